"""The frames that the simulated arm sends by itself, and when each is due."""
