"""What is asked of an export, and what is told of it."""

from __future__ import annotations

import enum
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, NamedTuple

from armui.protocol.generation import Generation, PiperModel
from armui.session.frames import Damage


class ArmOptions(NamedTuple):
    """What whoever exports says of the arm; `None` where it is to be found out.

    Attributes:
        generation: Of the protocol.
        firmware: As ``S-V1.8-5``; it tells where the joints have their zeros.
        channel: The name of the log's channel, as text.
        model: Which arm of the family it is.
    """

    generation: Generation | None = None
    firmware: str | None = None
    channel: str | None = None
    model: PiperModel | None = None


class ExportFormat(enum.StrEnum):
    """What can be written; of a file the value is also the ending of its name."""

    MCAP = "mcap"
    CSV = "csv"
    PARQUET = "parquet"
    CSV_MESSAGES = "csv-messages"
    """A folder with a file for each message."""

    @property
    def is_folder(self) -> bool:
        """True if several files are written."""
        return self is ExportFormat.CSV_MESSAGES

    def named(self, path: Path) -> Path:
        """Return a file's or folder's name as this format has it."""
        if self.is_folder:
            return path.with_name(f"{path.stem}{_MESSAGES}")
        stem = path.name.removesuffix(_MESSAGES) if path.name.endswith(_MESSAGES) else path.stem
        return path.with_name(f"{stem}.{self}")


_MESSAGES: Final = "-messages"
"""What the name of such a folder ends with."""


class ExportProblem(enum.StrEnum):
    """Why nothing was written."""

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


class ExportError(Exception):
    """Nothing was written, and nothing was changed.

    Attributes:
        problem: Why.
        detail: What the operating system, the reader of logs or the log itself says, in one line.
    """

    def __init__(self, problem: ExportProblem, detail: str = "") -> None:
        super().__init__(f"{problem}: {detail}")
        self.problem = problem
        self.detail = detail


class ExportCancelledError(Exception):
    """Whoever asked for it no longer wants it; nothing was written."""


@dataclass(frozen=True, slots=True)
class ExportRequest:
    """What to export.

    Attributes:
        log: The file, of any format that `LogFile` reads.
        target: The file to write, or the folder.
        format: In which format.
        begin_s: From there on, in seconds from the log's first frame.
        end_s: Up to there.
        wishes: What is known of the arm.
        replace: Whether a file that is there may be replaced.
    """

    log: Path
    target: Path
    format: ExportFormat
    begin_s: float = 0.0
    end_s: float = math.inf
    wishes: ArmOptions = field(default_factory=ArmOptions)
    replace: bool = False


@dataclass(frozen=True, slots=True)
class ExportReport:
    """What became of it.

    Attributes:
        items: Rows of a table, or messages.
        frames: Frames read.
        generation: Of the protocol, and why it was taken for that.
        why_generation: In words.
        firmware: Told by the log or said, "" if neither.
        model: Which arm of the family it was taken for.
        why_model: In words.
        pose_fits: Another model that the end pose in the log fits better; "" where there is none.
        offset: The identifier offset of the arm's feedback (0x470).
        channel: Whose frames were exported, as text; "" where the log has none.
        other_channels: Those left out.
        of_other_channels: How many frames they had.
        not_understood: Frames of the channel that are none of the arm's: in no table, of another
            length or kind.
        questions: Frames by which a host asked for the firmware, and generation 1 knows none.
        without_stamp: Frames whose time no ROS time stamp can tell.
        damages: The first damaged places of the log.
        damage_count: All of them.
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


@dataclass(frozen=True, slots=True)
class ExportProgress:
    """How far it has come.

    Attributes:
        done: 0 to 1, of the log's bytes; ``None`` where its size is not known.
        frames: Frames read.
    """

    done: float | None
    frames: int


def default_target(log: Path, export_format: ExportFormat) -> Path:
    """Beside the log, with its name and the format's ending."""
    name = log.with_suffix("") if log.suffix.lower() == ".gz" else log
    target = export_format.named(name)
    return target if target != log else log.with_name(f"{name.stem}-export.{export_format}")
