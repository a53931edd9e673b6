"""The window 导出 by clicks: what it asks for, what the operator reads, what is cancelled."""

from __future__ import annotations

import math
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QToolButton
from pytestqt.qtbot import QtBot

from armui.export.process import ExportDone
from armui.protocol.generation import Generation, PiperModel
from armui.session.batch_builder import LOG_NO_TIMES
from armui.session.exports.request import (
    ArmOptions,
    ExportFormat,
    ExportProblem,
    ExportProgress,
    ExportRequest,
)
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.watch import export_dialog
from armui.ui.watch.export_dialog import ExportDialog
from tests.ui.dialog_reading import message, shown
from tests.ui.fake_controller import FakeController

LEFT = Qt.MouseButton.LeftButton
LOG = Path("/records/run.blf")
REPORT = {
    "items": 1234, "frames": 5678, "generation": 2, "why_generation": "", "firmware": "",
    "model": "PiPER", "why_model": "", "pose_fits": "",
    "offset": 0, "channel": "can0", "other_channels": [], "of_other_channels": 0,
    "not_understood": 0, "questions": 0, "without_stamp": 0, "damages": [], "damage_count": 0,
    "notes": [],
}  # fmt: skip


class Exports:
    """Exports that a test answers."""

    def __init__(self) -> None:
        self.requests: list[ExportRequest] = []
        self.cancelled = 0
        self.on_answer: Any = None

    def __call__(self, request, on_answer):
        self.requests.append(request)
        self.on_answer = on_answer
        return self

    def end(self) -> None:
        self.cancelled += 1


@pytest.fixture
def exports() -> Exports:
    return Exports()


@pytest.fixture
def dialog(qtbot: QtBot, exports: Exports) -> ExportDialog:
    dialog = ExportDialog(FakeController().as_real, None, exports)
    shown(qtbot, dialog)
    return dialog


def choose(dialog: ExportDialog, name: str) -> None:
    button = dialog.findChild(QToolButton, name)
    assert button is not None
    QTest.mouseClick(button, LEFT)


def press_export(dialog: ExportDialog) -> None:
    QTest.mouseClick(dialog.export_button, LEFT)


def remarks(dialog: ExportDialog) -> str:
    return dialog.findChild(QLabel, "export_remarks").text()


def test_nothing_is_exported_without_a_recording(dialog, exports):
    assert not dialog.export_button.isEnabled()
    assert dialog.export_button.toolTip() == "Choose the log first."
    press_export(dialog)
    assert exports.requests == []


def test_what_is_entered_is_asked_for(dialog, exports):
    dialog.show_log(LOG)
    choose(dialog, "format_csv")
    choose(dialog, "generation_1")
    QTest.keyClicks(dialog.form.begin_field, "1.5")
    QTest.keyClicks(dialog.form.end_field, "20")
    QTest.keyClicks(dialog.form.channel_field, "can1")
    dialog.form.model_box.setCurrentText("PiPER X")
    press_export(dialog)
    assert exports.requests == [
        ExportRequest(
            LOG, Path("/records/run.csv"), ExportFormat.CSV, 1.5, 20.0,
            ArmOptions(Generation.ONE, None, "can1", PiperModel.PIPER_X),
        )
    ]  # fmt: skip


def test_without_entries_everything_is_exported(dialog, exports):
    dialog.show_log(LOG)
    press_export(dialog)
    (request,) = exports.requests
    assert request == ExportRequest(LOG, Path("/records/run.mcap"), ExportFormat.MCAP)
    assert (request.begin_s, request.end_s) == (0.0, math.inf)


def test_a_target_that_was_chosen_keeps_its_folder(dialog, exports):
    dialog.show_log(LOG)
    dialog.form.show_target(Path("/elsewhere/mine.mcap"))
    choose(dialog, "format_parquet")
    press_export(dialog)
    assert exports.requests[0].target == Path("/elsewhere/mine.parquet")


@pytest.mark.parametrize(("begin", "end"), [("5", "5"), ("5", "4"), ("x", ""), ("-1", "")])
def test_a_time_that_makes_no_sense_is_said(dialog, exports, begin, end):
    dialog.show_log(LOG)
    QTest.keyClicks(dialog.form.begin_field, begin)
    QTest.keyClicks(dialog.form.end_field, end)
    assert not dialog.export_button.isEnabled()
    assert message(dialog) == "The time must begin at 0 s or later, and end after that."
    press_export(dialog)
    assert exports.requests == []


def test_progress_and_the_end_are_shown(qtbot, dialog, exports):
    dialog.show_log(LOG)
    press_export(dialog)
    assert not dialog.form.isEnabled()
    assert not dialog.export_button.isEnabled()
    exports.on_answer(ExportProgress(0.25, 1000))
    qtbot.waitUntil(lambda: dialog.progress.value() == 250)
    assert message(dialog) == "Exporting… 1,000 frames read"
    exports.on_answer(ExportDone(report=REPORT))
    qtbot.waitUntil(dialog.export_button.isEnabled)
    assert message(dialog) == f"Saved: {Path('/records/run.mcap')} (1,234 messages)"
    assert remarks(dialog) == "5,678 frames read as generation 2, PiPER."
    assert not dialog.progress.isVisible()
    choose(dialog, "format_csv")
    assert (message(dialog), remarks(dialog)) == ("", "")


def test_damage_other_channels_and_foreign_frames_are_said(qtbot, dialog, exports):
    dialog.show_log(LOG)
    choose(dialog, "format_csv")
    press_export(dialog)
    more = {
        "damage_count": 3, "damages": [["line 7", "'x'", 6, False]], "other_channels": ["can1"],
        "of_other_channels": 50, "not_understood": 4, "notes": [asdict(LOG_NO_TIMES())],
    }  # fmt: skip
    exports.on_answer(ExportDone(report={**REPORT, **more}))
    qtbot.waitUntil(dialog.export_button.isEnabled)
    assert message(dialog) == f"Saved: {Path('/records/run.csv')} (1,234 rows)"
    assert remarks(dialog).split("\n") == [
        "Unreadable places in the log: 3; the first: line 7 ('x'). Everything else was exported.",
        LOG_NO_TIMES.source,
        "Only channel can0 was exported; 50 frames of can1 were left out.",
        "5,678 frames read as generation 2, PiPER. 4 of them do not belong to the arm.",
    ]


@pytest.mark.parametrize("problem", [None, *ExportProblem])
def test_every_problem_has_words(qtbot, dialog, exports, problem):
    dialog.show_log(LOG)
    press_export(dialog)
    exports.on_answer(ExportDone(problem, "why"))
    qtbot.waitUntil(dialog.export_button.isEnabled)
    assert message(dialog)
    assert "{" not in message(dialog)


@pytest.mark.parametrize("answer", [True, False])
def test_a_file_that_is_there_is_replaced_only_when_the_operator_says_so(
    qtbot, dialog, exports, answer
):
    dialog.show_log(LOG)
    press_export(dialog)
    exports.on_answer(ExportDone(ExportProblem.EXISTS, "/records/run.mcap"))
    qtbot.waitUntil(lambda: dialog.findChild(ConfirmDialog) is not None)
    question = dialog.findChild(ConfirmDialog)
    assert str(Path("/records/run.mcap")) in question.text()
    QTest.mouseClick(question.action_button if answer else question.cancel_button, LEFT)
    assert [each.replace for each in exports.requests] == ([False, True] if answer else [False])


@pytest.mark.parametrize("way", ["button", "close", "escape"])
def test_cancelled_by_button_close_and_escape(qtbot, dialog, exports, way):
    dialog.show_log(LOG)
    press_export(dialog)
    if way == "button":
        assert dialog.close_button.text() == "Cancel the export"
        QTest.mouseClick(dialog.close_button, LEFT)
        assert dialog.isVisible()
    elif way == "close":
        dialog.close()
    else:
        QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert exports.cancelled == 1
    exports.on_answer(ExportDone(report=REPORT))
    qtbot.wait(20)
    assert message(dialog) == "The export was cancelled; nothing was written."
    assert dialog.export_button.isEnabled()


def test_another_recording_does_not_disturb_an_export(dialog, exports):
    dialog.show_log(LOG)
    press_export(dialog)
    dialog.show_log(Path("/records/other.blf"))
    assert dialog.findChild(QLabel, "export_log").text() == str(LOG)
    assert exports.cancelled == 0


def test_a_folder_of_messages_is_asked_for(dialog, exports, monkeypatch, tmp_path):
    dialog.show_log(LOG)
    choose(dialog, "format_csv-messages")
    assert dialog.form.request().target == Path("/records/run-messages")
    asked = []
    monkeypatch.setattr(export_dialog, "choose_folder", lambda *_, **more: asked.append(more))
    QTest.mouseClick(dialog.form.target_button, LEFT)
    asked[0]["on_chosen"](tmp_path)
    press_export(dialog)
    assert exports.requests == [
        ExportRequest(LOG, tmp_path / "run-messages", ExportFormat.CSV_MESSAGES)
    ]


def test_another_format_has_another_ending(dialog, tmp_path):
    dialog.show_log(LOG)
    choose(dialog, "format_csv-messages")
    dialog.form.show_target(tmp_path / "run-messages")
    choose(dialog, "format_parquet")
    assert dialog.form.request().target == tmp_path / "run.parquet"
