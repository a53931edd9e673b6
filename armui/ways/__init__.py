"""Ways that a motion takes, and the rules that restrict them: pure, numpy only."""
