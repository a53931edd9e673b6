"""The steps of recovery as data: what stands in the way, and what the one button does about it."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from armui.arm.refusal import Refusal
from armui.control.events import Level


class Action(enum.Enum):
    """What the one button of a step does."""

    CONNECT = "connect"
    LEAVE_TEACHING_INPUT = "leave_teaching_input"
    RESUME = "resume"
    ENABLE = "enable"
    CLEAR_ERRORS = "clear_errors"
    RESET = "reset"
    """Emergency stop; the resume is the next step."""
    STOP_RECORDING = "stop_recording"
    ABORT_REPLAY = "abort_replay"
    LEAD_BY_HAND = "lead_by_hand"
    """Drag teaching is entered again, so that the arm gives way to the hand."""
    STOP = "stop"
    """The emergency stop, at once."""
    GO_ON = "go_on"
    """The motion held back goes on."""
    GIVE_UP = "give_up"
    """The motion held back is dropped."""
    TAKE_OVER = "take_over"
    """The arm is taken from another host."""
    LEAVE_MODE = "leave_mode"
    """The arm is taken out of MIT, CPV or high-follow by a mode word, and holds where it is."""
    STANDBY = "standby"
    """This host takes the command from another controller; in standby nothing moves."""
    WITHDRAW_STOP = "withdraw_stop"
    """The stop button stands beside it: this is the other answer."""


DANGEROUS: Final = frozenset(
    {
        Action.RESUME,
        Action.RESET,
        Action.LEAD_BY_HAND,
        Action.LEAVE_MODE,
        Action.STANDBY,
        Action.WITHDRAW_STOP,
    }
)
"""What the arm does then may surprise: the operator is asked first."""

HELD: Final = frozenset({Action.GO_ON, Action.TAKE_OVER})
"""The button is held for a second: the arm moves, or another host loses it."""


class StepKind(enum.Enum):
    """What stands between the operator and a ready arm; the value names its sentence."""

    NO_DEVICE = "no_device"
    OPENING = "opening"
    DEVICE_LOST = "device_lost"
    STOP_WAITS_FOR_DEVICE = "stop_waits_for_device"
    STOP_LAPSED_AWAY = "stop_lapsed_away"
    STOP_LAPSED = "stop_lapsed"
    TEACHING_INPUT = "teaching_input"
    STOP_UNCONFIRMED = "stop_unconfirmed"
    STOP_REQUESTED = "stop_requested"
    OFFLINE = "offline"
    LISTEN_ONLY = "listen_only"
    WORKING = "working"  # what
    STOPPED = "stopped"
    HANDSHAKE = "handshake"
    STATUS_UNKNOWN = "status_unknown"
    COMMUNICATION = "communication"  # joints
    COLLISION = "collision"  # joints
    DRIVER_FAULT = "driver_fault"  # joints
    OVERCURRENT = "overcurrent"  # joints
    STALL = "stall"  # joints
    SENSOR = "sensor"  # joints
    UNDERVOLTAGE = "undervoltage"  # joints
    OVERTEMPERATURE = "overtemperature"  # joints
    JOINT_STATUS = "joint_status"
    BRAKE_CLOSED = "brake_closed"
    CONTROLLER_HOT = "controller_hot"
    RESISTOR_HOT = "resistor_hot"
    OTHER_FAULT = "other_fault"
    UNKNOWN_STATUS = "unknown_status"  # status
    RECORDING = "recording"
    REPLAYING = "replaying"
    REPLAY_PAUSED = "replay_paused"
    OTHER_CONTROL = "other_control"  # mode
    CANCEL_UNHEEDED = "cancel_unheeded"
    OTHER_MODE = "other_mode"  # other_mode
    OTHER_HOST = "other_host"  # frames, since, rate
    LEADER_ARM = "leader_arm"  # frames, since, rate
    PAUSED = "paused"  # target
    HELD_AT_ZERO = "held_at_zero"  # target
    MOTORS_UNKNOWN = "motors_unknown"
    DRAG_MODE_AT_REST = "drag_mode_at_rest"
    DRAG_MODE_WITHOUT_POWER = "drag_mode_without_power"  # joint, angle, near
    OVERSPEED = "overspeed"  # joint, angle, near
    DRAG_MODE = "drag_mode"  # joint, angle, near
    OVERSPEED_REPORTED = "overspeed_reported"
    MOTORS_MIXED = "motors_mixed"  # joints
    MOTORS_OFF = "motors_off"
    BEYOND_LIMIT = "beyond_limit"  # joints
    TARGET_BEYOND_LIMIT = "target_beyond_limit"
    NO_SOLUTION = "no_solution"
    SINGULARITY = "singularity"
    RUN_PAUSED = "run_paused"
    RUN_WAITS = "run_waits"
    RUNNING = "running"
    BELOW_BASE = "below_base"  # value
    MOVING = "moving"
    READY = "ready"


UNHINDERED: Final = frozenset(
    {
        StepKind.RUN_PAUSED,
        StepKind.RUN_WAITS,
        StepKind.RUNNING,
        StepKind.BELOW_BASE,
        StepKind.MOVING,
        StepKind.READY,
    }
)
"""Nothing stands in the way: the arm moves as it was told, or may be moved."""


Params = Mapping[str, object]
"""The figures of a sentence by name."""


@dataclass(frozen=True, slots=True)
class Step:
    """The next step.

    Attributes:
        kind: What stands in the way.
        level: How much it matters.
        params: The figures of its sentence.
        action: What the button does; ``None``: the step is taken at the arm, or by waiting.
        alternative: What a second button does.
        joints: The joints it is about, where some are.
        waiting: The action has been taken and the arm has not shown it yet.
        failed: The action was taken, and why it came to nothing.
    """

    kind: StepKind
    level: Level
    params: Params = field(default_factory=dict)
    action: Action | None = None
    joints: tuple[int, ...] = ()
    waiting: bool = False
    failed: Refusal | None = None
    alternative: Action | None = None

    @property
    def actions(self) -> frozenset[Action]:
        """What its buttons do."""
        both = (self.action, self.alternative)
        return frozenset(action for action in both if action is not None)

    @property
    def held(self) -> bool:
        """Whether its button must be held for a second."""
        return self.action in HELD

    @property
    def dangerous(self) -> bool:
        """Whether the operator is to be asked before the action is taken."""
        return self.action in DANGEROUS


NO_DEVICE: Final = Step(StepKind.NO_DEVICE, Level.INFO, action=Action.CONNECT)
"""The step before all others."""
