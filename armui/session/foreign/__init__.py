"""Logs of other programs: read once into columns on the disk, for access to any place."""
