"""Every notice and refusal the program can give, with its figures.

The user interface has a sentence for each; a test compares the two.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.control.operating_state import Level

CODES: Final[Mapping[str, Level]] = {
    "sent_joints": Level.INFO,  # j1 … j6
    "jogged": Level.INFO,  # joint, target
    "went_home": Level.INFO,
    "jogging_joint": Level.INFO,  # joint, sign
    "jogging_tool": Level.INFO,  # axis, sign
    "jog_ended": Level.WARNING,  # reason
    "sent_pose": Level.INFO,  # x … rz
    "sent_line": Level.INFO,  # x … rz
    "sent_arc": Level.INFO,
    "stepped_tool": Level.INFO,  # axis, step with its unit
    "sent_speed": Level.INFO,  # percent
    "speed_waits": Level.WARNING,  # percent
    "other_host_moves": Level.WARNING,  # frames
    "leader_arm_moves": Level.WARNING,  # frames
    "other_host_gone": Level.INFO,  # frames
    "taken_over": Level.DONE,
    "cancel_unheeded": Level.FAULT,
    "motion_too_fast": Level.FAULT,  # reason
    "frames_dropped": Level.WARNING,  # count, total
    "sent_lamp": Level.INFO,  # joint, lamp, color
    "sent_lamps": Level.INFO,  # joint, color
    "stop_sent": Level.WARNING,
    "stop_not_sent": Level.FAULT,
    "stop_reaches_other": Level.WARNING,  # feedback
    "stop_lapsed": Level.FAULT,
    "stop_withdrawn": Level.WARNING,
    "stop_abandoned": Level.FAULT,  # device
    "stop_undone": Level.FAULT,
    "halt_sent": Level.INFO,
    "halt_not_out": Level.FAULT,
    "halt_at_rest": Level.DONE,
    "stop_confirmed": Level.WARNING,
    "stop_unconfirmed": Level.FAULT,
    "resume_sent": Level.INFO,
    "resumed": Level.DONE,
    "resume_failed": Level.FAULT,
    "enable_sent": Level.INFO,
    "enabled": Level.DONE,
    "enable_failed": Level.FAULT,  # joints
    "enable_sent_joint": Level.INFO,  # joint
    "enabled_joint": Level.DONE,  # joint
    "disable_sent": Level.INFO,
    "disable_sent_joint": Level.INFO,  # joint
    "disabled_joint": Level.DONE,  # joint
    "disabled": Level.DONE,
    "disable_failed": Level.FAULT,  # joints
    "clear_error_sent": Level.INFO,  # joint
    "clear_error_answered": Level.DONE,  # joint
    "clear_error_unanswered": Level.FAULT,  # joint
    "load_sent": Level.INFO,  # load
    "load_answered": Level.DONE,  # load
    "load_failed": Level.FAULT,  # reason
    "end_feedback_sent": Level.INFO,
    "end_feedback_on": Level.DONE,
    "end_feedback_off": Level.DONE,
    "end_feedback_failed": Level.FAULT,  # reason
    "linkage_sent": Level.INFO,
    "linkage_answered": Level.INFO,
    "linkage_answered_input": Level.INFO,
    "linkage_failed": Level.FAULT,  # reason
    "linkage_in_use": Level.DONE,  # feedback, control
    "linkage_found": Level.WARNING,  # feedback
    "gripper_sent": Level.INFO,  # value, unit
    "gripper_there": Level.DONE,  # value, unit
    "gripper_grips": Level.DONE,  # value, unit, torque
    "gripper_not_there": Level.FAULT,  # value, unit, target
    "gripper_act_sent": Level.INFO,  # act
    "gripper_act_done": Level.DONE,  # act
    "gripper_act_failed": Level.FAULT,  # act
    "zero_sent": Level.INFO,
    "zero_sent_joint": Level.INFO,  # joint
    "zero_set": Level.DONE,
    "zero_set_joint": Level.DONE,  # joint
    "zero_failed": Level.FAULT,  # reason
    "settings_sent": Level.INFO,  # count
    "settings_saved": Level.DONE,  # count
    "settings_refused": Level.FAULT,  # count, total, reason
    "settings_reset_sent": Level.INFO,
    "settings_reset": Level.DONE,
    "run_started": Level.INFO,  # name
    "run_paused": Level.INFO,  # row
    "run_continued": Level.INFO,  # row
    "run_done": Level.DONE,  # name
    "run_ended": Level.INFO,  # row
    "run_failed": Level.FAULT,  # row, reason
    "teaching_sent": Level.INFO,  # command
    "teaching_done": Level.DONE,  # command
    "teaching_unanswered": Level.FAULT,  # command
    "plan_sent": Level.INFO,  # plan
    "standby_sent": Level.INFO,
    "motion_output_sent": Level.INFO,
    "step_in_vain": Level.FAULT,
    "replay_paused": Level.INFO,
    "replay_continued": Level.INFO,
    "replay_ended": Level.INFO,  # name
    "replay_failed": Level.FAULT,  # reason
    "recording_started": Level.INFO,
    "recording_ended": Level.DONE,  # count, seconds
    "connected": Level.INFO,  # device
    "connect_failed": Level.FAULT,  # device, reason
    "disconnected": Level.INFO,  # device
    "link_lost": Level.FAULT,  # device, reason
    "reconnected": Level.DONE,  # device
    "bus_blocked": Level.FAULT,  # device, reason
    "bus_unblocked": Level.DONE,  # device
    "online": Level.DONE,
    "offline": Level.WARNING,
    "generation": Level.INFO,  # generation, firmware
    "limits_read": Level.INFO,
    "limits_missing": Level.WARNING,  # joints
    "limits_corrupt": Level.WARNING,  # joint
    "part_failed": Level.FAULT,  # part
    "settings_shared": Level.WARNING,  # path, count
    "channel_shared": Level.WARNING,  # device, count
    "refused": Level.WARNING,  # reason
}
"""Notice code to its level."""

REFUSALS: Final = frozenset(
    {
        "not_connected",
        "offline",
        "link_lost",
        "stopped",
        "stop_requested",
        "halt_listen_only",
        "listen_only",
        "not_stopped",
        "busy",  # what
        "step_gone",
        "step_in_vain",
        "teaching_off",
        "teaching_idle",
        "teaching_recording",
        "teaching_replaying",
        "teaching_paused",
        "not_moving",
        "not_enabled",  # joints
        "enabled_unknown",
        "speed_zero",
        "speed_out_of_range",  # value
        "joint_out_of_limits",  # joint, value, minimum, maximum
        "joint_not_a_number",  # joint, value
        "still_moving",
        "jog_at_limit",  # joint, limit
        "jog_out_of_reach",
        "jog_singular",  # joint
        "jog_not_following",
        "jog_no_feedback",
        "jog_held_up",  # value
        "pose_unknown",
        "target_refused",  # status
        "pose_not_a_number",  # axis, value
        "pose_out_of_reach",  # missing
        "pose_beyond_limits",  # joint, value, minimum, maximum
        "path_out_of_reach",  # gone
        "path_beyond_limits",  # joint, value, minimum, maximum, gone
        "path_singular",  # joint, gone
        "arc_not_at_start",  # distance, turned
        "arc_is_none",
        "arc_incomplete",  # point
        "model_differs",
        "light_out_of_range",  # light, value, minimum, maximum
        "light_not_a_number",  # light, value, minimum, maximum
        "joints_unknown",
        "generation_unknown",
        "no_rows_chosen",
        "findings_against",  # count
        "work_failed",  # text
        "moved_since_check",  # value
        "limits_changed_since_check",
        "not_running",
        "not_paused",
        "run_empty",  # name
        "run_no_such_row",  # row, maximum
        "run_stopped",
        "run_under_way",
        "run_disabled",
        "run_let_go",
        "run_left",
        "run_sets_lamps",
        "jog_under_way",
        "plan_paused",
        "held_at_zero",
        "nothing_held",
        "feedback_silent",  # frames, seconds
        "other_host",  # frames
        "leader_arm",  # frames
        "other_mode",  # other_mode
        "other_host_streams",  # frames
        "nobody_else",
        "command_over",
        "too_fast",  # joint, value, maximum
        "run_too_slow",  # seconds
        "run_elsewhere",  # away
        "run_not_ended",
        "replay_too_fast",  # joint, value, maximum, percent
        "replay_lagging",  # joint, away
        "replay_gap",  # seconds
        "gripper_other_generation",  # row
        "setting_out_of_range",  # parameter, joint, value, minimum, maximum
        "setting_not_a_number",  # parameter, joint, value, minimum, maximum
        "setting_no_choice",  # parameter, joint, value, choices
        "setting_not_kept",  # generation
        "setting_unknown",  # parameter, joint
        "setting_corrupt",  # parameter, joint
        "limits_crossed",  # joint, minimum, maximum
        "setting_unanswered",
        "setting_not_read_back",
        "setting_not_taken",  # parameter, joint, value, held
        "load_not_chosen",
        "load_while_moving",
        "end_feedback_goes_on",
        "control_offset_unknown",
        "offset_not_possible",  # offset, value
        "linkage_while_moving",
        "gripper_silent",
        "gripper_no_zero",
        "gripper_out_of_range",  # gripper, value, minimum, maximum, unit
        "gripper_not_a_number",  # gripper, value, minimum, maximum, unit
        "backup_no_json",  # line, column
        "backup_foreign",
        "backup_version",  # version, known
        "backup_field_missing",  # field
        "backup_field_bad",  # field, value
        "backup_twice",  # field, parameter
        "backup_empty",
        "backup_unreadable",  # path, text
        "backup_not_written",  # path, text
        "backup_nothing_read",
        "speed_unknown",  # joints
        "joints_moving",  # joints
        "zero_not_set",  # joints
        "zero_not_taken",  # joints
        "zero_moved",  # joints
        "order_too_late",
        "arm_changed",
        "part_failed",
        "ended_by_stop",
        "other_control",  # mode
        "arm_fault",  # status
        "bus_gone",  # device, interface
        "bus_busy",
        "bus_down",
        "bus_permission",
        "bus_off",  # + channel
        "bus_unacknowledged",
        "bus_send_blocked",
        "bus_backend_missing",  # + package
        "bus_driver_missing",
        "bus_bad_argument",  # + text
        "bus_failed",  # + text
    }
)
"""Every reason against an action; bus reasons all name device and interface."""
