"""The command `armui doctor`: finds faults of this computer and of the bus, with their remedies.

It must run where the window does not, so Qt, numpy and python-can are only loaded when needed.
"""

from armui.doctor.doctor_command import add_arguments, run

__all__ = ["add_arguments", "run"]
