"""The fault by which a joint loses its reference, as owners reported it in 2026.

An enabled arm pushed by hand reported an excursion of joint 5 of 40–89° at no more than 3.7 A, and
then its return. From then on the joint stood off by up to 85° with plausible feedback; only the
reset of 0x150 mended it. The times of the excursion are assumed, and that its return is what turns
the joint.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Final

from armui.sim.mechanics.powered_joints import SixValues

if TYPE_CHECKING:
    from armui.sim.parameters.settings_applier import SettingsApplier

EXCURSION_DEG: Final = 60.0
_AWAY_S: Final = 0.5
_STAYS_S: Final = 0.2
_BACK_S: Final = 0.5
_END_S: Final = _AWAY_S + _STAYS_S + _BACK_S
MOST_A: Final = 3.7
"""The highest current that was reported during an excursion."""


class LostReference:
    """Joints that have lost their reference, and the excursion that one reports.

    Attributes:
        joints: The joints (0–5) that stand elsewhere than they report.
    """

    def __init__(self, settings_applier: SettingsApplier) -> None:
        self._settings_applier = settings_applier
        self._index: int | None = None
        self._elapsed_s = 0.0
        self._excursion_deg = self._shift_deg = 0.0
        self._lost: set[int] = set()

    @property
    def joints(self) -> Collection[int]:
        """The joints (0–5) that stand elsewhere than they report."""
        return self._lost

    def begin(
        self, index: int, excursion_deg: float = EXCURSION_DEG, shift_deg: float | None = None
    ) -> None:
        """Begins the excursion of a joint.

        Args:
            index: The joint (0–5).
            excursion_deg: How far away it is reported.
            shift_deg: How far it turns on its return; by default as far back as was reported. A
                stop ends it before.
        """
        self._index, self._elapsed_s = index, 0.0
        self._excursion_deg = excursion_deg
        self._shift_deg = -excursion_deg if shift_deg is None else shift_deg

    def mend(self) -> None:
        """Ends everything: the reset of 0x150 has every joint report its true angle."""
        self._index = None
        self._lost.clear()

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds; on the way back the joint turns."""
        if self._index is None:
            return
        before = self._share_back
        self._elapsed_s += dt_s
        turned_deg = self._shift_deg * (self._share_back - before)
        if turned_deg:
            self._lost.add(self._index)
            self._settings_applier.slip(
                self._index, turned_deg, most_deg=abs(self._shift_deg) + 1.0
            )
        if self._elapsed_s >= _END_S:
            self._index = None

    def reported_deg(self, positions_deg: SixValues) -> SixValues:
        """Return the angles that the arm reports instead of these."""
        if self._index is None:
            return positions_deg
        away_deg = self._excursion_deg * (min(1.0, self._elapsed_s / _AWAY_S) - self._share_back)
        return tuple(
            angle + away_deg if i == self._index else angle for i, angle in enumerate(positions_deg)
        )

    def speed_deg_s(self, index: int) -> float:
        """Return the speed that the excursion adds to the report of a joint (0–5)."""
        if index != self._index:
            return 0.0
        if self._elapsed_s < _AWAY_S:
            return self._excursion_deg / _AWAY_S
        return -self._excursion_deg / _BACK_S if self._share_back else 0.0

    def current_a(self, index: int, current_a: float) -> float:
        """Return the current that a joint (0–5) reports: no more than was seen."""
        speed_deg_s = self.speed_deg_s(index)
        if not speed_deg_s:
            return current_a
        return MOST_A if speed_deg_s > 0.0 else -MOST_A

    @property
    def _share_back(self) -> float:
        return min(1.0, max(0.0, (self._elapsed_s - _AWAY_S - _STAYS_S) / _BACK_S))
