"""夹爪控制: opening or angle, power, zero and errors of the gripper."""
