"""Jogging by gamepad and SpaceMouse."""
