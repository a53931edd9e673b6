"""The widget that shows the arm and moves the camera."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QToolTip

from armui.arm.limits import JOINTS
from armui.viewport.camera_input import Drag, press_key, turn_wheel
from armui.viewport.handles import Handles
from armui.viewport.look_alike import look_alike
from armui.viewport.looking_view import LookingView
from armui.viewport.palette import LIGHT, ScenePalette
from armui.viewport.path_overlay import PathOverlay
from armui.viewport.projection import Projection
from armui.viewport.robot_shape import IDENTITY, composed, pose_rows
from armui.viewport.stroke_painter import StrokeLayer, StrokePainter
from armui.viewport.strokes import joint_range, tool_frame
from armui.viewport.view_state import BUILT_IN_ROBOT, PickRequest, RobotChoice, ViewState

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from PySide6.QtGui import QHideEvent, QKeyEvent, QMouseEvent, QPainter, QWheelEvent
    from PySide6.QtWidgets import QWidget

    from armui.viewport.client import PictureClient
    from armui.viewport.grips import Grip
    from armui.viewport.handles import HandlePlace
    from armui.viewport.news import Lost
    from armui.viewport.path_picture import Preview, Reach, Trail
    from armui.viewport.strokes import Stroke


class ArmView(LookingView):
    """The arm in 3D with the measured figures over it.

    Left drag turns, middle drag or shift with left drag moves, the wheel zooms, a double click on
    a link picks its joint. With the focus: arrow keys turn, + and − zoom, Home resets.

    Signals:
        joint_picked: a link was double-clicked; its joint number, 1–6.
        mark_picked: a point of the previewed path was clicked; its row, from 0.
        finding_picked: the sign of a finding was clicked, a `FindingMark`.
        handle_taken: a handle is held from now on.
        handle_moved: what the pointer has done to it since, a `Dragged`; whether in coarse steps
            (Ctrl), whether in fine ones (Shift).
        handle_left: it is let go; whether it was given up (Escape, or another window in front).

    Args:
        robot: URDF file to begin with; None: the project's own arm.
        palette: colours to begin with.
        client: has the pictures drawn; whoever gives one ends it. One of its own by default.
    """

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
        choice = BUILT_IN_ROBOT if robot is None else RobotChoice(robot)
        self._drag = Drag()
        self._pick_serial = 0
        self._tool = IDENTITY
        self._shows_tool = False
        self._range: tuple[int, tuple[float, float]] | None = None
        self._path_overlay = PathOverlay()
        self._handles = Handles()
        self._strokes = StrokePainter()
        self._range_layer = StrokeLayer(self._strokes)
        self._handle_layer = StrokeLayer(self._strokes)
        super().__init__(choice, palette, client, parent)
        self._client.joint_picked.connect(self._on_joint_picked)
        self._client.mark_picked.connect(self.mark_picked)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)  # a button that came up elsewhere is seen at the next move

    @property
    def highlighted_joint(self) -> int | None:
        """Number of the joint whose links carry the accent colour."""
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
        shown = self._state.angles_deg if look_alike(angles, self._state.angles_deg) else angles
        self._look_at(self._state._replace(angles_deg=shown, gripper_mm=gripper_mm, stale=stale))
        self._set_hud(self._hud._replace(angles_deg=angles, angles_stale=stale))

    def forget_joints(self) -> None:
        """Nothing is known of the angles any more: the arm stays where it was seen last, faded."""
        self._look_at(self._state._replace(stale=True))
        self._set_hud(self._hud._replace(angles_deg=None, angles_stale=True))

    def set_pose(
        self, pose: Sequence[float] | None, stale: bool = False, *, too_low: bool = False
    ) -> None:
        """Show the measured end pose.

        Args:
            pose: X, Y, Z in mm, RX, RY, RZ in degrees; None: never heard.
            stale: it is no longer fresh.
            too_low: flange or fingertip is below the plane the arm stands on.
        """
        self._set_hud(
            self._hud._replace(
                pose=None if pose is None else tuple(pose), pose_stale=stale, too_low=too_low
            )
        )

    def set_theme(self, palette: ScenePalette) -> None:
        """Take the colours of another theme."""
        self._show(self._state._replace(palette=palette))
        self.update()

    def set_robot(self, path: Path | None) -> None:
        """Show another robot description; `load_failed` tells if that can't be done.

        Args:
            path: the URDF file; None: the project's own arm.
        """
        choice = RobotChoice(path or BUILT_IN_ROBOT.path, self._state.robot.serial + 1)
        self._show(self._state._replace(robot=choice))

    def highlight_joint(self, number: int | None) -> None:
        """Give the links moved by joint 1–6 the accent colour; None takes it away."""
        self._show(self._state._replace(highlighted_joint=number))

    def set_preview(self, preview: Preview) -> None:
        """Show a path, its marks and a ghost beside the arm; `NOTHING` takes them away."""
        path = preview.path
        if path is not self._state.preview.path:
            self._viewpoint.take_places(() if path is None else path.outermost_m())
        self._look_at(self._state._replace(preview=preview))

    def set_trail(self, trail: Trail | None) -> None:
        """Show where the tool has been."""
        self._show(self._state._replace(trail=trail))

    def set_reach(self, reach: Reach | None) -> None:
        """Show how far the tool could reach, or no longer."""
        self._viewpoint.take_reach(reach)
        self._show(self._state._replace(reach=reach, camera=self._viewpoint.camera))

    def set_tool(self, tool: Sequence[float]) -> None:
        """The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees."""
        self._tool = pose_rows(tool)
        self._viewpoint.take_tool((self._tool[3], self._tool[7], self._tool[11]))
        self._look_at(self._state)
        self.update()

    def show_tool_frame(self, *, wanted: bool) -> None:
        """Draw the axes of the tool centre point, or no longer."""
        self._shows_tool = wanted
        self.update()

    def show_joint_range(
        self, number: int | None, limits_deg: tuple[float, float] = (0, 0)
    ) -> None:
        """Draw the range of joint 1–6 as an arc about its axis; None takes it away."""
        wanted = None if number is None else (number, limits_deg)
        if wanted != self._range:
            self._range = wanted
            self.update()

    def set_handles(self, place: HandlePlace | None) -> None:
        """Have handles at a pose of the arm, which the operator can drag; None: none."""
        if place is None and self._handles.is_held:
            self._leave_handle(given_up=True)
        if self._handles.set_place(place):
            self.update()

    # ------------------------------------------------------------------------------------------

    def _on_joint_picked(self, number: int | None) -> None:
        self.highlight_joint(number)
        if number is not None:
            self.joint_picked.emit(number)

    # over the picture -------------------------------------------------------------------------

    def _paint_over(self, painter: QPainter, shown: ViewState) -> None:
        projection = Projection(shown.camera, self.width(), self.height())
        palette = shown.palette
        self._path_overlay.paint(painter, shown.preview, projection, palette)
        shape, angles_deg = self._shape, shown.angles_deg
        if shape is None or angles_deg is None:
            return
        if self._range is not None:
            number, limits_deg = self._range
            edited_deg = shown.preview.ghost_deg or angles_deg

            def its_range() -> list[Stroke]:
                return joint_range(shape, edited_deg, number, limits_deg, palette)

            depends_on = (shape, edited_deg, self._range)
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
        if self._handles.let_go():
            self._viewpoint.is_carried = False
            self._viewpoint.hold(held=False)
            self._take_camera()
            self.handle_left.emit(given_up)

    # the operator's hand ----------------------------------------------------------------------

    def hideEvent(self, event: QHideEvent) -> None:
        """Forget a drag that was under way."""
        super().hideEvent(event)
        self.give_up_drag()

    def _on_lost(self, lost: Lost) -> None:
        """Nothing is aimed at in a picture that is gone (S24)."""
        super()._on_lost(lost)
        self.give_up_drag()

    def give_up_drag(self) -> None:
        """End a drag that is under way; what a handle has changed goes back to what it was."""
        self._drag.forget()
        self._leave_handle(given_up=True)
        self._viewpoint.hold(held=False)

    def event(self, event: QEvent) -> bool:
        """The tooltip of a sign says what was found."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            at = QPointF(event.pos())
            preview = self._state.preview
            finding = self._path_overlay.finding_at(preview, self.projection, at)
            QToolTip.showText(event.globalPos(), "" if finding is None else finding.text, self)
            return True
        return super().event(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A drag begins: of a handle, or of the camera."""
        if self._handles.is_held:
            if event.button() != Qt.MouseButton.LeftButton:
                return  # another button beside the one that holds
            self.give_up_drag()  # it was let go where nobody told of it
        at, projection = event.position(), self.projection
        left = event.button() == Qt.MouseButton.LeftButton
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
        """Carry a handle; else turn the camera, or with the middle button or shift move it."""
        at = event.position()
        if not event.buttons() and (self._handles.is_held or self._drag.is_pressed):
            self.give_up_drag()  # the button came up where nobody told of it
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
        """The drag is over; a click without one asks for the mark that is there."""
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
            self._show(self._state._replace(mark_pick=self._question(clicked)))

    def _hover(self, at: QPointF) -> None:
        projection = self.projection
        over, changed = self._handles.hover(self._grips(projection), projection, at.x(), at.y())
        if changed:
            self.setCursor(Qt.CursorShape.SizeAllCursor if over else Qt.CursorShape.ArrowCursor)
            self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Ask which link is there."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._show(self._state._replace(pick=self._question(event.position())))

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
        """Arrow keys turn, + and − zoom, Home resets; Escape gives a drag up."""
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
