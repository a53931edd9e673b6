"""The identifier offsets that 0x470 gives an arm, so that two arms can share one bus."""

from __future__ import annotations

from dataclasses import dataclass

OFFSETS = (0x00, 0x10, 0x20)
"""The legal offsets: 0x10 moves 0x2Ax to 0x2Bx and 0x15x to 0x16x, 0x20 one further."""

_FEEDBACK = range(0x2A1, 0x2A9)
_CONTROL = range(0x150, 0x160)


@dataclass(frozen=True, slots=True)
class Addressing:
    """Translates between the identifiers of the protocol's tables and those on the wire.

    Only the feedback 0x2A1–0x2A8 and the motion commands 0x150–0x15F move; everything else stays.

    Attributes:
        feedback_offset: Added to the feedback's identifiers: 0x00, 0x10 or 0x20.
        control_offset: Added to the motion commands' identifiers: 0x00, 0x10 or 0x20.

    Raises:
        ValueError: An offset the protocol does not know.
    """

    feedback_offset: int = 0
    control_offset: int = 0

    def __post_init__(self) -> None:
        for field in ("feedback_offset", "control_offset"):
            offset = getattr(self, field)
            if offset not in OFFSETS:
                raise ValueError(
                    f"{field} is {offset!r}; the protocol knows 0x00, 0x10 and 0x20 only"
                )

    def to_wire(self, arbitration_id: int) -> int:
        """Return the identifier on the bus for one of the protocol's tables."""
        if arbitration_id in _FEEDBACK:
            return arbitration_id + self.feedback_offset
        if arbitration_id in _CONTROL:
            return arbitration_id + self.control_offset
        return arbitration_id

    def on_every_offset(self, arbitration_id: int) -> tuple[int, ...]:
        """Return a motion command's identifiers on the bus for all offsets, the arm's own first."""
        base = self.from_wire(arbitration_id)
        if base is None or base not in _CONTROL:
            return (arbitration_id,)
        others = (base + offset for offset in OFFSETS if offset != self.control_offset)
        return (arbitration_id, *others)

    def from_wire(self, arbitration_id: int) -> int | None:
        """Return the identifier in the protocol's tables for one seen on the bus.

        Returns:
            The identifier without its offset, or None when it belongs to another arm: one of the
            movable ranges, with an offset other than this arm's.
        """
        for base, own in ((_FEEDBACK, self.feedback_offset), (_CONTROL, self.control_offset)):
            for offset in OFFSETS:
                if arbitration_id - offset in base:
                    return arbitration_id - offset if offset == own else None
        return arbitration_id
