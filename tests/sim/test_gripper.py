"""0x159 in, 0x2A8 out: angle and speed in generation 1, opening and torque in generation 2."""

from __future__ import annotations

import pytest

from armui.arm.state import GripperFault
from armui.protocol.codec import Codec
from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import BOTH, STOP, frame, heard, tell

ONE, TWO = Generation.ONE, Generation.TWO

# 40 mm = 40000 = 0x9C40, 1 N·m = 1000 = 0x03E8, enable; 0 mm
OPEN = "159#00009C4003E80100"
CLOSE = "159#0000000003E80100"


def said(arm: Firmware, after_s: float = 0.02) -> str:
    """The last 0x2A8 after some time."""
    return heard(arm.step(after_s), 0x2A8)[-1]


def test_it_opens_in_millimetres_at_a_finite_speed_and_reports_it() -> None:
    arm = Firmware(TWO)
    tell(arm, OPEN)
    moving = heard(arm.step(0.1), 0x2A8)
    assert len(set(moving)) == len(moving)
    assert arm.gripper.travel == pytest.approx(8.0)  # 80 mm/s
    # no torque where nothing resists; byte 6: enabled (bit 6) and homed (bit 7)
    assert said(arm, 1.0) == "00009C400000C000"
    tell(arm, "159#0000000000000000")
    assert said(arm) == "00009C4000008000"


def test_it_turns_in_degrees_with_its_speed() -> None:
    arm = Firmware(ONE)
    # 30° = 0x7530, 1 rad/s = 0x03E8: there after 0.5236 s
    tell(arm, "159#0000753003E80100")
    payload = said(arm, 0.5)
    assert payload.endswith("03E80100")
    assert payload != "0000753003E80100"
    assert said(arm, 0.06) == "0000753000000100"


def test_it_grips_what_is_between_its_jaws_with_the_torque_asked_for() -> None:
    arm = Firmware(TWO)
    tell(arm, OPEN)
    arm.step(1.0)
    arm.gripper.object_width = 25.0
    tell(arm, CLOSE)
    # 25 mm = 25000 = 0x61A8, 1 N·m
    assert said(arm, 1.0) == "000061A803E8C000"
    # opened again: no torque
    tell(arm, OPEN)
    assert said(arm, 1.0) == "00009C400000C000"
    tell(arm, CLOSE)
    arm.step(1.0)
    arm.gripper.object_width = None
    assert said(arm, 1.0) == "000000000000C000"


@pytest.mark.parametrize(
    ("version", "disable", "said_then"),
    [
        # 25 mm = 0x61A8; 1 N·m and bit 6 (enabled) as long as it holds
        ("S-V1.8-9", "471#0701000000000000", "000061A803E8C000"),
        ("S-V1.9-0", "471#0701000000000000", "000061A800008000"),
        ("S-V2.0-0", "471#0701000000000000", "000061A800008000"),
        *[("S-V1.9-0", f"471#0{joint}01000000000000", "000061A803E8C000") for joint in range(1, 7)],
    ],
)
def test_disabling_all_joints_lets_go_of_the_gripper_too_from_1_9_0_on(
    version: str, disable: str, said_then: str
) -> None:
    arm = Firmware(TWO, version=version)
    tell(arm, "471#0702000000000000", OPEN)
    arm.step(1.0)
    arm.gripper.object_width = 25.0
    tell(arm, CLOSE)
    assert said(arm, 1.0) == "000061A803E8C000"
    tell(arm, disable)
    assert said(arm, 0.1) == said_then


def test_an_object_wider_than_the_opening_is_not_between_the_jaws() -> None:
    arm = Firmware(TWO)
    arm.gripper.object_width = 25.0
    tell(arm, "159#00002710000A0100", CLOSE)  # 10 mm
    assert said(arm, 1.0) == "000000000000C000"


@pytest.mark.parametrize(
    ("stroke", "opening"),
    [
        ("00", "000186A0"),  # 0: no limit but its own 100 mm = 100000
        ("46", "00011170"),  # 70 mm = 70000
        ("64", "000186A0"),  # 100 mm
    ],
)
def test_the_stroke_limit_of_0x47d(stroke: str, opening: str) -> None:
    arm = Firmware(TWO)
    tell(arm, f"47D#64{stroke}010000000000")
    tell(arm, "159#0001D4C003E80100")  # 120 mm
    assert said(arm, 2.0)[:8] == opening


def test_setting_zero_counts_from_here() -> None:
    arm = Firmware(TWO)
    tell(arm, OPEN)
    arm.step(1.0)
    tell(arm, "159#00000000000001AE")  # enabled: not taken
    arm.step(0.01)
    assert arm.gripper.travel > 0.0
    tell(arm, OPEN)
    arm.step(1.0)
    tell(arm, "159#00000000000000AE")
    assert said(arm) == "0000000000008000"
    tell(arm, OPEN)
    assert said(arm, 1.0) == "00009C400000C000"


@pytest.mark.parametrize(
    ("error", "flag"),
    [
        (GripperFault.UNDERVOLTAGE, 0x01),
        (GripperFault.MOTOR_OVERTEMPERATURE, 0x02),
        (GripperFault.OVERCURRENT, 0x04),
        (GripperFault.DRIVER_OVERTEMPERATURE, 0x08),
        (GripperFault.SENSOR, 0x10),
        (GripperFault.DRIVER, 0x20),
    ],
)
def test_an_error_takes_its_power_until_it_is_cleared(error: GripperFault, flag: int) -> None:
    arm = Firmware(TWO)
    tell(arm, OPEN)
    arm.step(0.1)
    arm.gripper.fail(error)
    payload = said(arm, 0.5)
    assert payload[12:14] == f"{0x80 | flag:02X}"
    tell(arm, OPEN)
    assert said(arm, 0.5) == payload
    # clear alone, then clear and enable in one
    tell(arm, "159#0000000000000200")
    assert said(arm)[12:14] == "80"
    arm.gripper.fail(error)
    tell(arm, "159#00009C4003E80300")
    assert said(arm, 1.0) == "00009C400000C000"


def test_in_generation_1_an_error_shows_as_no_power() -> None:
    arm = Firmware(ONE)
    tell(arm, "159#0000753003E80100")
    arm.gripper.fail(GripperFault.OVERCURRENT)
    assert said(arm)[12:14] == "00"
    tell(arm, "159#0000753003E80300")
    assert said(arm)[12:14] == "01"


@pytest.mark.parametrize("generation", BOTH)
def test_a_stopped_arm_takes_no_gripper_command(generation: Generation) -> None:
    arm = Firmware(generation)
    tell(arm, STOP, "159#00009C4003E80100")
    arm.step(0.5)
    assert arm.gripper.travel == 0.0


def test_a_leaders_jaws_follow_the_hand_and_its_follower_follows() -> None:
    leader, follower = Firmware(TWO), Firmware(TWO)
    tell(leader, "470#FA00000000000000")
    leader.hand_guiding.gripper_to = 30.0
    for _ in range(200):
        for each in leader.step(0.005):
            follower.on_frame(each)
        follower.step(0.005)
    # 30 mm = 30000 = 0x7530
    assert heard(leader.step(0.005), 0x159) == ["0000753003E80100"]
    assert follower.gripper.travel == 30.0


def test_it_turns_to_an_angle_and_tells_an_angle_from_then_on() -> None:
    arm = Firmware(TWO)
    # 30° = 30000 = 0x7530, 1 N·m, bits 0 (enable) and 2 (angle); byte 7 of 0x2A8: 1, an angle
    tell(arm, "159#0000753003E80500")
    assert said(arm, 2.0) == "000075300000C001"
    tell(arm, OPEN)
    assert said(arm, 2.0) == "00009C400000C000"


def test_an_older_gripper_takes_an_angle_for_an_opening() -> None:
    arm = Firmware(TWO)
    older = Codec(TWO, firmware=FirmwareVersion(1, 8, 7))
    message = older.decode(frame("159#0000753003E80500"))
    arm.gripper.command(message.signals, knows_angles=older.quirks.has_gripper_angle)
    assert said(arm, 2.0) == "000075300000C000"
