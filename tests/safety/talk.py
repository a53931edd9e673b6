"""What the safety tests look for on the bus."""

MOTION_IDS = frozenset(range(0x151, 0x160)) | frozenset(range(0x181, 0x188))
"""Frames that start or change a motion; 0x150 carries stops, cancels and pauses as well."""
