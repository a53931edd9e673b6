"""Tests of the pages of trajectories."""
