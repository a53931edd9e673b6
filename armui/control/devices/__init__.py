"""What else the arm has: motors, gripper, lamps, linkage, teaching, zeros, end reports."""
