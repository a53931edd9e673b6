"""Finds the place of a note over the picture, where it hides least of the arm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from armui.viewport.fitting import Box

if TYPE_CHECKING:
    from armui.viewport.fitting import Room

_RIM_PX = 14.0


def note_places(room: Room, width_px: float, height_px: float) -> list[Box]:
    """Return the places for a note, the usual one first; those with too little room are left out.

    At the bottom, at the top beside the figures, under the figures, at the bottom beside the strip.

    Args:
        room: The picture and what lies over it.
        width_px: Of the note.
        height_px: Likewise.
    """
    figures = room.figures
    right = room.width_px - room.strip_px - width_px - _RIM_PX
    bottom = room.height_px - _RIM_PX - height_px
    corners = [
        (_RIM_PX, bottom),
        (right, _RIM_PX),
        (_RIM_PX, max(figures.bottom, _RIM_PX)),
        (right, bottom),
    ]
    places = [Box(left, top, left + width_px, top + height_px) for left, top in corners]
    free = [
        each
        for each in places
        if each.left >= 0.0 and each.top >= 0.0 and not each.overlaps(figures)
    ]
    return free or places[:1]


def freest(places: Sequence[Box], seen: Sequence[Box], before: int) -> int:
    """Return the index of the place that hides least of the arm.

    Args:
        places: As of `note_places`.
        seen: A rectangle around each link of the arm.
        before: The index of the present place, which stays unless another is better.
    """
    hidden = [sum(_shared_px2(place, each) for each in seen) for place in places]
    least = min(hidden)
    if before < len(hidden) and hidden[before] == least:
        return before
    return hidden.index(least)


def _shared_px2(one: Box, other: Box) -> float:
    wide = min(one.right, other.right) - max(one.left, other.left)
    high = min(one.bottom, other.bottom) - max(one.top, other.top)
    return max(wide, 0.0) * max(high, 0.0)
