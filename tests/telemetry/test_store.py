"""What of the bus is kept, under which name, in which unit."""

import math

import pytest

from armui.arm.limits import JOINTS
from armui.protocol.codec import Codec, InvalidFrame, InvalidFrameKind, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.telemetry.quantities import QUANTITIES, RECORDS, TOOL_POSE, Source
from armui.telemetry.store import Telemetry
from tests.telemetry.motions import EIGHT_BYTES, Clock, angle, feed, telemetry_at

FEEDBACK_MB = 136
"""Of an arm; without 0x481–0x486, which are sent only while they are switched on."""
MOST_MB = 398
"""Whatever is heard: every command of this program and of others at full rate beside it."""


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def telemetry(clock):
    return telemetry_at(clock)


def heard(telemetry, at_s, name, **signals):
    telemetry.on_heard([(Message(name, signals), at_s, EIGHT_BYTES, 0)])


def sent(telemetry, at_s, name, **signals):
    telemetry.on_sent([(Message(name, signals), at_s, EIGHT_BYTES, 0)])


def latest(telemetry, key):
    found = telemetry.latest(key)
    return None if found is None else found[1]


def test_half_an_hour_of_everything_has_a_bound():
    telemetry = Telemetry()
    assert telemetry.bytes_kept == 0
    assert telemetry.most_bytes <= MOST_MB * 1e6
    feedback = sum(
        telemetry.series[record.name].most_bytes
        for record in RECORDS
        if record.source is Source.ARM
        and record is not TOOL_POSE
        and not record.message.startswith("EndMotion")
    )
    assert feedback <= FEEDBACK_MB * 1e6


def test_every_quantity_has_a_name_of_its_own_and_a_place():
    telemetry = Telemetry()
    assert len(QUANTITIES) == sum(len(record.fields) for record in RECORDS)
    for key in QUANTITIES:
        quantity, series = telemetry.find(key)
        assert quantity.field in series.shape.fields
        assert telemetry.latest(key) is None


def test_every_field_is_told_by_some_generation():
    """No field of a record is misspelt: one of the generations has each of its signals."""
    for record in RECORDS:
        if record.source is Source.BUS or record is TOOL_POSE:
            continue
        told = set()
        for generation in Generation:
            try:
                told |= set(Codec(generation).signals(record.message))
            except ValueError:
                continue
        for field in record.fields:
            assert set(field.signals) <= told, (record.message, field.name)


def test_an_arm_that_moves(clock, telemetry):
    feed(telemetry, clock, 3.0)
    for joint in JOINTS:
        at_s, value = telemetry.latest(f"arm.joint_angle.{joint}")
        assert at_s == pytest.approx(1002.995)
        assert value == pytest.approx(angle(joint, 2.995), abs=1e-5)
        assert telemetry.series[f"DriverFast{joint}"].count == 600
        assert telemetry.series[f"DriverSlow{joint}"].count == 120
    assert latest(telemetry, "arm.motor_position.3") == pytest.approx(angle(3, 2.995), abs=1e-4)
    assert latest(telemetry, "arm.not_reached") == 1
    # 13 frames 200 times and 6 frames 40 times a second
    assert latest(telemetry, "bus.frames_per_s") == pytest.approx(2840, rel=0.02)
    # 2,840 × (47 + 64) bits of a million a second
    assert latest(telemetry, "bus.bus_load") == pytest.approx(31.5, rel=0.02)


def test_units_are_those_of_the_operator(clock):
    for generation, speed in ((Generation.TWO, math.degrees(2.0)), (Generation.ONE, 12.0)):
        telemetry = telemetry_at(clock, generation)
        heard(telemetry, 1.0, "DriverFast1", Speed=2.0, Current=1.5, Position=1.0)
        assert latest(telemetry, "arm.motor_speed.1") == pytest.approx(speed)
        assert latest(telemetry, "arm.motor_current.1") == 1.5
    # generation 1 counts pulses, which mean nothing to anybody
    assert math.isnan(latest(telemetry, "arm.motor_position.1"))


def test_what_the_generations_say_differently_waits_for_the_generation(clock):
    telemetry = Telemetry(clock)
    telemetry.on_codec(Codec(Generation.TWO))
    status = {"ControlMode": 1, "Status": 0, "MoveMode": 1, "TeachingState": 0, "MotionState": 0}
    status |= {f"J{n}{what}": 1 for n in JOINTS for what in ("LimitExceeded", "CommunicationFault")}
    heard(telemetry, 1.0, "DriverFast1", Speed=2.0, Current=1.5, Position=1.0)
    heard(telemetry, 1.0, "ArmStatus", TrajectoryPoint=7, **status)
    heard(telemetry, 1.0, "JointFeedback12", J1=1.0, J2=2.0)
    assert telemetry.latest("arm.motor_current.1") is None
    assert math.isnan(latest(telemetry, "arm.trajectory_point"))
    assert math.isnan(latest(telemetry, "arm.beyond_limit"))
    assert latest(telemetry, "arm.no_communication") == 63
    assert latest(telemetry, "arm.joint_angle.2") == 2.0
    # known as generation 1, and still decoded as generation 2 by the bus thread
    telemetry.know_generation(Generation.ONE)
    heard(telemetry, 1.1, "DriverFast1", Speed=2.0, Current=1.5, Position=1.0)
    assert telemetry.latest("arm.motor_current.1") is None
    telemetry.on_codec(Codec(Generation.ONE))
    heard(telemetry, 1.2, "DriverFast1", Speed=2.0, Current=1.5, Position=1.0)
    assert latest(telemetry, "arm.motor_current.1") == 1.5
    telemetry.know_generation(None)
    heard(telemetry, 1.3, "DriverFast1", Speed=2.0, Current=9.0, Position=1.0)
    assert latest(telemetry, "arm.motor_current.1") == 1.5


def test_faults_are_bits_that_mean_the_same_in_both_generations(clock):
    flags = dict.fromkeys(
        ("Undervoltage", "MotorOvertemperature", "DriverOvertemperature", "DriverFault"), 0
    )
    common = {"Voltage": 24.0, "DriverTemperature": 30, "MotorTemperature": 31, "BusCurrent": 0.1}
    first = telemetry_at(clock, Generation.ONE)
    heard(
        first, 1.0, "DriverSlow2", **common, **flags, Overcurrent=1, SensorFault=1, Homed=1,
        Enabled=0,
    )  # fmt: skip
    second = telemetry_at(clock, Generation.TWO)
    heard(
        second, 1.0, "DriverSlow2", **common, **flags, Overcurrent=1, CollisionProtection=1,
        StallProtection=0, Enabled=1,
    )  # fmt: skip
    assert latest(first, "arm.driver_faults.2") == 4 + 16
    assert latest(second, "arm.driver_faults.2") == 4 + 64
    assert latest(first, "arm.enabled.2") == 0
    assert latest(second, "arm.enabled.2") == 1


def test_a_code_outside_its_table_is_kept_and_an_unknown_frame_counted(telemetry):
    status = {"ControlMode": 99, "Status": 0, "MoveMode": 1, "TeachingState": 0, "MotionState": 0}
    status |= {f"J{n}{what}": 0 for n in JOINTS for what in ("LimitExceeded", "CommunicationFault")}
    message = Message("ArmStatus", {**status, "TrajectoryPoint": 0.0})
    odd = InvalidFrame(InvalidFrameKind.VALUE_OUTSIDE_TABLE, 0x2A1, "odd", message)
    unknown = InvalidFrame(InvalidFrameKind.UNKNOWN_ID, 0x7FF, "unknown")
    telemetry.on_look(1.0)
    telemetry.on_heard([(odd, 1.0, EIGHT_BYTES, 0), (unknown, 1.0, EIGHT_BYTES, 0)])
    telemetry.on_look(1.2)
    assert latest(telemetry, "arm.control_mode") == 99
    assert latest(telemetry, "bus.frames_per_s") == pytest.approx(10.0)


def test_frames_that_waited_while_the_computer_was_busy_are_no_higher_load(telemetry):
    unknown = InvalidFrame(InvalidFrameKind.UNKNOWN_ID, 0x7FF, "unknown")

    def hear(begin_s, end_s, look_s):
        """1,000 frames a second, read at once."""
        stamps = range(round(1000 * begin_s), round(1000 * end_s))
        telemetry.on_heard([(unknown, stamp / 1000, EIGHT_BYTES, 0) for stamp in stamps])
        telemetry.on_look(look_s)

    told = []
    for begin_s, end_s, look_s in (
        *((0.9, 1.0, 1.0), (1.0, 1.1, 1.1)),
        *((1.1, 1.15, 1.6), (1.15, 1.3, 1.605), (1.3, 1.58, 1.61), (1.58, 1.61, 1.615)),
        *((1.61, 1.68, 1.68), (1.68, 1.72, 1.72)),
    ):
        hear(begin_s, end_s, look_s)
        told.append(latest(telemetry, "bus.frames_per_s"))
    assert told[1:] == pytest.approx([1000.0] * 7, rel=0.02)


def test_whose_command_it_is(telemetry):
    sent(telemetry, 1.0, "JointTarget12", J1=10.0, J2=20.0)
    assert latest(telemetry, "own.joint_angle.1") == 10.0
    assert telemetry.latest("other.joint_angle.1") is None
    heard(telemetry, 2.0, "JointTarget12", J1=-5.0, J2=0.0)
    assert latest(telemetry, "other.joint_angle.1") == -5.0
    # the newest command alone stands
    assert math.isnan(latest(telemetry, "own.joint_angle.1"))
    sent(telemetry, 3.0, "CartesianTarget1", X=300.0, Y=1.0)
    assert math.isnan(latest(telemetry, "other.joint_angle.1"))
    assert latest(telemetry, "own.pose_x") == 300.0


@pytest.mark.parametrize(
    ("name", "signals"),
    [
        ("MotionCommand", {"EmergencyStop": 1, "TrajectoryCommand": 0}),
        ("MotionCommand", {"EmergencyStop": 0, "TrajectoryCommand": 6}),
        ("MotorEnable", {"Joint": 7, "Action": 1}),
    ],
)
@pytest.mark.parametrize("says", [heard, sent])
def test_a_stop_an_abort_and_a_disable_end_every_target(telemetry, says, name, signals):
    sent(telemetry, 1.0, "JointTarget34", J3=10.0, J4=20.0)
    sent(telemetry, 1.0, "ModeControl", SpeedPercent=30, MoveMode=1)
    says(telemetry, 2.0, name, **signals)
    assert math.isnan(latest(telemetry, "own.joint_angle.4"))
    assert latest(telemetry, "own.speed_percent") == 30
    assert telemetry.series["own.JointTarget34"].value_at("joint_angle.3", 1.5) == (1.0, 10.0)


@pytest.mark.parametrize(
    ("name", "signals"),
    [
        ("MotionCommand", {"EmergencyStop": 0, "TrajectoryCommand": 1}),
        ("MotorEnable", {"Joint": 7, "Action": 2}),
    ],
)
def test_a_pause_and_an_enable_do_not(telemetry, name, signals):
    sent(telemetry, 1.0, "JointTarget34", J3=10.0, J4=20.0)
    sent(telemetry, 2.0, name, **signals)
    assert latest(telemetry, "own.joint_angle.4") == 20.0


def test_frames_of_the_wire_come_out_as_figures(telemetry):
    codec = Codec(Generation.TWO)
    # J1 90.000° = 90,000 = 0x00015F90, J2 −0.001° = 0xFFFFFFFF
    frame = Frame(0x2A5, bytes.fromhex("00015F90FFFFFFFF"))
    telemetry.on_heard([(codec.decode(frame), 1.0, EIGHT_BYTES, 0)])
    assert latest(telemetry, "arm.joint_angle.1") == 90.0
    assert latest(telemetry, "arm.joint_angle.2") == pytest.approx(-0.001)
