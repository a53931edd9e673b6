"""What the link and the GUI thread hand each other: states to draw, and what became of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.viewport.frame_memory import FrameMemory
    from armui.viewport.view_state import ViewState


@dataclass(frozen=True, slots=True)
class Wanted:
    """A state to draw, and its number."""

    sequence: int
    state: ViewState


@dataclass(frozen=True, slots=True)
class PictureFrame:
    """A finished image.

    Attributes:
        number: Of the frame, for `ProcessLink.frame_used`.
        sequence: Number of the state that it shows.
        memory, slot, size_px: Where it is, and how large.
        pixel_ratio: Device pixels a logical pixel.
        is_rough: Whether one with smooth edges follows.
        began_s, ended_s: When it was drawn, by the system's monotonic clock.
    """

    number: int
    sequence: int
    memory: FrameMemory
    slot: int
    size_px: tuple[int, int]
    pixel_ratio: float
    is_rough: bool
    began_s: float
    ended_s: float


@dataclass(frozen=True, slots=True)
class UpToDate:
    """The last image shows this state, too; see `armui.viewport.messages.Drawn`."""

    sequence: int
    is_rough: bool


@dataclass(frozen=True, slots=True)
class Lost:
    """The process is gone; unless it comes back by itself, no pictures follow."""

    reason: Refusal
    comes_back: bool
