"""Follows 【保存】 to its end: values that the arm holds leave the draft, the rest stay."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.operations.started import Started, refusal_of
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_checks import Changes
from armui.control.parameters.setting_draft import SettingDraft


class Saves(Protocol):
    """The part of the controller that sets parameters and reads them back."""

    def save(self, changes: Changes) -> Started | Refusal:
        """Set parameters."""

    def cell(self, parameter: Parameter) -> SettingCellState:
        """Return the state of a parameter between the program and the arm."""


class SettingSaving:
    """Saves the entries of a draft, one saving at a time.

    Args:
        settings: Sets the parameters and reads them back.
        draft: The entries.
    """

    def __init__(self, settings: Saves, draft: SettingDraft) -> None:
        self._settings = settings
        self._draft = draft
        self._asked: Changes = {}
        self._running = False

    @property
    def running(self) -> bool:
        """True until the arm has answered everything."""
        return self._running

    @property
    def asked(self) -> Mapping[Parameter, float]:
        """The values sent last; empty once the operator has gone on."""
        return self._asked

    def begin(self, state: ArmState) -> Refusal | None:
        """Send the entries.

        Args:
            state: The arm as last heard.

        Returns:
            ``None`` if it is on its way, or why nothing was sent.
        """
        refusal = self._draft.first_wrong(state)
        changes = self._draft.changes()
        if refusal is None and changes:
            self._asked, self._running = changes, True
            refusal = refusal_of(self._settings.save(changes))
        if refusal is not None:
            self._running = False
            self.forget_outcome()
        return refusal

    def ended(self) -> bool:
        """Take in the parameters' states; return whether the saving has just ended."""
        if not self._running or any(
            self._cell_state(each) is CellState.SAVING for each in self._asked
        ):
            return False
        self._running = False
        taken = [each for each in self._asked if self._cell_state(each) is CellState.SAVED]
        self._draft.drop_entries(taken)
        if len(taken) == len(self._asked) and not self._draft.changed:
            self._draft.end_editing()
        return True

    def forget_outcome(self) -> None:
        """Forget the outcome of the saving, because the operator has gone on."""
        self._asked = {}

    def _cell_state(self, parameter: Parameter) -> CellState:
        return self._settings.cell(parameter).state
