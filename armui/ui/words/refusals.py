"""Every reason against an action as a sentence: what, its value and limit, and the remedy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal import Refusal
from armui.ui.words import status
from armui.ui.words.backup_refusals import BACKUP_REFUSALS
from armui.ui.words.gripper import gripper_figure
from armui.ui.words.motor_refusals import MOTOR_REFUSALS
from armui.ui.words.other_hosts import OTHER_HOST_REFUSALS, other_mode
from armui.ui.words.robot_refusals import ROBOT_REFUSALS
from armui.ui.words.run_refusals import RUN_REFUSALS
from armui.ui.words.setting_refusals import SETTING_REFUSALS, with_units
from armui.ui.words.text import NOT_KNOWN, sentence
from armui.ui.words.trajectory_refusals import TRAJECTORY_REFUSALS, with_figures

_REFUSALS: Final[Mapping[str, object]] = {
    "not_connected": QT_TRANSLATE_NOOP(
        "Refusal",
        "No arm is connected. Click the button at the top left, choose a device and connect it.",
    ),
    "offline": QT_TRANSLATE_NOOP(
        "Refusal",
        "The device is open, but nothing is heard from the arm. Check its power, the CAN cable "
        "and the bit rate.",
    ),
    "link_lost": QT_TRANSLATE_NOOP(
        "Refusal",
        "The CAN device is gone. Plug it in again: the program reconnects by itself.",
    ),
    "stopped": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is in emergency stop. Hold the arm, press Resume, then enable the motors.",
    ),
    "halt_listen_only": QT_TRANSLATE_NOOP(
        "Refusal",
        "This connection only listens: nothing is sent on it but the emergency stop.",
    ),
    "stop_requested": QT_TRANSLATE_NOOP(
        "Refusal",
        "The emergency stop has been sent and the arm has not confirmed it yet. Wait for the "
        "confirmation.",
    ),
    "not_stopped": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is not in emergency stop: there is nothing to resume from.",
    ),
    "busy": QT_TRANSLATE_NOOP("Refusal", "Still under way: {what}. Wait until it is done."),
    "step_gone": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is in another state by now: nothing was sent. Look at the step that is shown now.",
    ),
    "step_in_vain": QT_TRANSLATE_NOOP("Refusal", "The arm did not react."),
    "teaching_off": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is not in drag teaching. Start recording first, or press the button on the arm.",
    ),
    "teaching_idle": QT_TRANSLATE_NOOP(
        "Refusal",
        "Nothing is under way in drag teaching. Start recording or replay first.",
    ),
    "teaching_recording": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is recording. Stop recording first.",
    ),
    "teaching_replaying": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is replaying. Pause or terminate the replay first.",
    ),
    "teaching_paused": QT_TRANSLATE_NOOP(
        "Refusal",
        "The replay is paused. Continue or terminate it first.",
    ),
    "not_moving": QT_TRANSLATE_NOOP("Refusal", "The arm is not moving: there is nothing to pause."),
    "not_enabled": QT_TRANSLATE_NOOP(
        "Refusal",
        "The motors of these joints are not enabled: {joints}. Press Enable first.",
    ),
    "enabled_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "Not every motor has reported yet whether it is enabled. Wait a moment; if it stays so, "
        "check the arm's power and the CAN cable.",
    ),
    "speed_zero": QT_TRANSLATE_NOOP(
        "Refusal",
        "The speed is set to 0 %: the arm would not move. Set a speed from 1 to 100 % at the top.",
    ),
    "speed_out_of_range": QT_TRANSLATE_NOOP(
        "Refusal",
        "Speed {value} % is out of range. Enter a value from 0 to 100 %.",
    ),
    "joint_out_of_limits": QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint}: {value}° is beyond its limits of {minimum}° to {maximum}°. Enter an angle "
        "within them.",
    ),
    "joint_not_a_number": QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint}: “{value}” is not an angle. Enter degrees in figures, for example 12.5.",
    ),
    "still_moving": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is still moving. Wait until it stands still, then press again.",
    ),
    "jog_at_limit": QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint} is at its limit of {limit}°. Jog the other way.",
    ),
    "jog_out_of_reach": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm reaches no further this way. Jog in another direction.",
    ),
    "jog_singular": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is at a singular pose: joint {joint} would have to turn far too fast. Jog "
        "another way, or turn joint 5 away from 0° under Motion control.",
    ),
    "jog_not_following": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm does not follow. Check that nothing blocks it and what its status says.",
    ),
    "jog_no_feedback": QT_TRANSLATE_NOOP(
        "Refusal",
        "The joint angles are no longer heard from the arm. Check its power and the CAN cable.",
    ),
    "jog_held_up": QT_TRANSLATE_NOOP(
        "Refusal",
        "The program was held up for {value} ms. Let go and press again.",
    ),
    "pose_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm has not reported its pose yet. Wait until all six values are shown.",
    ),
    "target_refused": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm itself refuses its last target: {status}. Send another one.",
    ),
    "pose_not_a_number": QT_TRANSLATE_NOOP(
        "Refusal",
        "{axis}: “{value}” is no figure. Enter mm or degrees in figures, for example 12.5.",
    ),
    "pose_out_of_reach": QT_TRANSLATE_NOOP(
        "Refusal",
        "The target is {missing} mm out of the arm's reach. Choose one nearer to the arm, or "
        "turn the tool.",
    ),
    "pose_beyond_limits": QT_TRANSLATE_NOOP(
        "Refusal",
        "At the target joint {joint} would stand at {value}°, beyond its limits of {minimum}° to "
        "{maximum}°. Choose another position or turn the tool.",
    ),
    "path_out_of_reach": QT_TRANSLATE_NOOP(
        "Refusal",
        "After {gone} % of the way the arm reaches no further. Choose MOVE P, or another target.",
    ),
    "path_beyond_limits": QT_TRANSLATE_NOOP(
        "Refusal",
        "After {gone} % of the way joint {joint} would be at {value}°, beyond its limits of "
        "{minimum}° to {maximum}°. Choose MOVE P, or another target.",
    ),
    "path_singular": QT_TRANSLATE_NOOP(
        "Refusal",
        "After {gone} % of the way the arm comes to a singular pose: joint {joint} would have to "
        "jump. Choose MOVE P, or move joint 5 away from 0° first.",
    ),
    "arc_not_at_start": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm stands {distance} mm and {turned}° away from the start of the arc. Press Go to "
        "start first.",
    ),
    "arc_is_none": QT_TRANSLATE_NOOP(
        "Refusal",
        "The three poses lie on a line, or two in one place: that is no arc. Capture others.",
    ),
    "arc_incomplete": QT_TRANSLATE_NOOP(
        "Refusal",
        "Not captured yet: {point}. Bring the arm there and press its button.",
    ),
    "model_differs": QT_TRANSLATE_NOOP(
        "Refusal",
        "The pose the arm reports does not fit its joint angles: the program cannot compute its "
        "way. Check the joints' zeros; the joints can still be moved one by one.",
    ),
    "tool_not_possible": QT_TRANSLATE_NOOP(
        "Refusal",
        "Tool centre point: {value} is not possible. Enter lengths up to {maximum} mm and angles "
        "up to 180°.",
    ),
    "light_out_of_range": QT_TRANSLATE_NOOP(
        "Refusal",
        "{light}: {value} is out of range. Enter a whole number from {minimum} to {maximum}.",
    ),
    "light_not_a_number": QT_TRANSLATE_NOOP(
        "Refusal",
        "{light}: “{value}” is not a whole number. Enter one from {minimum} to {maximum}.",
    ),
    "joints_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm has not reported all of its joint angles yet. Wait until all six are shown.",
    ),
    "other_control": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm takes its commands from elsewhere: {mode}. Leave that mode first.",
    ),
    "arm_fault": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm reports: {status}. Remove the cause. If the report stays: emergency stop, hold "
        "the arm, Resume.",
    ),
    "bus_gone": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} is not there. Check that it is plugged in and its cable is sound.",
    ),
    "bus_busy": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} is in use by another program. Close that program, then connect again.",
    ),
    "bus_down": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} is switched off in the system. Switch it on in a terminal (with your "
        "interface's name for can0): sudo ip link set can0 up type can bitrate 1000000",
    ),
    "bus_permission": QT_TRANSLATE_NOOP(
        "Refusal",
        "You may not open {device}. On Linux add your account to the group dialout (serial "
        "adapters) or install the adapter's udev rule (USB adapters), then log in again.",
    ),
    "bus_off": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} is bus off: too many errors on the CAN bus, so its controller takes no part any "
        "more. Check CAN_H and CAN_L, both terminating resistors (120 Ω) and the bit rate, then "
        "disconnect and connect again; on socketcan run «sudo ip link set {channel} type can "
        "restart» before.",
    ),
    "bus_unacknowledged": QT_TRANSLATE_NOOP(
        "Refusal",
        "For half a second {device} could send nothing, because nobody on the bus acknowledges. "
        "Check the arm's power, the CAN cable, the terminating resistors and the bit rate "
        "(1 Mbit/s).",
    ),
    "bus_send_blocked": QT_TRANSLATE_NOOP(
        "Refusal",
        "For half a second {device} has taken no frame to send, though frames are heard. "
        "Unplug the adapter and plug it in again; if that does not help, check its driver.",
    ),
    "bus_backend_missing": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} needs a Python package that is not installed. Install it in a terminal: "
        "pip install {package}",
    ),
    "bus_driver_missing": QT_TRANSLATE_NOOP(
        "Refusal",
        "The driver for {device} ({interface}) is missing. Install the driver of the adapter's "
        "maker; for socketcan load the kernel's modules: sudo modprobe can_raw",
    ),
    "bus_bad_argument": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} does not accept these settings: {text}. Check interface, channel and bit rate.",
    ),
    "bus_failed": QT_TRANSLATE_NOOP(
        "Refusal",
        "{device} could not be opened: {text}. Check the device and its driver, then connect "
        "again.",
    ),
    "settings_broken": QT_TRANSLATE_NOOP(
        "Refusal",
        "The settings file could not be read and was put aside as {kept}. The program starts with "
        "its first settings.",
    ),
    "settings_unreadable": QT_TRANSLATE_NOOP(
        "Refusal",
        "The settings file {path} could not be read: {text}. The program starts with its first "
        "settings.",
    ),
    "settings_not_saved": QT_TRANSLATE_NOOP(
        "Refusal",
        "The settings could not be saved in {path}: {text}. They hold until the program ends.",
    ),
    "settings_in_use": QT_TRANSLATE_NOOP(
        "Refusal",
        "Another program is writing the settings file {path}. The settings hold until this program "
        "ends; change them once more to save them.",
    ),
    "setting_bad": QT_TRANSLATE_NOOP(
        "Refusal",
        "Setting “{field}”: “{value}” is not possible. Its first setting is used instead.",
    ),
    "jog_step_out_of_range": QT_TRANSLATE_NOOP(
        "Refusal",
        "Jog step {value}° is out of range. Enter a value from {minimum}° to {maximum}°.",
    ),
    "jog_step_not_a_number": QT_TRANSLATE_NOOP(
        "Refusal",
        "Jog step: “{value}” is not an angle. Enter degrees in figures, for example 0.5.",
    ),
}

_ALL: Final[Mapping[str, object]] = {
    **_REFUSALS,
    **SETTING_REFUSALS,
    **BACKUP_REFUSALS,
    **ROBOT_REFUSALS,
    **RUN_REFUSALS,
    **OTHER_HOST_REFUSALS,
    **MOTOR_REFUSALS,
    **TRAJECTORY_REFUSALS,
}

_UNDER_WAY: Final[Mapping[str, object]] = {
    "enabling": QT_TRANSLATE_NOOP("UnderWay", "enabling the motors"),
    "disabling": QT_TRANSLATE_NOOP("UnderWay", "disabling the motors"),
    "resuming": QT_TRANSLATE_NOOP("UnderWay", "resuming after the emergency stop"),
    "recording": QT_TRANSLATE_NOOP("UnderWay", "recording"),
    "settings": QT_TRANSLATE_NOOP("UnderWay", "reading or saving the arm's settings"),
    "end_reports": QT_TRANSLATE_NOOP("UnderWay", "the setting before"),
    "linkage": QT_TRANSLATE_NOOP("UnderWay", "setting the linkage"),
    "zeroing": QT_TRANSLATE_NOOP("UnderWay", "setting a zero"),
    "clearing_error": QT_TRANSLATE_NOOP("UnderWay", "clearing a joint's error"),
    "teaching": QT_TRANSLATE_NOOP("UnderWay", "a teaching command"),
    "recovery": QT_TRANSLATE_NOOP("UnderWay", "the step before"),
}

_SETTINGS: Final[Mapping[str, object]] = {
    "language": QT_TRANSLATE_NOOP("SettingName", "language"),
    "theme": QT_TRANSLATE_NOOP("SettingName", "theme"),
    "jog_step_deg": QT_TRANSLATE_NOOP("SettingName", "jog step"),
    "urdf_path": QT_TRANSLATE_NOOP("SettingName", "robot description"),
    "tool": QT_TRANSLATE_NOOP("SettingName", "tool centre point"),
}

_LIGHTS: Final[Mapping[str, object]] = {
    "joint": QT_TRANSLATE_NOOP("LightFigure", "Joint number"),
    "lamp": QT_TRANSLATE_NOOP("LightFigure", "Lamp number"),
    "red": QT_TRANSLATE_NOOP("LightFigure", "R channel"),
    "green": QT_TRANSLATE_NOOP("LightFigure", "G channel"),
    "blue": QT_TRANSLATE_NOOP("LightFigure", "B channel"),
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
        params["field"] = sentence("SettingName", _SETTINGS.get(field, field), {})
    if isinstance(light := params.get("light"), str):
        params["light"] = light_figure(light)
    if isinstance(figure := params.get("gripper"), str):
        params["gripper"] = gripper_figure(figure)
    source = _ALL.get(reason.code)
    if source is None:
        return _unexpected(reason)
    return sentence("Refusal", source, params)


def why_not(reason: Refusal | None) -> str:
    """The same, or nothing where nothing stands in the way."""
    return "" if reason is None else refusal(reason)


def under_way(what: str) -> str:
    """What the program is waiting for the arm to do."""
    return sentence("UnderWay", _UNDER_WAY.get(what, what), {})


def light_figure(name: str) -> str:
    """What a figure of the light command is called: a key of ``lights.RANGES``."""
    return sentence("LightFigure", _LIGHTS.get(name, name), {})


def _unexpected(reason: Refusal) -> str:
    """What to say to a code this program has no sentence for: an adapter of others may add one."""
    source = QT_TRANSLATE_NOOP("Refusal", "Not possible now: {reason}.")
    return sentence("Refusal", source, {"reason": str(reason) or NOT_KNOWN})
