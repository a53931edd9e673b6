"""A message below a table takes its room from the table's lower end: nothing that is used moves."""

import pytest
from PySide6.QtWidgets import QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from tests.operator.workspace.actions import rect_in_window

pytestmark = pytest.mark.styled

SIZES = [(1280, 800), (1440, 900)]


def settle(pages):
    pages.driver.window.layout().activate()
    pages.driver.run(0.1)


def places(pages, names):
    found = {}
    for name in names:
        (widget,) = pages.visible(QWidget, name)
        found[name] = rect_in_window(widget)
    return found


@pytest.mark.parametrize("size", SIZES)
def test_in_the_editor(pages, size):
    pages.driver.ready()
    editor = pages.open_editor()
    pages.driver.window.resize(*size)
    pages.driver.click("editor_jog")
    settle(pages)
    message = pages.driver.find("editor_message")
    stay = ("run_send", "box_plus_1", "box_minus_6", "box_insert", "editor_save", "run_cycles")
    before = places(pages, stay)
    rows = [editor.table.visualRect(editor.model.index(row, 0)) for row in range(2)]
    assert not message.isVisible()
    editor.save()
    settle(pages)
    assert message.isVisible()
    assert places(pages, stay) == before
    assert [editor.table.visualRect(editor.model.index(row, 0)) for row in range(2)] == rows
    assert not rect_in_window(message).intersects(rect_in_window(editor.table))
    pages.driver.click("editor_check")
    settle(pages)
    assert editor.findChild(QWidget, "findings_title").isVisible()
    assert places(pages, stay) == before


@pytest.mark.parametrize("size", SIZES)
def test_in_the_library(pages, size):
    page = pages.open_library()
    pages.driver.window.resize(*size)
    settle(pages)
    before = places(pages, ("run_send", "library_import"))
    pages.driver.find("library_table").choose(["two"], show=True)
    pages.driver.click("library_delete")
    settle(pages)
    message, undo = (pages.driver.find(name) for name in ("library_message", "library_undo"))
    assert message.isVisible()
    assert undo.isVisible()
    assert places(pages, ("run_send", "library_import")) == before
    message.show_message("")
    settle(pages)
    right = page.mapTo(pages.driver.window, page.rect().topRight()).x()
    assert rect_in_window(undo).right() == right
    assert undo.width() <= undo.sizeHint().width()


def test_what_has_no_points_is_not_sent_from_the_library(pages):
    Library(pages.driver.library_folder).save(Trajectory("empty"))
    pages.driver.ready()
    pages.open_library()
    pages.driver.find("library_table").choose(["empty"], show=True)
    send = pages.driver.find("run_send")
    assert not send.isEnabled()
    assert "no points" in send.toolTip()
    pages.driver.find("library_table").choose(["one"], show=True)
    assert send.isEnabled()


def test_six_points_are_seen_beside_the_jog_buttons_at_1280_800(pages):
    pages.driver.ready()
    editor = pages.open_editor()
    pages.driver.window.resize(1280, 800)
    pages.driver.click("editor_jog")
    for _ in range(4):
        pages.driver.click("box_insert")
    settle(pages)
    viewport = editor.table.viewport().rect()
    rows = [editor.table.visualRect(editor.model.index(row, 0)) for row in range(6)]
    assert all(viewport.contains(row.topLeft()) for row in rows)
    assert viewport.contains(rows[-1].bottomLeft())


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_first_point_moves_no_jog_button(pages, size, language):
    Library(pages.driver.library_folder).save(Trajectory("empty"))
    pages.driver.ready()
    pages.driver.store.change(language=language)
    editor = pages.open_editor("empty")
    pages.driver.window.resize(*size)
    if not editor.findChild(QWidget, "editor_jog").isChecked():
        pages.driver.click("editor_jog")
    settle(pages)
    stay = ("run_send", "box_plus_1", "box_plus_5", "box_insert")
    before = places(pages, stay)
    pages.driver.click("box_insert")
    effective = editor.findChild(QWidget, "run_effective")
    pages.driver.wait(lambda: "≈" in effective.text())
    settle(pages)
    assert places(pages, stay) == before
