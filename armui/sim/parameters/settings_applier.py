"""Applies settings to the arm's parts: zeros, weight, feedback schedule, flash."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence

from armui.arm.limits import JointLimits
from armui.protocol.addressing import Addressing
from armui.protocol.codes import Mounting
from armui.sim.arm_type import ArmType
from armui.sim.condition import Condition
from armui.sim.feedback_schedule import FeedbackSchedule
from armui.sim.mechanics.gravity import DOWN_BY_MOUNTING, PAYLOADS_KG
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.parameters.flash import Flash
from armui.sim.parameters.settings import ArmSettingsRecord


class SettingsApplier:
    """Applies the settings to the arm's parts and writes them to its flash.

    Attributes:
        model: The arm's type.
        stops: The mechanical stops, joint 1 first, whatever limits and zeros were set. A joint that
            was found beyond the model's range can be there: its stop is where it lay.
    """

    def __init__(
        self,
        settings: ArmSettingsRecord,
        mechanics: Mechanics,
        condition: Condition,
        schedule: FeedbackSchedule,
        arm_type: ArmType,
        *,
        found_deg: Sequence[float],
        flash: Flash,
        drop_targets: Callable[[], None],
    ) -> None:
        """Manages the parts of one arm.

        Args:
            settings: The values it keeps.
            mechanics: Its joints.
            condition: Its modes.
            schedule: The schedule of its feedback.
            arm_type: Its type.
            found_deg: The angles at which it was found, counted from the factory's zeros.
            flash: The storage of its settings.
            drop_targets: Drops its targets.
        """
        self.model = arm_type.model
        self._quirks = arm_type.quirks
        self._settings = settings
        self._flash = flash
        self._mechanics = mechanics
        self._condition = condition
        self._schedule = schedule
        self._drop_targets = drop_targets
        self._hanging_kg: float | None = None
        self._slips_deg = [0.0] * len(self.model.limits)
        self._widest = tuple(
            each._replace(min_deg=min(each.min_deg, angle), max_deg=max(each.max_deg, angle))
            for each, angle in zip(self.model.limits, found_deg, strict=True)
        )
        self.stops: tuple[JointLimits, ...] = self._widest
        self._refresh()

    @property
    def addressing(self) -> Addressing:
        """The identifier offsets in the settings."""
        linkage = self._settings.linkage
        return Addressing(linkage.feedback_offset, linkage.control_offset)

    def hang(self, mass_kg: float | None) -> None:
        """Sets the mass at the flange; None uses the one that the host has set."""
        self._hanging_kg = mass_kg
        self._refresh()

    def mount(self, mounting: Mounting) -> None:
        """Turns the whole arm to the mounting the host has set; the arm cannot measure it."""
        if mounting is Mounting.UPSIDE_DOWN and not self._quirks.has_upside_down:
            return
        down = DOWN_BY_MOUNTING.get(mounting)
        if down is not None:
            self._mechanics.weight.down = down

    def restart(self) -> None:
        """Loads the settings from the flash."""
        self._settings.take_over(self._flash.load(self.model.model))
        self._schedule.end_motion = False
        self._refresh()

    def settings_changed(self) -> None:
        """Applies the settings and writes them to the flash."""
        self._refresh()
        self._flash.save(self._settings)

    def report_end_motion(self, *, on: bool) -> None:
        """Switches the feedback 0x481–0x486."""
        self._schedule.end_motion = on

    def clear_joint_errors(self, indices: Iterable[int]) -> None:
        """Clears the errors that the drivers of joints (0–5) keep."""
        indices = list(indices)
        self._condition.alarms.clear(indices)
        for i in indices:
            self._condition.beyond_limit[i] = False

    def set_zero(self, indices: Iterable[int]) -> bool:
        """Makes the positions of joints (0–5) their zeros; returns whether it was possible.

        Every joint must stand still and be reachable; otherwise none is set.
        """
        indices, mechanics = list(indices), self._mechanics
        if mechanics.moving or any(
            mechanics.speeds_deg_s[i] or self._condition.communication_fault[i] for i in indices
        ):
            return False
        self._drop_targets()
        angles_deg, zeros_deg = list(mechanics.positions_deg), list(self._settings.zeros_deg)
        for i in indices:
            zeros_deg[i] += angles_deg[i]
            angles_deg[i] = 0.0
        self._settings.zeros_deg = zeros_deg
        self._refresh()
        mechanics.count_anew(angles_deg)
        return True

    def slip(self, index: int, step_deg: float, *, most_deg: float) -> None:
        """Turns a joint (0–5) without its encoder counting: its reported angle becomes wrong.

        Args:
            index: The joint.
            step_deg: The turn in degrees.
            most_deg: The largest turn in all; more is left out, as is a turn that a stop prevents.
        """
        stop, angle = self.stops[index], self._mechanics.positions_deg[index]
        there = self._slips_deg[index] + step_deg
        if abs(there) <= most_deg and stop.min_deg <= angle + step_deg <= stop.max_deg:
            self._slips_deg[index] = there
            self._refresh()

    def find_place(self, but: Collection[int] = ()) -> None:
        """Makes every joint that has slipped report its true angle again, but these (0–5)."""
        found = [0.0 if i in but else slip for i, slip in enumerate(self._slips_deg)]
        if any(found):
            there = [a + b for a, b in zip(self._mechanics.positions_deg, found, strict=True)]
            self._slips_deg = [a - b for a, b in zip(self._slips_deg, found, strict=True)]
            self._drop_targets()
            self._refresh()
            self._mechanics.count_anew(there)

    def move_zero(self, index: int, angle_deg: float) -> None:
        """Moves a joint's (0–5) zero; the joint stays in place and reports a smaller angle."""
        angles_deg, zeros_deg = list(self._mechanics.positions_deg), list(self._settings.zeros_deg)
        zeros_deg[index] += angle_deg
        angles_deg[index] -= angle_deg
        self._settings.zeros_deg = zeros_deg
        self.settings_changed()
        self._mechanics.count_anew(angles_deg)

    def _refresh(self) -> None:
        zeros_deg, weight = self._settings.zeros_deg, self._mechanics.weight
        told_kg = PAYLOADS_KG[self._settings.load]
        zeros_deg = [a + b for a, b in zip(zeros_deg, self._slips_deg, strict=True)]
        weight.zeros_deg = zeros_deg
        weight.told_kg = told_kg
        weight.payload_kg = told_kg if self._hanging_kg is None else self._hanging_kg
        self.stops = tuple(
            each._replace(min_deg=each.min_deg - zero, max_deg=each.max_deg - zero)
            for each, zero in zip(self._widest, zeros_deg, strict=True)
        )
