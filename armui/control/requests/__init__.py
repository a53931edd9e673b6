"""A command from sending to its end: answered, read back, refused or timed out."""
