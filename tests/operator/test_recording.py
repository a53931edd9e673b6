"""An operator who records the arm, trims and thins what came of it, keeps it and replays it."""

import math

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.trajectory.samples.recording import Recording
from armui.ui import format as fmt
from armui.ui.dialogs.confirm_dialog import LeaveQuestion, SaveQuestion
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.recording.recorded_curves import drawn_curves
from armui.ui.trajectory.recording.recording_page import RecordingPage
from tests.accepted import accepted

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)


class Operator:
    """With the window 录制 open before an arm that may move."""

    def __init__(self, app_driver):
        self.app_driver = app_driver
        app_driver.ready()
        app_driver.click("library_button")
        self.list = app_driver.page(LibraryPage)
        app_driver.click(self.list.findChild(QWidget, "library_record"))
        self.window = app_driver.page(RecordingPage)
        self.library = Library(app_driver.library_folder)

    def child(self, name):
        return self.window.findChild(QWidget, name)

    def click(self, name):
        self.app_driver.click(self.child(name))

    def text(self, name):
        return self.child(name).text()

    def type_into(self, name, text):
        field = self.child(name)
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)

    def record(self):
        self.click("record")
        self.app_driver.controller.motion.set_speed_percent(100)
        self.app_driver.controller.motion.send_joints(OUT)
        self.app_driver.run_until(
            lambda: math.dist(self.app_driver.firmware.joints_deg, OUT) < 1e-3
        )
        self.app_driver.run(0.5)
        self.click("record")


@pytest.fixture
def operator(app_driver):
    return Operator(app_driver)


@pytest.fixture
def slow(slow_driver):
    operator = Operator(slow_driver)
    slow_driver.workers.work()
    return operator


def test_what_the_arm_did_is_kept_as_a_recording(operator):
    curves = operator.child("recorded_curves")
    empty = curves.grab().toImage()
    operator.click("record")
    operator.app_driver.run(1.0)
    assert operator.text("record_state").startswith("Recording: ")
    assert operator.text("record") == "Stop recording"
    operator.window._show_growing()  # what its timer does
    assert curves.grab().toImage() != empty
    QTest.mousePress(curves, Qt.MouseButton.LeftButton, pos=curves.rect().center())
    assert operator.window.cut is None, "it is not trimmed yet"
    operator.click("record")
    operator.click("save_recording")
    operator.record()
    assert operator.text("record_state").startswith("Recorded: ")
    operator.type_into("record_name", "By hand")
    operator.click("save_recording")
    kept = operator.library.load("By hand")
    assert isinstance(kept, Recording)
    assert kept.joints_deg[-1] == pytest.approx(OUT, abs=0.01)
    assert "Saved as “By hand”" in operator.text("record_message")
    operator.window.close()
    assert not operator.window.isVisible()


def test_fewer_samples_with_a_larger_tolerance(operator):
    operator.record()
    operator.child("record_tolerance").show_value(0.0)
    operator.type_into("record_tolerance", "5")
    operator.click("save_recording")
    coarse = len(operator.library.load("Recording").samples)
    operator.type_into("record_tolerance", "0.01")
    operator.click("save_recording")
    assert coarse < len(operator.library.load("Recording 2").samples)


def test_it_is_trimmed(operator):
    operator.record()
    operator.type_into("record_from", "0.2")
    operator.type_into("record_to", "0.7")
    operator.click("save_recording")
    assert operator.library.load("Recording").duration_s == pytest.approx(0.5, abs=0.06)


def drag(curves, from_s, to_s):
    """Drag the handle at a time to another one."""
    height = curves.height() // 2
    begin, end = (QPoint(round(curves.place_px(each)), height) for each in (from_s, to_s))
    QTest.mousePress(curves, Qt.MouseButton.LeftButton, pos=begin)
    QTest.mouseMove(curves, end)
    QTest.mouseRelease(curves, Qt.MouseButton.LeftButton, pos=end)


def shown(operator):
    return operator.app_driver.program.view._state.preview


def test_it_is_trimmed_by_handles_on_the_curves_and_the_picture_shows_what_is_kept(operator):
    operator.record()
    curves = operator.child("recorded_curves")
    whole_s = operator.window._recording.duration_s
    whole = shown(operator).path
    assert math.dist(whole.marks_mm[0], whole.marks_mm[1]) > 100
    drag(curves, 0.0, 0.3)
    assert operator.child("record_from").value == pytest.approx(0.3, abs=0.02)
    first = shown(operator).path.marks_mm[0]
    drag(curves, whole_s, 0.6)
    to_s = operator.child("record_to").value
    assert to_s == pytest.approx(0.6, abs=0.02)

    kept = shown(operator)
    assert len(kept.path.places_mm) < len(whole.places_mm)
    assert kept.path.marks_mm[0] == pytest.approx(first)
    recording = operator.window._recording
    at = int((recording.times_s <= to_s).sum()) - 1
    assert kept.ghost_deg == pytest.approx(tuple(recording.joints_deg[at]), abs=3.0)
    drag(curves, to_s, 0.1)  # not before the other end
    assert operator.child("record_to").value == operator.child("record_from").value
    operator.type_into("record_to", "0.6")
    assert curves.place_px(0.6) == pytest.approx(curves.place_px(curves._to_s), abs=0.5)
    operator.app_driver.heard()
    operator.click("save_recording")
    assert operator.library.load("Recording").duration_s == pytest.approx(0.3, abs=0.06)
    assert operator.app_driver.heard() == []


def test_no_peak_of_a_long_recording_is_lost_in_its_curves():
    samples = np.zeros((50_000, 8))
    samples[:, 0] = np.arange(50_000) / 100
    samples[12_345, 3] = 80.0
    curves = drawn_curves(Recording("long", samples=samples), 400)
    assert [len(curve) for curve in curves] == pytest.approx([800] * 6, abs=4)
    assert [curve[:, 1].max() for curve in curves] == [0.0, 0.0, 80.0, 0.0, 0.0, 0.0]


def test_an_unsaved_recording_is_asked_about_before_another_takes_its_place(operator):
    operator.record()
    told = operator.text("record_state")
    operator.click("record")
    question = operator.app_driver.dialog(SaveQuestion)
    assert "“Recording” has not been saved" in question.text()
    operator.app_driver.click(question.cancel_button)
    assert operator.text("record_state") == told
    operator.click("record")
    operator.app_driver.click(operator.app_driver.dialog(SaveQuestion).save_button)
    assert operator.text("record") == "Stop recording"
    assert operator.library.load("Recording").joints_deg[-1] == pytest.approx(OUT, abs=0.01)
    operator.app_driver.run(0.5)
    operator.click("record")
    operator.click("record")
    operator.app_driver.confirm()
    assert operator.text("record") == "Stop recording"
    operator.click("record")
    assert [entry.name for entry in operator.library.entries()] == ["Recording"]


def test_what_comes_from_a_file_is_no_recording_made_here(operator):
    samples = np.zeros((200, 8))
    samples[:, 0] = np.arange(200) / 100
    operator.library.save(Recording("Seam", samples=samples))
    operator.library.save(Recording("Own", samples=samples, taught_on="piper"))
    for name, told in (("Seam", "Imported file, or of an unknown arm: "), ("Own", "Recorded: ")):
        operator.window.close()
        operator.list.refresh()
        operator.list.open_trajectory(name)
        operator.app_driver.run(0.1)
        operator.window = operator.app_driver.page(RecordingPage)
        assert operator.text("record_state") == f"{told}2.0 s, 200 samples, 13 kB"
        assert operator.window.title == "Trim samples"
        assert operator.window.focusWidget().objectName() == "record_preview"


def test_times_that_leave_nothing_are_not_saved(operator):
    operator.record()
    operator.type_into("record_from", "900")
    operator.app_driver.wait(lambda: not operator.child("save_recording").isEnabled())
    assert "Nothing is left" in operator.text("record_kept")


def test_thinning_takes_its_time_and_the_last_wish_counts(slow):
    slow.record()
    assert slow.text("record_kept") == "Working…"
    slow.app_driver.workers.work()
    all_of_it = slow.text("record_kept")
    slow.type_into("record_to", "0.7")
    slow.window._work_out()
    slow.type_into("record_to", "0.5")
    slow.click("save_recording")
    assert slow.library.entries() == []
    slow.app_driver.workers.work()
    assert slow.text("record_kept") != all_of_it
    assert slow.library.load("Recording").duration_s == pytest.approx(0.5, abs=0.03)


def test_recording_anew_forgets_what_is_being_thinned(slow):
    slow.record()
    slow.click("record")
    slow.app_driver.confirm()
    slow.app_driver.workers.work()
    assert slow.window._result is None
    assert not slow.child("save_recording").isEnabled()
    slow.click("record")


def test_work_that_fails_says_so(slow):
    slow.record()
    slow.app_driver.workers.break_down("out of memory")
    assert "out of memory" in slow.text("record_message")
    assert not slow.child("save_recording").isEnabled()


def test_what_would_be_kept_is_previewed(operator):
    def seconds():
        operator.click("record_preview")
        text = bar.findChild(QWidget, "preview_time").text()
        return float(text.rpartition(":")[2])

    operator.record()
    operator.app_driver.heard()
    bar = operator.app_driver.find("preview_bar")
    whole_s = seconds()
    assert bar.isVisible()
    recorded_s = operator.window._recording.duration_s
    operator.type_into("record_to", "0.5")
    assert whole_s - seconds() == pytest.approx(recorded_s - 0.5, abs=0.15)
    operator.app_driver.run(0.2)
    assert operator.app_driver.heard() == []
    assert operator.library.entries() == []


def test_it_is_kept_as_points(operator):
    operator.record()
    operator.type_into("record_tolerance", "1")
    operator.click("save_points")
    kept = operator.library.load("Recording")
    assert isinstance(kept, Trajectory)
    assert {point.move for point in kept.points} == {MoveMode.MOVE_J}
    assert kept.points[-1].target == pytest.approx(OUT, abs=0.01)


def test_closing_what_is_not_kept_asks(operator):
    operator.record()
    operator.window.close()
    question = operator.app_driver.dialog(LeaveQuestion)
    operator.app_driver.click(question.save_button)
    assert [entry.name for entry in operator.library.entries()] == ["Recording"]


def test_without_an_arm_there_is_nothing_to_record(app_driver):
    app_driver.click("library_button")
    app_driver.click(app_driver.page(LibraryPage).findChild(QWidget, "library_record"))
    button = app_driver.page(RecordingPage).findChild(QWidget, "record")
    assert not button.isEnabled()
    assert "No arm is connected" in button.toolTip()


def test_a_recording_is_replayed_from_the_list(operator):
    operator.record()
    operator.click("save_recording")
    operator.window.close()
    app_driver = operator.app_driver
    app_driver.controller.motion.go_home()
    app_driver.run_until(lambda: max(map(abs, app_driver.firmware.joints_deg)) < 0.01)
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving)
    operator.list.findChild(QWidget, "library_table").selectRow(0)
    assert not operator.list.findChild(QWidget, "run_first").isVisible()
    app_driver.click(operator.list.findChild(QWidget, "run_send"))
    accept = operator.list.findChild(QWidget, "accept_warnings")
    if accept.isVisible():
        app_driver.click(accept)
    assert app_driver.controller.replayer.running, operator.list.findChild(
        QWidget, "library_message"
    ).text()
    assert app_driver.read("run_text").startswith("0 % of the recording · ")  # on the way to it
    replayer = app_driver.controller.replayer
    app_driver.run_until(lambda: replayer.progress.done > 0.3)
    app_driver.run(0.2)
    done = fmt.percent(100 * replayer.progress.done)
    assert app_driver.read("run_text").startswith(f"{done} of the recording · ")
    app_driver.click("run_stop")
    app_driver.run_until(lambda: not replayer.running)
    done = fmt.percent(100 * replayer.progress.done)
    told = operator.list.findChild(QWidget, "library_message").text()
    assert told == f"“Recording” ended after {done} of the recording."
    assert not operator.list.findChild(QWidget, "run_resume").isVisible()


def test_a_recording_is_seen_while_another_panel_is_shown(app_driver):
    app_driver.ready()
    button = app_driver.find("library_button")
    assert button.text().strip() == "Trajectory library"
    accepted(app_driver.controller.recorder.start())
    app_driver.click("menu_motion")
    app_driver.run(0.2)
    assert button.text().strip() == button.accessibleName() == "Recording…"
    app_driver.controller.recorder.finish("one")
    app_driver.run(0.2)
    assert button.text().strip() == "Trajectory library"
