"""The strip of views, the note over the picture, and the picture as a file."""

from types import SimpleNamespace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QToolButton, QWidget

from armui.control.events import Level
from armui.settings import SettingsStore
from armui.ui.background import Background
from armui.ui.picture.picture_note import PictureNote
from armui.ui.picture.picture_work import PictureExport
from armui.ui.picture.view_bar import ViewBar
from armui.viewport.camera import ViewDirection
from armui.viewport.viewpoint import ViewMode
from tests.app_driver import AtOnce
from tests.ui.fake_view import FakeView

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def store(tmp_path):
    return SettingsStore(tmp_path / "settings.json")


@pytest.fixture
def view(qtbot):
    view = FakeView()
    qtbot.addWidget(view)
    return view


@pytest.fixture
def bar(qtbot, view, store):
    bar = ViewBar(view, store)
    qtbot.addWidget(bar)
    bar.show()
    return bar


@pytest.mark.parametrize("direction", ViewDirection)
def test_each_view_is_in_the_menu_and_is_kept(bar, view, store, direction):
    offered = bar.findChild(QToolButton, "view_from_button").menu().actions()
    assert len(offered) == len(ViewDirection)
    next(each for each in offered if each.objectName() == f"view_{direction.value}").trigger()
    assert view.looked_from == [direction]
    assert SettingsStore(store.path).settings.picture_direction == direction.value


def test_every_view_has_a_key_of_its_own_and_says_it(bar):
    actions = bar.view_actions
    keys = [action.shortcut().toString() for action in actions.values()]
    assert len(set(keys)) == len(keys)
    assert "Ctrl+1" in actions["front"].toolTip()
    for button in bar.findChildren(QToolButton):
        assert button.accessibleName()
        assert button.toolTip()


def test_following_is_shown_until_somebody_ends_it(bar, view):
    follow = bar.view_actions["follow"]
    follow.trigger()
    assert view.mode is ViewMode.FOLLOW
    view.mode = ViewMode.FREE  # the operator has moved the picture
    view.view_changed.emit()
    assert not follow.isChecked()


def test_what_is_chosen_of_the_picture_is_kept(bar, view, store):
    bar.view_actions["orthographic"].trigger()
    bar.view_actions["tool_frame"].trigger()
    assert (view.orthographic, view.tool_frame) == (True, False)
    kept = SettingsStore(store.path).settings
    assert (kept.picture_orthographic, kept.picture_tool_frame) == (True, False)


@pytest.fixture
def export(controller, view, qtbot):
    window = QWidget()
    qtbot.addWidget(window)
    export = PictureExport(controller, view, Background(AtOnce()), window)
    said = []
    export.message_changed.connect(lambda text, level: said.append((text, level)))
    return SimpleNamespace(export=export, said=said)


def test_no_picture_of_before_is_taken_for_one_of_now(export, view):
    export.export.copy()
    export.export.save()
    assert [level for _text, level in export.said] == [Level.WARNING] * 2


def test_the_picture_goes_to_the_clipboard_and_to_a_file(export, view, tmp_path):
    picture = QImage(30, 20, QImage.Format.Format_RGB32)
    picture.fill(0x336699)
    view.is_current, view.grab_picture = True, lambda: picture
    export.export.copy()
    assert QGuiApplication.clipboard().image().size() == picture.size()
    path = tmp_path / "picture.png"
    export.export.write(picture, path)
    assert QImage(str(path)).pixelColor(3, 3).name() == "#336699"
    assert [level for _text, level in export.said] == [Level.DONE] * 2


def test_a_picture_that_cannot_be_written_is_said(export, tmp_path):
    picture = QImage(30, 20, QImage.Format.Format_RGB32)
    export.export.write(picture, tmp_path / "no folder" / "picture.png")
    ((text, level),) = export.said
    assert level is Level.FAULT
    assert "no folder" in text


def test_a_note_goes_away_by_itself_and_one_that_stays_does_not(qtbot):
    note = PictureNote()
    qtbot.addWidget(note)
    note.show_message("Saved", Level.DONE)
    assert note.isVisible()
    assert note._end.isActive()
    note.show_message("Out of reach", Level.WARNING, stays=True)
    assert not note._end.isActive()
    note.show_message("")
    assert not note.isVisible()
