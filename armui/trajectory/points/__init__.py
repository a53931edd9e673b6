"""Trajectories of points: what they are, and how they are edited."""
