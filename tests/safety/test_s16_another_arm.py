"""S16: a trajectory knows the arm it was taught on; another one is said, and is to be accepted."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from armui.arm.model_check import ModelFit
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.generation import PiperModel
from armui.trajectory.files import csv_file, json_file, log_file, npz_file
from armui.trajectory.library.store import Library
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points.edits import turned
from armui.trajectory.points.program import Trajectory
from armui.trajectory.samples.recording import Recording
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_work import LibraryWork
from tests.operator.test_running import OUT, Operator, to
from tests.trajectory.arms import ARM, HERE, joint, pose, run

OLD = ModelFit(older_zeros=True).kind
X = ModelFit(PiperModel.PIPER_X).kind
ROWS = np.array([[0.0, *HERE, 10.0], [1.0, *HERE, 10.0]])


def test_kinds_differ_by_model_and_zeros():
    assert ModelFit().kind == "PiPER"
    assert OLD == "PiPER (zeros before S-V1.6-3)"
    assert X == "PiPER X"
    assert ModelFit().taught_on == "", "not checked yet"
    assert ModelFit(fitting=frozenset({PiperModel.PIPER})).taught_on == "PiPER"
    assert ModelFit(fitting=frozenset({PiperModel.PIPER_X})).taught_on == ""


@pytest.mark.parametrize("taught", ["", OLD, X])
def test_files_keep_it(taught):
    content = replace(run(joint(*HERE)), taught_on=taught)
    assert json_file.read(json_file.write(content), "n").taught_on == taught
    assert log_file.read(log_file.write(content), "n").taught_on == taught
    assert csv_file.read(csv_file.write(content), "n") == content
    assert pickle.loads(pickle.dumps(content)) == content
    recording = Recording("r", samples=ROWS, taught_on=taught)
    assert npz_file.read(npz_file.write(recording)).taught_on == taught
    assert json_file.read(json_file.write(recording), "n").taught_on == taught
    assert csv_file.read(csv_file.write(recording), "n").taught_on == taught
    assert log_file.read(log_file.write(recording), "n").taught_on == taught


def test_older_files_do_not_know():
    assert "taught_on" not in csv_file.write(run(joint(*HERE)))
    text = log_file.write(replace(run(joint(*HERE)), taught_on=""))
    assert "taught_on" not in text
    assert log_file.read(text, "n").taught_on == ""


@pytest.mark.parametrize("taught", [OLD, X])
def test_another_arm_is_a_warning_of_the_check(taught):
    arm = replace(ARM, kind="PiPER")
    content = replace(run(joint(*HERE, speed=30)), taught_on=taught)
    (found,) = check(CheckRequest(content, arm, HERE)).findings
    assert (found.code, found.severity, found.row) == ("other_arm", Severity.WARNING, None)
    assert dict(found.params) == {"taught": taught, "arm": "PiPER"}
    for same in ("", "PiPER"):
        assert not check(CheckRequest(replace(content, taught_on=same), arm, HERE)).findings


def test_a_recording_of_another_arm_too():
    content = Recording("r", samples=ROWS, taught_on=X)
    assert "other_arm" in {
        each.code for each in check(CheckRequest(content, replace(ARM, kind="P"), HERE)).findings
    }


def test_it_does_not_run_unless_accepted(app_driver):
    operator = Operator(app_driver)
    operator.window.leave()
    Library(app_driver.library_folder).save(Trajectory("Other", points=(to(OUT),), taught_on=X))
    operator.library.refresh()
    model = operator.library._model
    shown = {model.data(model.index(row, column)) for row in range(2) for column in range(5)}
    assert "! other arm" in shown
    operator.library.open_trajectory("Other")
    operator.window = editor = operator.library.editors.used
    assert "PiPER X" in editor.findChild(QWidget, "editor_other_arm").text()
    assert not editor.findChild(QWidget, "convert_zeros").isVisible(), "it has another wrist"
    operator.click("run_send")
    assert not app_driver.controller.player.running
    assert operator.child("accept_warnings").isVisible()


def test_the_first_taught_point_names_the_arm(app_driver):
    operator = Operator(app_driver)
    app_driver.run(1.0)
    assert app_driver.controller.operating_state.model_fit.taught_on == "PiPER"
    operator.window.insert_current()
    assert operator.window.document.trajectory().taught_on == "PiPER"
    operator.window.save()
    assert Library(app_driver.library_folder).load("Test").taught_on == "PiPER"


class AtTwo(Operator):
    """An operator with a trajectory of this arm and one of another."""

    def __init__(self, driver, other, *points):
        super().__init__(driver)
        driver.run(1.0)
        self.kept = Library(driver.library_folder)
        self.kept.save(Trajectory("Other", points=points or (to(OUT),), taught_on=other))
        self.kept.save(Trajectory("Ours", points=(to(OUT),), taught_on="PiPER"))
        self.library.refresh()

    def edit(self, name):
        self.library.open_trajectory(name)
        self.window = self.library.editors.used
        return self.window

    def do(self, name):
        self.window._actions[name].trigger()

    def said(self):
        return self.child("editor_message").text()


def test_pasting_points_of_another_arm_is_said(app_driver):
    operator = AtTwo(app_driver, X)
    operator.edit("Other").table.select_row(0)
    operator.do("copy")
    operator.edit("Ours")
    operator.do("paste")
    assert len(operator.window.document.points) == 2
    assert "PiPER X" in operator.said()
    assert "PiPER." in operator.said()
    assert operator.window.document.taught_on == "PiPER"
    operator.do("copy")
    operator.do("paste")
    assert operator.said() == ""


def test_a_file_pasted_says_its_arm_too(app_driver):
    operator = AtTwo(app_driver, X)
    text = log_file.write(operator.kept.load("Other"))
    operator.edit("Ours")
    QGuiApplication.clipboard().setText(text)
    operator.do("paste")
    assert "PiPER X" in operator.said()


def test_an_empty_trajectory_is_of_the_arm_of_what_is_pasted(app_driver):
    operator = AtTwo(app_driver, X)
    operator.kept.save(Trajectory("Empty"))
    operator.library.refresh()
    operator.edit("Other").table.select_row(0)
    operator.do("copy")
    operator.edit("Empty")
    operator.do("paste")
    assert operator.said() == ""
    assert operator.window.document.taught_on == X


@pytest.mark.parametrize("model", list(PiperModel))
@pytest.mark.parametrize("older", [False, True])
def test_zeros_that_are_converted_hold_the_flange_where_it_was(model, older):
    arm = ModelFit(model, frozenset({model}), older_zeros=older)
    theirs = arm._replace(older_zeros=not older)
    by_deg = arm.zeros_from_deg(theirs.kind)
    assert by_deg is not None
    assert [joint for joint, turn in enumerate(by_deg, 1) if turn] == [2, 3]
    points = (joint(*HERE), pose((300, 0, 250, 0, 85, 0)))
    angles, as_pose = turned(points, by_deg)
    before = Kinematics(theirs.geometry).forward(HERE)
    assert Kinematics(arm.geometry).forward(angles.target) == pytest.approx(before, abs=1e-9)
    assert as_pose is points[1], "the base is where it was"


def test_nothing_is_converted_between_models_or_for_an_arm_that_is_not_known():
    arm = ModelFit(fitting=frozenset({PiperModel.PIPER}))
    assert arm.zeros_from_deg(OLD) == (0.0, -2.0, 2.0, 0.0, 0.0, 0.0)
    assert arm.zeros_from_deg(X) is None
    assert arm.zeros_from_deg(arm.kind) is None
    assert arm.zeros_from_deg("") is None
    assert ModelFit().zeros_from_deg(OLD) is None


def test_the_operator_converts_zeros_and_undoes_it(app_driver):
    there = pose((300, 0, 250, 0, 85, 0))
    operator = AtTwo(app_driver, OLD, to(OUT), there)
    operator.edit("Other")
    assert "zeros before" in operator.child("editor_other_arm").text()
    run, convert = operator.child("run_send"), operator.child("convert_zeros")
    assert [one.property("primary") for one in (convert, run)] == [True, False]
    operator.click("convert_zeros")
    assert [one.property("primary") for one in (convert, run)] == [False, True]
    document = operator.window.document
    j1, j2, j3, *rest = OUT
    assert document.points[0].target == pytest.approx((j1, j2 - 2.0, j3 + 2.0, *rest))
    assert document.points[1] == there
    assert document.taught_on == "PiPER"
    assert not operator.child("editor_other_arm").isVisible()
    assert "poses stay" in operator.said()
    operator.do("undo")
    assert (document.points[0].target, document.taught_on) == (OUT, OLD)
    assert operator.child("convert_zeros").isVisible()
    assert [one.property("primary") for one in (convert, run)] == [True, False]
    operator.do("redo")
    operator.window.save()
    kept = operator.kept.load("Other")
    assert (kept.taught_on, kept.points[0].target[1]) == ("PiPER", pytest.approx(j2 - 2.0))


def test_converted_points_that_were_not_saved_are_not_converted_twice(app_driver):
    operator = AtTwo(app_driver, OLD)
    operator.edit("Other")
    operator.click("convert_zeros")
    converted, kept = operator.window.document.trajectory(), operator.kept.load("Other")
    assert isinstance(kept, Trajectory)
    page = EditorPage(
        app_driver.controller,
        operator.window._run_bar._checks,
        operator.window._run_bar._shared,
        LibraryWork(operator.kept, operator.window._work._background, app_driver.window),
        kept,
        draft=converted,
    )
    assert page.document.taught_on == "PiPER"
    page.document.stack.undo()
    page.document.stack.undo()
    assert (page.document.taught_on, page.document.points[0].target) == (OLD, OUT)
    page.deleteLater()
