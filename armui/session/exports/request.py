"""The request, the progress and the result of an export."""

from __future__ import annotations

import enum
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, NamedTuple

from armui.arm.refusal import Refusal
from armui.protocol.generation import Generation, PiperModel
from armui.session.frames import Damage


class ArmOptions(NamedTuple):
    """The given facts on the arm; `None` for what is to be found out.

    Attributes:
        generation: The generation of the protocol.
        firmware: The version as ``S-V1.8-5``; it decides the zeros of the joints.
        channel: The name of the log's channel, as text.
        model: The model of the family.
    """

    generation: Generation | None = None
    firmware: str | None = None
    channel: str | None = None
    model: PiperModel | None = None


class ExportFormat(enum.StrEnum):
    """The export formats; for a single file the value is also its suffix."""

    MCAP = "mcap"
    CSV = "csv"
    PARQUET = "parquet"
    CSV_MESSAGES = "csv-messages"
    """A folder with a file for each message."""
    LEROBOT = "lerobot"
    """A folder with a dataset of LeRobot."""

    @property
    def is_folder(self) -> bool:
        """True if several files are written."""
        return self in _FOLDERS

    def named(self, path: Path) -> Path:
        """Return the name of a file or folder with this format's ending."""
        endings = _FOLDERS.values()
        ending = next((each for each in endings if path.name.endswith(each)), "")
        stem = path.name.removesuffix(ending) if ending else path.stem
        return path.with_name(f"{stem}{_FOLDERS.get(self, f'.{self}')}")


_FOLDERS: Final = {ExportFormat.CSV_MESSAGES: "-messages", ExportFormat.LEROBOT: "-lerobot"}
"""The formats of several files, with the endings of their folders' names."""


class ExportProblem(enum.StrEnum):
    """The reason why nothing was written."""

    NO_LOG = "no_log"
    NO_CHANNEL = "no_channel"
    NO_FRAMES = "no_frames"
    NO_ARM = "no_arm"
    NO_ANGLES = "no_angles"
    NOTHING_THEN = "nothing_then"
    EXISTS = "exists"
    SAME_FILE = "same_file"
    CANNOT_WRITE = "cannot_write"
    NO_PYARROW = "no_pyarrow"
    NO_EPISODE = "no_episode"


class ExportError(Exception):
    """Nothing was written, and nothing was changed.

    Attributes:
        problem: The reason.
        detail: A message of the operating system, the log's reader or the log itself, in one line.
    """

    def __init__(self, problem: ExportProblem, detail: str = "") -> None:
        super().__init__(f"{problem}: {detail}")
        self.problem = problem
        self.detail = detail


class ExportCancelledError(Exception):
    """The export was cancelled by its caller; nothing was written."""


class EpisodeOptions(NamedTuple):
    """What is chosen of a dataset of LeRobot.

    Attributes:
        fps: Frames a second.
        task: The task of episodes that name none.
    """

    fps: int = 30
    task: str = "PiPER"


@dataclass(frozen=True, slots=True)
class ExportRequest:
    """The log to export, the target, and the choices of the operator.

    Attributes:
        log: The log's file, in any format that `LogFile` reads.
        target: The file to write, or the folder.
        format: The format.
        begin_s: The beginning, in seconds from the log's first frame.
        end_s: The end, likewise.
        wishes: The given facts on the arm.
        replace: True if an existing file may be replaced; a dataset never is.
        episodes: The options of a dataset of LeRobot.
    """

    log: Path
    target: Path
    format: ExportFormat
    begin_s: float = 0.0
    end_s: float = math.inf
    wishes: ArmOptions = field(default_factory=ArmOptions)
    replace: bool = False
    episodes: EpisodeOptions = field(default_factory=EpisodeOptions)


@dataclass(frozen=True, slots=True)
class ExportReport:
    """The result of an export.

    Attributes:
        items: The number of rows of a table, or of messages.
        frames: The number of frames read.
        generation: The generation of the protocol.
        why_generation: The reason for it, in words.
        firmware: The version in the log or the one given, "" if neither.
        model: The model of the family.
        why_model: The reason for it, in words.
        pose_fits: Another model that the end pose in the log fits better; "" if there is none.
        offset: The identifier offset of the arm's feedback (0x470).
        channel: The channel that was exported, as text; "" if the log has none.
        other_channels: The channels left out.
        of_other_channels: The number of their frames.
        not_understood: The number of frames of the channel that are none of the arm's: in no table,
            of another length or kind.
        questions: The number of questions for the firmware to an arm of generation 1, which has
            none.
        without_stamp: The number of frames whose time no ROS time stamp can hold.
        damages: The first damaged places of the log.
        damage_count: The number of all damaged places.
        notes: Further remarks on the log.
    """

    items: int
    frames: int
    generation: int
    why_generation: str
    firmware: str
    model: str
    why_model: str
    pose_fits: str
    offset: int
    channel: str
    other_channels: tuple[str, ...]
    of_other_channels: int
    not_understood: int
    questions: int
    without_stamp: int
    damages: tuple[Damage, ...]
    damage_count: int
    notes: tuple[Refusal, ...] = ()


@dataclass(frozen=True, slots=True)
class ExportProgress:
    """The progress of an export.

    Attributes:
        done: The share of the log's bytes, 0 to 1; ``None`` if its size is not known.
        frames: The number of frames read.
    """

    done: float | None
    frames: int


def default_target(log: Path, export_format: ExportFormat) -> Path:
    """Return a path beside the log, with its name and the format's ending."""
    name = log.with_suffix("") if log.suffix.lower() == ".gz" else log
    target = export_format.named(name)
    return target if target != log else log.with_name(f"{name.stem}-export.{export_format}")
