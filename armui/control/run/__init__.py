"""Runs of trajectories, replays of recordings, and the recording itself."""
