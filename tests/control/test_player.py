"""Trajectories run on the simulated arm: the path it really took, its dwells, its ends."""

from dataclasses import replace

import can
import pytest

from armui.arm.limits import JOINT_OUT_OF_LIMITS
from armui.control.link.link_state import LINK_LOST, OFFLINE
from armui.control.motion.abort import RUN_STOPPED
from armui.control.motion.point_frames import GRIPPER_OTHER_GENERATION
from armui.control.operating_state import RUN_UNDER_WAY
from armui.control.run.arrival import RUN_ELSEWHERE
from armui.control.run.player import NOT_PAUSED, NOT_RUNNING, RUN_TOO_SLOW
from armui.control.run.progress import ENDLESS, Run, RunPhase
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.interlocks import ARM_FAULT, NOT_ENABLED
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.sim.faults import schedule as faults
from armui.trajectory.points.program import GripperAngle, GripperOpening, LightAction, Waypoint
from tests.accepted import accepted
from tests.family import PIPER
from tests.faulty_arm import HardOfHearing

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
UP = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)


def to(joints_deg, **more):
    return Waypoint(MoveMode.MOVE_J, joints_deg, speed_percent=100, **more)


def run_of(*points, **more):
    return Run("test", points, [2.0 + point.dwell_s for point in points], **more)


class Journey:
    """Where the simulated arm really was, at each step."""

    def __init__(self, rig):
        self.rig = rig
        self.path = []

    def until(self, condition, seconds=30.0):
        def look():
            self.path.append((self.rig.time_s, tuple(self.rig.firmware.joints_deg)))
            return condition()

        self.rig.run_until(look, seconds)

    def times_at(self, joints_deg, tolerance_deg=0.1):
        return [time_s for time_s, here in self.path if _near(here, joints_deg, tolerance_deg)]


def _near(here, there, tolerance_deg=0.1):
    return all(abs(a - b) <= tolerance_deg for a, b in zip(here, there, strict=True))


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    return any_rig


def phase(rig):
    return rig.controller.player.progress.phase


def over(rig):
    return lambda: not rig.controller.player.running


def test_every_point_is_passed_in_order(ready):
    journey = Journey(ready)
    accepted(ready.controller.player.start(run_of(to(OUT), to(BACK), to(UP))))
    journey.until(over(ready))
    assert phase(ready) is RunPhase.DONE
    first, second, third = (journey.times_at(each)[0] for each in (OUT, BACK, UP))
    assert first < second < third
    assert ready.codes()[-1] == "run_done"
    progress = ready.controller.player.progress
    assert (progress.done, progress.remaining_s, progress.index) == (1.0, 0.0, 2)


def test_the_arm_stays_as_long_as_it_shall(ready):
    journey = Journey(ready)
    ready.controller.player.start(run_of(to(OUT, dwell_s=1.5), to(BACK)))
    journey.until(over(ready))
    times = journey.times_at(OUT, tolerance_deg=0.01)
    assert 1.5 <= times[-1] - times[0] <= 1.8


def test_laps_are_counted(ready):
    journey = Journey(ready)
    ready.controller.player.start(run_of(to(OUT), to(BACK), cycles=3))
    journey.until(over(ready), seconds=60.0)
    assert phase(ready) is RunPhase.DONE
    visits = 0
    was_there = False
    for _, here in journey.path:
        there = _near(here, OUT)
        visits += there and not was_there
        was_there = there
    assert visits == 3
    assert ready.controller.player.progress.cycle == 3


def test_an_endless_run_ends_when_the_operator_says_so(ready):
    player = ready.controller.player
    player.start(run_of(to(OUT), to(UP), cycles=ENDLESS))
    ready.run_until(lambda: player.progress.cycle == 3)
    assert player.progress.remaining_s is None
    player.stop()
    ready.run_until(over(ready))
    assert phase(ready) is RunPhase.STOPPED
    at = tuple(ready.firmware.joints_deg)
    ready.run(1.0)
    assert tuple(ready.firmware.joints_deg) == at
    assert ready.controller.operating_state.cannot_move is None


def test_a_pause_holds_the_arm_and_the_rest_follows(ready):
    player = ready.controller.player
    player.start(run_of(to(OUT), to(BACK)))
    ready.run(0.4)
    accepted(player.pause())
    ready.run(1.0)
    at = tuple(ready.firmware.joints_deg)
    remaining_s = player.progress.remaining_s
    ready.run(8.0)
    assert tuple(ready.firmware.joints_deg) == at
    assert phase(ready) is RunPhase.PAUSED
    assert player.progress.remaining_s == remaining_s
    accepted(player.go_on())
    ready.run_until(over(ready))
    assert phase(ready) is RunPhase.DONE
    assert _near(ready.firmware.joints_deg, BACK)


def test_a_run_that_is_stopped_in_a_pause_has_come_no_further(ready):
    player = ready.controller.player
    player.start(run_of(to(OUT)))
    ready.run(0.4)
    accepted(player.pause())
    ready.run(1.0)
    done = player.progress.done
    ready.run(30.0)
    ready.controller.emergency_stop()
    ready.run(1.0)
    assert phase(ready) is RunPhase.FAILED
    assert 0.0 < done < 0.9
    assert player.progress.done == pytest.approx(done, abs=0.01)


def test_a_pause_in_a_dwell_holds_its_clock(ready):
    player = ready.controller.player
    player.start(run_of(to(OUT, dwell_s=2.0), to(BACK)))
    ready.run_until(lambda: phase(ready) is RunPhase.DWELLING)
    ready.run(1.0)
    player.pause()
    ready.run(4.0)
    player.go_on()
    ready.run(0.8)
    assert _near(ready.firmware.joints_deg, OUT)
    ready.run_until(over(ready))
    assert _near(ready.firmware.joints_deg, BACK)


def test_step_by_step_waits_for_the_operator(ready):
    player = ready.controller.player
    player.start(run_of(to(OUT), to(BACK), step_by_step=True))
    ready.run_until(lambda: phase(ready) is RunPhase.WAITING)
    ready.run(2.0)
    assert _near(ready.firmware.joints_deg, OUT)
    assert player.go_on() is None  # a step is no command of its own
    ready.run_until(over(ready))
    assert _near(ready.firmware.joints_deg, BACK)


def test_a_run_may_begin_further_on(ready):
    journey = Journey(ready)
    ready.controller.player.start(run_of(to(OUT), to(BACK), first=1))
    journey.until(over(ready))
    assert journey.times_at(OUT) == []
    assert _near(ready.firmware.joints_deg, BACK)


def test_the_speed_of_a_point_is_slowed_by_the_operators(ready):
    ear = HardOfHearing(ready.firmware)
    point = replace(to(OUT), speed_percent=40)
    ready.controller.player.start(run_of(point, speed_percent=50))
    ready.run_until(over(ready))
    assert {frame.data[2] for frame in ear.heard if frame.arbitration_id == 0x151} == {20}


def test_lines_and_arcs_are_run(ready):
    flange = Kinematics(PIPER)
    start, middle, end = (
        tuple(flange.forward(joints))
        for joints in (
            OUT,
            (10.0, 45.0, -45.0, 5.0, 20.0, 5.0),
            (-5.0, 40.0, -40.0, 5.0, 20.0, 0.0),
        )
    )
    points = (
        to(OUT),
        Waypoint(MoveMode.MOVE_L, middle, speed_percent=100),
        Waypoint(MoveMode.MOVE_P, start, speed_percent=100),
        Waypoint(MoveMode.MOVE_C, end, middle=middle, speed_percent=100),
    )
    ready.controller.player.start(run_of(*points))
    ready.run_until(over(ready), seconds=60.0)
    assert ready.controller.player.progress.refusal is None
    assert ready.controller.state.end_pose() == pytest.approx(end, abs=0.1)


def test_gripper_and_lamps_act_on_arrival(ready):
    generation = ready.controller.operating_state.generation
    gripper = GripperOpening(30.0) if generation is Generation.TWO else GripperAngle(10.0)
    other = GripperAngle(10.0) if generation is Generation.TWO else GripperOpening(30.0)
    player = ready.controller.player
    refusal = player.start(run_of(to(OUT, gripper=other)))
    assert refusal.reason == GRIPPER_OTHER_GENERATION
    player.start(run_of(to(OUT, gripper=gripper, light=LightAction(2, 255, 0, 0), dwell_s=3.0)))
    ready.run_until(over(ready))
    assert ready.firmware.settings.lights[2][:4] == (255, 255, 0, 0)
    heard = ready.controller.state.gripper.value
    assert (heard.opening_mm, heard.angle_deg) in {(30.0, None), (None, 10.0)}


def test_a_point_beyond_the_limits_ends_the_run_and_is_not_sent(ready):
    beyond = (170.0, *OUT[1:])
    ready.controller.player.start(run_of(to(OUT), to(beyond)))
    ready.run_until(over(ready))
    progress = ready.controller.player.progress
    assert (progress.phase, progress.index) == (RunPhase.FAILED, 1)
    assert progress.refusal.reason == JOINT_OUT_OF_LIMITS
    assert _near(ready.firmware.joints_deg, OUT)


def test_an_emergency_stop_ends_the_run(ready):
    ready.controller.player.start(run_of(to(OUT), to(BACK)))
    ready.run(0.4)
    ready.controller.emergency_stop()
    assert phase(ready) is RunPhase.FAILED
    assert ready.controller.player.progress.refusal.reason == RUN_STOPPED
    ready.run(1.0)
    assert not ready.controller.player.running


def test_a_lost_cable_ends_the_run(ready, qtbot):
    ready.controller.player.start(run_of(to(OUT), to(BACK)))
    ready.run(0.4)
    ready.unplug(can.CanOperationError("gone"))
    qtbot.waitUntil(lambda: "link_lost" in ready.codes())
    assert ready.controller.player.progress.refusal.reason == LINK_LOST


def test_a_silent_arm_ends_the_run(ready):
    ready.controller.player.start(run_of(to(OUT), to(BACK)))
    ready.run(0.4)
    ready.powered = False
    ready.run_until(over(ready))
    assert ready.controller.player.progress.refusal.reason == OFFLINE


def test_a_collision_ends_the_run(ready):
    ready.controller.player.start(run_of(to(OUT), to(BACK)))
    ready.run(0.4)
    ready.node.faults.start(faults.read_fault("collision:2@0"))
    ready.run_until(over(ready))
    progress = ready.controller.player.progress
    assert progress.phase is RunPhase.FAILED
    assert progress.refusal.reason in {ARM_FAULT, NOT_ENABLED}


def test_a_blocked_arm_does_not_run_for_ever(ready):
    ear = HardOfHearing(ready.firmware)
    ear.deaf_to = {0x156}  # a whole target never comes
    ready.controller.player.start(run_of(to(OUT)))
    ready.run_until(over(ready), seconds=60.0)
    assert ready.controller.player.progress.refusal.reason in {
        RUN_ELSEWHERE,
        RUN_TOO_SLOW,
    }


def test_nothing_else_moves_the_arm_meanwhile(ready):
    ready.controller.player.start(run_of(to(OUT)))
    ready.step()
    refusal = ready.controller.motion.jog(1, 5.0)
    assert refusal.reason == RUN_UNDER_WAY
    assert ready.controller.player.start(run_of(to(BACK))).reason == RUN_UNDER_WAY
    ready.run_until(over(ready))
    assert _near(ready.firmware.joints_deg, OUT)


def test_an_arm_that_is_not_enabled_is_not_run(any_rig):
    any_rig.connect()
    assert any_rig.controller.player.start(run_of(to(OUT))).reason == NOT_ENABLED
    assert any_rig.controller.player.start(run_of()).reason == NOT_ENABLED


@pytest.mark.parametrize(
    ("run", "code"),
    [(run_of(), "run_empty"), (run_of(to(OUT), first=1), "run_no_such_row")],
)
def test_a_run_of_nothing_is_refused(ready, run, code):
    assert ready.controller.player.start(run).code == code


def test_words_out_of_place(ready):
    player = ready.controller.player
    assert player.pause().reason == NOT_RUNNING
    assert player.go_on().reason == NOT_PAUSED
    player.stop()
    assert phase(ready) is RunPhase.IDLE


@pytest.mark.parametrize(("late_s", "ends"), [(0.3, RunPhase.DONE), (5.0, RunPhase.FAILED)])
def test_angles_that_come_late_put_a_point_off_and_do_not_end_the_run(
    rig, monkeypatch, late_s, ends
):
    rig.ready()
    player, authority = rig.controller.player, rig.controller._authority
    measured_deg, late = authority.measured_deg, FEEDBACK_SILENT(frames="0x2A5", seconds=0.05)
    since_s = []

    def comes_late():
        if player._index == 0:
            return measured_deg()
        since_s.append(rig.time_s)
        return None if rig.time_s - since_s[0] < late_s else measured_deg()

    monkeypatch.setattr(authority, "measured_deg", comes_late)
    monkeypatch.setattr(authority, "why_unmeasured", lambda: late)
    accepted(player.start(run_of(to(OUT), to(BACK))))
    rig.run_until(lambda: player.progress.phase in {RunPhase.DONE, RunPhase.FAILED})
    assert player.progress.phase is ends
    assert since_s
    assert player.progress.refusal == (late if ends is RunPhase.FAILED else None)
