"""The base of a tab of the panel 单元: a part of the chosen cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar

from PySide6.QtWidgets import QWidget

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.operations.started import Started
from armui.ui.actions.command import Command, Target
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

Answered = Callable[[Started | Refusal | None], bool]
"""Shows an answer in the panel, and returns whether it was a yes."""


class CellTab(Translated, QWidget):
    """A part of the chosen cell.

    Args:
        controller: The controller of the arm; changes go through its `cell`.
        answered: Shows an answer in the panel.

    Attributes:
        key: Its stable name.
        title: The title of its button.
        commands: Its commands for the command palette, of the panel's key.
    """

    key: ClassVar[str] = ""
    title: ClassVar[Text]
    commands: ClassVar[Sequence[Command]] = ()

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__()
        self._controller = controller
        self._answered = answered

    def show_cell(self, why_not: str) -> None:
        """Show the chosen cell.

        Args:
            why_not: Why it cannot be changed now; empty if it can.
        """
        raise NotImplementedError

    def show_state(self, state: ArmState) -> None:
        """Show what the arm says."""

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each of its commands, by the command's name."""
        return {}
