"""Plays a log in place of the bus; nothing here can send."""
