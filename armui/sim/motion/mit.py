"""MIT control and high-follow: 0x151 byte 3 = 0xAD hands the joints to their drivers' own loop.

This follows reports of single users that no text of the maker denies, in their worst reading:
every mode word that arrives while 0xAD is in force, or that brings it, voids the setpoints; each
joint is limp, though powered, until its next one. That is a frame 0x15A–0x15F in MIT, a complete
joint target in high-follow, and in the MOVE modes without 0xAD the next target of any kind, which
the joints take up from where they have sunk to. A joint that is switched on in MIT or high-follow
is limp until then, too.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

from armui.arm.limits import JOINTS
from armui.protocol.codes import ControlMode, MitMode, MoveMode
from armui.sim.condition import Condition
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues
from armui.sim.mechanics.unpowered_joints import UnpoweredJoints

NAMES: Final = tuple(f"MitControl{joint}" for joint in JOINTS)
"""The frames 0x15A–0x15F, joint 1 first."""

_DAMPING_KD: Final = 0.1
"""From this gain on a joint that is not held sinks, damped; with less it falls."""


class DirectControl:
    """Joints that follow setpoints in their drivers, without a plan."""

    def __init__(self, mechanics: Mechanics, condition: Condition) -> None:
        self._body = mechanics
        self._condition = condition

    def mode_word(self, signals: dict[str, float]) -> None:
        """Takes a 0x151 that the arm has accepted; its modes are in the condition already."""
        condition = self._condition
        was_direct = condition.direct
        condition.direct = (
            signals.get("MitMode") == MitMode.MIT
            and condition.control_mode is ControlMode.CAN_CONTROL
            and condition.move_mode in (MoveMode.MOVE_M, MoveMode.MOVE_J)
        )
        if was_direct or condition.direct:
            self._body.let_go(range(JOINT_COUNT), UnpoweredJoints.FREE)

    def take(self, name: str, signals: dict[str, float]) -> bool:
        """Takes a frame 0x15A–0x15F; whether it was one. Outside MIT it does nothing."""
        if name not in NAMES:
            return False
        condition = self._condition
        if condition.direct and condition.move_mode is MoveMode.MOVE_M:
            self._set(NAMES.index(name), signals)
        return True

    def follow(self, target_deg: SixValues) -> None:
        """Hands a complete joint target of high-follow to the drivers."""
        for index, angle_deg in enumerate(target_deg):
            self._body.steer(index, angle_deg)

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors; in MIT and high-follow those that had none are limp."""
        if not self._condition.direct:
            self._body.power_on(indices)
            return
        off = [index for index in indices if not self._body.powered[index]]
        self._body.power_on(off)
        self._body.let_go(off, UnpoweredJoints.FREE)

    def _set(self, index: int, signals: dict[str, float]) -> None:
        if signals["Kp"] > 0.0:
            self._body.steer(index, math.degrees(signals["Position"]))
        else:
            unpowered = (
                UnpoweredJoints.DAMPED if signals["Kd"] >= _DAMPING_KD else UnpoweredJoints.FREE
            )
            self._body.let_go((index,), unpowered)
