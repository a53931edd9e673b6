"""The values an arm keeps, as it leaves the factory."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from armui.arm.limits import FACTORY_ACCELERATION_DEG_S2, FACTORY_LIMITS, JOINTS, JointLimits
from armui.protocol.codes import EndLoad


class TeachingHandle(NamedTuple):
    """How drag teaching feels, and the gripper's stroke (0x47D)."""

    range_percent: int = 100
    stroke_limit_mm: int = 70
    friction: int = 1


class Light(NamedTuple):
    """The last colour a joint's lamps were given (0x121)."""

    lamp: int
    red: int
    green: int
    blue: int


def factory_accelerations() -> list[float]:
    """Highest acceleration of each joint as the arm leaves the factory, in °/s²."""
    return [FACTORY_ACCELERATION_DEG_S2] * len(JOINTS)


@dataclass(slots=True)
class Settings:
    """What the arm keeps, with the values it leaves the factory with.

    Attributes:
        limits: Angles and speeds, joint 1 first.
        accelerations_deg_s2: Highest accelerations, joint 1 first.
        end_limits: Linear speed m/s, angular speed rad/s, and their accelerations.
        collision_levels: 0–8 a joint.
        load: What the flange carries.
        teaching: The teaching handle, generation 2.
        lights: The lamps, by joint.
    """

    limits: list[JointLimits] = field(default_factory=lambda: list(FACTORY_LIMITS))
    accelerations_deg_s2: list[float] = field(default_factory=factory_accelerations)
    end_limits: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0)
    collision_levels: tuple[int, ...] = (1,) * 6
    load: EndLoad = EndLoad.EMPTY
    teaching: TeachingHandle = field(default_factory=TeachingHandle)
    lights: dict[int, Light] = field(default_factory=dict)
