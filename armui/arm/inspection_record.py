"""The findings of joint inspections and resumes of an arm, and which of them are notable."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from statistics import median
from typing import Final

from armui.arm.json_fields import finite
from armui.arm.limits import JOINTS

KEPT: Final = 10
"""The number of inspections, and of resumes, that are kept of each arm."""
SLIP_DEG: Final = 1.0
"""A slip at a resume is reported from this angle on."""
_LONGEST_TEXT: Final = 64
_MOST: Final = 1e4


@dataclass(frozen=True, slots=True)
class JointFigures:
    """What the swing of one joint has shown.

    Attributes:
        behind_deg: The lag behind its setpoint at an even speed, in degrees.
        bears_a: The motor's current that is the same both ways: what it bears.
        current_a: The current that turns round with it: what it takes to turn the joint; ``None``
            where the arm tells no sign of its currents.
        motor_c, driver_c: The highest temperatures in °C; ``None`` if none was heard.
    """

    behind_deg: float
    bears_a: float
    current_a: float | None = None
    motor_c: float | None = None
    driver_c: float | None = None


@dataclass(frozen=True, slots=True)
class InspectionEntry:
    """A joint inspection.

    Attributes:
        at: The local time of its end, ISO 8601.
        speed_deg_s: The speed of the swings.
        joints: What each joint has shown, joint 1 first; ``None`` if it was not measured.
    """

    at: str
    speed_deg_s: float
    joints: tuple[JointFigures | None, ...]


@dataclass(frozen=True, slots=True)
class ResumeEntry:
    """A resume (0x150), and by how much the feedback of each joint jumped with it.

    Attributes:
        at: The local time, ISO 8601.
        slips_deg: Of each joint, joint 1 first; ``None`` if too little was heard to tell.
    """

    at: str
    slips_deg: tuple[float | None, ...]

    @property
    def slipped(self) -> dict[int, float]:
        """The joints (1–6) that slipped by at least :data:`SLIP_DEG`, each with its degrees."""
        found = zip(JOINTS, self.slips_deg, strict=True)
        return {joint: deg for joint, deg in found if deg is not None and abs(deg) >= SLIP_DEG}

    @property
    def text(self) -> str:
        """The slips as text, like ``J1 -5.0°, J2 +1.0°``; empty if nothing slipped."""
        return ", ".join(f"J{joint} {deg:+.1f}°" for joint, deg in self.slipped.items())


def read_inspections(entries: object) -> tuple[InspectionEntry, ...]:
    """Return the inspections in JSON entries; those that are not understood are left out."""
    found = []
    for entry in entries if isinstance(entries, list | tuple) else ():
        at, joints = _head(entry, "joints")
        speed_deg_s = _figure(entry.get("speed_deg_s")) if at else None
        figures = [None if each is None else _read_figures(each) for each in joints]
        if at and speed_deg_s is not None and len(figures) == len(JOINTS):
            found.append(InspectionEntry(at, speed_deg_s, tuple(figures)))
    return tuple(found[-KEPT:])


def read_resumes(entries: object) -> tuple[ResumeEntry, ...]:
    """Return the resumes in JSON entries; those that are not understood are left out."""
    found = []
    for entry in entries if isinstance(entries, list | tuple) else ():
        at, slips = _head(entry, "slips_deg")
        if at and len(slips) == len(JOINTS):
            found.append(ResumeEntry(at, tuple(map(_figure, slips))))
    return tuple(found[-KEPT:])


def _head(entry: object, name: str) -> tuple[str, Sequence[object]]:
    """Return the time of an entry, "" if it is none, and the list of that name."""
    if not isinstance(entry, Mapping):
        return "", ()
    at, values = entry.get("at"), entry.get(name)
    if not isinstance(at, str) or len(at) > _LONGEST_TEXT or not isinstance(values, list | tuple):
        return "", ()
    return at, values


def _figure(value: object) -> float | None:
    figure = finite(value)
    return figure if figure is not None and abs(figure) <= _MOST else None


def _read_figures(entry: object) -> JointFigures | None:
    if not isinstance(entry, Mapping):
        return None
    found = {each.name: _figure(entry.get(each.name)) for each in fields(JointFigures)}
    behind_deg, bears_a = found.pop("behind_deg"), found.pop("bears_a")
    if behind_deg is None or bears_a is None:
        return None
    return JointFigures(behind_deg, bears_a, **found)


# Notable figures ----------------------------------------------------------------------------------


class JointSign(enum.StrEnum):
    """The figures of `JointFigures` that may be notable."""

    BEHIND = "behind_deg"
    CURRENT = "current_a"
    MOTOR = "motor_c"
    DRIVER = "driver_c"


@dataclass(frozen=True, slots=True)
class JointFinding:
    """A notable figure of a joint.

    Attributes:
        joint: The joint (1–6).
        sign: The figure.
        value: The measured value.
        usual: The value it was compared with.
        earlier: True if that is the joint's own, of earlier; false if it is that of its peers.
    """

    joint: int
    sign: JointSign
    value: float
    usual: float
    earlier: bool


_PEERS: Final = {
    JointSign.BEHIND: (JOINTS,),
    JointSign.CURRENT: ((1, 2, 3), (4, 5, 6)),  # large and small motors
    JointSign.MOTOR: (JOINTS,),
    JointSign.DRIVER: (JOINTS,),
}
"""The joints that are compared with each other."""
_AGAINST_PEERS: Final = {
    JointSign.BEHIND: (1.5, 0.15),
    JointSign.CURRENT: (2.0, 0.15),
    JointSign.MOTOR: (1.0, 15.0),
    JointSign.DRIVER: (1.0, 15.0),
}
"""A figure is notable above this factor times its peers', plus this offset."""
_AGAINST_EARLIER: Final = {JointSign.BEHIND: (1.3, 0.1), JointSign.CURRENT: (1.5, 0.1)}
"""The same against the joint's earlier figures; not temperatures, which depend on the work
before."""
_SAME_SPEED: Final = 1.25
"""An inspection at a speed that differs by a greater factor is not compared."""


def findings(now: InspectionEntry, earlier: Iterable[InspectionEntry]) -> tuple[JointFinding, ...]:
    """Return the notable figures by joint, compared with other joints and earlier inspections."""
    before = [each for each in earlier if _alike(each.speed_deg_s, now.speed_deg_s)]
    found = []
    for joint in JOINTS:
        for sign in JointSign:
            value = _of(now, joint, sign)
            if value is None:
                continue
            group = next(each for each in _PEERS[sign] if joint in each)
            peers = [_of(now, each, sign) for each in group if each != joint]
            own = [_of(each, joint, sign) for each in before]
            for others, bounds, is_earlier in (
                (peers, _AGAINST_PEERS, False),
                (own, _AGAINST_EARLIER, True),
            ):
                known = [each for each in others if each is not None]
                times, more = bounds.get(sign, (1.0, float("inf")))
                least = 1 if is_earlier else 2
                if (
                    len(known) >= least
                    and value > times * (usual := max(0.0, median(known))) + more
                ):
                    found.append(JointFinding(joint, sign, value, usual, is_earlier))
    return tuple(found)


def _alike(one: float, other: float) -> bool:
    return max(one, other) <= _SAME_SPEED * min(one, other)


def _of(entry: InspectionEntry, joint: int, sign: JointSign) -> float | None:
    figures = entry.joints[joint - 1]
    if figures is None:
        return None
    value: float | None = getattr(figures, sign)
    return value
