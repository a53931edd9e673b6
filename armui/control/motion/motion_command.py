"""The data of our motion commands, of other movers and of observations."""

from __future__ import annotations

import enum
import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.models import model_data
from armui.arm.refusal import Reason, Refusal
from armui.control.motion.jog_pace import accelerations
from armui.protocol.generation import PiperModel

if TYPE_CHECKING:
    from armui.arm.limits import JointLimits
    from armui.arm.other_hosts import OtherTraffic
    from armui.arm.state import ArmState
    from armui.control.operations.started import Started
    from armui.control.safety.overspeed import ToolPace
    from armui.kinematics.poses import Matrix
    from armui.ways.way import Way

PLAN_PAUSED = Reason(
    "plan_paused",
    "A motion of the arm is paused: it holds back every new target. Press Continue or a Clear "
    "button under Drag teaching, Planned trajectory.",
)
HELD_AT_ZERO = Reason(
    "held_at_zero",
    "The arm holds back a motion at 0 %. Hold Continue or press Give up in the line above the "
    "panels first.",
)


class Mover(enum.Enum):
    """The party that moves the arm, its gripper included."""

    NOBODY = enum.auto()
    OURS = enum.auto()
    """This program: its command is under way or held back."""
    OTHER_HOST = enum.auto()
    LEADER = enum.auto()
    """A teaching-input arm that this arm follows (0x470)."""
    HAND = enum.auto()
    """A hand, in drag teaching."""
    GRAVITY = enum.auto()
    """Gravity: the motors have no power, and the arm is limp or lies where it fell."""
    UNKNOWN = enum.auto()
    """Nobody known: the arm is not heard, or moves without a known cause."""


class CommandKind(enum.Enum):
    """The kinds of our motion commands."""

    JOINTS = enum.auto()
    POSE = enum.auto()
    JOG = enum.auto()
    RUN = enum.auto()
    REPLAY = enum.auto()


class End(enum.Enum):
    """The causes that end a command of ours; no step starts from its target any more."""

    REPLACED = enum.auto()
    CANCELLED = enum.auto()
    STOPPED = enum.auto()
    DISABLED = enum.auto()
    OTHER_HOST = enum.auto()
    TAUGHT = enum.auto()
    """Drag teaching has begun."""
    OTHER_MODE = enum.auto()
    """The arm has left CAN control."""
    SILENT = enum.auto()
    LIMITS_CHANGED = enum.auto()
    ZERO_CHANGED = enum.auto()
    TOOL_CHANGED = enum.auto()
    MOVED_AWAY = enum.auto()
    """The arm is at rest elsewhere than where it was sent."""
    NOT_SENT = enum.auto()
    FORGOTTEN = enum.auto()
    """Another connection has begun."""


class Hold(enum.Enum):
    """The causes that hold a motion back."""

    PAUSE = "pause"
    SPEED_ZERO = "speed_zero"


def why_held(holds: Collection[Hold]) -> Refusal | None:
    """Return the cause that holds a motion back, as a reason against another one, or ``None``."""
    if Hold.PAUSE in holds:
        return PLAN_PAUSED()
    return HELD_AT_ZERO() if holds else None


@dataclass(frozen=True, slots=True)
class MotionCommand:
    """A command of ours that moves the joints.

    Attributes:
        number: The number, which counts up; frames of lower numbers are outdated.
        kind: The kind.
        sent_s: Monotonic time at which its last frames were sent.
        speed_percent: The speed it was sent with, in percent of the arm's maximum.
        joints_deg: The six target angles, where the command names them.
        tool: The target of the tool centre point, where the command names it.
        leads_away: True if that is measurably elsewhere than the tool was at sending; for angles
            this is evident.
        pace: The tool's speed at 100 % along a line or an arc.
        started: The operation that it carries out.
        way: The way that the gate has passed; ``None`` of a stream.
        most_percent: The highest speed that it may be given on its way.
    """

    number: int
    kind: CommandKind
    sent_s: float
    speed_percent: int
    joints_deg: tuple[float, ...] | None = None
    tool: Matrix | None = None
    leads_away: bool = False
    pace: ToolPace | None = None
    started: Started | None = None
    way: Way | None = None
    most_percent: int = 100

    @property
    def tool_mm_s(self) -> float:
        """The tool's highest speed along a line or an arc; infinite for any other motion."""
        return math.inf if self.pace is None else self.pace.linear_mm_s * self.speed_percent / 100.0


@dataclass(frozen=True, slots=True)
class Observation:
    """The knowledge of the arm at one moment.

    Attributes:
        state: The arm as heard.
        traffic: The frames that other hosts were heard to send.
        offsets: The identifier offsets under which the arm may take commands (0x470).
        online: True if the arm is heard at all.
        now_s: Monotonic time.
        waiting: True if frames of ours have not left yet.
        model: The arm's model, whose factory values stand in for unread ones.
    """

    state: ArmState
    traffic: OtherTraffic
    offsets: tuple[int, ...]
    online: bool
    now_s: float
    waiting: bool
    model: PiperModel = PiperModel.PIPER

    @property
    def factory_limits(self) -> tuple[JointLimits, ...]:
        """The limits of the joints that the model leaves the factory with."""
        return model_data(self.model).limits

    @property
    def accelerations_deg_s2(self) -> tuple[float, ...]:
        """The accelerations to plan braking with; see :func:`accelerations`."""
        factory = model_data(self.model).accelerations_deg_s2
        return accelerations(self.state.accelerations_deg_s2, factory)
