"""The 3D picture of one arm, drawn off screen. No Qt here.

A scene belongs to the thread that made it: OpenGL contexts don't travel.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from vtkmodules.vtkRenderingCore import vtkCellPicker

from armui.viewport.camera import HOME_CAMERA, VIEW_ANGLE_DEG
from armui.viewport.palette import LIGHT, ScenePalette
from armui.viewport.path_picture import NOTHING, Preview
from armui.viewport.process.offscreen import Canvas, Pixels
from armui.viewport.process.preview_actors import PreviewActors
from armui.viewport.process.reach_actor import ReachActor
from armui.viewport.process.robot_actors import RobotActors
from armui.viewport.process.stage import Stage
from armui.viewport.process.trail_actors import TrailActors

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from armui.viewport.process.robot import Robot
    from armui.viewport.view_state import ViewState

_FAR_BEHIND_FOCUS_M = 5.0
_FAR_BEFORE_FOCUS_M = 3.0
"""Without perspective nothing is too near to be seen, however small the picture's scale."""
_ZERO_DEG = (0.0,) * 6


class Scene:
    """Floor, axes, lights and a robot, seen by a camera.

    Attributes:
        camera: where the picture is taken from; assign the result of its `orbit`, `pan` or `zoom`.

    Raises:
        SceneError: this computer can't draw.
    """

    def __init__(
        self,
        width_px: int = 900,
        height_px: int = 700,
        pixel_ratio: float = 1.0,
        palette: ScenePalette = LIGHT,
    ) -> None:
        self._canvas = Canvas(width_px, height_px)
        self._stage = Stage(self._canvas.renderer)
        self._robot: RobotActors | None = None
        self._description: Robot | None = None
        self._ghost: RobotActors | None = None
        self._preview = NOTHING
        self._preview_actors = PreviewActors(self._canvas.renderer)
        self._trail = TrailActors(self._canvas.renderer)
        self._reach = ReachActor(self._canvas.renderer)
        self._pixel_ratio = pixel_ratio
        self._palette = palette
        self._is_fresh = False
        self._highlighted_joint: int | None = None
        self._pose: tuple[Sequence[float], float] = (_ZERO_DEG, 0.0)
        self._picker = vtkCellPicker()
        self._picker.SetTolerance(0.0)
        self.camera = HOME_CAMERA
        self._stage.scale_lines(pixel_ratio)
        self._stage.paint(palette)

    @property
    def robot(self) -> Robot | None:
        """The robot that is shown."""
        return self._description

    def load(self, path: Path) -> None:
        """Show the robot of a URDF file instead of the one before, in the same pose.

        Raises:
            SceneError: the file is no arm this program can show; the old robot stays.
        """
        from armui.viewport.process.urdf_file import load_robot  # noqa: PLC0415 - slow to import

        self.show_robot(load_robot(path))

    def show_robot(self, description: Robot) -> None:
        """Show a robot that was read before."""
        robot = RobotActors(description)
        renderer = self._canvas.renderer
        if self._robot is not None:
            for actor in self._robot.actors:
                renderer.RemoveActor(actor)
        for actor in robot.actors:
            renderer.AddActor(actor)
        self._robot, self._description = robot, description
        self._drop_ghost()
        self._show_ghost(self._preview.ghost_deg)
        robot.pose(*self._pose)
        self._paint_robot()

    def show(self, state: ViewState) -> None:
        """Take over all of a state but its robot and its question."""
        self.camera = state.camera
        if state.palette != self._palette:
            self.set_palette(state.palette)
        if state.highlighted_joint != self._highlighted_joint:
            self.highlight_joint(state.highlighted_joint)
        self.set_joints(state.angles_deg, state.gripper_mm, stale=state.stale)
        self.set_preview(state.preview)
        self._trail.show(state.trail, self._palette, state.pixel_ratio)
        if self._description is not None:
            self._reach.show(state.reach, self._description, self._palette)
        self.resize(state.width_px, state.height_px, state.pixel_ratio)

    def set_joints(
        self, angles_deg: Sequence[float] | None, gripper_mm: float | None, *, stale: bool = False
    ) -> None:
        """Move the robot.

        Args:
            angles_deg: six joint angles as on the bus; None: not measured, the robot is shown at
                zero and faded.
            gripper_mm: distance between the fingers; None: not measured, shown closed.
            stale: the angles are no longer fresh: the robot is faded.
        """
        self._pose = (_ZERO_DEG if angles_deg is None else angles_deg, gripper_mm or 0.0)
        if self._robot is not None:
            self._robot.pose(*self._pose)
            if self._ghost is not None:
                self._ghost.leave_out_what_stands_on(self._robot)
        is_fresh = angles_deg is not None and not stale
        if self._is_fresh != is_fresh:
            self._is_fresh = is_fresh
            self._paint_robot()

    def set_preview(self, preview: Preview) -> None:
        """Show a path and a ghost beside the robot."""
        before, self._preview = self._preview, preview
        if preview.path is not before.path:
            self._preview_actors.show(preview, self._palette, self._pixel_ratio)
        elif preview.selected_row != before.selected_row:
            self._preview_actors.select(preview.selected_row)
        if preview.current_row != before.current_row or preview.path is not before.path:
            self._preview_actors.light(preview.current_row)
        if preview.ghost_deg != before.ghost_deg:
            self._show_ghost(preview.ghost_deg)

    def set_palette(self, palette: ScenePalette) -> None:
        """Take the colours of another theme."""
        self._palette = palette
        self._stage.paint(palette)
        self._paint_robot()
        self._preview_actors.show(self._preview, palette, self._pixel_ratio)
        self._drop_ghost()
        self._show_ghost(self._preview.ghost_deg)

    def highlight_joint(self, number: int | None) -> None:
        """Give the links moved by joint 1–6 the accent colour; None takes it away."""
        self._highlighted_joint = number
        self._paint_robot()

    @property
    def is_unfinished(self) -> bool:
        """Whether something that is asked for is still being worked out."""
        return self._reach.is_unfinished

    def catch_up(self) -> bool:
        """Show what has been worked out meanwhile; whether there was anything."""
        return self._reach.catch_up()

    def resize(self, width_px: int, height_px: int, pixel_ratio: float) -> None:
        """Change the size of the picture, in device pixels."""
        self._canvas.resize(width_px, height_px)
        self._stage.scale_lines(pixel_ratio)
        if pixel_ratio != self._pixel_ratio:
            self._pixel_ratio = pixel_ratio
            self._preview_actors.show(self._preview, self._palette, pixel_ratio)

    def render(self, *, smooth: bool = True) -> Pixels:
        """Draw.

        Args:
            smooth: soften the edges (FXAA); cheap on a graphics card, 15 ms of a 24 ms frame on a
                processor.

        Returns:
            The image, valid until the next one is drawn.
        """
        self._aim()
        self._canvas.renderer.SetUseFXAA(smooth)
        return self._canvas.draw()

    def pick(self, x_px: float, y_px: float) -> int | None:
        """Number (1–6) of the joint whose link is seen at a pixel from the top left, else None."""
        self._aim()
        _, height_px = self._canvas.size_px
        hit = self._picker.Pick(x_px, height_px - 1 - y_px, 0.0, self._canvas.renderer)
        if not hit or self._robot is None:
            return None
        return self._robot.joint_of(self._picker.GetActor())

    def pick_mark(self, x_px: float, y_px: float) -> int | None:
        """Row of the previewed path's mark next to a pixel from the top left, else None."""
        self._aim()
        return self._preview_actors.row_at(x_px, y_px, self._pixel_ratio)

    def close(self) -> None:
        """Give the graphics memory back; call it in the thread that made the scene."""
        self._canvas.close()

    def _aim(self) -> None:
        camera = self._canvas.renderer.GetActiveCamera()
        width_px, height_px = self._canvas.size_px
        camera.SetUseHorizontalViewAngle(width_px < height_px)
        camera.SetViewAngle(VIEW_ANGLE_DEG)
        camera.SetParallelProjection(self.camera.orthographic)
        _, _, up = self.camera.axes()
        camera.SetFocalPoint(self.camera.focus_m)
        camera.SetViewUp(up)
        # Fixed by the camera alone: were it fitted to the arm, each motion would shift all depths
        # a little and edges far from the motion would flicker.
        distance_m = self.camera.distance_m
        if self.camera.orthographic:
            seen_m = distance_m * math.tan(math.radians(VIEW_ANGLE_DEG / 2.0))
            camera.SetParallelScale(seen_m * height_px / min(width_px, height_px))
            away = self.camera._replace(distance_m=_FAR_BEFORE_FOCUS_M)
            camera.SetPosition(away.eye_m)
            camera.SetClippingRange(0.01, _FAR_BEFORE_FOCUS_M + _FAR_BEHIND_FOCUS_M)
            return
        camera.SetPosition(self.camera.eye_m)
        camera.SetClippingRange(0.05 * distance_m, distance_m + _FAR_BEHIND_FOCUS_M)

    def _show_ghost(self, angles_deg: Sequence[float] | None) -> None:
        """Stand a transparent arm at some angles; the first one is built when it is wanted."""
        if angles_deg is None or self._description is None:
            self._drop_ghost()
            return
        if self._ghost is None:
            self._ghost = RobotActors(self._description)
            self._ghost.make_ghost(self._palette)
            for actor in self._ghost.actors:
                self._canvas.renderer.AddActor(actor)
        self._ghost.pose(angles_deg, 0.0)
        if self._robot is not None:
            self._ghost.leave_out_what_stands_on(self._robot)

    def _drop_ghost(self) -> None:
        if self._ghost is not None:
            for actor in self._ghost.actors:
                self._canvas.renderer.RemoveActor(actor)
        self._ghost = None

    def _paint_robot(self) -> None:
        if self._robot is not None:
            self._robot.paint(
                self._palette, fresh=self._is_fresh, highlighted_joint=self._highlighted_joint
            )
