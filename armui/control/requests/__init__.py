"""Requests: commands from sending to their end, answered, read back, refused or timed out."""
