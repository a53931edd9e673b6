"""The window 最近删除: deleted trajectories that can still be restored."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import QObject, QSize, Signal
from PySide6.QtWidgets import QAbstractItemView, QTableWidgetItem, QWidget

from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.trajectory.library.bin import KEPT
from armui.trajectory.library.folders import shown_folder
from armui.trajectory.library.store import Deleted
from armui.ui.actions.act import Act, HasActs
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.trajectory.library.library_actions import LibraryActions
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, fill
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.table_model import plain_table
from armui.ui.widgets.text_label import text_label

_SIZE: Final = QSize(680, 460)
_ROW_PX: Final = 34
_DATE_PX: Final = 160


class BinDialog(ArmDialog):
    """Lists everything that was deleted, the last first; other objects restore it.

    Signals:
        wanted: The list of :class:`Deleted` to be restored.
    """

    wanted = Signal(object)
    _back = Act("Restore", named="bin_back", primary=True, on_enter=True)

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(controller, parent)
        self._deleted: Sequence[Deleted] = ()
        self._text = text_label("bin_text", rank="muted", wraps=True)
        self._table = plain_table("bin_table", 3, wide=0)
        self._table.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self._table.setWordWrap(False)
        self._table.verticalHeader().setDefaultSectionSize(_ROW_PX)
        for column in (1, 2):
            self._table.setColumnWidth(column, _DATE_PX)
        self._message = named("bin_message", MessageLine(keeps_room=False))
        fill(self.body, self._text, (self._table, 1), self._message)
        fill(self.footer, STRETCH, self._back, CloseButton(self))
        self._table.itemSelectionChanged.connect(self._show_usable)
        self._table.itemDoubleClicked.connect(lambda _item: self._back.click())
        self.retranslate_ui()
        self.resize(_SIZE)
        self._table.setFocus()

    def show_deleted(self, deleted: Sequence[Deleted]) -> None:
        """List what can be restored now."""
        self._deleted = deleted
        self._fill()

    def show_message(self, text: Words, level: Level = Level.INFO) -> None:
        """Show a result."""
        self._message.show_message(text, level)

    def _fill(self) -> None:
        self._table.clearContents()
        self._table.setRowCount(len(self._deleted))
        for row, one in enumerate(self._deleted):
            # the star stands for unsaved changes, as in the list of the library
            star = " *" if one.only_draft else ""
            folder = f" · {shown_folder(one.folder)}" if one.folder else ""
            texts = (
                f"{', '.join(one.names)}{star}{folder}",
                f"{one.when.astimezone():%Y-%m-%d %H:%M}",
                f"{(one.when + KEPT).astimezone():%Y-%m-%d}",
            )
            for column, text in enumerate(texts):
                self._table.setItem(row, column, QTableWidgetItem(text))
        if self._deleted:
            self._table.selectRow(0)
        self._show_usable()

    @_back.why_not
    def _why_not_restore(self) -> str:
        chosen = self._table.selectionModel().selectedRows()
        return "" if chosen else self.tr("Choose what to restore")

    @_back.pressed
    def _on_restore(self) -> None:
        rows = sorted(index.row() for index in self._table.selectionModel().selectedRows())
        self.wanted.emit([self._deleted[row] for row in rows])

    def _show_usable(self) -> None:
        self.show_acts()
        days = KEPT.days
        if self._deleted:
            text = self.tr(
                "Deleted trajectories can be restored for {days} days. If a name has been "
                "taken meanwhile, a number is added."
            )
        else:
            text = self.tr("Nothing has been deleted in the last {days} days.")
        self._text.setText(text.format(days=days))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Recently deleted"))
        self._table.setHorizontalHeaderLabels(
            [self.tr("Name"), self.tr("Deleted"), self.tr("Kept until")]
        )
        self._table.setAccessibleName(self.tr("Recently deleted"))
        self._show_usable()


class RecentlyDeleted(HasActs, QObject):
    """Opens the window by a button, and keeps its list up to date.

    Args:
        controller: Receives the emergency stop.
        work: Reads from the library what was deleted.
        actions: Restores, and reports the result.
        page: The page with the button.
    """

    button = Act("Recently deleted…", named="library_bin", key="library.bin")

    def __init__(
        self, controller: ArmController, work: LibraryWork, actions: LibraryActions, page: QWidget
    ) -> None:
        super().__init__(page)
        self._controller = controller
        self._work = work
        self._actions = actions
        self._page = page
        self._dialog: BinDialog | None = None

    @button.pressed
    def _open(self) -> None:
        if self._dialog is None:
            self._dialog = BinDialog(self._controller, self._page.window())
            # it is deleted with its parent window, which may be a page's own window
            self._dialog.destroyed.connect(self._on_gone)
            self._dialog.wanted.connect(self._actions.bring_back)
            self._actions.message_changed.connect(self._dialog.show_message)
        self._dialog.show_message("")
        self.refresh()
        self._dialog.open()

    def refresh(self) -> None:
        """Update the list, if the window was opened."""
        if self._dialog is not None:
            self._work.do(self._work.library.recently_deleted, self._on_read, self._on_refused)

    def _on_gone(self) -> None:
        self._dialog = None

    def _on_read(self, deleted: Sequence[Deleted]) -> None:
        if self._dialog is not None:
            self._dialog.show_deleted(deleted)

    def _on_refused(self, text: str) -> None:
        if self._dialog is not None:
            self._dialog.show_deleted(())
            self._dialog.show_message(text, Level.FAULT)
