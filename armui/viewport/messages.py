"""Messages between the program and the render process: small, plain data.

The process begins with `Ready`. There is one request at a time; it is answered with `Drawn`, after
any other messages.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal

if TYPE_CHECKING:
    from armui.viewport.path_picture import PathPicture
    from armui.viewport.robot_shape import RobotShape
    from armui.viewport.view_state import ViewState

DRAWING_STOPPED = Reason("drawing_stopped", "The 3D view ended unexpectedly ({text}).")
NO_OPENGL = Reason(
    "no_opengl",
    (
        "The 3D view is not available: this computer offers no OpenGL. Install a graphics "
        "driver or Mesa (on Debian the packages libegl1 and libgl1-mesa-dri) and start the "
        "3D view again."
    ),
)
PICTURE_PROCESS_ENDED = Reason(
    "picture_process_ended", ("The 3D view ended unexpectedly ({text}).")
)
PICTURE_PROCESS_HUNG = Reason("picture_process_hung", "The 3D view stopped responding.")
URDF_MISSING = Reason(
    "urdf_missing",
    "Robot description: the file {path} is not there. Choose another file, or use the "
    "built-in one.",
)
BYTES_PER_PIXEL: Final = 4


class SceneError(Exception):
    """The 3D picture can't be made.

    Args:
        code: the reason.
        params: the figures in its sentence.

    Attributes:
        refusal: the reason, to be put into words by the user interface.
    """

    def __init__(self, code: Reason, **params: float | int | str) -> None:
        self.refusal = Refusal(code, params)
        super().__init__(str(self.refusal))


class PicturePhase(enum.Enum):
    """The phases of the render process."""

    STARTING = enum.auto()
    """The process imports its libraries."""
    OPENING = enum.auto()
    """It opens the graphics driver."""
    LOADING = enum.auto()
    """It reads a robot description."""
    FIRST_DRAWING = enum.auto()
    """It draws a robot for the first time."""
    DRAWING = enum.auto()


@dataclass(frozen=True, slots=True)
class MemoryName:
    """Shared memory for finished images; see `armui.viewport.frame_memory`."""

    name: str
    slot_bytes: int


@dataclass(frozen=True, slots=True)
class Draw:
    """A request to draw a state.

    Attributes:
        sequence: The number of the state.
        state: The state without its path; None to draw the last one again with smooth edges.
        slot: The place of the image in the memory.
        memory: The memory to use from now on; None for the one before.
        path: The path of the preview, if it has changed.
        keeps_path: True if the path sent last is shown.
        robot: The state's robot from `RobotRead`, so that its file is not read again.
    """

    sequence: int
    state: ViewState | None
    slot: int
    memory: MemoryName | None = None
    path: PathPicture | None = None
    keeps_path: bool = False
    robot: bytes | None = None


@dataclass(frozen=True, slots=True)
class Ready:
    """The process has imported its libraries and accepts requests."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """A request is done.

    Attributes:
        sequence: The number of the state in the image.
        size_px: Width and height of the image; None if nothing has changed, so that there is no
            image.
        pixel_ratio: Device pixels for each logical pixel.
        is_rough: True if the image would look better with smooth edges.
        began_s, ended_s: Beginning and end of the drawing, by the system's monotonic clock.
    """

    sequence: int
    size_px: tuple[int, int] | None
    pixel_ratio: float
    is_rough: bool
    began_s: float
    ended_s: float


@dataclass(frozen=True, slots=True)
class PictureBusy:
    """A sign of life while a request takes long, and whenever the phase changes.

    Attributes:
        phase: The present phase.
        cpu_s: The processor time it has taken so far.
        late_s: The delay of the process's last wake-up, caused by other programs.
    """

    phase: PicturePhase
    cpu_s: float
    late_s: float


@dataclass(frozen=True, slots=True)
class RobotRead:
    """A robot description and its meshes as they were read; a later process starts faster with it.

    Attributes:
        content: Pickled; the program keeps it unopened.
    """

    content: bytes


@dataclass(frozen=True, slots=True)
class RobotShown:
    """The robot that is in the picture from now on."""

    shape: RobotShape


@dataclass(frozen=True, slots=True)
class JointPicked:
    """The joint (1–6) whose link is at the requested place, or None."""

    number: int | None


@dataclass(frozen=True, slots=True)
class MarkPicked:
    """The row of the mark at the requested place."""

    row: int


@dataclass(frozen=True, slots=True)
class LoadFailed:
    """The reason why a robot description can't be shown; the one before stays."""

    refusal: Refusal


@dataclass(frozen=True, slots=True)
class Failed:
    """The reason why the process ends: this computer can't draw, or an unexpected error.

    Attributes:
        refusal: For the operator.
        traceback: For the log.
    """

    refusal: Refusal
    traceback: str = ""


Answer = (
    Ready
    | Drawn
    | PictureBusy
    | RobotRead
    | RobotShown
    | JointPicked
    | MarkPicked
    | LoadFailed
    | Failed
)
