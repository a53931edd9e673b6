"""The steps of recovery in the operator's language: sentence, button, danger."""

from __future__ import annotations

from armui.control.safety.recovery_steps import Action, Step
from armui.ui.words import arm
from armui.ui.words.arm import held_target, other_mode
from armui.ui.words.motion import uncommanded_motion
from armui.ui.words.refusals import refusal, under_way
from armui.ui.words.text import said, sentence


def step(this: Step) -> str:
    """Return the obstacle and the remedy, preceded by what the arm does and the last attempt."""
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
    if isinstance(part := params.get("part"), str):
        params["part"] = arm.part_name(part)
    told = this.kind.value
    source = told.source if this.joints else told.somewhere or told.source
    text = sentence(told.context, source, params)
    failed = "" if this.failed is None else refusal(this.failed)
    moves = "" if this.motion is None else uncommanded_motion(this.motion)
    return " ".join(filter(None, (moves, failed, text)))


def step_action(action: Action) -> str:
    """Return the text of a step's button."""
    return said(action.value, {})


def step_question(action: Action) -> str:
    """Return the title of the question before a dangerous action."""
    return sentence(action.value.context, action.value.question, {})


def step_danger(action: Action) -> str:
    """Return the physical effect of a dangerous action, shown before it."""
    return sentence(action.value.context, action.value.danger, {})
