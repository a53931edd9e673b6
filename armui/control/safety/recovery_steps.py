"""The steps of recovery as data: the obstacle, and the action of the one button against it."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar, Final

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.safety.uncommanded_motion import UncommandedMotion
from armui.system.sentence import Sentence

Params = Mapping[str, object]
"""The figures of a sentence, by name."""


@dataclass(frozen=True, slots=True)
class ActionText(Sentence):
    """The texts of a step's button.

    Attributes:
        question: The title of the question before an action that may surprise.
        danger: The physical effect to expect; with one the operator is asked, or holds the button.
        held: True if its button is held for a second: the arm moves, or another host loses it.
    """

    context: ClassVar[str] = "RecoveryAction"
    question: str = field(default="", compare=False)
    danger: str = field(default="", compare=False)
    held: bool = field(default=False, compare=False, kw_only=True)


class Action(enum.Enum):
    """The actions of a step's button, with their texts."""

    CONNECT = ActionText("connect", "Connect…")
    LEAVE_TEACHING_INPUT = ActionText("leave_teaching_input", "Motion output")
    RESUME = ActionText(
        "resume",
        "Release (the arm drops)",
        "Release the emergency stop",
        "Release ends the braking by the motors: the arm will drop. Hold the arm.\n"
        "Afterwards the motors must be enabled again.",
        held=True,
    )
    """The emergency stop is ended."""
    ENABLE = ActionText("enable", "Enable")
    CLEAR_ERRORS = ActionText("clear_errors", "Clear error")
    RESET = ActionText(
        "reset",
        "Reset…",
        "Reset the arm",
        "First the emergency stop: the motors only brake and the arm sinks. Then Release ends even "
        "that: the arm will drop. Hold the arm from now on.",
    )
    """The arm gets an emergency stop; its release is the next step."""
    STOP_RECORDING = ActionText("stop_recording", "Stop recording")
    ABORT_REPLAY = ActionText("abort_replay", "Terminate")
    LEAD_BY_HAND = ActionText(
        "lead_by_hand",
        "Lead by hand…",
        "Lead the arm by hand",
        "The arm will give way to the hand and starts a new recording; the one it holds is "
        "lost. Hold the arm.\nWhen you are done, lead it back near its zero pose before you "
        "stop the recording.",
    )
    """Drag teaching is entered again, so that the arm gives way to the hand."""
    STOP = ActionText("stop", "Emergency stop")
    """The arm gets an emergency stop at once."""
    GO_ON = ActionText("go_on", "Continue", held=True)
    """The motion held back goes on."""
    GIVE_UP = ActionText("give_up", "Give up")
    """The motion held back is dropped."""
    TAKE_OVER = ActionText("take_over", "Take over", held=True)
    """The arm is taken from another host."""
    LEAVE_MODE = ActionText(
        "leave_mode",
        "Take back…",
        "Take the arm back",
        "The arm changes back to its own control and is told to hold where it stands. Between the "
        "two its joints are limp for a moment: it may sag, and drop if the second message is "
        "lost. Hold the arm.\nThe other program must have ended.",
    )
    """The arm is taken out of MIT, CPV or high-follow by a mode word, and holds where it is."""
    CHECK_REFERENCE = ActionText("check_reference", "Reference check…")
    """The window of the reference check is opened."""
    ALLOW = ActionText(
        "allow",
        "Move anyway…",
        "Move with the reference in doubt",
        "A joint in doubt may stand up to 85° from what it reports: the arm then goes another way "
        "than the picture and the check show, and may strike itself or the table. Runs and faster "
        "motions may begin for one minute. Keep a hand on the stop.",
    )
    """Motions are agreed to with a reference in doubt."""
    NOTED = ActionText("noted", "Noted")
    """What slipped at a resume was read."""
    STANDBY = ActionText(
        "standby",
        "Take command…",
        "Take the command",
        "The arm will no longer follow the other control; a motion under way ends. Make sure that "
        "nobody relies on it.",
    )
    """This host takes the command from another controller; in standby nothing moves."""
    COME_INSIDE = ActionText("come_inside", "Move inside", held=True)
    """An arm that lies outside its limits is brought inside."""
    CONFIRM_CELL = ActionText("confirm_cell", "Confirm cell")
    """The cell kept for the adapter is that of this arm."""
    LEAVE_CELL = ActionText(
        "leave_cell",
        "Without it…",
        "Go on without the cell",
        "Nothing of the cell holds then, neither its tools nor anything it forbids. Its file is "
        "left as it is.",
    )
    """The cell kept for the adapter could not be read, and is not used."""
    WITHDRAW_STOP = ActionText(
        "withdraw_stop",
        "Withdraw…",
        "Withdraw the stop",
        "The arm is not stopped: it goes on with whatever it is doing, and obeys again. Look at "
        "the arm before.",
    )
    """The stop is withdrawn; the stop button beside it is the other choice."""


@dataclass(frozen=True, slots=True)
class StepText(Sentence):
    """The sentence of a step: the obstacle and what to do.

    Attributes:
        somewhere: The same for an arm that does not name the joint.
        shorter: The same where there is no room for it.
    """

    context: ClassVar[str] = "RecoveryStep"
    somewhere: str = field(default="", compare=False)
    shorter: str = field(default="", compare=False)


class StepKind(enum.Enum):
    """The kinds of steps between the operator and a ready arm, with their texts."""

    NO_DEVICE = StepText(
        "no_device", "No arm is connected. Connect one, or the simulated arm to try everything out."
    )
    OPENING = StepText("opening", "The device is being opened.")
    DEVICE_LOST = StepText(
        "device_lost",
        "The CAN device is gone: no stop reaches the arm. Cut its power if it moves. Plug the "
        "device in again, or choose another one.",
        "",
        "The CAN device is gone: cut the arm's power if it moves.",
    )
    STOP_WAITS_FOR_DEVICE = StepText(
        "stop_waits_for_device",
        "A stop is outstanding: it goes out once the CAN device is back. Cut the arm's power if "
        "it moves.",
    )
    STOP_LAPSED_AWAY = StepText(
        "stop_lapsed_away",
        "A stop is outstanding, and the arm is away. Cut its power if it moves, or connect to it "
        "and press the emergency stop.",
    )
    STOP_LAPSED = StepText(
        "stop_lapsed",
        "A stop is outstanding: the arm was away and has not confirmed it. Press the emergency "
        "stop to send it now, or withdraw it.",
    )
    TEACHING_INPUT = StepText(
        "teaching_input",
        "The arm is a teaching input: it sends commands and obeys none. Hold it: as a motion "
        "output again its six motors hold it under power, or let it drop.",
    )
    STOP_UNCONFIRMED = StepText(
        "stop_unconfirmed",
        "The arm has NOT confirmed the stop; it is sent again and again. Cut its power if it "
        "moves.",
    )
    STOP_REQUESTED = StepText("stop_requested", "Stop sent. Waiting for the arm to confirm it.")
    OFFLINE = StepText(
        "offline",
        "Nothing is heard from the arm. Check its power, the CAN cable and the bit rate, or "
        "whether this computer is too busy.",
    )
    DEAF = StepText(
        "deaf",
        "The adapter sends, but hears nothing, not even errors. Unplug it and plug it in again.",
    )
    BUS_OFF = StepText(
        "adapter_bus_off",
        "{device} is bus-off: after too many errors it neither sends, not even a stop, nor hears. "
        "Check CAN_H and CAN_L, both 120 Ω resistors and the bit rate, then connect again.",
        "",
        "{device} is bus-off: it sends nothing, not even a stop.",
    )
    LISTEN_ONLY = StepText(
        "listen_only",
        "Only listening: nothing is sent but the emergency stop. To move the arm, disconnect here, "
        "then connect without “Listen only”.",
    )
    WORKING = StepText("working", "Waiting for the arm: {what}.")
    STOPPED = StepText(
        "stopped", "Emergency stop: the motors only brake. Support the arm: released, it drops."
    )
    STOPPED_INPUT = StepText(
        "stopped_input",
        "Emergency stop. Support the arm: its release drops it and makes it a teaching input, deaf "
        "even to the stop.",
    )
    HANDSHAKE = StepText("handshake", "The arm is being asked for its protocol.")
    STATUS_UNKNOWN = StepText(
        "status_unknown",
        "The arm sends no complete feedback. If it stays so, check its power and connect again.",
    )
    COMMUNICATION = StepText(
        "communication",
        "No communication with joint {joints}. Check its cable; if the message stays, reset the "
        "arm.",
        "A joint no longer communicates. Check the cables; if the message stays, reset the arm.",
    )
    COLLISION = StepText(
        "collision",
        "Collision, joint {joints}. Remove what the arm hit, then clear the error.",
        "The arm has hit something. Remove it, then clear the errors.",
    )
    DRIVER_FAULT = StepText(
        "driver_fault",
        "Driver error, joint {joints}: its motor may be off. Hold the arm, then clear the error.",
    )
    OVERCURRENT = StepText(
        "overcurrent",
        "Overcurrent, joint {joints}: its motor may be off. Hold the arm, take the load away, "
        "clear the error.",
    )
    STALL = StepText("stall", "Stalled: joint {joints}. Free it, then clear the error.")
    SENSOR = StepText(
        "sensor",
        "Sensor fault, joint {joints}. Clear the error; if it comes back, check the joint's "
        "encoder.",
    )
    UNDERVOLTAGE = StepText(
        "undervoltage",
        "Supply voltage too low, joint {joints}. Check the 24 V supply; the arm goes on by itself.",
    )
    OVERTEMPERATURE = StepText(
        "overtemperature",
        "Too hot, joint {joints}: {temperature} °C. Let the arm cool down; the message goes by "
        "itself.",
    )
    JOINT_STATUS = StepText(
        "joint_status",
        "The arm reports a joint status fault. Look at the joint status, then clear the errors.",
    )
    BRAKE_CLOSED = StepText(
        "brake_closed", "A joint's brake is not released. Hold the arm, then reset it."
    )
    CONTROLLER_HOT = StepText(
        "controller_hot",
        "The main controller is too hot. Let it cool down; if the message stays, reset the arm.",
    )
    RESISTOR_HOT = StepText(
        "resistor_hot",
        "The brake resistor is too hot. Let it cool down; if the message stays, reset the arm.",
    )
    OTHER_FAULT = StepText(
        "other_fault",
        "The arm reports an unspecified fault. Look at the joint status, then reset the arm.",
    )
    UNKNOWN_STATUS = StepText(
        "unknown_status",
        "The arm reports a status this program does not know ({status}). Reset the arm.",
    )
    RECORDING = StepText("recording", "The arm records: lead it by hand. Stop recording when done.")
    REPLAYING = StepText("replaying", "The arm replays what it was taught. Keep clear.")
    REPLAY_PAUSED = StepText(
        "replay_paused",
        "The replay is paused. Hold “Continue” for 1 s under Drag teaching, or terminate it.",
    )
    OTHER_CONTROL = StepText(
        "other_control", "The arm takes its commands from elsewhere: {mode}. Take the command."
    )
    CANCEL_UNHEEDED = StepText(
        "cancel_unheeded",
        "The arm was told to end its motion and still moves. Stop it, or cut its power.",
    )
    OTHER_MODE = StepText(
        "other_mode",
        "Another program drives the arm in {other_mode} mode. Nothing is sent by itself: a new "
        "mode leaves the joints limp. Stop that program first.",
    )
    CELL_UNCONFIRMED = StepText(
        "cell_unconfirmed",
        "Last used here: the cell “{name}”. Is this its arm? Confirm it, or choose under Cell.",
    )
    CELL_HOLDING = StepText(
        "cell_holding",
        "Last used here: the cell “{name}”, the gripper holding “{held}”. Confirm both if they are "
        "there; if the gripper is empty, let go under Cell first.",
    )
    CELL_UNREADABLE = StepText(
        "cell_unreadable",
        "The cell “{name}” kept for this arm could not be read. Choose another one under Cell.",
    )
    OTHER_HOST = StepText(
        "other_host", "Another program controls the arm since {since} ({frames})."
    )
    LEADER_ARM = StepText("leader_arm", "A leader arm moves this arm since {since} ({frames}).")
    PAUSED = StepText(
        "paused",
        "The arm holds back a paused motion to {target}. Hold “Continue” for 1 s, or give it up.",
    )
    HELD_AT_ZERO = StepText(
        "held_at_zero",
        "The arm holds back a motion to {target} at 0 %. Set a speed and hold “Continue” for 1 s, "
        "or give it up.",
    )
    MOTORS_UNKNOWN = StepText(
        "motors_unknown",
        "Nothing is heard from the motor of joint {joints}. If it stays so, check power and cable, "
        "and connect again.",
    )
    DRAG_MODE_AT_REST = StepText(
        "drag_mode_at_rest",
        "Still in drag teaching, near the rest pose. Hold the arm and reset it; if it stays, "
        "switch it off and on.",
    )
    DRAG_MODE_WITHOUT_POWER = StepText(
        "drag_mode_without_power",
        "Still in drag teaching, joint {joint} at {angle}°. Enable the motors, then lead the arm "
        "to its rest pose.",
    )
    OVERSPEED = StepText(
        "overspeed",
        "Dragged too fast: the recording has ended. Lead the arm slowly to within {near}° of zero "
        "(joint {joint}: {angle}°).",
    )
    DRAG_MODE = StepText(
        "drag_mode",
        "Still in drag teaching. Lead every joint by hand to within {near}° of zero (joint "
        "{joint}: {angle}°).",
    )
    OVERSPEED_REPORTED = StepText(
        "overspeed_reported", "The arm was dragged too fast. Hold it, then reset it."
    )
    MOTORS_MIXED = StepText(
        "motors_mixed", "Without power: joint {joints}. Hold the arm, then enable the motors."
    )
    WRONG_MODEL = StepText("wrong_model", "{reason}")
    NO_MOTION = StepText("no_motion", "{reason}")
    MOTORS_OFF = StepText("motors_off", "The motors are off. Enable them to move the arm.")
    REFERENCE_CHECK = StepText(
        "reference_check",
        "The reference is being checked: nothing moves but what the check drives.",
    )
    REFERENCE_IN_DOUBT = StepText(
        "reference_in_doubt",
        "Joint {joints} left its place uncommanded while it was enabled: it may stand elsewhere "
        "than it reports. Check its reference.",
    )
    REFERENCE_AGREED = StepText(
        "reference_agreed",
        "Motions are agreed to, though joint {joints} may stand elsewhere than it reports.",
    )
    SLIPPED = StepText(
        "slipped",
        "At the resume the feedback jumped: {joints}. By so much the joint stood elsewhere than it "
        "reported; what was taught or set as zero before may be off by it.",
    )
    OUTSIDE = StepText(
        "outside",
        "Outside its limits, as a resting arm lies: {outside}. Until it is brought inside the arm "
        "takes only a run, or a target with all joints inside; hold Move inside: these move "
        "slowly, all at once, then J5 if the hand lies on the base.",
        "",
        "Outside its limits: {outside}. Hold Move inside.",
    )
    BEYOND_LIMIT = StepText(
        "beyond_limit",
        "Joint {joints} beyond its limit: the target was not taken. Send one within the limits.",
    )
    TARGET_BEYOND_LIMIT = StepText(
        "target_beyond_limit",
        "The last target is beyond a limit and was not taken. Send another one.",
    )
    NO_SOLUTION = StepText(
        "no_solution", "The last target has no solution and was not taken. Send another one."
    )
    SINGULARITY = StepText(
        "singularity",
        "The way to the last target is singular, and it was not taken. Send another target, or by "
        "joints.",
    )
    RUN_PAUSED = StepText("run_paused", "Paused: with the speed above 0 %, hold “Continue” for 1 s")
    RUN_WAITS = StepText("run_waits", "Waiting: press “Next step”")
    RUNNING = StepText("running", "A trajectory is running")
    IN_AREA = StepText(
        "in_area",
        "The arm is {value} mm too near to “{name}” of the work area ({part}). It can only be "
        "moved out: jog the other way, or lead it by hand.",
    )
    BELOW_LOWEST = StepText(
        "below_lowest",
        "The fingertip is {value} mm below the lowest height for motions. None goes lower: jog "
        "upwards, or change that height in the settings.",
    )
    BELOW_BASE = StepText(
        "below_base",
        "The fingertip is {value} mm below the floor. Jog upwards unless there "
        "is nothing there. Settings have a lowest height for motions.",
    )
    LEFT_HELD_BACK = StepText(
        "left_held_back",
        "Another program may have left a motion held back in the arm. Give it up, or go on with it "
        "there; the next motion from here cancels it.",
    )
    MOVING = StepText("moving", "The arm is moving")
    READY = StepText("ready", "Ready")


ARM_FAULTS: Final = frozenset(
    {
        StepKind.COMMUNICATION,
        StepKind.COLLISION,
        StepKind.DRIVER_FAULT,
        StepKind.OVERCURRENT,
        StepKind.STALL,
        StepKind.SENSOR,
        StepKind.UNDERVOLTAGE,
        StepKind.OVERTEMPERATURE,
        StepKind.JOINT_STATUS,
        StepKind.BRAKE_CLOSED,
        StepKind.CONTROLLER_HOT,
        StepKind.RESISTOR_HOT,
        StepKind.OTHER_FAULT,
        StepKind.UNKNOWN_STATUS,
    }
)
"""The faults that the arm reports: with some of them it still moves, with others it does not."""

UNHINDERED: Final = frozenset(
    {
        StepKind.RUN_PAUSED,
        StepKind.RUN_WAITS,
        StepKind.RUNNING,
        StepKind.IN_AREA,
        StepKind.REFERENCE_AGREED,
        StepKind.BELOW_LOWEST,
        StepKind.BELOW_BASE,
        StepKind.LEFT_HELD_BACK,
        StepKind.MOVING,
        StepKind.READY,
    }
)
"""The steps without an obstacle: the arm moves as it was told, or may be moved."""


@dataclass(frozen=True, slots=True)
class Step:
    """A step of recovery.

    Attributes:
        kind: The obstacle.
        level: The severity.
        params: The figures of its sentence.
        action: The action of the button; ``None`` if the step is taken at the arm, or by waiting.
        alternative: The action of a second button.
        joints: The joints it is about, where some are.
        waiting: True if the action was taken and the arm has not shown it yet.
        failed: The reason why the action came to nothing, once it was taken.
        motion: What the arm is measured to do meanwhile, though nothing holds it or told it to.
        locked: True if nothing may be moved meanwhile.
    """

    kind: StepKind
    level: Level
    params: Params = field(default_factory=dict)
    action: Action | None = None
    joints: tuple[int, ...] = ()
    waiting: bool = False
    failed: Refusal | None = None
    alternative: Action | None = None
    motion: UncommandedMotion | None = None
    locked: bool = False

    @property
    def actions(self) -> frozenset[Action]:
        """The one or two actions that it offers as buttons."""
        both = (self.action, self.alternative)
        return frozenset(action for action in both if action is not None)

    @property
    def held(self) -> bool:
        """True if its button must be held for a second."""
        return self.action is not None and self.action.value.held

    @property
    def dangerous(self) -> bool:
        """True if the action has a physical effect that is said before it is taken."""
        return self.action is not None and bool(self.action.value.danger)


NO_DEVICE: Final = Step(StepKind.NO_DEVICE, Level.INFO, action=Action.CONNECT)
"""The step while no device is connected."""
OPENING: Final = Step(StepKind.OPENING, Level.INFO)
"""The step while one is being opened."""
