"""armui: the open host program for AgileX's PiPER arm on a CAN bus."""

__version__ = "0.3.0"
