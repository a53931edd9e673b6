"""The operator's unsaved entries for the arm's parameters: pure, without Qt."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from armui.arm.parameters import Parameter, check_value, is_corrupt, not_a_number, reading_of
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_checks import Changes, crossed


class CellStatus(enum.Enum):
    """The ways in which a parameter is shown."""

    READ = "read"
    """The value is as the arm holds it, with no remark."""
    NOT_READ = "not_read"
    READING = "reading"
    CORRUPT = "corrupt"
    """The value read can only come from a corrupted memory."""
    CHANGED = "changed"
    WRONG = "wrong"
    """The entry cannot be saved."""
    SAVING = "saving"
    SAVED = "saved"
    NOT_SAVED = "not_saved"
    """The entry is not in the arm, as far as is known."""


@dataclass(frozen=True, slots=True)
class DraftEntry:
    """An entry of the operator.

    Attributes:
        text: The text as typed.
        value: Its value in the operator's unit, or ``None`` if it is no number.
    """

    text: str
    value: float | None


class SettingDraft:
    """The entries that differ from the arm's values.

    Args:
        parameters: The parameters that can be entered.

    Attributes:
        editing: True if the operator has begun to edit.
    """

    def __init__(self, parameters: Sequence[Parameter]) -> None:
        self.parameters = tuple(parameters)
        self.editing = False
        self._entries: dict[Parameter, DraftEntry] = {}

    def begin_editing(self) -> None:
        """Permit entries."""
        self.editing = True

    def end_editing(self) -> None:
        """Forget every entry; the arm's values are shown again."""
        self.editing = False
        self._entries.clear()

    def enter(self, state: ArmState, parameter: Parameter, text: str, value: float | None) -> None:
        """Take an entry; one that equals the arm's value as shown is not kept."""
        if _differs(state, parameter, text, value):
            self._entries[parameter] = DraftEntry(text, value)
        else:
            self._entries.pop(parameter, None)

    def drop_entries(self, parameters: Iterable[Parameter]) -> None:
        """Drop entries that are in the arm or no longer wanted."""
        for parameter in parameters:
            self._entries.pop(parameter, None)

    def entry(self, parameter: Parameter) -> DraftEntry | None:
        """Return the entry for a parameter, or ``None``."""
        return self._entries.get(parameter)

    @property
    def changed(self) -> bool:
        """True if an entry differs from the arm's value."""
        return bool(self._entries)

    def changes(self) -> Changes:
        """Return the values entered, in the order of the panel."""
        return {
            parameter: entry.value
            for parameter in self.parameters
            if (entry := self._entries.get(parameter)) is not None and entry.value is not None
        }

    def why_wrong(self, state: ArmState, parameter: Parameter) -> Refusal | None:
        """Return the reason against an entry, by itself and with its neighbours, or ``None``."""
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
        """Return the way in which a parameter is to be shown.

        Args:
            state: The arm as last heard.
            parameter: The parameter.
            cell: Its state between the program and the arm.
        """
        under_way = {CellState.SAVING: CellStatus.SAVING, CellState.READING: CellStatus.READING}
        if cell.state in under_way:
            return under_way[cell.state]
        if parameter in self._entries:
            if self.why_wrong(state, parameter) is not None:
                return CellStatus.WRONG
            return CellStatus.NOT_SAVED if cell.state is CellState.REFUSED else CellStatus.CHANGED
        if cell.state is CellState.REFUSED or reading_of(state, parameter) is None:
            return CellStatus.NOT_READ
        if is_corrupt(state, parameter):
            return CellStatus.CORRUPT
        return CellStatus.SAVED if cell.state is CellState.SAVED else CellStatus.READ


def shown_as(parameter: Parameter, value: float) -> float:
    """Return a value rounded to the last decimal that the operator sees."""
    return round(value, parameter.kind.decimals)


def _differs(state: ArmState, parameter: Parameter, text: str, value: float | None) -> bool:
    known = reading_of(state, parameter)
    if value is None:
        return known is not None or bool(text.strip())
    return known is None or shown_as(parameter, value) != shown_as(parameter, known.value)
