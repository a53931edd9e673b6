"""Every operation that is begun comes to an end that is told: answered, in vain, or cut off."""

from __future__ import annotations

from typing import Any

import pytest

from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.tools import Tool
from armui.control.motion.jog_path import JointJog
from armui.control.operations.started import Ending, Started
from armui.control.run.progress import RunPhase
from armui.control.run.replay import Replay
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import (
    EndLoad,
    LinkageRole,
    Mounting,
    MoveMode,
    TeachingState,
    TrajectoryCommand,
)
from tests.accepted import accepted
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
    accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.2)


def in_doubt(rig):
    rig.run(1.5)
    rig.firmware.lost_reference.begin(4)
    rig.run_until(lambda: rig.controller.operating_state.reference.doubtful)
    rig.run(2.0)


def checking(rig, *, answered=False):
    reference = rig.controller.reference
    accepted(reference.begin())
    reference.note_elsewhere(())
    for joint in range(1, 7) if answered else ():
        reference.answer(joint, 0.0)


def cell_unconfirmed(rig):
    tool = Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0))
    accepted(rig.controller.cell.take(Cell("bench", (tool,), "pen")))
    rig.controller.cell.forget_arm()


def outside_limits(rig):
    """The first joint is found beyond its limit."""
    limit = rig.controller.state.angles_deg()[0] - 5.0
    accepted(rig.controller.settings.save({Parameter("max_angle_deg", 1): round(limit, 1)}))
    rig.run_until(lambda: rig.controller.operating_state.outside != "")


def log_begun(rig):
    rig.controller.episodes.begin_log([].append, 0.0)


def episode_begun(rig):
    log_begun(rig)
    accepted(rig.controller.episodes.begin())


BEFORE: dict[str, Any] = {
    "motion.come_inside": outside_limits,
    "motors.resume": stopped,
    "run.pause": lambda rig: rig.controller.player.start(run_of(to(OUT), to(BACK))),
    "run.go_on": run_paused,
    "replay.go_on": replay_paused,
    "replay.pause": lambda rig: (
        rig.controller.replayer.start(Replay(wave())),
        rig.run_until(lambda: rig.controller.replayer.progress.done > 0.2),
    ),
    "inspection.start": lambda rig: (
        rig.controller.inspection.set_amplitude(10.0),
        rig.run_until(lambda: rig.controller.inspection.plan is not None),
    ),
    "planned.command": motion_under_way,
    "reference.allow": in_doubt,
    "reference.drive": checking,
    "reference.finish": lambda rig: checking(rig, answered=True),
    "episode.begin": log_begun,
    **dict.fromkeys(("episode.end", "episode.discard"), episode_begun),
    **dict.fromkeys(
        ("cell.choose", "cell.change", "cell.delete", "cell.rename"),
        lambda rig: accepted(rig.controller.cell.take(Cell("bench"))),
    ),
    "cell.confirm": cell_unconfirmed,
    "cell.hold": lambda rig: accepted(
        rig.controller.cell.take(Cell("bench", held_objects=(HeldObject("cube"),)))
    ),
}
"""What is under way, so that the operation may begin."""

NONE: tuple[()] = ()
BEGIN: dict[str, tuple[Any, Ending]] = {
    "lamps.set": ((1, 2, 3, 4, 5), SENT),
    "joints.set_zero": ((1,), DONE),
    "joints.clear_error": ((2,), ANSWERED),
    "gripper.move": ((10.0, 1.0), DONE),
    "gripper.enable": ((1.0,), DONE),
    **dict.fromkeys(("gripper.disable", "gripper.clear_error", "gripper.set_zero"), (NONE, DONE)),
    **dict.fromkeys(("motors.enable", "motors.disable", "motors.resume"), (NONE, DONE)),
    "motion.set_speed": ((40,), SENT),
    "motion.step": ((1, 5.0), DONE),
    "motion.send": ((BACK,), DONE),
    "motion.home": (NONE, DONE),
    "motion.come_inside": (NONE, DONE),
    "tool.move": ((POSE, MoveMode.MOVE_P), DONE),
    "tool.step": ((0, 5.0, JogFrame.BASE), DONE),
    "tool.arc": (arc, DONE),
    "jog.begin": ((JointJog(1, 1),), DONE),
    "planned.command": ((TrajectoryCommand.PAUSE,), SENT),
    "run.start": (lambda _rig: (run_of(to(OUT), to(BACK)),), DONE),
    **dict.fromkeys(("run.pause", "run.go_on", "replay.pause", "replay.go_on"), (NONE, SENT)),
    "replay.start": (lambda _rig: (Replay(wave()),), DONE),
    "inspection.start": ((10.0,), DONE),
    "recorder.start": (NONE, DONE),
    "episode.begin": (("stack the cubes",), DONE),
    **dict.fromkeys(("episode.end", "episode.discard"), (NONE, DONE)),
    "teaching.command": ((TeachingState.START_RECORDING,), DONE),
    "mounting.tell": ((Mounting.LEVEL,), SENT),
    "end_load.set": ((EndLoad.FULL,), ANSWERED),
    "end_load.report": ({"on": True}, DONE),
    "linkage.set": ((LinkageRole.MOTION_OUTPUT,), ANSWERED),
    "settings.save": (({Parameter("max_angle_deg", 2): 100.0},), DONE),
    "settings.reset_end_limits": (NONE, ANSWERED),
    "settings.reset_joint_limits": (NONE, ANSWERED),
    **dict.fromkeys(("reference.allow", "reference.begin", "reference.finish"), (NONE, SENT)),
    "reference.teach": (NONE, SENT),
    "reference.drive": ((6,), DONE),
    "cell.take": ((Cell("bench"),), DONE),
    "cell.choose": (("bench",), DONE),
    "cell.change": ((Cell("bench", (Tool("pen"),), "pen"),), DONE),
    **dict.fromkeys(("cell.confirm", "cell.delete"), (NONE, DONE)),
    "cell.hold": (("cube",), DONE),
    "cell.rename": (("stand",), DONE),
}
"""The arguments each begins with, and how it ends where nothing comes in between."""

GOES_ON = {"jog.begin", "recorder.start", "episode.begin"}
"""What goes on until the operator ends it."""
SHOWN = {
    *("recorder.start", "motors.enable", "episode.begin", "episode.end", "episode.discard"),
    *("gripper.disable", "gripper.clear_error", "gripper.set_zero"),
    *("cell.take", "cell.choose", "cell.change", "cell.confirm", "cell.delete"),
    *("cell.hold", "cell.rename"),
}
"""What the feedback shows of an arm that has heard nothing, for it was so before, and cells, which
no arm is told of.
"""
FOLLOWED = [name for name, (_begin, ending) in BEGIN.items() if ending is not SENT]


def begun(rig, name) -> Started:
    """The operation has begun, in an arm that is ready for it."""
    bend(rig)
    BEFORE.get(name, lambda _rig: None)(rig)
    since = len(rig.events)
    started = begin(rig, name)
    assert [each.started for each in rig.events[since:] if each.started is not None] == [started]
    assert started.operation == name
    return started


def begin(rig, name) -> Started:
    """The record that whoever begins it by its id is handed."""
    arguments = BEGIN[name][0]
    if callable(arguments):
        arguments = arguments(rig)
    named = arguments if isinstance(arguments, dict) else {}
    started = rig.controller.begin(name, *(() if named else arguments), **named)
    assert isinstance(started, Started)
    return started


def let_go(rig, name):
    """The operator ends what goes on until then."""
    rig.run(0.5)
    if name == "jog.begin":
        rig.controller.jogging.stop()
    elif name == "recorder.start":
        rig.controller.recorder.finish("a")
    elif name == "episode.begin":
        accepted(rig.controller.episodes.end())


def test_every_operation_is_among_them(rig):
    # what parameters hold is a question; its answer stands in the parameter
    assert set(rig.controller.operations) - set(BEGIN) == {"settings.read"}


@pytest.mark.parametrize("name", BEGIN)
def test_what_nothing_comes_between_ends_by_itself(rig, name):
    started = begun(rig, name)
    if name in GOES_ON:
        assert started.ending is None
        let_go(rig, name)
    rig.run_until(lambda: started.ending is not None, seconds=60.0)
    assert started.ending is BEGIN[name][1]


@pytest.mark.parametrize("name", FOLLOWED)
def test_a_lost_connection_ends_it(rig, name):
    started = begun(rig, name)
    was = started.ending
    rig.controller.disconnect_device()
    if name == "episode.begin":
        assert started.ending is None, "the log goes on without an arm, and so does its episode"
        return
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
    started = begin(rig, name)
    let_go(rig, name)
    rig.run_until(lambda: started.ending is not None)
    assert started.ending in {FAILED, CUT_OFF, REFUSED} or name in SHOWN


def deafen(rig):
    """Nothing that is sent reaches the arm; what it says is heard."""
    rig.firmware.on_frame = lambda _frame: []


def test_what_is_refused_has_no_record(rig):
    assert isinstance(rig.controller.begin("motion.home"), Refusal)
    with pytest.raises(KeyError):
        rig.controller.begin("motion.fly")


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
