"""Panels for the parameters the arm keeps: joints, end, collision levels, gripper, load."""
