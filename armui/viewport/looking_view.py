"""The picture with a camera that fits the arm, follows its tool, or stays where it was put."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QTimer, Signal

from armui.viewport.fitting import Box, Room
from armui.viewport.picture_view import PictureView
from armui.viewport.projection import Projection
from armui.viewport.viewpoint import ViewMode, Viewpoint

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from armui.viewport.camera import OrbitCamera, ViewDirection
    from armui.viewport.client import PictureClient
    from armui.viewport.palette import ScenePalette
    from armui.viewport.robot_shape import RobotShape
    from armui.viewport.view_state import RobotChoice, ViewState

_REST_MS: Final = 700
"""An arm that has not moved for so long is at rest: the camera may come nearer."""
_GLANCE_MS: Final = 80
"""So often it is looked whether a moving arm is still in the picture."""


class LookingView(PictureView):
    """Looks at the arm.

    To begin with, the arm fills the room it has, and the camera steps back when the arm would
    leave it, or come behind the figures. Once the operator has moved the picture, it stays where
    it was put; a view chosen, `fit` or `reset_view` brings that back.

    Signals:
        view_changed: how the arm is looked at has changed, by whomever.

    Args:
        robot: what to begin with.
        palette: colours to begin with.
        client: has the pictures drawn; whoever gives one ends it. One of its own by default.
    """

    view_changed = Signal()

    def __init__(
        self,
        robot: RobotChoice,
        palette: ScenePalette,
        client: PictureClient | None,
        parent: QWidget | None,
    ) -> None:
        self._viewpoint = Viewpoint()
        self._shape: RobotShape | None = None
        self._corner_px, self._strip_px = (0.0, 0.0), 0.0
        super().__init__(robot, palette, client, parent)
        self._client.robot_shown.connect(self._on_robot_shown)
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._on_rest)
        self._glance = QTimer(self, singleShot=True, interval=_GLANCE_MS)
        self._glance.timeout.connect(self._on_glance)
        if self._client.shape is not None:
            self._on_robot_shown(self._client.shape)

    @property
    def is_settled(self) -> bool:
        """Whether the picture on the screen shows the newest state, with smooth edges."""
        return not self._glance.isActive() and super().is_settled

    @property
    def camera(self) -> OrbitCamera:
        """Where the arm is seen from."""
        return self._state.camera

    @property
    def mode(self) -> ViewMode:
        """Who moves the camera."""
        return self._viewpoint.mode

    @property
    def projection(self) -> Projection:
        """From places to the widget's pixels and back, by the camera of now."""
        return Projection(self._state.camera, self.width(), self.height())

    @property
    def shape(self) -> RobotShape | None:
        """The robot in the picture, once it is known."""
        return self._shape

    # how it is looked at ----------------------------------------------------------------------

    def reset_view(self) -> None:
        """The first view again."""
        self._viewpoint.reset()
        self._take_camera()

    def fit(self) -> None:
        """Show all of the arm as large as the room allows."""
        self._viewpoint.fit()
        self._take_camera()

    def look_from(self, direction: ViewDirection) -> None:
        """Look from a direction at all of the arm."""
        self._viewpoint.look_from(direction)
        self._take_camera()

    def follow_tool(self, *, wanted: bool) -> None:
        """Keep the tool in the middle, or show all of the arm again."""
        self._viewpoint.follow(wanted=wanted)
        self._take_camera()

    def set_orthographic(self, *, wanted: bool) -> None:
        """Show parallel lines as such, or with perspective."""
        if wanted != self._viewpoint.camera.orthographic:
            self._viewpoint.set_orthographic(wanted=wanted)
            self._take_camera()

    def set_covered(self, corner_px: tuple[float, float], strip_px: float) -> None:
        """Say what lies over the picture, so that the arm stands beside it.

        Args:
            corner_px: Width and height of the buttons at the bottom right.
            strip_px: How wide the buttons along the right edge are.
        """
        if (corner_px, strip_px) == (self._corner_px, self._strip_px):
            return
        self._corner_px, self._strip_px = corner_px, strip_px
        self._resized()
        self._show(self._state)

    def _resized(self) -> None:
        frame = self._hud_painter.frame(self.font())
        figures = Box(0.0, 0.0, frame.right(), frame.bottom())
        self._take_arm(self._state)
        width, height = float(self.width()), float(self.height())
        corner = Box(0.0, 0.0, 0.0, 0.0)
        if any(self._corner_px):
            corner = Box(width - self._corner_px[0], height - self._corner_px[1], width, height)
        room = Room(width, height, figures, corner, self._strip_px)
        self._viewpoint.take_room(room)
        self._state = self._state._replace(camera=self._viewpoint.camera)

    def _on_robot_shown(self, shape: RobotShape) -> None:
        self._shape = shape
        self._viewpoint.take_shape(shape)
        self._take_camera()

    def _on_rest(self) -> None:
        if self.isVisible():
            self._viewpoint.come_to_rest()
            self._take_camera()

    def _look_at(self, state: ViewState) -> None:
        """Show a state in which the arm or its ghost may stand elsewhere."""
        moved = state.angles_deg is not self._state.angles_deg
        moved = moved or state.preview.ghost_deg != self._state.preview.ghost_deg
        if moved and self.isVisible():
            self._rest.start()
            if self.mode is ViewMode.FOLLOW or not self._glance.isActive():
                self._glance.start()
                self._take_arm(state)
                state = state._replace(camera=self._viewpoint.camera)
        self._show(state)

    def _take_arm(self, state: ViewState) -> None:
        ghost_deg = state.preview.ghost_deg
        self._viewpoint.take_arm(state.angles_deg, state.gripper_mm or 0.0, ghost_deg)

    def _on_glance(self) -> None:
        if self.isVisible():
            self._take_arm(self._state)
            self._show(self._state._replace(camera=self._viewpoint.camera))

    def _take_camera(self) -> None:
        self._show(self._state._replace(camera=self._viewpoint.camera))
        self.view_changed.emit()

    def _is_worth_showing(self, shown: ViewState) -> bool:
        """The first picture was drawn before it was known how large the robot is."""
        return shown.camera == self._state.camera

    def _look_through(self, camera: OrbitCamera | None) -> None:
        """The operator has moved the camera."""
        if camera is None or self._viewpoint.is_carried:
            return
        before = self._state.camera
        turned = (camera.focus_m, camera.distance_m) == (before.focus_m, before.distance_m)
        self._viewpoint.move_by_hand(camera, only_turned=turned)
        self._take_camera()
