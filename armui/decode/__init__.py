"""The command `armui decode`: a recorded CAN log, frame by frame, in words and units."""

from armui.decode.decode_command import add_arguments, run

__all__ = ["add_arguments", "run"]
