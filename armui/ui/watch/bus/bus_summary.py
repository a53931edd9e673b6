"""The state of the bus in figures and words: load, errors, losses, and what to do about them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QLabel, QWidget

from armui.control.events import Level
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.widgets.buttons import named
from armui.ui.widgets.curve_menu import tell_quantities
from armui.ui.widgets.elided_label import ElidedLabel
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.telemetry.bus_statistics import BusSnapshot

_OLD_S: Final = 1.0
_BUSY_PERCENT: Final = 80.0
_KEYS: Final = ("bus.bus_load", "bus.frames_per_s", "bus.error_frames_per_s")


class BusSummary(Translated, QWidget):
    """Four figures in a row, and below them what is wrong, if anything is.

    Args:
        controller: Knows the connection.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._lost_before = 0
        self._trouble: tuple[str, Level] = ("", Level.INFO)
        self._names = [text_label(rank="muted") for _ in range(4)]
        self.load, self.rate, self.errors, self.lost = self._values = [
            text_label(name) for name in ("bus_load", "bus_rate", "bus_errors", "bus_lost")
        ]
        for key, value in zip(_KEYS, self._values, strict=False):
            tell_quantities(value, key)
        self.counted = named("bus_counted", ElidedLabel())
        self.counted.setProperty("rank", "muted")
        self.paused = text_label("bus_paused", rank="warning")
        row = in_row(spacing=6)
        for name, value in zip(self._names, self._values, strict=True):
            row.addWidget(name)
            row.addWidget(value)
            row.addSpacing(18)
        row.addStretch(1)
        row.addWidget(self.paused)
        row.addSpacing(10)
        row.addWidget(self.counted)
        self.message = named("bus_message", MessageLine())
        self.message.hide()
        in_column(row, self.message, on=self, spacing=6, margins=0)
        self.retranslate_ui()

    def begin(self) -> None:
        """Losses are counted from now on."""
        self._lost_before = self._controller.bus.frames_dropped

    def show_bus(self, snapshot: BusSnapshot, now_s: float, counted: str, paused: str) -> None:
        """Show how the bus is.

        Args:
            snapshot: What was counted.
            now_s: Monotonic time.
            counted: Since when, in words.
            paused: That the figures below stand, in words; "": they do not.
        """
        load = self._latest("bus.bus_load", now_s)
        _put(self.load, f"{fmt.number(load, 0)} %" if load is not None else fmt.NOTHING)
        rate = self._latest("bus.frames_per_s", now_s)
        _put(self.rate, f"{fmt.number(rate, 0)} /s" if rate is not None else fmt.NOTHING)
        errors = self._latest("bus.error_frames_per_s", now_s)
        often = f" ({fmt.number(errors, 0)} /s)" if errors else ""
        _put(self.errors, f"{snapshot.error_frames}{often}")
        _put(self.lost, str(self._lost))
        if self.counted.text() != counted:
            self.counted.show_text(counted)
        _put(self.paused, paused)
        self._show_trouble(snapshot, load)

    @property
    def _lost(self) -> int:
        dropped = self._controller.bus.frames_dropped
        self._lost_before = min(self._lost_before, dropped)  # another device counts anew
        return dropped - self._lost_before

    def _latest(self, key: str, now_s: float) -> float | None:
        latest = self._controller.telemetry.latest(key)
        if latest is None or now_s - latest[0] > _OLD_S or not math.isfinite(latest[1]):
            return None
        return latest[1]

    def _show_trouble(self, snapshot: BusSnapshot, load: float | None) -> None:
        operating_state = self._controller.operating_state
        found: list[str] = []
        level = Level.WARNING
        if operating_state.link_problem is not None:
            found.append(words.refusal(operating_state.link_problem))
            level = Level.FAULT
        if self._lost:
            text = self.tr(
                "{count} frames were lost before the program could read them: the computer is too "
                "busy, or the adapter too slow. What is shown is not all that was on the bus."
            )
            found.append(text.format(count=self._lost))
        if load is not None and load >= _BUSY_PERCENT:
            found.append(
                self.tr("The bus is nearly full: frames of low rank come late. Have less sent.")
            )
        if snapshot.left_out or snapshot.beyond:
            text = self.tr(
                "Not counted here: {late} frames that came while the window was held up, {more} of "
                "identifiers beyond the first {rows}."
            )
            rows = len(snapshot.rows)
            found.append(text.format(late=snapshot.left_out, more=snapshot.beyond, rows=rows))
        trouble = " ".join(found), level
        if trouble != self._trouble:
            self._trouble = trouble
            self.message.show_message(*trouble)
            self.message.setVisible(bool(found))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        texts = (
            self.tr("Bus load"),
            self.tr("Frames"),
            self.tr("Error frames"),
            self.tr("Lost frames"),
        )
        tips = (
            self.tr("Of the bit rate, stuff bits not counted; right button: show as curve"),
            self.tr("A second, those of this program included"),
            self.tr("Errors on the bus that the adapter has reported since the counting began"),
            self.tr("Lost by the system's queue or by the adapter since the counting began"),
        )
        for name, value, text, tip in zip(self._names, self._values, texts, tips, strict=True):
            name.setText(text)
            name.setToolTip(tip)
            value.setToolTip(tip)
            value.setAccessibleName(text)
        self._trouble = ("", Level.INFO)


def _put(label: QLabel, text: str) -> None:
    """Text that is the same is not laid out anew."""
    if label.text() != text:
        label.setText(text)
