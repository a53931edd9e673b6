"""The program's codes as words and sentences in the operator's language.

The texts are looked up at every call, so that a caller which asks again after a change of language
(``QEvent.LanguageChange``) gets the new one.
"""

from armui.ui.words.arm import (
    arm_kind,
    arm_status,
    control_mode,
    control_mode_short,
    device_name,
    disabling,
    figure,
    joint_item,
    joint_verdict,
    joint_word,
    mounting_check,
    move_mode,
    reached,
    teaching,
    teaching_now,
)
from armui.ui.words.events import event
from armui.ui.words.motion import (
    uncommanded_motion,
    uncommanded_motion_short,
    uncommanded_motion_word,
)
from armui.ui.words.refusals import file_error, point_figure, refusal, why_ended, why_not
from armui.ui.words.steps import step, step_action, step_danger, step_question, step_texts

__all__ = [
    "arm_kind",
    "arm_status",
    "control_mode",
    "control_mode_short",
    "device_name",
    "disabling",
    "event",
    "figure",
    "file_error",
    "joint_item",
    "joint_verdict",
    "joint_word",
    "mounting_check",
    "move_mode",
    "point_figure",
    "reached",
    "refusal",
    "step",
    "step_action",
    "step_danger",
    "step_question",
    "step_texts",
    "teaching",
    "teaching_now",
    "uncommanded_motion",
    "uncommanded_motion_short",
    "uncommanded_motion_word",
    "why_ended",
    "why_not",
]
