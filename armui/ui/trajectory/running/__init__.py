"""Checks, starts and follows runs and replays."""
