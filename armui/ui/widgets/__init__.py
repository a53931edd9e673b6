"""Widgets that are used by more than one room of the windows."""
