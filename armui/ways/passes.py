"""What lets a motion onto the bus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.ways.rules import Rules
    from armui.ways.way import Way


@dataclass(frozen=True, slots=True)
class Pass:
    """What the gate hands out with a motion that may be sent; nobody else makes one.

    Attributes:
        way: The way that was checked; ``None`` of what moves no joint.
        rules: What it was checked against: with other rules it counts no more.
    """

    way: Way | None = None
    rules: Rules | None = None
