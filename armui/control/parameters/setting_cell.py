"""The state of one parameter between the program and the arm."""

from __future__ import annotations

import enum
from dataclasses import dataclass

from armui.arm.refusal import Refusal


class CellState(enum.Enum):
    """The states of a parameter between the program and the arm."""

    UNREAD = enum.auto()
    READING = enum.auto()
    READ = enum.auto()
    SAVING = enum.auto()
    SAVED = enum.auto()
    """The parameter was set, read back, and is the same."""
    REFUSED = enum.auto()
    """The parameter was not read or not taken, for the reason given."""


@dataclass(frozen=True, slots=True)
class SettingCellState:
    """A parameter's state, and the reason if it was refused."""

    state: CellState = CellState.UNREAD
    refusal: Refusal | None = None
