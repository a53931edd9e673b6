"""The part below a pose: an arc by three poses, or the tool centre point, one at a time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractButton,
    QLabel,
    QStackedWidget,
    QWidget,
)

from armui.arm.refusal import Reason, Refusal
from armui.control.motion.cartesian import Cartesian
from armui.kinematics.axes import AXES, LINEAR_AXES
from armui.protocol.codes import MoveMode
from armui.ui import format as fmt
from armui.ui.actions.act import Act, ActFamily, HasActs
from armui.ui.actions.command import with_pose
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import caption, choice_group
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import empty_grid, in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.cell.cell_control import CellControl

ARC_INCOMPLETE = Reason(
    "arc_incomplete", "Not captured yet: {point}. Bring the arm there and press its button."
)


Pose = tuple[float, ...]
_POINTS: Final[Mapping[str, Text]] = {
    "start": Text("ArcBox", "Capture start"),
    "middle": Text("ArcBox", "Capture middle"),
    "end": Text("ArcBox", "Capture end"),
}
_TEXT_SCALE: Final = 0.85


class ToolBox(Translated, QWidget):
    """Six small fields, which take effect as soon as a field is left."""

    changed = Signal(object)
    """Emitted with the six figures as typed; an invalid one as its text."""

    def __init__(self) -> None:
        super().__init__()
        self._title = text_label(rank="muted", wraps=True)
        self._fields = [FigureField(fmt.DECIMALS) for _ in AXES]
        grid = empty_grid(self, gaps=(8, 2), margins=0)
        grid.addWidget(self._title, 0, 0, 1, 6)
        for place, (name, field) in enumerate(zip(AXES, self._fields, strict=True)):
            row, column = 1 + place // LINEAR_AXES, 2 * (place % LINEAR_AXES)
            field.setObjectName(f"tool_field_{name}")
            grid.addWidget(QLabel(name), row, column)
            grid.addWidget(field, row, column + 1)
            grid.setColumnStretch(column + 1, 1)
            field.editingFinished.connect(self._on_finished)
        grid.setRowStretch(grid.rowCount(), 1)
        self._cell_tool: str | None = None
        self.retranslate_ui()

    def name_tool(self, cells: CellControl) -> None:
        """Say which tool the figures are of; those of a cell are changed in its own panel."""
        self._cell_tool = None if cells.in_force is None else cells.tool_name
        for field in self._fields:
            field.setReadOnly(self._cell_tool is not None)
        self._name()

    def show_tool(self, tool: Sequence[float]) -> None:
        """Set the fields to the figures in force."""
        for field, value in zip(self._fields, tool, strict=True):
            field.show_value(value)
            field.show_attention(wanted=False)

    def mark(self, *, wrong: bool) -> None:
        """Mark the invalid fields, or those that were refused."""
        for field in self._fields:
            field.show_attention(wanted=wrong and (field.value is None or abs(field.value) > 180))

    def _name(self) -> None:
        if self._cell_tool is None:
            text = self.tr("Tool centre point relative to the flange (mm, °), saved on this PC")
        elif self._cell_tool:
            text = self.tr("Tool “{name}” of the cell (mm, °); it is changed under Cell")
        else:
            text = self.tr("The cell has no tool chosen; one is chosen under Cell")
        self._title.setText(text.format(name=self._cell_tool))

    def _on_finished(self) -> None:
        if self._cell_tool is not None:
            return
        self.changed.emit(
            tuple(
                field.text() or fmt.NOTHING if field.value is None else field.value
                for field in self._fields
            )
        )

    def retranslate_ui(self) -> None:
        """Set the names in the operator's language."""
        self._name()
        for name, field in zip(AXES, self._fields, strict=True):
            field.setAccessibleName(self.tr("Tool {axis}").format(axis=name))


class ArcBox(HasActs, Translated, QWidget):
    """Three poses, each captured from the arm, and the two buttons that use them.

    Args:
        controller: Gives the frame in which poses are shown, and the reasons.
    """

    capture_wanted = Signal(int)
    """Emitted to capture a pose from the arm, with its index 0–2."""
    wanted = Signal(object)
    """Emitted with what sends a motion to the start or along the arc; see :func:`drive`."""

    captures = ActFamily(
        {
            place: Act(
                text,
                named=f"capture_{point}",
                tip="Captures the arm's present pose; nothing moves.",
                key=f"cartesian.capture_{point}",
                needs=with_pose,
            )
            for place, (point, text) in enumerate(_POINTS.items())
        }
    )
    go_to_start = Act(
        "Go to start",
        named="arc_start_button",
        does=Cartesian.move,
        tip="Moves to the captured start with MOVE P.",
        key="cartesian.arc_start",
        title=Text("ArcBox", "Go to start"),
        leads=True,  # the page shows which poses are captured
    )
    send = Act(
        "MOVE C",
        named="move_c_button",
        does=Cartesian.move_arc,
        tip="Moves from the start through the middle to the end. Some firmware has no arcs.",
        key="cartesian.move_c",
        title=Text("Action", "MOVE C: along the arc"),
        leads=True,
    )

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self.poses: list[Pose | None] = [None, None, None]
        self._texts = [text_label(f"captured_{point}", rank="muted") for point in _POINTS]
        grid = empty_grid(self, gaps=(6, 3), margins=0)
        captures = self.captures.values()
        for place, (button, text) in enumerate(zip(captures, self._texts, strict=True)):
            button.setProperty("compact", True)
            text.setAlignment(Qt.AlignmentFlag.AlignCenter)
            text.setFont(scaled_font(text, _TEXT_SCALE))
            grid.addWidget(button, 0, place)
            grid.addWidget(text, 1, place)
            grid.setColumnStretch(place, 1)
        buttons = in_row((self.go_to_start, 1), (self.send, 1), spacing=6)
        grid.addLayout(buttons, 2, 0, 1, len(_POINTS))
        grid.setRowStretch(3, 1)
        self.retranslate_ui()

    @captures.why_not
    def _why_no_pose(self, _place: int) -> Refusal | None:
        return self._controller.cell.why_no_pose()

    @captures.pressed
    def _on_capture(self, place: int) -> None:
        self.capture_wanted.emit(place)

    @go_to_start.why_not
    def _why_no_start(self) -> Refusal | None:
        return self._why_not(1)

    @send.why_not
    def _why_no_arc(self) -> Refusal | None:
        return self._why_not(len(self.poses))

    def _why_not(self, poses: int) -> Refusal | None:
        """Return why the arm cannot move now, or which of the first poses is not captured."""
        names = (self.tr("start"), self.tr("middle"), self.tr("end"))
        pairs = zip(names[:poses], self.poses, strict=False)
        missing = next((name for name, pose in pairs if pose is None), None)
        incomplete = None if missing is None else ARC_INCOMPLETE(point=missing)
        return self._controller.operating_state.cannot_move or incomplete

    @go_to_start.pressed
    def _on_go_to_start(self) -> None:
        if (start := self.poses[0]) is not None:
            move = self._controller.cartesian.move
            self.wanted.emit(lambda agreed_mm: move(start, MoveMode.MOVE_P, agreed_mm))

    @send.pressed
    def _on_send(self) -> None:
        points = [pose for pose in self.poses if pose is not None]
        move = self._controller.cartesian.move_arc
        self.wanted.emit(lambda agreed_mm: move(*points, agreed_mm=agreed_mm))

    def take(self, place: int, pose: Pose) -> None:
        """Set a captured pose."""
        self.poses[place] = pose
        self._show_poses()

    def clear(self) -> None:
        """Clear all poses."""
        self.poses = [None, None, None]
        self._show_poses()

    def _show_poses(self) -> None:
        self.show_acts()
        for text, pose in zip(self._texts, self.poses, strict=True):
            if pose is None:
                text.setText(fmt.NOTHING)
                text.setToolTip("")
                continue
            shown = self._controller.cartesian.in_frame(pose)
            text.setText(f"{' '.join(fmt.number(value, 0) for value in shown[:3])} mm")
            text.setToolTip(fmt.pose(shown, 1))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._show_poses()


class PoseExtras(Translated, QWidget):
    """Two buttons, of which the chosen one shows its part: so both fit on a low screen.

    Args:
        arc, tool: The parts to show.
    """

    def __init__(self, arc: ArcBox, tool: ToolBox) -> None:
        super().__init__()
        self._group = choice_group(self, ("extra_arc", "extra_tool"))
        self._stack = QStackedWidget()
        for widget in (arc, tool):
            self._stack.addWidget(widget)
        row = in_row(*((button, 1) for button in self.buttons), spacing=6)
        self._group.idClicked.connect(self._stack.setCurrentIndex)
        in_column(row, self._stack, on=self, spacing=6, margins=0)
        self.retranslate_ui()

    @property
    def buttons(self) -> list[QAbstractButton]:
        """The buttons for the arc and the tool, in this order."""
        return self._group.buttons()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for place, text in enumerate((self.tr("Arc by three poses"), self.tr("Tool centre point"))):
            caption(self._group.button(place), text)
