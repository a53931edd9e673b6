"""Widgets that more than one room of the windows uses."""
