"""The robot in the picture: one actor a part, moved by matrices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor

from armui.viewport.palette import ScenePalette, mix, rgb
from armui.viewport.process.geometry import actor_of, flat, is_closed, smooth

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.viewport.process.robot import Matrix, Rgb, Robot

_PLAIN: Rgb = (0.80, 0.82, 0.85)
_FADED_SHARE = 0.6
_HIGHLIGHT_SHARE = 0.55
_GHOST_OPACITY = 0.3
_SAME = 1e-3
"""Poses that differ by less, in metres and in the figures of their rotation, are one."""


class RobotActors:
    """Builds the actors of a robot and moves and colours them."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._joint_numbers = robot.joint_numbers()
        self._matrices = {part.link: vtkMatrix4x4() for part in robot.parts}
        self._poses: dict[str, Matrix] = {}
        self._parts: list[tuple[str, vtkActor, Rgb]] = []
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
    def actors(self) -> list[vtkActor]:
        """All actors, to be put into a renderer or taken out of it."""
        return [actor for _, actor, _ in self._parts]

    def pose(self, angles_deg: Sequence[float], opening_mm: float) -> None:
        """Move every link; joint angles as on the bus."""
        poses = self._poses = self._robot.link_poses(angles_deg, opening_mm)
        for link, matrix in self._matrices.items():
            matrix.DeepCopy(flat(poses[link]))

    def leave_out_what_stands_on(self, other: RobotActors) -> None:
        """Hide the links that are where another robot's are: two surfaces in one place flicker."""
        for link, actor, _ in self._parts:
            own, its = self._poses.get(link), other._poses.get(link)
            is_same = own is not None and its is not None and np.abs(own - its).max() < _SAME
            actor.SetVisibility(not is_same)

    def paint(self, palette: ScenePalette, *, fresh: bool, highlighted_joint: int | None) -> None:
        """Colour the robot.

        Args:
            palette: the theme.
            fresh: False fades the arm into the background: this pose is not what the arm reports
                now.
            highlighted_joint: its links take the accent colour.
        """
        for link, actor, own_color in self._parts:
            color = own_color
            is_highlighted = highlighted_joint == self._joint_numbers.get(link, 0)
            if is_highlighted:
                color = mix(color, rgb(palette.accent), _HIGHLIGHT_SHARE)
            if not fresh:
                color = mix(color, rgb(palette.background), _FADED_SHARE)
            # Faded is flat, too: on a light background a white shell fades by losing its shades.
            ambient, diffuse, specular = (0.12, 1.0, 0.25) if fresh else (0.7, 0.35, 0.0)
            look = actor.GetProperty()
            look.SetColor(*color)
            look.SetAmbient(ambient)
            look.SetDiffuse(diffuse)
            look.SetSpecular(specular)

    def make_ghost(self, palette: ScenePalette) -> None:
        """Let the robot shine through, in the accent colour: it is where no arm is."""
        for _, actor, _ in self._parts:
            actor.PickableOff()
            look = actor.GetProperty()
            look.SetColor(*rgb(palette.accent))
            look.SetOpacity(_GHOST_OPACITY)
            look.BackfaceCullingOff()
            look.SetSpecular(0.0)

    def joint_of(self, picked: object) -> int | None:
        """Number (1–6) of the joint that moves an actor; None for the base and the unknown."""
        for link, actor, _ in self._parts:
            if actor is picked:
                return self._joint_numbers.get(link)
        return None
