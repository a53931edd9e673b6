"""The 3D picture of one arm, drawn off screen. No Qt here.

A scene belongs to the thread that created it, because OpenGL contexts cannot change threads.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCellPicker,
    vtkFollower,
    vtkLight,
    vtkPolyDataMapper,
)
from vtkmodules.vtkRenderingFreeType import vtkVectorText

from armui.viewport.camera import HOME_CAMERA, ON_THE_FLOOR, VIEW_ANGLE_DEG
from armui.viewport.palette import LIGHT, ScenePalette, mix, rgb
from armui.viewport.path_picture import NOTHING, Preview
from armui.viewport.process.area_actors import AreaActors
from armui.viewport.process.geometry import (
    actor_of,
    axis_arrow,
    flat,
    floor_lines,
    is_closed,
    smooth,
)
from armui.viewport.process.offscreen import Canvas, Pixels
from armui.viewport.process.preview_actors import PreviewActors
from armui.viewport.process.reach import ReachActor

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from vtkmodules.vtkRenderingCore import vtkRenderer

    from armui.viewport.path_picture import FindingMark, Trail
    from armui.viewport.process.robot import Matrix, Rgb, Robot
    from armui.viewport.view_state import ViewState


_FLOOR_RADIUS_M = 0.9
_FLOOR_STEP_M = 0.1
_AXIS_LENGTH_M = 0.15
_LETTER_HEIGHT_M = 0.022
_AXES = (("X", (1.0, 0.0, 0.0)), ("Y", (0.0, 1.0, 0.0)), ("Z", (0.0, 0.0, 1.0)))
_PLAIN: Rgb = (0.80, 0.82, 0.85)
_FADED_SHARE = 0.6
_HIGHLIGHT_SHARE = 0.55
_GHOST_OPACITY = 0.3
_TOUCHING_OPACITY = 0.75
_SAME = 1e-3
"""Poses that differ by less, in metres and in the elements of their rotation, are equal."""
_MM = 0.001
_DRIVEN_PX, _COMMANDED_PX = 7.0, 2.0
_OLDEST_SHARE = 0.12
"""The share of its colour at the oldest place; the rest is the background's."""
_FAR_BEHIND_FOCUS_M = 5.0
_FAR_BEFORE_FOCUS_M = 3.0
"""Without perspective nothing is too near to be seen, at any scale."""
_ZERO_DEG = (0.0,) * 6


class Stage:
    """The floor grid, labelled axes and lights of one renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._placement = ON_THE_FLOOR
        lines, self._outward = floor_lines(_FLOOR_RADIUS_M, _FLOOR_STEP_M)
        self._lines = lines
        self._lines.point_data["color"] = np.zeros((lines.n_points, 3), np.uint8)
        self._lines.point_data.active_scalars_name = "color"
        self._grid = self._unlit(self._lines)
        self._arrows = [
            self._unlit(axis_arrow(direction, _AXIS_LENGTH_M)) for _, direction in _AXES
        ]
        self._letters = [self._letter(text, direction) for text, direction in _AXES]
        self._light()

    def stand(self, placement: tuple[float, ...]) -> None:
        """Place the floor at the height of the room's floor, centred below the base."""
        if placement != self._placement:
            self._placement = placement
            in_room = np.vstack((np.reshape(placement, (3, 4)), (0.0, 0.0, 0.0, 1.0)))
            below = np.eye(4)
            below[:2, 3] = np.round(in_room[:2, 3] / _FLOOR_STEP_M) * _FLOOR_STEP_M
            matrix = vtkMatrix4x4()
            matrix.DeepCopy(flat(np.linalg.inv(in_room) @ below))
            self._grid.SetUserMatrix(matrix)

    def paint(self, palette: ScenePalette) -> None:
        """Apply the colours of a theme."""
        background, grid = rgb(palette.background), rgb(palette.grid)
        self._renderer.SetBackground(background)
        shares = self._outward[:, np.newaxis] ** 2
        colors = np.asarray(grid) * (1.0 - shares) + np.asarray(background) * shares
        self._lines.point_data["color"] = np.round(np.clip(colors, 0.0, 1.0) * 255.0).astype(
            np.uint8
        )
        for color, arrow, letter in zip(palette.axes, self._arrows, self._letters, strict=True):
            arrow.GetProperty().SetColor(*rgb(color))
            letter.GetProperty().SetColor(*mix(rgb(color), rgb(palette.text), 0.15))

    def scale_lines(self, pixel_ratio: float) -> None:
        """Keep the apparent width of the floor lines on screens with small pixels."""
        self._grid.GetProperty().SetLineWidth(pixel_ratio)

    def _unlit(self, surface: pv.PolyData) -> vtkActor:
        actor = actor_of(surface)
        actor.GetProperty().LightingOff()
        self._add(actor)
        return actor

    def _letter(self, text: str, direction: tuple[float, float, float]) -> vtkFollower:
        shape = vtkVectorText()
        shape.SetText(text)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(shape.GetOutputPort())
        follower = vtkFollower()
        follower.SetMapper(mapper)
        follower.SetScale(_LETTER_HEIGHT_M)
        follower.SetPosition([1.1 * _AXIS_LENGTH_M * part for part in direction])
        follower.SetCamera(self._renderer.GetActiveCamera())
        follower.GetProperty().LightingOff()
        self._add(follower)
        return follower

    def _add(self, actor: vtkActor) -> None:
        actor.PickableOff()
        self._renderer.AddActor(actor)

    def _light(self) -> None:
        """Add a soft head light, a key light over the left shoulder, a faint one from the right."""
        for position, intensity in (
            ((0, 0, 1), 0.40),
            ((-0.6, 1.2, 0.9), 0.56),
            ((0.9, 0.1, 0.5), 0.2),
        ):
            light = vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetIntensity(intensity)
            light.SetPosition(position)
            self._renderer.AddLight(light)


class RobotActors:
    """Builds, moves and colours the actors of a robot."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._joint_numbers = robot.joint_numbers()
        self._matrices = {part.link: vtkMatrix4x4() for part in robot.parts}
        self._poses: dict[str, Matrix] = {}
        self._parts: list[tuple[str, vtkActor, Rgb]] = []
        self._touching: frozenset[int] = frozenset()
        for part in robot.parts:
            actor = actor_of(smooth(part.surface))
            # One matrix a link, shared by its actors: a pose is set once and moves them all.
            actor.SetUserMatrix(self._matrices[part.link])
            actor.GetProperty().SetInterpolationToPhong()
            actor.GetProperty().SetSpecularPower(30.0)
            # saves a third of a picture's cost where the processor draws it
            actor.GetProperty().SetBackfaceCulling(is_closed(part.surface))
            self._parts.append((part.link, actor, part.color or _PLAIN))

    @property
    def flange(self) -> Matrix:
        """The pose of the link that joint 6 moves."""
        last = self._robot.arm_joints[-1]
        return self._poses[next(each.child for each in self._robot.joints if each.name == last)]

    @property
    def actors(self) -> list[vtkActor]:
        """All actors, for adding them to a renderer or removing them."""
        return [actor for _, actor, _ in self._parts]

    def pose(self, angles_deg: Sequence[float], opening_mm: float) -> None:
        """Move every link; joint angles as on the bus."""
        poses = self._poses = self._robot.link_poses(angles_deg, opening_mm)
        for link, matrix in self._matrices.items():
            matrix.DeepCopy(flat(poses[link]))

    def leave_out_what_stands_on(self, other: RobotActors) -> None:
        """Hide links that coincide with another robot's, except those that touch by a finding."""
        for link, actor, _ in self._parts:
            own, its = self._poses.get(link), other._poses.get(link)
            is_same = own is not None and its is not None and np.abs(own - its).max() < _SAME
            actor.SetVisibility(not is_same or self._touches(link))

    def paint(self, palette: ScenePalette, *, fresh: bool, highlighted_joint: int | None) -> None:
        """Colour the robot.

        Args:
            palette: the theme.
            fresh: False fades the arm into the background: this pose is not what the arm reports
                now.
            highlighted_joint: the joint whose links have the accent colour.
        """
        for link, actor, own_color in self._parts:
            color = own_color
            is_highlighted = highlighted_joint == self._joint_numbers.get(link, 0)
            if is_highlighted:
                color = mix(color, rgb(palette.accent), _HIGHLIGHT_SHARE)
            if not fresh:
                color = mix(color, rgb(palette.background), _FADED_SHARE)
            # fade the shading, too: a white shell on a light background fades by nothing else
            ambient, diffuse, specular = (0.12, 1.0, 0.25) if fresh else (0.7, 0.35, 0.0)
            appearance = actor.GetProperty()
            appearance.SetColor(*color)
            appearance.SetAmbient(ambient)
            appearance.SetDiffuse(diffuse)
            appearance.SetSpecular(specular)

    def make_ghost(self, palette: ScenePalette, finding: FindingMark | None) -> None:
        """Make the robot transparent, in the accent colour: no real arm is there.

        Args:
            palette: the theme.
            finding: the finding whose links have its own colour instead, as in `Preview`.
        """
        self._touching = frozenset(() if finding is None else finding.touching)
        of_finding = palette.fault if finding is None or finding.is_error else palette.warning
        for link, actor, _ in self._parts:
            actor.PickableOff()
            appearance = actor.GetProperty()
            touches = self._touches(link)
            appearance.SetColor(*rgb(of_finding if touches else palette.accent))
            appearance.SetOpacity(_TOUCHING_OPACITY if touches else _GHOST_OPACITY)
            appearance.BackfaceCullingOff()
            appearance.SetSpecular(0.0)

    def _touches(self, link: str) -> bool:
        return self._joint_numbers.get(link, 0) in self._touching

    def joint_of(self, picked: object) -> int | None:
        """Return the number (1–6) of the joint that moves an actor, or None for base and others."""
        for link, actor, _ in self._parts:
            if actor is picked:
                return self._joint_numbers.get(link)
        return None


class TrailActors:
    """The lines of a trail in a renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._driven = _FadingLine(renderer, _DRIVEN_PX)
        self._commanded = _FadingLine(renderer, _COMMANDED_PX)
        self._shown: tuple[Trail | None, ScenePalette, float] | None = None

    def show(self, trail: Trail | None, palette: ScenePalette, pixel_ratio: float) -> None:
        """Show a trail; do nothing if it is the same as before."""
        wanted = (trail, palette, pixel_ratio)
        if wanted == self._shown:
            return
        self._shown = wanted
        driven, commanded = (b"", b"") if trail is None else (trail.driven, trail.commanded)
        self._commanded.show(commanded, palette.commanded, palette.background, pixel_ratio)
        self._driven.show(driven, palette.driven, palette.background, pixel_ratio)


class _FadingLine:
    """One line; it grows ten times a second, so only its places are put in anew."""

    def __init__(self, renderer: vtkRenderer, width_px: float) -> None:
        self._renderer = renderer
        self._width_px = width_px
        self._line = pv.PolyData()
        self._actor = actor_of(self._line)
        self._actor.GetProperty().LightingOff()
        self._actor.PickableOff()
        self._is_there = False
        self._colors_of: tuple[int, str, str] | None = None

    def show(self, places: bytes, color: str, ground: str, pixel_ratio: float) -> None:
        """Show a line through places, three 32-bit floats each, mm; fewer than two make no line."""
        points = np.frombuffer(places, np.float32).reshape(-1, 3) * np.float32(_MM)
        is_there = len(points) > 1
        if is_there:
            self._line.points = points
            wanted = (len(points), color, ground)
            if wanted != self._colors_of:
                self._colors_of = wanted
                self._line.lines = np.concatenate(([len(points)], np.arange(len(points))))
                self._line.point_data["color"] = _fading(*wanted)
                self._line.point_data.active_scalars_name = "color"
            self._actor.GetProperty().SetLineWidth(self._width_px * pixel_ratio)
        if is_there != self._is_there:
            self._is_there = is_there
            change = self._renderer.AddActor if is_there else self._renderer.RemoveActor
            change(self._actor)


def _fading(count: int, color: str, ground: str) -> np.ndarray:
    shares = np.linspace(_OLDEST_SHARE, 1.0, count)[:, np.newaxis]
    far, own = np.asarray(rgb(ground)), np.asarray(rgb(color))
    return np.round((far * (1.0 - shares) + own * shares) * 255.0).astype(np.uint8)


class Scene:
    """The floor, axes, lights and a robot, seen by a camera.

    Attributes:
        camera: the camera; assign the result of its `orbit`, `pan` or `zoom`.

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
        self._area = AreaActors(self._canvas.renderer)
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
        """The robot in the picture."""
        return self._description

    def load(self, path: Path) -> None:
        """Show the robot of a URDF file instead of the present one, in the same pose.

        Raises:
            SceneError: the file has no arm that this program can show; the old robot stays.
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
        self._area.follow(robot.flange)
        self._paint_robot()

    def show(self, state: ViewState) -> None:
        """Apply all of a state but its robot and its pick request."""
        self.camera = state.camera
        self._stage.stand(state.camera.placement)
        if state.palette != self._palette:
            self.set_palette(state.palette)
        if state.highlighted_joint != self._highlighted_joint:
            self.highlight_joint(state.highlighted_joint)
        self.set_joints(state.angles_deg, state.gripper_mm, stale=state.stale)
        self.set_preview(state.preview)
        self._trail.show(state.trail, self._palette, state.pixel_ratio)
        self._area.show(state.area, self._palette)
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
            self._area.follow(self._robot.flange)
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
        if (preview.ghost_deg, preview.finding) != (before.ghost_deg, before.finding):
            self._show_ghost(preview.ghost_deg)

    def set_palette(self, palette: ScenePalette) -> None:
        """Apply the colours of another theme."""
        self._palette = palette
        self._stage.paint(palette)
        self._paint_robot()
        self._preview_actors.show(self._preview, palette, self._pixel_ratio)
        self._drop_ghost()
        self._show_ghost(self._preview.ghost_deg)

    def highlight_joint(self, number: int | None) -> None:
        """Give the links moved by joint 1–6 the accent colour; None removes it."""
        self._highlighted_joint = number
        self._paint_robot()

    @property
    def is_unfinished(self) -> bool:
        """True if something requested is still being computed."""
        return self._reach.is_unfinished

    def catch_up(self) -> bool:
        """Show results that are ready, and return whether there were any."""
        return self._reach.catch_up()

    def resize(self, width_px: int, height_px: int, pixel_ratio: float) -> None:
        """Change the size of the picture, in device pixels."""
        self._canvas.resize(width_px, height_px)
        self._stage.scale_lines(pixel_ratio)
        if pixel_ratio != self._pixel_ratio:
            self._pixel_ratio = pixel_ratio
            self._preview_actors.show(self._preview, self._palette, pixel_ratio)

    def render(self, *, smooth: bool = True) -> Pixels:
        """Draw the picture.

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
        """Return the number (1–6) of the joint whose link is at a pixel from the top left.

        None for the base, other surfaces and the background.
        """
        self._aim()
        _, height_px = self._canvas.size_px
        hit = self._picker.Pick(x_px, height_px - 1 - y_px, 0.0, self._canvas.renderer)
        if not hit or self._robot is None:
            return None
        return self._robot.joint_of(self._picker.GetActor())

    def pick_mark(self, x_px: float, y_px: float) -> int | None:
        """Return the row of the preview's mark next to a pixel from the top left, or None."""
        self._aim()
        return self._preview_actors.row_at(x_px, y_px, self._pixel_ratio)

    def close(self) -> None:
        """Free the graphics memory; to be called in the thread that created the scene."""
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
            away = replace(self.camera, distance_m=_FAR_BEFORE_FOCUS_M)
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
            for actor in self._ghost.actors:
                self._canvas.renderer.AddActor(actor)
        self._ghost.make_ghost(self._palette, self._preview.finding)
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
