"""S35: every motion of ours passes one gate, or nothing of it is sent."""

import ast
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest

from armui.arm.refusal import Refusal
from armui.bus.outbox import Outbox, UnpassedMotionError
from armui.cell.cell import Cell
from armui.cell.work_area import Area, AreaBox
from armui.control.context import COMMAND_OVER, REFUSED
from armui.control.motion.jog_path import JointJog
from armui.control.motion.motion_command import End
from armui.control.operations.started import Ending, Started
from armui.control.run.progress import Run, RunPhase
from armui.control.run.replay import Replay
from armui.control.safety import gate
from armui.control.safety.gate import BEGAN_ELSEWHERE, NOT_IN_TIME
from armui.control.safety.interlocks import SPEED_ZERO
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode, TeachingState
from armui.protocol.frame import Frame
from armui.protocol.motion_frames import is_motion_frame
from armui.trajectory.points.program import Waypoint
from armui.ways.passes import Pass
from tests.accepted import accepted
from tests.arm_rig import ArmRig
from tests.each import check_each
from tests.safety.test_s12_speed_override import even_turn

HERE = (0.0, 40.0, -40.0, 0.0, 20.0, 0.0)
THERE = (60.0, 40.0, -40.0, 0.0, 20.0, 0.0)
BACK = (-60.0, 40.0, -40.0, 0.0, 20.0, 0.0)
POSE = (300.0, 0.0, 300.0, 0.0, 90.0, 0.0)
RUN = Run("run", [Waypoint(MoveMode.MOVE_J, THERE)], [2.0])
FAR_BOX = AreaBox("far", (2000.0, 0.0, 0.0, 0.0, 0.0, 0.0), (50.0, 50.0, 50.0))


class Thread:
    """Works out what the gate hands on when the test says so."""

    def __init__(self) -> None:
        self.waiting: list[tuple[Future[Any], Callable[[], Any]]] = []

    def __call__(self, work):
        done: Future[Any] = Future()
        self.waiting.append((done, work))
        return done

    def work(self):
        """Work out all that waits."""
        for done, work in self.waiting:
            done.set_result(work())
        self.waiting.clear()


@pytest.fixture
def moving(rig):
    """The arm is on its way to a place."""
    rig.lie(HERE)
    rig.ready()
    rig.controller.motion.set_speed_percent(50)
    accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.6)
    assert rig.controller.operating_state.moving
    rig.heard()
    return rig


@pytest.fixture
def slow(rig, monkeypatch):
    """A check that takes as long as the test wants; the arm rests."""
    rig.lie(HERE)
    rig.ready()
    rig.controller.gate._background = thread = Thread()
    monkeypatch.setattr(gate, "_AT_ONCE", -1.0)
    rig.heard()
    return rig, thread


def ids(rig: ArmRig) -> list[int]:
    return [frame.arbitration_id for frame in rig.heard()]


def percents(heard: list[Frame]) -> set[int]:
    return {frame.data[2] for frame in heard if frame.arbitration_id == 0x151}


def why(rig: ArmRig):
    """Why the last motion was refused after its press."""
    told = [event for event in rig.events if event.notice == REFUSED]
    reason = told[-1].params["reason"]
    assert isinstance(reason, Refusal)
    return reason.reason


# The bus ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", [0x00, 0x10, 0x20])
def test_the_outbox_takes_no_motion_frame_without_a_pass(offset):
    def check(entry):
        arbitration_id, data, moves = entry
        frame = Frame(arbitration_id, bytes.fromhex(data).ljust(8, b"\0"))
        assert is_motion_frame(frame) is moves
        box = Outbox()
        if not moves:
            box.put([frame])
            return
        with pytest.raises(UnpassedMotionError, match=f"0x{arbitration_id:03X}"):
            box.put([frame])
        box.put([frame], passed=Pass())

    check_each(
        (
            *((each + offset, "", True) for each in range(0x151, 0x160)),
            (0x150 + offset, "01", False),  # stop
            (0x150 + offset, "02", False),  # resume
            (0x150 + offset, "00 01", False),  # pause
            (0x150 + offset, "00 02", True),  # continue
            (0x150 + offset, "00 06", False),  # end
            (0x150 + offset, "00 00 01", False),  # record by hand
            (0x150 + offset, "00 00 03", True),  # replay within the arm
            (0x150 + offset, "00 00 05", True),
            (0x150 + offset, "00 00 07", True),
            (0x181, "77", True),  # a motor
            (0x181, "72", False),  # asks one
            (0x471, "07 02", False),  # enable
            (0x121, "01", False),  # a lamp
        ),
        check,
    )


def test_nobody_but_the_gate_makes_a_pass():
    """And nobody asks the rules one by one but the gate, and the check of whole trajectories."""
    root = Path(gate.__file__).parents[2]
    makes, asks = set(), set()
    for path in root.rglob("*.py"):
        name = path.relative_to(root).as_posix()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            called = node.func if isinstance(node, ast.Call) else None
            if isinstance(called, ast.Name) and called.id == "Pass":
                makes.add(name)
            if isinstance(node, ast.ImportFrom) and node.module in {
                "armui.ways.rules",
                "armui.ways.law",
                "armui.ways.own_body",
            }:
                asks.add(name)
    assert makes == {"control/safety/gate.py"}
    own = {name for name in asks if name.startswith("ways/")}
    assert asks - own == {
        "control/controller_parts.py",
        "control/safety/gate.py",
        "trajectory/planning/check.py",
    }


# A second motion into one under way --------------------------------------------------------------


def test_a_target_the_other_way_brakes_first(moving):
    rig = moving
    accepted(rig.controller.motion.send_joints(BACK))
    assert 0x155 not in ids(rig)
    began_s = rig.time_s
    rig.run_until(lambda: 0x155 in ids(rig), seconds=1.0)
    assert rig.time_s - began_s <= 1.0
    assert rig.firmware.joints_deg[0] < THERE[0]
    rig.run(4.0)
    assert rig.firmware.joints_deg == pytest.approx(BACK, abs=0.5)


def test_a_target_further_on_is_sent_at_once(moving):
    rig = moving
    accepted(rig.controller.motion.send_joints((90.0, *THERE[1:])))
    rig.step()
    assert 0x155 in ids(rig)
    rig.run(4.0)
    assert rig.firmware.joints_deg[0] == pytest.approx(90.0, abs=0.5)


def test_quick_steps_stay_fluent_and_add_up(rig):
    rig.lie(HERE)
    rig.ready()
    for _ in range(12):
        accepted(rig.controller.motion.jog(1, 1.0))
        rig.run(0.04)
    rig.run(3.0)
    assert rig.firmware.joints_deg[0] == pytest.approx(12.0, abs=0.1)
    assert not [frame for frame in rig.heard() if frame.arbitration_id == 0x150]


def test_quick_steps_of_the_tool_stay_fluent_and_add_up(rig):
    rig.lie(HERE)
    rig.ready()
    before = rig.controller.cartesian.tool_pose(rig.controller.state)[2]
    for _ in range(12):
        accepted(rig.controller.cartesian.step(2, 1.0, JogFrame.BASE))
        rig.run(0.04)
    rig.run(3.0)
    after = rig.controller.cartesian.tool_pose(rig.controller.state)[2]
    assert after - before == pytest.approx(12.0, abs=0.1)
    assert not [frame for frame in rig.heard() if frame.arbitration_id == 0x150]


def test_a_target_out_of_the_question_does_not_end_the_motion_under_way(moving):
    rig = moving
    assert isinstance(rig.controller.motion.send_joints((170.0, *HERE[1:])), Refusal)
    rig.run(4.0)
    assert ids(rig) == []
    assert rig.firmware.joints_deg == pytest.approx(THERE, abs=0.5)


@pytest.mark.parametrize("act", ["emergency_stop", "halt_and_hold"])
def test_what_waits_for_the_arm_to_rest_is_void_after_a_stop(moving, act):
    rig = moving
    started = accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.1)
    getattr(rig.controller, act)()
    rig.heard()
    rig.run(3.0)
    assert 0x155 not in ids(rig)
    assert started.ending is Ending.CUT_OFF


def test_the_last_of_several_presses_counts(moving):
    rig = moving
    first = accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.1)
    accepted(rig.controller.motion.send_joints(HERE))
    assert first.ending is Ending.CUT_OFF
    rig.run(5.0)
    assert rig.firmware.joints_deg == pytest.approx(HERE, abs=0.5)


def test_a_jog_voids_what_waits(moving):
    rig = moving
    waits = accepted(rig.controller.motion.send_joints(BACK))
    rig.controller.jogging.start(JointJog(2, 1))
    rig.controller.jogging.stop()
    rig.run(3.0)
    assert waits.ending is Ending.CUT_OFF
    assert rig.firmware.joints_deg[0] > 0.0


@pytest.mark.parametrize(
    "press",
    [
        lambda arm: arm.motion.send_joints(HERE),
        lambda arm: arm.motion.go_home(),
        lambda arm: arm.motion.come_inside(),
        lambda arm: arm.cartesian.move((300.0, 0.0, 300.0, 0.0, 90.0, 0.0), MoveMode.MOVE_P),
        lambda arm: arm.cartesian.move_arc(*3 * ((300.0, 0.0, 300.0, 0.0, 90.0, 0.0),)),
        lambda arm: arm.jogging.start(JointJog(2, 1)),
    ],
)
def test_a_press_that_is_refused_voids_what_waits_too(moving, press):
    rig = moving
    waits = accepted(rig.controller.motion.send_joints(BACK))
    percent, rig.controller.motion.speed_percent = rig.controller.motion.speed_percent, 0
    assert press(rig.controller) == SPEED_ZERO()
    assert waits.ending is Ending.CUT_OFF
    rig.controller.motion.speed_percent = percent
    rig.run(3.0)
    assert 0x155 not in ids(rig)


def test_it_leaves_at_the_speed_that_was_chosen_while_it_braked(moving):
    rig = moving
    accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.06)
    accepted(rig.controller.motion.set_speed_percent(10))
    rig.run(1.0)
    heard = rig.heard()
    assert 0x155 in {frame.arbitration_id for frame in heard}
    assert percents(heard) == {10}


# A check that takes its time ---------------------------------------------------------------------


def test_nothing_leaves_before_the_check_has_answered(slow):
    rig, thread = slow
    started = accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.3)
    assert ids(rig) == []
    assert "checking" in rig.codes()
    thread.work()
    rig.step()
    assert 0x155 in ids(rig)
    assert isinstance(started, Started)


@pytest.mark.parametrize(
    "press",
    [
        lambda arm: arm.motion.send_joints(THERE),
        lambda arm: arm.motion.jog(1, 30.0),
        lambda arm: arm.cartesian.step(2, 40.0, JogFrame.BASE),
    ],
)
def test_it_leaves_at_the_speed_that_was_chosen_while_it_was_checked(slow, press):
    rig, thread = slow
    accepted(press(rig.controller))
    rig.run(0.1)
    accepted(rig.controller.motion.set_speed_percent(10))
    rig.run(0.1)
    rig.heard()
    thread.work()
    rig.run(0.1)
    assert percents(rig.heard()) == {10}
    assert rig.controller.operating_state.moving


@pytest.mark.parametrize("by", ["pause", "0 %"])
@pytest.mark.parametrize("part", ["player", "replayer"])
def test_what_is_paused_while_its_way_is_checked_sends_nothing_before_it_goes_on(slow, part, by):
    rig, thread = slow
    run, controller = getattr(rig.controller, part), rig.controller
    accepted(run.start(RUN if part == "player" else Replay(even_turn())))
    rig.run(0.1)
    accepted(run.pause() if by == "pause" else controller.motion.set_speed_percent(0))
    rig.run(0.1)
    thread.work()
    rig.run(0.5)
    assert ids(rig) == []
    assert run.phase is RunPhase.PAUSED
    if by == "0 %":
        accepted(controller.motion.set_speed_percent(30))
    accepted(run.go_on())
    rig.step()
    assert ids(rig) == []
    thread.work()
    rig.run(0.1)
    assert 0x155 in ids(rig)
    assert run.progress.phase is RunPhase.MOVING


def test_a_press_that_is_refused_beside_a_run_takes_nothing_of_it(slow):
    rig, thread = slow
    presses = (
        rig.controller.motion.go_home,
        lambda: rig.controller.motion.send_joints(BACK),
        lambda: rig.controller.jogging.start(JointJog(1, 1)),
        lambda: rig.controller.cartesian.move(POSE, MoveMode.MOVE_P),
        lambda: rig.controller.teaching.command(TeachingState.START_RECORDING),
    )
    controller = rig.controller
    for run, content in ((controller.player, RUN), (controller.replayer, Replay(even_turn()))):
        accepted(run.start(content))
        for press in presses:
            assert isinstance(press(), Refusal)
        thread.work()
        rig.run(0.2)
        assert rig.firmware.mechanics.moving
        rig.controller.halt_and_hold()
        rig.run(1.0)


def test_a_run_is_told_that_what_it_waits_for_is_void(slow):
    rig, thread = slow
    controller = rig.controller
    runs = ((controller.player, RUN), (controller.replayer, Replay(even_turn())))
    for run, content in runs:
        accepted(run.start(content))
        controller._authority.end_command(End.OTHER_MODE)
        rig.run(0.1)
        assert run.progress.refusal == COMMAND_OVER()
    thread.work()
    rig.run(0.2)
    assert not set(ids(rig)) & {0x155, 0x156, 0x157}


def test_drag_teaching_voids_what_is_still_checked(slow):
    rig, thread = slow
    waits = accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.1)
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    thread.work()
    rig.controller.tick()  # the arm has not said yet that a hand may lead it
    rig.run(0.5)
    assert ids(rig) == [0x150]
    assert waits.ending is Ending.CUT_OFF


def test_a_replay_waits_for_its_check_as_long_as_any_motion(slow):
    rig, thread = slow
    replayer = rig.controller.replayer
    accepted(replayer.start(Replay(even_turn())))
    rig.run(0.8)
    thread.work()
    rig.run(0.2)
    assert rig.firmware.mechanics.moving
    replayer.stop()
    rig.run(1.0)
    accepted(replayer.start(Replay(even_turn())))
    rig.run(1.1)
    assert replayer.progress.refusal == NOT_IN_TIME()


def test_an_answer_a_second_late_counts_no_more(slow):
    rig, thread = slow
    started = accepted(rig.controller.motion.send_joints(THERE))
    rig.run(1.1)
    thread.work()
    rig.run(0.5)
    assert ids(rig) == []
    assert (why(rig), started.ending) == (NOT_IN_TIME, Ending.REFUSED)


@pytest.mark.parametrize("by", ["emergency_stop", "halt_and_hold", "end_all_motion"])
def test_an_answer_after_a_stop_counts_no_more(slow, by):
    rig, thread = slow
    accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.1)
    getattr(rig.controller, by)()
    thread.work()
    rig.run(0.5)
    assert 0x155 not in ids(rig)


def test_an_answer_about_another_cell_counts_no_more(slow):
    rig, thread = slow
    accepted(rig.controller.cell.take(Cell("one")))
    accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.1)
    accepted(rig.controller.cell.change(Cell("one", area=Area(boxes=(FAR_BOX,)))))
    thread.work()
    rig.run(0.5)
    assert 0x155 not in ids(rig)
    assert why(rig) == BEGAN_ELSEWHERE


def test_an_answer_for_another_place_counts_no_more(slow):
    rig, thread = slow
    accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.1)
    rig.firmware.mechanics.sag_deg = (5.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    rig.run(0.1)
    thread.work()
    rig.run(0.5)
    assert 0x155 not in ids(rig)
    assert why(rig) == BEGAN_ELSEWHERE


def test_only_the_newest_answer_counts(slow):
    rig, thread = slow
    accepted(rig.controller.motion.send_joints(BACK))
    accepted(rig.controller.motion.send_joints(THERE))
    thread.work()
    rig.run(4.0)
    assert rig.firmware.joints_deg == pytest.approx(THERE, abs=0.5)
