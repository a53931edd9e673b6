"""What the arm tells by itself: bytes, rates, order, and that the numbers fit together."""

from __future__ import annotations

import math
from collections import Counter

import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codec import Codec, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.feedback import Feedback
from armui.sim.firmware import Firmware
from tests.family import PIPER
from tests.protocol.rows import ROWS
from tests.sim.talk import (
    BOTH,
    DISABLE,
    FRAMES_A_SECOND,
    STOP,
    frame,
    heard,
    mode,
    ready,
    target,
    tell,
    text,
)

ONE, TWO = Generation.ONE, Generation.TWO
CONTROLLER = list(range(0x2A1, 0x2A9))
FAST = list(range(0x251, 0x257))
SLOW = list(range(0x261, 0x267))


def message(codec: Codec, each: Frame) -> Message:
    """Decodes a frame that must hold no invalid frame."""
    decoded = codec.decode(each)
    assert isinstance(decoded, Message), decoded
    return decoded


def signals(codec: Codec, frames: list[Frame], identifier: int) -> dict[str, float]:
    """The last message under one identifier."""
    last = [each for each in frames if each.arbitration_id == identifier][-1]
    return message(codec, last).signals


# fmt: off
AT_REST = {
    ONE: [
        "2A1#0000000000000000",
        "2A2#0000DB4000000000",  # X 56.128 mm = 56128 = 0xDB40, Y 0
        "2A3#0003411200000000",  # Z 213.266 mm = 213266 = 0x34112, RX 0
        "2A4#00014C0800000000",  # RY 85° = 85000 = 0x14C08, RZ 0
        "2A5#0000000000000000",
        "2A6#0000000000000000",
        "2A7#0000000000000000",
        "2A8#0000000000000000",
        "251#0000000000000000",
    ],
    TWO: [
        "2A1#0000000000000000",
        "2A2#0000DB4000000000",
        "2A3#0003411200000000",
        "2A4#00014C0800000000",
        "2A5#0000000000000000",
        "2A6#0000000000000000",
        "2A7#0000000000000000",
        "2A8#0000000000008000",  # gripper homed: bit 7
        "251#0000000000000000",
    ],
}
# fmt: on


@pytest.mark.parametrize("generation", BOTH)
def test_the_frames_of_an_arm_at_rest(generation: Generation) -> None:
    said = {text(each) for each in Firmware(generation).step(0.02)}
    assert set(AT_REST[generation]) <= said


@pytest.mark.parametrize(
    ("generation", "controller", "fast", "slow"), [(ONE, 50, 50, 10), (TWO, 200, 200, 40)]
)
@pytest.mark.parametrize("dt_s", [0.001, 0.005, 0.0123, 1.0])
def test_rates_do_not_depend_on_the_step(
    generation: Generation, controller: int, fast: int, slow: int, dt_s: float
) -> None:
    arm = Firmware(generation)
    count: Counter[int] = Counter()
    while arm.time_s < 1.0:
        left_s = 1.0 - arm.time_s
        count.update(each.arbitration_id for each in arm.step(min(dt_s, left_s)))
    assert count == {
        **dict.fromkeys(CONTROLLER, controller),
        **dict.fromkeys(FAST, fast),
        **dict.fromkeys(SLOW, slow),
        **{row.arbitration_id: 1000 // row.cycle_ms for row in ROWS[generation] if row.cycle_ms},
    }


def test_generation_2_fills_the_bus() -> None:
    assert len(Firmware(TWO).step(1.0)) == FRAMES_A_SECOND


@pytest.mark.parametrize("generation", BOTH)
def test_the_controller_speaks_in_one_burst_and_drivers_spread(generation: Generation) -> None:
    arm = Firmware(generation)
    bursts = [[each.arbitration_id for each in arm.step(0.005)] for _ in range(200)]
    for burst in bursts:
        spoken = [identifier for identifier in burst if identifier in CONTROLLER]
        assert spoken in ([], CONTROLLER)
        assert sum(identifier in SLOW for identifier in burst) <= 2
    if generation is TWO:
        assert all(burst[:8] == CONTROLLER for burst in bursts)
        assert all(burst[8:14] == FAST for burst in bursts)
    else:
        assert max(map(len, bursts)) <= 11


def test_every_frame_of_a_step_tells_its_own_moment() -> None:
    long, short = ready(), ready()
    for arm in (long, short):
        tell(arm, mode(100), *target(90.0, 0, 0, 0, 0, 0))
    in_one = heard(long.step(0.5), 0x2A5)
    in_many = [payload for _ in range(100) for payload in heard(short.step(0.005), 0x2A5)]
    assert len(set(in_one)) == 100
    assert in_one == in_many


def test_the_same_seed_and_calls_give_the_same_frames() -> None:
    def life(seed: int) -> list[Frame]:
        arm = Firmware(TWO, seed=seed, joints_deg=(0, 90, -90, 0, 0, 0))
        frames = arm.on_frame(frame("471#0702000000000000"))
        tell(arm, mode(60), *target(40.0, 30.0, -20.0, 0, 10.0, 0))
        frames += arm.step(0.7)
        tell(arm, STOP)
        return frames + arm.step(1.0)

    assert life(1) == life(1)
    assert life(1) != life(2)


@pytest.mark.parametrize("generation", BOTH)
def test_end_pose_is_the_forward_kinematics_of_the_joints(generation: Generation) -> None:
    arm, codec = ready(generation), Codec(generation)
    tell(arm, mode(50), *target(40.0, 70.0, -50.0, 30.0, -20.0, 60.0))
    for _ in range(30):
        frames = arm.step(0.1)
        joints = [
            value
            for identifier in (0x2A5, 0x2A6, 0x2A7)
            for value in signals(codec, frames, identifier).values()
        ]
        pose = [
            value
            for identifier in (0x2A2, 0x2A3, 0x2A4)
            for value in signals(codec, frames, identifier).values()
        ]
        # 0.001° of each joint at 0.6 m reach is 0.01 mm
        assert pose == pytest.approx(Kinematics(PIPER).forward(joints), abs=0.06)


def test_driver_positions_and_speeds_in_radians() -> None:
    arm, codec = ready(TWO), Codec(TWO)
    tell(arm, mode(100), *target(90.0, 90.0, -90.0, 45.0, -30.0, 60.0))
    before = arm.step(0.3)
    for _ in range(60):
        after = arm.step(0.005)
        for joint in range(1, 7):
            earlier = signals(codec, before, 0x250 + joint)
            later = signals(codec, after, 0x250 + joint)
            moved = later["Position"] - earlier["Position"]
            mean = (later["Speed"] + earlier["Speed"]) / 2
            # each position is rounded to 0.001 rad, in 5 ms that is 0.2 rad/s
            assert moved / 0.005 == pytest.approx(mean, abs=0.21)
            assert later["Position"] == pytest.approx(
                math.radians(arm.joints_deg[joint - 1]), abs=0.00051
            )
        before = after


def test_driver_positions_and_speeds_in_pulses_and_rpm() -> None:
    arm, codec = ready(ONE), Codec(ONE)
    tell(arm, mode(100), *target(120.0, 0, 0, 0, 0, 0))
    frames = arm.step(0.65)
    # full speed: 3 rad/s = 28.6 RPM
    assert signals(codec, frames, 0x251)["Speed"] == 29
    arm.step(2.0)
    # 120° of 65536 pulses a turn
    assert signals(codec, arm.step(0.02), 0x251)["Position"] == 21845


@pytest.mark.parametrize(("generation", "speed"), [(ONE, 32767), (TWO, 32.767)])
def test_a_driver_reports_no_more_speed_than_its_field_holds(generation, speed) -> None:
    arm, codec = ready(generation), Codec(generation)
    arm.mechanics.speeds_deg_s = (1e7, -1e7, 0.0, 0.0, 0.0, 0.0)
    frames = [Feedback(codec, arm)._driver_fast(joint) for joint in (1, 2)]
    assert signals(codec, frames, 0x251)["Speed"] == pytest.approx(speed)
    assert signals(codec, frames, 0x252)["Speed"] == pytest.approx(-speed)


def test_currents_carry_the_weight_and_vanish_without_power() -> None:
    arm, codec = ready(TWO, joints_deg=(0, 150.0, -60.0, 0, 0, 0)), Codec(TWO)
    frames = arm.step(0.1)
    # leaning forward, joint 2 is pulled to larger angles and pushes back
    assert signals(codec, frames, 0x252)["Current"] < -0.5
    assert signals(codec, frames, 0x251)["Current"] == 0.0
    tell(arm, DISABLE)
    frames = arm.step(0.1)
    assert all(signals(codec, frames, identifier)["Current"] == 0.0 for identifier in FAST)


def test_accelerating_a_joint_takes_current_in_its_direction() -> None:
    arm, codec = ready(TWO), Codec(TWO)
    tell(arm, mode(100), *target(90.0, 0, 0, 0, 0, 0))
    assert signals(codec, arm.step(0.1), 0x251)["Current"] > 0.1
    # most of the way lies behind: braking
    assert signals(codec, arm.step(0.85), 0x251)["Current"] < 0.0


def test_current_without_sign_in_generation_1() -> None:
    arm, codec = ready(ONE, joints_deg=(0, 150.0, -60.0, 0, 0, 0)), Codec(ONE)
    assert signals(codec, arm.step(0.1), 0x252)["Current"] > 0.5


@pytest.mark.parametrize("generation", BOTH)
def test_supply_and_temperatures_are_plausible(generation: Generation) -> None:
    arm, codec = ready(generation, joints_deg=(0, 160.0, -60.0, 0, 0, 0)), Codec(generation)
    first: dict[int, float] = {}
    for _ in range(12):
        frames = arm.step(10.0)[-FRAMES_A_SECOND:]
        for identifier in SLOW:
            slow = signals(codec, frames, identifier)
            assert slow["Voltage"] == pytest.approx(24.0, abs=0.25)
            assert 30 <= slow["DriverTemperature"] <= 40
            assert 30 <= slow["MotorTemperature"] <= 40
            first.setdefault(identifier, slow["MotorTemperature"])
    # joint 2 holds the arm and warms; joint 1 holds nothing
    assert signals(codec, frames, 0x262)["MotorTemperature"] > first[0x262]
    assert signals(codec, frames, 0x261)["MotorTemperature"] == first[0x261]


def test_angles_at_rest_do_not_jitter() -> None:
    arm = ready(joints_deg=(1.2345, 90.0, -90.0, 5.4321, 10.0, 20.0))
    frames = arm.step(5.0)
    for identifier in CONTROLLER + FAST:
        assert len(set(heard(frames, identifier))) == 1


def test_time_cannot_run_backwards() -> None:
    arm = Firmware(TWO)
    with pytest.raises(ValueError, match=r"dt_s is -0\.1"):
        arm.step(-0.1)
    with pytest.raises(ValueError, match="dt_s is nan"):
        arm.step(math.nan)
    assert arm.step(0.0) == []
    assert arm.time_s == 0.0


def test_another_version_is_told_as_text() -> None:
    arm = Firmware(TWO, version="S-V1.5-2")
    answers = arm.on_frame(frame("4AF#0100000000000000"))
    assert b"S-V1.5-2" in b"".join(each.data for each in answers)
