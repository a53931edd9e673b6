"""MIT control and high-follow: 0x151 byte 3 = 0xAD, and what a mode word does to limp joints."""

from __future__ import annotations

import math

import pytest

from armui.protocol.codes import ControlMode, MotionState, MoveMode
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.mechanics.joint_dynamics import JointLosses
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

MIT = "151#010600AD00000000"
OLD_MIT = "151#010400AD00000000"
HIGH_FOLLOW = "151#010100AD00000000"
CPV = "151#0105320000000000"
LEANING = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)
"""Gravity pulls joints 2, 3 and 5 from here."""
STIFF = {"kp": 0xFFF, "kd": 0xFFF}
"""500 N·m/rad and 5 N·m·s/rad."""
DRY_NM = JointLosses().dry_nm


def setpoint(
    joint: int, angle_deg: float, *, kp: int = 0x051, kd: int = 0x947, torque: int = 0x7FF
) -> str:
    """0x15A–0x15F, layout B: position 16 bit over ±12.5 rad, speed nearest 0, kp 10, kd 0.8."""
    raw = int((math.radians(angle_deg) + 12.5) * 65535 / 25.0)
    word = raw << 48 | 0x7FF << 36 | kp << 24 | kd << 12 | torque
    return f"{0x159 + joint:03X}#{word:016X}"


def hold(joints_deg: tuple[float, ...], /, **gains: int) -> list[str]:
    return [setpoint(joint, angle, **gains) for joint, angle in enumerate(joints_deg, start=1)]


def in_mit(joints_deg: tuple[float, ...] = LEANING, /, **gains: int) -> Firmware:
    arm = ready(joints_deg=joints_deg)
    tell(arm, MIT, *hold(joints_deg, **gains))
    return arm


def gravity_nm(arm: Firmware) -> tuple[float, ...]:
    return arm.mechanics.weight.torques_nm(arm.joints_deg)


def test_the_frames_are_those_of_the_worked_example() -> None:
    # 0.5 rad = 28.648°, kp 10, kd 0.8, t 0: layout B
    assert setpoint(1, 28.6479) == "15A#851E7FF0519477FF"


@pytest.mark.parametrize("gains", [{}, {"kp": 0x333, "kd": 0x999}, STIFF])
def test_a_held_pose_sags_by_what_gravity_says(gains: dict[str, int]) -> None:
    """In the end kp times the sag is the weight's torque, but for what dry friction bears."""
    arm = in_mit(**gains)
    arm.step(8.0)
    assert arm.mechanics.speeds_deg_s == (0.0,) * 6
    kp = gains.get("kp", 0x051) * 500 / 4095
    sags_rad = [math.radians(a - b) for a, b in zip(arm.joints_deg, LEANING, strict=True)]
    for sag_rad, weight_nm, dry_nm in zip(sags_rad, gravity_nm(arm), DRY_NM, strict=True):
        # half a step of the position, and the torque nearest to 0, 0.0039 N·m
        assert kp * sag_rad == pytest.approx(weight_nm, abs=dry_nm + kp * 0.0004 + 0.004)
    assert abs(sags_rad[2]) > 0.5 * 0.4 / kp
    assert arm.condition.move_mode is MoveMode.MOVE_M_FROM_1_8_8
    assert arm.enabled == (True,) * 6


def test_stiff_and_soft_gains_differ_as_they_should() -> None:
    soft, stiff = in_mit(), in_mit(**STIFF)
    for arm in (soft, stiff):
        arm.step(8.0)
    sag = [abs(arm.joints_deg[2] - LEANING[2]) for arm in (soft, stiff)]
    assert sag[0] > 5.0
    assert sag[1] < 0.4


def test_there_is_no_watchdog_and_joint_limits_do_not_bound_a_setpoint() -> None:
    arm = in_mit(**STIFF)
    tell(arm, "474#0601F4FE0C7FFF00")  # J6: 50.0°, −50.0°, speed as it is
    assert arm.settings.limits[5].max_deg == 50.0
    tell(arm, setpoint(6, 80.0, **STIFF))
    arm.step(6.0)
    assert arm.joints_deg[5] == pytest.approx(80.0, abs=0.1)
    assert arm.condition.status.name == "NORMAL"


@pytest.mark.parametrize("word", [MIT, mode(30), mode(0, move=2), STANDBY, CPV, HIGH_FOLLOW])
def test_a_new_mode_word_leaves_every_joint_limp_though_powered(word: str) -> None:
    arm = in_mit(**STIFF)
    arm.step(1.0)
    before = arm.joints_deg
    tell(arm, word)
    arm.step(0.3)
    assert arm.enabled == (True,) * 6
    assert abs(arm.joints_deg[2] - before[2]) > 5.0
    assert max(map(abs, arm.mechanics.speeds_deg_s)) > 20.0


def test_a_limp_arm_falls_to_its_stops() -> None:
    arm = in_mit(**STIFF)
    tell(arm, MIT)
    arm.step(8.0)
    assert arm.joints_deg[1:3] == pytest.approx((0.0, 0.0), abs=1e-6)
    assert arm.mechanics.speeds_deg_s == (0.0,) * 6
    at_rest = arm.joints_deg
    arm.step(5.0)
    assert arm.joints_deg == at_rest


def test_after_a_mode_word_each_joint_waits_for_its_own_frame() -> None:
    arm = in_mit(**STIFF)
    stiff = hold(LEANING, **STIFF)
    tell(arm, MIT, *(line for joint, line in enumerate(stiff, 1) if joint != 3))
    arm.step(0.3)
    assert arm.joints_deg[1] == pytest.approx(LEANING[1], abs=1.5)
    fallen = arm.joints_deg[2]
    assert abs(fallen - LEANING[2]) > 5.0
    tell(arm, setpoint(3, fallen, **STIFF))
    arm.step(3.0)
    assert arm.joints_deg[2] == pytest.approx(fallen, abs=0.5)


def test_a_host_that_repeats_mode_word_and_setpoints_holds_the_arm() -> None:
    arm, stiff = in_mit(**STIFF), hold(LEANING, **STIFF)
    for _ in range(200):
        tell(arm, MIT, *stiff)
        arm.step(0.005)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.5)


def test_damping_alone_sinks_and_no_gain_falls() -> None:
    falls, sinks = in_mit(**STIFF), in_mit(**STIFF)
    tell(falls, setpoint(3, -60.0, kp=0, kd=0x7FF))
    tell(sinks, setpoint(3, -60.0, kp=0, kd=0xFFF))
    for arm in (falls, sinks):
        arm.step(0.3)
    assert abs(falls.joints_deg[2] + 60.0) > 2.0 * abs(sinks.joints_deg[2] + 60.0) > 0.5


def test_a_torque_turns_a_joint_until_friction_balances_it() -> None:
    arm = ready()
    tell(arm, MIT, *hold((0.0,) * 6, **STIFF))
    # raw 2200: (2200 − 2047.5)·32/4095 = 1.19 N·m on the wire, times c = 0.813 on joint 6
    tell(arm, setpoint(6, 0.0, kp=0, kd=0x7FF, torque=2200))
    arm.step(0.3)
    torque_nm = (2200 * 32 / 4095 - 16) * 0.813252
    # at a steady speed: torque = dry friction + viscous friction (kd −0.0012 is nearly nothing)
    expected = math.degrees((torque_nm - 0.25) / 0.3)
    assert arm.mechanics.speeds_deg_s[5] == pytest.approx(expected, rel=0.01)


def test_gravity_fed_forward_lets_the_arm_float() -> None:
    """A torque of the weight against it, kp = kd = 0, renewed at 200 Hz as gravity asks."""
    pose = (0.0, 90.0, -70.0, 10.0, 20.0, 0.0)
    arm = ready(joints_deg=pose)
    tell(arm, MIT)
    for _ in range(1000):
        lines = []
        for joint, (weight_nm, c) in enumerate(
            zip(gravity_nm(arm), arm.type.mit_torque_scale, strict=True), 1
        ):
            raw = int((-weight_nm / c + 16) * 4095 / 32)
            lines.append(setpoint(joint, 0.0, kp=0, kd=0x7FF, torque=raw))
        tell(arm, *lines)
        arm.step(0.005)
    assert arm.joints_deg == pytest.approx(pose, abs=0.5)
    assert max(map(abs, gravity_nm(arm))) > 1.5  # friction alone would not have held it


def test_every_field_at_the_code_nearest_to_zero_never_makes_a_joint_faster() -> None:
    """p −0.00019, v −0.011, kp 0, kd −0.0012, t −0.0039: the last worked example."""
    arm = in_mit((0.0,) * 6)
    for index in (0, 3, 5):
        arm.mechanics._loop._speeds_rad_s[index] = 1.0
    tell(arm, *(f"{0x15A + index:03X}#7FFF7FF0007FF7FF" for index in range(6)))
    speed = 60.0
    for _ in range(400):
        arm.step(0.005)
        now = max(map(abs, arm.mechanics.speeds_deg_s))
        assert now <= speed
        speed = now
    assert speed == 0.0


def test_joint_targets_do_nothing_in_mit_and_a_target_after_it_catches_the_arm() -> None:
    arm = in_mit(**STIFF)
    tell(arm, *target(10, 60, -60, 0, 20, 0))
    arm.step(1.0)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.5)
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
    arm = in_mit(**STIFF)
    tell(arm, STOP)
    tell(arm, *hold(LEANING))
    arm.step(0.3)
    assert 0.1 < abs(arm.joints_deg[2] - LEANING[2]) < 2.0
    tell(arm, RESUME, ENABLE)
    arm.step(0.5)
    caught = arm.joints_deg
    tell(arm, mode(30))
    arm.step(1.0)
    assert arm.joints_deg == caught
    assert arm.condition.control_mode is ControlMode.CAN_CONTROL


def test_a_joint_switched_on_in_mit_is_limp_and_enabling_again_changes_nothing() -> None:
    arm = in_mit(**STIFF)
    tell(arm, ENABLE)
    arm.step(0.5)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.5)
    tell(arm, "471#0301000000000000", "471#0302000000000000")
    arm.step(0.3)
    assert arm.enabled == (True,) * 6
    assert abs(arm.joints_deg[2] - LEANING[2]) > 5.0
    tell(arm, DISABLE)
    assert arm.enabled == (False,) * 6


def test_high_follow_takes_targets_without_planning() -> None:
    arm = ready()
    goal = (20, 30, -30, 0, 0, 0)
    tell(arm, HIGH_FOLLOW, *target(*goal))
    arm.step(0.05)
    assert arm.mechanics.speeds_deg_s[0] > 30.0
    assert arm.condition.move_mode is MoveMode.MOVE_J
    assert arm.condition.motion_state is MotionState.REACHED  # no plan, nothing to reach
    arm.step(2.0)
    # softer than MOVE J, but it carries its own weight: off by no more than friction holds
    assert arm.joints_deg == pytest.approx(goal, abs=math.degrees(0.4 / 50))
    tell(arm, *target(151, 30, -30, 0, 0, 0))
    arm.step(1.0)
    assert arm.condition.status.name == "TARGET_BEYOND_LIMIT"
    assert arm.joints_deg == pytest.approx(goal, abs=math.degrees(0.4 / 50))


@pytest.mark.parametrize("index", range(6))
def test_high_follow_lags_a_triangle_as_a_user_measured(index: int) -> None:
    """0.089 rad at 1.2 rad/s."""
    pose = [0.0, 60.0, -80.0, 0.0, 0.0, 0.0]
    arm = ready(joints_deg=pose)
    tell(arm, HIGH_FOLLOW, *target(*pose))
    arm.step(0.5)
    for tick in range(1, 121):
        angles = list(pose)
        angles[index] = pose[index] + math.degrees(1.2) * tick * 0.005
        tell(arm, *target(*angles))
        arm.step(0.005)
    lag_rad = math.radians(angles[index] - arm.joints_deg[index])
    assert lag_rad == pytest.approx(0.089, abs=0.02)


def test_a_plain_mode_word_in_high_follow_lets_the_arm_fall() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, HIGH_FOLLOW, *target(*LEANING))
    arm.step(1.0)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.5)
    tell(arm, mode(30))
    arm.step(0.3)
    assert abs(arm.joints_deg[2] - LEANING[2]) > 5.0
    fallen = arm.joints_deg
    tell(arm, *target(*fallen))
    arm.step(3.0)
    assert arm.joints_deg == pytest.approx(fallen, abs=0.01)


def test_the_status_knows_mit_and_cpv() -> None:
    arm = ready()
    tell(arm, MIT)
    assert status_bytes(arm)[4:6] == "06"
    tell(arm, CPV)
    assert status_bytes(arm)[4:6] == "05"


def test_a_mode_word_that_keeps_the_mode_changes_the_speed_and_voids_nothing() -> None:
    arm = in_mit(**STIFF)
    arm.step(1.0)
    tell(arm, "151#01FF320000000000")
    arm.step(1.0)
    assert arm.joints_deg == pytest.approx(LEANING, abs=0.5)
    assert arm.condition.move_mode is MoveMode.MOVE_M_FROM_1_8_8
    assert arm.condition.speed_percent == 50


def test_the_old_code_is_taken_without_error_and_does_nothing() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, OLD_MIT, *hold((10.0,) * 6, **STIFF))
    arm.step(1.0)
    assert arm.joints_deg == LEANING
    assert status_bytes(arm)[2:6] == "0004"


def test_the_drivers_measure_the_torque_they_give() -> None:
    """Current times k·b·c is the torque of the law: 10·(p − q), damped to a standstill."""
    arm = in_mit()
    arm.step(8.0)
    for index in (1, 2, 4):
        given_nm = arm.drivers.currents_a[index] * arm.type.nm_per_ampere[index]
        sag_rad = math.radians(arm.joints_deg[index] - LEANING[index])
        assert given_nm == pytest.approx(-9.89 * sag_rad, abs=0.02)


def test_generation_1_knows_neither() -> None:
    arm = ready(Generation.ONE, joints_deg=LEANING)
    tell(arm, MIT, OLD_MIT, HIGH_FOLLOW, *hold(LEANING))
    arm.step(1.0)
    assert arm.joints_deg == LEANING
    assert arm.condition.move_mode is MoveMode.MOVE_J
