"""The command palette: everything that can be done, found by a piece of its name (Ctrl+K)."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QShowEvent
from PySide6.QtWidgets import QAbstractItemView, QLineEdit, QListView, QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui.actions.catalogue import synonyms
from armui.ui.actions.names import Names, read_names
from armui.ui.actions.offer import Doing, Offer, Offers, nothing_to_do
from armui.ui.actions.offer_list import OfferDelegate, OfferModel
from armui.ui.actions.search import SearchText, rank
from armui.ui.background import Background, Job
from armui.ui.dialogs.base import ArmDialog
from armui.ui.widgets.buttons import named
from armui.ui.widgets.message_line import MessageLine

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_SIZE_PX: Final = (440, 600)
"""As wide as the panel it opens over: the picture stays free."""
_FOLLOW_MS: Final = 200
_PLACE: Final = QPoint(184, 72)
"""In the main window: right of the menu, below the stop."""
_TO_THE_LIST: Final = frozenset(
    {Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown}
)


class CommandPalette(ArmDialog):
    """A search above a list; Enter does what is chosen there, by its own button.

    It is a window beside the others, and takes no key and no press from them: stop and halt work
    as they do everywhere, and stand on it, too.

    Args:
        controller: Whom the emergency stop tells, and who knows why something cannot be done.
        offers: What is offered.
        background: Where names are read from their file.
        parent: The main window.
    """

    def __init__(
        self, controller: ArmController, offers: Offers, background: Background, parent: QWidget
    ) -> None:
        super().__init__(controller, parent)
        self.setObjectName("command_palette")
        self._source = offers
        self._names = Names()
        self._offers: list[tuple[Offer, SearchText]] = []
        self.search = named("palette_search", QLineEdit())
        self.search.setClearButtonEnabled(True)
        self.search.installEventFilter(self)
        self.list = named("palette_list", QListView())
        self._model = OfferModel()
        self.list.setModel(self._model)
        self.list.setItemDelegate(OfferDelegate(self.list))
        self.list.setUniformItemSizes(False)
        self.list.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._message = named("palette_message", MessageLine())
        self.body.addWidget(self.search)
        self.body.addWidget(self.list, 1)
        self.body.addWidget(self._message)
        self.resize(*_SIZE_PX)
        self._timer = QTimer(self, interval=_FOLLOW_MS, singleShot=True)
        self._timer.timeout.connect(self._gather)
        controller.operating_state_changed.connect(self._follow)
        self.search.textChanged.connect(self._show_found)
        self.list.activated.connect(self._on_chosen)
        self.list.clicked.connect(self._on_chosen)
        self.list.selectionModel().currentChanged.connect(self._message.hide)
        self.retranslate_ui()
        background.begin_here(Job(self._take_names), read_names)

    @property
    def knows_names(self) -> bool:
        """Whether the other language and pinyin are found, too: their file has been read."""
        return self._names.known

    # -- what is offered ----------------------------------------------------------------------

    def _take_names(self, names: Names | Refusal) -> None:
        if isinstance(names, Names):
            self._names = names
            if self.isVisible():
                self._gather()

    def _follow(self) -> None:
        if self.isVisible() and not self._timer.isActive():
            self._timer.start()

    def _gather(self) -> None:
        """Ask anew what can be done; what is chosen stays chosen."""
        if not self.isVisible():
            return
        self._offers = [
            (
                offer,
                self._names.search_text(offer.title, offer.place, synonyms(offer.name)),
            )
            for offer in self._source.now(self)
        ]
        self._show_found(keep=True)

    def _show_found(self, *_args: object, keep: bool = False) -> None:
        query = self.search.text()
        before = self._chosen() if keep else None
        told = self._message.isVisible() and before is not None
        ranked = [(rank(query, text), place) for place, (_, text) in enumerate(self._offers)]
        found = [
            # nobody comes upon what is dangerous by Enter while anything else is called so
            (bool(query.strip()) and self._offers[place][0].dangerous, how, place)
            for how, place in ranked
            if how is not None
        ]
        found.sort()
        self._model.show_offers([self._offers[place][0] for _, _, place in found])
        self.list.setCurrentIndex(self._model.index(self._model.row_like(before), 0))
        chosen = self._chosen()
        if chosen is None:
            self._show_reason(None)
        else:  # the reason that was told stays as long as what it was told of is chosen
            self._message.setVisible(told and before is not None and chosen.is_like(before))

    def _chosen(self) -> Offer | None:
        return self._model.offer(self.list.currentIndex().row())

    def _show_reason(self, offer: Offer | None) -> None:
        """Say why what is wanted cannot be done, or that nothing was found."""
        if offer is None:
            text = self.tr("Nothing is called so. Chinese, English, pinyin and initials are found.")
            self._message.show_message(text)
        else:
            self._message.show_message(offer.reason, Level.WARNING)
        self._message.show()

    # -- what the operator does ---------------------------------------------------------------

    def _on_chosen(self) -> None:
        offer = self._chosen()
        if offer is not None and not offer.reason and offer.show is not None:
            offer = self._look(offer.show, offer.point_out)
        if offer is None or offer.reason or not self.isVisible():
            self._show_reason(offer)
            return
        self.close()
        offer.do()

    def _look(self, show: Doing, point_out: Doing | None) -> Offer | None:
        """Open the page on which something is done; the same offer, as it stands there.

        Args:
            show: Opens it.
            point_out: What is done then instead of it, if anything.
        """
        show()
        self._gather()
        offer = self._chosen()
        if offer is not None and offer.show is not None:  # its button is not there just now
            offer = replace(offer, reason=nothing_to_do())
        if offer is not None and offer.reason:
            self.raise_()
            self.activateWindow()
            self.search.setFocus()
        if offer is not None and point_out is not None:
            offer = replace(offer, do=point_out)
        return offer

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """In the search the arrows move through the list, and Enter does what is chosen."""
        pressed = event.type() == QEvent.Type.KeyPress
        if watched is self.search and pressed and isinstance(event, QKeyEvent):
            if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
                self._on_chosen()
                return True
            if event.key() in _TO_THE_LIST:
                self.list.event(event)
                return True
        return super().eventFilter(watched, event)

    def showEvent(self, event: QShowEvent) -> None:
        """Begin anew at each opening, over the panel and beside the picture."""
        super().showEvent(event)
        if event.spontaneous():
            return
        window = self.parentWidget()
        if window is not None:
            self.move(window.mapToGlobal(window.rect().topLeft()) + _PLACE)
        self.search.clear()
        self.search.setFocus()
        self._gather()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Commands"))
        self.search.setPlaceholderText(self.tr("Name, pinyin or initials, in Chinese or English"))
        self.search.setAccessibleName(self.tr("Search for a command"))
        self.list.setAccessibleName(self.tr("Commands found"))
        self._gather()
