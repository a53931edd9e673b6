"""S16: a trajectory knows the arm it was taught on; another one is said, and is to be accepted."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtWidgets import QWidget

from armui.arm.model_check import ModelFit
from armui.protocol.generation import PiperModel
from armui.trajectory.files import json_file, log_file, npz_file
from armui.trajectory.library.store import Library
from armui.trajectory.planning.check import check
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points.program import Trajectory
from armui.trajectory.samples.recording import Recording
from tests.test_operator_running import OUT, Operator, to
from tests.trajectory.arms import ARM, HERE, joint, run

OLD = ModelFit(older_zeros=True).kind
X = ModelFit(PiperModel.PIPER_X).kind
ROWS = np.array([[0.0, *HERE, 10.0], [1.0, *HERE, 10.0]])


def test_kinds_differ_by_model_and_zeros():
    assert ModelFit().kind == "PiPER"
    assert OLD == "PiPER (zeros before S-V1.6-3)"
    assert X == "PiPER X"
    assert ModelFit().taught_on == "", "not compared yet"
    assert ModelFit(fitting=frozenset({PiperModel.PIPER})).taught_on == "PiPER"
    assert ModelFit(fitting=frozenset({PiperModel.PIPER_X})).taught_on == ""


@pytest.mark.parametrize("taught", ["", OLD, X])
def test_files_keep_it(taught):
    content = replace(run(joint(*HERE)), taught_on=taught)
    assert json_file.read(json_file.write(content), "n").taught_on == taught
    assert log_file.read(log_file.write(content), "n").taught_on == taught
    assert pickle.loads(pickle.dumps(content)) == content
    recording = Recording("r", samples=ROWS, taught_on=taught)
    assert npz_file.read(npz_file.write(recording)).taught_on == taught
    assert json_file.read(json_file.write(recording), "n").taught_on == taught
    assert log_file.read(log_file.write(recording), "n").taught_on == taught


def test_older_files_do_not_know():
    text = log_file.write(replace(run(joint(*HERE)), taught_on=""))
    assert "taught_on" not in text
    assert log_file.read(text, "n").taught_on == ""


@pytest.mark.parametrize("taught", [OLD, X])
def test_another_arm_is_a_warning_of_the_check(taught):
    arm = replace(ARM, kind="PiPER")
    content = replace(run(joint(*HERE, speed=30)), taught_on=taught)
    (found,) = check(content, arm, HERE).findings
    assert (found.code, found.severity, found.row) == ("other_arm", Severity.WARNING, None)
    assert dict(found.params) == {"taught": taught, "arm": "PiPER"}
    for same in ("", "PiPER"):
        assert not check(replace(content, taught_on=same), arm, HERE).findings


def test_a_recording_of_another_arm_too():
    content = Recording("r", samples=ROWS, taught_on=X)
    assert "other_arm" in {
        each.code for each in check(content, replace(ARM, kind="P"), HERE).findings
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
    assert "PiPER X" in editor.findChild(QWidget, "editor_message").text()
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
