"""S12: beside 发送 stands how fast the arm is told to go; a trajectory has one set of options."""

from PySide6.QtWidgets import QSpinBox, QWidget

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
    """An operator with the library and an editor of the same trajectory."""

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

    def speeds(self):
        return [
            page.findChild(QSpinBox, "run_speed").value() for page in (self.library, self.window)
        ]

    def effective(self, page=None):
        return (page or self.window).findChild(QWidget, "run_effective").text()

    def sent(self):
        """The speed percentages of the mode words that came with targets."""
        heard = [each for each in self.app_driver.node.heard if each.arbitration_id == 0x151]
        return {each.data[2] for each in heard if each.data[1] == 1}


def test_a_first_run_is_slow_and_says_why(app_driver):
    operator = AtBoth(app_driver, SLOW, FAST)
    assert operator.speeds() == [20, 20]
    for page in (operator.window, operator.library):
        assert operator.effective(page) == "Effective speed 3–18 % · first run"
    tip = operator.child("run_effective").toolTip()
    assert "not known to have run" in tip
    assert "top bar" in tip


def test_what_is_said_is_what_is_sent(app_driver):
    operator = AtBoth(app_driver, SLOW, FAST)
    app_driver.controller.motion.set_speed_percent(60)
    app_driver.run(0.5)
    app_driver.node.heard.clear()
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    app_driver.run(0.1)
    assert operator.sent() == {3, 18}
    assert operator.effective().startswith("Effective speed 3–18 %")
    assert "first run" not in operator.effective(), "it has run by now"


def test_what_is_chosen_on_one_page_stands_on_the_other(app_driver):
    operator = AtBoth(app_driver, SLOW)
    operator.child("run_speed").setValue(200)
    assert operator.speeds() == [200, 200]
    assert operator.effective(operator.library).startswith("Effective speed 30 %")
    operator.library.findChild(QWidget, "run_cycles").setCurrentIndex(2)
    operator.library.findChild(QWidget, "run_steps").setChecked(True)
    assert operator.child("run_cycles").currentIndex() == 2
    assert operator.child("run_steps").isChecked()


def test_each_trajectory_has_its_own(app_driver):
    Library(app_driver.library_folder).save(Trajectory("Other", points=(FAST,)))
    operator = AtBoth(app_driver, SLOW)
    operator.child("run_speed").setValue(70)
    operator.library._table.choose(["Other"], show=True)
    assert operator.speeds() == [20, 70]
    operator.library._table.choose(["Test"], show=True)
    assert operator.speeds() == [70, 70]


def test_the_library_keeps_how_it_was_run(app_driver):
    operator = AtBoth(app_driver, SLOW)
    operator.child("run_speed").setValue(80)
    operator.send()
    operator.until_over()
    (entry,) = Library(app_driver.library_folder).entries()
    assert entry.ran_with == RunOptions(speed_factor=0.8)
    kept = Library(app_driver.library_folder)
    kept.save(Trajectory("Test", points=(FAST,)), replacing="Test")
    kept.rename("Test", "New")
    assert kept.entries()[0].ran_with == RunOptions(speed_factor=0.8), "saved and renamed"
    (back,) = kept.restore(kept.delete(["New"]))
    assert kept.entries()[0].ran_with == RunOptions(speed_factor=0.8), "deleted and restored"
    kept.duplicate(back, "Copy")
    assert kept.entries()[0].ran_with is None, "a copy never ran"


def test_another_program_turns_nothing_here(app_driver):
    operator = AtBoth(app_driver, SLOW)
    Library(app_driver.library_folder).note_run("Test", RunOptions(speed_factor=2.0))
    operator.library.refresh()
    assert operator.speeds() == [20, 20], "nobody has chosen another speed at this window"


def test_only_the_rows_that_run_count(app_driver):
    operator = AtBoth(app_driver, SLOW, FAST, FAST)
    factor = operator.child("run_speed")
    factor.setValue(100)
    for page in (operator.window, operator.library):
        assert operator.effective(page) == "Effective speed 15–90 % · first run"
    operator.child("run_first").setValue(2)
    for page in (operator.window, operator.library):
        assert operator.effective(page) == "Effective speed 90 % · first run"
        assert "from row 2 on" in page.findChild(QWidget, "run_effective").toolTip()
    operator.child("run_cycles").setCurrentIndex(1)  # further cycles begin with the first row
    assert operator.effective() == "Effective speed 15–90 % · first run"


def test_speeds_from_each_row_on():
    percents = [50, 20, 20, 80, 30, 30]
    points = [Waypoint(MoveMode.MOVE_J, OUT, speed_percent=one) for one in percents]
    found = speeds_of(points)
    assert found == ((0, 20, 80), (3, 30, 80), (4, 30, 30))
    assert speeds_of([]) == ()
