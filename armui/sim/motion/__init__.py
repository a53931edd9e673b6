"""What the simulated controller makes of motion commands."""
