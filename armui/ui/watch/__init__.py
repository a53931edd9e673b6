"""Watching the arm over time: curves."""
