"""The declaration of a page or window: its titles, its place, its class, how it is created."""

from __future__ import annotations

import enum
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from armui.ui.actions.command import Command
    from armui.ui.dialogs.base import ArmDialog
    from armui.ui.widgets.page import Page
    from armui.ui.words.text import Text

_Opener = TypeVar("_Opener")


class Home(enum.Enum):
    """The part of the program that shows a page."""

    BESIDE = enum.auto()
    """Beside the 3D picture, in the place of the panels."""
    DRAWER = enum.auto()
    """A tab of the drawer."""
    WINDOW = enum.auto()
    """A window of its own."""


@dataclass(frozen=True)
class PageEntry(Generic[_Opener]):
    """The declaration of a page or window; its functions are called with the opener.

    Attributes:
        title: Its title, also of its tab and its button.
        home: Where it is shown; a page can be moved from there into a window of its own.
        kind: Loads and returns its class, which declares its commands.
        make: Creates it when it is first opened; ``None`` if that is left to `show`.
        tip: Its purpose, for its tab and its button.
        command: Opens it from the command palette.
        beside_menu: True if it has a button below the menu, of the name ``<key>_button``.
        show: Shows it, if that is more than to create and open it.
    """

    title: Text
    home: Home
    kind: Callable[[], type[Page | ArmDialog]]
    make: Callable[[_Opener], Page | ArmDialog] | None = None
    tip: Text | None = None
    command: Command | None = None
    beside_menu: bool = False
    show: Callable[[_Opener], object] | None = None

    @property
    def movable(self) -> bool:
        """True if it can be moved into a window of its own."""
        return self.home is not Home.WINDOW

    @property
    def tip_text(self) -> str:
        """The purpose of the page in the present language; empty if none is declared."""
        return "" if self.tip is None else self.tip.text()
