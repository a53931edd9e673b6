"""The window «About this arm»: what is known of it, for the operator and for a support mail (B17).

Each value is one that was heard, read or set; what the arm does not tell is said to be unknown.
"""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QWidget

from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.doctor.facts import LinkFacts
from armui.doctor.probes.can_devices import look_at_links
from armui.ui.background import Background, Job
from armui.ui.dialogs.about_arm_rows import AboutRow, about_rows
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.close_button import CloseButton
from armui.ui.dialogs.online_since import OnlineSince
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.layouts import empty_grid, fill
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import text_label

_SIZE_PX: Final = (720, 720)
_REFRESH_MS: Final = 1000
_LEAST_S: Final = 0.5
_COLUMN_GAP_PX: Final = 28
_ROW_GAP_PX: Final = 4


class AboutArmDialog(ArmDialog):
    """Shows the values, fresh every second while it is open.

    Args:
        controller: Who hears the arm.
        online: Knows since when.
        background: Asks the operating system for the bit rate of its CAN interfaces.
        parent: The main window.
    """

    def __init__(
        self,
        controller: ArmController,
        online: OnlineSince,
        background: Background,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._online = online
        self._background = background
        self._links: tuple[LinkFacts, ...] = ()
        self._looking = False
        self._before: tuple[int, float] | None = None
        self._rate: float | None = None
        self._rows: list[AboutRow] = []
        self._labels: list[tuple[QLabel, QLabel]] = []
        self._build()
        self.resize(*_SIZE_PX)
        self._timer = SeenTimer(self, _REFRESH_MS, self._refresh)
        self.copy_button.clicked.connect(self._on_copy)
        controller.operating_state_changed.connect(self._on_state_changed)
        self.retranslate_ui()

    def _build(self) -> None:
        self._grid_widget = QWidget()
        self._grid = empty_grid(self._grid_widget, gaps=(_COLUMN_GAP_PX, _ROW_GAP_PX), margins=0)
        self._grid.setColumnStretch(1, 1)
        area = named("about_arm_values", QScrollArea())
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidget(self._grid_widget)
        area.viewport().setAutoFillBackground(False)
        self._grid_widget.setAutoFillBackground(False)
        self._said = text_label("about_arm_said", rank="muted")
        self.copy_button = push_button("about_arm_copy", on_enter=False)
        self.body.addWidget(area, 1)
        fill(self.footer, self.copy_button, (self._said, 1), CloseButton(self, on_enter=True))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("About this arm"))
        self.copy_button.setText(self.tr("Copy as text"))
        self._refresh()

    def showEvent(self, event: QShowEvent) -> None:
        """Look anew."""
        super().showEvent(event)
        if not event.spontaneous():
            self._before = self._rate = None
            self._said.clear()
            self._look_at_links()
            self._refresh()

    def text(self) -> str:
        """Everything that is shown, a line each."""
        return "".join(f"{row.label}: {row.value}\n" for row in self._rows)

    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text())
        self._said.setText(self.tr("Copied: paste it into a mail."))

    def _on_state_changed(self) -> None:
        if self.isVisible():
            self._look_at_links()
            self._refresh()

    def _look_at_links(self) -> None:
        device = self._controller.operating_state.device
        if self._looking or device is None or device.interface != "socketcan":
            return
        self._looking = True
        self._background.begin_here(Job(self._on_links), look_at_links)

    def _on_links(self, links: tuple[LinkFacts, ...] | Refusal) -> None:
        self._looking = False
        self._links = () if isinstance(links, Refusal) else links
        self._refresh()

    def _refresh(self) -> None:
        self._measure_rate()
        self._rows = about_rows(
            self._controller.state,
            self._controller.operating_state,
            self._links,
            online_s=self._online.seconds(),
            frames_per_s=self._rate,
        )
        while len(self._labels) < len(self._rows):
            self._add_row()
        for (name, value), row in zip(self._labels, self._rows, strict=True):
            if value.text() != row.value or name.text() != row.label:
                name.setText(row.label)
                value.setText(row.value)
                value.setObjectName(f"about_{row.key}")
                value.setAccessibleName(f"{row.label}: {row.value}")

    def _measure_rate(self) -> None:
        """Frames a second by the time of the feedback, since the last look a second ago."""
        state = self._controller.state
        if state.last_feedback_s is None:
            self._before = self._rate = None
            return
        now = (state.frames, state.last_feedback_s)
        if self._before is None or now[0] < self._before[0]:
            self._before = now
            return
        frames, seconds = now[0] - self._before[0], now[1] - self._before[1]
        if seconds >= _LEAST_S:
            self._rate = frames / seconds
            self._before = now

    def _add_row(self) -> None:
        name, value = QLabel(), QLabel()
        name.setProperty("rank", "muted")
        name.setAlignment(Qt.AlignmentFlag.AlignTop)
        value.setTextFormat(Qt.TextFormat.PlainText)
        value.setWordWrap(True)
        value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        row = len(self._labels)
        self._grid.addWidget(name, row, 0)
        self._grid.addWidget(value, row, 1)
        self._grid.setRowStretch(row + 1, 1)
        self._grid.setRowStretch(row, 0)
        self._labels.append((name, value))
