"""The window «About armui»: version, files of another version, licences."""

import sys
from datetime import UTC, datetime

import pytest

from armui import __version__
from armui.system.version_record import note_version
from armui.ui.background import Background
from armui.ui.dialogs.about import AboutDialog
from tests.app_driver import AtOnce
from tests.ui.dialog_reading import message, words_of
from tests.ui.fake_controller import FakeController


@pytest.fixture
def settings(tmp_path):
    return tmp_path / "settings.json"


@pytest.fixture
def dialog(qtbot, settings):
    dialog = AboutDialog(FakeController().as_real, Background(AtOnce()), settings)
    qtbot.addWidget(dialog)
    return dialog


def test_it_tells_the_version_and_shows_the_lgpl(qtbot, dialog):
    dialog.open()
    assert f"armui {__version__} – from the source" in words_of(dialog)
    assert "No files of another version" in words_of(dialog)
    labels = [dialog.list.item(row).text() for row in range(dialog.list.count())]
    assert labels[0].startswith("armui:")
    assert "Permission is hereby granted" in dialog.text.toPlainText()
    dialog.list.setCurrentRow(labels.index("PySide6-Essentials: LGPL-3.0.txt"))
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in dialog.text.toPlainText()


def test_it_tells_what_was_taken_over(dialog, settings, tmp_path):
    settings.write_text("{}")
    (tmp_path / "t").mkdir()
    (tmp_path / "t" / "one.log").touch()
    note_version("0.3.0", settings, {"trajectories": tmp_path / "t"}, datetime.now(UTC))
    dialog.open()
    said = words_of(dialog)
    assert "Files of an older version were taken over by 0.3.0 on " in said
    assert "settings yes, trajectories 1, logs 0." in said


def test_texts_that_were_not_installed_are_told(monkeypatch, dialog, tmp_path):
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "armui"))
    dialog.open()
    if dialog.list.count() == 0:  # this computer has no package of ours
        assert "release" in message(dialog)
    assert "installed package" in words_of(dialog)
