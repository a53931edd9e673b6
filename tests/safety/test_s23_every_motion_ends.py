"""S23: whatever fails, every motion of ours ends, unless what failed can drive nothing.

A check tries a sample of the places that can fail; `HYPOTHESIS_PROFILE=nightly` tries each with
every kind of motion, for half an hour.
"""

import contextlib
import logging
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.app import DRIVE_NOTHING, may_drive
from armui.control.assessment_inputs import Assessor
from armui.control.authority import Authority
from armui.control.authority_watch import AuthorityWatch
from armui.control.devices.gripper import GripperControl
from armui.control.gamepad.pilot import GamepadPilot
from armui.control.link.connection import Connection
from armui.control.link.link_watch import LinkWatch
from armui.control.motion.jog_path import JointJog, JointJogPath, ToolJogPath
from armui.control.motion.jog_stream import JogStream
from armui.control.motion.jogging import Jogging
from armui.control.motion.steered_path import SteeredToolPath
from armui.control.motion_end import MotionEnd
from armui.control.operations.started import Started
from armui.control.run.execution import Execution
from armui.control.run.player import Player
from armui.control.run.recorder import Recorder
from armui.control.run.replayer import Replayer
from armui.control.safety.recovery import Recovery
from armui.control.safety.stopping import Stopping
from armui.protocol.generation import Generation
from armui.system import failures
from armui.ui.panels.jogging.cartesian_panel import CartesianPanel, PoseRow
from armui.ui.panels.jogging.jog_box import JogBox, JogCell
from armui.ui.panels.jogging.jog_panel import JogPanel, JogRow, KeyPad
from armui.ui.panels.jogging.motion_panel import JointRow, MotionPanel
from armui.ui.shell.status_bar import StatusBar
from armui.ui.widgets.hold_guard import HoldGuard
from armui.ui.widgets.jog_button import JogButton
from armui.viewport.view import ArmView
from tests.accepted import accepted
from tests.arm_rig import ArmRig
from tests.control.jogger import BENT_DEG, TICK_S, bend, hold
from tests.control.under_way import BACK, OUT, replay_moving, run_moving, to
from tests.examples import sample
from tests.failing import ERROR, failing, functions_of, getter
from tests.gamepad.pads import PAD, Pads, switch_on
from tests.gamepad.piloting import pick_up
from tests.operator.editor.actions import Editor

ABORT = bytes([0, 6, 0, 0, 0, 0, 0, 0])  # 0x150 byte 1: the trajectory command 6, end it
STREAM = {0x155, 0x156, 0x157}
AIMS = {*STREAM, 0x151, 0x152, 0x153, 0x154, 0x159}


@pytest.fixture(autouse=True)
def told(monkeypatch):
    """Hooks in place, as in the program; pytest-qt's own come back after."""
    monkeypatch.setattr(logging.getLogger("armui"), "propagate", False)
    with failures.hooks():
        yield


class Slot(QObject):
    """Has Qt call something, as it calls a slot."""

    fired = Signal()

    def call(self, act):
        self.fired.connect(act)
        self.fired.emit()
        self.fired.disconnect(act)


def single_motion(rig):
    far = max((OUT, BACK), key=lambda to: abs(to[0] - rig.firmware.joints_deg[0]))
    accepted(rig.controller.motion.send_joints(far))
    rig.run(0.4)
    assert rig.controller.operating_state.moving


def jog(rig):
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.run(0.4)
    assert rig.controller.jogging.active


MOTIONS = {"jog": jog, "run": run_moving, "replay": replay_moving, "single": single_motion}


def fail_in_a_slot(rig):
    """`StatusBar.retranslate_ui` has been made to fail."""
    bar = rig.window.findChild(StatusBar)
    Slot().call(bar.retranslate_ui)


def drives(controller):
    authority = controller._authority
    return (
        controller.jogging.active
        or controller.player.running
        or controller.replayer.running
        or authority.under_way
        or bool(authority.holds)
    )


def aborts(frames):
    return [frame for frame in frames if bytes(frame.data) == ABORT]


def rests_for_good(rig, seconds=0.7):
    """Within 0.7 s the arm is at rest and stays there, and nothing sends it anywhere."""
    rig.run(seconds)
    rig.heard()
    before = rig.firmware.joints_deg
    rig.run(0.3)
    aimed = {frame.arbitration_id for frame in rig.heard()} & AIMS
    return not aimed and rig.firmware.joints_deg == pytest.approx(before, abs=0.01)


# What is called at each tick ----------------------------------------------------------------------

EACH_TICK: dict[str, Callable[..., Any]] = {
    "Connection.follow_arm": Connection.follow_arm,
    "Connection.offsets": Connection._another_answers,
    "LinkWatch.follow_online": LinkWatch.follow_online,
    "Stopping.follow_arm": Stopping.follow_arm,
    "AuthorityWatch.follow_arm": AuthorityWatch.follow_arm,
    "AuthorityWatch.observe": AuthorityWatch.observe,
    "Assessor.assess": Assessor.assess,
    "Authority.observe": Authority.observe,
    "Authority.under_way": getter(Authority, "under_way"),
    "LinkWatch.follow_handshake": LinkWatch.follow_handshake,
    "Jogging.follow_arm": Jogging.follow_arm,
    "Player.follow_arm": Player.follow_arm,
    "Replayer.follow_arm": Replayer.follow_arm,
    "Recorder.follow_arm": Recorder.follow_arm,
    "GripperControl.follow_arm": GripperControl.follow_arm,
    "Recovery.follow_arm": Recovery.follow_arm,
    "MotionEnd.retry_end": MotionEnd.retry_end,
}


@pytest.mark.timeout(300)
@pytest.mark.parametrize("place", EACH_TICK)
def test_a_failure_at_every_tick_ends_each_motion_once(rig, place):
    rig.ready()
    for motion, begin in sample(MOTIONS.items(), 1, place):
        begin(rig)
        rig.heard()
        with failing(EACH_TICK[place]):
            rig.run(0.3)
            # once by its own way, and once more where something in that failed
            assert len(aborts(rig.heard())) in {1, 2}, motion
            assert rests_for_good(rig), motion
        rig.run(0.1)
        assert rig.controller.operating_state.cannot_move is None, motion


@pytest.mark.timeout(300)
@pytest.mark.parametrize("place", sample(EACH_TICK, 3))
def test_no_motion_begins_while_something_fails(rig, place):
    """It is refused, or ends with the next tick."""
    rig.ready()
    before = rig.firmware.joints_deg
    with failing(EACH_TICK[place]):
        rig.run(0.1)
        for motion, begin in MOTIONS.items():
            with contextlib.suppress(AssertionError, ArithmeticError):
                begin(rig)
            assert rests_for_good(rig), motion
    assert rig.firmware.joints_deg == pytest.approx(before, abs=3.0)


def test_in_generation_1_as_well(qapp, request):
    rig = ArmRig(request.node.nodeid, Generation.ONE)
    rig.ready()
    for begin in sample(MOTIONS.values(), 2):
        begin(rig)
        rig.heard()
        with failing(Connection.follow_arm):
            rig.run(0.3)
            assert len(aborts(rig.heard())) == 1
            assert rests_for_good(rig)
        rig.run(0.1)
    rig.close()


ENDS: dict[str, Callable[..., Any]] = {
    "Jogging.stop": Jogging.stop,
    "Jogging.end_jog": Jogging.end_jog,
    "Jogging._end_hold": Jogging._end_hold,
    "Jogging.active": getter(Jogging, "active"),
    "Execution.end_run": Execution.end_run,
    "Execution._fail": Execution._fail,
    "Execution.running": getter(Execution, "running"),
    "Authority.cancelled": Authority.cancelled,
    "Authority.number": getter(Authority, "number"),
    "GripperControl.end_travel": GripperControl.end_travel,
    "GamepadPilot.lose": GamepadPilot.lose,
    "MotionEnd._end_single_motion": MotionEnd._end_single_motion,
}


@pytest.mark.timeout(300)
@pytest.mark.parametrize("place", sample(ENDS, 3))
def test_what_cannot_end_its_own_motion_has_it_ended(app_driver, place):
    """The arm is told by each way that works, and by the shortest where one fails; once each."""
    rig = app_driver
    rig.ready()
    for motion, begin in sample(MOTIONS.items(), 2, place):
        begin(rig)
        rig.heard()
        with failing(ENDS[place], StatusBar.retranslate_ui):
            fail_in_a_slot(rig)
            rig.run(0.3)
            # as a single motion, by the shortest way, and by a run that finds that it may not go on
            assert 1 <= len(aborts(rig.heard())) <= 3, motion
            assert rests_for_good(rig), motion
            fail_in_a_slot(rig)
            rig.run(0.1)
            assert aborts(rig.heard()) == [], motion
        rig.run(0.1)
        assert rig.controller.operating_state.cannot_move is None, motion
    with failing(ENDS[place], StatusBar.retranslate_ui):
        fail_in_a_slot(rig)
        rig.controller.emergency_stop()  # it is left alone
        rig.run_until(lambda: "stop_confirmed" in rig.codes(), 1.0)


def test_a_failure_ends_a_motion_of_the_gripper(any_driver):
    rig = any_driver
    rig.ready()
    accepted(rig.controller.gripper.move(60.0, 1.0))
    rig.run(0.3)
    gripper = rig.firmware.gripper
    at_failure = gripper.travel
    assert 0.0 < at_failure < 50.0
    with failing(StatusBar.retranslate_ui):
        fail_in_a_slot(rig)
    rig.run(2.0)
    assert gripper.travel == pytest.approx(at_failure, abs=5.0)
    assert gripper.enabled


def test_a_failure_of_the_bus_thread_ends_the_motion_when_the_device_is_back(
    app_driver, monkeypatch, qtbot
):
    rig = app_driver
    rig.ready()
    single_motion(rig)
    rig.heard()
    worker = rig.controller._connection._worker
    monkeypatch.setattr(worker, "_take_in", None)  # calling it raises in the worker
    rig.node.poll(0.02)
    qtbot.waitUntil(lambda: "link_lost" in rig.codes())
    monkeypatch.undo()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())
    rig.run_until(lambda: aborts(rig.heard()) != [], 1.0)
    assert rests_for_good(rig)


def test_a_failure_does_not_cut_the_motion_of_another_host(app_driver):
    """Nothing of ours moves: nothing is sent."""
    rig = app_driver
    rig.ready()
    rig.run(1.0)
    rig.heard()
    with failing(StatusBar.retranslate_ui):
        for _ in range(20):
            fail_in_a_slot(rig)
            rig.step()
    assert rig.heard() == []


def test_a_failure_within_the_press_that_begins_a_motion_ends_it(app_driver):
    """The slot of a notice fails before the run's first target is sent."""
    rig = app_driver
    rig.ready()
    rig.controller.noticed.connect(lambda event: 1 / 0 if event.code == "run_started" else None)
    run_moving_anyhow = Slot()
    run_moving_anyhow.call(lambda: run_moving(rig))
    assert not rig.controller.player.running
    assert rests_for_good(rig)


# Whose traceback ----------------------------------------------------------------------------------


def test_the_contract_and_the_code_name_the_same_rooms():
    project = Path(__file__).parents[2] / "pyproject.toml"
    contracts = tomllib.loads(project.read_text(encoding="utf-8"))["tool"]["importlinter"]
    (contract,) = [c for c in contracts["contracts"] if c["name"].startswith("Rooms that can")]
    assert tuple(contract["source_modules"]) == DRIVE_NOTHING
    assert {"can", "armui.control", "armui.bus.outbox", "armui.bus.worker"} <= set(
        contract["forbidden_modules"]
    )


@pytest.mark.parametrize(
    ("modules", "drives"),
    [
        ((), True),
        (("armui.viewport.view",), False),
        (("armui.viewport.view", "armui.system.atomic"), False),
        (("armui.trajectory.planning.check", "armui.ways.own_body"), False),
        (("armui.control.safety.gate", "armui.ways.law"), True),
        (("armui.viewport.view", "armui.control.context"), True),
        (("armui.viewports",), True),
        (("armui.viewport",), False),
        (("armui.ui.widgets.hold_guard",), True),
        (("armui.app",), True),
        (("armui.a_room_that_nobody_has_named",), True),
    ],
)
def test_only_a_traceback_of_rooms_that_drive_nothing_ends_nothing(modules, drives):
    assert may_drive(modules) is drives


def test_a_failure_in_a_room_that_drives_nothing_ends_nothing(app_driver):
    rig = app_driver
    rig.ready()
    single_motion(rig)
    rig.heard()
    with failing(ArmView.retranslate_ui):
        Slot().call(lambda: rig.program.view.retranslate_ui(None))
    assert "no motion was ended" in rig.find("failure_line").text()
    rig.run(5.0)
    assert aborts(rig.heard()) == []
    assert rig.firmware.joints_deg[0] == pytest.approx(OUT[0], abs=0.1)
    line = rig.find("failure_line")
    assert ERROR in line.text()
    assert "no motion was ended" in line.text()


def handlers():
    """Each method of each class of the program that some widget now seen is made of."""
    kinds = {
        kind
        for widget in QApplication.allWidgets()
        if widget.isVisible()
        for kind in type(widget).__mro__
        if kind.__module__.startswith("armui.")
    }
    return [
        (kind, function)
        for kind in sorted(kinds, key=lambda kind: (kind.__module__, kind.__name__))
        for function in functions_of(kind)
        if function.__name__.startswith("_on_") or function.__name__.endswith("Event")
    ]


@pytest.mark.timeout(600)
@pytest.mark.parametrize("motion", MOTIONS)
def test_any_slot_of_any_widget_that_fails_ends_the_motion(app_driver, motion):
    rig = app_driver
    rig.program.view.setVisible(True)
    rig.ready()
    for name in ("joint_status_button", "library_button"):
        rig.click(name)
    found = handlers()
    assert len(found) > 60
    ended = spared = 0
    slot = Slot()
    tried = sample(found, 4, motion)
    for kind, function in tried:
        if not drives(rig.controller):
            rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
            rig.run_until(lambda: rig.controller._authority.at_rest)
            MOTIONS[motion](rig)
        rig.heard()
        arguments = [None] * (function.__code__.co_argcount - 1)
        with failing(function):
            slot.call(lambda f=function, a=arguments: f(None, *a))
        harmless = not may_drive([kind.__module__])
        assert drives(rig.controller) is harmless, function.__qualname__
        spared, ended = spared + harmless, ended + (not harmless)
        if drives(rig.controller):
            rig.controller.end_motion(single=True)
    assert ended >= len(tried) // 2
    assert spared > 0 or tried != found


# What holds a jog ---------------------------------------------------------------------------------


def continuous(rig, box):
    steps = rig.find(box)
    steps.setCurrentIndex(steps.count() - 1)


def by_keys(rig):
    continuous(rig, "jog_step")
    rig.find("jog_keys_button").setChecked(True)
    pad = rig.find("jog_key_pad")

    def press():
        pad.setFocus()
        QTest.keyPress(pad, Qt.Key.Key_Space)
        QTest.keyPress(pad, Qt.Key.Key_Q)

    def release():
        QTest.keyRelease(pad, Qt.Key.Key_Q)
        QTest.keyRelease(pad, Qt.Key.Key_Space)

    return press, release


def by_button(name, box, *clicks):
    def prepare(rig):
        for each in clicks:
            rig.click(each)
        continuous(rig, box)
        button = rig.find(name)
        left = Qt.MouseButton.LeftButton
        return (
            lambda: rig.press(button),
            lambda: QTest.mouseRelease(button, left, pos=button.rect().center()),
        )

    return prepare


def in_the_editor(rig):
    Editor(rig, to(OUT))
    return by_button("box_plus_1", "box_step_deg", "editor_jog")(rig)


def by_gamepad(rig):
    pads = Pads()
    switch_on(rig.program, pads)
    pick_up(rig, pads)
    pilot, step, slot = rig.controller.gamepad, rig.step, Slot()

    def step_both(*seconds):
        step(*seconds)
        slot.call(pilot.tick)

    rig.step = step_both  # as often as its own timer would

    def press():
        pads.push(PAD, left_x=0.0, right_trigger=0.0)
        pads.release("left_shoulder")
        rig.run(0.1)
        pads.press("left_shoulder")
        rig.run(0.1)
        pads.push(PAD, left_x=-1.0, right_trigger=1.0)

    def release():
        pads.release("left_shoulder")
        pilot.tick()

    return press, release


_SHARED = (HoldGuard, Jogging, JogStream, Started)
_PANEL = (JogPanel, MotionPanel, JointJogPath)
HELD = {
    "keys": (by_keys, (KeyPad, *_PANEL, *_SHARED)),
    "button": (by_button("jog_plus_1", "jog_step"), (JogButton, JogRow, JointRow, *_PANEL)),
    "pose": (
        by_button("pose_plus_Z", "tool_step", "menu_cartesian"),
        (JogButton, PoseRow, CartesianPanel, ToolJogPath, *_SHARED),
    ),
    "box": (in_the_editor, (JogBox, JogCell, JogButton, *_SHARED)),
    "gamepad": (by_gamepad, (GamepadPilot, Jogging, JogStream, SteeredToolPath)),
}


@pytest.mark.timeout(600)
@pytest.mark.parametrize("how", HELD)
def test_a_jog_ends_on_release_whatever_method_of_what_holds_it_fails(app_driver, how):
    prepare, kinds = HELD[how]
    rig = app_driver
    rig.window.activateWindow()
    bend(rig)
    press, release = prepare(rig)
    slot = Slot()
    for kind in kinds:
        for function in sample(functions_of(kind), 2, kind.__name__):
            rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
            rig.run_until(lambda: rig.controller._authority.at_rest)
            press()
            hold(rig, 0.1)
            assert rig.controller.jogging.active, function.__qualname__
            with failing(function):
                slot.call(release)
                for _ in range(20):
                    slot.call(lambda: rig.step(TICK_S))
                rig.heard()
                before = rig.firmware.joints_deg
                for _ in range(10):
                    slot.call(lambda: rig.step(TICK_S))
                aimed = {frame.arbitration_id for frame in rig.heard()} & STREAM
                assert not aimed, function.__qualname__
                assert rig.firmware.joints_deg == pytest.approx(before, abs=0.01)
            rig.run(0.1)
            away = zip(rig.controller.state.angles_deg(), BENT_DEG, strict=True)
            if max(abs(here - there) for here, there in away) > 30.0:  # a limit would end it, too
                accepted(rig.controller.motion.send_joints(BENT_DEG))
                rig.run(3.0)
