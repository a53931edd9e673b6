"""What a panel of parameters says below its buttons: the one thing that matters most now."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final, NamedTuple

from PySide6.QtCore import QCoreApplication

from armui.arm.parameters import Parameter, heard
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState
from armui.control.events import Level
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_draft import CellStatus, SettingDraft, shown_as
from armui.ui import words
from armui.ui.panels.panel import level_of
from armui.ui.words.parameters import full_name, status_explained, value_text
from armui.ui.words.text import listed

_LEVELS: Final = {
    RefusalCode.SETTING_NOT_TAKEN: Level.FAULT,
    RefusalCode.SETTING_UNANSWERED: Level.FAULT,
    RefusalCode.SETTING_NOT_READ_BACK: Level.FAULT,
}


class Said(NamedTuple):
    """A text and how much it matters."""

    text: str
    level: Level = Level.INFO


def message(
    *,
    refusal: Refusal | None,
    draft: SettingDraft,
    state: ArmState,
    cell: Callable[[Parameter], SettingCellState],
    asked: Mapping[Parameter, float],
    danger: str,
) -> Said:
    """What to say.

    Args:
        refusal: The controller's no, or that the arm cannot be reached.
        draft: What was entered.
        state: The arm as last heard.
        cell: How a parameter stands.
        asked: What was saved last; empty if the operator has gone on since.
        danger: What is dangerous in the figures shown.
    """
    reasons = (cell(parameter).reason for parameter in draft.parameters)
    first = (
        refusal
        or draft.first_wrong(state)
        or next((reason for reason in reasons if reason is not None), None)
    )
    if first is not None:
        return Said(words.refusal(first), _LEVELS.get(first.code, level_of(first)))
    corrupt = [
        parameter
        for parameter in draft.parameters
        if draft.status(state, parameter, cell(parameter)) is CellStatus.CORRUPT
    ]
    if corrupt:
        names = listed(full_name(parameter) for parameter in corrupt)
        text = QCoreApplication.translate("ParameterPanel", "{names}: {reason}")
        reason = status_explained(CellStatus.CORRUPT, "")
        return Said(text.format(names=names, reason=reason), Level.FAULT)
    if danger:
        return Said(danger, Level.WARNING)
    if asked and all(cell(parameter).state is CellState.SAVED for parameter in asked):
        return _saved(state, asked)
    return Said("")


def _saved(state: ArmState, asked: Mapping[Parameter, float]) -> Said:
    """That all of it is in the arm, and where that keeps coarser steps than were asked for."""
    nearest = [
        f"{full_name(parameter)} {value_text(parameter.name, known.value)}"
        for parameter, value in asked.items()
        if (known := heard(state, parameter)) is not None
        and shown_as(parameter, known.value) != shown_as(parameter, value)
    ]
    if not nearest:
        text = QCoreApplication.translate(
            "ParameterPanel", "Saved: read back from the arm, and the same."
        )
        return Said(text, Level.DONE)
    text = QCoreApplication.translate(
        "ParameterPanel", "Saved. The arm keeps coarser steps; it holds the nearest: {values}."
    )
    return Said(text.format(values=listed(nearest)), Level.DONE)
