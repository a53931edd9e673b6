"""A check takes its time; nothing comes of one that the operator no longer wants."""

import math
from typing import Any

import pytest
from PySide6.QtWidgets import QListWidget, QPushButton, QWidget

from armui.cell.cell import Cell
from armui.cell.tools import Tool
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.system.helper_process import HelperProcess
from armui.trajectory.library.store import Library
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.accepted import accepted
from tests.app_driver import AppDriver

HERE = (0.0, 20.0, -30.0, 0.0, 10.0, 0.0)
NEAR = (5.0, 25.0, -35.0, 0.0, 15.0, 5.0)


class Operator:
    """Before an editor of two points, near to where the arm is, which may move."""

    def __init__(self, app_driver):
        self.app_driver, self.workers = app_driver, app_driver.workers
        app_driver.ready()
        self.lead_to(HERE)
        Library(app_driver.library_folder).save(
            Trajectory("Test", points=(Waypoint(MoveMode.MOVE_J, NEAR), to_here()))
        )
        app_driver.click("library_button")
        self.list = app_driver.page(LibraryPage)
        self.list.open_trajectory("Test")
        self.window = app_driver.page(EditorPage)
        self.workers.work()

    def lead_to(self, joints_deg):
        """By somebody else's hand, for all the editor knows."""
        accepted(self.app_driver.controller.motion.send_joints(joints_deg))
        self.app_driver.run_until(
            lambda: math.dist(self.app_driver.controller.state.angles_deg(), joints_deg) < 0.01
        )

    def child(self, name, window=None):
        return (window or self.window).findChild(QWidget, name)

    def click(self, name):
        self.app_driver.click(self.child(name))

    def text(self, name):
        return self.child(name).text()

    @property
    def marks(self):
        """The mark of the first row, and how many signs of findings are in the picture."""
        shown = self.app_driver.program.view._state.preview
        return self.window.model.fault(0), len(shown.path.findings)

    @property
    def running(self):
        return self.app_driver.controller.player.running


def to_here():
    return Waypoint(MoveMode.MOVE_J, HERE)


@pytest.fixture
def operator(slow_driver):
    return Operator(slow_driver)


def test_the_run_begins_when_the_check_has_ended(operator):
    operator.click("run_send")
    assert operator.text("run_checking") == "Checking…"
    assert not operator.child("run_send").isEnabled()
    assert operator.child("run_call_off").isVisible()
    assert not operator.running
    operator.workers.work()
    assert operator.running


def test_a_check_can_be_called_off(operator):
    operator.click("run_send")
    operator.click("run_call_off")
    assert operator.text("run_checking") == ""
    assert operator.child("run_send").isEnabled()
    operator.workers.work()
    assert not operator.running


def test_the_emergency_stop_is_meant_for_what_is_about_to_begin(operator):
    operator.click("run_send")
    operator.app_driver.click("stop_button")
    operator.workers.work()
    operator.app_driver.run(1.0)
    assert not operator.running
    assert not operator.child("findings_title").isVisible()


@pytest.mark.parametrize("end", ["halt_and_hold", "on_failure", "end_all_motion"])
def test_what_ends_every_motion_is_meant_for_what_is_about_to_begin(operator, end):
    operator.click("run_send")
    getattr(operator.app_driver.controller, end)()
    assert operator.text("run_checking") == ""
    operator.workers.work()
    operator.app_driver.run(1.0)
    assert not operator.running
    assert not operator.child("findings_title").isVisible()


def test_a_stopped_arm_hinders_no_check(operator):
    operator.app_driver.click("stop_button")
    operator.app_driver.run(1.0)
    operator.click("editor_check")
    operator.app_driver.run(0.5)
    operator.workers.work()
    assert operator.text("findings_title").startswith("Check: nothing found.")  # the arm sinks


def test_a_check_says_that_the_cell_waits_for_its_confirmation(operator):
    cell = operator.app_driver.controller.cell
    operator.app_driver.run(1.0)
    pen = Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0), 10.0)
    accepted(cell.take(Cell("bench", (pen,), "pen")))
    cell.forget_arm()
    operator.app_driver.run(0.1)
    operator.click("editor_check")
    operator.workers.work()
    title = operator.text("findings_title")
    assert title.startswith("Check: nothing found. The cell “bench” is not confirmed")
    assert "tool was not" in title
    accepted(cell.confirm())
    operator.app_driver.run(0.1)
    operator.click("editor_check")
    operator.workers.work()
    assert "bench" not in operator.text("findings_title")


def test_what_was_found_of_the_way_there_goes_when_the_arm_stands_elsewhere(operator):
    operator.lead_to((60.0, *HERE[1:]))
    operator.app_driver.run(0.5)
    operator.click("editor_check")
    operator.workers.work()
    findings = operator.child("findings_list")
    assert "The first point is far from where the arm is" in findings.item(0).text()
    assert operator.marks == (False, 1)
    operator.lead_to(HERE)
    operator.app_driver.run(0.5)
    assert findings.count() == 0
    assert operator.marks == (None, 0), "the mark of the row and the sign in 3D go with it"
    assert operator.text("findings_title") == (
        "Check: the points were checked. The arm has moved since: its way to the first point is "
        "not checked."
    )
    operator.lead_to((60.0, *HERE[1:]))
    operator.app_driver.run(0.5)
    assert findings.count() == 1, "it stands where it was checked from"
    assert operator.marks == (False, 1)
    operator.click("findings_close")
    operator.lead_to(HERE)
    operator.app_driver.run(0.5)
    assert operator.marks == (None, 0), "also after the list was closed"
    assert not findings.isVisible()


def test_the_run_of_a_check_is_no_motion_away_from_it(operator):
    operator.click("run_send")
    operator.workers.work()
    assert operator.running
    arm = operator.app_driver.controller
    operator.app_driver.run_until(lambda: math.dist(arm.state.angles_deg(), HERE) > 3.0)
    operator.app_driver.click("run_pause")
    operator.app_driver.run(0.3)
    assert operator.text("findings_title") == "Check: nothing found."
    operator.app_driver.click("run_stop")
    operator.app_driver.run_until(lambda: not operator.running)
    operator.app_driver.run(0.3)
    assert operator.text("findings_title").startswith("Check: nothing found. The arm has moved")


def test_an_edit_makes_the_check_worthless(operator):
    operator.click("run_send")
    model = operator.window.model
    model.setData(model.index(0, PointColumn.VALUE_1), "7")
    operator.workers.work()
    assert not operator.running
    assert not operator.child("findings_title").isVisible()


def test_nothing_begins_from_a_window_that_was_closed(operator):
    operator.click("run_send")
    operator.window.close()
    operator.workers.work()
    assert not operator.running


def test_nothing_begins_for_another_row_of_the_list(operator):
    Library(operator.app_driver.library_folder).save(Trajectory("Other"))
    window = operator.list
    window.refresh(["Test"])
    operator.app_driver.click(operator.child("run_send", window))
    window.refresh(["Test"])
    assert operator.child("run_checking", window).text() == "Checking…"
    window.refresh(["Other"])
    assert operator.child("run_checking", window).text() == ""
    operator.workers.work()
    assert not operator.running


def test_an_arm_that_was_moved_meanwhile_is_checked_anew(operator):
    operator.click("run_send")
    operator.lead_to((0.0, 20.0, -31.0, 0.0, 10.0, 0.0))
    operator.workers.work()
    assert not operator.running
    assert "has moved by 1.0° since" in operator.text("editor_message")
    operator.click("run_send")
    operator.workers.work()
    assert operator.running


def test_after_a_long_check_the_operator_is_asked(operator, monkeypatch):
    monkeypatch.setattr("armui.control.run.run_request._SURPRISING_S", -1.0)
    operator.click("run_send")
    operator.workers.work()
    assert not operator.running
    accept = operator.window.findChild(QPushButton, "accept_warnings")
    assert accept.isVisible()
    assert accept.text() == "Run now"
    operator.app_driver.click(accept)
    assert operator.running


def test_what_waits_for_the_operator_is_lit_and_said_in_the_line_above(operator, monkeypatch):
    monkeypatch.setattr("armui.control.run.run_request._SURPRISING_S", -1.0)
    accept = operator.window.findChild(QPushButton, "accept_warnings")
    send = operator.window.findChild(QPushButton, "run_send")

    def ask():
        operator.click("run_send")
        operator.workers.work()
        assert (accept.property("primary"), send.property("primary")) == (True, False)
        assert "“Test” has not started" in operator.app_driver.read("recovery_text")
        assert "press the button beside it" in operator.app_driver.read("recovery_text")

    def answered():
        assert operator.app_driver.read("recovery_text") == "Ready"
        assert send.property("primary")

    operator.app_driver.run_until(lambda: operator.app_driver.read("recovery_text") == "Ready")
    ask()
    operator.click("findings_close")
    answered()
    assert not operator.running
    ask()
    operator.window.document.set_note("another", "Note")
    operator.window.document.edit(operator.window.document.points[:1], "edit")
    answered()  # what is edited was not checked
    ask()
    operator.window.document.stack.undo()
    operator.window.document.stack.undo()
    ask()
    operator.app_driver.click(accept)
    assert operator.running
    assert send.property("primary")
    assert "has not started" not in operator.app_driver.read("recovery_text")


def test_a_fault_is_said_before_a_run_that_waits(operator, monkeypatch):
    monkeypatch.setattr("armui.control.run.run_request._SURPRISING_S", -1.0)
    operator.click("run_send")
    operator.workers.work()
    operator.app_driver.controller.emergency_stop()
    operator.app_driver.run(0.2)
    assert "has not started" not in operator.app_driver.read("recovery_text")
    accept = operator.window.findChild(QPushButton, "accept_warnings")
    assert not accept.isEnabled()
    assert "emergency stop" in accept.toolTip()


def test_a_check_that_fails_says_so(operator):
    operator.click("run_send")
    operator.workers.break_down("out of memory")
    assert "out of memory" in operator.text("editor_message")
    assert not operator.running
    assert operator.child("run_send").isEnabled()


def test_the_worst_of_many_findings_are_listed_and_the_rest_counted(operator):
    beyond = Waypoint(MoveMode.MOVE_J, (0.0, 20.0, -30.0, 110.0, 10.0, 0.0))
    operator.window.document.edit((beyond,) * 150, "edit")
    operator.click("editor_check")
    operator.workers.work()
    shown = operator.window.findChild(QListWidget, "findings_list")
    assert shown.count() == 101
    assert shown.item(100).text() == "51 more"  # the first point is far from the arm, too


def test_a_check_in_a_process_of_its_own(qapp, request, tmp_path):
    settings = tmp_path / "settings.json"
    app_driver = AppDriver(qapp, request.node.nodeid, settings, Generation.TWO, HelperProcess())
    Library(app_driver.library_folder).save(Trajectory("Test", points=(to_here(),) * 3))
    app_driver.click("library_button")
    app_driver.page(LibraryPage).open_trajectory("Test")
    window: Any = app_driver.page(EditorPage)
    app_driver.click(window.findChild(QWidget, "editor_check"))
    app_driver.wait(window.findChild(QWidget, "findings_title").isVisible)
    assert window.findChild(QWidget, "run_checking").text() == ""
    app_driver.close()
