"""Commands to motors, gripper, lamps, linkage, drag teaching, zeros and end reports."""
