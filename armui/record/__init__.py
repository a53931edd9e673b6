"""`armui record`: what is on a bus into a file, without a window."""

from armui.record.record_command import add_arguments, run

__all__ = ["add_arguments", "run"]
