"""An operator who runs trajectories from 轨迹库: the path the simulated arm really took."""

import math
from dataclasses import replace
from itertools import pairwise

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QListWidget, QSpinBox, QToolTip, QWidget

from armui.control.run.player import RUN_TOO_SLOW
from armui.control.run.progress import RunPhase
from armui.protocol.codes import MoveMode
from armui.sim.faults.schedule import fault
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.running.run_bar import POINTS_CHANGED_SINCE_RUN, RunBar
from tests.accepted import accepted
from tests.generations import ONE_IS_ENOUGH
from tests.trajectory.arms import ARM

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
UP = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)
AWAY = Waypoint(MoveMode.MOVE_P, (900.0, 0.0, 200.0, 0.0, 85.0, 0.0))


def to(joints_deg, **more):
    return Waypoint(MoveMode.MOVE_J, joints_deg, speed_percent=100, **more)


class Operator:
    """At the editor of one trajectory, with an arm that may move.

    Attributes:
        path: Where the arm was at each step.
    """

    def __init__(self, app_driver, *points):
        self.app_driver = app_driver
        self.path = []
        app_driver.ready()
        library = Library(app_driver.library_folder)
        library.save(Trajectory("Test", points=points))
        library.note_run("Test", RunOptions())  # a first run would begin at 20 %
        app_driver.click("library_button")
        self.library = app_driver.page(LibraryPage)
        self.library.open_trajectory("Test")
        self.window = app_driver.page(EditorPage)
        app_driver.wait(self.window.isActiveWindow)
        app_driver.controller.motion.set_speed_percent(100)
        app_driver.step()  # its frame has left

    @property
    def progress(self):
        return self.app_driver.controller.player.progress

    def child(self, name, kind=QWidget):
        return self.window.findChild(kind, name)

    def click(self, name):
        self.app_driver.click(self.child(name))

    def send(self, button="run_send", window=None):
        """Press 发送, and accept that the first point is far from where the arm is."""
        window = window or self.window
        self.app_driver.click(window.findChild(QWidget, button))
        accept = window.findChild(QWidget, "accept_warnings")
        if accept.isVisible():
            self.app_driver.click(accept)

    def of_strip(self, name):
        """A part of the strip below the page, which is there since something ran."""
        return self.app_driver.find(name)

    def text(self, name):
        found = self.app_driver.window.findChildren(QWidget, name)
        (shown,) = [each for each in found if each.isVisible()]
        return shown.text()

    def until(self, condition, seconds=40.0):
        def look():
            self.path.append(tuple(self.app_driver.firmware.joints_deg))
            return condition()

        self.app_driver.run_until(look, seconds)

    def until_over(self):
        self.until(lambda: not self.app_driver.controller.player.running)

    def visits(self, joints_deg):
        there = [math.dist(here, joints_deg) < 0.1 for here in self.path]
        return sum(now and not before for before, now in zip([False, *there], there, strict=False))

    def lit(self):
        model = self.window.model
        headers = (
            model.headerData(row, Qt.Orientation.Vertical) for row in range(model.rowCount())
        )
        return [row for row, text in enumerate(headers) if text.startswith("▶")]


def test_once_through_every_point_in_order(any_driver):
    operator = Operator(any_driver, to(OUT), to(BACK), to(UP))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    assert operator.lit() == [1]
    assert "point 2 of 3" in operator.text("run_text")
    assert "left" in operator.text("run_text")
    assert not operator.child("run_send").isEnabled()
    operator.until_over()
    assert [operator.visits(place) for place in (OUT, BACK, UP)] == [1, 1, 1]
    assert operator.lit() == []
    assert operator.of_strip("run_bar").value() == 1000
    assert operator.text("run_text").endswith("done")


@pytest.mark.styled
def test_how_long_it_takes_is_read_whole_beside_where_it_goes_on(app_driver):
    operator = Operator(app_driver, *(to(OUT, dwell_s=3600.0) for _ in range(12)))
    app_driver.controller.motion.set_speed_percent(20)
    operator.child("run_first", QSpinBox).setValue(12)
    operator.child("run_cycles", QComboBox).setCurrentIndex(2)
    operator.send()
    operator.until(lambda: app_driver.controller.player.running)
    app_driver.click("run_stop")
    operator.until_over()
    told = operator.child("run_effective")
    app_driver.wait(lambda: "at 20 %" in told.text())
    assert operator.child("run_resume").isVisible()
    assert told.fontMetrics().horizontalAdvance(told.text()) > told.width()
    assert told.text() not in told.toolTip(), "it is cut"
    assert told.height() >= 2 * told.fontMetrics().lineSpacing()


def test_so_many_times(app_driver):
    operator = Operator(app_driver, to(OUT), to(UP))
    operator.child("run_cycles", QComboBox).setCurrentIndex(1)
    operator.child("run_times", QSpinBox).setValue(2)
    operator.send()
    operator.until(lambda: operator.progress.cycle == 2)
    assert "cycle 2 of 2" in operator.text("run_text")
    operator.until_over()
    assert (operator.visits(OUT), operator.visits(UP)) == (2, 2)


def test_in_a_loop_until_it_is_ended_and_on_from_there(app_driver):
    operator = Operator(app_driver, to(OUT), to(UP))
    operator.child("run_cycles", QComboBox).setCurrentIndex(2)
    operator.send()
    operator.until(lambda: (operator.progress.cycle, operator.progress.index) == (2, 1))
    assert "∞" in operator.text("run_text")
    operator.app_driver.click("run_stop")
    operator.until_over()
    assert operator.progress.phase is RunPhase.STOPPED
    assert operator.text("run_resume") == "Continue from row 2"
    operator.send("run_resume")
    operator.until(lambda: operator.visits(UP) == 2)
    assert operator.progress.cycles == 0


@ONE_IS_ENOUGH
def test_a_pause_holds_the_arm(any_driver):
    operator = Operator(any_driver, to(OUT), to(BACK))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    operator.app_driver.run(0.3)
    operator.app_driver.click("run_pause")
    operator.app_driver.run(1.5)
    assert operator.text("run_text").endswith("paused: hold “Continue” for 1 s")
    here = tuple(operator.app_driver.firmware.joints_deg)
    operator.app_driver.run(1.0)
    assert math.dist(here, operator.app_driver.firmware.joints_deg) < 0.001
    assert operator.text("run_continue") == "Continue"
    operator.app_driver.click("run_continue")
    assert operator.progress.phase is RunPhase.PAUSED
    assert QToolTip.text() == "Hold it for 1 s, with the mouse or the space bar."
    operator.app_driver.hold_button("run_continue")
    operator.app_driver.run(0.2)
    assert operator.text("run_text").endswith("moving · speed 100 %")
    operator.until_over()
    assert operator.visits(BACK) == 1


def test_a_line_says_how_fast_the_tool_may_be(app_driver):
    """What a run is ended for when it is measured to be faster stands where it is seen to run."""
    tool = ARM.kinematics.forward(UP)
    line = Waypoint(MoveMode.MOVE_L, (*tool[:1], tool[1] + 150.0, *tool[2:]), speed_percent=20)
    operator = Operator(app_driver, to(UP), line)
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    told = operator.text("run_text").rpartition(" · ")[2]
    assert told.startswith("speed 20 %, tool ≤ ")
    places = [ARM.kinematics.forward(operator.path[-1])[:3]]
    for _ in range(200):
        app_driver.run(0.1)
        places.append(ARM.kinematics.forward(app_driver.firmware.joints_deg)[:3])
    fastest_mm_s = max(math.dist(a, b) / 0.1 for a, b in pairwise(places))
    shown_mm_s = float(told.removeprefix("speed 20 %, tool ≤ ").removesuffix(" mm/s"))
    assert shown_mm_s == pytest.approx(fastest_mm_s, rel=0.02)


def test_step_by_step_from_the_second_row(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK), to(UP))
    operator.child("run_first", QSpinBox).setValue(2)
    operator.child("run_steps").setChecked(True)
    operator.send()
    operator.until(lambda: operator.progress.phase is RunPhase.WAITING)
    assert operator.text("run_next") == "Next step"
    assert (operator.visits(OUT), operator.visits(BACK)) == (0, 1)
    operator.app_driver.run(1.0)
    assert operator.progress.index == 1
    assert operator.text("run_text").endswith("waiting: press “Next step”")
    operator.app_driver.click("run_next")
    operator.until_over()
    operator.app_driver.run(0.5)
    operator.app_driver.click("run_close")
    assert operator.text("recovery_text") == "Ready"
    assert operator.visits(UP) == 1


def test_the_emergency_stop_ends_it_and_says_where(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    operator.app_driver.press(operator.app_driver.find("stop_button"))
    operator.until_over()
    assert operator.progress.phase is RunPhase.FAILED
    assert "Ended at row 2" in operator.text("editor_message")
    assert operator.text("editor_message").endswith("It was the emergency stop.")
    assert operator.text("run_resume") == "Continue from row 2"
    assert not operator.child("run_resume").isEnabled()
    app_driver.store.change(language="zh")
    app_driver.step()
    assert operator.text("editor_message") == "在第 2 行结束。原因是急停。"


def test_the_end_of_an_earlier_run_is_not_told_after_a_later_one(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK), to(UP))
    pages = ((operator.window, "editor_message"), (operator.library, "library_message"))
    told = [page.findChild(QWidget, name) for page, name in pages]
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    app_driver.controller.player.end_run(RUN_TOO_SLOW(seconds=3))
    app_driver.run(1.0)
    assert all("at row 2" in each.text() for each in told)
    operator.send()
    operator.until(lambda: operator.progress.index == 2)
    assert not any("at row" in each.text() for each in told)
    app_driver.click("run_stop")
    operator.until_over()
    assert [each.text() for each in told] == ["Ended at row 3.", "“Test” ended at row 3."]


def test_the_rows_of_a_table_that_is_changed_are_not_those_of_the_run(app_driver):
    """The run goes by the points as they were: no other row is marked or gone on from."""
    operator = Operator(app_driver, to(OUT), to(BACK), to(UP))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    told, resume = operator.child("editor_message"), operator.child("run_resume")
    app_driver.click("run_pause")
    operator.window.select_row(0)
    operator.click("editor_duplicate")
    assert operator.lit() == []
    assert told.text().startswith("The table is not what runs")
    operator.click("editor_undo")
    assert (operator.lit(), told.text()) == ([1], "")
    operator.click("editor_delete")
    app_driver.run(0.3)
    assert operator.lit() == []
    app_driver.click("run_stop")
    operator.until_over()
    assert told.text().startswith("Ended at row 2 of the table as it was. The points have been")
    assert not resume.isVisible()
    operator.click("editor_undo")
    assert told.text() == "Ended at row 2."
    assert resume.isVisible()


def test_a_file_that_is_changed_is_not_gone_on_with(app_driver):
    """Where a list shows the run's own trajectory, another program may have changed it."""
    operator = Operator(app_driver, to(OUT), to(BACK), to(UP))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    app_driver.click("run_stop")
    operator.until_over()
    bar = operator.window.findChild(RunBar)
    assert bar._why_not_resume(Trajectory("Test", points=(to(OUT), to(BACK), to(UP)))) is None
    other = bar._why_not_resume(Trajectory("Test", points=(to(BACK), to(OUT), to(BACK), to(UP))))
    assert other.reason == POINTS_CHANGED_SINCE_RUN


def test_errors_of_the_check_are_not_run(app_driver):
    operator = Operator(app_driver, to(OUT), AWAY, to(UP))
    app_driver.heard()
    operator.click("run_send")
    app_driver.run(0.2)
    assert app_driver.heard() == []
    assert "the check has found errors (1)" in operator.text("editor_message")
    assert not operator.child("run_send").property("primary")
    findings = operator.child("findings_list", QListWidget)
    assert findings.item(0).text().startswith("✕ Error · Row 2")
    assert not operator.child("accept_warnings").isVisible()
    place = findings.visualItemRect(findings.item(0)).center()
    QTest.mouseClick(findings.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert operator.window.table.current_row() == 1
    assert operator.window.model.headerData(1, Qt.Orientation.Vertical) == "✕ 2"


@pytest.mark.parametrize("begun", [True, False])
def test_a_fault_that_is_over_is_not_told_as_there(app_driver, begun):
    operator = Operator(app_driver, to((0.0, 60.0, -60.0, 0.0, 20.0, 100.0)))
    push = fault("collision", 2)
    operator.click("run_send")
    app_driver.run(0.2)
    if begun:
        operator.click("accept_warnings")
        app_driver.run_until(lambda: operator.progress.phase is RunPhase.MOVING)
    app_driver.node.faults.start(push)
    app_driver.run(0.5)
    if begun:
        assert operator.text("editor_message").startswith("Ended at row 1. The arm reported: ")
        assert "emergency stop" not in operator.text("editor_message")
    else:
        assert not operator.child("accept_warnings").isEnabled()
        assert "The arm reports: " in operator.child("accept_warnings").toolTip()
    app_driver.node.faults.end(push)
    app_driver.run(0.1)
    accepted(app_driver.controller.joint_errors.clear(2))
    app_driver.run(1.0)
    assert "The arm reports" not in operator.child("editor_message").text()
    assert operator.child("accept_warnings").isEnabled()


def test_beside_a_question_no_other_button_is_lit(app_driver):
    operator = Operator(app_driver, to((0.0, 60.0, -60.0, 0.0, 20.0, 100.0)))
    operator.click("editor_jog")
    assert operator.child("box_insert").property("primary")
    operator.click("run_send")
    app_driver.run(0.2)
    lit = [each.objectName() for each in buttons_of(operator) if each.property("primary")]
    assert lit == ["accept_warnings"]
    operator.click("findings_close")
    assert operator.child("box_insert").property("primary")


def buttons_of(operator):
    buttons = operator.window.findChildren(QAbstractButton)
    return [each for each in buttons if each.isVisible()]


def test_warnings_are_run_once_they_are_accepted(app_driver):
    operator = Operator(app_driver, to((0.0, 60.0, -60.0, 0.0, 20.0, 100.0)))
    app_driver.heard()
    operator.click("run_send")
    app_driver.run(0.2)
    assert app_driver.heard() == []  # far from where the arm is
    findings = operator.child("findings_list", QListWidget)
    assert findings.item(0).text().startswith("! Warning")
    operator.click("accept_warnings")
    operator.until_over()
    assert operator.progress.phase is RunPhase.DONE


def test_a_joint_beyond_its_limit_is_an_error(app_driver):
    operator = Operator(app_driver, to((0.0, 60.0, -60.0, 0.0, 20.0, 0.0)), to((170.0, *UP[1:])))
    operator.click("editor_check")
    findings = operator.child("findings_list", QListWidget)
    rows = [findings.item(place).text() for place in range(findings.count())]
    assert any(text.startswith("✕ Error · Row 2") for text in rows)


def test_the_check_marks_the_list(app_driver):
    operator = Operator(app_driver, to(OUT), AWAY)
    operator.click("editor_check")
    table = operator.library.findChild(QWidget, "library_table")
    assert table.model().index(0, 4).data() == "✕ errors"


def test_points_that_change_take_the_findings_away(app_driver):
    operator = Operator(app_driver, to(OUT), AWAY)
    operator.click("editor_check")
    assert operator.child("findings_list").isVisible()
    operator.window.select_row(1)
    QTest.keyClick(operator.window.table, Qt.Key.Key_Delete)
    assert not operator.child("findings_list").isVisible()


def test_motors_that_are_off_keep_it_from_being_sent(app_driver):
    operator = Operator(app_driver, to(OUT))
    accepted(app_driver.controller.motors.disable())
    app_driver.run_until(lambda: app_driver.controller.operating_state.cannot_run is not None)
    app_driver.run(0.2)
    assert not operator.child("run_send").isEnabled()
    assert operator.child("run_send").toolTip()


def test_the_speed_is_that_of_the_points_times_the_one_at_the_top(app_driver):
    operator = Operator(app_driver, replace(to(OUT), speed_percent=60), to(UP))
    app_driver.type_into("speed_field", "50")
    app_driver.step()  # its own frame has left
    app_driver.heard()
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    modes = [frame for frame in app_driver.heard() if frame.arbitration_id == 0x151]
    assert [frame.data[2] for frame in modes] == [30, 50]  # 60 % and 100 %, halved


def test_the_library_sends_the_chosen_one(app_driver):
    operator = Operator(app_driver, to(OUT), to(UP))
    operator.window.close()
    table = operator.library.findChild(QWidget, "library_table")
    table.selectRow(0)
    operator.send(window=operator.library)
    operator.until_over()
    assert (operator.visits(OUT), operator.visits(UP)) == (1, 1)
    assert "done" in operator.text("run_text")


@pytest.mark.parametrize("override", [100, 50, 20])
@pytest.mark.parametrize("percent", [20, 100])
def test_the_time_left_is_that_which_short_ways_take(app_driver, percent, override):
    near = tuple(angle + 5.0 for angle in OUT)
    operator = Operator(app_driver, to(OUT), to(near), to(OUT, dwell_s=1.0), to(near))
    app_driver.controller.motion.set_speed_percent(percent)
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    app_driver.controller.motion.set_speed_percent(override)
    app_driver.step()
    told_s, begun_s = operator.progress.remaining_s, app_driver.time_s
    operator.until_over()
    took_s = app_driver.time_s - begun_s
    assert told_s == pytest.approx(took_s, rel=0.15)


def test_points_from_and_to_the_rest_pose_are_run_inside_the_limits(app_driver):
    rest = (0.0, -1.999, 1.971, -1.412, 22.11, -2.608)
    operator = Operator(app_driver, to(rest), to(OUT), to(rest))
    operator.send()
    operator.until_over()
    assert operator.path[-1] == pytest.approx((0.0, 0.5, -0.5, -1.412, 15.0, -2.608), abs=0.1)
    assert any(math.dist(OUT, each) < 1.0 for each in operator.path)
    assert min(each[1] for each in operator.path) > -0.01
