"""The two generations of the protocol."""

from __future__ import annotations

import enum


class Generation(enum.IntEnum):
    """Which protocol an arm speaks: that of the manual, or that of today's firmware."""

    ONE = 1
    TWO = 2
