"""An operator at the second level of 轨迹库: points edited by keys, clicks, menu and clipboard."""

import math

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QDropEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory.cells import Column
from armui.trajectory.library import Library
from armui.trajectory.program import GripperOpening, LightAction, Trajectory, Waypoint
from armui.ui.trajectory.cell_editors import CellEditor
from armui.ui.trajectory.editor_window import EditorWindow
from armui.ui.trajectory.leave_question import LeaveQuestion
from armui.ui.trajectory.library_window import LibraryWindow

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
UP = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)


def to(joints_deg, **more):
    return Waypoint(MoveMode.MOVE_J, joints_deg, speed_percent=100, **more)


class Editor:
    """The editor in the operator's hands.

    Attributes:
        window: It.
    """

    def __init__(self, desk, *points, name="Test"):
        self.desk = desk
        self.library = Library(desk.library_folder)
        self.library.save(Trajectory(name, points=points))
        self.window = self.open(name)

    def open(self, name="Test"):
        self.desk.click("library_button")
        self.desk.dialog(LibraryWindow).open_trajectory(name)
        window = self.desk.dialog(EditorWindow)
        self.desk.wait(window.isActiveWindow)
        return window

    @property
    def points(self):
        return self.window.document.points

    @property
    def table(self):
        return self.window.table

    def child(self, name, kind=QWidget):
        return self.window.findChild(kind, name)

    def cell(self, row, column):
        return self.table.visualRect(self.table.model().index(row, column)).center()

    def text(self, row, column):
        return self.table.model().index(row, column).data()

    def choose(self, row, modifier=Qt.KeyboardModifier.NoModifier):
        viewport, place = self.table.viewport(), self.cell(row, Column.SPEED)
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, modifier, place)

    def edit(self, row, column):
        """Double click into a cell; the editor that opens."""
        viewport, place = self.table.viewport(), self.cell(row, column)
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, pos=place)
        QTest.mouseDClick(viewport, Qt.MouseButton.LeftButton, pos=place)
        editors = [each for each in viewport.children() if isinstance(each, CellEditor)]
        assert len(editors) == 1, editors
        return editors[0]

    def type_into(self, row, column, text):
        field = self.edit(row, column)
        assert isinstance(field, QLineEdit)
        field.selectAll()
        QTest.keyClicks(field, text)
        self.enter(field)
        return field

    @staticmethod
    def enter(field):
        """Press Enter in a cell's editor: Qt takes it over a moment later."""
        QTest.keyClick(field, Qt.Key.Key_Return)
        QCoreApplication.processEvents()

    def keys(self, key, modifier=Qt.KeyboardModifier.NoModifier):
        QTest.keyClick(self.table, key, modifier)

    def act(self, name):
        """Choose an entry of the menu of the right button."""
        action = next(
            each for each in self.table.actions() if each.objectName() == f"action_{name}"
        )
        assert action.text()
        action.trigger()

    def click(self, name):
        self.desk.click(self.child(name))

    def message(self):
        return self.child("editor_message").text()


@pytest.fixture
def editor(desk):
    return Editor(desk, to(OUT, note="out"), to(BACK, note="back"), to(UP, note="up"))


def notes(editor):
    return [point.note for point in editor.points]


CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


# Cells --------------------------------------------------------------------------------------------


def test_an_angle_is_typed_undone_and_done_again(editor):
    editor.type_into(1, Column.VALUE_2, "45,5")
    assert editor.text(1, Column.VALUE_2) == "45.500"
    assert editor.window.windowTitle() == "Test *"
    editor.click("editor_undo")
    assert editor.points[1].target == BACK
    assert editor.window.windowTitle() == "Test"
    editor.click("editor_redo")
    assert editor.points[1].target[1] == 45.5


def test_what_cannot_be_is_said_at_the_cell_and_stays_open(editor):
    field = editor.type_into(0, Column.SPEED, "250")
    problem = editor.table.findChild(QWidget, "cell_problem")
    assert problem.isVisible()
    assert field.isVisible()
    assert problem.text()
    below = editor.table.visualRect(editor.table.model().index(0, Column.SPEED)).bottom()
    assert 0 <= problem.y() - below <= 6
    field.selectAll()
    QTest.keyClicks(field, "25")
    editor.enter(field)
    assert not problem.isVisible()
    assert editor.points[0].speed_percent == 25


def test_escape_leaves_a_cell_as_it_was(editor):
    field = editor.edit(0, Column.DWELL)
    QTest.keyClicks(field, "3")
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert editor.points[0].dwell_s == 0.0
    assert editor.window.isVisible()


def test_the_gripper_has_an_editor_of_its_own(editor):
    box = editor.edit(0, Column.GRIPPER)
    kind = editor.table.findChild(QComboBox, "gripper_kind")
    assert box is not None
    kind.setCurrentIndex(1)
    place = editor.table.findChild(QLineEdit, "gripper_place")
    place.selectAll()
    QTest.keyClicks(place, "35")
    editor.enter(place.parentWidget())
    assert editor.points[0].gripper == GripperOpening(35.0, 1.0)
    assert editor.text(0, Column.GRIPPER) == "35mm@1Nm"


def test_so_have_the_lamps(editor):
    editor.edit(1, Column.LIGHT)
    joint = editor.table.findChild(QComboBox, "light_joint")
    joint.setCurrentIndex(3)
    color = editor.table.findChild(QLineEdit, "light_color")
    color.selectAll()
    QTest.keyClicks(color, "255, 128, 0")
    editor.enter(color.parentWidget())
    assert editor.points[1].light == LightAction(3, 255, 128, 0)


def test_another_kind_of_motion_keeps_the_place(editor):
    box = editor.edit(2, Column.MOVE)
    assert isinstance(box, QComboBox)
    box.setCurrentText("MOVE L")
    box.activated.emit(box.currentIndex())
    model = editor.desk.controller.cartesian.kinematics()
    assert editor.points[2].move is MoveMode.MOVE_L
    assert editor.points[2].target == pytest.approx(tuple(model.forward(UP)))
    assert editor.text(2, Column.VALUE_1) == f"{model.forward(UP).x_mm:.3f}"


def test_only_an_arc_has_a_middle(editor):
    index = editor.table.model().index(0, Column.MIDDLE)
    assert not index.flags() & Qt.ItemFlag.ItemIsEditable


# Rows ---------------------------------------------------------------------------------------------


def test_rows_are_inserted_duplicated_moved_and_deleted(editor):
    editor.choose(1)
    editor.keys(Qt.Key.Key_Return, CTRL)
    assert [point.target for point in editor.points] == [OUT, BACK, BACK, UP]
    assert notes(editor) == ["out", "back", "", "up"]
    editor.act("insert_before")
    assert len(editor.points) == 5
    editor.click("editor_undo")
    editor.keys(Qt.Key.Key_Up, ALT)
    assert notes(editor) == ["out", "", "back", "up"]
    editor.keys(Qt.Key.Key_Delete)
    assert notes(editor) == ["out", "back", "up"]
    editor.keys(Qt.Key.Key_D, CTRL)
    assert notes(editor) == ["out", "back", "back", "up"]
    for _ in range(4):
        editor.click("editor_undo")
    assert notes(editor) == ["out", "back", "up"]
    assert not editor.child("editor_undo").isEnabled()


def test_several_rows_are_cut_and_pasted_elsewhere(editor):
    editor.choose(0)
    editor.choose(1, SHIFT)
    editor.keys(Qt.Key.Key_X, CTRL)
    assert notes(editor) == ["up"]
    editor.keys(Qt.Key.Key_V, CTRL)
    assert notes(editor) == ["up", "out", "back"]


def test_rows_of_a_spreadsheet_are_pasted(editor):
    QGuiApplication.clipboard().setText("J1\tJ2\tJ3\tJ4\tJ5\tJ6\n1\t2\t-3\t4\t5\t6\n")
    editor.choose(2)
    editor.act("paste")
    assert editor.points[3].target == (1.0, 2.0, -3.0, 4.0, 5.0, 6.0)


def test_nonsense_is_not_pasted_and_says_where_it_is(editor):
    QGuiApplication.clipboard().setText("1\t2\t3\t4\t5\t6\n1\t2\tx\t4\t5\t6")
    editor.act("paste")
    assert len(editor.points) == 3
    assert "Line 2, column 3" in editor.message()


def test_a_row_is_dragged_to_the_end(editor):
    model, viewport = editor.table.model(), editor.table.viewport()
    editor.choose(0)
    data = model.mimeData(editor.table.selectedIndexes())
    below = QPointF(editor.cell(2, 1)) + QPointF(0, 60)
    drop = QDropEvent(
        below,
        Qt.DropAction.MoveAction,
        data,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
        QEvent.Type.Drop,
    )
    model.dropMimeData(drop.mimeData(), drop.dropAction(), -1, -1, editor.table.rootIndex())
    assert notes(editor) == ["back", "up", "out"]
    assert editor.table.rows() == [2]
    assert viewport.rect().contains(editor.cell(2, 1))
    editor.click("editor_undo")
    assert notes(editor) == ["out", "back", "up"]


def test_joint_angles_become_a_pose_and_back(editor):
    editor.choose(0)
    editor.choose(2, CTRL)
    editor.keys(Qt.Key.Key_K, CTRL)
    assert [point.move.name for point in editor.points] == ["MOVE_P", "MOVE_J", "MOVE_P"]
    editor.choose(0)
    editor.keys(Qt.Key.Key_K, CTRL)
    assert editor.points[0].target == pytest.approx(OUT, abs=1e-6)


# The arm ------------------------------------------------------------------------------------------


def test_the_current_pose_without_an_arm_is_refused(editor):
    editor.act("insert_measured")
    assert len(editor.points) == 3
    assert "No arm is connected" in editor.message()


def test_the_current_pose_is_the_measured_one(desk):
    editor = Editor(desk, to(OUT))
    desk.ready()
    desk.controller.motion.send_joints(BACK)
    desk.run_until(lambda: math.dist(desk.firmware.joints_deg, BACK) < 1e-3)
    desk.run(0.2)
    editor.choose(0)
    editor.act("insert_measured")
    assert editor.points[1].target == pytest.approx(BACK, abs=1e-3)
    editor.choose(0)
    editor.act("replace_by_measured")
    assert editor.points[0].target == pytest.approx(BACK, abs=1e-3)


def test_the_arm_goes_to_the_point(desk):
    editor = Editor(desk, to(OUT), to(BACK))
    desk.ready()
    editor.choose(1)
    editor.keys(Qt.Key.Key_G, CTRL)
    desk.run_until(lambda: math.dist(desk.firmware.joints_deg, BACK) < 0.01)


def test_the_arm_goes_to_a_pose(desk):
    editor = Editor(desk, to(OUT), to(BACK))
    desk.ready()
    editor.choose(0)
    editor.keys(Qt.Key.Key_K, CTRL)
    editor.act("go_to")
    desk.run_until(lambda: math.dist(desk.firmware.joints_deg, OUT) < 0.05)


def test_a_motor_that_is_off_is_told(desk):
    editor = Editor(desk, to(OUT))
    desk.connect()
    editor.act("go_to")
    assert "enable" in editor.message().lower()


# Find and replace ---------------------------------------------------------------------------------


def test_a_note_is_found_and_replaced(editor):
    QTest.keyClick(editor.window, Qt.Key.Key_F, CTRL)
    find = editor.child("find_text")
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


# Saving -------------------------------------------------------------------------------------------


def test_saved_points_are_in_the_library(editor):
    editor.type_into(0, Column.DWELL, "1.5 s")
    QTest.keyClick(editor.window, Qt.Key.Key_S, CTRL)
    assert editor.library.load("Test").points[0].dwell_s == 1.5
    assert editor.message() == "Saved."
    editor.window.close()
    assert not editor.window.isVisible()


def test_closing_with_changes_asks_and_saves(editor):
    editor.type_into(0, Column.DWELL, "2")
    editor.window.close()
    question = editor.desk.dialog(LeaveQuestion)
    editor.desk.click(question.cancel_button)
    assert editor.window.isVisible()
    editor.window.close()
    editor.desk.click(editor.desk.dialog(LeaveQuestion).save_button)
    assert not editor.window.isVisible()
    assert editor.library.load("Test").points[0].dwell_s == 2.0


def test_changes_can_be_discarded(editor):
    editor.type_into(0, Column.DWELL, "2")
    editor.window.close()
    editor.desk.click(editor.desk.dialog(LeaveQuestion).action_button)
    assert editor.library.load("Test").points[0].dwell_s == 0.0
    assert editor.library.drafts() == []


def test_changes_survive_a_crash(editor):
    editor.type_into(0, Column.DWELL, "2")
    editor.desk.wait(lambda: editor.library.drafts() == ["Test"])
    # the program is gone without a word: another one opens the same folder
    again = EditorWindow(
        editor.desk.controller,
        editor.library,
        editor.library.load("Test"),
        editor.library.draft("Test"),
    )
    assert again.document.points[0].dwell_s == 2.0
    assert "were not saved" in again.findChild(QWidget, "editor_message").text()
    again.document.stack.undo()
    assert again.document.points[0].dwell_s == 0.0
    again.deleteLater()


def test_the_draft_goes_when_nothing_is_left_to_save(editor):
    editor.type_into(0, Column.DWELL, "2")
    editor.desk.wait(lambda: editor.library.drafts() == ["Test"])
    editor.click("editor_undo")
    editor.desk.wait(lambda: editor.library.drafts() == [])


# Size, words --------------------------------------------------------------------------------------


def test_ten_thousand_points_are_edited_without_a_stall(desk):
    editor = Editor(desk, *(to(OUT, note=str(row)) for row in range(10_000)))
    editor.table.select_row(5000)
    editor.choose(5000)
    editor.keys(Qt.Key.Key_Delete)
    editor.keys(Qt.Key.Key_D, CTRL)
    assert len(editor.points) == 10_000
    assert editor.points[5000].note == "5001"


def test_everything_is_said_in_the_language_chosen(editor):
    editor.desk.store.change(language="zh")
    editor.desk.store.change(language="en")
    titles = [
        editor.table.model().headerData(column, Qt.Orientation.Horizontal) for column in Column
    ]
    assert titles[0] == "Motion"
    assert all(titles)
    assert editor.table.mapTo(editor.window, QPoint(0, 0)).x() >= 0
