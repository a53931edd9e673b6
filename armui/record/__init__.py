"""`armui record`: records the traffic of a bus in a file, without a window."""

from armui.record.record_command import add_arguments, run

__all__ = ["add_arguments", "run"]
