"""Trajectories of points, and their editing."""
