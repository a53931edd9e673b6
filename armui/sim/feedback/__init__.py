"""What the simulated arm tells, and when."""
