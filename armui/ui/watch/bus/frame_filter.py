"""The filter of frames by identifier, text, sender and change: pure."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.protocol.frame import FrameFlag
from armui.telemetry.bus_senders import Sender

if TYPE_CHECKING:
    from armui.telemetry.bus_statistics import FrameRow

_HEX: Final = r"(?:0[xX])?([0-9a-fA-F]{1,8})"
_ONE: Final = re.compile(_HEX)
_RANGE: Final = re.compile(rf"{_HEX}\s*[-–]\s*{_HEX}")
_MASKED: Final = re.compile(rf"{_HEX}\s*/\s*{_HEX}")
_SEPARATORS: Final = re.compile(r"\s*[,;]\s*|(?<![-–/\s])\s+(?![-–/\s])")


@dataclass(frozen=True, slots=True)
class IdFilter:
    """A set of identifiers.

    Attributes:
        ranges: The first and the last identifier of each range.
        masked: Value and mask: the bits of the mask must be those of the value.
    """

    ranges: tuple[tuple[int, int], ...] = ()
    masked: tuple[tuple[int, int], ...] = ()

    def accepts(self, arbitration_id: int) -> bool:
        """Return whether an identifier is in the set; an empty one accepts all."""
        if not (self.ranges or self.masked):
            return True
        return any(low <= arbitration_id <= high for low, high in self.ranges) or any(
            arbitration_id & mask == value & mask for value, mask in self.masked
        )


def parse_ids(text: str) -> IdFilter | str:
    """Return the filter in a text, or the part of the text that is wrong.

    Args:
        text: Hexadecimal, separated by commas or blanks: ``2A1``, ``2A1-2A8``, ``155/7F0`` for
            value and mask. Empty: all.
    """
    ranges: list[tuple[int, int]] = []
    masked: list[tuple[int, int]] = []
    for part in _SEPARATORS.split(text.strip()):
        if not part:
            continue
        if found := _ONE.fullmatch(part):
            ranges.append((int(found[1], 16), int(found[1], 16)))
        elif found := _RANGE.fullmatch(part):
            low, high = sorted((int(found[1], 16), int(found[2], 16)))
            ranges.append((low, high))
        elif found := _MASKED.fullmatch(part):
            masked.append((int(found[1], 16), int(found[2], 16)))
        else:
            return part
    return IdFilter(tuple(ranges), tuple(masked))


@dataclass(frozen=True, slots=True)
class FrameFilter:
    """The conditions for a frame to be shown.

    Attributes:
        text: A part of its identifier or name, in any case.
        ids: Its identifiers.
        sender: Its sender.
        only_unknown: True for frames that are unknown, or do not follow the protocol.
        changed_since_s: The time since which a byte must have changed.
    """

    text: str = ""
    ids: IdFilter = IdFilter()
    sender: Sender | None = None
    only_unknown: bool = False
    changed_since_s: float | None = None

    def accepts(self, row: FrameRow, words: Callable[[FrameRow], str]) -> bool:
        """Return whether a row is shown.

        Args:
            row: A row of the statistics.
            words: Returns the texts of a row, with its identifier.
        """
        if self.sender is not None and row.sender is not self.sender:
            return False
        if not self.ids.accepts(row.arbitration_id):
            return False
        if self.only_unknown and not (row.invalid_count or row.flags & FrameFlag.ERROR):
            return False
        if self.changed_since_s is not None and not row.changed_since(self.changed_since_s):
            return False
        return self.text.casefold() in words(row).casefold() if self.text else True

    @property
    def for_trace(self) -> FrameFilter:
        """The same filter for single frames, each of which must have changed."""
        return replace(self, changed_since_s=None)
