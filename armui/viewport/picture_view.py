"""The widget that shows the picture of a process of its own, and says where it lags or is gone."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

from PySide6.QtCore import (
    QCoreApplication,
    QEvent,
    QPoint,
    QPointF,
    QRectF,
    QSize,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QPushButton, QWidget

from armui.viewport.client import Picture, PictureClient
from armui.viewport.hud import Hud, HudValues
from armui.viewport.overlay import add_again_button, lost_text, paint_image, paint_plate
from armui.viewport.view_state import ViewState

if TYPE_CHECKING:
    from PySide6.QtGui import (
        QCloseEvent,
        QFocusEvent,
        QImage,
        QPaintEvent,
        QResizeEvent,
        QShowEvent,
    )

    from armui.viewport.news import Lost
    from armui.viewport.palette import ScenePalette
    from armui.viewport.view_state import RobotChoice

_VIEWERS = itertools.count()
_START_MS = 20
_FIGURES_WAIT_MS = 50
"""So long new figures wait for the picture of the same moment, to be painted with it."""


_MOST_ASKED = 128


class PictureView(QWidget):
    """Shows the newest picture with the measured figures over it.

    Nothing is drawn while the widget can't be seen. Where the picture lags behind what it should
    show, or is gone, the widget says so (safety promise S24).

    Signals:
        load_failed: why a robot description can't be shown, a `Refusal` with one of the codes
            `armui.arm.refusal_codes.RefusalCode`; the old one stays.
        first_frame_shown: the arm is on the screen for the first time.
        settled: the picture on the screen shows the newest state, see `is_settled`.

    Args:
        robot: what to begin with.
        palette: colours to begin with.
        client: has the pictures drawn; whoever gives one ends it. One of its own by default.
    """

    load_failed = Signal(object)
    first_frame_shown = Signal()
    settled = Signal()

    def __init__(
        self,
        robot: RobotChoice,
        palette: ScenePalette,
        client: PictureClient | None,
        parent: QWidget | None,
    ) -> None:
        super().__init__(parent)
        self._state = ViewState(robot, palette=palette, viewer=next(_VIEWERS))
        self._asked: dict[int, ViewState] = {}
        self._shown: ViewState | None = None
        self._hud = HudValues()
        self._hud_painter = Hud()
        self._picture: Picture | None = None
        self._is_frame_new = False
        self._lost: Lost | None = None
        self._is_started = False
        self._is_shut_down = False
        self._owns_client = client is None
        self._client = client or PictureClient(parent=self)
        self._client.frame_ready.connect(self._on_frame_ready)
        self._client.load_failed.connect(self.load_failed)
        self._client.lost.connect(self._on_lost)
        self._client.aged.connect(self.update)
        self._again_button = add_again_button(self, self._start_again)
        self._figures_wait = QTimer(self, singleShot=True, interval=_FIGURES_WAIT_MS)
        self._figures_wait.timeout.connect(self._paint_figures)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(240, 200)
        application = QCoreApplication.instance()
        if application is not None:
            # A child gets no close event when its window closes.
            application.aboutToQuit.connect(self.shutdown)
        self.retranslate_ui(self._again_button)

    def sizeHint(self) -> QSize:
        """Room for the arm and the figures."""
        return QSize(720, 640)

    @property
    def is_settled(self) -> bool:
        """Whether the picture on the screen shows the newest state, with smooth edges."""
        return self._picture is not None and not self._is_frame_new and self._client.is_settled

    @property
    def has_given_up(self) -> bool:
        """Whether there is no picture, and none will come by itself."""
        return self._lost is not None and not self._lost.comes_back

    @property
    def is_current(self) -> bool:
        """Whether what is on the screen may be taken for what is there now."""
        return self._picture is not None and not self._notice()

    @property
    def is_late(self) -> bool:
        """Whether the picture lags, or is gone: nothing is aimed at in it."""
        return self._client.looks_old or self._lost is not None

    def taken_picture(self) -> QImage | None:
        """A copy of the picture with the figures, as it is on the screen; None without one."""
        return None if self._picture is None else self.grab().toImage()

    def shutdown(self) -> None:
        """End drawing for good and wait for it; may be called twice."""
        self._is_shut_down = True
        if self._owns_client:
            self._client.stop()

    # what a picture with a camera adds ---------------------------------------------------------

    def _resized(self) -> None:
        """The picture has another size."""

    def _is_worth_showing(self, _shown: ViewState) -> bool:
        """Whether the first picture may be shown; otherwise the next is waited for."""
        return True

    def _paint_over(self, painter: QPainter, shown: ViewState) -> None:
        """Draw over the picture, by the camera and the angles it was drawn with."""

    # what is asked for, and what comes ---------------------------------------------------------

    def _show(self, state: ViewState) -> None:
        self._state = state
        if self._client.is_running and self.isVisible() and not self._is_shut_down:
            self._client.show(state)
            self._asked[self._client.sequence] = state
            if len(self._asked) > _MOST_ASKED:  # no picture has come for seconds
                del self._asked[min(self._asked)]

    def _set_hud(self, values: HudValues) -> None:
        if values == self._hud:
            return
        self._hud = values
        if not self._client.is_running or self._client.is_settled or self._lost is not None:
            self._paint_figures()  # no picture is on its way
        elif not self._figures_wait.isActive():
            self._figures_wait.start()

    def _paint_figures(self) -> None:
        self.update(self._hud_painter.frame(self.font()).toAlignedRect())

    def _fit_size(self) -> None:
        """Ask for a picture as large as the widget, in device pixels."""
        ratio = self.devicePixelRatioF()
        self._state = self._state._replace(
            width_px=max(1, round(self.width() * ratio)),
            height_px=max(1, round(self.height() * ratio)),
            pixel_ratio=ratio,
        )
        self._resized()
        self._show(self._state)

    def _start(self) -> None:
        if self.isVisible() and not self._is_shut_down and not self._client.is_running:
            self._client.start()
            self._fit_size()

    def _start_again(self) -> None:
        self._again_button.hide()
        self._lost = None
        self._client.start()
        self.update()

    def _on_frame_ready(self, picture: Picture) -> None:
        is_first = self._picture is None
        sequence = picture.frame.sequence
        shown = self._asked.get(sequence, self._state)
        self._asked = {each: state for each, state in self._asked.items() if each >= sequence}
        if is_first and not self._is_worth_showing(shown):
            self._client.frame_used(picture)
            return
        self._picture = picture
        self._shown = shown
        self._is_frame_new = True
        self._lost = None
        self._figures_wait.stop()
        self.update()
        if is_first:
            self.first_frame_shown.emit()

    def _on_lost(self, lost: Lost) -> None:
        self._lost = lost
        self._again_button.setVisible(not lost.comes_back)
        self.update()

    def _notice(self) -> str:
        """What is wrong with the picture, in words; empty when nothing is."""
        if self._lost is not None:
            return lost_text(self._lost)
        if self._picture is None:
            return QCoreApplication.translate("ArmView", "Loading the 3D model …")
        late = QCoreApplication.translate("ArmView", "Picture delayed")
        return late if self._client.looks_old else ""

    def retranslate_ui(self, button: QPushButton) -> None:
        """Put the words into the operator's language."""
        button.setText(QCoreApplication.translate("ArmView", "Start the 3D view again"))

    def quantities_at(self, place: QPoint) -> list[str]:
        """The key of the figure at a place; see `armui.telemetry.quantities`."""
        key = self._hud_painter.quantity_at(QPointF(place), self.font())
        return [] if key is None else [key]

    # events -----------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Ask for a picture of the size shown."""
        super().showEvent(event)
        self._fit_size()

    def closeEvent(self, event: QCloseEvent) -> None:
        """End drawing: as a window of its own the view is closed for good."""
        self.shutdown()
        super().closeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Ask for a picture of the new size."""
        super().resizeEvent(event)
        self._fit_size()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Show the last picture, the figures and, if need be, why there is no picture."""
        palette = self._state.palette
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        notice = self._notice()
        image = None if self._picture is None else self._picture.image
        paint_image(painter, self.size(), image, palette, faded=bool(notice))
        if self._shown is not None and not notice:
            self._paint_over(painter, self._shown)
        self._hud_painter.paint(painter, self._hud, palette, self.font())
        if notice:
            paint_plate(painter, self.rect(), notice, palette)
        if self.hasFocus():
            painter.setPen(QPen(QColor(palette.accent), 1.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5))
        painter.end()
        if not self._is_started:
            # Loading the libraries is work for a window that the operator already sees.
            self._is_started = True
            QTimer.singleShot(_START_MS, self, self._start)
        if self._is_frame_new and self._picture is not None:
            # Only a picture on the screen makes room for the next: a covered window draws nothing.
            self._is_frame_new = False
            self._client.frame_used(self._picture)
            if self._client.is_settled:
                self.settled.emit()
        if not math.isclose(self._state.pixel_ratio, self.devicePixelRatioF()):
            self._fit_size()

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate_ui(self._again_button)
            self.update()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show the focus."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Show that the focus is gone."""
        super().focusOutEvent(event)
        self.update()
