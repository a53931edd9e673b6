"""轨迹库: the list of trajectories, and the actions on it."""
