"""The six figures of a pose, one below the other, targets beside measured values."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.kinematics.poses import AXES, LINEAR_AXES
from armui.ui.panels.jogging.pose_row import PoseRow
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated


class PoseRows(Translated, QWidget):
    """Targets to type and jog.

    Attributes:
        rows: One an axis.
    """

    def __init__(self) -> None:
        super().__init__()
        self._point = text_label("point_label", rank="muted")
        self._measured_head = text_label(rank="muted")
        self._with_tool = False
        self.rows = [
            PoseRow(place, name, "mm" if place < LINEAR_AXES else "°")
            for place, name in enumerate(AXES)
        ]
        head = in_row(self._point, STRETCH, self._measured_head)
        in_column(head, *self.rows, on=self, spacing=4, margins=0)
        self.retranslate_ui()

    def targets(self) -> list[float] | Refusal:
        """The six figures, or why one of them is none."""
        values = [row.field.value for row in self.rows]
        targets = [value for value in values if value is not None]
        if len(targets) == len(AXES):
            return targets
        return self.nonsense() or Refusal(RefusalCode.POSE_UNKNOWN)

    def nonsense(self) -> Refusal | None:
        """What is to be said against the first text that is no figure."""
        for row in self.rows:
            if row.field.is_nonsense():
                return Refusal(
                    RefusalCode.POSE_NOT_A_NUMBER, {"axis": row.name, "value": row.field.text()}
                )
        return None

    def fill(self, pose: Sequence[float] | None) -> None:
        """Put a pose into the fields; ``None`` empties them."""
        for row, value in zip(self.rows, pose or (None,) * len(AXES), strict=True):
            row.show_target(value)

    def follow(self, pose: Sequence[float]) -> None:
        """Show a pose in the fields in which no target was given."""
        for row, value in zip(self.rows, pose, strict=True):
            row.follow(value)

    def release(self) -> None:
        """No target is the operator's any more."""
        for row in self.rows:
            row.own = False

    def differ_from(self, pose: Sequence[float]) -> bool:
        """Whether a target was given that is not this pose."""
        return any(row.differs_from(value) for row, value in zip(self.rows, pose, strict=True))

    def show_measured(self, pose: Sequence[float] | None, *, stale: bool) -> None:
        """Show what is measured."""
        for row, value in zip(self.rows, pose or (None,) * len(AXES), strict=True):
            row.show_measured(value, stale=stale)

    def set_step(self, step: float, *, continuous: bool) -> None:
        """How far one press of − or + goes, or whether it goes on while they are held."""
        for row in self.rows:
            row.set_step(step, continuous=continuous)

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for row in self.rows:
            row.allow_jog(why_not)

    def name_point(self, *, with_tool: bool) -> None:
        """Say which point the figures are about."""
        self._with_tool = with_tool
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._point.setText(
            self.tr("Tool centre point") if self._with_tool else self.tr("Flange (no tool set)")
        )
        self._measured_head.setText(self.tr("Measured"))
