"""Plans a trajectory: its path, its timing, and the check with its findings."""
