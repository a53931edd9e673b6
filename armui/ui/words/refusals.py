"""Every reason against an action as a sentence: what, its value and limit, and the remedy."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.ui.words import status
from armui.ui.words.backup_refusals import BACKUP_REFUSALS
from armui.ui.words.gamepad_refusals import GAMEPAD_REFUSALS
from armui.ui.words.gripper import gripper_figure
from armui.ui.words.lights import light_figure
from armui.ui.words.log_refusals import LOG_REFUSALS
from armui.ui.words.motor_refusals import MOTOR_REFUSALS
from armui.ui.words.other_hosts import OTHER_HOST_REFUSALS, other_mode
from armui.ui.words.robot_refusals import ROBOT_REFUSALS
from armui.ui.words.run_refusals import RUN_REFUSALS
from armui.ui.words.session_refusals import SESSION_REFUSALS
from armui.ui.words.setting_names import SETTING_NAMES
from armui.ui.words.setting_refusals import SETTING_REFUSALS, with_units
from armui.ui.words.text import NOT_KNOWN, Texts, sentence
from armui.ui.words.trajectory_refusals import TRAJECTORY_REFUSALS, with_figures

_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.NOT_CONNECTED: (
        "No arm is connected. Click the button at the top left, choose a device and connect it."
    ),
    RefusalCode.OFFLINE: (
        "The device is open, but nothing is heard from the arm. Check its power, the CAN cable "
        "and the bit rate."
    ),
    RefusalCode.LINK_LOST: (
        "The CAN device is gone. Plug it in again: the program reconnects by itself."
    ),
    RefusalCode.STOPPED: (
        "The arm is in emergency stop. Hold the arm, press Resume, then enable the motors."
    ),
    RefusalCode.HALT_LISTEN_ONLY: (
        "This connection only listens: nothing is sent on it but the emergency stop."
    ),
    RefusalCode.STOP_REQUESTED: (
        "The emergency stop has been sent and the arm has not confirmed it yet. Wait for the "
        "confirmation."
    ),
    RefusalCode.NOT_STOPPED: "The arm is not in emergency stop: there is nothing to resume from.",
    RefusalCode.BUSY: "Still under way: {what}. Wait until it is done.",
    RefusalCode.STEP_GONE: (
        "The arm is in another state by now: nothing was sent. Look at the step that is shown now."
    ),
    RefusalCode.VERSION_UNANSWERED: (
        "Nothing was sent: the arm was asked for its firmware version and has not named it within "
        "0.9 s. With an older one it would fall. Try again; if it stays so, hold the arm and use "
        "the emergency stop."
    ),
    RefusalCode.VERSION_NOT_FIT: (
        "Nothing was sent: asked for its firmware version, the arm named {versions}. With it, or "
        "with two arms on the bus, an arm would fall. Hold the arm and use the emergency stop."
    ),
    RefusalCode.ASKED_OTHERWISE: (
        "What it was asked about is no more as it was: nothing was sent. Ask again."
    ),
    RefusalCode.DRAG_GIVEN_UP: (
        "The drag was given up: the arm, or what was dragged, is another by now. Drag again."
    ),
    RefusalCode.STEP_IN_VAIN: "The arm did not react.",
    RefusalCode.TEACHING_OFF: (
        "The arm is not in drag teaching. Start recording first, or press the button on the arm."
    ),
    RefusalCode.TEACHING_IDLE: (
        "Nothing is under way in drag teaching. Start recording or replay first."
    ),
    RefusalCode.TEACHING_RECORDING: "The arm is recording. Stop recording first.",
    RefusalCode.TEACHING_REPLAYING: "The arm is replaying. Pause or terminate the replay first.",
    RefusalCode.TEACHING_PAUSED: "The replay is paused. Continue or terminate it first.",
    RefusalCode.NOT_MOVING: "The arm is not moving: there is nothing to pause.",
    RefusalCode.NOT_ENABLED: (
        "The motors of these joints are not enabled: {joints}. Press Enable first."
    ),
    RefusalCode.ENABLED_UNKNOWN: (
        "Not every motor has reported yet whether it is enabled. Wait a moment; if it stays so, "
        "check the arm's power and the CAN cable."
    ),
    RefusalCode.SPEED_ZERO: (
        "The speed is set to 0 %: the arm would not move. Set a speed from 1 to 100 % at the top."
    ),
    RefusalCode.SPEED_OUT_OF_RANGE: (
        "Speed {value} % is out of range. Enter a value from 0 to 100 %."
    ),
    RefusalCode.JOINT_OUT_OF_LIMITS: (
        "Joint {joint}: {value}° is beyond its limits of {minimum}° to {maximum}°. Enter an angle "
        "within them."
    ),
    RefusalCode.JOINT_NOT_A_NUMBER: (
        "Joint {joint}: “{value}” is not an angle. Enter degrees in figures, for example 12.5."
    ),
    RefusalCode.STILL_MOVING: (
        "The arm is still moving. Wait until it stands still, then press again."
    ),
    RefusalCode.JOG_AT_LIMIT: "Joint {joint} is at its limit of {limit}°. Jog the other way.",
    RefusalCode.JOG_OUT_OF_REACH: "The arm reaches no further this way. Jog in another direction.",
    RefusalCode.JOG_TOO_LOW: (
        "The fingertip would come to {value} mm; jogs end at {minimum} mm, as chosen under "
        "Settings. Jog upwards."
    ),
    RefusalCode.JOG_SINGULAR: (
        "The arm is at a singular pose: joint {joint} would have to turn far too fast. Jog "
        "another way, or turn joint 5 away from 0° under Motion control."
    ),
    RefusalCode.JOG_NOT_FOLLOWING: (
        "The arm does not follow. Check that nothing blocks it and what its status says."
    ),
    RefusalCode.JOG_NO_FEEDBACK: (
        "The joint angles are no longer heard from the arm. Check its power and the CAN cable."
    ),
    RefusalCode.HOLD_UNATTENDED: (
        "Jogging ended: held for {seconds} s without a movement of the mouse or another key. Let "
        "go and press again; move the mouse a little while you hold it for long."
    ),
    RefusalCode.JOG_HELD_UP: "The program was held up for {value} ms. Let go and press again.",
    RefusalCode.POSE_UNKNOWN: (
        "The arm has not reported its pose yet. Wait until all six values are shown."
    ),
    RefusalCode.TARGET_REFUSED: (
        "The arm itself refuses its last target: {status}. Send another one."
    ),
    RefusalCode.POSE_NOT_A_NUMBER: (
        "{axis}: “{value}” is no figure. Enter mm or degrees in figures, for example 12.5."
    ),
    RefusalCode.POSE_OUT_OF_REACH: (
        "The target is {missing} mm out of the arm's reach. Choose one nearer to the arm, or "
        "turn the tool."
    ),
    RefusalCode.POSE_BEYOND_LIMITS: (
        "At the target joint {joint} would stand at {value}°, beyond its limits of {minimum}° to "
        "{maximum}°. Choose another position or turn the tool."
    ),
    RefusalCode.PATH_OUT_OF_REACH: (
        "After {gone} % of the way the arm reaches no further. Choose MOVE P, or another target."
    ),
    RefusalCode.PATH_BEYOND_LIMITS: (
        "After {gone} % of the way joint {joint} would be at {value}°, beyond its limits of "
        "{minimum}° to {maximum}°. Choose MOVE P, or another target."
    ),
    RefusalCode.PATH_SINGULAR: (
        "After {gone} % of the way the arm comes to a singular pose: joint {joint} would have to "
        "jump. Choose MOVE P, or move joint 5 away from 0° first."
    ),
    RefusalCode.ARC_NOT_AT_START: (
        "The arm stands {distance} mm and {turned}° away from the start of the arc. Press Go to "
        "start first."
    ),
    RefusalCode.ARC_IS_NONE: (
        "The three poses lie on a line, or two in one place: that is no arc. Capture others."
    ),
    RefusalCode.ARC_INCOMPLETE: (
        "Not captured yet: {point}. Bring the arm there and press its button."
    ),
    RefusalCode.MODEL_DIFFERS: (
        "The pose the arm reports does not fit its joint angles: the program cannot compute its "
        "way. Check the joints' zeros; the joints can still be moved one by one."
    ),
    RefusalCode.MODEL_OTHER: (
        "This arm was connected as a {chosen}, but the pose it reports is that of a {fits}: the "
        "program would compute with the wrong lengths. Connect it as a {fits}; until then the "
        "joints can be moved one by one."
    ),
    RefusalCode.TOOL_NOT_POSSIBLE: (
        "Tool centre point: {value} is not possible. Enter lengths up to {maximum} mm and angles "
        "up to 180°."
    ),
    RefusalCode.LIGHT_OUT_OF_RANGE: (
        "{light}: {value} is out of range. Enter a whole number from {minimum} to {maximum}."
    ),
    RefusalCode.LIGHT_NOT_A_NUMBER: (
        "{light}: “{value}” is not a whole number. Enter one from {minimum} to {maximum}."
    ),
    RefusalCode.JOINTS_UNKNOWN: (
        "The arm has not reported all of its joint angles yet. Wait until all six are shown."
    ),
    RefusalCode.OTHER_CONTROL: (
        "The arm takes its commands from elsewhere: {mode}. Leave that mode first."
    ),
    RefusalCode.ARM_FAULT: (
        "The arm reports: {status}. Remove the cause. If the report stays: emergency stop, hold "
        "the arm, Resume."
    ),
    RefusalCode.BUS_GONE: (
        "{device} is not there. Check that it is plugged in and its cable is sound."
    ),
    RefusalCode.BUS_BUSY: (
        "{device} is in use by another program. Close that program, then connect again."
    ),
    RefusalCode.BUS_DOWN: (
        "{device} is switched off in the system. Switch it on in a terminal (with your "
        "interface's name for can0): sudo ip link set can0 up type can bitrate 1000000"
    ),
    RefusalCode.BUS_PERMISSION: (
        "You may not open {device}. On Linux add your account to the group dialout (serial "
        "adapters) or install the adapter's udev rule (USB adapters), then log in again."
    ),
    RefusalCode.BUS_OFF: (
        "{device} is bus off: too many errors on the CAN bus, so its controller takes no part any "
        "more. Check CAN_H and CAN_L, both terminating resistors (120 Ω) and the bit rate, then "
        "disconnect and connect again; on socketcan run «sudo ip link set {channel} type can "
        "restart» before."
    ),
    RefusalCode.BUS_UNACKNOWLEDGED: (
        "For half a second {device} could send nothing, because nobody on the bus acknowledges. "
        "Check the arm's power, the CAN cable, the terminating resistors and the bit rate "
        "(1 Mbit/s)."
    ),
    RefusalCode.BUS_SEND_BLOCKED: (
        "For half a second {device} has taken no frame to send, though frames are heard. "
        "Unplug the adapter and plug it in again; if that does not help, check its driver."
    ),
    RefusalCode.BUS_BACKEND_MISSING: (
        "{device} needs a Python package that is not installed. Install it in a terminal: "
        "pip install {package}"
    ),
    RefusalCode.BUS_DRIVER_MISSING: (
        "The driver for {device} ({interface}) is missing. Install the driver of the adapter's "
        "maker; for socketcan load the kernel's modules: sudo modprobe can_raw"
    ),
    RefusalCode.BUS_BAD_ARGUMENT: (
        "{device} does not accept these settings: {text}. Check interface, channel and bit rate."
    ),
    RefusalCode.BUS_FAILED: (
        "{device} could not be opened: {text}. Check the device and its driver, then connect again."
    ),
    RefusalCode.SETTINGS_BROKEN: (
        "The settings file could not be read and was put aside as {kept}. The program starts with "
        "its first settings."
    ),
    RefusalCode.SETTINGS_UNREADABLE: (
        "The settings file {path} could not be read: {text}. The program starts with its first "
        "settings."
    ),
    RefusalCode.SETTINGS_NOT_SAVED: (
        "The settings could not be saved in {path}: {text}. They hold until the program ends."
    ),
    RefusalCode.SETTINGS_IN_USE: (
        "Another program is writing the settings file {path}. The settings hold until this program "
        "ends; change them once more to save them."
    ),
    RefusalCode.SETTING_BAD: (
        "Setting “{field}”: “{value}” is not possible. Its first setting is used instead."
    ),
    RefusalCode.JOG_STEP_OUT_OF_RANGE: (
        "Jog step {value}° is out of range. Enter a value from {minimum}° to {maximum}°."
    ),
    RefusalCode.JOG_STEP_NOT_A_NUMBER: (
        "Jog step: “{value}” is not an angle. Enter degrees in figures, for example 0.5."
    ),
}

_ALL: Final = (
    _REFUSALS
    | SETTING_REFUSALS
    | BACKUP_REFUSALS
    | ROBOT_REFUSALS
    | LOG_REFUSALS
    | RUN_REFUSALS
    | OTHER_HOST_REFUSALS
    | MOTOR_REFUSALS
    | SESSION_REFUSALS
    | GAMEPAD_REFUSALS
    | TRAJECTORY_REFUSALS
)

_UNDER_WAY: Final = Texts("UnderWay") | {
    "enabling": "enabling the motors",
    "disabling": "disabling the motors",
    "resuming": "resuming after the emergency stop",
    "recording": "recording",
    "settings": "reading or saving the arm's settings",
    "end_reports": "the setting before",
    "linkage": "setting the linkage",
    "zeroing": "setting a zero",
    "clearing_error": "clearing a joint's error",
    "teaching": "a teaching command",
    "recovery": "the step before",
}

CODES: Final = frozenset(_ALL)
"""The refusals there is a sentence for."""


def refusal(reason: Refusal) -> str:
    """A reason against an action in the operator's language."""
    params = with_figures(reason.code, with_units(dict(reason.params)))
    if isinstance(mode := params.get("mode"), int):
        params["mode"] = status.control_mode(mode)
    if isinstance(other := params.get("other_mode"), str):
        params["other_mode"] = other_mode(other)
    if isinstance(code := params.get("status"), int):
        params["status"] = status.arm_status(code)
    if isinstance(what := params.get("what"), str):
        params["what"] = under_way(what)
    if isinstance(field := params.get("field"), str):
        params["field"] = SETTING_NAMES.word(field)
    if isinstance(light := params.get("light"), str):
        params["light"] = light_figure(light)
    if isinstance(figure := params.get("gripper"), str):
        params["gripper"] = gripper_figure(figure)
    if reason.code not in _ALL:
        return _unexpected(reason)
    return _ALL.text(reason.code, params)


def why_not(reason: Refusal | None) -> str:
    """The same, or nothing where nothing stands in the way."""
    return "" if reason is None else refusal(reason)


def under_way(what: str) -> str:
    """What the program is waiting for the arm to do."""
    return _UNDER_WAY.word(what)


def _unexpected(reason: Refusal) -> str:
    """What to say to a code this program has no sentence for: an adapter of others may add one."""
    source = QT_TRANSLATE_NOOP("Refusal", "Not possible now: {reason}.")
    return sentence("Refusal", source, {"reason": str(reason) or NOT_KNOWN})
