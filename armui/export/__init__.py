"""The command `armui export`: a recorded CAN log as MCAP, CSV or Parquet."""

from armui.export.export_command import add_arguments, run

__all__ = ["add_arguments", "run"]
