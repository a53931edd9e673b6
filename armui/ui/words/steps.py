"""The steps of recovery in the operator's language: the sentence, the button, the danger."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.control.safety.recovery_steps import Action, Step, StepKind
from armui.ui.words import status
from armui.ui.words.other_hosts import held_target, other_mode
from armui.ui.words.refusals import refusal, under_way
from armui.ui.words.text import sentence

_SENTENCES: Final[Mapping[StepKind, object]] = {
    StepKind.NO_DEVICE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "No arm is connected. Connect one, or the simulated arm to try everything out.",
    ),
    StepKind.OPENING: QT_TRANSLATE_NOOP("RecoveryStep", "The device is being opened."),
    StepKind.DEVICE_LOST: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The CAN device is gone. Plug it in again, or choose another one."
    ),
    StepKind.STOP_WAITS_FOR_DEVICE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "A stop is outstanding: it goes out once the CAN device is back. Cut the arm's power if "
        "it moves.",
    ),
    StepKind.STOP_LAPSED_AWAY: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "A stop is outstanding, and the arm is away. Cut its power if it moves, or connect to it "
        "and press the emergency stop.",
    ),
    StepKind.STOP_LAPSED: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "A stop is outstanding: the arm was away and has not confirmed it. Press the emergency "
        "stop to send it now, or withdraw it.",
    ),
    StepKind.TEACHING_INPUT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm is a teaching input: it sends commands and obeys none. Make it a motion "
        "output again.",
    ),
    StepKind.STOP_UNCONFIRMED: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm has NOT confirmed the stop; it is sent again and again. Cut its power if it "
        "moves.",
    ),
    StepKind.STOP_REQUESTED: QT_TRANSLATE_NOOP(
        "RecoveryStep", "Stop sent. Waiting for the arm to confirm it."
    ),
    StepKind.OFFLINE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Nothing is heard from the arm. Check its power, the CAN cable and the bit rate.",
    ),
    StepKind.LISTEN_ONLY: QT_TRANSLATE_NOOP(
        "RecoveryStep", "Only listening: nothing is sent but the emergency stop."
    ),
    StepKind.WORKING: QT_TRANSLATE_NOOP("RecoveryStep", "Waiting for the arm: {what}."),
    StepKind.STOPPED: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Stopped. Support the arm: power will be cut and the arm drops. Then resume.",
    ),
    StepKind.HANDSHAKE: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The arm is being asked for its protocol."
    ),
    StepKind.STATUS_UNKNOWN: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm sends no complete feedback. If it stays so, check its power and connect again.",
    ),
    StepKind.COMMUNICATION: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "No communication with joint {joints}. Check its cable; if the message stays, reset "
        "the arm.",
    ),
    StepKind.COLLISION: QT_TRANSLATE_NOOP(
        "RecoveryStep", "Collision, joint {joints}. Remove what the arm hit, then clear the error."
    ),
    StepKind.DRIVER_FAULT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Driver error, joint {joints}: its motor is off. Hold the arm, then clear the error.",
    ),
    StepKind.OVERCURRENT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Overcurrent, joint {joints}: its motor may be off. Hold the arm, take the load "
        "away, clear the error.",
    ),
    StepKind.STALL: QT_TRANSLATE_NOOP(
        "RecoveryStep", "Joint {joints} is held fast. Free it, then clear the error."
    ),
    StepKind.SENSOR: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Sensor fault, joint {joints}. Clear the error; if it comes back, check the joint's "
        "encoder.",
    ),
    StepKind.UNDERVOLTAGE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Supply voltage too low, joint {joints}. Check the 24 V supply; the arm goes on by itself.",
    ),
    StepKind.OVERTEMPERATURE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Too hot, joint {joints}. Let the arm cool down; the message goes by itself.",
    ),
    StepKind.JOINT_STATUS: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm reports a joint status fault. Look at the joint status, then clear the errors.",
    ),
    StepKind.BRAKE_CLOSED: QT_TRANSLATE_NOOP(
        "RecoveryStep", "A joint's brake is not released. Hold the arm, then reset it."
    ),
    StepKind.CONTROLLER_HOT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The main controller is too hot. Let it cool down; if the message stays, reset the arm.",
    ),
    StepKind.RESISTOR_HOT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The brake resistor is too hot. Let it cool down; if the message stays, reset the arm.",
    ),
    StepKind.OTHER_FAULT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm reports an unspecified fault. Look at the joint status, then reset the arm.",
    ),
    StepKind.UNKNOWN_STATUS: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm reports a status this program does not know ({status}). Reset the arm.",
    ),
    StepKind.RECORDING: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The arm records: lead it by hand. Stop recording when done."
    ),
    StepKind.REPLAYING: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The arm replays what it was taught. Keep clear."
    ),
    StepKind.REPLAY_PAUSED: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The replay is paused. Continue under Teaching, or terminate it."
    ),
    StepKind.OTHER_CONTROL: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The arm takes its commands from elsewhere: {mode}. Take the command."
    ),
    StepKind.CANCEL_UNHEEDED: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm was told to end its motion and still moves. Stop it, or cut its power.",
    ),
    StepKind.OTHER_MODE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Another program drives the arm in {other_mode} mode. Nothing is sent by itself: a new "
        "mode leaves the joints limp. Stop that program first.",
    ),
    StepKind.OTHER_HOST: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Another program controls the arm since {since} ({frames}, {rate} frames/s).",
    ),
    StepKind.LEADER_ARM: QT_TRANSLATE_NOOP(
        "RecoveryStep", "A leader arm moves this arm since {since} ({frames}, {rate} frames/s)."
    ),
    StepKind.PAUSED: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm holds back a paused motion to {target}. Hold Continue, or give it up.",
    ),
    StepKind.HELD_AT_ZERO: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm holds back a motion to {target} at 0 %. Set a speed and hold Continue, or give "
        "it up.",
    ),
    StepKind.MOTORS_UNKNOWN: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Not every motor has reported. If it stays so, check power and cable, and connect again.",
    ),
    StepKind.DRAG_MODE_AT_REST: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Still in drag teaching, near the rest pose. Hold the arm and reset it; if it stays, "
        "switch it off and on.",
    ),
    StepKind.DRAG_MODE_WITHOUT_POWER: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Still in drag teaching, joint {joint} at {angle}°. Enable the motors, then lead the "
        "arm to its rest pose.",
    ),
    StepKind.OVERSPEED: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Dragged too fast: the recording has ended. Lead the arm slowly to within {near}° of "
        "zero (joint {joint}: {angle}°).",
    ),
    StepKind.DRAG_MODE: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Still in drag teaching. Lead every joint by hand to within {near}° of zero (joint "
        "{joint}: {angle}°).",
    ),
    StepKind.OVERSPEED_REPORTED: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The arm was dragged too fast. Hold it, then reset it."
    ),
    StepKind.MOTORS_MIXED: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The motors of joint {joints} are off. Hold the arm, then enable them."
    ),
    StepKind.MOTORS_OFF: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The motors are off. Enable them to move the arm."
    ),
    StepKind.BEYOND_LIMIT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "Joint {joints} beyond its limit. The arm stands still; send a target within the limits.",
    ),
    StepKind.TARGET_BEYOND_LIMIT: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The last target is beyond a limit. The arm stands still; send another target.",
    ),
    StepKind.NO_SOLUTION: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "No way to the last target was found. The arm stands still; send another target.",
    ),
    StepKind.SINGULARITY: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The way to the last target is singular. The arm stands still; send another target, "
        "or by joints.",
    ),
    StepKind.READY: QT_TRANSLATE_NOOP("RecoveryStep", "Ready"),
}

_SOMEWHERE: Final[Mapping[StepKind, object]] = {
    StepKind.COMMUNICATION: QT_TRANSLATE_NOOP(
        "RecoveryStep",
        "The arm has lost a joint. Check the cables; if the message stays, reset the arm.",
    ),
    StepKind.COLLISION: QT_TRANSLATE_NOOP(
        "RecoveryStep", "The arm has hit something. Remove it, then clear the errors."
    ),
}
"""What to say where the arm does not tell which joint it is."""

_BUTTONS: Final[Mapping[Action, object]] = {
    Action.CONNECT: QT_TRANSLATE_NOOP("RecoveryAction", "Connection…"),
    Action.LEAVE_TEACHING_INPUT: QT_TRANSLATE_NOOP("RecoveryAction", "Motion output"),
    Action.RESUME: QT_TRANSLATE_NOOP("RecoveryAction", "Resume…"),
    Action.ENABLE: QT_TRANSLATE_NOOP("RecoveryAction", "Enable"),
    Action.CLEAR_ERRORS: QT_TRANSLATE_NOOP("RecoveryAction", "Clear error"),
    Action.RESET: QT_TRANSLATE_NOOP("RecoveryAction", "Reset…"),
    Action.LEAVE_MODE: QT_TRANSLATE_NOOP("RecoveryAction", "Take back…"),
    Action.STOP_RECORDING: QT_TRANSLATE_NOOP("RecoveryAction", "Stop recording"),
    Action.ABORT_REPLAY: QT_TRANSLATE_NOOP("RecoveryAction", "Terminate"),
    Action.LEAD_BY_HAND: QT_TRANSLATE_NOOP("RecoveryAction", "Lead by hand…"),
    Action.STANDBY: QT_TRANSLATE_NOOP("RecoveryAction", "Take command…"),
    Action.WITHDRAW_STOP: QT_TRANSLATE_NOOP("RecoveryAction", "Withdraw…"),
    Action.STOP: QT_TRANSLATE_NOOP("RecoveryAction", "Emergency stop"),
    Action.GO_ON: QT_TRANSLATE_NOOP("RecoveryAction", "Continue"),
    Action.GIVE_UP: QT_TRANSLATE_NOOP("RecoveryAction", "Give up"),
    Action.TAKE_OVER: QT_TRANSLATE_NOOP("RecoveryAction", "Take over"),
}

_QUESTIONS: Final[Mapping[Action, object]] = {
    Action.RESUME: QT_TRANSLATE_NOOP("RecoveryDanger", "Resume after the emergency stop"),
    Action.RESET: QT_TRANSLATE_NOOP("RecoveryDanger", "Reset the arm"),
    Action.LEAVE_MODE: QT_TRANSLATE_NOOP("RecoveryDanger", "Take the arm back"),
    Action.LEAD_BY_HAND: QT_TRANSLATE_NOOP("RecoveryDanger", "Lead the arm by hand"),
    Action.STANDBY: QT_TRANSLATE_NOOP("RecoveryDanger", "Take the command"),
    Action.WITHDRAW_STOP: QT_TRANSLATE_NOOP("RecoveryDanger", "Withdraw the stop"),
}

_DANGERS: Final[Mapping[Action, object]] = {
    Action.RESUME: QT_TRANSLATE_NOOP(
        "RecoveryDanger",
        "Resuming cuts the power of the motors: the arm will drop. Hold the arm.\nAfterwards "
        "the motors must be enabled again.",
    ),
    Action.RESET: QT_TRANSLATE_NOOP(
        "RecoveryDanger",
        "First the emergency stop: the motors go limp and the arm sinks. Then Resume cuts "
        "their power: the arm will drop. Hold the arm from now on.",
    ),
    Action.LEAVE_MODE: QT_TRANSLATE_NOOP(
        "RecoveryDanger",
        "The arm changes back to its own control and is told to hold where it stands. Between the "
        "two its joints are limp for a moment: it may sag, and drop if the second message is lost. "
        "Hold the arm.\nThe other program must have ended.",
    ),
    Action.LEAD_BY_HAND: QT_TRANSLATE_NOOP(
        "RecoveryDanger",
        "The arm will give way to the hand and starts a new recording; the one it holds is "
        "lost. Hold the arm.\nLead it near its rest pose, then stop recording.",
    ),
    Action.STANDBY: QT_TRANSLATE_NOOP(
        "RecoveryDanger",
        "The arm will no longer follow the other control; a motion under way ends. Make sure "
        "that nobody relies on it.",
    ),
    Action.WITHDRAW_STOP: QT_TRANSLATE_NOOP(
        "RecoveryDanger",
        "The arm is not stopped: it goes on with whatever it is doing, and obeys again. Look at "
        "the arm before.",
    ),
}


def step(this: Step) -> str:
    """What stands in the way and what to do, with what became of the last attempt before it."""
    params: dict[str, object] = dict(this.params)
    if isinstance(mode := params.get("mode"), int):
        params["mode"] = status.control_mode(mode)
    if "target" in params:
        params["target"] = held_target(params["target"])
    if isinstance(other := params.get("other_mode"), str):
        params["other_mode"] = other_mode(other)
    if isinstance(code := params.get("status"), int):
        params["status"] = f"0x{code:02X}"
    if isinstance(what := params.get("what"), str):
        params["what"] = under_way(what)
    table = _SENTENCES if this.joints or this.kind not in _SOMEWHERE else _SOMEWHERE
    text = sentence("RecoveryStep", table[this.kind], params)
    return text if this.failed is None else f"{refusal(this.failed)} {text}"


def step_action(action: Action) -> str:
    """What the button of a step is called."""
    return QCoreApplication.translate("RecoveryAction", str(_BUTTONS[action]))


def step_question(action: Action) -> str:
    """The title of the question before a dangerous action."""
    return QCoreApplication.translate("RecoveryDanger", str(_QUESTIONS[action]))


def step_danger(action: Action) -> str:
    """What will physically happen, said before a dangerous action."""
    return QCoreApplication.translate("RecoveryDanger", str(_DANGERS[action]))
