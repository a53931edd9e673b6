"""【保存】 followed to its end: what the arm is seen to hold leaves the draft, the rest stays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_checks import Changes
from armui.control.parameters.setting_draft import SettingDraft


class Saves(Protocol):
    """The part of the controller that sets parameters and reads them back."""

    def save(self, changes: Changes) -> Refusal | None:
        """Set parameters: ``None`` if they are on their way, or why nothing was sent."""

    def cell(self, parameter: Parameter) -> SettingCellState:
        """Return how a parameter stands between the program and the arm."""


class SettingSaving:
    """Saves what stands in a draft, one saving at a time.

    Args:
        settings: Sets the parameters and reads them back.
        draft: What was entered.
    """

    def __init__(self, settings: Saves, draft: SettingDraft) -> None:
        self._settings = settings
        self._draft = draft
        self._asked: Changes = {}
        self._running = False

    @property
    def running(self) -> bool:
        """True if the arm has not answered everything yet."""
        return self._running

    @property
    def asked(self) -> Mapping[Parameter, float]:
        """What was sent last; empty once the operator has gone on."""
        return self._asked

    def begin(self, state: ArmState) -> Refusal | None:
        """Send what was entered.

        Args:
            state: The arm as last heard.

        Returns:
            ``None`` if it is on its way, or why nothing was sent.
        """
        refusal = self._draft.first_wrong(state)
        changes = self._draft.changes()
        if refusal is None and changes:
            self._asked, self._running = changes, True
            refusal = self._settings.save(changes)
        if refusal is not None:
            self._running = False
            self.forget_outcome()
        return refusal

    def ended(self) -> bool:
        """Look at how the parameters stand; tell whether the saving has just come to its end."""
        if not self._running or any(self._stands(each) is CellState.SAVING for each in self._asked):
            return False
        self._running = False
        taken = [each for each in self._asked if self._stands(each) is CellState.SAVED]
        self._draft.drop_entries(taken)
        if len(taken) == len(self._asked) and not self._draft.changed:
            self._draft.end_editing()
        return True

    def forget_outcome(self) -> None:
        """Tell no more how it ended: the operator has gone on."""
        self._asked = {}

    def _stands(self, parameter: Parameter) -> CellState:
        return self._settings.cell(parameter).state
