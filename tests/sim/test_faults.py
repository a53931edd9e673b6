"""What breaks, as the bytes tell it; and how faults are named, planned, started and ended."""

from __future__ import annotations

import pytest

from armui.protocol.codec import Codec, Message
from armui.protocol.codes import ArmStatusCode, EndLoad, MotionState
from armui.protocol.generation import Generation
from armui.sim.faults.faulty_link import FaultyLink
from armui.sim.faults.schedule import FAULTS, Fault, FaultError, Faults, fault, read_fault
from armui.sim.firmware import Firmware
from tests.moments import now
from tests.sim.talk import BOTH, ENABLE, FRAMES_A_SECOND, RESUME, heard, mode, ready, target, tell

ONE, TWO = Generation.ONE, Generation.TWO
LEANING = (10.0, 110.0, -60.0, 5.0, 10.0, 15.0)
CLEAR_2 = "475#0200000000AE0000"
CLEAR_ALL = "475#0700000000AE0000"


def breaking(arm: Firmware) -> Faults:
    return Faults(arm, FaultyLink())


def told(arm: Firmware) -> tuple[str, str, list[str]]:
    """Bytes 1 and 7 of 0x2A1, and byte 5 of 0x261–0x266."""
    frames = arm.step(0.1)
    status = heard(frames, 0x2A1)[-1]
    return status[2:4], status[14:16], [heard(frames, 0x260 + j)[-1][10:12] for j in range(1, 7)]


# byte 5: bit 6 enabled; bit 7 homed in generation 1 only
FINE = {ONE: "C0", TWO: "40"}
# name, status 0x2A1 byte 1, byte 5 of joint 2 in generations 1 and 2
IN_BYTES = [
    ("motor-overtemperature", "09", "C2", "42"),  # bit 1
    ("driver-overtemperature", "09", "C8", "48"),  # bit 3
    ("sensor-error", "09", "D0", "60"),  # bit 4; in generation 2 told as driver fault, bit 5
    ("overcurrent", "09", "84", "04"),  # bit 2, and no longer enabled
    ("driver-error", "09", "A0", "20"),  # bit 5, and no longer enabled
    ("collision", "07", "C0", "50"),  # generation 2: bit 4; generation 1 has the status alone
]


@pytest.mark.each_value(full="each fault in both generations")
@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize(("name", "status", "one", "two"), IN_BYTES)
def test_a_joint_fault_shows_and_stops_the_motion(
    generation: Generation, name: str, status: str, one: str, two: str
) -> None:
    arm = ready(generation)
    tell(arm, mode(50), *target(90.0, 60.0, -60.0, 0, 0, 0))
    arm.step(0.4)
    assert told(arm) == ("00", "00", [FINE[generation]] * 6)
    broken = fault(name, 2)
    faults = breaking(arm)
    faults.start(broken)
    arm.step(2.0)
    fine = FINE[generation]
    shown = one if generation is ONE else two
    assert told(arm) == (status, "00", [fine, shown, fine, fine, fine, fine])
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    assert 0.0 < arm.joints_deg[0] < 90.0
    here = arm.joints_deg[0]
    tell(arm, *target(0, 0, 0, 0, 0, 0))
    arm.step(0.5)
    assert arm.joints_deg[0] == here


@pytest.mark.parametrize("generation", BOTH)
def test_low_voltage_shows_in_every_driver(generation: Generation) -> None:
    arm = ready(generation)
    faults, broken = breaking(arm), fault("undervoltage")
    faults.start(broken)
    frames = arm.step(0.1)
    # 18.0 V = 180 = 0xB4, within 0.1 V of noise
    assert all(0xB2 <= int(heard(frames, 0x260 + j)[-1][:4], 16) <= 0xB5 for j in range(1, 7))
    low = f"{int(FINE[generation], 16) | 1:02X}"
    assert told(arm) == ("09", "00", [low] * 6)
    faults.end(broken)
    arm.step(0.1)
    assert told(arm) == ("00", "00", [FINE[generation]] * 6)


@pytest.mark.parametrize("generation", BOTH)
def test_a_lost_joint_shows_in_0x2a1(generation: Generation) -> None:
    arm = ready(generation)
    faults, broken = breaking(arm), fault("joint-communication", 3)
    faults.start(broken)
    assert told(arm)[:2] == ("05", "04")
    faults.end(broken)
    assert told(arm)[:2] == ("00", "00")


@pytest.mark.parametrize(("generation", "byte_5"), [(ONE, "C0"), (TWO, "C0")])
def test_a_blocked_joint_stalls_when_it_is_driven(generation: Generation, byte_5: str) -> None:
    arm = ready(generation)
    faults, broken = breaking(arm), fault("stall", 2)
    faults.start(broken)
    tell(arm, mode(50), *target(20.0, 0, 0, 0, 0, 0))
    arm.step(3.0)
    assert arm.joints_deg[0] == 20.0
    assert told(arm)[0] == "00"
    tell(arm, *target(0, 30.0, 0, 0, 0, 0))
    arm.step(0.1)
    status, _, drivers = told(arm)
    # generation 2: bit 7 stall, bit 6 enabled; generation 1: bit 7 homed
    assert (status, drivers[1]) == ("09", byte_5)
    assert abs(arm.joints_deg[1]) < 0.1
    tell(arm, CLEAR_2, *target(0, 30.0, 0, 0, 0, 0))
    arm.step(0.1)
    assert told(arm)[0] == "09"
    faults.end(broken)
    tell(arm, CLEAR_2, *target(0, 30.0, 0, 0, 0, 0))
    arm.step(5.0)
    assert arm.joints_deg[:2] == (0.0, 30.0)


@pytest.mark.parametrize("name", ["overcurrent", "driver-error"])
def test_a_driver_that_gave_up_drops_its_joint_and_is_enabled_again_once_cleared(name: str) -> None:
    arm = ready(joints_deg=LEANING)
    faults, broken = breaking(arm), fault(name, 2)
    faults.start(broken)
    assert arm.enabled == (True, False, True, True, True, True)
    arm.step(0.5)
    assert arm.joints_deg[1] > LEANING[1] + 2.0
    tell(arm, CLEAR_2, ENABLE)
    assert not arm.enabled[1]  # the cause is still there
    faults.end(broken)
    tell(arm, ENABLE)
    assert not arm.enabled[1]  # the alarm is kept
    assert tell(arm, CLEAR_2, ENABLE)
    assert arm.enabled == (True,) * 6
    assert arm.condition.status is ArmStatusCode.NORMAL


@pytest.mark.parametrize("remedy", [CLEAR_ALL, RESUME])
def test_a_collision_is_kept_until_cleared(remedy: str) -> None:
    arm = ready()
    faults, broken = breaking(arm), fault("collision", 4)
    faults.start(broken)
    arm.step(0.01)
    faults.end(broken)
    arm.step(1.0)
    assert now(arm.condition.status) is ArmStatusCode.COLLISION
    assert arm.enabled == (True,) * 6
    tell(arm, "475#0100000000AE0000")  # joint 1 is not the one
    assert now(arm.condition.status) is ArmStatusCode.COLLISION
    tell(arm, remedy)
    arm.step(0.1)
    assert now(arm.condition.status) is ArmStatusCode.NORMAL


@pytest.mark.parametrize("level", range(9))
@pytest.mark.parametrize(("joint", "step_nm"), [(2, 2.0), (5, 0.6)])
def test_a_push_is_felt_from_the_level_s_torque_on(level: int, joint: int, step_nm: float) -> None:
    arm = ready()
    levels = "".join(f"{level if j == joint else 8:02X}" for j in range(1, 7))
    tell(arm, f"47A#{levels}0000")
    arm.protection.push(joint - 1, level * step_nm - 0.01)
    arm.step(0.1)
    assert arm.condition.status is ArmStatusCode.NORMAL
    arm.protection.push(joint - 1, -(level * step_nm + 0.01) if level else 40.0)
    arm.step(0.1)
    assert arm.condition.status is (ArmStatusCode.COLLISION if level else ArmStatusCode.NORMAL)


def test_an_arm_without_power_feels_no_collision_but_is_pushed() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, "471#0701000000000000")
    arm.step(20.0)
    resting = arm.joints_deg
    arm.protection.push(0, 40.0)
    arm.step(0.5)
    assert arm.condition.status is ArmStatusCode.NORMAL
    assert arm.joints_deg[0] > resting[0] + 1.0


def test_a_heated_motor_cools_and_the_alarm_ends_with_it() -> None:
    arm, codec = ready(TWO), Codec(TWO)
    faults, broken = breaking(arm), fault("motor-overtemperature", 6)

    def motor_c() -> float:
        message = codec.decode([f for f in arm.step(0.1) if f.arbitration_id == 0x266][-1])
        assert isinstance(message, Message)
        return message.signals["MotorTemperature"]

    faults.start(broken)
    assert motor_c() == 95
    faults.end(broken)
    hot_for_s = 0.0
    while arm.condition.status is ArmStatusCode.JOINT_STATUS_ABNORMAL:
        arm.step(1.0)
        hot_for_s += 1.0
        assert hot_for_s < 100.0
    assert 10.0 < hot_for_s < 60.0
    assert motor_c() <= 75


def test_a_load_nobody_told_the_arm_of_is_taken_for_a_collision() -> None:
    arm = ready(joints_deg=LEANING)
    arm.settings_applier.hang(1.5)
    arm.step(0.1)
    assert arm.condition.status is ArmStatusCode.COLLISION
    told_so = ready(joints_deg=LEANING)
    tell(told_so, "477#000000AE02000000")
    told_so.step(0.1)
    assert told_so.settings.load is EndLoad.FULL
    assert told_so.condition.status is ArmStatusCode.NORMAL


def test_corrupt_limits_stay_until_reset() -> None:
    arm = Firmware(TWO)
    faults, broken = breaking(arm), fault("corrupt-limits", 2)
    faults.start(broken)
    faults.end(broken)
    assert tell(arm, "472#0201000000000000") == ["473#02FFFFFFFFFFFF00"]
    assert tell(arm, "472#0301000000000000") == ["473#030000F95C012C00"]


def test_stopped_feedback_still_answers() -> None:
    arm = Firmware(TWO)
    faults, broken = breaking(arm), fault("feedback-stopped")
    faults.start(broken)
    assert arm.step(1.0) == []
    assert tell(arm, "477#0200000000000000") == ["47B#0101010101010000"]
    faults.end(broken)
    assert len(arm.step(1.0)) == FRAMES_A_SECOND


def test_planned_faults_begin_and_end_at_their_time() -> None:
    arm = Firmware(TWO)
    late, early = fault("sensor-error", 1, start_s=2.0, end_s=3.0), fault("sensor-error", 2)
    faults = Faults(arm, FaultyLink(), [late, early])
    seen = []
    for tick in range(9):
        faults.at(tick * 0.5)
        seen.append([each.value for each in faults.active])
    assert seen == [[2], [2], [2], [2], [2, 1], [2, 1], [2], [2], [2]]


def test_starting_twice_and_ending_twice_is_harmless() -> None:
    arm = Firmware(TWO)
    faults, broken = breaking(arm), fault("lost-frames", 0.5)
    faults.start(broken)
    faults.start(broken)
    faults.end(broken)
    faults.end(broken)
    assert faults.active == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("overcurrent@5", Fault("overcurrent", 1, 5.0, None)),
        ("overcurrent:3@5-10", Fault("overcurrent", 3, 5.0, 10.0)),
        ("lost-frames:0.25@0.5", Fault("lost-frames", 0.25, 0.5, None)),
        ("latency@0-1.5", Fault("latency", 0.05, 0.0, 1.5)),
        ("garbage:2000@1", Fault("garbage", 2000, 1.0, None)),
        ("bus-off@3-4", Fault("bus-off", 0, 3.0, 4.0)),
    ],
)
def test_faults_are_read(text: str, expected: Fault) -> None:
    assert read_fault(text) == expected


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("fire@1", "no fault is called 'fire'; there are joint-communication, "),
        ("stall", "write NAME@SECONDS"),
        ("stall@soon", "write NAME@SECONDS"),
        ("stall@1.2.3", "no number"),
        ("stall:7@1", "the joint is 7; give 1 to 6"),
        ("stall:1.5@1", "the joint is 1.5; give a whole number"),
        ("lost-frames:1.1@1", "the share of the frames is 1.1; give 0 to 1"),
        ("bus-off:1@1", "bus-off takes no number; leave out :1"),
        ("stall@5-5", "stall ends at 5 s, which is not after 5 s"),
        ("", "write NAME@SECONDS"),
    ],
)
def test_faults_that_cannot_be_say_why(text: str, reason: str) -> None:
    with pytest.raises(FaultError) as caught:
        read_fault(text)
    assert reason in str(caught.value)


@pytest.mark.each_value(full="each fault in both generations")
@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize("name", FAULTS)
def test_every_fault_leaves_no_trace_when_it_has_ended_and_errors_are_cleared(
    name: str, generation: Generation
) -> None:
    arm = ready(generation)
    faults, broken = breaking(arm), fault(name)
    faults.start(broken)
    arm.step(0.5)
    faults.end(broken)
    arm.step(60.0 if "temperature" in name else 5.0)  # what is hot cools in its own time
    tell(arm, RESUME, ENABLE)
    arm.step(0.1)
    assert told(arm) == ("00", "00", [FINE[generation]] * 6)


def test_a_joint_that_loses_its_reference_reports_an_excursion_and_is_off_from_then_on() -> None:
    arm = ready()
    faults, broken = breaking(arm), fault("lost-reference")
    faults.start(broken)
    frames = arm.step(0.5)
    # 60.000° = 60,000 = 0x0000EA60; J6 stays at 0
    assert heard(frames, 0x2A7)[-1] == "0000EA6000000000"
    # the motor's current in mA: 3,700 = 0x0E74, and no more
    assert {data[4:8] for data in heard(frames, 0x255)[1:-1]} == {"0E74"}
    assert arm.true_joints_deg[4] == 0.0
    faults.end(broken)  # does not mend by itself
    frames = arm.step(1.0)
    assert heard(frames, 0x2A7)[-1] == "0000000000000000"
    assert heard(frames, 0x255)[-1][:4] == "0000"  # and stands still
    assert arm.true_joints_deg[4] == pytest.approx(-60.0)
    assert told(arm) == ("00", "00", [FINE[TWO]] * 6)
    arm.power_cycle()
    tell(arm, ENABLE)
    arm.step(0.1)
    assert arm.true_joints_deg[4] - arm.joints_deg[4] == pytest.approx(-60.0)
    tell(arm, RESUME)
    arm.step(0.1)
    assert arm.true_joints_deg[4] == arm.joints_deg[4]
    # -60.000° = 0xFFFF15A0, as long as the joint has not sunk
    assert heard(arm.step(0.02), 0x2A7)[-1][:6] == "FFFF15"


def test_its_shift_ends_at_the_stop_and_may_be_smaller_than_the_excursion() -> None:
    arm = ready(joints_deg=(0.0, 0.0, 0.0, 0.0, 20.0, 0.0))
    arm.lost_reference.begin(4, excursion_deg=89.0, shift_deg=-85.0)
    assert heard(arm.step(0.5), 0x2A7)[-1] == "0001A9C800000000"  # 109.000°
    arm.step(1.0)
    assert arm.true_joints_deg[4] == pytest.approx(-65.0)
    assert heard(arm.step(0.02), 0x2A7)[-1] == "00004E2000000000"


def swung(arm: Firmware) -> tuple[float, float]:
    """How far joint 3 is behind at its top speed, in degrees, and its motor's current there."""
    tell(arm, mode(10), *target(0, 90.0, -90.0, 0, 0, 0))
    arm.step(60.0)
    tell(arm, mode(10), *target(0, 90.0, -60.0, 0, 0, 0))
    frames = arm.step(1.2)
    behind = arm.mechanics.setpoints_deg[2] - arm.joints_deg[2]
    return behind, int(heard(frames, 0x253)[-1][4:8], 16) / 1000.0


def test_a_stiff_joint_stays_behind_and_needs_more_current_until_the_fault_ends() -> None:
    arm = ready()
    faults, broken = breaking(arm), fault("stiff-joint", 3)
    behind, current = swung(arm)
    assert behind == pytest.approx(arm.mechanics.sag_deg[2])
    faults.start(broken)
    stiff_behind, stiff_current = swung(arm)
    # 5 · 0.4 N·m; assumed: 0.3° for each N·m
    assert stiff_behind - behind == pytest.approx(0.6, abs=0.05)
    assert abs(stiff_current - current) == pytest.approx(2.0 / arm.type.nm_per_ampere[2], rel=0.05)
    arm.step(30.0)
    assert arm.joints_deg[2] == pytest.approx(-60.0, abs=0.5)  # it arrives nevertheless
    faults.end(broken)
    assert swung(arm) == pytest.approx((behind, current), abs=1e-3)


def test_a_joint_runs_hot_without_an_alarm_until_the_fault_ends() -> None:
    arm = ready()
    faults, broken = breaking(arm), fault("hot-joint", 2)
    before = arm.drivers.motor_temperatures_c[1]
    faults.start(broken)
    arm.step(10.0)
    assert arm.drivers.motor_temperatures_c[1] == pytest.approx(before + 25.0, abs=2.0)
    assert told(arm)[:2] == ("00", "00")
    faults.end(broken)
    assert arm.drivers.motor_temperatures_c[1] == pytest.approx(before, abs=2.0)


@pytest.mark.parametrize(("joint", "slips_deg"), [(5, 5.0), (2, 5.0), (3, -5.0)])
def test_what_has_slipped_shows_at_the_next_resume(joint: int, slips_deg: float) -> None:
    arm = ready()
    place = joint - 1
    breaking(arm).start(fault("slip", joint))
    arm.step(0.1)
    assert arm.reported_deg[place] == 0.0
    assert abs(arm.true_joints_deg[place]) == pytest.approx(abs(slips_deg))
    tell(arm, RESUME)
    assert arm.reported_deg[place] == pytest.approx(arm.true_joints_deg[place])
    assert abs(arm.reported_deg[place]) == pytest.approx(5.0)
