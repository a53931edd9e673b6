"""The command `armui doctor`: what is missing on this computer and on the bus, with the remedy.

It runs where the window does not, so nothing here is loaded before it is needed: neither Qt nor
numpy nor python-can.
"""

from armui.doctor.doctor_command import add_arguments, run

__all__ = ["add_arguments", "run"]
