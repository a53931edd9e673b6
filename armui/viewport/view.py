"""The widget that shows the arm, reports a late or lost picture, and moves the camera."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from typing import TYPE_CHECKING, Final

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
from PySide6.QtGui import QColor, QHelpEvent, QPainter, QPen
from PySide6.QtWidgets import QToolTip, QWidget

from armui.arm.limits import JOINTS
from armui.viewport.area_picture import corners
from armui.viewport.camera import poses_equal
from armui.viewport.camera_input import Drag, press_key, turn_wheel
from armui.viewport.client import Picture, PictureClient
from armui.viewport.fitting import Box, Room
from armui.viewport.handles import Handles
from armui.viewport.hud import Hud, HudValues, add_again_button, lost_text, paint_image, paint_plate
from armui.viewport.palette import LIGHT, ScenePalette
from armui.viewport.path_overlay import PathOverlay
from armui.viewport.projection import Projection
from armui.viewport.robot_shape import IDENTITY, composed, pose_rows
from armui.viewport.stroke_painter import StrokeLayer, StrokePainter
from armui.viewport.strokes import FrameMark, joint_range, tool_frame, user_frames
from armui.viewport.view_state import BUILT_IN_ROBOT, PickRequest, RobotChoice, ViewState
from armui.viewport.viewpoint import ViewMode, Viewpoint

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from PySide6.QtGui import (
        QCloseEvent,
        QHideEvent,
        QImage,
        QKeyEvent,
        QMouseEvent,
        QPaintEvent,
        QResizeEvent,
        QShowEvent,
        QWheelEvent,
    )

    from armui.viewport.area_picture import AreaPicture
    from armui.viewport.camera import OrbitCamera, ViewDirection
    from armui.viewport.grips import Grip
    from armui.viewport.handles import HandlePlace
    from armui.viewport.path_picture import Preview, Reach, Trail
    from armui.viewport.process_link import Lost
    from armui.viewport.robot_shape import RobotShape
    from armui.viewport.strokes import Stroke

_VIEWERS = itertools.count()
_START_MS = 20
_FIGURES_WAIT_MS = 50
"""The longest that new figures wait for the picture of the same moment."""


_MOST_ASKED = 128
_REST_MS: Final = 700
"""An arm that has not moved for this long is at rest: the camera may move closer."""
_GLANCE_MS: Final = 80
"""The period of checking whether a moving arm is still in the picture."""


class ArmView(QWidget):
    """The arm in 3D with the measured figures over it.

    Nothing is drawn while the widget is hidden. If the picture is late or lost, the widget says so
    (safety promise S24).

    At first the arm fills its room, and the camera moves back when the arm would leave it, or come
    behind the figures. Once the operator has turned or moved the picture, it stays so, until a view
    is chosen or `fit` or `reset_view` is called.

    Left drag turns, middle drag or shift with left drag moves, the wheel zooms, a double click on
    a link picks its joint. With the focus: arrow keys turn, + and − zoom, Home resets.

    Signals:
        load_failed: the `Refusal` of a robot description that can't be shown; the old one stays.
        first_frame_shown: the arm is on the screen for the first time.
        settled: the picture on the screen shows the newest state, see `is_settled`.
        view_changed: the camera has changed, for any reason.
        joint_picked: a link was double-clicked; its joint number, 1–6.
        mark_picked: a point of the previewed path was clicked; its row, from 0.
        finding_picked: the sign of a finding was clicked, a `FindingMark`.
        handle_taken: a handle is held from now on.
        handle_moved: a `Dragged`; true for coarse steps (Ctrl); true for fine ones (Shift).
        handle_left: the handle was released; true if the drag was cancelled (Escape, or another
            window in front).

    Args:
        robot: the first URDF file; None for the project's own arm.
        palette: the first colours.
        client: the client that has the pictures drawn, to be ended by its owner. One of its own by
            default.
    """

    load_failed = Signal(object)
    first_frame_shown = Signal()
    settled = Signal()
    view_changed = Signal()
    joint_picked = Signal(int)
    mark_picked = Signal(int)
    finding_picked = Signal(object)
    handle_taken = Signal()
    handle_moved = Signal(object, bool, bool)
    handle_left = Signal(bool)

    def __init__(
        self,
        robot: Path | None = None,
        *,
        palette: ScenePalette = LIGHT,
        client: PictureClient | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        choice = BUILT_IN_ROBOT if robot is None else RobotChoice(robot)
        self._state = ViewState(choice, palette=palette, viewer=next(_VIEWERS))
        self._asked: dict[int, ViewState] = {}
        self._shown: ViewState | None = None
        self._hud = HudValues()
        self._hud_painter = Hud()
        self._picture: Picture | None = None
        self._is_frame_new = False
        self._lost: Lost | None = None
        self._is_started = False
        self._is_shut_down = False
        self._viewpoint = Viewpoint()
        self._shape: RobotShape | None = None
        self._strip_px = 0.0
        self._drag = Drag()
        self._pick_serial = 0
        self._tool = IDENTITY
        self._frames: tuple[FrameMark, ...] = ()
        self._shows_tool = False
        self._range: tuple[int, tuple[float, float]] | None = None
        self._path_overlay = PathOverlay()
        self._handles = Handles()
        self._strokes = StrokePainter()
        self._range_layer = StrokeLayer(self._strokes)
        self._handle_layer = StrokeLayer(self._strokes)
        self._owns_client = client is None
        self._client = client or PictureClient(parent=self)
        self._connect_client()
        self._again_button = add_again_button(self, self._start_again)
        self._figures_wait = QTimer(self, singleShot=True, interval=_FIGURES_WAIT_MS)
        self._figures_wait.timeout.connect(self._paint_figures)
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._on_rest)
        self._glance = QTimer(self, singleShot=True, interval=_GLANCE_MS)
        self._glance.timeout.connect(self._on_glance)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)  # the picture covers all of it
        self.setMinimumSize(240, 200)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        # moves without a button reveal that a button was released elsewhere, see `mouseMoveEvent`
        self.setMouseTracking(True)
        application = QCoreApplication.instance()
        if application is not None:
            # A child gets no close event when its window closes.
            application.aboutToQuit.connect(self.shutdown)
        self.retranslate_ui()
        if self._client.shape is not None:
            self._on_robot_shown(self._client.shape)

    def _connect_client(self) -> None:
        self._client.frame_ready.connect(self._on_frame_ready)
        self._client.load_failed.connect(self.load_failed)
        self._client.lost.connect(self._on_lost)
        self._client.aged.connect(self.update)
        self._client.robot_shown.connect(self._on_robot_shown)
        self._client.joint_picked.connect(self._on_joint_picked)
        self._client.mark_picked.connect(self.mark_picked)

    def sizeHint(self) -> QSize:
        """Return the room for the arm and the figures."""
        return QSize(720, 640)

    @property
    def is_settled(self) -> bool:
        """True if the picture on the screen shows the newest state, with smooth edges."""
        return (
            self._picture is not None
            and not self._is_frame_new
            and not self._glance.isActive()
            and self._client.is_settled
        )

    @property
    def has_given_up(self) -> bool:
        """True if there is no picture, and none will come by itself."""
        return self._lost is not None and not self._lost.comes_back

    @property
    def is_current(self) -> bool:
        """True if the picture may be taken as the present state."""
        return self._picture is not None and not self._notice()

    @property
    def is_late(self) -> bool:
        """True if the picture is late or lost, so that nothing may be aimed at in it."""
        return self._client.is_stale or self._lost is not None

    def grab_picture(self) -> QImage | None:
        """Return a copy of the picture with the figures, as on the screen; None without one."""
        return None if self._picture is None else self.grab().toImage()

    def shutdown(self) -> None:
        """End drawing for good and wait for it; may be called twice."""
        self._is_shut_down = True
        if self._owns_client:
            self._client.stop()

    @property
    def camera(self) -> OrbitCamera:
        """The camera of the next picture."""
        return self._state.camera

    @property
    def mode(self) -> ViewMode:
        """The camera mode."""
        return self._viewpoint.mode

    @property
    def projection(self) -> Projection:
        """The projection from places to the widget's pixels and back, by the present camera."""
        return Projection(self._state.camera, self.width(), self.height())

    @property
    def shape(self) -> RobotShape | None:
        """The robot in the picture, once it is known."""
        return self._shape

    @property
    def highlighted_joint(self) -> int | None:
        """The number of the joint whose links have the accent colour."""
        return self._state.highlighted_joint

    # what is shown ----------------------------------------------------------------------------

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
        shown = self._state.angles_deg if poses_equal(angles, self._state.angles_deg) else angles
        self._look_at(replace(self._state, angles_deg=shown, gripper_mm=gripper_mm, stale=stale))
        self._set_hud(replace(self._hud, angles_deg=angles, angles_stale=stale))

    def set_joints_unknown(self) -> None:
        """Fade the arm at its last pose, or at zero before the first: its angles are not known."""
        self._look_at(replace(self._state, stale=True))
        self._set_hud(replace(self._hud, angles_deg=None, angles_stale=True))

    def set_pose(
        self,
        pose: Sequence[float] | None,
        stale: bool = False,
        *,
        too_low: bool = False,
        of_tool: bool = False,
        frame: str = "",
    ) -> None:
        """Show the measured end pose.

        Args:
            pose: X, Y, Z in mm, RX, RY, RZ in degrees; None: never heard.
            stale: it is no longer fresh.
            too_low: flange or fingertip is below the plane on which the arm stands.
            of_tool: the pose is that of the tool centre point, not of the flange.
            frame: the name of the user frame that it is in; empty for the base.
        """
        shown = None if pose is None else tuple(pose)
        hud = replace(self._hud, pose=shown, pose_stale=stale, too_low=too_low)
        self._set_hud(replace(hud, of_tool=of_tool, frame=frame))

    def set_theme(self, palette: ScenePalette) -> None:
        """Apply the colours of another theme."""
        self._show(replace(self._state, palette=palette))
        self.update()

    def set_robot(self, path: Path | None) -> None:
        """Show another robot description; `load_failed` is emitted if that fails.

        Args:
            path: the URDF file; None: the project's own arm.
        """
        choice = RobotChoice(path or BUILT_IN_ROBOT.path, self._state.robot.serial + 1)
        self._show(replace(self._state, robot=choice))

    def highlight_joint(self, number: int | None) -> None:
        """Give the links moved by joint 1–6 the accent colour; None removes it."""
        self._show(replace(self._state, highlighted_joint=number))

    def set_preview(self, preview: Preview) -> None:
        """Show a path, its marks and a ghost beside the arm; `NOTHING` removes them."""
        path = preview.path
        if path is not self._state.preview.path:
            self._viewpoint.set_places(() if path is None else path.outermost_m())
        self._look_at(replace(self._state, preview=preview))

    def set_trail(self, trail: Trail | None) -> None:
        """Show the trail of the tool."""
        self._show(replace(self._state, trail=trail))

    def set_reach(self, reach: Reach | None) -> None:
        """Show or hide the reach of the tool."""
        self._viewpoint.set_reach(reach)
        self._show(replace(self._state, reach=reach, camera=self._viewpoint.camera))

    def set_area(self, area: AreaPicture, base: Sequence[float] = (0.0,) * 6) -> None:
        """Show the planes and boxes of a work area, and place the base in the room."""
        self._viewpoint.set_placement(pose_rows(base))
        if area != self._state.area:
            self._viewpoint.set_boxes(tuple(corners(area)))
        camera = self._viewpoint.camera
        if (area, camera) != (self._state.area, self._state.camera):
            self._show(replace(self._state, area=area, camera=camera))

    def bring_in(self, area: AreaPicture) -> None:
        """Move the camera back to show newly added boxes, unless the operator has moved it."""
        self._viewpoint.bring_in(tuple(corners(area)))
        self._take_camera()

    def set_tool(self, tool: Sequence[float]) -> None:
        """Set the tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees."""
        self._tool = pose_rows(tool)
        self._viewpoint.set_tool((self._tool[3], self._tool[7], self._tool[11]))
        self._look_at(self._state)
        self.update()

    def set_frames(self, marks: tuple[FrameMark, ...]) -> None:
        """Show user frames; an empty tuple removes them."""
        if marks != self._frames:
            self._frames = marks
            self.update()

    def show_tool_frame(self, *, wanted: bool) -> None:
        """Show or hide the axes of the tool centre point."""
        self._shows_tool = wanted
        self.update()

    def show_joint_range(
        self, number: int | None, limits_deg: tuple[float, float] = (0, 0)
    ) -> None:
        """Draw the range of joint 1–6 as an arc about its axis; None removes it."""
        wanted = None if number is None else (number, limits_deg)
        if wanted != self._range:
            self._range = wanted
            self.update()

    def set_handles(self, place: HandlePlace | None) -> None:
        """Show handles at a pose of the arm for the operator to drag; None removes them."""
        if place is None and self._handles.is_held:
            self._leave_handle(given_up=True)
        if self._handles.set_place(place):
            self.update()

    # how it is looked at ----------------------------------------------------------------------

    def reset_view(self) -> None:
        """Go back to the first view."""
        self._viewpoint.reset()
        self._take_camera()

    def fit(self) -> None:
        """Show all of the arm and of the boxes beside it, as large as the room allows."""
        self._viewpoint.fit()
        self._take_camera()

    def look_from(self, direction: ViewDirection) -> None:
        """Look at all of the arm from a direction."""
        self._viewpoint.look_from(direction)
        self._take_camera()

    def follow_tool(self, *, wanted: bool) -> None:
        """Keep the tool in the middle, or show all of the arm again."""
        self._viewpoint.follow(wanted=wanted)
        self._take_camera()

    def set_orthographic(self, *, wanted: bool) -> None:
        """Switch perspective off or on."""
        if wanted != self._viewpoint.camera.orthographic:
            self._viewpoint.set_orthographic(wanted=wanted)
            self._take_camera()

    def set_covered(self, strip_px: float) -> None:
        """Set the width of the buttons along the right edge: the arm is shown beside them."""
        if strip_px != self._strip_px:
            self._strip_px = strip_px
            self._resized()
            self._show(self._state)

    @property
    def room(self) -> Room:
        """The picture, and what lies over it."""
        return self._viewpoint.room

    def arm_boxes(self) -> list[Box]:
        """Return a rectangle around each link of the arm and its ghost, as they are seen."""
        return self._viewpoint.arm_boxes()

    def _resized(self) -> None:
        frame = self._hud_painter.frame(self.font())
        figures = Box(0.0, 0.0, frame.right(), frame.bottom())
        self._take_arm(self._state)
        room = Room(float(self.width()), float(self.height()), figures, self._strip_px)
        self._viewpoint.set_room(room)
        self._state = replace(self._state, camera=self._viewpoint.camera)

    def _on_robot_shown(self, shape: RobotShape) -> None:
        self._shape = shape
        self._viewpoint.set_shape(shape)
        self._take_camera()

    def _on_rest(self) -> None:
        if self.isVisible():
            self._viewpoint.come_to_rest()
            self._take_camera()

    def _look_at(self, state: ViewState) -> None:
        """Apply a state in which the arm or ghost may have moved; move the camera if needed."""
        moved = state.angles_deg is not self._state.angles_deg
        moved = moved or state.preview.ghost_deg != self._state.preview.ghost_deg
        if moved and self.isVisible():
            self._rest.start()
            if self.mode is ViewMode.FOLLOW or not self._glance.isActive():
                self._glance.start()
                self._take_arm(state)
                state = replace(state, camera=self._viewpoint.camera)
        self._show(state)

    def _take_arm(self, state: ViewState) -> None:
        ghost_deg = state.preview.ghost_deg
        self._viewpoint.set_arm(state.angles_deg, state.gripper_mm or 0.0, ghost_deg)

    def _on_glance(self) -> None:
        if self.isVisible():
            self._take_arm(self._state)
            self._show(replace(self._state, camera=self._viewpoint.camera))

    def _take_camera(self) -> None:
        self._show(replace(self._state, camera=self._viewpoint.camera))
        self.view_changed.emit()

    def _look_through(self, camera: OrbitCamera | None) -> None:
        """Take over the camera that the operator has moved; ``None`` changes nothing."""
        if camera is None or self._viewpoint.is_carried:
            return
        self._viewpoint.move_by_hand(camera)
        self._take_camera()

    # requests and answers ----------------------------------------------------------------------

    def _show(self, state: ViewState) -> None:
        self._state = state
        if self._client.is_running and self.isVisible() and not self._is_shut_down:
            self._client.show(state)
            self._asked[self._client.sequence] = state
            if len(self._asked) > _MOST_ASKED:  # no picture for seconds: drop the oldest request
                del self._asked[min(self._asked)]

    def _set_hud(self, values: HudValues) -> None:
        if values == self._hud:
            return
        self._hud = values
        if not self._client.is_running or self._client.is_settled or self._lost is not None:
            self._paint_figures()  # no picture is awaited for the figures to appear with
        elif not self._figures_wait.isActive():
            self._figures_wait.start()

    def _paint_figures(self) -> None:
        self.update(self._hud_painter.frame(self.font()).toAlignedRect())

    def _fit_size(self) -> None:
        """Ask for a picture as large as the widget, in device pixels."""
        ratio = self.devicePixelRatioF()
        self._state = replace(
            self._state,
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
        sequence = picture.frame.drawn.sequence
        shown = self._asked.get(sequence, self._state)
        self._asked = {each: state for each, state in self._asked.items() if each >= sequence}
        if is_first and shown.camera != self._state.camera:
            # drop it: its camera was fitted before the size of the robot was known
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
        """End a drag: nobody may aim at handles that are no longer drawn (S24)."""
        self._lost = lost
        self._again_button.setVisible(not lost.comes_back)
        self.update()
        self.give_up_drag()

    def _notice(self) -> str:
        """Return the notice on a missing or late picture; "" if there is none."""
        if self._lost is not None:
            return lost_text(self._lost)
        if self._picture is None:
            return QCoreApplication.translate("ArmView", "Loading the 3D model …")
        late = QCoreApplication.translate("ArmView", "Picture delayed")
        return late if self._client.is_stale else ""

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self._again_button.setText(QCoreApplication.translate("ArmView", "Restart the 3D view"))

    def quantities_at(self, place: QPoint) -> list[str]:
        """Return the key of the curve for the figure at a place; none for poses in a user frame."""
        hud = self._hud
        key = self._hud_painter.quantity_at(QPointF(place), self.font(), of_tool=hud.of_tool)
        return [] if key is None or (hud.frame and "joint" not in key) else [key]

    def _on_joint_picked(self, number: int | None) -> None:
        self.highlight_joint(number)
        if number is not None:
            self.joint_picked.emit(number)

    # over the picture -------------------------------------------------------------------------

    def _paint_over(self, painter: QPainter, shown: ViewState) -> None:
        projection = Projection(shown.camera, self.width(), self.height())
        palette = shown.palette
        self._path_overlay.paint(painter, shown.preview, projection, palette)
        self._strokes.paint(painter, user_frames(self._frames, palette), projection, palette)
        shape, angles_deg = self._shape, shown.angles_deg
        if shape is None or angles_deg is None:
            return
        if self._range is not None:
            number, limits_deg = self._range
            ghost_deg = shown.preview.ghost_deg
            edited_deg = ghost_deg or angles_deg
            measured_deg = None if ghost_deg is None or shown.stale else angles_deg[number - 1]

            def its_range() -> list[Stroke]:
                return joint_range(
                    shape, edited_deg, number, limits_deg, palette, measured_deg=measured_deg
                )

            depends_on = (shape, edited_deg, measured_deg, self._range)
            self._range_layer.paint(painter, depends_on, its_range, projection, palette)
        if self._shows_tool and not shown.stale:
            rows = composed(shape.flange(shape.links(angles_deg)), self._tool)
            self._strokes.paint(painter, tool_frame(rows, palette), projection, palette)
        if self._handles.place is not None:

            def handles() -> list[Stroke]:
                return self._handles.strokes(self._grips(projection))

            key = (shape, self._tool, self._handles.key)
            self._handle_layer.paint(painter, key, handles, projection, palette)

    def _grips(self, projection: Projection) -> list[Grip]:
        if self._shape is None:
            return []
        return self._handles.grips(self._shape, self._tool, projection, self._state.palette)

    def _leave_handle(self, *, given_up: bool) -> None:
        if self._handles.release():
            self._viewpoint.is_carried = False
            self._viewpoint.hold(held=False)
            self._take_camera()
            self.handle_left.emit(given_up)

    # events -----------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Request a picture of the widget's size."""
        super().showEvent(event)
        self._fit_size()

    def hideEvent(self, event: QHideEvent) -> None:
        """Cancel a drag, because its release would not be noticed."""
        super().hideEvent(event)
        self.give_up_drag()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Stop drawing: as a window of its own the view is closed for good."""
        self.shutdown()
        super().closeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Request a picture of the new size."""
        super().resizeEvent(event)
        self._fit_size()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Show the last picture, the figures and, if there is no picture, the reason."""
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
        """Update the texts after a change of language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate_ui()
            self.update()

    # the operator's hand ----------------------------------------------------------------------

    def give_up_drag(self) -> None:
        """Cancel a drag; changes made by a handle are reverted."""
        self._drag.cancel()
        self._leave_handle(given_up=True)
        self._viewpoint.hold(held=False)

    def event(self, event: QEvent) -> bool:
        """Show the finding of a sign as its tooltip."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            at = QPointF(event.pos())
            preview = self._state.preview
            finding = self._path_overlay.finding_at(preview, self.projection, at)
            QToolTip.showText(event.globalPos(), "" if finding is None else finding.text, self)
            return True
        return super().event(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin a drag of a handle or of the camera."""
        if self._handles.is_held:
            if event.button() != Qt.MouseButton.LeftButton:
                return  # a second button changes nothing while the left one drags
            self.give_up_drag()  # its release was never reported
        at, projection = event.position(), self.projection
        left = event.button() == Qt.MouseButton.LeftButton
        # in a late picture the handles are not where they seem to be: none can be grabbed (S24)
        if left and self._handles.place is not None and not self.is_late:
            grips = self._grips(projection)
            if self._handles.take(grips, projection, at.x(), at.y()) is not None:
                self._viewpoint.hold(held=True)
                self._viewpoint.is_carried = True
                self.handle_taken.emit()
                self.update()
                return
        self._drag.press(event)
        self._viewpoint.hold(held=self._drag.is_pressed)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag a handle; else turn the camera, or with the middle button or shift move it."""
        at = event.position()
        if not event.buttons() and (self._handles.is_held or self._drag.is_pressed):
            self.give_up_drag()  # its release was never reported
        if self._handles.is_held:
            dragged = self._handles.carry(at.x(), at.y())
            if dragged is not None:
                keys = event.modifiers()
                coarse = bool(keys & Qt.KeyboardModifier.ControlModifier)
                fine = bool(keys & Qt.KeyboardModifier.ShiftModifier)
                self.handle_moved.emit(dragged, coarse, fine)
            return
        if self._handles.place is not None and not event.buttons():
            self._hover(at)
        shorter_side_px = float(min(self.width(), self.height()))
        self._look_through(self._drag.move(event, self._state.camera, shorter_side_px))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End the drag; a click without one requests the mark at its place."""
        if self._handles.is_held:
            if event.button() == Qt.MouseButton.LeftButton:
                self._leave_handle(given_up=False)
            return
        clicked = self._drag.release(event)
        self._viewpoint.hold(held=False)
        self._take_camera()
        preview = self._state.preview
        if clicked is None or preview.path is None:
            return
        finding = self._path_overlay.finding_at(preview, self.projection, clicked)
        if finding is not None:
            self.finding_picked.emit(finding)
        else:
            self._show(replace(self._state, mark_pick=self._question(clicked)))

    def _hover(self, at: QPointF) -> None:
        projection = self.projection
        over, changed = self._handles.hover(self._grips(projection), projection, at.x(), at.y())
        if changed:
            self.setCursor(Qt.CursorShape.SizeAllCursor if over else Qt.CursorShape.ArrowCursor)
            self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Request the link at the place."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._show(replace(self._state, pick=self._question(event.position())))

    def _question(self, at: QPointF) -> PickRequest:
        """Return a request for the link or mark at a place."""
        self._pick_serial += 1
        place = at * self._state.pixel_ratio
        return PickRequest(self._pick_serial, place.x(), place.y())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom by the notches of the wheel."""
        self._look_through(turn_wheel(event, self._state.camera))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Turn with arrow keys, zoom with + and −, reset with Home, cancel a drag with Escape."""
        if event.key() == Qt.Key.Key_Escape and self._handles.is_held:
            self._leave_handle(given_up=True)
            return
        if event.key() == Qt.Key.Key_Home:
            self.reset_view()
            return
        camera = press_key(event.key(), self._state.camera)
        if camera is None:
            super().keyPressEvent(event)
        self._look_through(camera)
