"""The robot in the picture: one actor a visual, moved by matrices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from armui.viewport.geometry import flat, picture_of
from armui.viewport.palette import ScenePalette, mix, rgb

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.viewport.robot import Rgb, Robot

_PLAIN: Rgb = (0.80, 0.82, 0.85)
_FADED_SHARE = 0.6
_HIGHLIGHT_SHARE = 0.55


class RobotActors:
    """Builds the actors of a robot and moves and colours them.

    Raises:
        SceneError: a mesh file can't be read.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._matrices = {link: vtkMatrix4x4() for link in robot.visuals}
        self._parts: list[tuple[str, pv.Actor, Rgb]] = []
        for link, visuals in robot.visuals.items():
            for visual in visuals:
                actor = pv.Actor(mapper=pv.DataSetMapper(picture_of(visual)))
                # One matrix a link, shared by its actors: a pose is set once and moves them all.
                actor.SetUserMatrix(self._matrices[link])
                actor.prop.interpolation = "phong"
                actor.prop.specular_power = 30.0
                self._parts.append((link, actor, visual.color or _PLAIN))

    @property
    def actors(self) -> list[pv.Actor]:
        """All actors, to be put into a renderer or taken out of it."""
        return [actor for _, actor, _ in self._parts]

    def pose(self, angles_deg: Sequence[float], opening_mm: float) -> None:
        """Move every link; joint angles as on the bus."""
        for link, pose in self._robot.link_poses(angles_deg, opening_mm).items():
            self._matrices[link].DeepCopy(flat(pose))

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
            is_highlighted = highlighted_joint == self._robot.joint_number_of_link.get(link, 0)
            if is_highlighted:
                color = mix(color, rgb(palette.accent), _HIGHLIGHT_SHARE)
            if not fresh:
                color = mix(color, rgb(palette.background), _FADED_SHARE)
            actor.prop.color = color
            # Faded is flat, too: on a light background a white shell fades by losing its shades.
            actor.prop.ambient, actor.prop.diffuse, actor.prop.specular = (
                (0.12, 1.0, 0.25) if fresh else (0.7, 0.35, 0.0)
            )

    def joint_of(self, picked: object) -> int | None:
        """Number (1–6) of the joint that moves an actor; None for the base and the unknown."""
        for link, actor, _ in self._parts:
            if actor is picked:
                return self._robot.joint_number_of_link.get(link)
        return None
