"""夹爪控制: the gripper."""
