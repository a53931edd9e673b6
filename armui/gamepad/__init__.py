"""Gamepads and SpaceMice: read in a thread of their own; what their axes and buttons ask for."""
