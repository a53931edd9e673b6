"""The steps of recovery in the operator's language: the sentence, the button, the danger."""

from __future__ import annotations

from typing import Final

from armui.control.safety.recovery_steps import Action, Step, StepKind
from armui.ui.words import arm
from armui.ui.words.arm import held_target, other_mode
from armui.ui.words.refusals import refusal, under_way
from armui.ui.words.text import Texts

_SENTENCES: Final = Texts("RecoveryStep") | {
    StepKind.NO_DEVICE: (
        "No arm is connected. Connect one, or the simulated arm to try everything out."
    ),
    StepKind.OPENING: "The device is being opened.",
    StepKind.DEVICE_LOST: "The CAN device is gone. Plug it in again, or choose another one.",
    StepKind.STOP_WAITS_FOR_DEVICE: (
        "A stop is outstanding: it goes out once the CAN device is back. Cut the arm's power if "
        "it moves."
    ),
    StepKind.STOP_LAPSED_AWAY: (
        "A stop is outstanding, and the arm is away. Cut its power if it moves, or connect to it "
        "and press the emergency stop."
    ),
    StepKind.STOP_LAPSED: (
        "A stop is outstanding: the arm was away and has not confirmed it. Press the emergency "
        "stop to send it now, or withdraw it."
    ),
    StepKind.TEACHING_INPUT: (
        "The arm is a teaching input: it sends commands and obeys none. Make it a motion "
        "output again."
    ),
    StepKind.STOP_UNCONFIRMED: (
        "The arm has NOT confirmed the stop; it is sent again and again. Cut its power if it moves."
    ),
    StepKind.STOP_REQUESTED: "Stop sent. Waiting for the arm to confirm it.",
    StepKind.OFFLINE: (
        "Nothing is heard from the arm. Check its power, the CAN cable and the bit rate."
    ),
    StepKind.LISTEN_ONLY: "Only listening: nothing is sent but the emergency stop.",
    StepKind.WORKING: "Waiting for the arm: {what}.",
    StepKind.STOPPED: "Stopped. Support the arm: power will be cut and the arm drops. Then resume.",
    StepKind.HANDSHAKE: "The arm is being asked for its protocol.",
    StepKind.STATUS_UNKNOWN: (
        "The arm sends no complete feedback. If it stays so, check its power and connect again."
    ),
    StepKind.COMMUNICATION: (
        "No communication with joint {joints}. Check its cable; if the message stays, reset "
        "the arm."
    ),
    StepKind.COLLISION: "Collision, joint {joints}. Remove what the arm hit, then clear the error.",
    StepKind.DRIVER_FAULT: (
        "Driver error, joint {joints}: its motor is off. Hold the arm, then clear the error."
    ),
    StepKind.OVERCURRENT: (
        "Overcurrent, joint {joints}: its motor may be off. Hold the arm, take the load "
        "away, clear the error."
    ),
    StepKind.STALL: "Joint {joints} is held fast. Free it, then clear the error.",
    StepKind.SENSOR: (
        "Sensor fault, joint {joints}. Clear the error; if it comes back, check the joint's "
        "encoder."
    ),
    StepKind.UNDERVOLTAGE: (
        "Supply voltage too low, joint {joints}. Check the 24 V supply; the arm goes on by itself."
    ),
    StepKind.OVERTEMPERATURE: (
        "Too hot, joint {joints}. Let the arm cool down; the message goes by itself."
    ),
    StepKind.JOINT_STATUS: (
        "The arm reports a joint status fault. Look at the joint status, then clear the errors."
    ),
    StepKind.BRAKE_CLOSED: "A joint's brake is not released. Hold the arm, then reset it.",
    StepKind.CONTROLLER_HOT: (
        "The main controller is too hot. Let it cool down; if the message stays, reset the arm."
    ),
    StepKind.RESISTOR_HOT: (
        "The brake resistor is too hot. Let it cool down; if the message stays, reset the arm."
    ),
    StepKind.OTHER_FAULT: (
        "The arm reports an unspecified fault. Look at the joint status, then reset the arm."
    ),
    StepKind.UNKNOWN_STATUS: (
        "The arm reports a status this program does not know ({status}). Reset the arm."
    ),
    StepKind.RECORDING: "The arm records: lead it by hand. Stop recording when done.",
    StepKind.REPLAYING: "The arm replays what it was taught. Keep clear.",
    StepKind.REPLAY_PAUSED: (
        "The replay is paused. Hold “Continue” for 1 s under Teaching, or terminate it."
    ),
    StepKind.OTHER_CONTROL: "The arm takes its commands from elsewhere: {mode}. Take the command.",
    StepKind.CANCEL_UNHEEDED: (
        "The arm was told to end its motion and still moves. Stop it, or cut its power."
    ),
    StepKind.OTHER_MODE: (
        "Another program drives the arm in {other_mode} mode. Nothing is sent by itself: a new "
        "mode leaves the joints limp. Stop that program first."
    ),
    StepKind.OTHER_HOST: (
        "Another program controls the arm since {since} ({frames}, {rate} frames/s)."
    ),
    StepKind.LEADER_ARM: "A leader arm moves this arm since {since} ({frames}, {rate} frames/s).",
    StepKind.PAUSED: (
        "The arm holds back a paused motion to {target}. Hold “Continue” for 1 s, or give it up."
    ),
    StepKind.HELD_AT_ZERO: (
        "The arm holds back a motion to {target} at 0 %. Set a speed and hold “Continue” for 1 s, "
        "or give it up."
    ),
    StepKind.MOTORS_UNKNOWN: (
        "Not every motor has reported. If it stays so, check power and cable, and connect again."
    ),
    StepKind.DRAG_MODE_AT_REST: (
        "Still in drag teaching, near the rest pose. Hold the arm and reset it; if it stays, "
        "switch it off and on."
    ),
    StepKind.DRAG_MODE_WITHOUT_POWER: (
        "Still in drag teaching, joint {joint} at {angle}°. Enable the motors, then lead the "
        "arm to its rest pose."
    ),
    StepKind.OVERSPEED: (
        "Dragged too fast: the recording has ended. Lead the arm slowly to within {near}° of "
        "zero (joint {joint}: {angle}°)."
    ),
    StepKind.DRAG_MODE: (
        "Still in drag teaching. Lead every joint by hand to within {near}° of zero (joint "
        "{joint}: {angle}°)."
    ),
    StepKind.OVERSPEED_REPORTED: "The arm was dragged too fast. Hold it, then reset it.",
    StepKind.MOTORS_MIXED: "The motors of joint {joints} are off. Hold the arm, then enable them.",
    StepKind.MOTORS_OFF: "The motors are off. Enable them to move the arm.",
    StepKind.BEYOND_LIMIT: (
        "Joint {joints} beyond its limit. The arm stands still; send a target within the limits."
    ),
    StepKind.TARGET_BEYOND_LIMIT: (
        "The last target is beyond a limit. The arm stands still; send another target."
    ),
    StepKind.NO_SOLUTION: (
        "No way to the last target was found. The arm stands still; send another target."
    ),
    StepKind.SINGULARITY: (
        "The way to the last target is singular. The arm stands still; send another target, "
        "or by joints."
    ),
    StepKind.RUN_PAUSED: "Paused: hold “Continue” for 1 s",
    StepKind.RUN_WAITS: "Waiting: press “Next step”",
    StepKind.RUNNING: "A trajectory is running",
    StepKind.BELOW_BASE: (
        "The fingertip is {value} mm below the plane the arm stands on. Jog upwards unless there "
        "is nothing there. Settings have a lowest height for jogs."
    ),
    StepKind.MOVING: "The arm is moving",
    StepKind.READY: "Ready",
}

_SOMEWHERE: Final = Texts("RecoveryStep") | {
    StepKind.COMMUNICATION: (
        "The arm has lost a joint. Check the cables; if the message stays, reset the arm."
    ),
    StepKind.COLLISION: "The arm has hit something. Remove it, then clear the errors.",
}
"""What to say where the arm does not tell which joint it is."""

_BUTTONS: Final = Texts("RecoveryAction") | {
    Action.CONNECT: "Connection…",
    Action.LEAVE_TEACHING_INPUT: "Motion output",
    Action.RESUME: "Resume…",
    Action.ENABLE: "Enable",
    Action.CLEAR_ERRORS: "Clear error",
    Action.RESET: "Reset…",
    Action.LEAVE_MODE: "Take back…",
    Action.STOP_RECORDING: "Stop recording",
    Action.ABORT_REPLAY: "Terminate",
    Action.LEAD_BY_HAND: "Lead by hand…",
    Action.STANDBY: "Take command…",
    Action.WITHDRAW_STOP: "Withdraw…",
    Action.STOP: "Emergency stop",
    Action.GO_ON: "Continue",
    Action.GIVE_UP: "Give up",
    Action.TAKE_OVER: "Take over",
}

_QUESTIONS: Final = Texts("RecoveryDanger") | {
    Action.RESUME: "Resume after the emergency stop",
    Action.RESET: "Reset the arm",
    Action.LEAVE_MODE: "Take the arm back",
    Action.LEAD_BY_HAND: "Lead the arm by hand",
    Action.STANDBY: "Take the command",
    Action.WITHDRAW_STOP: "Withdraw the stop",
}

_DANGERS: Final = Texts("RecoveryDanger") | {
    Action.RESUME: (
        "Resuming cuts the power of the motors: the arm will drop. Hold the arm.\nAfterwards "
        "the motors must be enabled again."
    ),
    Action.RESET: (
        "First the emergency stop: the motors go limp and the arm sinks. Then Resume cuts "
        "their power: the arm will drop. Hold the arm from now on."
    ),
    Action.LEAVE_MODE: (
        "The arm changes back to its own control and is told to hold where it stands. Between the "
        "two its joints are limp for a moment: it may sag, and drop if the second message is lost. "
        "Hold the arm.\nThe other program must have ended."
    ),
    Action.LEAD_BY_HAND: (
        "The arm will give way to the hand and starts a new recording; the one it holds is "
        "lost. Hold the arm.\nLead it near its rest pose, then stop recording."
    ),
    Action.STANDBY: (
        "The arm will no longer follow the other control; a motion under way ends. Make sure "
        "that nobody relies on it."
    ),
    Action.WITHDRAW_STOP: (
        "The arm is not stopped: it goes on with whatever it is doing, and obeys again. Look at "
        "the arm before."
    ),
}


def step(this: Step) -> str:
    """What stands in the way and what to do, with what became of the last attempt before it."""
    params: dict[str, object] = dict(this.params)
    if isinstance(mode := params.get("mode"), int):
        params["mode"] = arm.control_mode(mode)
    if "target" in params:
        params["target"] = held_target(params["target"])
    if isinstance(other := params.get("other_mode"), str):
        params["other_mode"] = other_mode(other)
    if isinstance(code := params.get("status"), int):
        params["status"] = f"0x{code:02X}"
    if isinstance(what := params.get("what"), str):
        params["what"] = under_way(what)
    table = _SENTENCES if this.joints or this.kind not in _SOMEWHERE else _SOMEWHERE
    text = table.text(this.kind, params)
    return text if this.failed is None else f"{refusal(this.failed)} {text}"


def step_action(action: Action) -> str:
    """What the button of a step is called."""
    return _BUTTONS.text(action)


def step_question(action: Action) -> str:
    """The title of the question before a dangerous action."""
    return _QUESTIONS.text(action)


def step_danger(action: Action) -> str:
    """What will physically happen, said before a dangerous action."""
    return _DANGERS.text(action)
