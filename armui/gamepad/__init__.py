"""Gamepads and SpaceMice: read in a thread of their own, and interpreted as commands to the arm."""
