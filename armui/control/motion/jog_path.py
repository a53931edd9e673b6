"""Where a jog leads: one joint turning, or the tool centre point on a straight line or turning."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Protocol

from armui.arm.limits import JointLimits, check_joints
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.kinematics.axes import LINEAR_AXES, JogFrame

if TYPE_CHECKING:
    from armui.control.motion.jog_pace import Pace
    from armui.kinematics.arm_kinematics import Kinematics
    from armui.kinematics.poses import Matrix

TOOL_MM_S: Final = 60.0
TOOL_DEG_S: Final = 12.0
"""Highest jog speeds of the tool centre point. Where a joint would have to turn faster than it may
be jogged, the tool goes slower."""


@dataclass(frozen=True, slots=True)
class JointJog:
    """A joint, 1–6, and the direction, +1 or −1."""

    joint: int
    direction: int


@dataclass(frozen=True, slots=True)
class ToolJog:
    """An axis, 0–5 for X, Y, Z, RX, RY, RZ, the direction, +1 or −1, and whose axis it is."""

    axis: int
    direction: int
    frame: JogFrame


class JogPath(Protocol):
    """The way of a jog, by how far it has gone, in mm or degrees."""

    def speed(self, pace: Pace) -> float:
        """How fast to go along it, in mm/s or °/s."""
        ...

    def room(self) -> float:
        """How far it leads."""
        ...

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """Six angles at a place of the way, or why it cannot be gone so far."""
        ...

    def end(self) -> Refusal:
        """What to say at its end."""
        ...


class JointJogPath:
    """One joint turns to its limit; the others stay.

    Args:
        jog: Which joint, and where to.
        base_deg: Six angles to begin with.
        limits: Of the six joints.
    """

    def __init__(
        self, jog: JointJog, base_deg: Sequence[float], limits: Sequence[JointLimits]
    ) -> None:
        self._jog = jog
        self._base_deg = tuple(base_deg)
        bounds = limits[jog.joint - 1]
        self._bound_deg = bounds.max_deg if jog.direction > 0 else bounds.min_deg

    def speed(self, pace: Pace) -> float:
        """That of the joint."""
        return pace.speeds_deg_s[self._jog.joint - 1]

    def room(self) -> float:
        """To the limit; none for a joint that is beyond it already."""
        return self._jog.direction * (self._bound_deg - self._base_deg[self._jog.joint - 1])

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...]:  # noqa: ARG002 - one way only
        """The joint turned so far."""
        place = self._jog.joint - 1
        turned = self._base_deg[place] + self._jog.direction * gone
        return (*self._base_deg[:place], turned, *self._base_deg[place + 1 :])

    def end(self) -> Refusal:
        """The limit."""
        return Refusal(
            RefusalCode.JOG_AT_LIMIT, {"joint": self._jog.joint, "limit": self._bound_deg}
        )


class HeldToolPath:
    """What the ways of the tool centre point share: they are gone as far as the arm reaches.

    Args:
        kinematics: Of the arm.
        base_deg: Six angles to begin with.
        tool: The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        limits: Of the six joints.
    """

    def __init__(
        self,
        kinematics: Kinematics,
        base_deg: Sequence[float],
        tool: Sequence[float],
        limits: Sequence[JointLimits],
    ) -> None:
        from armui.kinematics.poses import tool_matrix  # noqa: PLC0415 - numpy, loaded when asked for

        self._kinematics = kinematics
        self._tool = tuple(tool)
        self._limits = tuple(limits)
        self._start: Matrix = tool_matrix(kinematics.matrix(base_deg), self._tool)

    def room(self) -> float:
        """As far as the arm reaches: that is found out on the way."""
        return float("inf")

    def end(self) -> Refusal:
        """The edge of the arm's reach."""
        return Refusal(RefusalCode.JOG_OUT_OF_REACH)

    def _joints_of(self, target: Matrix, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """The solution nearest to ``near_deg``, or why there is none."""
        from armui.kinematics import poses  # noqa: PLC0415 - see above

        pose = poses.matrix_to_pose(poses.flange_matrix(target, self._tool))
        solutions = self._kinematics.inverse(pose, near_deg)
        if not solutions:
            return self.end()
        beyond = check_joints(solutions[0], self._limits)
        return solutions[0] if beyond is None else at_limit(beyond)


class ToolJogPath(HeldToolPath):
    """The tool centre point goes straight along an axis, or turns about one.

    Args:
        jog: Which axis, and where to; for the others see :class:`HeldToolPath`.
    """

    def __init__(
        self,
        jog: ToolJog,
        kinematics: Kinematics,
        base_deg: Sequence[float],
        tool: Sequence[float],
        limits: Sequence[JointLimits],
    ) -> None:
        super().__init__(kinematics, base_deg, tool, limits)
        self._jog = jog

    def speed(self, pace: Pace) -> float:
        """The tool's, at the present speed percentage."""
        return pace.share * (TOOL_MM_S if self._jog.axis < LINEAR_AXES else TOOL_DEG_S)

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """The solution nearest to ``near_deg``, or why there is none."""
        from armui.kinematics.poses import shifted  # noqa: PLC0415 - see above

        jog = self._jog
        target = shifted(self._start, jog.axis, jog.direction * gone, jog.frame)
        return self._joints_of(target, near_deg)


def at_limit(beyond: Refusal) -> Refusal:
    """What to say of a jog at the limit that six angles would be beyond."""
    bound = "minimum" if beyond.params["value"] < beyond.params["minimum"] else "maximum"  # type: ignore[operator]  # both are angles
    return Refusal(
        RefusalCode.JOG_AT_LIMIT,
        {"joint": beyond.params["joint"], "limit": beyond.params[bound]},
    )
