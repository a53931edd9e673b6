"""What a host can say to the arm: one function a command.

Each takes the codec first and physical units after it (degrees and millimetres; any other unit is
in the name), and returns the frames in sending order. All raise `EncodeError` for a value the
protocol cannot carry and for a command the generation does not have; whether the arm can do what is
asked is not theirs to judge. Direct (MIT) control of motors is left out on purpose.
"""

from armui.protocol.commands.motion import (
    arc_point,
    cartesian_target,
    clear_gripper_error,
    disable_gripper,
    disable_motors,
    emergency_stop,
    enable_motors,
    joint_target,
    move_arc,
    move_gripper_angle,
    move_gripper_opening,
    move_joints,
    move_pose,
    resume,
    set_gripper_zero,
    set_mode,
    teaching_command,
    trajectory_command,
)
from armui.protocol.commands.queries import (
    query_acceleration,
    query_collision_levels,
    query_end_limits,
    query_firmware,
    query_limits,
    query_teaching,
    query_trajectory_index,
)
from armui.protocol.commands.settings import (
    clear_joint_error,
    reset_end_limits,
    reset_joint_limits,
    set_bus_silence,
    set_end_feedback,
    set_joint_zero,
    set_light,
    set_linkage,
    set_load,
    set_parameters,
)

__all__ = [
    "arc_point",
    "cartesian_target",
    "clear_gripper_error",
    "clear_joint_error",
    "disable_gripper",
    "disable_motors",
    "emergency_stop",
    "enable_motors",
    "joint_target",
    "move_arc",
    "move_gripper_angle",
    "move_gripper_opening",
    "move_joints",
    "move_pose",
    "query_acceleration",
    "query_collision_levels",
    "query_end_limits",
    "query_firmware",
    "query_limits",
    "query_teaching",
    "query_trajectory_index",
    "reset_end_limits",
    "reset_joint_limits",
    "resume",
    "set_bus_silence",
    "set_end_feedback",
    "set_gripper_zero",
    "set_joint_zero",
    "set_light",
    "set_linkage",
    "set_load",
    "set_mode",
    "set_parameters",
    "teaching_command",
    "trajectory_command",
]
