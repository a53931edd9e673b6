"""Everything that happens as a sentence, for the left half of the status bar."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.device import Device
from armui.arm.refusal import Refusal
from armui.control.operating_state import Notice
from armui.protocol.codes import EndLoad, TeachingState, TrajectoryCommand
from armui.ui.words.devices import device_name
from armui.ui.words.gripper import end_load, gripper_act
from armui.ui.words.refusals import refusal
from armui.ui.words.teaching import teaching_command, trajectory_command
from armui.ui.words.text import sentence

_NOTICES: Final[Mapping[str, object]] = {
    "sent_joints": QT_TRANSLATE_NOOP(
        "Notice", "Sent J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°"
    ),
    "jogged": QT_TRANSLATE_NOOP("Notice", "Sent J{joint} {target}°"),
    "went_home": QT_TRANSLATE_NOOP("Notice", "Home sent: all joints to 0°"),
    "jogging_joint": QT_TRANSLATE_NOOP("Notice", "Jogging J{joint} {sign}"),
    "jogging_tool": QT_TRANSLATE_NOOP("Notice", "Jogging {axis} {sign}"),
    "jog_ended": QT_TRANSLATE_NOOP("Notice", "Jogging ended. {reason}"),
    "sent_pose": QT_TRANSLATE_NOOP(
        "Notice", "Sent MOVE P to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°"
    ),
    "sent_line": QT_TRANSLATE_NOOP(
        "Notice", "Sent MOVE L to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°"
    ),
    "sent_arc": QT_TRANSLATE_NOOP("Notice", "Sent MOVE C through the three captured poses"),
    "stepped_tool": QT_TRANSLATE_NOOP("Notice", "Sent a step of {step} along {axis}"),
    "sent_speed": QT_TRANSLATE_NOOP("Notice", "Sent speed {percent} %"),
    "speed_waits": QT_TRANSLATE_NOOP(
        "Notice", "{percent} % is kept: the arm gets it when the motion held back goes on"
    ),
    "other_host_moves": QT_TRANSLATE_NOOP("Notice", "Another program controls the arm ({frames})."),
    "leader_arm_moves": QT_TRANSLATE_NOOP("Notice", "A leader arm moves this arm ({frames})."),
    "other_host_gone": QT_TRANSLATE_NOOP("Notice", "Nobody else controls the arm any more."),
    "taken_over": QT_TRANSLATE_NOOP("Notice", "Taken over: this program may move the arm."),
    "cancel_unheeded": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm was told to end its motion and still moves. Stop it, or cut its power.",
    ),
    "motion_too_fast": QT_TRANSLATE_NOOP("Notice", "Motion ended: too fast. {reason}"),
    "frames_dropped": QT_TRANSLATE_NOOP(
        "Notice",
        "{count} frames were lost before the program could read them ({total} since connecting): "
        "the computer is too busy, or the adapter too slow.",
    ),
    "sent_lamp": QT_TRANSLATE_NOOP("Notice", "Sent to lamp {lamp} of joint {joint}: {color}"),
    "sent_lamps": QT_TRANSLATE_NOOP("Notice", "Sent to all lamps of joint {joint}: {color}"),
    "stop_sent": QT_TRANSLATE_NOOP(
        "Notice", "Emergency stop sent. The motors go limp and the arm sinks: hold the arm."
    ),
    "stop_not_sent": QT_TRANSLATE_NOOP(
        "Notice",
        "The emergency stop is NOT on the bus: no CAN device is open, or it does not take the "
        "frame. Cut the arm's power if it moves.",
    ),
    "stop_reaches_other": QT_TRANSLATE_NOOP(
        "Notice",
        "A second arm is heard on this bus (feedback at {feedback}): the stop reaches it, too.",
    ),
    "stop_lapsed": QT_TRANSLATE_NOOP(
        "Notice",
        "A stop is outstanding: the arm was away for more than 10 seconds and has not confirmed "
        "it. It is not sent by itself any more. Press the emergency stop if the arm must stop.",
    ),
    "stop_withdrawn": QT_TRANSLATE_NOOP(
        "Notice", "The outstanding emergency stop was withdrawn; the arm has not stopped."
    ),
    "stop_abandoned": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm on {device} has never confirmed its emergency stop, and another device is "
        "connected now. Cut that arm's power if it moves.",
    ),
    "stop_undone": QT_TRANSLATE_NOOP(
        "Notice",
        "The emergency stop was undone, and not by this program: another host has resumed the "
        "arm, or it was switched off and on. Press the emergency stop again if it must stay.",
    ),
    "halt_sent": QT_TRANSLATE_NOOP(
        "Notice", "Halt sent: the motion ends, the motors keep their power."
    ),
    "halt_not_out": QT_TRANSLATE_NOOP(
        "Notice",
        "The halt is NOT on the bus yet: the adapter does not take it. It goes out as soon as that "
        "is possible. Press the emergency stop if the arm moves.",
    ),
    "halt_at_rest": QT_TRANSLATE_NOOP("Notice", "The arm stands still and holds."),
    "stop_confirmed": QT_TRANSLATE_NOOP("Notice", "The arm has confirmed the emergency stop."),
    "stop_unconfirmed": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm has NOT confirmed the emergency stop; it is sent again and again. Cut the arm's "
        "power if it moves.",
    ),
    "resume_sent": QT_TRANSLATE_NOOP(
        "Notice", "Resume sent. The motors lose power and the arm drops: hold the arm."
    ),
    "resumed": QT_TRANSLATE_NOOP(
        "Notice", "The emergency stop is over. Enable the motors to go on."
    ),
    "resume_failed": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm stays in emergency stop. Check it, then press Resume again.",
    ),
    "enable_sent": QT_TRANSLATE_NOOP("Notice", "Enable sent to all six motors"),
    "enabled": QT_TRANSLATE_NOOP("Notice", "All six motors are enabled."),
    "enable_failed": QT_TRANSLATE_NOOP(
        "Notice",
        "These joints did not enable: {joints}. Press Enable again; if that fails, check their "
        "drivers and the arm's power.",
    ),
    "enable_sent_joint": QT_TRANSLATE_NOOP("Notice", "Enable sent to joint {joint}"),
    "enabled_joint": QT_TRANSLATE_NOOP("Notice", "Joint {joint} is enabled."),
    "disable_sent_joint": QT_TRANSLATE_NOOP("Notice", "Disable sent to joint {joint}"),
    "disabled_joint": QT_TRANSLATE_NOOP("Notice", "Joint {joint} is disabled."),
    "disable_sent": QT_TRANSLATE_NOOP(
        "Notice", "Disable sent to all six motors. The arm drops: hold the arm."
    ),
    "disabled": QT_TRANSLATE_NOOP("Notice", "All six motors are disabled."),
    "disable_failed": QT_TRANSLATE_NOOP(
        "Notice",
        "These joints did not disable: {joints}. Press Disable again, or use the emergency stop.",
    ),
    "clear_error_sent": QT_TRANSLATE_NOOP("Notice", "Clear error sent to joint {joint}"),
    "clear_error_answered": QT_TRANSLATE_NOOP(
        "Notice",
        "Joint {joint}: the arm has confirmed the command to clear the error. Where a fault is "
        "still shown, remove its cause, then clear it again.",
    ),
    "clear_error_unanswered": QT_TRANSLATE_NOOP(
        "Notice",
        "Joint {joint}: the arm did not confirm within a second the command to clear the error. "
        "Try again; if it stays silent, check the CAN cable.",
    ),
    "load_sent": QT_TRANSLATE_NOOP("Notice", "End load sent: {load}"),
    "load_answered": QT_TRANSLATE_NOOP(
        "Notice", "The arm has answered the end load: {load}. It cannot be asked for it."
    ),
    "load_failed": QT_TRANSLATE_NOOP("Notice", "End load not confirmed. {reason}"),
    "end_feedback_sent": QT_TRANSLATE_NOOP("Notice", "Switching the feedback of the end's motion"),
    "end_feedback_on": QT_TRANSLATE_NOOP("Notice", "The arm reports the motion of its end."),
    "end_feedback_off": QT_TRANSLATE_NOOP(
        "Notice", "The arm no longer reports the motion of its end."
    ),
    "end_feedback_failed": QT_TRANSLATE_NOOP(
        "Notice", "The feedback of the end's motion is not switched. {reason}"
    ),
    "linkage_sent": QT_TRANSLATE_NOOP("Notice", "Linkage setting sent"),
    "linkage_answered": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm has answered the linkage setting. It holds in standby, or after the arm was "
        "switched off and on.",
    ),
    "linkage_answered_input": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm has answered: it becomes a teaching input. Its feedback ends and it can be led "
        "by hand.",
    ),
    "linkage_failed": QT_TRANSLATE_NOOP("Notice", "Linkage setting not confirmed. {reason}"),
    "linkage_in_use": QT_TRANSLATE_NOOP(
        "Notice", "Identifiers in use: feedback from {feedback}, commands from {control}."
    ),
    "linkage_found": QT_TRANSLATE_NOOP(
        "Notice",
        "An arm is heard with its feedback from {feedback}. On which identifiers it takes commands "
        "is not known: set them under Linkage control.",
    ),
    "gripper_sent": QT_TRANSLATE_NOOP("Notice", "Gripper: sent to {value} {unit}"),
    "gripper_there": QT_TRANSLATE_NOOP("Notice", "The gripper is at {value} {unit}."),
    "gripper_grips": QT_TRANSLATE_NOOP(
        "Notice", "The gripper holds something at {value} {unit}, with {torque} N·m."
    ),
    "gripper_not_there": QT_TRANSLATE_NOOP(
        "Notice",
        "The gripper stands at {value} {unit} instead of {target} {unit}. Look for what blocks it, "
        "for its errors and its power.",
    ),
    "gripper_act_sent": QT_TRANSLATE_NOOP("Notice", "Gripper: {act} sent"),
    "gripper_act_done": QT_TRANSLATE_NOOP("Notice", "Gripper: {act} done, by its own feedback."),
    "gripper_act_failed": QT_TRANSLATE_NOOP(
        "Notice",
        "Gripper: {act} has no effect. Look at its errors, its power and its cable, then try "
        "again.",
    ),
    "zero_sent": QT_TRANSLATE_NOOP("Notice", "Zero setting sent to all six joints"),
    "zero_sent_joint": QT_TRANSLATE_NOOP("Notice", "Zero setting sent to joint {joint}"),
    "zero_set": QT_TRANSLATE_NOOP(
        "Notice", "The arm has set the zeros of all six joints; their angles now read 0."
    ),
    "zero_set_joint": QT_TRANSLATE_NOOP(
        "Notice", "The arm has set the zero of joint {joint}; its angle now reads 0."
    ),
    "zero_failed": QT_TRANSLATE_NOOP("Notice", "Zero setting failed. {reason}"),
    "settings_sent": QT_TRANSLATE_NOOP("Notice", "Settings sent to the arm: {count}"),
    "settings_saved": QT_TRANSLATE_NOOP(
        "Notice", "Settings saved, read back from the arm and the same: {count}"
    ),
    "settings_refused": QT_TRANSLATE_NOOP(
        "Notice", "{count} of {total} settings are not in the arm. {reason}"
    ),
    "settings_reset_sent": QT_TRANSLATE_NOOP("Notice", "Asked the arm for its factory values"),
    "settings_reset": QT_TRANSLATE_NOOP(
        "Notice", "The arm has answered that its factory values are back; they are read again."
    ),
    "run_started": QT_TRANSLATE_NOOP("Notice", "Running “{name}”"),
    "run_paused": QT_TRANSLATE_NOOP("Notice", "Run paused in row {row}: the arm holds"),
    "run_continued": QT_TRANSLATE_NOOP("Notice", "Run goes on in row {row}"),
    "run_done": QT_TRANSLATE_NOOP("Notice", "“{name}” has been run to its end."),
    "run_ended": QT_TRANSLATE_NOOP("Notice", "Run ended in row {row}; the arm stands."),
    "run_failed": QT_TRANSLATE_NOOP("Notice", "Run ended in row {row}. {reason}"),
    "teaching_sent": QT_TRANSLATE_NOOP("Notice", "Sent: {command}"),
    "teaching_done": QT_TRANSLATE_NOOP("Notice", "The arm has confirmed: {command}"),
    "teaching_unanswered": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm did not follow within 1.5 s: {command}. Look at its status; if it has no "
        "recording, record first.",
    ),
    "plan_sent": QT_TRANSLATE_NOOP(
        "Notice",
        "Sent: {plan}. The arm does not report this; watch it.",
    ),
    "standby_sent": QT_TRANSLATE_NOOP("Notice", "Standby sent"),
    "motion_output_sent": QT_TRANSLATE_NOOP("Notice", "Sent: motion output (0xFC)"),
    "step_in_vain": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm did not react. Look at the step above the panel.",
    ),
    "replay_paused": QT_TRANSLATE_NOOP("Notice", "Replay paused: the arm holds"),
    "replay_continued": QT_TRANSLATE_NOOP("Notice", "Replay goes on"),
    "replay_ended": QT_TRANSLATE_NOOP("Notice", "Replay of “{name}” ended; the arm stands."),
    "replay_failed": QT_TRANSLATE_NOOP("Notice", "Replay ended. {reason}"),
    "recording_started": QT_TRANSLATE_NOOP("Notice", "Recording the arm's motion"),
    "recording_ended": QT_TRANSLATE_NOOP("Notice", "Recorded: {count} samples over {seconds} s"),
    "connected": QT_TRANSLATE_NOOP("Notice", "Device open: {device}"),
    "connect_failed": QT_TRANSLATE_NOOP("Notice", "Not connected. {reason}"),
    "disconnected": QT_TRANSLATE_NOOP("Notice", "Disconnected from {device}"),
    "link_lost": QT_TRANSLATE_NOOP(
        "Notice",
        "Connection to {device} lost; the program keeps trying to reconnect. {reason}",
    ),
    "reconnected": QT_TRANSLATE_NOOP("Notice", "Connected to {device} again"),
    "bus_blocked": QT_TRANSLATE_NOOP("Notice", "{device} sends nothing. {reason}"),
    "bus_unblocked": QT_TRANSLATE_NOOP(
        "Notice", "{device} sends again. What had waited was dropped, but for a stop."
    ),
    "online": QT_TRANSLATE_NOOP("Notice", "The arm is online."),
    "offline": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm is offline: nothing is heard from it. Check its power, the CAN cable and the bit "
        "rate.",
    ),
    "generation": QT_TRANSLATE_NOOP(
        "Notice", "The arm speaks protocol generation {generation}. Firmware: {firmware}"
    ),
    "limits_read": QT_TRANSLATE_NOOP("Notice", "Joint limits read from the arm"),
    "limits_missing": QT_TRANSLATE_NOOP(
        "Notice",
        "The arm did not tell the limits of these joints: {joints}. The factory limits hold; "
        "connect again to ask once more.",
    ),
    "limits_corrupt": QT_TRANSLATE_NOOP(
        "Notice",
        "Joint {joint}: the limits stored in the arm cannot be true. The factory limits hold; set "
        "the joint's limits anew.",
    ),
    "part_failed": QT_TRANSLATE_NOOP(
        "Notice",
        "A part of the program has failed ({part}). The emergency stop still works; end what is "
        "under way and start the program again.",
    ),
    "settings_shared": QT_TRANSLATE_NOOP(
        "Notice",
        "Another armui on this computer uses the same settings file. What is changed here is kept; "
        "changes made there appear at the next start.",
    ),
    "channel_shared": QT_TRANSLATE_NOOP(
        "Notice",
        "Another armui on this computer is connected to {device}, too. Both can move the arm: "
        "close one of them.",
    ),
    "refused": QT_TRANSLATE_NOOP("Notice", "Not sent. {reason}"),
}

CODES: Final = frozenset(_NOTICES)
"""The notices there is a sentence for."""


def notice(event: Notice) -> str:
    """What happened in the operator's language, without its time."""
    params = dict(event.params)
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
    source = _NOTICES.get(event.code)
    if source is None:
        source = QT_TRANSLATE_NOOP("Notice", "Event: {code}")
        params["code"] = event.code
    return sentence("Notice", source, params).rstrip()
