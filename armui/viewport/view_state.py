"""The state of the 3D view: plain data, handed from the widget to the render process."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from armui.arm.models import robot_description
from armui.protocol.generation import PiperModel
from armui.viewport.camera import HOME_CAMERA, OrbitCamera
from armui.viewport.palette import LIGHT, ScenePalette
from armui.viewport.path_picture import NOTHING, Preview, Reach, Trail


@dataclass(frozen=True, slots=True)
class PickRequest:
    """A question which link is seen at a pixel; `serial` tells two questions at one place apart."""

    serial: int
    x_px: float
    y_px: float


@dataclass(frozen=True, slots=True)
class RobotChoice:
    """The URDF file to show; `serial` makes the same file, repaired, load again."""

    path: Path
    serial: int = 0


BUILT_IN_ROBOT: Final = RobotChoice(robot_description(PiperModel.PIPER))
"""The project's own PiPER."""


@dataclass(frozen=True, slots=True)
class ViewState:
    """Everything the picture depends on.

    Attributes:
        robot: the description to show.
        width_px: of the picture, in device pixels.
        height_px: likewise.
        pixel_ratio: device pixels a logical pixel.
        camera: where it is seen from.
        palette: colours.
        angles_deg: six joint angles as on the bus; None: never heard.
        gripper_mm: opening; None: never heard.
        stale: the angles are no longer fresh.
        highlighted_joint: 1–6 or None.
        preview: what is shown beside the arm.
        trail: where the tool has been.
        reach: how far the tool could reach.
        pick: a question to answer along the way.
        mark_pick: likewise, about a mark of the preview.
        viewer: tells views apart that have their pictures drawn by one process, one after another.
    """

    robot: RobotChoice
    width_px: int = 1
    height_px: int = 1
    pixel_ratio: float = 1.0
    camera: OrbitCamera = HOME_CAMERA
    palette: ScenePalette = LIGHT
    angles_deg: tuple[float, ...] | None = None
    gripper_mm: float | None = None
    stale: bool = False
    highlighted_joint: int | None = None
    preview: Preview = NOTHING
    trail: Trail | None = None
    reach: Reach | None = None
    pick: PickRequest | None = None
    mark_pick: PickRequest | None = None
    viewer: int = 0
