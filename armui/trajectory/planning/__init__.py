"""Where a trajectory leads: its path, its time, and what speaks against it."""
