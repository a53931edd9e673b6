"""The panels of the arm's parameters: joints, end, collision levels, gripper, load."""
