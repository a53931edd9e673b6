"""Everything that happens as a sentence, for the left half of the status bar."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.device import Device
from armui.arm.refusal import Refusal
from armui.control.events import Event, EventCode
from armui.protocol.codes import EndLoad, Mounting, TeachingState, TrajectoryCommand
from armui.ui.words.arm import (
    device_name,
    end_load,
    gripper_act,
    mounting,
    teaching_command,
    trajectory_command,
)
from armui.ui.words.refusals import refusal
from armui.ui.words.text import Texts, sentence

_NOTICES: Final[Texts[str]] = Texts("Notice") | {
    EventCode.SENT_JOINTS: "Sent J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°",
    EventCode.JOGGED: "Sent J{joint} {target}°",
    EventCode.WENT_HOME: "Home sent: all joints to 0°",
    EventCode.JOGGING_JOINT: "Jogging J{joint} {sign}",
    EventCode.JOGGING_TOOL: "Jogging {axis} {sign}",
    EventCode.DEVICE_JOGS_JOINTS: "{device} jogs {axes} (joints)",
    EventCode.DEVICE_JOGS_BASE: "{device} jogs {axes} (base frame)",
    EventCode.DEVICE_JOGS_TOOL: "{device} jogs {axes} (tool frame)",
    EventCode.JOG_ENDED: "Jogging ended. {reason}",
    EventCode.SENT_POSE: "Sent MOVE P to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°",
    EventCode.SENT_LINE: "Sent MOVE L to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°",
    EventCode.SENT_ARC: "Sent MOVE C through the three captured poses",
    EventCode.STEPPED_TOOL: "Sent a step of {step} along {axis}",
    EventCode.SENT_SPEED: "Sent speed {percent} %",
    EventCode.OVERRIDE_SET: "Speed override {percent} %",
    EventCode.SPEED_WAITS: "{percent} % is kept: the arm gets it when the motion held back goes on",
    EventCode.OTHER_HOST_MOVES: "Another program controls the arm ({frames}).",
    EventCode.LEADER_ARM_MOVES: "A leader arm moves this arm ({frames}).",
    EventCode.OTHER_HOST_GONE: "Nobody else controls the arm any more.",
    EventCode.TAKEN_OVER: "Taken over: this program may move the arm.",
    EventCode.MODE_LEFT: (
        "Told the arm to leave the other program's mode and to hold where it stands."
    ),
    EventCode.CANCEL_UNHEEDED: (
        "The arm was told to end its motion and still moves. Stop it, or cut its power."
    ),
    EventCode.MOTION_UNHEEDED: (
        "The arm has not taken the last motion: it is heard, and does not move. It may listen "
        "under another control offset (Linkage control), or a frame was lost."
    ),
    EventCode.MOTION_TOO_FAST: "Motion ended: too fast. {reason}",
    EventCode.FRAMES_DROPPED: (
        "{count} frames were lost before the program could read them ({total} since connecting): "
        "the computer is too busy, or the adapter too slow."
    ),
    EventCode.FRAME_SENT_BY_HAND: "Sent by hand: {frame}. It counts as another program's command.",
    EventCode.SENT_LAMP: "Sent to lamp {lamp} of joint {joint}: {color}",
    EventCode.SENT_LAMPS: "Sent to all lamps of joint {joint}: {color}",
    EventCode.STOP_SENT: "Emergency stop sent. The motors go limp and the arm sinks: hold the arm.",
    EventCode.STOP_NOT_SENT: (
        "The emergency stop is NOT on the bus: no CAN device is open, or it does not take the "
        "frame. Cut the arm's power if it moves."
    ),
    EventCode.STOP_REACHES_OTHER: (
        "A second arm is heard on this bus (feedback at {feedback}): the stop reaches it, too."
    ),
    EventCode.STOP_LAPSED: (
        "A stop is outstanding: the arm was away for more than 10 seconds and has not confirmed "
        "it. It is not sent by itself any more. Press the emergency stop if the arm must stop."
    ),
    EventCode.STOP_WITHDRAWN: (
        "The outstanding emergency stop was withdrawn; the arm has not stopped."
    ),
    EventCode.STOP_ABANDONED: (
        "The arm on {device} has never confirmed its emergency stop, and another device is "
        "connected now. Cut that arm's power if it moves."
    ),
    EventCode.STOP_UNDONE: (
        "The emergency stop was undone, and not by this program: another host has resumed the "
        "arm, or it was switched off and on. Press the emergency stop again if it must stay."
    ),
    EventCode.HALT_SENT: "Halt sent: the motion ends, the motors keep their power.",
    EventCode.HALT_NOT_OUT: (
        "The halt is NOT on the bus yet: the adapter does not take it. It goes out as soon as that "
        "is possible. Press the emergency stop if the arm moves."
    ),
    EventCode.HALT_AT_REST: "The arm stands still and holds.",
    EventCode.STOP_CONFIRMED: "The arm has confirmed the emergency stop.",
    EventCode.STOP_UNCONFIRMED: (
        "The arm has NOT confirmed the emergency stop; it is sent again and again. Cut the arm's "
        "power if it moves."
    ),
    EventCode.RESUME_SENT: "Resume sent. The motors lose power and the arm drops: hold the arm.",
    EventCode.RESUMED: "The emergency stop is over. Enable the motors to go on.",
    EventCode.RESUME_FAILED: "The arm stays in emergency stop. Check it, then press Resume again.",
    EventCode.ENABLE_SENT: "Enable sent to all six motors",
    EventCode.ENABLED: "All six motors are enabled.",
    EventCode.ENABLE_FAILED: (
        "These joints did not enable: {joints}. Press Enable again; if that fails, check their "
        "drivers and the arm's power."
    ),
    EventCode.ENABLE_SENT_JOINT: "Enable sent to joint {joint}",
    EventCode.ENABLED_JOINT: "Joint {joint} is enabled.",
    EventCode.DISABLE_SENT_JOINT: "Disable sent to joint {joint}",
    EventCode.DISABLED_JOINT: "Joint {joint} is disabled.",
    EventCode.DISABLE_SENT: "Disable sent to all six motors. The arm drops: hold the arm.",
    EventCode.DISABLED: "All six motors are disabled.",
    EventCode.DISABLE_FAILED: (
        "These joints did not disable: {joints}. Press Disable again, or use the emergency stop."
    ),
    EventCode.CLEAR_ERROR_SENT: "Clear error sent to joint {joint}",
    EventCode.CLEAR_ERROR_ANSWERED: (
        "Joint {joint}: the arm has confirmed the command to clear the error. Where a fault is "
        "still shown, remove its cause, then clear it again."
    ),
    EventCode.CLEAR_ERROR_UNANSWERED: (
        "Joint {joint}: the arm did not confirm within a second the command to clear the error. "
        "Try again; if it stays silent, check the CAN cable."
    ),
    EventCode.MOUNTING_SENT: "Mounting sent: {mounting}. The arm does not report it back.",
    EventCode.LOAD_SENT: "End load sent: {load}",
    EventCode.LOAD_ANSWERED: (
        "The arm has answered the end load: {load}. It cannot be asked for it."
    ),
    EventCode.LOAD_FAILED: "End load not confirmed. {reason}",
    EventCode.END_FEEDBACK_SENT: "Switching the feedback of the end's motion",
    EventCode.END_FEEDBACK_ON: "The arm reports the motion of its end.",
    EventCode.END_FEEDBACK_OFF: "The arm no longer reports the motion of its end.",
    EventCode.END_FEEDBACK_FAILED: "The feedback of the end's motion is not switched. {reason}",
    EventCode.LINKAGE_SENT: "Linkage setting sent",
    EventCode.LINKAGE_ANSWERED: (
        "The arm has acknowledged the linkage setting. It takes effect in standby, or after a "
        "power cycle."
    ),
    EventCode.LINKAGE_ANSWERED_INPUT: (
        "The arm has answered: it becomes a teaching input. Its feedback ends and it can be led "
        "by hand."
    ),
    EventCode.LINKAGE_FAILED: "Linkage setting not confirmed. {reason}",
    EventCode.LINKAGE_IN_USE: (
        "Identifiers in use: feedback from {feedback}, commands from {control}."
    ),
    EventCode.LINKAGE_FOUND: (
        "An arm is heard with its feedback from {feedback}. On which identifiers it takes commands "
        "is not known: set them under Linkage control."
    ),
    EventCode.GRIPPER_SENT: "Gripper: sent to {value} {unit}",
    EventCode.GRIPPER_THERE: "The gripper is at {value} {unit}.",
    EventCode.GRIPPER_GRIPS: "The gripper holds something at {value} {unit}, with {torque} N·m.",
    EventCode.GRIPPER_NOT_THERE: (
        "The gripper stopped at {value} {unit} instead of {target} {unit}. Check what blocks "
        "it, its errors and its power."
    ),
    EventCode.GRIPPER_ACT_SENT: "Gripper: {act} sent",
    EventCode.GRIPPER_ACT_DONE: "Gripper: {act} done, by its own feedback.",
    EventCode.GRIPPER_ACT_FAILED: (
        "Gripper: {act} has had no effect. Check its errors, its power and its cable, then try "
        "again."
    ),
    EventCode.ZERO_SENT: "Zero setting sent to all six joints",
    EventCode.ZERO_SENT_JOINT: "Zero setting sent to joint {joint}",
    EventCode.ZERO_SET: "The arm has set the zeros of all six joints; their angles now read 0.",
    EventCode.ZERO_SET_JOINT: "The arm has set the zero of joint {joint}; its angle now reads 0.",
    EventCode.ZERO_FAILED: "Zero setting failed. {reason}",
    EventCode.SETTINGS_SENT: "Settings sent to the arm: {count}",
    EventCode.SETTINGS_SAVED: "Settings saved and read back unchanged: {count}",
    EventCode.SETTINGS_REFUSED: "{count} of {total} settings did not take effect. {reason}",
    EventCode.SETTINGS_RESET_SENT: "Restoring the factory values",
    EventCode.SETTINGS_RESET: ("The arm has confirmed its factory values; they are read again."),
    EventCode.SETTINGS_RESET_FAILED: ("The arm has not confirmed its factory values. {reason}"),
    EventCode.RUN_STARTED: "Running “{name}”",
    EventCode.RUN_PAUSED: "Run paused in row {row}: the arm holds",
    EventCode.RUN_CONTINUED: "Run continues in row {row}",
    EventCode.RUN_DONE: "“{name}” has finished.",
    EventCode.RUN_ENDED: "Run ended in row {row}; the arm is at rest.",
    EventCode.RUN_FAILED: "Run ended in row {row}. {reason}",
    EventCode.TEACHING_SENT: "Sent: {command}",
    EventCode.TEACHING_DONE: "The arm has confirmed: {command}",
    EventCode.TEACHING_UNANSWERED: (
        "The arm did not follow within 1.5 s: {command}. Look at its status; if it has no "
        "recording, record first."
    ),
    EventCode.PLAN_SENT: "Sent: {plan}. The arm does not report this; watch it.",
    EventCode.STANDBY_SENT: "Standby sent",
    EventCode.MOTION_OUTPUT_SENT: "Sent: motion output (0xFC)",
    EventCode.STEP_IN_VAIN: "The arm did not react. Look at the step above the panel.",
    EventCode.REPLAY_PAUSED: "Replay paused: the arm holds",
    EventCode.REPLAY_CONTINUED: "Replay continues",
    EventCode.REPLAY_ENDED: "Replay of “{name}” ended; the arm is at rest.",
    EventCode.REPLAY_FAILED: "Replay ended. {reason}",
    EventCode.RECORDING_STARTED: "Recording the arm's motion",
    EventCode.RECORDING_ENDED: "Recorded: {count} samples over {seconds} s",
    EventCode.SESSION_STARTED: "Recording the session: {name}",
    EventCode.SESSION_ENDED: "Session recorded: {name}, {frames} frames, {size} MB",
    EventCode.SESSION_FAILED: "Recording the session has ended: {reason}",
    EventCode.SESSION_FRAMES_LOST: (
        "{count} frames are missing in the recording: the disk is too slow"
    ),
    EventCode.MF4_SAVED: "Also saved as MF4: {name}.mf4",
    EventCode.MF4_NOT_SAVED: "No .mf4 file of {name}: {reason} The recording is whole as .blf.",
    EventCode.RING_SAVED: "What just happened is saved: {name}",
    EventCode.RING_NOT_SAVED: "What just happened could not be saved: {reason}",
    EventCode.CONNECTED: "Device open: {device}",
    EventCode.CONNECT_FAILED: "Not connected. {reason}",
    EventCode.DISCONNECTED: "Disconnected from {device}",
    EventCode.LINK_LOST: (
        "Connection to {device} lost; the program keeps trying to reconnect. {reason}"
    ),
    EventCode.RECONNECTED: "Connected to {device} again",
    EventCode.BUS_BLOCKED: "{device} sends nothing. {reason}",
    EventCode.BUS_UNBLOCKED: "{device} sends again. What had waited was dropped, but for a stop.",
    EventCode.ONLINE: "The arm is online.",
    EventCode.OFFLINE: (
        "The arm is offline: nothing is heard from it. Check its power, the CAN cable and the bit "
        "rate."
    ),
    EventCode.GENERATION: "The arm speaks protocol generation {generation}. Firmware: {firmware}",
    EventCode.LIMITS_READ: "Joint limits read from the arm",
    EventCode.LIMITS_MISSING: (
        "The arm did not tell the limits of these joints: {joints}. The factory limits hold; "
        "connect again to ask once more."
    ),
    EventCode.LIMITS_CORRUPT: (
        "Joint {joint}: the limits stored in the arm cannot be true. The factory limits hold; set "
        "the joint's limits anew."
    ),
    EventCode.PART_FAILED: (
        "A part of the program has failed ({part}). The emergency stop still works; every motion "
        "of this program is ended. Start the program again."
    ),
    EventCode.SETTINGS_SHARED: (
        "Another armui on this computer uses the same settings file. What is changed here is kept; "
        "changes made there appear at the next start."
    ),
    EventCode.CHANNEL_SHARED: (
        "Another armui on this computer is connected to {device}, too. Both can move the arm: "
        "close one of them."
    ),
    EventCode.NOBODY_MET: (
        "armui cannot tell whether another copy runs on this computer: {path} cannot be used "
        "({text}). Do not start the program twice for one arm."
    ),
    EventCode.FILES_HANG: (
        "A disk or network folder has spent more than 10 s on one file. Other files no longer "
        "wait for it. If it does not finish, check the cable or network. (Under way: {count})"
    ),
    EventCode.SETTINGS_UNSAVED: "The change is in effect, but not saved. {reason}",
    EventCode.REFUSED: "Not sent. {reason}",
    EventCode.QUESTION_WITHDRAWN: "“{question}” was withdrawn. {reason}",
    EventCode.MODEL_OTHER: (
        "Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a "
        "{fits}."
    ),
    EventCode.MODEL_NONE: (
        "The pose the arm reports fits its angles in no model of the family, {chosen} included."
    ),
    EventCode.MODEL_RECALLED: (
        "Last time this arm (node {node}) was a {before}: that is used instead of {chosen}, "
        "which was only the default."
    ),
    EventCode.MODEL_WAS_OTHER: (
        "Connected as a {chosen}, but last time this arm (node {node}) was a {before}. If it "
        "is one, connect it as that."
    ),
}

CODES: Final = frozenset(_NOTICES)
"""The notices there is a sentence for."""


def event(event: Event) -> str:
    """What happened in the operator's language, without its time."""
    return event_text(event.code, event.params)


def event_text(code: str, figures: Mapping[str, object]) -> str:
    """The same of a notice's code and figures."""
    params = dict(figures)
    reason = params.get("reason")
    params["reason"] = refusal(reason) if isinstance(reason, Refusal) else ""
    if not params.get("firmware"):
        params.pop("firmware", None)  # generation 1 has none
    if isinstance(device := params.get("device"), Device):
        params["device"] = device_name(device)
    if isinstance(command := params.get("command"), int):
        params["command"] = teaching_command(TeachingState(command))
    if isinstance(plan := params.get("plan"), int):
        params["plan"] = trajectory_command(TrajectoryCommand(plan))
    if isinstance(act := params.get("act"), str):
        params["act"] = gripper_act(act)
    if isinstance(load := params.get("load"), int):
        params["load"] = end_load(EndLoad(load))
    if isinstance(how := params.get("mounting"), int):
        params["mounting"] = mounting(Mounting(how))
    if code in _NOTICES:
        return _NOTICES.text(code, params).rstrip()
    unknown = QT_TRANSLATE_NOOP("Notice", "Event: {code}")
    return sentence("Notice", unknown, {**params, "code": code}).rstrip()
