"""The window: finding and replacing, saving and leaving, its language."""

import pytest
from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QWidget

from armui.control.run.preflight import Checks
from armui.protocol.codes import MoveMode
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import Waypoint
from armui.ui.background import Background
from armui.ui.dialogs.confirm_dialog import LeaveQuestion
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.running.run_bar import RunChoices
from tests.app_driver import AtOnce
from tests.operator.editor.actions import BACK, CTRL, OUT, UP, Editor, notes, to

pytestmark = pytest.mark.styled

# Find and replace ---------------------------------------------------------------------------------


def test_a_note_is_found_and_replaced(editor):
    QTest.keyClick(editor.window, Qt.Key.Key_F, CTRL)
    find = editor.child("find_text")
    for name in ("find_next", "find_previous", "replace_one", "replace_all"):
        assert not editor.child(name).isEnabled()
        assert editor.child(name).toolTip() == "Type what to find first."
    QTest.keyClicks(find, "ba")
    QTest.keyClick(find, Qt.Key.Key_Return)
    assert editor.table.current_row() == 1
    assert editor.child("find_result").text() == "1 of 1"
    QTest.keyClicks(editor.child("replace_text"), "wo")
    editor.click("replace_one")
    assert notes(editor) == ["out", "wock", "up"]
    editor.click("find_close")
    assert not find.isVisible()


def test_a_figure_is_replaced_everywhere_as_one_step(editor):
    editor.click("editor_find")
    field = editor.child("find_field", QComboBox)
    field.setCurrentIndex(field.findData("speed"))
    QTest.keyClicks(editor.child("find_text"), "100")
    QTest.keyClicks(editor.child("replace_text"), "40 %")
    editor.click("replace_all")
    assert [point.speed_percent for point in editor.points] == [40, 40, 40]
    editor.click("editor_undo")
    assert [point.speed_percent for point in editor.points] == [100, 100, 100]


def test_an_angle_beyond_the_limits_of_its_joint_replaces_none(editor):
    editor.click("editor_find")
    field = editor.child("find_field", QComboBox)
    field.setCurrentIndex(field.findData("J1"))
    before = editor.points
    QTest.keyClicks(editor.child("find_text"), "20")
    QTest.keyClicks(editor.child("replace_text"), "170")
    for name in ("replace_all", "replace_one"):
        editor.choose(0)
        editor.click(name)
        assert "Joint 1: 170° is beyond its limits" in editor.child("find_result").text()
        assert editor.points is before


# Saving -------------------------------------------------------------------------------------------


def test_saved_points_are_in_the_library(editor):
    editor.type_into(0, PointColumn.DWELL, "1.5 s")
    QTest.keyClick(editor.window, Qt.Key.Key_S, CTRL)
    assert editor.library.load("Test").points[0].dwell_s == 1.5
    assert editor.message() == "Saved."
    editor.window.close()
    assert not editor.window.isVisible()


def test_saved_is_said_until_something_is_changed(editor):
    editor.type_into(0, PointColumn.DWELL, "1.5 s")
    QTest.keyClick(editor.window, Qt.Key.Key_S, CTRL)
    assert editor.message() == "Saved."
    editor.click("editor_undo")
    assert editor.message() == ""
    assert editor.window.title.endswith("*")


def test_the_range_of_a_joint_is_not_shown_once_the_editor_is_left(editor, monkeypatch):
    shown = []
    monkeypatch.setattr(
        editor.app_driver.program.view,
        "show_joint_range",
        lambda number, *limits: shown.append(number),
    )
    editor.type_into(0, PointColumn.VALUE_2, "42")
    assert shown[-1] == 2
    editor.window.close()
    editor.app_driver.click(editor.app_driver.dialog(LeaveQuestion).save_button)
    assert not editor.window.isVisible()
    QCoreApplication.processEvents()
    assert shown[-1] is None


def test_the_keys_count_wherever_the_keyboard_is_while_the_editor_is_seen(editor):
    editor.type_into(0, PointColumn.NOTE, "changed")
    main = editor.app_driver.window
    for elsewhere in (main, editor.app_driver.find("menu_motion"), editor.child("trajectory_note")):
        editor.window.document.set_note(f"note {elsewhere.objectName()}", "Note")
        elsewhere.setFocus()
        QTest.keyClick(elsewhere, Qt.Key.Key_S, CTRL)
        assert editor.library.load("Test").note == f"note {elsewhere.objectName()}"
    main.setFocus()
    QTest.keyClick(main, Qt.Key.Key_E, CTRL)
    assert editor.child("findings_title").isVisible()
    editor.app_driver.click("menu_motion")  # the panel is seen now, the editor is not
    editor.window.document.set_note("not seen", "Note")
    QTest.keyClick(main, Qt.Key.Key_S, CTRL)
    assert editor.library.load("Test").note != "not seen"


def test_a_question_keeps_its_keys(editor):
    """What is asked in a window of its own is not answered by keys of the window behind it."""
    editor.window.document.set_note("kept", "Note")
    editor.window.leave()
    question = editor.app_driver.dialog(LeaveQuestion)
    editor.app_driver.wait(question.isActiveWindow)
    QTest.keyClick(question, Qt.Key.Key_S, CTRL)
    assert editor.library.load("Test").note == ""
    question.reject()


def test_closing_with_changes_asks_and_saves(editor):
    editor.type_into(0, PointColumn.DWELL, "2")
    editor.window.close()
    question = editor.app_driver.dialog(LeaveQuestion)
    editor.app_driver.click(question.cancel_button)
    assert editor.window.isVisible()
    editor.window.close()
    editor.app_driver.click(editor.app_driver.dialog(LeaveQuestion).save_button)
    assert not editor.window.isVisible()
    assert editor.library.load("Test").points[0].dwell_s == 2.0


def test_changes_can_be_discarded(editor):
    editor.type_into(0, PointColumn.DWELL, "2")
    editor.window.close()
    editor.app_driver.click(editor.app_driver.dialog(LeaveQuestion).action_button)
    assert editor.library.load("Test").points[0].dwell_s == 0.0
    assert editor.library.drafts() == []


def test_changes_survive_a_crash(editor):
    editor.type_into(0, PointColumn.DWELL, "2")
    editor.app_driver.wait(lambda: editor.library.drafts() == ["Test"])
    # the program is gone without a word: another one opens the same folder
    again = EditorPage(
        editor.app_driver.controller,
        Checks(editor.app_driver.controller, Background(AtOnce())),
        RunChoices(),
        LibraryWork(editor.library, Background(AtOnce()), editor.window),
        editor.library.load("Test"),
        draft=editor.library.draft("Test"),
    )
    assert again.document.points[0].dwell_s == 2.0
    assert "were not saved" in again.findChild(QWidget, "editor_message").text()
    again.document.stack.undo()
    assert again.document.points[0].dwell_s == 0.0
    again.deleteLater()


def test_the_draft_goes_when_nothing_is_left_to_save(editor):
    editor.type_into(0, PointColumn.DWELL, "2")
    editor.app_driver.wait(lambda: editor.library.drafts() == ["Test"])
    editor.click("editor_undo")
    editor.app_driver.wait(lambda: editor.library.drafts() == [])


# Words --------------------------------------------------------------------------------------------


def test_everything_is_said_in_the_language_chosen(editor):
    editor.app_driver.store.change(language="zh")
    editor.app_driver.store.change(language="en")
    titles = [
        editor.table.model().headerData(column, Qt.Orientation.Horizontal) for column in PointColumn
    ]
    assert titles[0] == "Motion\n(flange)"
    assert all(titles)
    assert editor.table.mapTo(editor.window, QPoint(0, 0)).x() >= 0


def test_beside_the_jog_buttons_one_button_is_lit(editor):
    send = editor.child("run_send")
    assert send.property("primary")
    editor.click("editor_jog")
    assert editor.child("box_insert").property("primary")
    assert not send.property("primary")
    editor.click("editor_jog")
    assert send.property("primary")


def test_escape_closes_what_is_open_before_it_leaves(editor):
    """What is typed in a cell or a field first, then find, findings and jog; then the page."""
    page = editor.window
    field = editor.edit(0, PointColumn.SPEED)
    QTest.keyClicks(field, "77")
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert editor.points[0].speed_percent == 100
    note = editor.child("trajectory_note")
    note.setFocus()
    QTest.keyClicks(note, "for the tray")
    QTest.keyClick(note, Qt.Key.Key_Escape)
    assert (note.text(), page.document.note, editor.table.hasFocus()) == ("", "", True)
    for name in ("jog", "check", "find"):
        editor.click(f"editor_{name}")
    editor.table.setFocus()
    panes = [editor.child("find_field"), editor.child("findings_title"), editor.child("jog_box")]
    left = []
    page.closed.connect(lambda: left.append(True))
    for gone in range(3):
        assert [pane.isVisible() for pane in panes] == [False] * gone + [True] * (3 - gone)
        QTest.keyClick(editor.table, Qt.Key.Key_Escape)
    assert not any(pane.isVisible() for pane in panes)
    assert not editor.child("editor_jog").isChecked()
    assert left == []
    QTest.keyClick(editor.table, Qt.Key.Key_Escape)
    assert left == [True]


@pytest.mark.parametrize("size", [(1024, 720), (1280, 800)])
@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_bar_of_the_preview_is_whole_beside_the_jog_box(app_driver, language, size):
    app_driver.ready()
    app_driver.store.change(language=language)
    app_driver.window.resize(*size)
    editor = Editor(app_driver, to(OUT), to(BACK))
    editor.click("editor_jog")
    editor.click("editor_check")
    app_driver.run(0.2)
    bar, close = app_driver.find("preview_bar"), app_driver.find("preview_close")
    assert bar.isVisible()
    assert bar.minimumSizeHint().width() <= bar.width()
    assert close.width() >= close.sizeHint().width()


# Everything in sight ------------------------------------------------------------------------------


@pytest.mark.parametrize("language", ["en", "zh"])
def test_at_1440_every_column_is_in_sight(app_driver, language):
    app_driver.store.change(language=language)
    app_driver.window.resize(1440, 900)
    editor = Editor(app_driver, to((-120.5, 100.0, -100.0, 10.0, 20.0, 15.0)), to(UP))
    app_driver.run(0.1)
    assert not editor.table.horizontalScrollBar().isVisible()
    across = editor.table.horizontalHeader()
    for column in PointColumn:
        if not editor.table.isColumnHidden(column):
            needed_px = across.sectionSizeFromContents(column).width()
            assert across.sectionSize(column) >= needed_px, column
            assert across.sectionSize(column) >= editor.table.sizeHintForColumn(column), column


def test_at_1440_every_column_is_in_sight_beside_an_arc(app_driver):
    app_driver.window.resize(1440, 900)
    middle = (320.0, 50.0, 250.0, 0.0, 85.0, 0.0)
    arc = Waypoint(MoveMode.MOVE_C, (300.0, 100.0, 250.0, 0.0, 85.0, 0.0), middle=middle)
    editor = Editor(app_driver, to(OUT), arc)
    app_driver.run(0.1)
    assert not editor.table.isColumnHidden(PointColumn.MIDDLE)
    assert not editor.table.horizontalScrollBar().isVisible()


def test_the_middle_pose_of_an_arc_is_not_cut(app_driver):
    app_driver.window.resize(1920, 1000)  # a narrow page shortens it: its tooltip is whole
    middle = (320.0, -150.5, 250.0, -178.5, 85.0, -170.5)
    arc = Waypoint(MoveMode.MOVE_C, (300.0, 100.0, 250.0, 0.0, 85.0, 0.0), middle=middle)
    editor = Editor(app_driver, to(OUT), arc)
    app_driver.run(0.1)
    cell = editor.table.model().index(1, PointColumn.MIDDLE)
    wanted, room = editor.table.sizeHintForIndex(cell), editor.table.visualRect(cell)
    assert wanted.width() <= room.width()
    assert wanted.height() <= room.height()


def test_rows_have_buttons(app_driver):
    editor = Editor(app_driver, to(OUT), to(UP))
    editor.choose(0)
    for button in ("insert_after", "move_down", "move_up", "duplicate", "delete"):
        assert editor.child(f"editor_{button}").isVisible()
    app_driver.click(editor.child("editor_duplicate"))
    assert editor.points == (to(OUT), to(OUT), to(UP))
    app_driver.click(editor.child("editor_move_down"))
    assert editor.points == (to(OUT), to(UP), to(OUT))
    app_driver.click(editor.child("editor_delete"))
    assert editor.points == (to(OUT), to(UP))


def test_the_preview_has_a_button_that_plays_it(app_driver):
    editor = Editor(app_driver, to(OUT), to(UP))
    app_driver.click(editor.child("editor_preview"))
    assert app_driver.find("preview_bar").isVisible()
    assert app_driver.read("preview_play") == "Pause"
    app_driver.click("preview_close")
    app_driver.click(editor.child("editor_check"))
    assert app_driver.read("preview_play") == "Play", "a check alone plays nothing"
