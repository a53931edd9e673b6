"""轨迹库: the list of trajectories, and what can be done with it."""
