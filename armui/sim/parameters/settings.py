"""The values an arm keeps, with the factory's values as defaults."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import Annotated, NamedTuple

from armui.arm.limits import JOINTS, JointLimits
from armui.arm.models import model_data
from armui.protocol.codes import EndLoad, LinkageRole
from armui.protocol.generation import PiperModel


class HandleSettings(NamedTuple):
    """Settings of the teaching handle, and the gripper's stroke (0x47D)."""

    range_percent: Annotated[int, "TeachingRange"] = 100
    stroke_limit_mm: Annotated[int, "StrokeLimit"] = 70
    friction: Annotated[int, "Friction"] = 1


class Light(NamedTuple):
    """The last colour a joint's lamps were given (0x121), with the count the host gave it."""

    lamp: int
    red: int
    green: int
    blue: int
    counter: int = 0


class LinkageSettings(NamedTuple):
    """The role beside another arm, and the identifier offsets (0x470)."""

    role: LinkageRole = LinkageRole.MOTION_OUTPUT
    feedback_offset: int = 0
    control_offset: int = 0
    target_offset: int = 0


def factory_settings(model: PiperModel) -> ArmSettingsRecord:
    """Return the limits and accelerations that a model leaves the factory with."""
    data = model_data(model)
    return ArmSettingsRecord(
        limits=list(data.limits), accelerations_deg_s2=list(data.accelerations_deg_s2)
    )


@dataclass(slots=True)
class ArmSettingsRecord:
    """The values an arm keeps, by default the factory values of a PiPER.

    Attributes:
        limits: Angles and speeds, joint 1 first.
        accelerations_deg_s2: Highest accelerations, joint 1 first.
        end_limits: Linear speed m/s, angular speed rad/s, and their accelerations.
        collision_levels: 0–8 for each joint.
        load: The load at the flange, as set by the host.
        teaching: The teaching handle, generation 2.
        drag_assistance: 0–10 for each joint, from S-V1.8-1.
        linkage: Role and identifier offsets.
        zeros_deg: Each joint's zero, counted from the factory's.
        lights: The lamps, by joint; dark again after a power cycle.
    """

    limits: list[JointLimits] = field(default_factory=lambda: list(model_data().limits))
    accelerations_deg_s2: list[float] = field(
        default_factory=lambda: list(model_data().accelerations_deg_s2)
    )
    end_limits: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0)
    collision_levels: tuple[int, ...] = (1,) * 6
    load: EndLoad = EndLoad.EMPTY
    teaching: HandleSettings = field(default_factory=HandleSettings)
    drag_assistance: tuple[int, ...] = (5,) * 6
    linkage: LinkageSettings = field(default_factory=LinkageSettings)
    zeros_deg: list[float] = field(default_factory=lambda: [0.0] * len(JOINTS))
    lights: dict[int, Light] = field(default_factory=dict)

    def take_over(self, other: ArmSettingsRecord) -> None:
        """Copies all values of another record into this object, which the arm's parts share."""
        for each in fields(self):
            setattr(self, each.name, getattr(other, each.name))
