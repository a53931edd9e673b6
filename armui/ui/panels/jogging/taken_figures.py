"""Targets that come from elsewhere than the keyboard, into the rows of a panel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, Protocol

if TYPE_CHECKING:
    from armui.ui.widgets.figure_field import FigureField

_SAME: Final = 0.0005
"""Half of the last decimal: less is not seen in a field."""


class TargetRow(Protocol):
    """A row whose target was given, or follows the arm."""

    own: bool
    field: FigureField

    def show_target(self, value: float | None, /) -> None: ...  # noqa: D102 - as in the rows


def take_figures(
    rows: Sequence[TargetRow], values: Sequence[float], given: Sequence[bool] | None
) -> None:
    """Give the rows their targets; one that does not differ goes on to follow the arm.

    Args:
        rows: Of a panel.
        values: One each.
        given: Which of them stand still from now on; None: those that did, and those that differ.
    """
    for row, value in zip(rows, values, strict=True):
        before = row.field.value
        if before is None or abs(value - before) > _SAME:
            row.show_target(value)
    for row, stands in zip(rows, given or (), strict=False):
        row.own = stands
