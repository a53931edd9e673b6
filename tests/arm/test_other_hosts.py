"""What other hosts on the bus send: which frames, since when, how often, and whether they lead."""

from __future__ import annotations

import pytest

from armui.arm.other_hosts import MOTION_IDS, FrameSeries, OtherHosts, OtherTraffic, is_arms_answer
from armui.protocol.addressing import OFFSETS

BEGIN_S = 0.25
OWN = (0x00,)
LEADER = (0x151, 0x155, 0x156, 0x157, 0x159)


@pytest.fixture
def hosts():
    return OtherHosts()


def stream(hosts, identifiers, count, period_s=0.005, begin_s=BEGIN_S):
    """Frames in lockstep, so many of each identifier."""
    for k in range(count):
        for each in identifiers:
            hosts.note(each, bytes([k]), begin_s + k * period_s)


def moving(hosts, offsets=OWN):
    return {each.arbitration_id for each in hosts.traffic().motion(offsets)}


# Which frames -------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", OFFSETS)
def test_the_frames_that_move_an_arm_under_an_offset(hosts, offset):
    for each in range(0x800):
        hosts.note(each, b"", BEGIN_S)
    others = {*range(0x181, 0x188), 0x470, 0x471, 0x475}
    assert moving(hosts, (offset,)) == {*range(0x150 + offset, 0x160 + offset), *others}


def test_under_any_offset(hosts):
    for each in range(0x800):
        hosts.note(each, b"", BEGIN_S)
    others = {*range(0x181, 0x188), 0x470, 0x471, 0x475}
    assert moving(hosts, OFFSETS) == {*range(0x150, 0x180), *others}


def test_they_come_in_the_order_of_their_identifiers(hosts):
    for each in (0x471, 0x155, 0x187, 0x151):
        hosts.note(each, b"", BEGIN_S)
    motion = hosts.traffic().motion(OWN)
    assert [each.arbitration_id for each in motion] == [0x151, 0x155, 0x187, 0x471]


def test_questions_lamps_and_settings_are_kept_and_move_nothing(hosts):
    named = {0x121, 0x191, 0x422, 0x472, 0x474, 0x477, 0x479, 0x47A, 0x47D, 0x487}
    for each in named:
        hosts.note(each, b"", BEGIN_S)
    assert set(hosts.traffic().series) == named
    assert moving(hosts, OFFSETS) == set()


@pytest.mark.parametrize(
    "feedback", [0x2A1, 0x2B5, 0x251, 0x261, 0x476, 0x4AF, 0x180, 0x188, 0x14F]
)
def test_feedback_is_no_command(hosts, feedback):
    hosts.note(feedback, b"", BEGIN_S)
    assert not hosts.traffic().series


def test_nothing_was_heard_yet(hosts):
    traffic = hosts.traffic()
    assert traffic == OtherTraffic()
    assert traffic.motion(OWN) == ()
    assert traffic.mode_word(OWN) is None
    assert not traffic.leads(OWN)


# Since when, how often ----------------------------------------------------------------------------


def test_a_series_is_counted_from_its_first_frame_and_keeps_the_last_payload(hosts):
    stream(hosts, [0x155], 5, 0.25)
    assert hosts.traffic().series[0x155] == FrameSeries(
        0x155, 5, BEGIN_S, BEGIN_S + 1.0, bytes([4])
    )
    assert hosts.traffic().series[0x155].rate_hz == 4.0


def test_a_single_frame_has_no_rate(hosts):
    hosts.note(0x155, b"", BEGIN_S)
    assert hosts.traffic().series[0x155].rate_hz == 0.0


@pytest.mark.parametrize(("pause_s", "count"), [(2.0, 2), (2.0625, 1)])
def test_a_pause_of_more_than_two_seconds_begins_anew(hosts, pause_s, count):
    hosts.note(0x155, b"\x01", BEGIN_S)
    hosts.note(0x155, b"\x02", BEGIN_S + pause_s)
    series = hosts.traffic().series[0x155]
    assert series.count == count
    assert series.since_s == (BEGIN_S if count == 2 else BEGIN_S + pause_s)
    assert (series.last_s, series.data) == (BEGIN_S + pause_s, b"\x02")


def test_each_identifier_is_a_series_of_its_own(hosts):
    stream(hosts, [0x155, 0x165], 3)
    hosts.note(0x165, b"", BEGIN_S + 1.0)
    assert {each: series.count for each, series in hosts.traffic().series.items()} == {
        0x155: 3,
        0x165: 4,
    }


def test_a_snapshot_stays_as_it_was_and_is_the_same_one_while_nothing_is_new(hosts):
    hosts.note(0x155, b"", BEGIN_S)
    first = hosts.traffic()
    assert hosts.traffic() is first
    hosts.note(0x155, b"", BEGIN_S + 1.0)
    second = hosts.traffic()
    assert second is not first
    assert hosts.traffic() is second
    assert (first.series[0x155].count, second.series[0x155].count) == (1, 2)


def test_what_is_not_kept_makes_no_new_snapshot(hosts):
    first = hosts.traffic()
    hosts.note(0x2A1, b"", BEGIN_S)
    assert hosts.traffic() is first


# The newest of a kind -----------------------------------------------------------------------------

KINDS = {
    "mode word": (OtherTraffic.mode_word, (0x151,)),
    "MIT setpoint": (OtherTraffic.mit_frames, tuple(range(0x15A, 0x160))),
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("offset", OFFSETS)
def test_which_frame_is_the_newest_of_its_kind(hosts, kind, offset):
    newest, identifiers = KINDS[kind]
    for k, each in enumerate(range(0x800)):
        hosts.note(each, b"", BEGIN_S + k / 1024)
    own = newest(hosts.traffic(), (offset,))
    assert own.arbitration_id == identifiers[-1] + offset
    for each in identifiers:
        hosts.note(each + offset, b"", BEGIN_S + 2.0 + each / 1024)
        assert newest(hosts.traffic(), (offset,)).arbitration_id == each + offset
        assert newest(hosts.traffic(), OFFSETS).arbitration_id == each + offset


@pytest.mark.parametrize("kind", KINDS)
def test_other_frames_are_none_of_that_kind(hosts, kind):
    newest, identifiers = KINDS[kind]
    for each in set(range(0x800)) - set(identifiers):
        hosts.note(each, b"", BEGIN_S)
    assert newest(hosts.traffic(), OWN) is None


def test_setpoints_in_cpv_mode_have_no_offset(hosts):
    for each in range(0x181, 0x188):
        hosts.note(each, b"", BEGIN_S + each / 1024)
        assert hosts.traffic().cpv_frames().arbitration_id == each


def test_other_frames_are_none_in_cpv_mode(hosts):
    for each in set(range(0x800)) - set(range(0x181, 0x188)):
        hosts.note(each, b"", BEGIN_S)
    assert hosts.traffic().cpv_frames() is None


# A leader arm -------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_leader_sends_mode_targets_and_gripper_in_lockstep(hosts, offset):
    stream(hosts, [each + offset for each in LEADER], 10)
    assert hosts.traffic().leads((offset,))
    assert hosts.traffic().leads(OFFSETS)


def test_a_leader_for_another_arm_is_none_of_ours(hosts):
    stream(hosts, [each + 0x10 for each in LEADER], 10)
    assert not hosts.traffic().leads(OWN)


@pytest.mark.parametrize("missing", LEADER)
def test_what_lacks_one_of_them_is_a_program(hosts, missing):
    stream(hosts, [each for each in LEADER if each != missing], 10)
    assert not hosts.traffic().leads(OWN)


def test_what_moves_the_arm_otherwise_too_is_a_program(hosts):
    stream(hosts, (0x150, *LEADER), 10)
    assert not hosts.traffic().leads(OWN)


@pytest.mark.parametrize(("more", "leads"), [(3, True), (4, False), (10, False)])
@pytest.mark.parametrize("which", LEADER)
def test_lockstep_allows_for_a_frame_lost_and_a_cycle_under_way(hosts, which, more, leads):
    stream(hosts, LEADER, 10)
    stream(hosts, [which], more, begin_s=BEGIN_S + 0.05)
    assert hosts.traffic().leads(OWN) is leads


@pytest.mark.parametrize(("period_s", "leads"), [(0.05, True), (1 / 19.5, False)])
def test_a_leader_sends_at_twenty_hertz_at_least(hosts, period_s, leads):
    stream(hosts, LEADER, 9, period_s, begin_s=0.0)
    assert hosts.traffic().leads(OWN) is leads


def test_one_slow_frame_among_them_is_a_programs(hosts):
    stream(hosts, LEADER[:-1], 3)
    stream(hosts, LEADER[-1:], 2, 0.5)
    assert not hosts.traffic().leads(OWN)


def test_single_frames_lead_nothing(hosts):
    stream(hosts, LEADER, 1)
    assert not hosts.traffic().leads(OWN)


# Two sources of one bus ---------------------------------------------------------------------------


def one_series(count, since_s, last_s, data=b"", arbitration_id=0x155):
    return FrameSeries(arbitration_id, count, since_s, last_s, data)


EARLIER = one_series(4, 1.0, 3.0, b"earlier")


@pytest.mark.parametrize(
    ("later", "both"),
    [
        (one_series(3, 2.0, 4.0, b"later"), one_series(7, 1.0, 4.0, b"later")),
        (one_series(3, 0.5, 4.0, b"later"), one_series(7, 0.5, 4.0, b"later")),
        (one_series(3, 5.0, 6.0, b"later"), one_series(7, 1.0, 6.0, b"later")),
        (one_series(3, 5.25, 6.0, b"later"), one_series(3, 5.25, 6.0, b"later")),
    ],
    ids=["overlapping", "around it", "within two seconds", "after a longer pause"],
)
def test_what_two_heard_of_one_identifier_is_one_series(later, both):
    assert EARLIER.joined(later) == both
    assert later.joined(EARLIER) == both


def test_of_two_that_ended_at_once_the_one_asked_last_tells_the_payload():
    assert EARLIER.joined(one_series(1, 3.0, 3.0, b"same")).data == b"same"


def test_what_two_heard_is_the_traffic_of_both():
    modes = one_series(2, 1.0, 2.0, arbitration_id=0x151)
    first = OtherTraffic({0x155: EARLIER})
    second = OtherTraffic({0x155: one_series(3, 2.0, 4.0), 0x151: modes})
    both = {0x155: one_series(7, 1.0, 4.0), 0x151: modes}
    assert dict(first.joined(second).series) == both
    assert first.joined(OtherTraffic()) is first
    assert dict(first.series) == {0x155: EARLIER}


@pytest.mark.parametrize(
    ("arbitration_id", "data", "answers"),
    [
        (0x181, b"\x61", True),
        (0x187, b"\x61\x00\x01", True),
        (0x181, b"\x60", False),
        (0x181, b"\x62", False),
        (0x181, b"", False),
        (0x181, b"\x00\x61", False),
        (0x188, b"\x61", False),
        (0x155, b"\x61", False),
    ],
)
def test_the_arms_own_answer_in_cpv_mode_is_no_command(hosts, arbitration_id, data, answers):
    assert is_arms_answer(arbitration_id, data) is answers
    hosts.note(arbitration_id, data, BEGIN_S)
    known = arbitration_id in MOTION_IDS and not answers
    assert (arbitration_id in hosts.traffic().series) is known
