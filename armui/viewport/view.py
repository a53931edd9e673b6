"""The widget that shows the arm and moves the camera."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
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

from armui.arm.limits import JOINTS
from armui.viewport.camera import HOME_CAMERA
from armui.viewport.camera_input import Drag, press_key, turn_wheel
from armui.viewport.client import Picture, PictureClient
from armui.viewport.hud import Hud, HudValues
from armui.viewport.overlay import add_again_button, lost_text, paint_image, paint_plate
from armui.viewport.palette import LIGHT, ScenePalette
from armui.viewport.view_state import (
    BUILT_IN_ROBOT,
    PickRequest,
    RobotChoice,
    ViewState,
    look_alike,
)

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from PySide6.QtGui import (
        QCloseEvent,
        QFocusEvent,
        QHideEvent,
        QKeyEvent,
        QMouseEvent,
        QPaintEvent,
        QResizeEvent,
        QShowEvent,
        QWheelEvent,
    )

    from armui.viewport.camera import OrbitCamera
    from armui.viewport.news import Lost
    from armui.viewport.path_picture import Preview

_VIEWERS = itertools.count()
_START_MS = 20
_FIGURES_WAIT_MS = 50
"""So long new figures wait for the picture of the same moment, to be painted with it."""


class ArmView(QWidget):
    """The arm in 3D with the measured figures over it.

    Left drag turns, middle drag or shift with left drag moves, the wheel zooms, a double click on
    a link picks its joint. With the focus: arrow keys turn, + and − zoom, Home resets. Nothing is
    drawn while the widget can't be seen. The picture is drawn in a process of its own; where it
    lags behind what it should show, or is gone, the widget says so (safety promise S24).

    Signals:
        joint_picked: a link was double-clicked; its joint number, 1–6.
        load_failed: why a robot description can't be shown, a `Refusal` with one of the codes
            `armui.arm.refusal_codes.RefusalCode`; the old one stays.
        mark_picked: a point of the previewed path was clicked; its row, from 0.
        first_frame_shown: the arm is on the screen for the first time.
        settled: the picture on the screen shows the newest state, see `is_settled`.

    Args:
        robot: URDF file to begin with; None: the project's own arm.
        palette: colours to begin with.
        client: has the pictures drawn; whoever gives one ends it. One of its own by default.
    """

    joint_picked = Signal(int)
    load_failed = Signal(object)
    mark_picked = Signal(int)
    first_frame_shown = Signal()
    settled = Signal()

    def __init__(
        self,
        robot: Path | None = None,
        *,
        palette: ScenePalette = LIGHT,
        client: PictureClient | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        robot_choice = BUILT_IN_ROBOT if robot is None else RobotChoice(robot)
        self._state = ViewState(robot_choice, palette=palette, viewer=next(_VIEWERS))
        self._hud = HudValues()
        self._hud_painter = Hud()
        self._picture: Picture | None = None
        self._is_frame_new = False
        self._lost: Lost | None = None
        self._drag = Drag()
        self._pick_serial = 0
        self._is_started = False
        self._is_shut_down = False
        self._owns_client = client is None
        self._client = client or PictureClient(parent=self)
        self._client.frame_ready.connect(self._on_frame_ready)
        self._client.joint_picked.connect(self._on_joint_picked)
        self._client.mark_picked.connect(self.mark_picked)
        self._client.load_failed.connect(self.load_failed)
        self._client.lost.connect(self._on_lost)
        self._client.aged.connect(self.update)
        self._again_button = add_again_button(self, self._start_again)
        self._figures_wait = QTimer(self, singleShot=True, interval=_FIGURES_WAIT_MS)
        self._figures_wait.timeout.connect(self._paint_figures)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
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
    def camera(self) -> OrbitCamera:
        """Where the arm is seen from."""
        return self._state.camera

    @property
    def is_settled(self) -> bool:
        """Whether the picture on the screen shows the newest state, with smooth edges."""
        return self._picture is not None and not self._is_frame_new and self._client.is_settled

    @property
    def has_given_up(self) -> bool:
        """Whether there is no picture, and none will come by itself."""
        return self._lost is not None and not self._lost.comes_back

    @property
    def highlighted_joint(self) -> int | None:
        """Number of the joint whose links carry the accent colour."""
        return self._state.highlighted_joint

    def set_joints(
        self, angles_deg: Sequence[float] | None, gripper_mm: float | None, stale: bool = False
    ) -> None:
        """Show measured joint angles.

        Args:
            angles_deg: six angles as on the bus; None: never heard, the arm is shown at zero and
                faded.
            gripper_mm: opening; None: never heard, shown closed.
            stale: the values are no longer fresh: the figures turn muted, the arm fades.

        Raises:
            ValueError: there are not six angles.
        """
        if angles_deg is not None and len(angles_deg) != len(JOINTS):
            raise ValueError(f"{len(angles_deg)} joint angles instead of {len(JOINTS)}")
        angles = None if angles_deg is None else tuple(angles_deg)
        shown = self._state.angles_deg if look_alike(angles, self._state.angles_deg) else angles
        self._show(replace(self._state, angles_deg=shown, gripper_mm=gripper_mm, stale=stale))
        self._set_hud(self._hud._replace(angles_deg=angles, angles_stale=stale))

    def set_pose(self, pose: Sequence[float] | None, stale: bool = False) -> None:
        """Show the measured end pose: X, Y, Z in mm, RX, RY, RZ in degrees; None: never heard."""
        self._set_hud(
            self._hud._replace(pose=None if pose is None else tuple(pose), pose_stale=stale)
        )

    def set_theme(self, palette: ScenePalette) -> None:
        """Take the colours of another theme."""
        self._show(replace(self._state, palette=palette))
        self.update()

    def set_robot(self, path: Path | None) -> None:
        """Show another robot description; `load_failed` tells if that can't be done.

        Args:
            path: the URDF file; None: the project's own arm.
        """
        choice = RobotChoice(path or BUILT_IN_ROBOT.path, self._state.robot.serial + 1)
        self._show(replace(self._state, robot=choice))

    def highlight_joint(self, number: int | None) -> None:
        """Give the links moved by joint 1–6 the accent colour; None takes it away."""
        self._show(replace(self._state, highlighted_joint=number))

    def set_preview(self, preview: Preview) -> None:
        """Show a path, its marks and a ghost beside the arm; `NOTHING` takes them away."""
        self._show(replace(self._state, preview=preview))

    def reset_view(self) -> None:
        """The first view again."""
        self._show(replace(self._state, camera=HOME_CAMERA))

    def shutdown(self) -> None:
        """End drawing for good and wait for it; may be called twice."""
        self._is_shut_down = True
        if self._owns_client:
            self._client.stop()

    def _show(self, state: ViewState) -> None:
        self._state = state
        if self._client.is_running and self.isVisible() and not self._is_shut_down:
            self._client.show(state)

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

    def _fit(self) -> None:
        """Ask for a picture as large as the widget, in device pixels."""
        ratio = self.devicePixelRatioF()
        self._show(
            replace(
                self._state,
                width_px=max(1, round(self.width() * ratio)),
                height_px=max(1, round(self.height() * ratio)),
                pixel_ratio=ratio,
            )
        )

    def _start(self) -> None:
        if self.isVisible() and not self._is_shut_down and not self._client.is_running:
            self._client.start()
            self._fit()

    def _start_again(self) -> None:
        self._again_button.hide()
        self._lost = None
        self._client.start()
        self.update()

    def _on_frame_ready(self, picture: Picture) -> None:
        is_first = self._picture is None
        self._picture = picture
        self._is_frame_new = True
        self._lost = None
        self._figures_wait.stop()
        self.update()
        if is_first:
            self.first_frame_shown.emit()

    def _on_joint_picked(self, number: int | None) -> None:
        self.highlight_joint(number)
        if number is not None:
            self.joint_picked.emit(number)

    def _on_lost(self, lost: Lost) -> None:
        self._lost = lost
        self._again_button.setVisible(not lost.comes_back)
        self.update()

    def _notice(self) -> str:
        """What is wrong with the picture, in words; empty when nothing is."""
        if self._lost is not None:
            return lost_text(self._lost)
        if self._picture is None:
            return self.tr("Loading the 3D model …")
        return self.tr("Picture delayed") if self._client.looks_old else ""

    def retranslate_ui(self, button: QPushButton) -> None:
        """Put the words into the operator's language."""
        button.setText(self.tr("Start the 3D view again"))

    def quantities_at(self, place: QPoint) -> list[str]:
        """The key of the figure at a place; see `armui.telemetry.quantities`."""
        key = self._hud_painter.quantity_at(QPointF(place), self.font())
        return [] if key is None else [key]

    def showEvent(self, event: QShowEvent) -> None:
        """Ask for a picture of the size shown."""
        super().showEvent(event)
        self._fit()

    def hideEvent(self, event: QHideEvent) -> None:
        """Forget a drag that was under way."""
        super().hideEvent(event)
        self._drag.forget()

    def closeEvent(self, event: QCloseEvent) -> None:
        """End drawing: as a window of its own the view is closed for good."""
        self.shutdown()
        super().closeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Ask for a picture of the new size."""
        super().resizeEvent(event)
        self._fit()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Show the last picture, the figures and, if need be, why there is no picture."""
        palette = self._state.palette
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        notice = self._notice()
        image = None if self._picture is None else self._picture.image
        paint_image(painter, self.size(), image, palette, faded=bool(notice))
        self._hud_painter.paint(painter, self._hud, palette, self.font())
        if notice:
            paint_plate(painter, self.rect(), notice, palette)
        if self.hasFocus():
            painter.setPen(QPen(QColor(palette.accent), 1.0))
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
            self._fit()

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

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A drag begins."""
        self._drag.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn, or with the middle button or shift move."""
        shorter_side_px = float(min(self.width(), self.height()))
        self._look_through(self._drag.move(event, self._state.camera, shorter_side_px))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """The drag is over; a click without one asks for the mark that is there."""
        clicked = self._drag.release(event)
        if clicked is not None and self._state.preview.path is not None:
            self._show(replace(self._state, mark_pick=self._question(clicked)))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Ask which link is there."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._show(replace(self._state, pick=self._question(event.position())))

    def _question(self, at: QPointF) -> PickRequest:
        """What is seen there?"""
        self._pick_serial += 1
        place = at * self._state.pixel_ratio
        return PickRequest(self._pick_serial, place.x(), place.y())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom."""
        self._look_through(turn_wheel(event, self._state.camera))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrow keys turn, + and − zoom, Home resets."""
        camera = press_key(event.key(), self._state.camera)
        if camera is None:
            super().keyPressEvent(event)
        self._look_through(camera)

    def _look_through(self, camera: OrbitCamera | None) -> None:
        if camera is not None:
            self._show(replace(self._state, camera=camera))
