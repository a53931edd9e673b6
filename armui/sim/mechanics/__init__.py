"""How the simulated arm moves: powered, unpowered or led by hand, under gravity."""
