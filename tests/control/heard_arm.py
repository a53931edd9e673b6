"""An arm as the authority hears it, moment by moment."""

from __future__ import annotations

import enum
from typing import Any

from armui.arm.limits import JointLimits
from armui.arm.other_hosts import OtherHosts
from armui.arm.state import ArmState, DriverFast, DriverSlow, Reading, Status
from armui.control.authority import Authority
from armui.control.motion.motion_command import CommandKind, Observation
from armui.protocol.codes import ArmStatusCode, ControlMode, MoveMode
from tests.ui.arm_states import heard_six

START_S = 0.25
HERE = (0.0, 10.0, -10.0, 0.0, 0.0, 0.0)
THERE = (40.0, 10.0, -10.0, 0.0, 0.0, 0.0)
NOWHERE = (20.0, 10.0, -10.0, 0.0, 0.0, 0.0)


NORMAL = Status(
    control_mode=int(ControlMode.CAN_CONTROL),
    arm_status=int(ArmStatusCode.NORMAL),
    move_mode=int(MoveMode.MOVE_J),
    teaching=0,
    reached=True,
    speed_percent=None,
    trajectory_point=None,
    limit_exceeded=(False,) * 6,
    communication_fault=(False,) * 6,
)


def status(**changes) -> Status:
    """What 0x2A1 says; the codec gives codes as plain numbers."""
    plain: dict[str, Any] = {
        name: int(each) if isinstance(each, enum.IntEnum) else each
        for name, each in changes.items()
    }
    return NORMAL._replace(**plain)


DRIVER = DriverSlow(24.0, 30.0, 30.0, 0.0, *(False,) * 5, True, None, None, False, False)


class Arm:
    """An arm as heard, moment by moment.

    Attributes:
        silent: What of it is not heard: ``status``, ``joints`` or ``drivers``.
        waiting: Frames of ours have not left yet.
        driver_deg_s: The speed that each driver reports.
    """

    def __init__(self) -> None:
        self.now_s = START_S
        self.joints_deg = HERE
        self.status = status()
        self.enabled = True
        self.driver_deg_s = 0.0
        self.silent: set[str] = set()
        self.hosts = OtherHosts()
        self.limits: JointLimits | None = None
        self.offsets = (0,)
        self.online = True
        self.waiting = False
        self.authority = Authority()
        self._status = Reading(self.status, self.now_s)
        self._joints = heard_six(HERE, self.now_s)
        self.wait(0.5)

    def look(self) -> None:
        """Observe once."""
        now_s = self.now_s
        if "status" not in self.silent:
            self._status = Reading(self.status, now_s)
        if "joints" not in self.silent:
            self._joints = heard_six(self.joints_deg, now_s)
        driver = Reading(DRIVER._replace(enabled=self.enabled), now_s)
        limits = None if self.limits is None else Reading(self.limits, now_s)
        state = ArmState(
            last_feedback_s=now_s,
            status=self._status,
            joints_deg=self._joints,
            drivers_fast=(Reading(DriverFast(self.driver_deg_s, 0.0, None), now_s),) * 6,
            drivers_slow=(None if "drivers" in self.silent else driver,) * 6,
            limits=(limits,) * 6,
        )
        traffic = self.hosts.traffic()
        self.authority.observe(
            Observation(state, traffic, self.offsets, self.online, now_s, self.waiting)
        )

    def wait(self, seconds: float) -> None:
        """Observe every 20 ms for so long."""
        for _ in range(round(seconds / 0.02)):
            self.now_s += 0.02
            self.look()

    def send(
        self,
        target=THERE,
        kind=CommandKind.JOINTS,
        percent=30,
        mode=MoveMode.MOVE_J,
        tool=None,
        pace=None,
    ):
        """A command of ours."""
        return self.authority.begin(
            kind,
            now_s=self.now_s,
            move_mode=mode,
            speed_percent=percent,
            joints_deg=target,
            tool=tool,
            pace=pace,
        )

    def turn(self, steps: int, deg: float = 1.0) -> None:
        """Joint 1 turns so far every 20 ms."""
        for _ in range(steps):
            self.joints_deg = (self.joints_deg[0] + deg, *self.joints_deg[1:])
            self.wait(0.02)

    def move(self) -> None:
        """It is on its way, and says so."""
        self.status = status(reached=False)
        self.turn(5)

    def meet(self) -> None:
        """This program comes while the arm is on its way to a target of somebody else."""
        self.authority = Authority()
        self.move()

    def cancel(self) -> None:
        """The arm is told to end its motion."""
        self.authority.cancelled(self.now_s)

    def take_over(self) -> None:
        """Another host moves it for a moment, and the operator takes it over."""
        self.other()
        self.turn(30)
        assert self.authority.take_over() is None

    def arrive(self, target=THERE) -> None:
        """The arm gets there and rests."""
        self.status = status(reached=False)
        self.wait(0.2)
        self.joints_deg, self.status = target, status()
        self.wait(0.6)

    def other(self, arbitration_id=0x155, data=bytes(8)) -> None:
        """Another host says something."""
        self.hosts.note(arbitration_id, data, self.now_s)
