"""What the operator reads: the program's codes as words and sentences, in the language chosen.

The words are looked up at every call, so a caller that asks again after the language has changed
(``QEvent.LanguageChange``) shows the new one.
"""

from armui.ui.words.arm_kinds import arm_kind
from armui.ui.words.devices import device_name
from armui.ui.words.events import event
from armui.ui.words.file_errors import file_error
from armui.ui.words.gripper import end_load, gripper_act, gripper_fault, gripper_figure
from armui.ui.words.joints import joint_item, joint_verdict, joint_word
from armui.ui.words.lights import light_figure
from armui.ui.words.mounting import mounting
from armui.ui.words.other_hosts import other_mode
from armui.ui.words.refusals import refusal, why_not
from armui.ui.words.status import (
    arm_status,
    control_mode,
    control_mode_short,
    move_mode,
    reached,
    teaching,
)
from armui.ui.words.steps import step, step_action, step_danger, step_question
from armui.ui.words.teaching import teaching_command, teaching_phase, trajectory_command
from armui.ui.words.trajectory_refusals import point_figure

__all__ = [
    "arm_kind",
    "arm_status",
    "control_mode",
    "control_mode_short",
    "device_name",
    "end_load",
    "event",
    "file_error",
    "gripper_act",
    "gripper_fault",
    "gripper_figure",
    "joint_item",
    "joint_verdict",
    "joint_word",
    "light_figure",
    "mounting",
    "move_mode",
    "other_mode",
    "point_figure",
    "reached",
    "refusal",
    "step",
    "step_action",
    "step_danger",
    "step_question",
    "teaching",
    "teaching_command",
    "teaching_phase",
    "trajectory_command",
    "why_not",
]
