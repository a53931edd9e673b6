"""Known bugs of firmware versions, as users reported them, for testing how a host copes.

The reports tell the effect, seldom the cause; the moment at which each bug shows here is assumed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.protocol.codes import LinkageRole
from armui.protocol.firmware_version import FirmwareBug
from armui.protocol.frame import Frame
from armui.sim.parameters.settings import LinkageSettings

if TYPE_CHECKING:
    from armui.sim.condition import Condition
    from armui.sim.faults.lost_reference import LostReference
    from armui.sim.mechanics.mechanics import Mechanics
    from armui.sim.parameters.settings import ArmSettingsRecord
    from armui.sim.parameters.settings_applier import SettingsApplier

PURPOSES: Final = {
    FirmwareBug.CORRUPTED_LIMITS: (
        "all limits read -0.1°/-0.1° and 0xFFFF as acceleration until they are reset"
    ),
    FirmwareBug.FEEDBACK_PARTS: (
        "10 s after all motors are on, joint 3 goes on at 2°/s for 30° and its feedback does not "
        "show it; 0x150 resume mends it"
    ),
    FirmwareBug.MIT_MOVES_ZERO: (
        "a mode word that leaves MIT or high-follow is not followed by any motion until a reset, "
        "and moves the zero of joint 1 by 12°"
    ),
    FirmwareBug.ZERO_FEEDBACK: (
        "angles and pose read 0 until the teaching handle is set with 0x47D"
    ),
    FirmwareBug.SILENT_LEADER: (
        "made a teaching input with 0x470, the arm says nothing more until a power cycle"
    ),
    FirmwareBug.FALLS_BACK_TO_LEADER: (
        "30 s after it was switched on the arm makes itself a teaching input"
    ),
    FirmwareBug.TEACHING_EXIT_DROPS: (
        "leaving drag teaching drops the arm; the simulated arm does so with every version"
    ),
}
"""A description of each bug's effect here."""

NAMES: Final = {bug.value.replace("_", "-"): bug for bug in FirmwareBug}
"""The bugs by their names on the command line."""

_SLIPPING: Final = 2
_SLIPS_AFTER_S: Final = 10.0
_SLIP_DEG_S: Final = 2.0
_MOST_SLIP_DEG: Final = 30.0
_ZERO_MOVES_DEG: Final = 12.0
_LEADS_AFTER_S: Final = 30.0
_BAD_DEG: Final = -0.1
_TOLD_ZERO: Final = ("JointFeedback", "EndPose", "DriverFast")


@dataclass(eq=False, repr=False)
class FirmwareBugs:
    """The bugs that one arm has.

    Attributes:
        present: The bugs.
        mechanics: The arm's joints and motors.
        condition: Its modes, flags and faults.
        settings: The values it keeps.
        applier: Moves its zeros, and finds the joints' places.
        lost: The fault by which a joint loses its reference.
        lead: Gives it another role.
        corrupt_limits: Makes the limits of a joint (1–6) read back as from a worn flash.
        silent: True if the arm sends nothing because of a bug.
    """

    present: frozenset[FirmwareBug]
    mechanics: Mechanics
    condition: Condition
    settings: ArmSettingsRecord
    applier: SettingsApplier
    lost: LostReference
    lead: Callable[[LinkageSettings], None]
    corrupt_limits: Callable[[int], None]
    silent: bool = field(default=False, init=False)
    _powered_s: float = field(default=0.0, init=False)
    _on_s: float = field(default=0.0, init=False)
    _handle_set: bool = field(default=False, init=False)

    def __post_init__(self) -> None:
        if FirmwareBug.CORRUPTED_LIMITS in self.present:
            self._corrupt()

    def switched_on(self) -> None:
        """Starts again after a power cycle."""
        self.silent = self._handle_set = False
        self._on_s = self._powered_s = 0.0
        self.applier.find_place(but=self.lost.joints)

    def reset(self) -> None:
        """Clears what 0x150 resume repairs: a joint that had lost its position reports it again."""
        self._powered_s = 0.0
        self.applier.find_place()

    def setting_taken(self, name: str) -> None:
        """Handles a setting: 0x47D repairs what the teaching handle's level had broken."""
        self._handle_set = self._handle_set or name == "TeachingSetting"

    def time_passed(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds."""
        if not self.present:
            return
        self._on_s += dt_s
        self._powered_s = self._powered_s + dt_s if all(self.mechanics.powered) else 0.0
        if FirmwareBug.FEEDBACK_PARTS in self.present and self._powered_s > _SLIPS_AFTER_S:
            self.applier.slip(_SLIPPING, -_SLIP_DEG_S * dt_s, most_deg=_MOST_SLIP_DEG)
        role = self.settings.linkage.role
        if (
            FirmwareBug.FALLS_BACK_TO_LEADER in self.present
            and self._on_s > _LEADS_AFTER_S
            and role is not LinkageRole.TEACHING_INPUT
        ):
            self._on_s = 0.0
            self.lead(self.settings.linkage._replace(role=LinkageRole.TEACHING_INPUT))

    def mode_word(self, *, was_direct: bool) -> None:
        """Handles a mode word that the arm has accepted."""
        condition = self.condition
        if FirmwareBug.MIT_MOVES_ZERO in self.present and was_direct and not condition.direct:
            condition.needs_reset = True
            self.applier.move_zero(0, _ZERO_MOVES_DEG)

    def role_set(self, role: LinkageRole) -> None:
        """Handles a 0x470."""
        if FirmwareBug.SILENT_LEADER in self.present and role is LinkageRole.TEACHING_INPUT:
            self.silent = True

    def distorted(self, names: list[str], frames: list[Frame]) -> list[Frame]:
        """Return the feedback that the arm sends instead of these frames."""
        if FirmwareBug.ZERO_FEEDBACK not in self.present or self._handle_set:
            return frames
        return [
            each._replace(data=bytes(len(each.data))) if name.startswith(_TOLD_ZERO) else each
            for name, each in zip(names, frames, strict=True)
        ]

    def _corrupt(self) -> None:
        for joint in JOINTS:
            self.corrupt_limits(joint)
        limits = self.settings.limits
        limits[:] = [each._replace(min_deg=_BAD_DEG, max_deg=_BAD_DEG) for each in limits]
