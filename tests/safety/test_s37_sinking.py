"""S37: an arm without power is told to sink, how far and how fast, until it is measured at rest."""

import math
from dataclasses import replace
from itertools import pairwise

from armui.control.operating_state import StopState
from armui.control.safety.recovery_steps import StepKind
from armui.control.safety.sinking_control import FURTHER_S
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion, Unheld
from armui.sim.faults.schedule import fault
from armui.ui import words
from tests.accepted import accepted
from tests.arm_rig import STEP_S
from tests.cell.areas import TABLE, put
from tests.control.jogger import bend
from tests.safety.true_arm import flange, lowest_mm
from tests.sim.talk import mode, target, tell

RAISED_DEG = (10.0, 120.0, -90.0, 15.0, 40.0, 20.0)
LOW_DEG = (10.0, 150.0, -90.0, 15.0, 40.0, 20.0)
"""Not far above where it comes to lie."""
SHOWN_S = 0.25 + 2 * STEP_S
"""The oldest figures that are shown."""
BEGUN_S = 0.4
"""It is told by then."""
OVER_S = 0.6
"""It is told no more by then."""


class Truth:
    """The simulated arm from where it stood, and how it was a moment ago."""

    def __init__(self, rig):
        self._rig = rig
        self._stood_mm = lowest_mm(rig.firmware.joints_deg)
        self.stood_deg = rig.firmware.joints_deg
        self._poses = []

    def step(self):
        self._rig.step()
        joints_deg = self._rig.firmware.joints_deg
        if not self._poses or joints_deg != self._poses[-1][1]:
            self.moved_s = self._rig.time_s
        self._poses.append((self._rig.time_s, joints_deg))
        self._poses = self._poses[-round(0.6 / STEP_S) :]

    def run(self, seconds):
        for _ in range(round(seconds / STEP_S)):
            self.step()

    @property
    def down_mm(self):
        return self._stood_mm - lowest_mm(self._rig.firmware.joints_deg)

    @property
    def stands(self):
        return self._rig.time_s - self.moved_s > 2 * STEP_S

    def speeds_mm_s(self):
        """The flange's speed from step to step over the last 0.6 s."""
        places = [(at_s, flange(joints_deg)[:3, 3]) for at_s, joints_deg in self._poses]
        return [
            math.dist(after, before) / (after_s - before_s)
            for (before_s, before), (after_s, after) in pairwise(places)
        ]


def seen(rig):
    return rig.controller.operating_state.uncommanded


def line(rig):
    return words.step(rig.controller.recovery.step)


def check_figures(rig, truth):
    """What is told is what the arm does, as of a quarter of a second ago at most."""
    motion, speeds_mm_s = seen(rig), truth.speeds_mm_s()
    fastest_mm_s = max(speeds_mm_s)
    assert motion.kind is MotionKind.SINKS
    assert abs(motion.down_mm - truth.down_mm) <= 1.5 + SHOWN_S * fastest_mm_s
    assert min(speeds_mm_s) - 1.0 <= motion.speed_mm_s <= fastest_mm_s + 1.0
    turned_deg = [abs(a - b) for a, b in zip(rig.firmware.joints_deg, truth.stood_deg, strict=True)]
    assert motion.joint == 1 + turned_deg.index(max(turned_deg))
    assert abs(motion.turned_deg - max(turned_deg)) <= 0.3 + SHOWN_S * 6.0


def test_after_the_emergency_stop_of_a_raised_arm_at_each_second_until_it_rests(rig):
    check_the_sinking_of(rig, RAISED_DEG)
    assert rig.codes().count("arm_sinks_on") >= 3


def test_after_the_emergency_stop_of_a_low_arm_of_either_generation(any_rig):
    check_the_sinking_of(any_rig, LOW_DEG)


def check_the_sinking_of(rig, pose_deg):
    bend(rig, pose_deg)
    rig.run(1.0)
    truth, told = Truth(rig), []
    rig.controller.noticed.connect(lambda event: told.append((rig.time_s, event)))
    assert seen(rig) is None
    rig.controller.emergency_stop()
    truth.run(1.0)
    seconds = 0
    while not truth.stands:
        check_figures(rig, truth)
        assert seen(rig).cause is Unheld.STOPPED
        assert abs(seen(rig).seconds - seconds - 1.0) <= 1.0
        assert line(rig).startswith("The arm sinks: ")
        assert f"{seen(rig).speed_mm_s} mm/s" in line(rig)
        assert rig.controller.recovery.step.kind is StepKind.STOPPED
        truth.run(1.0)
        seconds += 1
    assert seconds >= 3
    truth.run(OVER_S)
    assert seen(rig) is None
    assert rig.controller.operating_state.stop is StopState.STOPPED
    assert line(rig).startswith("Emergency stop: ")

    told = [(at_s, event) for at_s, event in told if event.code.startswith("arm_")]
    codes = [event.code for _, event in told]
    assert codes == ["arm_sinks", *["arm_sinks_on"] * (len(codes) - 2), "arm_rests"]
    whole = told[-1][1].params
    assert abs(whole["down"] - truth.down_mm) <= 1.0
    assert abs(whole["seconds"] - seconds) <= 2
    times_s = [at_s for at_s, _ in told[:-1]]
    assert all(b - a >= FURTHER_S - STEP_S for a, b in pairwise(times_s))


def test_where_the_hand_rises_while_the_arm_gives_way_no_height_is_told():
    motion = UncommandedMotion(MotionKind.SINKS, Unheld.STOPPED, 3, 0, 2, 7.7, 5, "post")
    assert words.uncommanded_motion(motion) == (
        "The arm gives way, the tool no lower: J2 by 7.7° in 3 s, now at 5 mm/s. Below it: post. "
        "Hold it."
    )
    assert words.uncommanded_motion_short(motion) == "Moves, 5 mm/s"
    powered = replace(motion, cause=Unheld.NOT_TOLD)
    assert words.uncommanded_motion(powered).startswith("The arm moves, and nothing told it to: ")
    lower = replace(motion, down_mm=1)
    assert words.uncommanded_motion(lower).startswith("The arm sinks: 1 mm lower after 3 s")


def test_an_arm_stopped_on_its_way_is_told_from_the_stop_on(rig):
    bend(rig)
    accepted(rig.controller.motion.send_joints((10.0, 40.0, -60.0, 15.0, 40.0, 20.0)))
    rig.run(0.4)
    assert seen(rig) is None
    truth = Truth(rig)
    rig.controller.emergency_stop()
    while seen(rig) is None or seen(rig).kind is MotionKind.UNMEASURED:
        truth.step()
        assert rig.controller.operating_state.stop is not StopState.STOPPED or seen(rig)
    truth.run(1.0)
    check_figures(rig, truth)


def test_an_arm_that_lies_is_stopped_at_once(any_rig):
    rig = any_rig
    rig.connect()
    rig.run(1.0)
    rig.controller.emergency_stop()
    for _ in range(round(3.0 / STEP_S)):
        rig.step()
        assert seen(rig) is None
    assert rig.controller.operating_state.stop is StopState.STOPPED
    assert not [code for code in rig.codes() if code.startswith("arm_")]


def test_what_is_below_is_named(rig):
    bend(rig)
    put(rig.controller, TABLE)
    rig.controller.emergency_stop()
    rig.run(1.0)
    assert seen(rig).below == TABLE.name
    assert f"Below it: {TABLE.name}." in line(rig)
    put(rig.controller)
    rig.run(2.0)
    assert "Below it: table or floor." in line(rig)


def test_after_disabling_all_motors_the_drop_is_told(any_rig):
    rig = any_rig
    bend(rig)
    rig.run(1.0)
    truth = Truth(rig)
    accepted(rig.controller.motors.disable())
    truth.step()
    sank = False
    while not truth.stands:
        truth.run(BEGUN_S)
        if not truth.stands:
            check_figures_of_a_drop(rig, truth)
            assert line(rig).startswith("The arm sinks: ")
            sank = True
    assert sank
    truth.run(OVER_S)
    assert seen(rig) is None
    assert line(rig).startswith("The motors are off. ")
    assert abs(rig.events[-1].params["down"] - truth.down_mm) <= 1.0


def check_figures_of_a_drop(rig, truth):
    motion = seen(rig)
    assert motion.kind is MotionKind.SINKS
    all_off = not any(rig.controller.operating_state.enabled)
    assert motion.cause is (Unheld.MOTORS_OFF if all_off else Unheld.JOINTS_OFF)
    slack_mm = 1.5 + SHOWN_S * max(truth.speeds_mm_s())
    assert abs(motion.down_mm - truth.down_mm) <= slack_mm


def test_of_one_motor_only_what_its_joint_does_is_told(rig):
    bend(rig)
    rig.run(1.0)
    truth = Truth(rig)
    accepted(rig.controller.motors.disable(3))
    rig.run_until(lambda: rig.controller.operating_state.enabled[2] is False)
    truth.run(BEGUN_S)
    check_figures_of_a_drop(rig, truth)
    assert seen(rig).joint == 3
    assert rig.controller.recovery.step.kind is StepKind.MOTORS_MIXED
    (told,) = [event for event in rig.events if event.code.startswith("arm_")]
    assert words.event(told).startswith("No motor holds joint 3, ")
    assert "no motor holds J3" in words.uncommanded_motion(
        replace(seen(rig), kind=MotionKind.MOVES)
    )
    truth.run(5.0)
    assert seen(rig) is None
    assert rig.events[-1].code == "arm_rests"
    assert rig.events[-1].params["joint"] == 3


def test_a_motor_that_loses_its_power_is_told_like_one_that_was_disabled(rig):
    bend(rig)
    rig.run(1.0)
    truth = Truth(rig)
    rig.node.faults.start(fault("driver-error", 2))
    rig.run_until(lambda: rig.controller.operating_state.enabled[1] is False)
    truth.run(BEGUN_S)
    check_figures_of_a_drop(rig, truth)
    assert seen(rig).joint == 2
    assert rig.controller.recovery.step.kind is StepKind.DRIVER_FAULT
    assert line(rig).startswith("The arm sinks: ")


def test_it_comes_back_when_a_resume_lets_the_arm_drop(rig):
    bend(rig, LOW_DEG)
    rig.controller.emergency_stop()
    rig.run(1.0)
    truth = Truth(rig)
    accepted(rig.controller.motors.resume())
    truth.run(BEGUN_S)
    assert seen(rig).kind is MotionKind.SINKS
    assert seen(rig).speed_mm_s > 50
    truth.run(5.0)
    assert truth.stands
    assert seen(rig) is None


def test_enabled_in_its_fall_it_is_told_to_be_held(rig):
    bend(rig)
    accepted(rig.controller.motors.disable())
    rig.run_until(lambda: rig.controller.operating_state.busy is None)
    rig.run(0.1)
    assert seen(rig).kind is MotionKind.SINKS
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: all(rig.controller.operating_state.enabled))
    rig.run(OVER_S)
    assert seen(rig) is None
    assert rig.codes()[-1] in {"arm_rests", "arm_held_again"}


def test_a_powered_arm_that_nothing_told_to_move_is_told(rig):
    """The arm gets a target that is heard by nobody but it: as from its own firmware."""
    bend(rig)
    assert rig.controller.halt_and_hold() is None
    rig.run(1.0)
    tell(rig.firmware, *target(10.0, 100.0, -60.0, 15.0, 40.0, 20.0), mode(20))
    truth = Truth(rig)
    truth.run(1.0)
    motion = seen(rig)
    assert motion.cause is Unheld.NOT_TOLD
    assert motion.kind is MotionKind.SINKS
    assert motion.joint == 2
    assert line(rig).startswith("The arm sinks though its motors are on: ")
    truth.run(3.0)
    tell(rig.firmware, *target(10.0, 70.0, -60.0, 15.0, 40.0, 20.0), mode(20))
    truth.run(1.0)
    assert seen(rig).kind is MotionKind.MOVES
    assert line(rig).startswith("The arm moves, and nothing told it to: ")
    truth.run(10.0)
    assert seen(rig) is None
    assert {"arm_sinks_powered", "arm_moves_untold", "arm_rests"} <= set(rig.codes())
