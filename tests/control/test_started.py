"""Every operation that is begun comes to an end that is told: answered, in vain, or cut off."""

from __future__ import annotations

from typing import Any

import pytest

from armui.arm.parameters import Parameter
from armui.control.motion.jog_path import JointJog
from armui.control.operations.started import Ending, Started
from armui.control.run.progress import RunPhase
from armui.control.run.replay import Replay
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import EndLoad, Mounting, MoveMode, TeachingState, TrajectoryCommand
from tests.control.jogger import bend
from tests.control.test_replayer import wave
from tests.control.under_way import BACK, OUT, POSE, replay_paused, run_of, run_paused, to

SENT, ANSWERED, DONE = Ending.SENT, Ending.ANSWERED, Ending.DONE
REFUSED, FAILED, CUT_OFF = Ending.REFUSED, Ending.FAILED, Ending.CUT_OFF


def here(rig):
    return tuple(rig.controller.cartesian.tool_pose(rig.controller.state))


def arc(rig):
    x, y, z, *turned = here(rig)
    return (x, y, z, *turned), (x + 10, y + 20, z, *turned), (x, y + 40, z, *turned)


def stopped(rig):
    rig.controller.emergency_stop()
    rig.run(1.0)


def motion_under_way(rig):
    assert rig.controller.motion.send_joints(BACK) is None
    rig.run(0.2)


BEFORE: dict[str, Any] = {
    "motors.resume": stopped,
    "run.pause": lambda rig: rig.controller.player.start(run_of(to(OUT), to(BACK))),
    "run.go_on": run_paused,
    "replay.go_on": replay_paused,
    "replay.pause": lambda rig: (
        rig.controller.replayer.start(Replay(wave())),
        rig.run_until(lambda: rig.controller.replayer.progress.done > 0.2),
    ),
    "planned.command": motion_under_way,
}
"""What is under way, so that the operation may begin."""

BEGIN: dict[str, tuple[Any, Ending]] = {
    "lamps.set": (lambda c, _rig: c.lights.set_light(1, 2, 3, 4, 5), SENT),
    "joints.set_zero": (lambda c, _rig: c.zeroing.set_zero(1), DONE),
    "joints.clear_error": (lambda c, _rig: c.joint_errors.clear(2), ANSWERED),
    "gripper.move": (lambda c, _rig: c.gripper.move(10.0, 1.0), DONE),
    "gripper.enable": (lambda c, _rig: c.gripper.enable(1.0), DONE),
    "gripper.disable": (lambda c, _rig: c.gripper.disable(), DONE),
    "gripper.clear_error": (lambda c, _rig: c.gripper.clear_error(), DONE),
    "gripper.set_zero": (lambda c, _rig: c.gripper.set_zero(), DONE),
    "motors.enable": (lambda c, _rig: c.motors.enable(), DONE),
    "motors.disable": (lambda c, _rig: c.motors.disable(), DONE),
    "motors.resume": (lambda c, _rig: c.motors.resume(), DONE),
    "motion.set_speed": (lambda c, _rig: c.motion.set_speed_percent(40), SENT),
    "motion.step": (lambda c, _rig: c.motion.jog(1, 5.0), DONE),
    "motion.send": (lambda c, _rig: c.motion.send_joints(BACK), DONE),
    "motion.home": (lambda c, _rig: c.motion.go_home(), DONE),
    "tool.move": (lambda c, _rig: c.cartesian.move(POSE, MoveMode.MOVE_P), DONE),
    "tool.step": (lambda c, _rig: c.cartesian.step(0, 5.0, JogFrame.BASE), DONE),
    "tool.arc": (lambda c, rig: c.cartesian.move_arc(*arc(rig)), DONE),
    "jog.begin": (lambda c, _rig: c.jogging.start(JointJog(1, 1)), DONE),
    "planned.command": (lambda c, _rig: c.planned_motion.command(TrajectoryCommand.PAUSE), SENT),
    "run.start": (lambda c, _rig: c.player.start(run_of(to(OUT), to(BACK))), DONE),
    "run.pause": (lambda c, _rig: c.player.pause(), SENT),
    "run.go_on": (lambda c, _rig: c.player.go_on(), SENT),
    "run.override": (lambda c, _rig: c.speed_override.set_percent(50), SENT),
    "replay.start": (lambda c, _rig: c.replayer.start(Replay(wave())), DONE),
    "replay.pause": (lambda c, _rig: c.replayer.pause(), SENT),
    "replay.go_on": (lambda c, _rig: c.replayer.go_on(), SENT),
    "recorder.start": (lambda c, _rig: c.recorder.start(), DONE),
    "teaching.command": (lambda c, _rig: c.teaching.command(TeachingState.START_RECORDING), DONE),
    "mounting.tell": (lambda c, _rig: c.mounting.tell(Mounting.LEVEL), SENT),
    "end_load.set": (lambda c, _rig: c.end_reports.set_load(EndLoad.FULL), ANSWERED),
    "end_load.report": (lambda c, _rig: c.end_reports.switch(on=True), DONE),
    "linkage.set": (lambda c, _rig: c.linkage.release(), ANSWERED),
    "settings.save": (
        lambda c, _rig: c.settings.save({Parameter("max_angle_deg", 2): 100.0}),
        DONE,
    ),
    "settings.reset_end_limits": (lambda c, _rig: c.settings.reset_end_limits(), ANSWERED),
    "settings.reset_joint_limits": (lambda c, _rig: c.settings.reset_joint_limits(), ANSWERED),
}
"""How each begins, and how it ends where nothing comes in between."""

GOES_ON = {"jog.begin", "recorder.start"}
"""What goes on until the operator ends it."""
SHOWN = {
    *("recorder.start", "motors.enable"),
    *("gripper.disable", "gripper.clear_error", "gripper.set_zero"),
}
"""What the feedback shows of an arm that has heard nothing, for it was so before."""
FOLLOWED = [name for name, (_begin, ending) in BEGIN.items() if ending is not SENT]


def begun(rig, name) -> Started:
    """The operation has begun, in an arm that is ready for it."""
    bend(rig)
    BEFORE.get(name, lambda _rig: None)(rig)
    since = len(rig.events)
    assert BEGIN[name][0](rig.controller, rig) is None
    (started,) = [each.started for each in rig.events[since:] if each.started is not None]
    assert started.operation == name
    return started


def let_go(rig, name):
    """The operator ends what goes on until then."""
    rig.run(0.5)
    if name == "jog.begin":
        rig.controller.jogging.stop()
    elif name == "recorder.start":
        rig.controller.recorder.finish("a")


def test_every_operation_is_among_them(rig):
    # what parameters hold is a question; its answer stands in the parameter
    assert set(rig.controller.operations) - set(BEGIN) == {"settings.read"}


@pytest.mark.parametrize("name", BEGIN)
def test_what_nothing_comes_between_ends_by_itself(rig, name):
    started = begun(rig, name)
    if name in GOES_ON:
        assert started.ending is None
        let_go(rig, name)
    rig.run_until(lambda: started.ending is not None)
    assert started.ending is BEGIN[name][1]


@pytest.mark.parametrize("name", FOLLOWED)
def test_a_lost_connection_ends_it(rig, name):
    started = begun(rig, name)
    was = started.ending
    rig.controller.disconnect_device()
    assert started.ending is (was or (DONE if name == "recorder.start" else CUT_OFF))


@pytest.mark.parametrize("name", FOLLOWED)
def test_a_stop_ends_what_moves_and_lets_the_rest_come_to_its_end(rig, name):
    started = begun(rig, name)
    rig.run(0.05)
    was = started.ending  # the arm may have said so by now
    rig.controller.emergency_stop()
    let_go(rig, name)
    rig.run_until(lambda: started.ending is not None)
    if rig.controller.operations[name].operation.moves:
        assert started.ending is (was or CUT_OFF)


@pytest.mark.parametrize("name", FOLLOWED)
def test_another_command_leaves_nothing_open(rig, name):
    started = begun(rig, name)
    rig.run(0.05)
    rig.controller.motors.disable()
    let_go(rig, name)
    rig.run_until(lambda: started.ending is not None)


@pytest.mark.parametrize("name", FOLLOWED)
def test_an_arm_that_obeys_no_more_leaves_nothing_open(rig, name):
    bend(rig)
    BEFORE.get(name, lambda _rig: None)(rig)
    deafen(rig)
    since = len(rig.events)
    assert BEGIN[name][0](rig.controller, rig) is None
    started = next(each.started for each in rig.events[since:] if each.started is not None)
    let_go(rig, name)
    rig.run_until(lambda: started.ending is not None)
    assert started.ending in {FAILED, CUT_OFF, REFUSED} or name in SHOWN


def deafen(rig):
    """Nothing that is sent reaches the arm; what it says is heard."""
    rig.firmware.on_frame = lambda _frame: []


def test_a_record_is_closed_once():
    started = Started("a.b")
    started.close(DONE)
    started.close(FAILED)
    assert started.ending is DONE
    assert Started("a.b").number > started.number


def test_a_run_is_followed_apart_from_its_points(rig):
    started = begun(rig, "run.start")
    point = rig.controller._authority.command.started
    assert (point.operation, point is started) == ("run.start", False)
    rig.run_until(lambda: rig.controller.player.phase is RunPhase.DONE)
    assert (point.ending, started.ending) == (DONE, DONE)
