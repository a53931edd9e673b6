"""What was noted becomes events: a table of what is heard and what is said of it."""

from types import MappingProxyType

import pytest

from armui.arm.limits import JointLimits
from armui.arm.other_hosts import FrameSeries, OtherTraffic
from armui.arm.state import ArmState, Reading
from armui.control.event_log.observer import ARM_STATUS, EventObserver
from armui.control.event_log.status_listener import (
    DRIVER_FLAGS,
    GAP,
    GRIPPER,
    RATE,
    STATUS,
    StatusChange,
)
from armui.control.event_log.status_listener import InvalidFrames as Odd
from armui.telemetry.events import Level

NOBODY = OtherTraffic()


def status(at_s, **codes):
    plain = dict.fromkeys(
        ("ControlMode", "Status", "MoveMode", "TeachingState", "MotionState"), 0
    ) | {f"J{n}{what}": 0 for n in range(1, 7) for what in ("CommunicationFault", "LimitExceeded")}
    return StatusChange(at_s, STATUS, {**plain, **codes})


def driver(at_s, joint=1, **flags):
    return StatusChange(at_s, f"DriverSlow{joint}", {**dict.fromkeys(DRIVER_FLAGS, 0), **flags})


def gripper(at_s, **flags):
    return StatusChange(at_s, GRIPPER, flags)


def said(*noted, state=None, traffic=NOBODY, now_s=100.0, observer=None):
    """The changes as short tuples."""
    observer = observer or EventObserver()
    changes = observer.observe(noted, state or ArmState(), traffic, now_s)
    return [
        (each.phase.name, each.observed and each.observed.id, each.at_s, dict(each.params))
        for each in changes
    ]


BEGAN, ENDED, HAPPENED, GREW = "BEGAN", "ENDED", "HAPPENED", "GREW"
OVERCURRENT = {"joint": 3, "item": "DRIVER_CURRENT", "word": "OVERCURRENT"}

TABLE = {
    "the first status": (
        [status(1.0, ControlMode=1)],
        [(HAPPENED, "control_mode", 1.0, {"mode": 1, "before": None})],
    ),
    "a mode that changes": (
        [status(1.0), status(2.0, ControlMode=1, MoveMode=2)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (HAPPENED, "control_mode", 2.0, {"mode": 1, "before": 0}),
            (HAPPENED, "move_mode", 2.0, {"mode": 2, "before": 0}),
        ],
    ),
    "drag teaching": (
        [status(1.0), status(2.0, TeachingState=1, Status=0x0B), status(3.0)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (HAPPENED, "teaching", 2.0, {"state": 1, "before": 0}),
            (BEGAN, "arm_status", 2.0, {"status": 0x0B}),
            (HAPPENED, "teaching", 3.0, {"state": 0, "before": 1}),
            (ENDED, None, 3.0, {}),
        ],
    ),
    "one fault after another": (
        [status(1.0, Status=7), status(2.0, Status=5), status(3.0)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (BEGAN, "arm_status", 1.0, {"status": 7}),
            (ENDED, None, 2.0, {}),
            (BEGAN, "arm_status", 2.0, {"status": 5}),
            (ENDED, None, 3.0, {}),
        ],
    ),
    "a motion": (
        [status(1.0), status(2.0, MotionState=1), status(2.5)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (BEGAN, "motion", 2.0, {}),
            (ENDED, None, 2.5, {}),
        ],
    ),
    "a joint beyond its limit": (
        [status(1.0), status(2.0, J4LimitExceeded=1), status(3.0)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (BEGAN, "beyond_limit", 2.0, {"joint": 4}),
            (ENDED, None, 3.0, {}),
        ],
    ),
    "a joint that is not heard by its controller": (
        [status(1.0, J2CommunicationFault=1), status(3.0)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (
                *(BEGAN, "joint_fault", 1.0),
                {"joint": 2, "item": "COMMUNICATION", "word": "ABNORMAL"},
            ),
            (ENDED, None, 3.0, {}),
        ],
    ),
    "a driver's fault": (
        [driver(1.0, 3), driver(2.0, 3, Overcurrent=1), driver(2.005, 3)],
        [
            (HAPPENED, "motors_off", 1.0, {"joints": (3,)}),
            (BEGAN, "joint_fault", 2.0, OVERCURRENT),
            (ENDED, None, 2.005, {}),
        ],
    ),
    "six motors at once": (
        [driver(1.0 + 0.004 * n, n, Enabled=1) for n in range(1, 7)],
        [
            (HAPPENED, "motors_on", 1.004, {"joints": (1,)}),
            *((GREW, None, 1.0 + 0.004 * n, {"joints": tuple(range(1, n + 1))}) for n in (2, 3)),
            *((GREW, None, 1.0 + 0.004 * n, {"joints": tuple(range(1, n + 1))}) for n in (4, 5)),
            (GREW, None, 1.024, {"joints": (1, 2, 3, 4, 5, 6)}),
        ],
    ),
    "one motor long after another": (
        [driver(1.0, 1, Enabled=1), driver(2.0, 2, Enabled=1)],
        [
            (HAPPENED, "motors_on", 1.0, {"joints": (1,)}),
            (HAPPENED, "motors_on", 2.0, {"joints": (2,)}),
        ],
    ),
    "the gripper": (
        [gripper(1.0, Overcurrent=0), gripper(2.0, Overcurrent=1), gripper(3.0, Overcurrent=0)],
        [(BEGAN, "gripper_fault", 2.0, {"fault": "Overcurrent"}), (ENDED, None, 3.0, {})],
    ),
    "silence": (
        [
            driver(1.0, 3, Overcurrent=1, Enabled=1),
            StatusChange(1.0, GAP, {}),
            driver(9.0, 3, Enabled=1),
        ],
        [
            (BEGAN, "joint_fault", 1.0, OVERCURRENT),
            (HAPPENED, "motors_on", 1.0, {"joints": (3,)}),
            (ENDED, None, 1.0, {}),
            (HAPPENED, "motors_on", 9.0, {"joints": (3,)}),
        ],
    ),
    "a stop over a silence": (
        [status(1.0, Status=1), StatusChange(1.0, GAP, {}), status(9.0, Status=1)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (BEGAN, "arm_status", 1.0, {"status": 1}),
            (HAPPENED, "control_mode", 9.0, {"mode": 0, "before": None}),
        ],
    ),
    "a stop that ends in a silence": (
        [status(1.0, Status=1), StatusChange(1.5, GAP, {}), status(9.0, Status=0)],
        [
            (HAPPENED, "control_mode", 1.0, {"mode": 0, "before": None}),
            (BEGAN, "arm_status", 1.0, {"status": 1}),
            (HAPPENED, "control_mode", 9.0, {"mode": 0, "before": None}),
            (ENDED, None, 1.5, {}),
        ],
    ),
    "a rate that drops and comes back": (
        [
            StatusChange(2.0 * n, RATE, {"hz": hz})
            for n, hz in enumerate((200.0, 200.0, 180.0, 178.0, 198.0, 200.0))
        ],
        [(BEGAN, "fewer_frames", 6.0, {"share": 10}), (ENDED, None, 10.0, {})],
    ),
    "a pause of the computer, and the frames that come late for it": (
        [
            StatusChange(2.0 * n, RATE, {"hz": hz})
            for n, hz in enumerate((200.0, 201.0, 150.0, 250.0, 200.0, 199.0))
        ],
        [(BEGAN, "fewer_frames", 4.0, {"share": 12}), (ENDED, None, 6.0, {})],
    ),
    "a rate that is as it always was": (
        [StatusChange(t, RATE, {"hz": 150.0 + t % 3}) for t in range(2, 20, 2)],
        [],
    ),
}


@pytest.mark.parametrize("name", TABLE)
def test_what_is_heard_and_what_is_said(name):
    noted, expected = TABLE[name]
    assert said(*noted) == expected


@pytest.mark.parametrize("name", TABLE)
def test_it_is_the_same_frame_by_frame_and_in_one_batch(name):
    noted, expected = TABLE[name]
    observer = EventObserver()
    single = [each for one in noted for each in said(one, observer=observer)]
    assert single == expected


def test_what_was_not_heard_to_end_says_so():
    observer = EventObserver()
    said(driver(1.0, 3, Overcurrent=1), observer=observer)
    (end,) = observer.forget(5.0)
    assert (end.phase.name, end.at_s, end.unheard) == (ENDED, 5.0, True)
    assert observer.forget(6.0) == []


@pytest.mark.parametrize(
    ("code", "level"),
    [
        (1, Level.FAULT),
        (4, Level.WARNING),
        (7, Level.FAULT),
        (0x0C, Level.INFO),
        (0x77, Level.FAULT),
    ],
)
def test_how_grave_a_status_is(code, level):
    changes = EventObserver().observe([status(1.0, Status=code)], ArmState(), NOBODY, 1.0)
    assert [each.level for each in changes if each.observed == ARM_STATUS] == [level]


def limits(low, high, at_s, speed=180.0):
    reading = Reading(JointLimits(low, high, speed), at_s)
    return ArmState(limits=(reading, None, None, None, None, None))


def test_limits_that_cannot_be_true():
    observer = EventObserver()
    corrupt = said(state=limits(6553.5, 6553.5, 1.0), observer=observer)
    assert corrupt == [(BEGAN, "limits_unusable", 1.0, {"joint": 1})]
    assert said(state=limits(6553.5, 6553.5, 2.0), observer=observer) == []
    assert said(state=limits(-150.0, 150.0, 3.0), observer=observer) == [(ENDED, None, 3.0, {})]


def test_limits_read_before_a_silence_are_not_told_again():
    observer = EventObserver()
    corrupt = limits(6553.5, 6553.5, 1.0)
    said(state=corrupt, observer=observer)
    assert said(StatusChange(5.0, GAP, {}), state=corrupt, observer=observer) == [
        (ENDED, None, 5.0, {})
    ]


# Frames that come again and again ------------------------------------------------------------


def odd(times, first_s, last_s, sort="UNKNOWN_ID"):
    return Odd(sort, 0x4F0, times, first_s, last_s)


def test_frames_that_are_not_understood_are_one_event_with_a_count():
    observer = EventObserver()
    figures = {"kind": "UNKNOWN_ID", "id": "0x4F0"}
    assert said(odd(3, 1.0, 1.02), now_s=1.0, observer=observer) == [
        (BEGAN, "invalid_frames", 1.0, figures)
    ]
    assert said(odd(1, 1.1, 1.1), now_s=1.1, observer=observer) == []
    assert said(odd(2, 1.2, 1.3), now_s=1.3, observer=observer) == [(GREW, None, 1.3, figures)]
    assert said(now_s=3.2, observer=observer) == []
    (end,) = observer.observe([], ArmState(), NOBODY, 3.4)
    assert (end.phase.name, end.at_s, end.count) == (ENDED, 1.3, 6)


def test_a_pause_within_one_look_is_a_pause_all_the_same():
    observer = EventObserver()
    said(odd(1, 1.0, 1.0), now_s=1.0, observer=observer)
    phases = [each[0] for each in said(odd(1, 9.0, 9.0), now_s=9.0, observer=observer)]
    assert phases == [ENDED, BEGAN]


def test_a_thousand_odd_frames_a_second_are_few_changes():
    observer = EventObserver()
    changes = []
    for n in range(3000):
        at_s = n / 30
        changes += said(odd(33, at_s, at_s), now_s=at_s, observer=observer)
    assert len(changes) < 25


def traffic(count, since_s, last_s, arbitration_id=0x155):
    series = FrameSeries(arbitration_id, count, since_s, last_s, bytes(8))
    return OtherTraffic(MappingProxyType({arbitration_id: series}))


def test_another_host_is_named_by_its_frames_from_the_first_to_the_last():
    observer = EventObserver()
    figures = {"id": "0x155"}
    begun = said(traffic=traffic(1, 1.0, 1.0), now_s=1.0, observer=observer)
    assert begun == [(BEGAN, "other_frames", 1.0, figures)]
    grown = said(traffic=traffic(40, 1.0, 1.5), now_s=1.5, observer=observer)
    assert grown == [(GREW, None, 1.5, figures)]
    over = traffic(41, 1.0, 1.6)
    said(traffic=over, now_s=1.6, observer=observer)
    assert said(traffic=over, now_s=3.7, observer=observer) == [(ENDED, None, 1.6, {})]
    assert said(traffic=over, now_s=3.8, observer=observer) == []
    # the record of a series that is over stays with the others
    assert said(traffic=traffic(41, 1.0, 1.6), now_s=3.9, observer=observer) == []
    again = said(traffic=traffic(1, 9.0, 9.0), now_s=9.0, observer=observer)
    assert again == [(BEGAN, "other_frames", 9.0, figures)]
