"""Applies settings to the arm's parts: zeros, weight, feedback schedule, flash."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from armui.arm.limits import FACTORY_LIMITS, JointLimits
from armui.protocol.addressing import Addressing
from armui.sim.condition import Condition
from armui.sim.feedback.schedule import FeedbackSchedule
from armui.sim.mechanics.gravity import PAYLOADS_KG
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.parameters.flash import Flash
from armui.sim.parameters.settings import ArmSettingsRecord


class SettingsApplier:
    """Keeps the arm's parts and its flash in step with its settings.

    Attributes:
        stops: Where the metal ends, joint 1 first, whatever limits and zeros were set.
    """

    def __init__(
        self,
        settings: ArmSettingsRecord,
        mechanics: Mechanics,
        condition: Condition,
        schedule: FeedbackSchedule,
        *,
        flash: Flash,
        forget: Callable[[], None],
    ) -> None:
        """Takes care of the parts of one arm; `forget` drops the targets it has."""
        self._settings = settings
        self._flash = flash
        self._body = mechanics
        self._condition = condition
        self._schedule = schedule
        self._forget = forget
        self._hanging_kg: float | None = None
        self.stops: tuple[JointLimits, ...] = FACTORY_LIMITS
        self._refresh()

    @property
    def addressing(self) -> Addressing:
        """The identifier offsets the arm is to have."""
        linkage = self._settings.linkage
        return Addressing(linkage.feedback_offset, linkage.control_offset)

    def hang(self, mass_kg: float | None) -> None:
        """Hangs a mass at the flange whatever the host says of it; as it says again with None."""
        self._hanging_kg = mass_kg
        self._refresh()

    def restart(self) -> None:
        """Goes on with the settings that the flash holds."""
        self._settings.take_over(self._flash.load())
        self._schedule.end_motion = False
        self._refresh()

    def settings_changed(self) -> None:
        """Applies the settings and writes them to the flash."""
        self._refresh()
        self._flash.save(self._settings)

    def report_end_motion(self, *, on: bool) -> None:
        """Switches 0x481–0x486."""
        self._schedule.end_motion = on

    def clear_joint_errors(self, indices: Iterable[int]) -> None:
        """Clears the errors the drivers of joints (0–5) keep."""
        indices = list(indices)
        self._condition.alarms.clear(indices)
        for i in indices:
            self._condition.beyond_limit[i] = False

    def set_zero(self, indices: Iterable[int]) -> bool:
        """Writes where joints (0–5) stand as their zero, of all or of none.

        It takes joints that stand still and can be talked to.
        """
        indices, mechanics = list(indices), self._body
        if mechanics.moving or any(
            mechanics.speeds_deg_s[i] or self._condition.communication_fault[i] for i in indices
        ):
            return False
        self._forget()
        angles_deg, zeros_deg = list(mechanics.positions_deg), list(self._settings.zeros_deg)
        for i in indices:
            zeros_deg[i] += angles_deg[i]
            angles_deg[i] = 0.0
        self._settings.zeros_deg = zeros_deg
        self._refresh()
        mechanics.count_anew(angles_deg)
        return True

    def _refresh(self) -> None:
        zeros_deg, weight = self._settings.zeros_deg, self._body.weight
        told_kg = PAYLOADS_KG[self._settings.load]
        weight.zeros_deg = zeros_deg
        weight.told_kg = told_kg
        weight.payload_kg = told_kg if self._hanging_kg is None else self._hanging_kg
        self.stops = tuple(
            replace(each, min_deg=each.min_deg - zero, max_deg=each.max_deg - zero)
            for each, zero in zip(FACTORY_LIMITS, zeros_deg, strict=True)
        )
