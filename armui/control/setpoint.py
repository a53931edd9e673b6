"""The angles last asked for, as long as they stand for what the arm is doing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from armui.arm.state import ArmState

_SAME_PLACE_DEG: Final = 0.5
"""Measured this close to the setpoint, a joint is where it was sent."""

_UNDER_WAY_S: Final = 0.3
"""So long after it was sent a motion counts as under way, whatever the arm's last word was."""

_LAG_STEPS: Final = 2


class Setpoint:
    """Where the next jog starts from.

    Attributes:
        angles_deg: Six angles, or ``None``.
        revision: Grows whenever somebody sets or clears them.
    """

    def __init__(self) -> None:
        self.angles_deg: tuple[float, ...] | None = None
        self.revision = 0
        self._sent_s = 0.0

    def set(self, angles_deg: Sequence[float], now_s: float) -> None:
        """The arm has been sent to these six angles."""
        self.angles_deg = tuple(angles_deg)
        self.revision += 1
        self._sent_s = now_s

    def clear(self) -> None:
        """The arm is no longer where it was sent: stopped, limp, lost."""
        self.angles_deg = None
        self.revision += 1

    def jog_base_deg(
        self, state: ArmState, now_s: float, *, moving: bool
    ) -> tuple[float, ...] | None:
        """Six angles a step is added to, or ``None`` while the arm's angles are not known.

        A moving arm, and a joint that has arrived, step from the setpoint, so that steps add up
        exactly; a joint that somebody moved by hand steps from where it is.
        """
        measured_deg = state.angles_deg()
        if measured_deg is None or self.angles_deg is None:
            return measured_deg
        if moving or now_s - self._sent_s < _UNDER_WAY_S:
            return self.angles_deg
        return tuple(
            asked if abs(asked - measured) < _SAME_PLACE_DEG else measured
            for asked, measured in zip(self.angles_deg, measured_deg, strict=True)
        )

    def lagging(self, state: ArmState, joint: int, step_deg: float) -> bool:
        """Whether the arm is more than two steps behind: a held button should not step on."""
        heard = state.joints_deg[joint - 1]
        if self.angles_deg is None or heard is None:
            return False
        return abs(self.angles_deg[joint - 1] - heard.value) > _LAG_STEPS * abs(step_deg)
