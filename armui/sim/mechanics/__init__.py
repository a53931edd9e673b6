"""The motion of the simulated arm: powered, unpowered or led by hand, under gravity."""
