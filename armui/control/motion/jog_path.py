"""Paths of jogs: joints that turn, or the tool centre point along or about an axis."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Protocol

from armui.arm.limits import JOINTS, JointLimits, check_joints
from armui.arm.refusal import Reason, Refusal
from armui.cell.user_frames import UserFrame
from armui.kinematics import poses
from armui.kinematics.axes import AXES, LINEAR_AXES, JogFrame
from armui.kinematics.poses import shifted, tool_matrix

if TYPE_CHECKING:
    from armui.control.motion.jog_pace import Pace
    from armui.kinematics.arm_kinematics import Kinematics
    from armui.kinematics.poses import JogAxes, Matrix

JOG_AT_LIMIT = Reason("jog_at_limit", "J{joint} is at its limit of {limit}°. Jog the other way.")
JOG_OUT_OF_REACH = Reason(
    "jog_out_of_reach", "The arm can reach no further this way. Jog in another direction."
)


TOOL_MM_S: Final = 60.0
TOOL_DEG_S: Final = 12.0
"""Highest jog speeds of the tool centre point. Where a joint would have to turn faster than it may
be jogged, the tool goes slower."""

_NOWHERE_DEG: Final = float("inf")


MotionFrame = JogFrame | UserFrame
"""The frame whose axes a jog or a step follows: the base's, the tool's, or a user frame's."""


@dataclass(frozen=True, slots=True)
class JointJog:
    """A joint, 1–6, and its direction, +1 or −1."""

    joint: int
    direction: int

    @property
    def rates(self) -> tuple[float, ...]:
        """The rates of the six joints: its direction for this one, 0 for the others."""
        return tuple(float(self.direction) if each == self.joint else 0.0 for each in JOINTS)


@dataclass(frozen=True, slots=True)
class ToolJog:
    """An axis, 0–5 for X, Y, Z, RX, RY, RZ, its direction, +1 or −1, and its frame."""

    axis: int
    direction: int
    frame: MotionFrame


class JogPath(Protocol):
    """The path of a jog as a function of the distance gone, in mm or degrees."""

    def speed(self, pace: Pace) -> float:
        """Return the speed along the path, in mm/s or °/s."""
        ...

    def room(self) -> float:
        """Return the distance to the end of the path, in mm or degrees."""
        ...

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """Return six angles at a distance along the path, or why it cannot be gone so far."""
        ...

    def why_no_further(self) -> Refusal:
        """Return the reason to give at its end."""
        ...


class JointJogPath:
    """Joints that turn together, each at its rate, until one is at its limit.

    Args:
        rates: Six, −1 to 1, not all 0.
        base_deg: Six angles to begin with.
        limits: The limits of the six joints.
    """

    def __init__(
        self, rates: Sequence[float], base_deg: Sequence[float], limits: Sequence[JointLimits]
    ) -> None:
        self._base_deg = tuple(base_deg)
        self._limits = tuple(limits)
        self._most = max(map(abs, rates))
        self._ways = tuple(rate / self._most for rate in rates)

    def speed(self, pace: Pace) -> float:
        """Return the speed of the joint with the highest rate; the others keep their share."""
        speeds = zip(pace.speeds_deg_s, self._ways, strict=True)
        return self._most * min(speed for speed, way in speeds if way)

    def room(self) -> float:
        """Return the angle to the first limit, in degrees of the fastest joint."""
        return min(self._room_of(place) for place in range(len(self._ways)))

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...]:  # noqa: ARG002 - one way only
        """Return six angles after the fastest joint has turned by so many degrees."""
        return tuple(
            base + way * gone for base, way in zip(self._base_deg, self._ways, strict=True)
        )

    def why_no_further(self) -> Refusal:
        """Return the nearest limit as a reason."""
        place = min(range(len(self._ways)), key=self._room_of)
        return JOG_AT_LIMIT(joint=place + 1, limit=self._bound_deg(place))

    def _room_of(self, place: int) -> float:
        way = self._ways[place]
        if not way:
            return _NOWHERE_DEG
        return (self._bound_deg(place) - self._base_deg[place]) / way

    def _bound_deg(self, place: int) -> float:
        bounds = self._limits[place]
        return bounds.max_deg if self._ways[place] > 0 else bounds.min_deg


class HeldToolPath:
    """The common base of the tool's paths, which lead as far as the arm reaches.

    Args:
        kinematics: The arm's kinematics.
        base_deg: Six angles to begin with.
        tool: The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        limits: The limits of the six joints.
    """

    def __init__(
        self,
        kinematics: Kinematics,
        base_deg: Sequence[float],
        tool: Sequence[float],
        limits: Sequence[JointLimits],
    ) -> None:

        self._kinematics = kinematics
        self._tool = tuple(tool)
        self._limits = tuple(limits)
        self._start: Matrix = tool_matrix(kinematics.matrix(base_deg), self._tool)

    def room(self) -> float:
        """Return infinity: the reach is found out on the way."""
        return float("inf")

    def why_no_further(self) -> Refusal:
        """Return the end of the arm's reach as a reason."""
        return JOG_OUT_OF_REACH()

    def _joints_of(self, target: Matrix, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """Return the solution nearest to ``near_deg``, or why there is none."""
        pose = poses.matrix_to_pose(poses.flange_matrix(target, self._tool))
        solutions = self._kinematics.inverse(pose, near_deg)
        if not solutions:
            return self.why_no_further()
        beyond = check_joints(solutions[0], self._limits)
        return solutions[0] if beyond is None else at_limit(beyond)


class ToolJogPath(HeldToolPath):
    """The path of the tool centre point straight along an axis, or turning about one.

    Args:
        jog: The axis and its direction; for the others see :class:`HeldToolPath`.
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
        self._axes = axes_of(jog.frame)

    def speed(self, pace: Pace) -> float:
        """Return the tool's speed at the present speed percentage."""
        return pace.share * (TOOL_MM_S if self._jog.axis < LINEAR_AXES else TOOL_DEG_S)

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """Return the solution nearest to ``near_deg``, or why there is none."""
        jog = self._jog
        target = shifted(self._start, jog.axis, jog.direction * gone, self._axes)
        return self._joints_of(target, near_deg)


def axes_of(frame: MotionFrame) -> JogAxes:
    """Return what :func:`armui.kinematics.poses.moved` takes for a frame."""
    if isinstance(frame, UserFrame):
        rotation: Matrix = poses.pose_to_matrix(frame.pose)[:3, :3]
        return rotation
    return frame


def axis_in(frame: MotionFrame, axis: int) -> str:
    """Return the name of an axis, 0–5; that of a user frame names it, as X (table)."""
    return f"{AXES[axis]} ({frame.name})" if isinstance(frame, UserFrame) else AXES[axis]


def at_limit(beyond: Refusal) -> Refusal:
    """Return the reason for a jog to end at a limit that its next angles would exceed."""
    bound = "minimum" if beyond.params["value"] < beyond.params["minimum"] else "maximum"  # type: ignore[operator]  # both are angles
    return JOG_AT_LIMIT(joint=beyond.params["joint"], limit=beyond.params[bound])
