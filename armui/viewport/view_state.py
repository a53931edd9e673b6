"""The state of the 3D view: plain data, passed from the widget to the render process."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from armui.arm.models import robot_description
from armui.protocol.generation import PiperModel
from armui.viewport.area_picture import AreaPicture
from armui.viewport.camera import HOME_CAMERA, OrbitCamera
from armui.viewport.palette import LIGHT, ScenePalette
from armui.viewport.path_picture import NOTHING, Preview, Reach, Trail


@dataclass(frozen=True, slots=True)
class PickRequest:
    """A request for the link at a pixel; `serial` distinguishes two requests at one place."""

    serial: int
    x_px: float
    y_px: float


@dataclass(frozen=True, slots=True)
class RobotChoice:
    """The URDF file to show; a new `serial` makes the same file load again after a repair."""

    path: Path
    serial: int = 0


BUILT_IN_ROBOT: Final = RobotChoice(robot_description(PiperModel.PIPER))
"""The project's own PiPER."""


@dataclass(frozen=True, slots=True)
class ViewState:
    """Everything the picture depends on.

    Attributes:
        robot: the description to show.
        width_px: the picture's width in device pixels.
        height_px: the picture's height in device pixels.
        pixel_ratio: device pixels for each logical pixel.
        camera: the camera.
        palette: colours.
        angles_deg: six joint angles as on the bus; None: never heard.
        gripper_mm: opening; None: never heard.
        stale: the angles are no longer fresh.
        highlighted_joint: 1–6 or None.
        preview: what is shown beside the arm.
        trail: the way of the tool.
        reach: the reach of the tool.
        area: the planes and boxes of the work area.
        pick: a request for the link at a place.
        mark_pick: a request for the mark of the preview at a place.
        viewer: the number of the view: one process may draw for several views in turn.
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
    area: AreaPicture = ()
    pick: PickRequest | None = None
    mark_pick: PickRequest | None = None
    viewer: int = 0
