"""The edits of the selected rows by the menu of the table, each as one step of undo."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Final, Union

from PySide6.QtCore import QMimeData, QObject
from PySide6.QtGui import QGuiApplication

from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_pose
from armui.control.devices.gripper import GRIPPER_SILENT
from armui.control.operations.started import Started
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.kinematics.poses import tool_pose
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.setting_checks import TOOL_LONGEST_MM
from armui.trajectory.files.errors import TrajectoryFileError
from armui.trajectory.planning.convert import (
    CONVERT_OUT_OF_REACH,
    Conversion,
    RowRefusal,
    converted,
    joints_above,
    pose_of,
    to_move,
)
from armui.trajectory.planning.pasting import copied, kept_from
from armui.trajectory.planning.user_frames import (
    Frames,
    RowsOrRefusal,
    frames_of,
    placed,
    pose_in_frame,
    reframed,
    why_unknown,
)
from armui.trajectory.points import edits
from armui.trajectory.points.clipboard import PastedPoints
from armui.trajectory.points.program import (
    VALUE_COUNT,
    GripperAction,
    GripperAngle,
    GripperOpening,
    Values,
    Waypoint,
    check_text,
)
from armui.ui.trajectory.editor.long_edits import LongEdit

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.trajectory.editor.document import Document
    from armui.ui.trajectory.editor.points_table import PointsTable

GRIPPER_TELLS_ANGLE = Reason(
    "gripper_tells_angle",
    "The gripper tells an angle now, and a point keeps an opening. Move it by an opening in "
    "Gripper control first.",
)
NO_ROWS_CHOSEN = Reason("no_rows_chosen", "No row is chosen. Click one in the table first.")


_ZERO: Final = (0.0,) * VALUE_COUNT
_CONVERTED_AT_ONCE: Final = 10
_REFRAMED_AT_ONCE: Final = 50
_PASTED_AT_ONCE: Final = 200
_COPIED_AT_ONCE: Final = 500
"""The most rows of each edit that are worked out at once, in some 10 ms."""

_TAUGHT_ON: Final = "application/x-armui-taught-on"
"""The format, beside the text in the clipboard, with the arm the points were taught on."""
_TOOL: Final = "application/x-armui-tool"
"""The format with the tool whose poses the text holds: six figures, zeros for the flange."""


@dataclass(frozen=True, slots=True)
class OfOtherArm:
    """The warning that pasted points were taught on another arm than the present ones.

    Attributes:
        pasted, here: The two arms, as in `ModelFit.kind`.
    """

    pasted: str
    here: str


@dataclass(frozen=True, slots=True)
class OfShownTool:
    """The warning that pasted poses do not say what they are of, and count as the table's do.

    Attributes:
        tool: The tool, as a sentence names it.
    """

    tool: str


@dataclass(frozen=True, slots=True)
class FrameGiven:
    """The result of giving points another frame.

    Attributes:
        lost: The frame that is not known, of which they keep the figures; "" if all keep their
            places.
        name: The new frame; "" for the base.
    """

    lost: str
    name: str


Outcome = Union[
    FrameGiven, Refusal, TrajectoryFileError, OfOtherArm, OfShownTool, "LongEdit[Outcome]", None
]
"""The result of an edit: ``None`` if it is done; if it is done with a warning, that."""


class PointEdits(QObject):
    """Edits a document at the selected rows of its table.

    Args:
        controller: Gives the arm's state, and moves it.
        document: The document.
        table: The table with the selected rows, which shows the result.
    """

    def __init__(self, controller: ArmController, document: Document, table: PointsTable) -> None:
        super().__init__(table)
        self._controller = controller
        self._document = document
        self._table = table

    # New points -------------------------------------------------------------------------------

    def insert_before(self) -> Outcome:
        """Insert a copy of the first selected point's place above it."""
        rows = self._table.rows()
        return self._insert(rows[0] if rows else 0, [self._plain(rows[:1])])

    def insert_after(self) -> Outcome:
        """Insert a copy of the last selected point's place below it."""
        rows = self._table.rows()
        return self._insert(self._below(), [self._plain(rows[-1:])])

    def insert_measured(self, *, with_gripper: bool = False) -> Outcome:
        """Insert the arm's position below the selected rows.

        Args:
            with_gripper: True to add the measured opening of the gripper.
        """
        plain = self._plain(self._table.rows()[-1:])
        placed = plain if plain.is_joint else self._in_frame(plain, self._chosen_frame())
        point = placed if isinstance(placed, Refusal) else self._measured(placed)
        if isinstance(point, Refusal):
            return point
        if with_gripper:
            gripper = self._measured_gripper()
            if isinstance(gripper, Refusal):
                return gripper
            point = replace(point, gripper=gripper)
        self._insert(self._below(), [point])
        self._document.note_taught(self._controller.operating_state.model_fit.taught_on)
        return None

    def replace_by_measured(self) -> Outcome:
        """Set the selected rows to the arm's position; speed, dwell and actions stay."""
        return self._change(self._measured, self.tr("Replace with current pose"))

    def duplicate(self) -> Outcome:
        """Insert copies of the selected rows below them."""
        rows = self._table.rows()
        if not rows:
            return NO_ROWS_CHOSEN()
        return self._insert(rows[-1] + 1, edits.chosen(self._document.points, rows))

    def _insert(self, row: int, new: Sequence[Waypoint]) -> Outcome:
        self._document.edit(edits.insert(self._document.points, row, new), self.tr("Insert"))
        self._table.select_rows(row, len(new))
        return None

    def _below(self) -> int:
        rows = self._table.rows()
        return rows[-1] + 1 if rows else len(self._document.points)

    def _plain(self, rows: Sequence[int]) -> Waypoint:
        """Return a point at the first row's place, without actions; without rows at the arm."""
        if not rows:
            angles_deg = self._controller.state.angles_deg() or _ZERO
            return Waypoint(MoveMode.MOVE_J, tuple(angles_deg))
        point = self._document.points[rows[0]]
        return Waypoint(
            point.move, point.target, point.middle, point.speed_percent, frame=point.frame
        )

    def _measured(self, point: Waypoint) -> Waypoint | Refusal:
        """Return a point moved to the measured pose of the arm."""
        reason = self._controller.operating_state.unreachable
        if reason is not None:
            return reason
        state = self._controller.state
        values = state.angles_deg() if point.is_joint else state.end_pose()
        if values is None:
            return JOINTS_UNKNOWN()
        if not point.frame:
            return replace(point, target=tuple(values))
        frames = self.frames()
        return why_unknown((point,), frames) or replace(
            point, target=pose_in_frame(values, point.frame, frames)
        )

    def _measured_gripper(self) -> GripperAction | Refusal:
        """Return the gripper's action that leads to its measured opening or angle."""
        now, heard = self._controller.operating_state, self._controller.state.gripper
        if heard is None or not now.gripper_heard:
            return GRIPPER_SILENT()
        gripper = heard.value
        if now.generation is Generation.ONE:
            return GripperAngle(round(gripper.travel, 3))
        if gripper.opening_mm is None:
            return GRIPPER_TELLS_ANGLE()
        return GripperOpening(round(max(0.0, self._controller.gripper.shown(gripper)), 3))

    # Chosen rows ------------------------------------------------------------------------------

    def delete(self) -> Outcome:
        """Delete the selected rows."""
        return self._remove(self._table.rows(), self.tr("Delete"))

    def _remove(self, rows: Sequence[int], label: str) -> Outcome:
        if not rows:
            return NO_ROWS_CHOSEN()
        self._document.edit(edits.remove(self._document.points, rows), label)
        self._table.select_row(min(rows[0], len(self._document.points) - 1))
        return None

    def move_up(self) -> Outcome:
        """Move the selected rows up by one."""
        return self._shift(-1)

    def move_down(self) -> Outcome:
        """Move the selected rows down by one."""
        return self._shift(1)

    def _shift(self, by: int) -> Outcome:
        rows = self._table.rows()
        if not rows:
            return NO_ROWS_CHOSEN()
        points, first = edits.shift(self._document.points, rows, by)
        if self._document.edit(points, self.tr("Move")):
            self._table.select_rows(first, len(rows))
        return None

    def convert(self) -> Outcome:
        """Convert joint angles to poses, and poses to joint angles."""
        rows = self._table.rows()
        by = Conversion(
            self._controller.operating_state.model_fit.geometry,
            self._measured_deg(),
            self._controller.operating_state.limits,
            self.frames(),
            self._chosen_frame(),
        )
        arguments = self._document.points, rows, by
        finish = self._put_converted
        return LongEdit(len(rows), _CONVERTED_AT_ONCE, converted, arguments, finish)

    def _put_converted(self, changed: dict[int, Waypoint] | RowRefusal | Refusal) -> Outcome:
        if isinstance(changed, RowRefusal):
            return self._as_shown(changed.refusal, self._document.points[changed.row])
        return self._put(changed, self.tr("Convert"))

    def to_move(self, row: int, move: MoveMode) -> Waypoint | Refusal:
        """Return the point of a row with another kind of motion, or why not.

        A pose stays in its frame; one that was joint angles comes into the chosen one.
        """
        model = self._controller.cartesian.kinematics()
        points, measured_deg = self._document.points, self._measured_deg()
        based = self._in_frame(points[row], "")
        above = self._in_frame(points[max(row - 1, 0)], "")
        if isinstance(based, Refusal):
            return based
        if isinstance(above, Refusal):
            return above
        near_deg = joints_above(points, row, measured_deg)
        before = pose_of(above, model) if row else model.forward(measured_deg)
        result = to_move(based, move, model, near_deg, before)
        if isinstance(result, Refusal):
            return self._as_shown(result, points[row])
        frame = self._chosen_frame() if points[row].is_joint else points[row].frame
        return self._in_frame(result, frame)

    def _as_shown(self, refusal: Refusal, point: Waypoint) -> Refusal:
        """Return a refusal with the place of the point as the table shows it."""
        if refusal.reason != CONVERT_OUT_OF_REACH:
            return refusal
        x, y, z = self._table.points.tool.shown(point).target[:3]
        return CONVERT_OUT_OF_REACH(x=x, y=y, z=z)

    def set_frame(self, name: str) -> Outcome:
        """Have the selected points count from another frame.

        Each keeps its place; where the frame it was in is not known, its figures.

        Args:
            name: The user frame of the cell; "" for the base.
        """
        frames, rows, points = self.frames(), self._table.rows(), self._document.points
        known = ("", *frames)
        lost = next((points[row].frame for row in rows if points[row].frame not in known), "")

        def finish(changed: RowsOrRefusal) -> Outcome:
            return self._put(changed, self.tr("Frame")) or FrameGiven(lost, name)

        arguments = points, rows, name, frames
        return LongEdit(len(rows), _REFRAMED_AT_ONCE, reframed, arguments, finish)

    def frames(self) -> Frames:
        """Return the user frames of the cell."""
        return frames_of(self._controller.cell.cell)

    def _chosen_frame(self) -> str:
        cell = self._controller.cell.cell
        return "" if cell is None else cell.frame

    def _in_frame(self, point: Waypoint, name: str) -> Waypoint | Refusal:
        """Return the same place in another frame, or why where it is is not known."""
        return placed(point, name, self.frames())

    def _measured_deg(self) -> Sequence[float]:
        return self._controller.state.angles_deg() or _ZERO

    def _change(self, how: Callable[[Waypoint], Waypoint | Refusal], label: str) -> Outcome:
        changed: dict[int, Waypoint] = {}
        for row in self._table.rows():
            point = how(self._document.points[row])
            if isinstance(point, Refusal):
                return point
            changed[row] = point
        return self._put(changed, label)

    def _put(self, changed: RowsOrRefusal, label: str) -> Refusal | None:
        if isinstance(changed, Refusal):
            return changed
        if not changed:
            return NO_ROWS_CHOSEN()
        self._document.edit(edits.change(self._document.points, changed), label)
        return None

    # The clipboard ----------------------------------------------------------------------------

    def copy(self) -> Outcome:
        """Copy the selected rows to the clipboard, in a form for spreadsheets."""
        return self._copied(self._table.rows(), lambda: None)

    def cut(self) -> Outcome:
        """Copy the selected rows to the clipboard, and delete them."""
        rows = self._table.rows()
        return self._copied(rows, lambda: self._remove(rows, self.tr("Cut")))

    def _copied(self, rows: Sequence[int], then: Callable[[], Outcome]) -> Outcome:
        if not rows:
            return NO_ROWS_CHOSEN()
        tool, taught_on = self._table.points.tool, self._document.taught_on

        def finish(text: str | Refusal) -> Outcome:
            if isinstance(text, Refusal):
                return text
            data = QMimeData()
            data.setText(text)
            data.setData(_TOOL, " ".join(map(repr, tool.tool)).encode())
            if taught_on:
                data.setData(_TAUGHT_ON, taught_on.encode())
            QGuiApplication.clipboard().setMimeData(data)
            return then()

        points = edits.chosen(self._document.points, rows)
        return LongEdit(len(rows), _COPIED_AT_ONCE, copied, (points, tool), finish)

    def paste(self) -> Outcome:
        """Insert the points in the clipboard below the rows that are selected now."""
        rows, below = self._table.rows(), self._below()
        like = self._document.points[rows[-1]].move if rows else MoveMode.MOVE_J
        like = MoveMode.MOVE_L if like is MoveMode.MOVE_C else like
        text, told = QGuiApplication.clipboard().text(), _tool_in_clipboard()
        shown, arm = self._table.points, _arm_in_clipboard()
        tool, named_tool = shown.tool, shown.named_tool

        def finish(new: PastedPoints | Refusal | TrajectoryFileError) -> Outcome:
            if not isinstance(new, PastedPoints):
                return new
            warning = self._take_pasted(new, new.taught_on or arm, below)
            unsaid = not new.is_file and not tool.is_flange and told is None
            poses = unsaid and not all(point.is_joint for point in new.points)
            return warning or (OfShownTool(named_tool) if poses else None)

        arguments = text, like, tool, told, shown.limits()
        return LongEdit(text.count("\n"), _PASTED_AT_ONCE, kept_from, arguments, finish)

    def _take_pasted(self, new: PastedPoints, arm: str, below: int) -> OfOtherArm | None:
        here = self._document.taught_on
        self._insert(below, new.points)
        if arm and here and arm != here:
            return OfOtherArm(arm, here)
        self._document.note_taught(arm, len(new.points))
        return None

    # The arm ----------------------------------------------------------------------------------

    def convert_zeros(self) -> bool:
        """Convert all joint angles to the zeros of the arm; return whether it was possible."""
        fit = self._controller.operating_state.model_fit
        by_deg = fit.zeros_from_deg(self._document.taught_on)
        if by_deg is None:
            return False
        points = edits.turned(self._document.points, by_deg)
        self._document.convert(points, fit.kind, self.tr("Convert zeros"))
        return True

    def current_point(self) -> Waypoint | None:
        """Return the point of the current row, if there is one."""
        row = self._table.current_row()
        return self._document.points[row] if row >= 0 else None

    def motion_here(self) -> Callable[[float], Started | Refusal] | Refusal:
        """Return what sends the arm to the current point, without its actions; see `drive`."""
        given = self.current_point()
        if given is None:
            return NO_ROWS_CHOSEN()
        point = self._in_frame(given, "")
        if isinstance(point, Refusal):
            return point
        if point.is_joint:
            return partial(self._controller.motion.send_joints, point.target)
        cartesian = self._controller.cartesian
        move = MoveMode.MOVE_L if point.move is MoveMode.MOVE_L else MoveMode.MOVE_P
        return partial(cartesian.move, tool_pose(point.target, cartesian.tool), move)


def _arm_in_clipboard() -> str:
    data = QGuiApplication.clipboard().mimeData()
    kept = b"" if data is None else bytes(data.data(_TAUGHT_ON).data())
    name = kept.decode(errors="replace")
    return "" if check_text("taught_on", name, lines=1) else name


def _tool_in_clipboard() -> Values | None:
    """Return the tool whose poses are in the clipboard; ``None`` if nothing says so."""
    data = QGuiApplication.clipboard().mimeData()
    kept = b"" if data is None else bytes(data.data(_TOOL).data())
    try:
        tool = tuple(map(float, kept.split()))
    except ValueError:
        return None
    possible = len(tool) == VALUE_COUNT and check_pose("", tool, TOOL_LONGEST_MM) is None
    return tool if possible else None
