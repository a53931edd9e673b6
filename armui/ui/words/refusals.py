"""Every reason against an action as a sentence: what, its value and limit, and the remedy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.ui.words import arm
from armui.ui.words.arm import gripper_figure, light_figure, other_mode
from armui.ui.words.file_refusals import FILE_REFUSALS, SETTING_NAMES, with_figures, with_units
from armui.ui.words.text import NOT_KNOWN, Texts, sentence

if TYPE_CHECKING:
    from armui.trajectory.files import TrajectoryFileError


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
    RefusalCode.OVERRIDE_ZERO: (
        "The speed override is 0 %: raise it, then hold “Continue” for 1 s."
    ),
    RefusalCode.NO_OWN_HOME: (
        "No home of your own is kept for this arm. Set it with the button beside."
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
    # Zeros of motors, commands of the gripper, the linkage
    RefusalCode.LOAD_NOT_CHOSEN: "No end load is chosen. Choose one first.",
    RefusalCode.LOAD_WHILE_MOVING: (
        "The arm is moving. Wait until it stands still, then set the end load."
    ),
    RefusalCode.END_FEEDBACK_GOES_ON: "The arm has answered, but goes on reporting. Try again.",
    RefusalCode.CONTROL_OFFSET_UNKNOWN: (
        "Whether the arm takes commands on the identifiers in use is not proven, so it is not "
        "moved; stop and halt reach it. To prove it, set the offsets again in Linkage with the "
        "arm in standby: they count once the arm has answered."
    ),
    RefusalCode.OFFSET_NOT_POSSIBLE: (
        "An offset of {value} is not possible. Choose 0x00, 0x10 or 0x20."
    ),
    RefusalCode.LINKAGE_WHILE_MOVING: (
        "The arm is moving. Wait until it stands still, then set the linkage."
    ),
    RefusalCode.GRIPPER_SILENT: (
        "No gripper is heard. If one is mounted, check its cable and its power."
    ),
    RefusalCode.GRIPPER_RANGE_UNKNOWN: (
        "How far this gripper opens is not known: the arm has told no stroke limit. Set it in "
        "Gripper settings, or enter a target in Gripper control."
    ),
    RefusalCode.GRIPPER_TELLS_ANGLE: (
        "The gripper tells an angle now, and a point keeps an opening. Move it by an opening in "
        "Gripper control first."
    ),
    RefusalCode.GRIPPER_NO_ZERO: "The gripper of a generation 1 arm has no command for its zero.",
    RefusalCode.GRIPPER_OUT_OF_RANGE: (
        "{gripper}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} "
        "{unit}."
    ),
    RefusalCode.GRIPPER_NOT_A_NUMBER: (
        "{gripper}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}."
    ),
    RefusalCode.SPEED_UNKNOWN: (
        "Whether these joints stand still is not known: {joints}. Their drivers report no speed: "
        "check the arm's power and the CAN cable."
    ),
    RefusalCode.JOINTS_MOVING: (
        "These joints are moving: {joints}. Wait until the arm stands still."
    ),
    RefusalCode.ZERO_NOT_SET: (
        "The arm answered that it did not set the zero of these joints: {joints}. Let the arm "
        "stand still, clear its errors, then try again."
    ),
    RefusalCode.ZERO_NOT_TAKEN: (
        "The arm answered that the zero is set, but these joints do not read 0°: {joints}. Do not "
        "move the arm before the zero is set anew."
    ),
    RefusalCode.ZERO_MOVED: (
        "Joint {joints} does not stand where it stood at the press: no zero was sent. Try again "
        "where it shall be."
    ),
    RefusalCode.ENDED_BY_STOP: (
        "The stop came first; it is not sent again. Look at what the arm shows, then repeat it."
    ),
    # Runs
    RefusalCode.NO_ROWS_CHOSEN: "No row is chosen. Click one in the table first.",
    RefusalCode.FINDINGS_AGAINST: (
        "Not run: the check has found errors ({count}). Mend what is listed, then send again."
    ),
    RefusalCode.WORK_FAILED: "The program did not come to the end of its work: {text}. Try again.",
    RefusalCode.MOVED_SINCE_CHECK: (
        "Not run: the arm has moved by {value}° since it was checked. Send again."
    ),
    RefusalCode.LIMITS_CHANGED_SINCE_CHECK: (
        "Not run: the arm's joint limits are others than those of the check. Send again."
    ),
    RefusalCode.MODEL_CHANGED_SINCE_CHECK: (
        "Not run: the arm's model or zeros are others than those of the check. Send again."
    ),
    RefusalCode.CHANGED_SINCE_CHECK: (
        "Not run: tool, load, settings or choices are others than those of the check. Send again."
    ),
    RefusalCode.NOT_RUNNING: "No trajectory is running: nothing to pause.",
    RefusalCode.NOT_PAUSED: "No trajectory is paused: nothing to go on with.",
    RefusalCode.RUN_EMPTY: "“{name}” has no points. Add points, or choose another trajectory.",
    RefusalCode.RUN_NO_SUCH_ROW: (
        "There is no row {row}: the last one is {maximum}. Choose another row."
    ),
    RefusalCode.RUN_STOPPED: (
        "The arm is in emergency stop. Hold the arm, press Resume, enable the motors; then the "
        "run can go on from this row."
    ),
    RefusalCode.RUN_UNDER_WAY: (
        "A trajectory or recording is under way, be it paused or dwelling. Wait until it is done, "
        "or end the run first."
    ),
    RefusalCode.RUN_DISABLED: (
        "Motors were disabled while it ran: the arm was told to end its motion. Enable the motors; "
        "then the run can go on from this row."
    ),
    RefusalCode.RUN_LET_GO: (
        "The gripper was disabled while it ran: the arm was told to end its motion. See what it "
        "held; then the run can go on from this row."
    ),
    RefusalCode.RUN_LEFT: (
        "The device was disconnected while it ran: the arm was told before to end its motion."
    ),
    RefusalCode.PART_FAILED: (
        "A part of the program has failed: every motion of this program ends, and none begins "
        "while it fails. Copy the details of the error, then start the program again."
    ),
    RefusalCode.SYSTEM_ENDS: (
        "The computer was about to sleep, or to end this program: the arm was told before to end "
        "its motion."
    ),
    RefusalCode.RUN_SETS_LAMPS: (
        "The run under way sets the lamps itself. Wait until it is done, or end the run first."
    ),
    RefusalCode.JOG_UNDER_WAY: "The arm is being jogged. Let go first, then press again.",
    RefusalCode.PLAN_PAUSED: (
        "A motion of the arm is paused: it holds back every new target. Press Continue or a Clear "
        "button under Drag teaching, Planned trajectory."
    ),
    RefusalCode.RUN_TOO_SLOW: (
        "The point was not reached within {seconds} s. See what keeps the arm, then go on from "
        "this row."
    ),
    RefusalCode.RUN_ELSEWHERE: (
        "The arm says that it is there, but measures itself away from the point: {away}. See what "
        "keeps it, then go on from this row."
    ),
    RefusalCode.RUN_NOT_ENDED: (
        "The arm was told to end its motion and still moves. Press the emergency stop if it must "
        "not."
    ),
    RefusalCode.REPLAY_TOO_FAST: (
        "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
        "{percent} % of the recorded speed at most."
    ),
    RefusalCode.REPLAY_LAGGING: (
        "Joint {joint} does not follow: it is {away}° behind. See what keeps it, or replay more "
        "slowly."
    ),
    RefusalCode.REPLAY_GAP: (
        "The program or the computer stood still for {seconds} s, so the replay was ended. Let the "
        "computer do less beside it, keep it from sleeping, and start the replay anew."
    ),
    RefusalCode.POSE_UNKNOWN: (
        "The arm has not reported its end pose: an arc has no beginning. Wait for it."
    ),
    RefusalCode.GRIPPER_OTHER_GENERATION: (
        "Row {row}: this arm's protocol moves the gripper by other figures (generation 1 by an "
        "angle, generation 2 by an opening). Change the gripper's action."
    ),
    # Gamepads and SpaceMouse
    RefusalCode.GAMEPAD_LOST: "{name} is gone. Plug it in again or switch it on.",
    RefusalCode.GAMEPAD_SILENT: (
        "Nothing more is heard of {name}. Let go of its buttons and press anew."
    ),
    RefusalCode.GAMEPAD_UNATTENDED: (
        "The dead-man button was held for {seconds} s without a movement of the device. Press anew."
    ),
    RefusalCode.GAMEPAD_NOT_IN_FRONT: (
        "The main window, or a page taken out of it, is not in front, or a menu is open. Click "
        "into one of them, then press anew."
    ),
    # Other hosts, leader arms, motions held back
    RefusalCode.FEEDBACK_SILENT: (
        "{frames} of the arm has not been heard for {seconds} s: nobody knows where it is. Check "
        "its power and the CAN cable; nothing is sent until it is heard again."
    ),
    RefusalCode.OTHER_HOST: (
        "Another program controls the arm ({frames}). Wait until it has been quiet for 2 s and the "
        "arm rests, or take over when it pauses. The stop works at any time."
    ),
    RefusalCode.LEADER_ARM: (
        "A leader arm moves this arm ({frames}). Switch the leader off, or make it a motion "
        "output. The stop works at any time."
    ),
    RefusalCode.OTHER_MODE: (
        "Another program drives the arm in {other_mode} mode: a mode word of ours would leave its "
        "joints limp. End that program, hold the arm, and take the way back that the line above "
        "the panels offers."
    ),
    RefusalCode.OTHER_HOST_STREAMS: (
        "The other program is still sending ({frames}): it can be taken over half a second after "
        "its last frame. Against a stream only the stop wins."
    ),
    RefusalCode.LISTEN_ONLY: (
        "This connection only listens: nothing is sent but the emergency stop. Connect without "
        "Listen only to command the arm."
    ),
    RefusalCode.NOBODY_ELSE: "No other program moves the arm.",
    RefusalCode.HELD_AT_ZERO: (
        "The arm holds back a motion at 0 %. Hold Continue or press Give up in the line above the "
        "panels first."
    ),
    RefusalCode.NOTHING_HELD: "No motion is held back.",
    RefusalCode.COMMAND_OVER: (
        "Something else has ended this motion. Look at the arm, then start again."
    ),
    RefusalCode.TOO_FAST: (
        "Joint {joint} moves at {value} °/s, where {maximum} °/s is shown. Set the speed again "
        "before the next motion."
    ),
    RefusalCode.TOOL_TOO_FAST: (
        "The tool moves at {value} mm/s, where {maximum} mm/s is shown. Set the speed again before "
        "the next motion."
    ),
    RefusalCode.TOOL_TURNS_TOO_FAST: (
        "The tool turns at {value} °/s, where {maximum} °/s is shown. Set the speed again before "
        "the next motion."
    ),
    # Frames sent by hand
    RefusalCode.FRAME_ID_BAD: (
        "Identifier: “{value}” is no hexadecimal number. Enter 000 to 7FF, for example 151."
    ),
    RefusalCode.FRAME_ID_TOO_HIGH: (
        "Identifier: {value} has more than 11 bits, and the arm knows none of those. Enter 000 to "
        "7FF."
    ),
    RefusalCode.FRAME_DATA_BAD: (
        "Data: “{value}” are no whole bytes. Enter two hexadecimal figures for each byte, for "
        "example 01 0A FF."
    ),
    RefusalCode.FRAME_DATA_LONG: "Data: {count} bytes do not fit into a frame. Enter 8 at most.",
    RefusalCode.FRAME_IS_THE_ARMS: (
        "{frame} is what an arm itself says: two senders of one identifier disturb the bus, and "
        "others would take it for the arm's word. Choose an identifier that hosts send."
    ),
    RefusalCode.FRAME_OF_UPGRADE: (
        "{frame} is kept for firmware upgrades: what it does is not public, and it may leave the "
        "arm without firmware. Use the maker's upgrade program."
    ),
    RefusalCode.FRAME_RESUMES: (
        "This frame ends an emergency stop and lets the arm drop. Use Resume in the main window, "
        "once the arm is supported."
    ),
    RefusalCode.FRAME_NOT_HELD: (
        "This frame acts on the arm: hold the button for a second to send it."
    ),
}

_ALL: Final = _REFUSALS | FILE_REFUSALS

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
_PLACE = QT_TRANSLATE_NOOP("FilePlace", "{file}, line {line}, column {column}: {reason}")
_LINE = QT_TRANSLATE_NOOP("FilePlace", "{file}, line {line}: {reason}")
_FILE = QT_TRANSLATE_NOOP("FilePlace", "{file}: {reason}")
_PLACE_ONLY = QT_TRANSLATE_NOOP("FilePlace", "Line {line}, column {column}: {reason}")
_LINE_ONLY = QT_TRANSLATE_NOOP("FilePlace", "Line {line}: {reason}")


def refusal(reason: Refusal) -> str:
    """A reason against an action in the operator's language."""
    params = with_figures(reason.code, with_units(dict(reason.params)))
    if isinstance(mode := params.get("mode"), int):
        params["mode"] = arm.control_mode(mode)
    if isinstance(other := params.get("other_mode"), str):
        params["other_mode"] = other_mode(other)
    if isinstance(code := params.get("status"), int):
        params["status"] = arm.arm_status(code)
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


def file_error(error: TrajectoryFileError) -> str:
    """What is wrong with a file, in the operator's language.

    Args:
        error: What was found; a text without a file, as of the clipboard, has none to name.
    """
    reason = refusal(error.reason)
    if error.line:
        named, bare = (_PLACE, _PLACE_ONLY) if error.column else (_LINE, _LINE_ONLY)
        source = named if error.file else bare
    elif error.file:
        source = _FILE
    else:
        return reason
    figures = {"file": error.file, "line": error.line, "column": error.column, "reason": reason}
    return sentence("FilePlace", source, figures)
