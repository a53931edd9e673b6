"""The list of all shortcuts, by the places where they count (?)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QWidget

from armui.ui.actions.keys import SHORTCUTS
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.sections import HelpSection, SectionsArea
from armui.ui.widgets.layouts import STRETCH, fill

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.words.text import Text

_SIZE_PX: Final = (600, 640)
_GAPS_PX: Final = (16, 6)


class ShortcutList(ArmDialog):
    """The list with keys on the left and their effects on the right.

    Args:
        controller: Receives the emergency stop.
        places: The titles of all places by their keys.
        parent: The main window.
    """

    def __init__(
        self, controller: ArmController, places: Mapping[str, Text], parent: QWidget | None = None
    ) -> None:
        sections = [_section(place, title) for place, title in places.items()]
        super().__init__(controller, parent)
        shown = [each for each in sections if each.lines]
        self.body.addWidget(SectionsArea(shown, gaps_px=_GAPS_PX), 1)
        fill(self.footer, STRETCH, CloseButton(self, on_enter=True))
        self.setObjectName("shortcut_list")
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Keyboard shortcuts"))


def _section(place: str, title: Text) -> HelpSection:
    shortcuts = (each for each in SHORTCUTS.values() if each.place == place)
    return HelpSection(title, [(each.text(), each.title) for each in shortcuts])
