"""The proof that a motion was checked, without which none is sent (S35)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.ways.rules import Rules
    from armui.ways.way import Way


@dataclass(frozen=True, slots=True)
class Pass:
    """The proof that a motion may be sent; nobody but the gate makes one (S35).

    Attributes:
        way: The way that was checked; ``None`` of what moves no joint.
        rules: The rules it was checked against; with other rules it is void.
    """

    way: Way | None = None
    rules: Rules | None = None
