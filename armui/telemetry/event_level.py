"""How grave an event is."""

import enum


class Level(enum.Enum):
    """How grave an event is."""

    INFO = enum.auto()
    DONE = enum.auto()
    WARNING = enum.auto()
    FAULT = enum.auto()
