"""The window 本地接口: its switch, its address, the connected clients and what was granted."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QCheckBox, QLabel, QLineEdit, QListWidget, QWidget

from armui.control.events import Level
from armui.interface.reasons import CONSENT_GRANTED, LEASE_ENDED, LEASE_GRANTED, LEASE_REFUSED
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command, Target, also
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.widgets.buttons import caption, describe, named
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.words.event_log import entry_text
from armui.ui.words.settings import setting_label, setting_tip

if TYPE_CHECKING:
    from collections.abc import Mapping

    from PySide6.QtGui import QShowEvent

    from armui.arm.refusal import Refusal
    from armui.control.arm_controller import ArmController
    from armui.interface.interface import Interface
    from armui.settings import SettingsStore

_SIZE_PX: Final = (640, 520)
_CLIENTS_PX: Final = 96
_GRANTS: Final = frozenset(
    each.id for each in (LEASE_GRANTED, LEASE_ENDED, LEASE_REFUSED, CONSENT_GRANTED)
)


class InterfaceDialog(ArmDialog):
    """Switches the local interface, and shows who uses it.

    Args:
        interface: Tells its state.
        store: The setting that switches it on.
        controller: Receives the emergency stop; has the events.
        parent: The main window.
    """

    commands = (
        Command(
            "interface.switch",
            setting_label("interface"),
            synonyms=also("api script socket python 脚本 编程"),
        ),
    )
    copy_path = Act("Copy", named="interface_copy", tip="Copies the path.", whose=True)

    def __init__(
        self,
        interface: Interface,
        store: SettingsStore,
        controller: ArmController,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._interface, self._store = interface, store
        self._unsaved: Refusal | None = None
        self.box = named("interface_box", QCheckBox())
        self._note = text_label(rank="muted", wraps=True, plain=True)
        self._path_label, self.path = QLabel(), named("interface_path", QLineEdit())
        self.path.setReadOnly(True)
        self._path_label.setBuddy(self.path)
        self._clients_label, self.clients = QLabel(), named("interface_clients", QListWidget())
        self.clients.setFixedHeight(_CLIENTS_PX)
        self._grants_label, self.grants = QLabel(), named("interface_grants", QListWidget())
        for shown in (self.clients, self.grants):
            shown.setWordWrap(True)
            shown.setTextElideMode(Qt.TextElideMode.ElideNone)
            shown.setResizeMode(QListWidget.ResizeMode.Adjust)
            shown.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._message = named("interface_message", MessageLine(keeps_room=False))
        fill(
            self.body,
            *(in_row(self.box, STRETCH), self._note),
            in_row(self._path_label, (self.path, 1), self.copy_path, spacing=8),
            *(self._clients_label, self.clients, self._grants_label, (self.grants, 1)),
            self._message,
        )
        fill(self.footer, STRETCH, CloseButton(self, on_enter=True))
        self.resize(*_SIZE_PX)
        self.box.clicked.connect(self._on_box)
        interface.changed.connect(self._on_changed)
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {**super().command_targets(), "interface.switch": self.box}

    def heading(self) -> str:
        """Return the name of what the acts belong to, for a screen reader."""
        return self._path_label.text()

    def _on_box(self) -> None:
        self._unsaved = self._store.change(interface=self.box.isChecked())
        self._refresh()

    @copy_path.pressed
    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(self.path.text())

    def _on_changed(self, _view: object) -> None:
        if self.isVisible():
            self._refresh()

    def showEvent(self, event: QShowEvent) -> None:
        """Show what has happened meanwhile."""
        super().showEvent(event)
        if not event.spontaneous():
            self._unsaved = None
            self._refresh()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(setting_label("interface").text())
        caption(self.box, self.tr("Serve the local interface"))
        self._note.setText(setting_tip("interface").text())
        self._path_label.setText(self.tr("Socket"))
        describe(self.path, self._path_label.text())
        for label, shown, text in (
            (self._clients_label, self.clients, self.tr("Connected now")),
            (self._grants_label, self.grants, self.tr("Granted in this run")),
        ):
            label.setText(text)
            shown.setAccessibleName(text)
        self.show_acts()
        self._refresh()

    def _refresh(self) -> None:
        view = self._interface.view
        self.box.setChecked(self._store.settings.interface)
        self.path.setText(view.path)
        _fill_list(self.clients, [str(each) for each in view.clients])
        entries = reversed(self._controller.event_collector.log.entries())
        granted = [each for each in entries if each.code in _GRANTS]
        _fill_list(self.grants, [f"{each.wall:%H:%M:%S}  {entry_text(each)}" for each in granted])
        problem = self._unsaved or view.problem
        self._message.show_message("" if problem is None else words.refusal(problem), Level.WARNING)


def _fill_list(shown: QListWidget, lines: list[str]) -> None:
    if lines != [shown.item(row).text() for row in range(shown.count())]:
        shown.clear()
        shown.addItems(lines)
