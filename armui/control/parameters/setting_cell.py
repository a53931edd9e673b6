"""How one parameter stands between the program and the arm."""

from __future__ import annotations

import enum
from dataclasses import dataclass

from armui.arm.refusal import Refusal


class CellState(enum.Enum):
    """How a parameter stands between the program and the arm."""

    UNREAD = enum.auto()
    READING = enum.auto()
    READ = enum.auto()
    SAVING = enum.auto()
    SAVED = enum.auto()
    """Asked for, read back, and the same."""
    REFUSED = enum.auto()
    """Not read or not taken; the reason says why."""


@dataclass(frozen=True, slots=True)
class SettingCellState:
    """A parameter's state, and the reason if it was refused."""

    state: CellState = CellState.UNREAD
    refusal: Refusal | None = None
