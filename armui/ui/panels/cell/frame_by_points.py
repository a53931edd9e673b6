"""The guided capture of a user frame: its origin, a point on +X, one on the side of +Y."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any, Final

from PySide6.QtGui import QHideEvent, QShowEvent

from armui.arm.refusal import Refusal
from armui.cell.user_frames import (
    LEAST_APART_MM,
    LEAST_OFF_DEG,
    UserFrame,
    frame_from_points,
    off_x_axis,
    why_near,
)
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_reasons import CELL_NONE
from armui.kinematics.poses import pose_to_matrix, tool_pose
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.panels.cell.cell_tab import NARROW_PX, Answered
from armui.ui.panels.cell.named_tab import ADDED
from armui.ui.panels.cell.point_search import PointSearch, Pose
from armui.ui.widgets.buttons import caption, enable_or_explain, push_button, show_primary
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row
from armui.ui.widgets.text_label import text_label

_POINTS: Final = 3


class FrameByPoints(PointSearch):
    """Takes three places of the tool centre point at rest, and shows the frame that they give.

    The frame is shown in the picture before it is taken; see :class:`PointSearch`.
    """

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered, "frame_points")
        self._points: list[Pose | None] = [None] * _POINTS
        self._tool = controller.cartesian.tool
        self._chosen: UserFrame | None = None
        self._takes = [push_button(f"frame_take_{number}") for number in range(1, _POINTS + 1)]
        self._places = [text_label(f"frame_place_{each}") for each in range(1, _POINTS + 1)]
        self._add = push_button("frame_points_add")
        grid = empty_grid(gaps=(8, 4), margins=0)
        for place, (button, label) in enumerate(zip(self._takes, self._places, strict=True)):
            button.clicked.connect(partial(self._on_take, place))
            grid.addWidget(button, place, 0)
            grid.addWidget(label, place, 1)
        grid.setColumnStretch(1, 1)
        self._add.setMinimumWidth(NARROW_PX)
        ends = in_row((self._add, 1), (self._apply, 1), (self._restart, 1), spacing=6)
        parts = (self._next, self._live, grid, self._result, ends, STRETCH)
        in_column(*parts, on=self, spacing=6, margins=0)
        self._add.clicked.connect(lambda: self._on_apply(anew=True))
        self.retranslate_ui()

    # -- actions ------------------------------------------------------------------------------

    def _on_take(self, place: int) -> None:
        def keep(flange: Pose) -> None:
            self._points[place] = tuple(tool_pose(flange, self._controller.cartesian.tool))

        self._captured(keep)

    def restart(self) -> None:
        """Forget the points taken so far."""
        self._points = [None] * _POINTS
        self._show()

    def found(self) -> Pose | Refusal | None:
        """Return the frame given by the points, or why there is none; ``None``: too few points."""
        points = [point for point in self._points if point is not None]
        if len(points) == _POINTS:
            return frame_from_points(*points)
        origin, on_x, _ = self._points
        return why_near(origin, on_x, "+X") if origin is not None and on_x is not None else None

    # -- appearance ---------------------------------------------------------------------------

    def show_chosen(self, chosen: Any, why_not: str) -> None:
        """Show which frame the result can replace."""
        self._chosen, self._why_not = chosen, why_not
        tool = self._controller.cartesian.tool
        # points taken with different tools together give no frame
        if tool != self._tool:
            self._tool, self._points = tool, [None] * _POINTS
        self._show()

    def show_live(self) -> None:
        """Show how far the arm's present place is from the origin or the X axis."""
        refusal = self._controller.cell.why_not_capture()
        use = self.tr("Takes the measured place of the tool; nothing moves.")
        for button in self._takes:
            enable_or_explain(button, words.why_not(refusal), use)
        self._live.setText(self._live_text(refusal))

    def _live_text(self, refusal: Refusal | None) -> str:
        if refusal is not None:
            return self._why_no_pose(refusal)
        pose, origin = self._controller.cartesian.tool_pose(self._controller.state), self._points[0]
        if pose is None or origin is None or None not in self._points:
            return ""
        on_x = self._points[1]
        if on_x is None or why_near(origin, on_x, "+X"):
            text = self.tr("{value} mm from the origin; at least {wanted} mm are needed.")
            value = math.dist(pose[:3], origin[:3])
            return text.format(value=fmt.number(value, 1), wanted=round(LEAST_APART_MM))
        text = self.tr("{value} mm and {angle}° off the X axis; at least {wanted}° are needed.")
        value, angle = off_x_axis(origin, on_x, pose)
        return text.format(
            value=fmt.number(value, 1), angle=fmt.number(angle, 1), wanted=round(LEAST_OFF_DEG)
        )

    def _show(self) -> None:
        found = self.found()
        missing = next((place for place in range(_POINTS) if self._points[place] is None), _POINTS)
        for place, (button, label) in enumerate(zip(self._takes, self._places, strict=True)):
            wanted = place == missing and self._controller.cell.cell is not None
            show_primary(button, wanted=wanted)
            label.setText(self._place_text(self._points[place]))
        reason = words.refusal(found) if isinstance(found, Refusal) else ""
        reason = reason or ("" if found is not None else self.tr("Not all points are taken yet."))
        self._result.setText(self._result_text(found) if isinstance(found, tuple) else "")
        none = "" if self._chosen is not None else self.tr("No frame is chosen.")
        use = self.tr("Adds the frame found under a new name; it is in force once it is chosen.")
        enable_or_explain(self._add, self._why_not or reason, use)
        use = self.tr(
            "Puts the frame found in the place of “{name}”. Points of trajectories that belong to "
            "it move with it; their way is checked anew."
        )
        name = "" if self._chosen is None else self._chosen.name
        enable_or_explain(self._apply, self._why_not or reason or none, use.format(name=name))
        taken = self._taken(found) is not None
        show_primary(self._add, wanted=not reason and not taken and not self._why_not)
        self._restart.setEnabled(any(self._points))
        self._next.setText(self._next_step(found, missing))
        self._propose(found)
        self.show_live()

    def _propose(self, found: Pose | Refusal | None) -> None:
        """Show the frame found in the picture, until it is applied or this widget is hidden."""
        shown = isinstance(found, tuple) and self.isVisible() and self._taken(found) is None
        pose = found if isinstance(found, tuple) else ()
        self._controller.cell.propose(UserFrame(self.tr("New frame"), pose) if shown else None)

    def _taken(self, found: Pose | Refusal | None) -> UserFrame | None:
        """Return the frame of the cell whose pose is the one found, or ``None``."""
        cell = self._controller.cell.cell
        if cell is None or not isinstance(found, tuple):
            return None
        pose = tuple(round(each, fmt.DECIMALS) for each in found)
        return next((frame for frame in cell.all_frames if frame.pose == pose), None)

    def _place_text(self, point: Pose | None) -> str:
        if point is None:
            return fmt.NOTHING
        x, y, z = (fmt.number(value, 1) for value in point[:3])
        return self.tr("X {x}  Y {y}  Z {z} mm in the base").format(x=x, y=y, z=z)

    def _result_text(self, pose: Pose) -> str:
        up = [fmt.number(value, 2) for value in pose_to_matrix(pose)[:3, 2].tolist()]
        text = self.tr("Found, in the base: {frame}\nZ points along {direction}")
        return text.format(
            frame=fmt.pose(pose, 2),
            direction="X {}  Y {}  Z {}".format(*up),
        )

    def _next_step(self, found: Pose | Refusal | None, missing: int) -> str:
        if self._controller.cell.cell is None:
            return words.refusal(CELL_NONE())
        if isinstance(found, Refusal):
            return words.refusal(found)
        taken = self._taken(found)
        if taken is not None and taken != self._chosen:
            return ADDED.text().format(name=taken.name)
        if taken is not None:
            return self.tr(
                "“{name}” is in force: jog along it in Cartesian, by its button beside − and +."
            ).format(name=taken.name)
        steps: tuple[Callable[[], str], ...] = (
            lambda: self.tr(
                "Bring the tool's tip to what becomes the origin (by Jog above, or lead the arm "
                "by hand), and press Origin."
            ),
            lambda: self.tr(
                "Jog the tip along what becomes the X axis, as far as you can; press On +X."
            ),
            lambda: self.tr("Jog the tip to the side where +Y is to be; press On the +Y side."),
            lambda: self.tr(
                "Look at the axes in the picture: is Z as you want it? Then press Add. If not, "
                "take a point again."
            ),
        )
        return steps[missing]()

    def showEvent(self, event: QShowEvent) -> None:
        """Show the frame found in the picture again."""
        super().showEvent(event)
        self._show()

    def hideEvent(self, event: QHideEvent) -> None:
        """Remove the frame found from the picture."""
        super().hideEvent(event)
        self._controller.cell.propose(None)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        points = (self.tr("Origin"), self.tr("On +X"), self.tr("On the +Y side"))
        for button, text in zip(self._takes, points, strict=True):
            caption(button, text)
        caption(self._add, self.tr("Add"), whose=self.tr("Frame found"))
        caption(self._apply, self.tr("Replace"), whose=self.tr("Frame found"))
        caption(self._restart, self.tr("Start again"))
        self._show()
