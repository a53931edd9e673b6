"""What operator and client of the fuzz have asked for, and what must not be."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field

from armui.sim.mechanics.powered_joints import SixValues


class Kind(enum.Enum):
    """What was asked for."""

    NOTHING = "nothing"
    STEP = "a joint step"
    TOOL_STEP = "a tool step"
    JOINTS = "six angles"
    POSE = "a pose"
    JOG = "a held jog"
    RUN = "a run"
    CONTINUE = "继续"
    TEACHING = "drag teaching"
    STREAM = "a client's stream"


@dataclass(slots=True)
class Asked:
    """The last thing that was asked for and may move the arm.

    Attributes:
        kind: What it was.
        at_s: When.
        goal_deg, pose: Where it leads (of the flange), as far as it says.
        joint, delta: Of a step: what is to turn, and by how much.
        bases: Where a step may start from: the arm, and our own target while it stands.
        along: Of a step of the tool, where it is known: which way in the base, of length 1.
        cancelled: What has ended it.
        over_jog: Whether a jog was still held when it was asked for.
        lease: By which a client asked for it; ``None``: the operator did.
        ended_s: When a stream was ended by its client.
    """

    kind: Kind
    at_s: float
    goal_deg: SixValues | None = None
    pose: SixValues | None = None
    joint: int | None = None
    delta: float = 0.0
    bases: list[SixValues] = field(default_factory=list)
    along: tuple[float, ...] | None = None
    cancelled: str | None = None
    over_jog: bool = False
    lease: int | None = None
    ended_s: float = -1e9


@dataclass(frozen=True, slots=True)
class Violation:
    """Something that must not be.

    Attributes:
        promise: Its number in safety.md, or «exception».
        key: What tells it from other violations: the same in each shrunk run.
        text: What was seen, with its figures.
    """

    promise: str
    key: str
    text: str
