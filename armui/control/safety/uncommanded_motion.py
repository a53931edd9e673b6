"""The motion of an arm that no motor holds, or that nothing told to move, as values: pure.

Emergency stop and disabling take the power from the joints, and the arm has no brakes: what the
operator is shown is therefore what is measured, not what was asked for (safety S37).
"""

from __future__ import annotations

import enum
from dataclasses import dataclass


class Unheld(enum.Enum):
    """The reasons why the arm may move without a command."""

    STOPPED = "stopped"
    """The emergency stop has taken the power; the windings brake."""
    MOTORS_OFF = "motors_off"
    """No motor has power: disabled, or after a resume."""
    JOINTS_OFF = "joints_off"
    """Some motors have no power: disabled, or by a fault."""
    DRAG_TEACHING = "drag_teaching"
    """In drag teaching, where nobody is known to lead it."""
    OWN_REPLAY = "own_replay"
    """In drag teaching it follows its taught path, or goes to its start, until it rests."""
    LED = "led"
    """In drag teaching it records, or it is a teaching input: a hand leads it."""
    NOT_TOLD = "not_told"
    """All motors are on, and neither this program nor another host has told it to move."""
    STOP_AWAITED = "stop_awaited"
    """A stop was asked for that the arm has not confirmed."""


class MotionKind(enum.Enum):
    """What is known of the motion of an arm that nothing holds, or commanded to move."""

    UNMEASURED = "unmeasured"
    """Whether it stands is not measured yet."""
    SINKS = "sinks"
    MOVES = "moves"
    """It moves up or sideways, as by a hand."""
    LED = "led"
    """A hand moves it."""
    UNHEARD = "unheard"
    """Nothing is heard of it: it may be moving."""


@dataclass(frozen=True, slots=True)
class UncommandedMotion:
    """A motion without a command of ours, with the figures shown while it lasts.

    Attributes:
        kind: The kind of motion.
        cause: Why it may move; ``None`` of an arm that is not heard.
        seconds: The time since it began to move, or since it was last heard.
        down_mm: How far the lowest of flange, fingertip and held object has come down meanwhile;
            0 if it has not.
        joint: The joint (1–6) that has turned furthest, of those that it is about.
        turned_deg: How far that joint has turned.
        speed_mm_s: The speed of the flange now, or when it was last heard; 0: it stood still,
            ``None``: that was not measured.
        below: The names of the parts of the work area below it; "" for none.
    """

    kind: MotionKind
    cause: Unheld | None = None
    seconds: int = 0
    down_mm: int = 0
    joint: int = 0
    turned_deg: float = 0.0
    speed_mm_s: int | None = 0
    below: str = ""

    def figures(self) -> dict[str, object]:
        """Return the figures of its sentences by name."""
        return {
            "down": self.down_mm,
            "seconds": self.seconds or "< 1",
            "joint": self.joint,
            "turned": f"{self.turned_deg:.1f}",
            "speed": self.speed_mm_s,
            "below": self.below,
        }

    @property
    def is_level(self) -> bool:
        """True if its weight comes down, and the lowest of its end not, as where the hand rises."""
        return self.kind is MotionKind.SINKS and self.down_mm == 0

    @property
    def is_danger(self) -> bool:
        """True if the operator is to be warned: it moves by no hand, or may be moving."""
        return self.kind in {MotionKind.SINKS, MotionKind.MOVES, MotionKind.UNHEARD}
