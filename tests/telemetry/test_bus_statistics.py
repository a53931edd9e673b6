"""What is counted of the frames on the bus: rate, jitter, change, senders, oddities, the trace."""

import pytest

from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec, InvalidFrame, InvalidFrameKind
from armui.protocol.frame import Frame, FrameFlag
from armui.protocol.generation import Generation
from armui.telemetry import bus_statistics
from armui.telemetry.bus_senders import Sender
from armui.telemetry.bus_statistics import MOST_ROWS, BusStatistics, cycle_of
from armui.telemetry.bus_trace import BusTrace

CODEC = Codec(Generation.TWO)
TARGET = "155#000003E8000007D0"
QUESTION = "4AF#0100000000000000"


class Rig:
    """Statistics with a clock in the test's hand."""

    def __init__(self, codec=CODEC):
        self.codec = codec
        self.time_s = 100.0
        self.statistics = BusStatistics(lambda: self.time_s)
        self.statistics.on_codec(codec)

    def taken(self, line, flags=0):
        identifier, _, data = line.partition("#")
        frame = Frame(int(identifier, 16), bytes.fromhex(data))
        if flags:
            heard = InvalidFrame(InvalidFrameKind.UNKNOWN_ID, frame.arbitration_id, "no data frame")
        else:
            heard = self.codec.decode(frame)
        return heard, self.time_s, frame, flags

    def hear(self, *lines, flags=0):
        self.statistics.on_heard([self.taken(line, flags) for line in lines])

    def send(self, *lines):
        taken = [self.taken(line) for line in lines]
        sent = [(*each[:3], FrameFlag.TRANSMITTED) for each in taken]
        self.statistics.on_sent(sent)

    def hear_every(self, gaps_s, line="2A5#0000000000000000"):
        for gap_s in gaps_s:
            self.time_s += gap_s
            self.hear(line)

    def look(self):
        assert self.statistics.count_waiting()
        return self.statistics.snapshot()

    def rows(self):
        return [
            (f"{row.arbitration_id:03X}", row.sender.value, row.count) for row in self.look().rows
        ]

    def row(self, arbitration_id):
        (row,) = (row for row in self.look().rows if row.arbitration_id == arbitration_id)
        return row


@pytest.fixture
def rig():
    return Rig()


def test_frames_are_counted_by_identifier_and_sender(rig):
    rig.hear("2A1#0000000000000000", TARGET, TARGET)
    rig.send(TARGET)
    rig.hear("2A1#0000000000000000", "3C1#01")

    assert rig.rows() == [
        ("155", "other", 2),
        ("155", "own", 1),
        ("2A1", "arm", 2),
        ("3C1", "unknown", 1),
    ]
    assert rig.look().frames == 6


def test_rate_and_jitter_of_a_steady_frame(rig):
    rig.hear_every([0.005] * 400)
    row = rig.row(0x2A5)

    assert row.cycle().rate_hz == pytest.approx(200.0)
    assert row.cycle().deviation_s == pytest.approx(0.0, abs=1e-9)
    assert row.max_gap_s == pytest.approx(0.005)


def test_jitter_is_the_mean_deviation_and_the_longest_gap_stays(rig):
    rig.hear_every([0.01, 0.05])
    rig.hear_every([0.009, 0.011] * 300)
    row = rig.row(0x2A5)

    assert row.cycle().rate_hz == pytest.approx(100.0, rel=0.01)
    assert row.cycle().deviation_s == pytest.approx(0.001, rel=0.02)
    assert row.max_gap_s == pytest.approx(0.05)


def test_seldom_frames_have_a_rate_of_their_last_cycles(rig):
    rig.hear_every([2.0] * 20)

    assert rig.row(0x2A5).cycle().rate_hz == pytest.approx(0.5)


def test_a_new_rate_shows_within_three_seconds(rig):
    rig.hear_every([0.1] * 200)
    rig.hear_every([0.02] * 160)

    assert rig.row(0x2A5).cycle().rate_hz == pytest.approx(50.0)


@pytest.mark.parametrize("times_s", [(), (1.0,), (1.0, 1.0)])
def test_no_rate_without_a_cycle(times_s):
    assert cycle_of(times_s) is None


def test_a_frame_that_stops_is_silent_and_a_single_one_is_not(rig):
    rig.hear_every([0.005] * 50)
    rig.hear("472#0101000000000000")
    rig.time_s += 0.4
    assert not rig.row(0x2A5).is_silent(rig.time_s)
    rig.time_s += 0.2

    assert rig.row(0x2A5).is_silent(rig.time_s)
    assert not rig.row(0x472).is_silent(rig.time_s)


def test_a_slow_frame_is_not_silent_between_two(rig):
    rig.hear_every([1.0] * 5)
    rig.time_s += 1.5

    assert not rig.row(0x2A5).is_silent(rig.time_s)


def test_bytes_that_change_are_known_with_the_time(rig):
    rig.hear("2A5#0011223344556677")
    assert rig.row(0x2A5).changed_s == (-float("inf"),) * 8
    rig.time_s = 101.0
    rig.hear("2A5#0011223344556699")
    rig.hear("2A5#00FF223344556699", "2A5#0011223344556699")  # there and back between two looks
    changed_s = rig.row(0x2A5).changed_s

    assert [place for place, at_s in enumerate(changed_s) if at_s == 101.0] == [1, 7]
    assert rig.row(0x2A5).changed_since(100.5)
    assert not rig.row(0x2A5).changed_since(101.0)


def test_another_length_changes_every_byte(rig):
    rig.hear("3C1#00")
    rig.hear("3C1#0000")

    assert all(at_s == rig.time_s for at_s in rig.row(0x3C1).changed_s)


def test_malformed_frames_are_counted_beside_the_good_ones(rig):
    rig.hear("2A8#0000000000000000", "2A8#0011", "2A8#0000000000000000")
    row = rig.row(0x2A8)

    assert (row.count, row.invalid_count, row.invalid_length) == (3, 1, 2)
    assert row.invalid.kind is InvalidFrameKind.WRONG_LENGTH
    assert len(row.data) == 8


def test_extended_remote_and_error_frames_are_rows_of_their_own(rig):
    rig.hear("2A1#00", flags=FrameFlag.EXTENDED)
    rig.hear("2A1#", flags=FrameFlag.REMOTE)
    rig.hear("040#0000000000000000", flags=FrameFlag.ERROR)
    rig.hear("2A1#0000000000000000")
    snapshot = rig.look()

    assert [(row.flags, row.sender) for row in snapshot.rows] == [
        (0, Sender.ARM),
        (FrameFlag.EXTENDED, Sender.UNKNOWN),
        (FrameFlag.REMOTE, Sender.UNKNOWN),
        (FrameFlag.ERROR, Sender.ADAPTER),
    ]
    assert snapshot.error_frames == 1


def test_what_is_shown_stays_while_counting_goes_on(rig):
    rig.hear(TARGET)
    before = rig.look()
    rig.hear(TARGET)

    assert rig.look().rows[0].count == 2
    assert before.rows[0].count == 1


def test_what_did_not_come_again_is_the_same_row(rig):
    rig.hear(TARGET, "2A5#0000000000000000")
    first = rig.look()
    rig.hear(TARGET)
    second = rig.look()

    assert second.rows[1] is first.rows[1]
    assert second.rows[0] is not first.rows[0]


def test_clearing_begins_anew(rig):
    rig.hear(TARGET, "2A5#0000000000000000")
    rig.look()
    rig.time_s += 5.0
    rig.statistics.clear()
    rig.hear(TARGET)
    snapshot = rig.look()

    assert snapshot.since_s == rig.time_s
    assert [row.count for row in snapshot.rows] == [1]
    assert len(rig.statistics.trace.snapshot()) == 1


def test_no_cycle_goes_on_over_a_lost_device(rig):
    rig.hear_every([0.005] * 10)
    rig.statistics.on_open(None)
    rig.hear_every([9.0, 0.005, 0.005])

    assert rig.row(0x2A5).max_gap_s == pytest.approx(0.005)
    assert rig.row(0x2A5).count == 13


def test_who_never_looks_makes_nothing_grow(rig, monkeypatch):
    monkeypatch.setattr(bus_statistics, "MOST_WAITING", 100)
    batch = [rig.taken(TARGET)] * 10
    for _ in range(50):
        rig.statistics.on_heard(batch)
    snapshot = rig.look()

    assert snapshot.frames == 110
    assert snapshot.left_out == 390
    rig.statistics.on_heard(batch)
    assert rig.look().frames == 120


def test_counting_comes_in_slices(rig):
    batch = [rig.taken(TARGET)] * 10
    for _ in range(5):
        rig.statistics.on_heard(batch)

    assert not rig.statistics.count_waiting(20)
    assert rig.statistics.snapshot().frames == 20
    assert rig.statistics.count_waiting(1000)
    assert rig.statistics.snapshot().frames == 50


def test_a_bus_full_of_nonsense_has_an_end(rig):
    for identifier in range(MOST_ROWS + 30):
        rig.hear(f"{identifier:08X}#00", flags=FrameFlag.EXTENDED)
    snapshot = rig.look()

    assert len(snapshot.rows) == MOST_ROWS
    assert snapshot.beyond == 30


def test_another_codec_names_senders_anew(rig):
    rig.hear("2B1#0000000000000000")
    rig.look()
    rig.codec = Codec(Generation.TWO, Addressing(feedback_offset=0x10))
    rig.statistics.on_codec(rig.codec)
    rig.hear("2B1#0000000000000000", "2A1#0000000000000000")

    assert rig.rows() == [("2A1", "other_arm", 1), ("2B1", "arm", 1), ("2B1", "other_arm", 1)]


def test_the_version_question_is_a_hosts_and_its_answer_the_arms(rig):
    rig.send(QUESTION)
    rig.hear(QUESTION, "4AF#532D56312E382D33", QUESTION)

    assert rig.rows() == [("4AF", "arm", 1), ("4AF", "other", 2), ("4AF", "own", 1)]


def test_the_generation_is_known_or_not(rig):
    assert not rig.statistics.generation_known
    rig.statistics.know_generation(Generation.TWO)
    assert rig.statistics.generation_known


# The trace ----------------------------------------------------------------------------------------


def test_frames_in_order_of_time_with_what_changed(rig):
    rig.hear("2A5#0011223344556677")
    rig.time_s += 0.002
    rig.hear("2A5#0011223344556699")
    rig.time_s -= 0.001
    rig.send(TARGET)  # told a little later than it went out
    rig.look()
    trace = rig.statistics.trace.snapshot()
    frames = [trace.frame(place) for place in range(len(trace))]

    assert [f"{each.arbitration_id:03X}" for each in frames] == ["2A5", "155", "2A5"]
    assert frames[1].sender is Sender.OWN
    assert frames[2].data.hex() == "0011223344556699"
    assert frames[2].changed == (False,) * 7 + (True,)
    assert frames[0].changed == (False,) * 8


def test_the_trace_takes_rows_and_changed_frames_alone(rig):
    for value in (1, 1, 2):
        rig.hear(f"3C1#{value:02X}", "2A5#0000000000000000")
    rows = {row.arbitration_id: row.number for row in rig.look().rows}
    trace = rig.statistics.trace.snapshot()

    assert len(trace.selected([rows[0x3C1]])) == 3
    assert len(trace.selected([rows[0x3C1]], only_changed=True)) == 1
    assert trace.selected([rows[0x3C1]], most=1).frame(0).data == b"\x02"
    assert len(trace.selected([])) == 0


def test_the_oldest_frames_give_way():
    trace = BusTrace(most=10)
    trace.name(0, 0x3C1, 0, Sender.UNKNOWN)
    for first in (0, 7, 14):
        taken = [
            (CODEC.decode(Frame(0x3C1, bytes([n]))), float(n), Frame(0x3C1, bytes([n])), 0)
            for n in range(first, first + 7)
        ]
        words = [n << 56 for n in range(first, first + 7)]
        trace.extend(taken, [0] * 7, words, [0] * 7)
    kept = trace.snapshot()

    assert list(kept.times_s) == [float(n) for n in range(11, 21)]
    assert kept.frame(0).data == bytes([11])


def test_more_at_once_than_the_trace_holds():
    trace = BusTrace(most=4)
    trace.name(0, 0x3C1, 0, Sender.UNKNOWN)
    frame = Frame(0x3C1, b"")
    taken = [(CODEC.decode(frame), float(n), frame, 0) for n in range(9)]
    trace.extend(taken, [0] * 9, [0] * 9, [0] * 9)

    assert list(trace.snapshot().times_s) == [5.0, 6.0, 7.0, 8.0]
