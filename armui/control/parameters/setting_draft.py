"""What an operator has entered for the arm's parameters and not saved yet: pure, without Qt."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from armui.arm.parameters import Parameter, check_value, heard, is_corrupt, not_a_number
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_checks import Changes, crossed


class CellStatus(enum.Enum):
    """How a parameter is shown."""

    READ = "read"
    """As the arm holds it: nothing is to be said."""
    NOT_READ = "not_read"
    READING = "reading"
    CORRUPT = "corrupt"
    """What was read can only be a corrupted memory."""
    CHANGED = "changed"
    WRONG = "wrong"
    """What was entered cannot be saved."""
    SAVING = "saving"
    SAVED = "saved"
    NOT_SAVED = "not_saved"
    """What was entered is not in the arm, as far as is known."""


@dataclass(frozen=True, slots=True)
class DraftEntry:
    """What was entered.

    Attributes:
        text: As it was typed.
        value: The figure in it, in the operator's unit; ``None`` if it is none.
    """

    text: str
    value: float | None


class SettingDraft:
    """The entries beside what the arm holds; what is entered as the arm holds it is no change.

    Args:
        parameters: Those that can be entered.

    Attributes:
        editing: Whether the operator has begun to edit.
    """

    def __init__(self, parameters: Sequence[Parameter]) -> None:
        self.parameters = tuple(parameters)
        self.editing = False
        self._entries: dict[Parameter, DraftEntry] = {}

    def begin_editing(self) -> None:
        """Let entries be made."""
        self.editing = True

    def end_editing(self) -> None:
        """Forget every entry; what the arm holds is shown again."""
        self.editing = False
        self._entries.clear()

    def enter(self, state: ArmState, parameter: Parameter, text: str, value: float | None) -> None:
        """Take what was typed; what the arm holds already, as it is shown, is no entry."""
        if _differs(state, parameter, text, value):
            self._entries[parameter] = DraftEntry(text, value)
        else:
            self._entries.pop(parameter, None)

    def drop_entries(self, parameters: Iterable[Parameter]) -> None:
        """Drop entries that are in the arm, or not wanted any more."""
        for parameter in parameters:
            self._entries.pop(parameter, None)

    def entry(self, parameter: Parameter) -> DraftEntry | None:
        """Return what was entered for a parameter."""
        return self._entries.get(parameter)

    @property
    def changed(self) -> bool:
        """True if something differs from what the arm holds."""
        return bool(self._entries)

    def changes(self) -> Changes:
        """Return the figures entered, in the order of the panel."""
        return {
            parameter: entry.value
            for parameter in self.parameters
            if (entry := self._entries.get(parameter)) is not None and entry.value is not None
        }

    def why_wrong(self, state: ArmState, parameter: Parameter) -> Refusal | None:
        """Return what speaks against an entry, by itself and beside its neighbours."""
        entry = self._entries.get(parameter)
        if entry is None:
            return None
        if entry.value is None:
            return not_a_number(parameter, entry.text.strip() or "—")
        refusal = check_value(parameter, entry.value)
        if refusal is None and parameter.name in {"max_angle_deg", "min_angle_deg"}:
            return crossed(state, parameter.batch, self.changes())
        return refusal

    def first_wrong(self, state: ArmState) -> Refusal | None:
        """Return the first reason against saving, or ``None``."""
        reasons = (self.why_wrong(state, parameter) for parameter in self.parameters)
        return next((reason for reason in reasons if reason is not None), None)

    def status(self, state: ArmState, parameter: Parameter, cell: SettingCellState) -> CellStatus:
        """Return how a parameter is to be shown.

        Args:
            state: The arm as last heard.
            parameter: Which one.
            cell: How it stands between the program and the arm.
        """
        under_way = {CellState.SAVING: CellStatus.SAVING, CellState.READING: CellStatus.READING}
        if cell.state in under_way:
            return under_way[cell.state]
        if parameter in self._entries:
            if self.why_wrong(state, parameter) is not None:
                return CellStatus.WRONG
            return CellStatus.NOT_SAVED if cell.state is CellState.REFUSED else CellStatus.CHANGED
        if cell.state is CellState.REFUSED or heard(state, parameter) is None:
            return CellStatus.NOT_READ
        if is_corrupt(state, parameter):
            return CellStatus.CORRUPT
        return CellStatus.SAVED if cell.state is CellState.SAVED else CellStatus.READ


def shown_as(parameter: Parameter, value: float) -> float:
    """Return a value to the last decimal the operator sees."""
    return round(value, parameter.kind.decimals)


def _differs(state: ArmState, parameter: Parameter, text: str, value: float | None) -> bool:
    known = heard(state, parameter)
    if value is None:
        return known is not None or bool(text.strip())
    return known is None or shown_as(parameter, value) != shown_as(parameter, known.value)
