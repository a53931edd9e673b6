"""Logs of other programs: read once into columns on the disk, so that any place is at hand."""
