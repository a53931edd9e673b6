"""The folder whose trajectories are listed, and what can be done with folders."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QMenu

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.trajectory.library.file_names import folded
from armui.trajectory.library.folders import FOLDER_TAKEN, check_folder_name, shown_folder
from armui.trajectory.library.store import IndexEntry, Listing
from armui.ui.actions.act import Act, HasActs
from armui.ui.trajectory.library.library_actions import LibraryActions
from armui.ui.trajectory.library.name_bar import NameBar, NameQuestion
from armui.ui.widgets.buttons import enable_or_explain, give_menu, named

_CHOICE_PX: Final = 110


class FolderBar(HasActs, QObject):
    """Shows the choice of the folder that is listed, and two menus, beside the search.

    Args:
        actions: Makes, renames and deletes folders, and moves trajectories.
        name_bar: Asks for names.
        chosen: Returns the selected entries.
        parent: Its owner.

    Attributes:
        choice: The list of the folders; all trajectories come first.
        menu_button: Opens the menu of the folder.
        move_button: Opens the menu of the folders to move to.

    Signals:
        shown_changed: Another folder is listed.
        message_changed: A text and its :class:`Level`.
    """

    shown_changed = Signal()
    message_changed = Signal(object, object)
    menu_button = Act(
        "Folder",
        named="library_folder_menu",
        tip="New folder; rename or delete the one that is listed",
        key="library.folder_menu",
    )
    move_button = Act(
        "Move to…", named="library_move", tip="Moves what is chosen to a folder", key="library.move"
    )

    def __init__(
        self,
        actions: LibraryActions,
        name_bar: NameBar,
        chosen: Callable[[], Sequence[IndexEntry]],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._actions = actions
        self._name_bar = name_bar
        self._chosen = chosen
        self._folders: tuple[str, ...] = ()
        self._closed: tuple[str, ...] = ()
        self._shown = ""
        self.choice = named("library_folder", QComboBox())
        self.choice.setMinimumWidth(_CHOICE_PX)
        self.choice.activated.connect(self._on_activated)
        for button in (self.menu_button, self.move_button):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the focus in the list
        self._menu = QMenu(self.menu_button, toolTipsVisible=True)
        acts = {"create": self._create, "rename": self._rename, "delete": self._delete}
        self._acts = {name: self._menu.addAction("") for name in acts}
        for name, act in acts.items():
            self._acts[name].triggered.connect(lambda _on=False, act=act: act())
        give_menu(self.menu_button, self._menu)
        self._targets = QMenu(self.move_button)
        give_menu(self.move_button, self._targets)
        self.retranslate()

    @property
    def shown(self) -> str:
        """The sub-folder that is listed; "" if all trajectories are."""
        return self._shown

    def show_listing(self, listing: Listing) -> None:
        """Offer the folders there are now; if the one listed is gone, that is said."""
        if (listing.folders, listing.closed) == (self._folders, self._closed):
            return
        self._folders, self._closed = listing.folders, listing.closed
        gone = self._shown if self._shown not in ("", *self._folders) else ""
        if gone:
            self._shown = ""
        self.retranslate()
        if gone:
            text = self.tr(
                "The folder “{name}” is gone: it was renamed, moved or deleted elsewhere. All "
                "trajectories are listed."
            )
            self.message_changed.emit(text.format(name=shown_folder(gone)), Level.WARNING)
            self.shown_changed.emit()
        closed = [name for name in self._closed if name == self._shown]
        if closed:
            self._say_closed()

    def show_chosen(self) -> None:
        """Enable “Move to…” only for entries that can be moved; say why not otherwise."""
        self.show_acts()

    @move_button.why_not
    def _why_not_move(self) -> str:
        entries = self._chosen()
        if not entries:
            return self.tr("Choose a trajectory in the list first")
        if any(entry.kind == "draft" for entry in entries):
            return self.tr("Not saved yet. Open it and save it first")
        return "" if self._folders else self.tr("There is no folder yet. Make one first")

    def show_all(self) -> None:
        """List the trajectories of all folders."""
        self._show("")

    def _on_activated(self, place: int) -> None:
        self._show(("", *self._folders)[place])
        if self._shown in self._closed:
            self._say_closed()

    def _show(self, folder: str) -> None:
        changed, self._shown = folder != self._shown, folder
        self.retranslate()
        if changed:
            self.shown_changed.emit()

    def _say_closed(self) -> None:
        text = self.tr(
            "The folder “{name}” cannot be read. Check the rights to it, and its disk or network "
            "share."
        )
        self.message_changed.emit(text.format(name=shown_folder(self._shown)), Level.WARNING)

    # What is done with folders ----------------------------------------------------------------

    def _create(self) -> None:
        self._ask(
            lambda: self.tr("Create"),
            "",
            lambda name: self._actions.create_folder(
                name, partial(self._follow, name), self._name_bar.refuse
            ),
        )

    def _rename(self) -> None:
        old = self._shown
        self._ask(
            lambda: self.tr("Rename"),
            old,
            lambda name: self._actions.rename_folder(
                old, name, partial(self._follow, name), self._name_bar.refuse
            ),
        )

    def _ask(self, act: Callable[[], str], old: str, give: Callable[[str], object]) -> None:
        def why_not(name: str) -> Refusal | None:
            others = {folded(each) for each in self._folders if each != old}
            return FOLDER_TAKEN(name=name) if folded(name) in others else check_folder_name(name)

        self._name_bar.ask(
            NameQuestion(
                label=lambda: self.tr("Name of the folder"),
                act=act,
                suggest=lambda: shown_folder(old),
                why_not=why_not,
                give=give,
            )
        )

    def _follow(self, name: str) -> None:
        """List the folder that was just made or renamed."""
        self._name_bar.put_away()
        self._folders = tuple(sorted({*self._folders, name}))
        self._show(name)

    def _delete(self) -> None:
        self._actions.delete_folder(self._shown, self.show_all)

    # Texts ------------------------------------------------------------------------------------

    def retranslate(self) -> None:
        """Set all texts in the operator's language."""
        self.choice.clear()
        self.choice.addItems([self.tr("All folders"), *map(shown_folder, self._folders)])
        self.choice.setCurrentIndex(("", *self._folders).index(self._shown))
        self.choice.setAccessibleName(self.tr("Folder"))
        self.choice.setToolTip(self.tr("The folder whose trajectories are listed"))
        self._acts["create"].setText(self.tr("New folder…"))
        self._acts["rename"].setText(self.tr("Rename the folder…"))
        self._acts["delete"].setText(self.tr("Delete the folder"))
        for name in ("rename", "delete"):
            reason = "" if self._shown else self.tr("Choose the folder in the list first")
            enable_or_explain(self._acts[name], reason)
        self._targets.clear()
        for folder in ("", *self._folders):
            action = QAction(self._target_text(folder), self._targets)
            action.triggered.connect(partial(self._on_target, folder))
            self._targets.addAction(action)
        self.show_acts()

    def _target_text(self, folder: str) -> str:
        """Return a folder's name for a menu, in which “&” would mark a key."""
        return shown_folder(folder).replace("&", "&&") or self.tr("Into no folder")

    def _on_target(self, folder: str, _checked: bool = False) -> None:
        self._actions.move([entry.name for entry in self._chosen()], folder)
