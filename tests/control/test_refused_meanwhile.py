"""What is refused while something is under way: no frame gets to the arm, and a reason is told."""

import pytest

from armui.arm.parameters import Batch, Group
from armui.arm.refusal import Refusal
from armui.cell.cell import Cell
from armui.cell.tools import Tool
from armui.control.devices.gripper import RUN_LET_GO
from armui.control.devices.lights import RUN_SETS_LAMPS
from armui.control.operations.started import refusal_of
from armui.control.run.player import RUN_TOO_SLOW
from armui.control.run.progress import RunPhase
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.control.safety.standstill import JOINTS_MOVING
from armui.protocol.codes import Mounting, TeachingState, TrajectoryCommand
from armui.protocol.frame import Frame
from armui.trajectory.points.program import LightAction
from tests.accepted import accepted
from tests.control.under_way import (
    BACK,
    BESIDE_A_RUN,
    MOTIONS,
    OUT,
    PLANS,
    RUNS,
    SETTINGS,
    joint_jog,
    motion_paused,
    run_dwelling,
    run_moving,
    run_of,
    run_paused,
    to,
    tool_jog,
)
from tests.faulty_arm import HardOfHearing
from tests.sim.talk import frame, mode

ABORT = Frame(0x150, bytes.fromhex("00 06 00 00 00 00 00 00"))
STREAM = {0x155, 0x156, 0x157}
QUESTIONS = {0x472, 0x477}
DISABLE = 0x471


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    any_rig.ear = HardOfHearing(any_rig.firmware)
    return any_rig


def ids(rig):
    return {frame.arbitration_id for frame in rig.ear.heard}


def refused(rig, *tables):
    """The codes with which each command of some tables is refused; ``None`` where it is not."""
    codes = {}
    for table in tables:
        for name, command in table.items():
            told = rig.codes().count("refused")
            refusal = refusal_of(command(rig))
            codes[name] = refusal and refusal.code
            assert refusal is None or rig.codes().count("refused") == told + 1, name
    return codes


@pytest.mark.each_value(full="each phase in both generations")
@pytest.mark.parametrize("begin", RUNS.values(), ids=RUNS)
def test_a_run_in_any_phase_is_all_that_the_arm_hears(ready, begin):
    begin(ready)
    streams = begin.__name__ == "replay_moving"
    ready.ear.heard.clear()
    codes = refused(ready, SETTINGS, MOTIONS, PLANS, BESIDE_A_RUN)
    assert set(codes.values()) == {"run_under_way"}
    for command in TeachingState:
        if command is not TeachingState.OFF:
            assert isinstance(ready.controller.teaching.command(command), Refusal)
    ready.run(0.06)
    assert ids(ready) <= (STREAM if streams else set())
    assert ready.controller.player.running or ready.controller.replayer.running
    assert ready.controller.motion.speed_percent == 30


@pytest.mark.parametrize("begin", [joint_jog, tool_jog])
def test_what_a_held_jog_was_begun_with_stays(any_rig, begin):
    begin(any_rig)
    any_rig.ear = HardOfHearing(any_rig.firmware)
    assert set(refused(any_rig, SETTINGS, PLANS).values()) == {"jog_under_way"}
    any_rig.run(0.1)
    assert any_rig.controller.jogging.active
    assert ids(any_rig) <= STREAM | {0x151}


def test_the_speed_set_during_a_jog_reaches_the_arm_by_the_jog(any_rig):
    joint_jog(any_rig)
    any_rig.ear = HardOfHearing(any_rig.firmware)
    accepted(any_rig.controller.motion.set_speed_percent(50))
    any_rig.step()
    assert 0x151 not in ids(any_rig)
    any_rig.run(0.1)
    assert any_rig.controller.jogging.active
    assert any_rig.controller.motion.speed_percent == 50


def test_a_paused_motion_is_not_met_by_anything_new(ready):
    motion_paused(ready)
    ready.ear.heard.clear()
    codes = refused(ready, SETTINGS, MOTIONS)
    assert set(codes.values()) == {"plan_paused"}
    ready.run(0.1)
    assert ready.ear.heard == []
    accepted(ready.controller.planned_motion.command(TrajectoryCommand.CLEAR_ALL))
    accepted(ready.controller.motion.send_joints(BACK))


@pytest.mark.each_value(full="each phase in both generations")
@pytest.mark.parametrize("begin", RUNS.values(), ids=RUNS)
def test_reading_and_recording_are_fine_at_any_time(ready, begin):
    begin(ready)
    ready.ear.heard.clear()
    assert ready.controller.settings.read([Batch(Group.COLLISION)]) is None
    accepted(ready.controller.recorder.start())
    accepted(ready.controller.lights.set_light(1, 0, 1, 2, 3))
    ready.run(0.1)
    assert ready.controller.player.running or ready.controller.replayer.running
    assert ids(ready) <= STREAM | QUESTIONS | {0x121}


def test_lamps_that_a_run_speaks_by_are_left_to_it(ready):
    point = to(OUT, light=LightAction(2, 255, 0, 0), dwell_s=60.0)
    ready.controller.player.start(run_of(point))
    assert ready.controller.lights.set_light(1, 0, 1, 2, 3).reason == RUN_SETS_LAMPS
    ready.controller.player.stop()
    ready.run_until(lambda: not ready.controller.player.running)
    accepted(ready.controller.lights.set_light(1, 0, 1, 2, 3))


@pytest.mark.parametrize("name", ["limit", "load", "clear error", "linkage"])
def test_nothing_moves_while_something_is_being_set(ready, name):
    ready.ear.mute_on = {0x476}
    ready.controller.settings.read([Batch(Group.JOINT_LIMITS, 2)])
    ready.run_until(lambda: not ready.controller.settings.busy)
    accepted(SETTINGS[name](ready))
    ready.ear.heard.clear()
    codes = refused(ready, MOTIONS, {"run": SETTINGS["run"], "replay": SETTINGS["replay"]})
    assert set(codes.values()) <= {"busy", "control_offset_unknown"}
    ready.step()
    assert ids(ready) <= {0x470, 0x474, 0x475, 0x477}


def test_settings_wait_until_no_joint_turns(ready):
    ready.controller.motion.send_joints(OUT)
    ready.run_until(lambda: ready.controller.operating_state.moving)
    ready.run(0.2)
    ready.ear.heard.clear()
    assert SETTINGS["factory end limits"](ready).reason == JOINTS_MOVING
    ready.step()
    assert ready.ear.heard == []
    ready.run_until(lambda: not ready.controller.operating_state.moving)
    ready.run(0.2)
    accepted(SETTINGS["factory end limits"](ready))


def test_no_zero_in_the_middle_of_a_recording(ready):
    ready.controller.recorder.start()
    refusal = ready.controller.zeroing.set_zero(1)
    assert (refusal.code, refusal.params["what"]) == ("busy", "recording")


@pytest.mark.each_value(full="each joint in each phase, in both generations")
@pytest.mark.parametrize("begin", [run_moving, run_paused, run_dwelling])
@pytest.mark.parametrize("joint", [3, 7])
def test_motors_can_always_be_disabled_and_the_run_says_so(ready, begin, joint):
    begin(ready)
    ready.ear.heard.clear()
    accepted(ready.controller.motors.disable(joint))
    ready.step()
    assert [ready.ear.heard[0], ready.ear.heard[1].arbitration_id] == [ABORT, DISABLE]
    progress = ready.controller.player.progress
    assert (progress.phase, progress.refusal.code) == (RunPhase.FAILED, "run_disabled")
    ready.run(0.5)  # it brakes
    here = ready.firmware.joints_deg[0]
    ready.run(1.0)
    assert ready.firmware.joints_deg[0] == pytest.approx(here, abs=0.01)


def test_the_gripper_can_always_let_go_and_the_run_says_so(ready):
    run_dwelling(ready)
    ready.ear.heard.clear()
    accepted(ready.controller.gripper.disable())
    ready.step()
    assert [frame.arbitration_id for frame in ready.ear.heard][:2] == [0x150, 0x159]
    assert ready.controller.player.progress.refusal.reason == RUN_LET_GO


@pytest.mark.each_value(full="each phase of each run in both generations")
@pytest.mark.parametrize("begin", RUNS.values(), ids=RUNS)
@pytest.mark.parametrize("plan", [TrajectoryCommand.ABORT, TrajectoryCommand.CLEAR_ALL])
def test_what_ends_motions_ends_a_run_too(ready, begin, plan):
    begin(ready)
    accepted(ready.controller.planned_motion.command(plan))
    running = (ready.controller.player, ready.controller.replayer)
    ready.run_until(lambda: not any(each.running for each in running))
    assert RunPhase.STOPPED in {each.progress.phase for each in running}
    here = tuple(ready.firmware.joints_deg)
    ready.run(1.0)
    assert tuple(ready.firmware.joints_deg) == here


@pytest.mark.each_value(full="each phase in both generations")
@pytest.mark.parametrize("begin", RUNS.values(), ids=RUNS)
def test_the_emergency_stop_works_in_every_phase(ready, begin):
    begin(ready)
    ready.controller.emergency_stop()
    ready.run_until(lambda: "stop_confirmed" in ready.codes())
    assert not ready.controller.player.running
    assert not ready.controller.replayer.running
    ready.run(0.3)
    ready.ear.heard.clear()
    ready.run(1.0)
    assert ready.ear.heard == []


@pytest.mark.each_value(full="each way to leave in each phase, in both generations")
@pytest.mark.parametrize("begin", RUNS.values(), ids=RUNS)
@pytest.mark.parametrize("leave", ["disconnect_device", "shutdown"])
def test_an_arm_that_is_left_does_not_go_on(ready, begin, leave):
    begin(ready)
    ready.ear.heard.clear()
    getattr(ready.controller, leave)()
    told = [event for event in ready.events if "failed" in event.code]
    assert [event.params["reason"].code for event in told] == ["run_left"]
    ready.node.poll(0.02)
    heard = ready.ear.heard
    assert ABORT in heard
    behind = {frame.arbitration_id for frame in heard[heard.index(ABORT) :]}
    assert behind <= {0x150, 0x151}  # told again until it rests; the operator's speed is given back
    for _ in range(50):
        ready.node.poll(0.02)
    here = tuple(ready.firmware.joints_deg)
    for _ in range(50):
        ready.node.poll(0.02)
    assert tuple(ready.firmware.joints_deg) == here


def test_a_motion_paused_from_here_is_dropped_when_the_arm_is_left(ready):
    motion_paused(ready)
    ready.ear.heard.clear()
    ready.controller.disconnect_device()
    ready.node.poll(0.02)
    assert ready.ear.heard == [ABORT]


def test_an_arm_held_up_does_not_set_out_for_the_point_of_a_run_that_is_over(ready):
    # a speed of 0 % stands for whatever holds the arm up
    ready.controller.player.start(run_of(to(OUT)))
    ready.run(0.2)
    ready.firmware.on_frame(frame(mode(0)))
    ready.run_until(lambda: not ready.controller.player.running, seconds=60.0)
    assert ready.controller.player.progress.refusal.reason == RUN_TOO_SLOW
    here = tuple(ready.firmware.joints_deg)
    ready.firmware.on_frame(frame(mode(100)))
    ready.run(2.0)
    assert tuple(ready.firmware.joints_deg) == here


def test_a_motion_that_was_ended_does_not_count_as_moving_for_good(ready):
    run_moving(ready)
    ready.controller.player.stop()
    assert ready.controller.operating_state.moving
    ready.run_until(lambda: not ready.controller.player.running)
    ready.run(0.5)
    assert not ready.controller.state.status.value.reached
    assert not ready.controller.operating_state.moving


def test_a_tool_step_after_another_motion_begins_where_the_arm_is(ready):
    authority = ready.controller._authority
    ready.controller.motion.send_joints(OUT)
    ready.run_until(lambda: ready.controller.operating_state.moving)
    ready.run_until(lambda: not ready.controller.operating_state.moving)
    accepted(MOTIONS["tool step"](ready))
    assert authority.tool_base() is not None
    ready.controller.motion.send_joints(BACK)
    assert authority.tool_base() is None


# Identifiers that are not certain -----------------------------------------------------------------


@pytest.fixture
def uncertain(ready):
    """The arm may listen elsewhere, and another one here (0x470)."""
    ready.controller._connection.offsets.control_known = False
    ready.step()
    assert not ready.controller.operating_state.control_certain
    ready.ear.heard.clear()
    return ready


def test_nothing_that_moves_or_hands_over_is_sent_to_an_arm_nobody_knows(uncertain):
    codes = refused(uncertain, MOTIONS, PLANS)
    drag = uncertain.controller.teaching.command(TeachingState.START_RECORDING)
    assert {*codes.values(), drag.code} == {"control_offset_unknown"}
    accepted(uncertain.controller.motion.set_speed_percent(5))
    uncertain.run(0.1)
    assert uncertain.ear.heard == []


def test_an_arm_is_not_made_to_drop_on_identifiers_nobody_knows(uncertain):
    uncertain.controller.emergency_stop()
    uncertain.run_until(lambda: "stop_confirmed" in uncertain.codes())
    assert ids(uncertain) == {0x150, 0x160, 0x170}
    uncertain.ear.heard.clear()
    assert uncertain.controller.motors.resume().reason == CONTROL_OFFSET_UNKNOWN
    step = uncertain.controller.recovery.step
    assert uncertain.controller.recovery.act(step).reason == CONTROL_OFFSET_UNKNOWN
    uncertain.run(0.1)
    assert uncertain.ear.heard == []


@pytest.mark.parametrize("waits_s", [0.0, 0.3])
def test_what_a_motion_was_checked_against_is_kept_from_its_press_on(ready, waits_s):
    """It is not measured to move yet, and may wait for the adapter."""
    kept = {name: SETTINGS[name] for name in ("zero one", "zero all", "limit", "collision", "load")}
    kept |= {name: SETTINGS[name] for name in ("factory joint limits", "linkage", "no linkage")}
    kept["mounting"] = lambda rig: rig.controller.mounting.tell(Mounting.LEVEL)
    kept["cell"] = lambda rig: rig.controller.cell.take(Cell("bench", (Tool("pen"),), "pen"))
    ready.controller.motion.set_speed_percent(1)
    ready.run(0.5)
    if waits_s:
        ready.hold_driver()
    accepted(ready.controller.motion.send_joints(OUT))
    ready.ear.heard.clear()
    ready.run(waits_s)
    assert None not in refused(ready, kept).values()
    ready.free_driver()
    ready.run(0.02)
    assert ids(ready) == {0x151, 0x155, 0x156, 0x157}
