"""Whether the arm stands still, by its measured joint angles."""

from __future__ import annotations

from typing import Final

from armui.arm.state import ArmState

_STILL_DEG: Final = 0.02
_STILL_FOR_S: Final = 0.3


class Stillness:
    """Compares angles over time; says yes after 0.3 s in which no joint moved by 0.02°."""

    def __init__(self) -> None:
        self._from_deg: tuple[float, ...] | None = None
        self._since_s = 0.0

    def still(self, state: ArmState, now_s: float) -> bool:
        """Look at the angles last heard; called regularly."""
        angles_deg = state.angles_deg()
        if angles_deg is None or not state.online(now_s):
            self._from_deg = None
            return False
        moved = self._from_deg is None or any(
            abs(a - b) > _STILL_DEG for a, b in zip(angles_deg, self._from_deg, strict=True)
        )
        if moved:
            self._from_deg, self._since_s = angles_deg, now_s
        return not moved and now_s - self._since_s >= _STILL_FOR_S
