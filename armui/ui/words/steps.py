"""The steps of recovery in the operator's language: sentence, button, danger."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal import Refusal
from armui.control.safety.recovery_steps import ARM_FAULTS, Action, Step
from armui.ui.words.arm import held_target
from armui.ui.words.motion import uncommanded_motion, uncommanded_motion_short, what_to_do
from armui.ui.words.refusals import in_words, refusal
from armui.ui.words.text import Text, joined, said, sentence

_STREAM: Final = Text("RecoveryStep", "{frames}, {rate} frames/s")
_BRIEFLY: Final = Text("RecoveryStep", "{does}. {text}")
_LOCKED: Final = Text("RecoveryStep", "Motion is locked: {obstacle}")
"""The text before a fault that locks motion."""


def step(this: Step) -> str:
    """Return the obstacle and the remedy, preceded by what the arm does and the last attempt."""
    return step_texts(this)[0]


def step_texts(this: Step) -> tuple[str, ...]:
    """Return the same in full and in shorter versions; each describes the arm's motion."""
    text, *shorter = _obstacle(this)
    if this.motion is None or not (moves := uncommanded_motion(this.motion)):
        return text, *shorter
    short = uncommanded_motion_short(this.motion)
    briefly = (_BRIEFLY.text().format(does=short, text=each) for each in (text, *shorter))
    return joined(moves, text), *briefly, moves, what_to_do(this.motion)


def _obstacle(this: Step) -> tuple[str, ...]:
    """Return the obstacle and the remedy, in full and shorter, after the last attempt's result."""
    params: dict[str, object] = dict(this.params)
    if isinstance(code := params.get("status"), int):
        params["status"] = f"0x{code:02X}"
    params = in_words(params)
    if params.get("rate"):  # there is no rate for single frames, or for frames of many kinds
        params["frames"] = _STREAM.text().format(**params)
    if "target" in params:
        params["target"] = held_target(params["target"])
    if isinstance(reason := params.get("reason"), Refusal):
        params["reason"] = refusal(reason)
    told = this.kind.value
    source = told.source if this.joints else told.somewhere or told.source
    text, *shorter = (
        sentence(told.context, each, params) for each in (source, told.shorter) if each
    )
    if this.locked and this.kind in ARM_FAULTS:
        text = _LOCKED.text().format(obstacle=text)
    return text if this.failed is None else joined(refusal(this.failed), text), *shorter


def step_action(action: Action) -> str:
    """Return the text of a step's button."""
    return said(action.value, {})


def step_question(action: Action) -> str:
    """Return the title of the question before a dangerous action."""
    return sentence(action.value.context, action.value.question, {})


def step_danger(action: Action) -> str:
    """Return the physical effect of a dangerous action, shown before it."""
    return sentence(action.value.context, action.value.danger, {})
