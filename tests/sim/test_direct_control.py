"""MIT control and high-follow: 0x151 byte 3 = 0xAD, and what a mode word does to limp joints."""

from __future__ import annotations

import pytest

from armui.protocol.codes import ControlMode, MotionState, MoveMode
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import (
    DISABLE,
    ENABLE,
    RESUME,
    STANDBY,
    STOP,
    mode,
    ready,
    status_bytes,
    target,
    tell,
)

MIT = "151#010400AD00000000"
HIGH_FOLLOW = "151#010100AD00000000"
CPV = "151#0105320000000000"
LEANING = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)
"""Gravity pulls joints 2, 3 and 5 from here."""


def setpoint(joint: int, angle_deg: float, *, kp: int = 0x051, kd: int = 0x947) -> str:
    """0x15A–0x15F: position 16 bit over ±12.5 rad, speed and torque nearest 0, kp 10, kd 0.8."""
    raw = int((angle_deg * 3.141592653589793 / 180.0 + 12.5) * 65535 / 25.0)
    word = (
        raw << 48 | 0x7FF << 36 | kp << 24 | kd << 12 | 0x7F << 4
    )  # position, speed, kp, kd, torque, check
    return f"{0x159 + joint:03X}#{word:016X}"


def hold(joints_deg: tuple[float, ...]) -> list[str]:
    return [setpoint(joint, angle) for joint, angle in enumerate(joints_deg, start=1)]


def in_mit(joints_deg: tuple[float, ...] = LEANING) -> Firmware:
    arm = ready(joints_deg=joints_deg)
    tell(arm, MIT, *hold(joints_deg))
    return arm


def test_the_frames_are_those_of_the_worked_example() -> None:
    # 0.5 rad = 28.648°, kp 10, kd 0.8: 85 1E 7F F0 51 94 77 (check left out)
    assert setpoint(1, 28.6479)[:18] == "15A#851E7FF0519477"


def test_joints_with_a_setpoint_hold_it_and_follow_the_next() -> None:
    arm = in_mit()
    arm.step(5.0)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.02)  # a step is 0.022°
    assert arm.move_mode is MoveMode.MOVE_M
    assert arm.enabled == (True,) * 6
    tell(arm, setpoint(6, 30.0))
    arm.step(0.09)
    assert 15.0 < arm.joints_deg[5] < 25.0  # one lag: 63 % of the way
    arm.step(2.0)
    assert arm.joints_deg == pytest.approx((*LEANING[:5], 30.0), abs=0.02)


def test_there_is_no_watchdog_and_joint_limits_do_not_bound_a_setpoint() -> None:
    arm = in_mit()
    tell(arm, "474#0601F4FE0C7FFF00")  # J6: 50.0°, −50.0°, speed as it is
    assert arm.settings.limits[5].max_deg == 50.0
    tell(arm, setpoint(6, 80.0))
    arm.step(60.0)
    assert arm.joints_deg[5] == pytest.approx(80.0, abs=0.02)
    assert arm.status.name == "NORMAL"


@pytest.mark.parametrize("word", [MIT, mode(30), mode(0, move=2), STANDBY, CPV, HIGH_FOLLOW])
def test_a_new_mode_word_leaves_every_joint_limp_though_powered(word: str) -> None:
    arm = in_mit()
    arm.step(1.0)
    before = arm.joints_deg
    tell(arm, word)
    arm.step(0.3)
    assert arm.enabled == (True,) * 6
    for joint in (1, 2):
        assert abs(arm.joints_deg[joint] - before[joint]) > 5.0
    assert max(map(abs, arm.mechanics.speeds_deg_s)) > 20.0


def test_after_a_mode_word_each_joint_waits_for_its_own_frame() -> None:
    arm = in_mit()
    tell(arm, MIT, *(line for joint, line in enumerate(hold(LEANING), 1) if joint != 3))
    arm.step(0.3)
    assert arm.joints_deg[1] == pytest.approx(LEANING[1], abs=0.05)
    fallen = arm.joints_deg[2]
    assert abs(fallen - LEANING[2]) > 5.0
    tell(arm, setpoint(3, fallen))
    arm.step(1.0)
    assert arm.joints_deg[2] == pytest.approx(fallen, abs=0.05)


def test_a_host_that_repeats_mode_word_and_setpoints_holds_the_arm() -> None:
    arm = in_mit()
    for _ in range(200):
        tell(arm, MIT, *hold(LEANING))
        arm.step(0.005)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.05)


def test_no_gain_falls_and_damping_alone_sinks_slowly() -> None:
    falls, sinks = in_mit(), in_mit()
    tell(falls, setpoint(2, 60.0, kp=0, kd=0x7FF))
    tell(sinks, setpoint(2, 60.0, kp=0))
    falls.step(0.3)
    sinks.step(0.3)
    assert abs(falls.joints_deg[1] - 60.0) > 5.0
    assert 0.1 < abs(sinks.joints_deg[1] - 60.0) < 2.0


def test_joint_targets_do_nothing_in_mit_and_a_target_after_it_catches_the_arm() -> None:
    arm = in_mit()
    tell(arm, *target(10, 60, -60, 0, 20, 0))
    arm.step(1.0)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.02)
    tell(arm, mode(100))
    arm.step(1.0)
    # the target that waited is taken up at once, from where the joints were
    assert arm.joints_deg == pytest.approx((10, 60, -60, 0, 20, 0), abs=0.02)


def test_mit_frames_outside_mit_do_nothing() -> None:
    arm, other = ready(joints_deg=LEANING), ready(joints_deg=LEANING)
    tell(arm, setpoint(2, 0.0), mode(30), setpoint(3, 0.0))
    tell(other, mode(30))
    assert arm.step(1.0) == other.step(1.0)


def test_a_stop_damps_the_joints_and_a_resume_ends_mit() -> None:
    arm = in_mit()
    tell(arm, STOP)
    tell(arm, *hold(LEANING))
    arm.step(0.3)
    assert 0.1 < abs(arm.joints_deg[1] - LEANING[1]) < 2.0
    tell(arm, RESUME, ENABLE)
    arm.step(0.5)
    caught = arm.joints_deg
    tell(arm, mode(30))
    arm.step(1.0)
    assert arm.joints_deg == caught
    assert arm.control_mode is ControlMode.CAN_CONTROL


def test_a_joint_switched_on_in_mit_is_limp_and_enabling_again_changes_nothing() -> None:
    arm = in_mit()
    tell(arm, ENABLE)
    arm.step(0.5)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.02)
    tell(arm, "471#0201000000000000", "471#0202000000000000")
    arm.step(0.3)
    assert arm.enabled == (True,) * 6
    assert abs(arm.joints_deg[1] - LEANING[1]) > 5.0
    tell(arm, DISABLE)
    assert arm.enabled == (False,) * 6


def test_high_follow_takes_targets_without_planning() -> None:
    arm = ready()
    tell(arm, HIGH_FOLLOW, *target(20, 30, -30, 0, 0, 0))
    arm.step(0.09)
    assert arm.joints_deg[0] == pytest.approx(20 * 0.632, abs=1.0)  # 63 % in one lag
    assert arm.move_mode is MoveMode.MOVE_J
    assert arm.motion_state is MotionState.REACHED  # no plan, nothing to reach
    arm.step(2.0)
    assert arm.joints_deg == pytest.approx((20, 30, -30, 0, 0, 0), abs=0.01)
    tell(arm, *target(151, 30, -30, 0, 0, 0))
    arm.step(1.0)
    assert arm.status.name == "TARGET_BEYOND_LIMIT"
    assert arm.joints_deg == pytest.approx((20, 30, -30, 0, 0, 0), abs=0.01)


def test_a_plain_mode_word_in_high_follow_lets_the_arm_fall() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, HIGH_FOLLOW, *target(*LEANING))
    arm.step(1.0)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.01)
    tell(arm, mode(30))
    arm.step(0.3)
    assert abs(arm.joints_deg[1] - LEANING[1]) > 5.0
    fallen = arm.joints_deg
    tell(arm, *target(*fallen))
    arm.step(1.0)
    assert arm.joints_deg == pytest.approx(fallen, abs=0.01)


def test_the_status_knows_mit_and_cpv() -> None:
    arm = ready()
    tell(arm, MIT)
    assert status_bytes(arm)[4:6] == "04"
    tell(arm, CPV)
    assert status_bytes(arm)[4:6] == "05"


def test_cpv_holds_the_arm_and_takes_no_joint_target() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, CPV, *target(10, 60, -60, 0, 20, 0))
    arm.step(1.0)
    assert arm.joints_deg == LEANING


def test_generation_1_knows_neither() -> None:
    arm = ready(Generation.ONE, joints_deg=LEANING)
    tell(arm, MIT, HIGH_FOLLOW, *hold(LEANING))
    arm.step(1.0)
    assert arm.joints_deg == LEANING
    assert arm.move_mode is MoveMode.MOVE_J
