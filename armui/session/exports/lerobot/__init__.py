"""Episodes of a log as a dataset of LeRobot (v3.0), without cameras."""
