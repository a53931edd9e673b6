"""armui: the open host program for AgileX's PiPER arm on a CAN bus."""

__version__ = "0.4.0.dev0"
