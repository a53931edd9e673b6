"""S12: the slider at the top is the speed of a run, too; a first run begins slowly, visibly."""

from dataclasses import replace

from PySide6.QtWidgets import QWidget

from armui.control.run.progress import RunPhase
from armui.protocol.codes import MoveMode
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint, speeds_of
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.operator.test_running import BACK, OUT, Operator

SLOW = Waypoint(MoveMode.MOVE_J, OUT, speed_percent=15)
FAST = Waypoint(MoveMode.MOVE_J, BACK, speed_percent=90)


class AtBoth(Operator):
    """An operator with the library and an editor of the same trajectory, which never ran."""

    def __init__(self, driver, *points):
        driver.ready()
        self.app_driver, self.path = driver, []
        Library(driver.library_folder).save(Trajectory("Test", points=points))
        driver.click("library_button")
        self.library = driver.page(LibraryPage)
        self.library._table.choose(["Test"], show=True)
        self.library.open_trajectory("Test")
        self.window = driver.page(EditorPage)
        driver.wait(self.window.isActiveWindow)

    def told(self, page=None):
        return (page or self.window).findChild(QWidget, "run_effective")

    def sent(self):
        """The speed percentages of the mode words that came with targets."""
        heard = [each for each in self.app_driver.node.heard if each.arbitration_id == 0x151]
        return {each.data[2] for each in heard if each.data[1] == 1}


def test_a_first_run_lowers_the_slider_where_it_is_seen(app_driver):
    operator = AtBoth(app_driver, SLOW, FAST)
    app_driver.type_into("speed_field", "60")
    for page in (operator.window, operator.library):
        assert "first run: lowered to 20 %" in operator.told(page).text()
        assert "3–18 % from row 1 on" in operator.told(page).toolTip()
    app_driver.run(0.5)
    app_driver.node.heard.clear()
    operator.send()
    assert app_driver.read("speed_field") == "20 %"
    (told,) = [each for each in app_driver.events if each.code == "run_speed_lowered"]
    assert told.params == {"before": 60, "percent": 20}
    operator.until(lambda: operator.progress.index == 1)
    app_driver.run(0.1)
    assert operator.sent() == {3, 18}
    assert "first run" not in operator.told().text(), "it has run by now"


def test_a_first_run_never_raises_it_and_a_second_leaves_it(app_driver):
    operator = AtBoth(app_driver, FAST)
    app_driver.type_into("speed_field", "10")
    operator.send()
    assert app_driver.read("speed_field") == "10 %"
    operator.until_over()
    app_driver.type_into("speed_field", "60")
    operator.send()
    assert app_driver.read("speed_field") == "60 %"


def test_a_first_run_that_does_not_begin_leaves_the_slider(app_driver):
    operator = AtBoth(app_driver, replace(FAST, target=(0.0, 220.0, 0.0, 0.0, 0.0, 0.0)))
    app_driver.type_into("speed_field", "60")
    operator.send()
    assert operator.child("findings_list").isVisible(), "the check has found errors"
    assert operator.progress.phase is RunPhase.IDLE
    assert app_driver.read("speed_field") == "60 %"


def test_a_question_before_a_first_run_leaves_the_slider_until_it_is_agreed_to(app_driver):
    operator = AtBoth(app_driver, replace(FAST, target=OUT))
    app_driver.type_into("speed_field", "60")
    operator.click("run_send")
    assert operator.child("accept_warnings").isVisible()
    assert app_driver.read("speed_field") == "60 %"
    operator.click("accept_warnings")
    app_driver.run(0.1)
    assert app_driver.read("speed_field") == "20 %"
    operator.until_over()
    assert app_driver.read("speed_field") == "20 %"


def test_what_is_raised_in_a_run_counts_and_is_back_after_it(app_driver):
    operator = AtBoth(app_driver, FAST)
    operator.send()
    app_driver.run(0.2)
    app_driver.type_into("speed_field", "50")
    app_driver.run(0.1)
    assert app_driver.firmware.condition.speed_percent == 45
    assert operator.progress.phase is RunPhase.MOVING
    operator.until_over()
    assert app_driver.read("speed_field") == "20 %"


def test_at_0_percent_nothing_is_sent_and_the_reason_names_the_slider(app_driver):
    operator = AtBoth(app_driver, FAST)
    app_driver.type_into("speed_field", "0")
    button = operator.child("run_send")
    assert not button.isEnabled()
    assert "at the top" in button.toolTip()


def test_what_is_chosen_on_one_page_stands_on_the_other(app_driver):
    operator = AtBoth(app_driver, SLOW)
    operator.library.findChild(QWidget, "run_cycles").setCurrentIndex(2)
    operator.library.findChild(QWidget, "run_steps").setChecked(True)
    assert operator.child("run_cycles").currentIndex() == 2
    assert operator.child("run_steps").isChecked()


def test_the_library_keeps_how_it_was_run(app_driver):
    operator = AtBoth(app_driver, SLOW)
    operator.child("run_cycles").setCurrentIndex(1)
    operator.child("run_times").setValue(2)
    operator.send()
    operator.until_over()
    (entry,) = Library(app_driver.library_folder).entries()
    assert entry.ran_with == RunOptions(cycles=2)
    kept = Library(app_driver.library_folder)
    kept.save(Trajectory("Test", points=(FAST,)), replacing="Test")
    kept.rename("Test", "New")
    assert kept.entries()[0].ran_with == RunOptions(cycles=2), "saved and renamed"
    (back,) = kept.restore(kept.delete(["New"]))
    assert kept.entries()[0].ran_with == RunOptions(cycles=2), "deleted and restored"
    kept.duplicate(back, "Copy")
    assert kept.entries()[0].ran_with is None, "a copy never ran"


def test_only_the_rows_that_run_count(app_driver):
    operator = AtBoth(app_driver, SLOW, FAST, FAST)
    assert "3–18 % from row 1 on" in operator.told().toolTip()
    operator.child("run_first").setValue(2)
    for page in (operator.window, operator.library):
        assert "18 % from row 2 on" in operator.told(page).toolTip()
    operator.child("run_cycles").setCurrentIndex(1)  # further cycles begin with the first row
    assert "3–18 % from row 1 on" in operator.told().toolTip()


def test_speeds_from_each_row_on():
    percents = [50, 20, 20, 80, 30, 30]
    points = [Waypoint(MoveMode.MOVE_J, OUT, speed_percent=one) for one in percents]
    found = speeds_of(points)
    assert found == ((0, 20, 80), (3, 30, 80), (4, 30, 30))
    assert speeds_of([]) == ()
