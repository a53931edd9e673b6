"""Asking before something that the operator might regret."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.dialogs.confirm_dialog import ConfirmDialog


def confirm(
    parent: QWidget,
    controller: ArmController,
    *,
    title: str,
    text: str,
    action_label: str,
    on_confirmed: Callable[[], object],
    hold: bool = False,
    concerns_arm: bool = True,
    still: Callable[[], bool] = lambda: True,
) -> ConfirmDialog:
    """Ask, without holding up anything; an older question of the same title is withdrawn.

    Args:
        parent: The window that asks.
        controller: Whom the emergency stop in the question tells.
        title: The question in a few words.
        text: What will physically happen, and what to do before.
        action_label: What the button does, in a word.
        on_confirmed: Called when the operator agrees.
        hold: The button must be held for a second.
        concerns_arm: It is withdrawn when another arm, or none, is there; see `ConfirmDialog`.
        still: Whether what it says is still so; it is withdrawn when not.

    Returns:
        The open question; it deletes itself once answered.
    """
    from armui.ui.dialogs.confirm_dialog import ConfirmDialog  # noqa: PLC0415 - faster start

    for older in parent.findChildren(ConfirmDialog):
        if older.windowTitle() == title:
            older.reject()
    dialog = ConfirmDialog(
        controller,
        parent,
        title=title,
        text=text,
        action_label=action_label,
        hold=hold,
        concerns_arm=concerns_arm,
        still=still,
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.accepted.connect(on_confirmed)
    dialog.open()
    return dialog
