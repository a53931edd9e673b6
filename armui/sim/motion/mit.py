"""MIT control and high-follow: 0x151 byte 3 = 0xAD hands the joints to their drivers' own loop.

The code of MIT, the signs of its commands, the scale of its torques and the way out of it are those
of the arm's firmware and model (`firmware_version`). The rest follows reports of single users that
no text of the maker denies, in their worst reading: every mode word that arrives while 0xAD is in
force, or that brings it, voids the setpoints; each joint is limp, though powered, until its next
one. That is a frame 0x15A–0x15F in MIT, a complete joint target in high-follow, and in the MOVE
modes without 0xAD the next target of any kind, which the joints take up from where they have fallen
to. Before S-V1.8-5 no target is taken up there: the arm stays limp until it is reset. A joint that
is switched on in MIT or high-follow is limp until its setpoint, too.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

from armui.arm.limits import JOINTS
from armui.protocol.codes import ControlMode, MitMode, MoveMode
from armui.sim.arm_type import ArmType
from armui.sim.condition import Condition
from armui.sim.mechanics.driver_loop import DriverSetpoint
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues

NAMES: Final = tuple(f"MitControl{joint}" for joint in JOINTS)
"""The frames 0x15A–0x15F, joint 1 first."""

_FOLLOW_GAINS: Final = ((50.0, 2.5),) * 3 + ((20.0, 1.0),) * 3
"""kp and kd of high-follow, which are not published: with the simulated arm's friction they lag a
triangle of 1.2 rad/s by 0.089 rad, as a user measured."""


class DirectControl:
    """Joints that follow setpoints in their drivers, without a plan."""

    def __init__(self, mechanics: Mechanics, condition: Condition, arm_type: ArmType) -> None:
        self._mechanics = mechanics
        self._condition = condition
        self._quirks = arm_type.quirks
        self._torque_scale = arm_type.mit_torque_scale

    def mode_word(self, signals: dict[str, float]) -> None:
        """Takes a 0x151 that the arm has accepted; its modes are in the condition already."""
        condition = self._condition
        was_direct = condition.direct
        condition.direct = (
            signals.get("MitMode") == MitMode.MIT
            and condition.control_mode is ControlMode.CAN_CONTROL
            and condition.move_mode in (self._quirks.mit_code, MoveMode.MOVE_J)
        )
        if condition.direct:
            condition.needs_reset = False
        elif was_direct:
            condition.needs_reset = not self._quirks.exits_by_mode_word
        if was_direct or condition.direct:
            self._mechanics.let_go(range(JOINT_COUNT))

    def take(self, name: str, signals: dict[str, float]) -> bool:
        """Takes a frame 0x15A–0x15F; whether it was one. Outside MIT it does nothing."""
        if name not in NAMES:
            return False
        condition = self._condition
        if condition.direct and condition.move_mode == self._quirks.mit_code:
            self._set(NAMES.index(name), signals)
        return True

    def follow(self, target_deg: SixValues) -> None:
        """Hands a complete joint target of high-follow to the drivers."""
        for index, angle_deg in enumerate(target_deg):
            kp, kd = _FOLLOW_GAINS[index]
            setpoint = DriverSetpoint(angle_deg, kp=kp, kd=kd, carries_weight=True)
            self._mechanics.steer(index, setpoint)

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors; in MIT and high-follow those that had none are limp."""
        if not self._condition.direct:
            self._mechanics.power_on(indices)
            return
        off = [index for index in indices if not self._mechanics.powered[index]]
        self._mechanics.power_on(off)
        self._mechanics.let_go(off)

    def _set(self, index: int, signals: dict[str, float]) -> None:
        sign = self._quirks.mit_signs[index]
        setpoint = DriverSetpoint(
            sign * math.degrees(signals["Position"]),
            sign * signals["Velocity"],
            signals["Kp"],
            signals["Kd"],
            sign * signals["Torque"] * self._torque_scale[index],
        )
        self._mechanics.steer(index, setpoint)
