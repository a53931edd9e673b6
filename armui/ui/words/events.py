"""Events as sentences, for the left half of the status bar."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.device import Device
from armui.arm.refusal import Refusal
from armui.control.devices.gripper import CALIBRATED_MM
from armui.control.events import Event, Notice
from armui.protocol.codes import EndLoad, Mounting, TeachingState, TrajectoryCommand
from armui.ui.words.arm import (
    ARM_PARTS,
    END_LOADS,
    GRIPPER_ACTS,
    MOUNTINGS,
    TEACHING_COMMANDS,
    TRAJECTORY_COMMANDS,
    calibrated_mm,
    device_name,
    operation_title,
)
from armui.ui.words.motion import what_is_below
from armui.ui.words.parameters import setting_names
from armui.ui.words.refusals import refusal
from armui.ui.words.text import sentence, source_of

_NAMES: Final = {
    "act": GRIPPER_ACTS.word,
    "operation": operation_title,
    "part": ARM_PARTS.word,
    "below": what_is_below,
    "settings": setting_names,
}
_UNKNOWN: Final = QT_TRANSLATE_NOOP("Notice", "Event: {code}")


def event(event: Event) -> str:
    """Return the sentence of an event in the operator's language, without its time."""
    return notice_text(event.notice, event.params)


def notice_text(notice: Notice, figures: Mapping[str, object]) -> str:
    """Return the sentence of a notice with its figures."""
    params = {"settings": figures.get("count"), **figures}  # older files have only a count
    reason = params.get("reason")
    params["reason"] = refusal(reason) if isinstance(reason, Refusal) else ""
    if not params.get("firmware"):
        params.pop("firmware", None)  # generation 1 has none
    if isinstance(device := params.get("device"), Device):
        params["device"] = device_name(device)
    if isinstance(command := params.get("command"), int):
        params["command"] = TEACHING_COMMANDS.text(TeachingState(command))
    if isinstance(plan := params.get("plan"), int):
        params["plan"] = TRAJECTORY_COMMANDS.text(TrajectoryCommand(plan))
    if params.get("unit") == CALIBRATED_MM:
        params["unit"] = calibrated_mm()
    if isinstance(load := params.get("load"), int):
        params["load"] = END_LOADS.text(EndLoad(load))
    if isinstance(how := params.get("mounting"), int):
        params["mounting"] = MOUNTINGS.text(Mounting(how))
    for name, in_words in _NAMES.items():
        if isinstance(value := params.get(name), str):
            params[name] = in_words(value)
    params["code"] = notice.id
    return sentence(Notice.context, source_of(notice) or _UNKNOWN, params).rstrip()
