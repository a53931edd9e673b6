"""Trajectories and recordings: files, library, planning and checks; no Qt, no bus."""
