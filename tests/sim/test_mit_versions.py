"""What differs in MIT with the firmware and the model: code, layout, signs, torque, the way out."""

from __future__ import annotations

import math

import pytest

from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from armui.sim.mechanics.driver_loop import DriverSetpoint
from tests.sim.talk import ENABLE, RESUME, mode, status_bytes, target, tell

WORDS = {0x04: "151#010400AD00000000", 0x06: "151#010600AD00000000"}
HIGH_FOLLOW = "151#010100AD00000000"
EXAMPLES = (
    # p, v, kp, kd, t; layout A, layout B
    ((0.5, 0.0, 10.0, 0.8, 2.0), "851E7FF0519479F8", "851E7FF0519478FF"),
    ((0.5, 0.0, 10.0, 0.8, 0.0), "851E7FF0519477F6", "851E7FF0519477FF"),
    ((0.0, 0.0, 10.0, 0.8, 0.0), "7FFF7FF0519477FD", "7FFF7FF0519477FF"),
    ((-0.5, 1.0, 20.0, 1.0, -1.5), "7AE082D0A3999674", "7AE082D0A399973F"),
    ((0.0, 0.0, 0.0, 0.0, 0.0), "7FFF7FF0007FF7F7", "7FFF7FF0007FF7FF"),
)
STEPS = (25 / 65535, 90 / 4095, 500 / 4095, 10 / 4095)
"""Of position, speed, kp and kd: a value is at most this much above what the frame says."""

OLD = {"S-V1.5-2", "S-V1.6-5", "S-V1.7-3", "S-V1.8-2", "S-V1.8-3", "S-V1.8-5", "S-V1.8-7"}
NEW = {"S-V1.8-8", "S-V1.8-9", "S-V1.9-0"}
FLIPPED = (-1, -1, 1, -1, 1, -1)


def arm_of(version: str, model: PiperModel = PiperModel.PIPER) -> Firmware:
    arm = Firmware(Generation.TWO, version=version, model=model)
    tell(arm, ENABLE)
    return arm


def told(arm: Firmware, joint: int) -> DriverSetpoint:
    return arm.mechanics._loop._setpoints[joint - 1]


@pytest.mark.parametrize("version", sorted(OLD | NEW))
@pytest.mark.parametrize("example", EXAMPLES)
def test_the_worked_examples_drive_it(version: str, example) -> None:
    values, layout_a, layout_b = example
    arm = arm_of(version)
    is_old = version in OLD
    signs = FLIPPED if version in {"S-V1.5-2", "S-V1.6-5"} else (1,) * 6
    scale_b = (4, 4, 4, 1, 1, 1) if version <= "S-V1.8-2" else (1,) * 6
    scale_c = (1, 1, 1, 0.813252, 0.813252, 0.813252)
    tell(arm, WORDS[0x04 if is_old else 0x06])
    p, v, kp, kd, t = values
    torque_step = 16 / 255 if is_old else 32 / 4095
    for joint in range(1, 7):
        tell(arm, f"{0x159 + joint:03X}#{layout_a if is_old else layout_b}")
        got, sign = told(arm, joint), signs[joint - 1]
        scale = scale_b[joint - 1] * scale_c[joint - 1]
        read = (math.radians(got.position_deg) * sign, got.speed_rad_s * sign, got.kp, got.kd)
        for have, want, step in zip(read, (p, v, kp, kd), STEPS, strict=True):
            assert want - step - 1e-9 <= have <= want + 1e-9
        wire = got.torque_nm * sign / scale
        assert t - torque_step - 1e-9 <= wire <= t + 1e-9


def test_the_whole_chain_of_the_text_for_joint_2_of_version_1_6_5() -> None:
    """Wanted: 0.5 rad, kp 10, kd 0.8, 2.0 N·m at the output; the sign turned, divided by 4."""
    arm = arm_of("S-V1.6-5")
    tell(arm, WORDS[0x04], "15B#7AE07FF051947777")
    got = told(arm, 2)
    assert got.position_deg == pytest.approx(math.degrees(0.5), abs=0.03)
    assert got.torque_nm == pytest.approx(2.0, abs=4 * 16 / 255)
    assert (got.kp, got.kd) == pytest.approx((9.89, 0.8), abs=0.01)


@pytest.mark.parametrize("version", sorted(OLD | NEW))
def test_the_other_code_is_taken_without_error_and_does_nothing(version: str) -> None:
    arm = arm_of(version)
    other = 0x06 if version in OLD else 0x04
    tell(arm, WORDS[other], "15A#851E7FF0519479F8")
    arm.step(0.5)
    assert arm.joints_deg == (0.0,) * 6
    assert status_bytes(arm)[:6] == f"0100{other:02X}"
    assert not arm.condition.direct


@pytest.mark.parametrize(
    ("version", "model", "signs"),
    [
        ("S-V1.8-8", PiperModel.PIPER, (1, 1, 1, 1, 1, 1)),
        ("S-V1.8-8", PiperModel.PIPER_X, (1, 1, 1, -1, -1, 1)),
        ("S-V1.8-9", PiperModel.PIPER_X, (1, 1, 1, 1, 1, 1)),
    ],
)
def test_the_signs_of_the_models(version: str, model: PiperModel, signs) -> None:
    arm = arm_of(version, model)
    tell(arm, WORDS[0x06], *(f"{0x15A + i:03X}#851E7FF0519478FF" for i in range(6)))
    for joint, sign in enumerate(signs, 1):
        got = told(arm, joint)
        assert math.copysign(1, got.position_deg) == sign
        assert math.copysign(1, got.torque_nm) == sign


def test_the_firmware_turns_torque_into_current_as_for_a_piper() -> None:
    """A PiPER H needs 1/0.588 times as much on J4: 2.0 N·m on the wire become 2·0.757·1.7."""
    arm = arm_of("S-V1.8-9", PiperModel.PIPER_H)
    tell(arm, WORDS[0x06], "15D#851E7FF0519478FF")
    assert told(arm, 4).torque_nm == pytest.approx(2.0 * 0.757 * 1.7, rel=0.01)


@pytest.mark.parametrize("word", ["mit", "high-follow"])
@pytest.mark.parametrize("version", sorted(OLD | NEW))
def test_the_way_out_needs_a_reset_before_1_8_5(version: str, word: str) -> None:
    arm = arm_of(version)
    code = 0x04 if version in OLD else 0x06
    tell(arm, WORDS[code] if word == "mit" else HIGH_FOLLOW)
    arm.step(0.1)
    tell(arm, mode(100), *target(20, 0, 0, 0, 0, 0))
    arm.step(2.0)
    follows = version >= "S-V1.8-5"
    assert (arm.joints_deg[0] == pytest.approx(20.0)) is follows
    assert arm.condition.move_mode is MoveMode.MOVE_J
    tell(arm, RESUME, ENABLE, mode(100), *target(30, 0, 0, 0, 0, 0))
    arm.step(2.0)
    assert arm.joints_deg[0] == pytest.approx(30.0)


def test_high_follow_on_an_old_arm_may_change_to_mit_without_a_reset() -> None:
    arm = arm_of("S-V1.7-3")
    tell(arm, HIGH_FOLLOW, mode(30), WORDS[0x04], "15A#851E7FF0519477F6")
    arm.step(3.0)
    assert arm.joints_deg[0] == pytest.approx(math.degrees(0.5), abs=3.0)
