"""The arms of the family as data: one file each, `urdf/<model>/model.json`.

Whatever differs between the models of one protocol stands there and nowhere else: dimensions,
ranges, torque coefficients, masses, how the gripper is mounted. What differs with the firmware
stands in `armui.protocol.firmware_version`.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, NamedTuple

from armui.arm.json_fields import FieldError, Fields
from armui.arm.limits import JointLimits
from armui.kinematics.geometry import Geometry, GeometryError
from armui.protocol.firmware_version import FirmwareVersion, quirks_of
from armui.protocol.generation import PiperModel
from armui.system.files import read_file
from armui.system.paths import URDF

if TYPE_CHECKING:
    from armui.arm.state import EndLimits
    from armui.kinematics.arm_kinematics import Kinematics

FORMAT: Final = 1
LINK_NAMES: Final = ("base_link", *(f"link{joint}" for joint in range(1, 7)))
_SIX: Final = (6,)
_SPEEDS: Final = {"known": False, "assumed": True}


class ModelFileError(Exception):
    """A model's data file that is missing or wrong; names the file and the field."""


class LinkMass(NamedTuple):
    """The mass of a link.

    Attributes:
        name: Of the link in the robot description.
        mass_kg: Of the link.
        centre_mm: Its centre of mass in the link's own DH frame, that of the robot description:
            the Z axis of link n is the axis of joint n.
    """

    name: str
    mass_kg: float
    centre_mm: tuple[float, float, float]


class TorqueCoefficients(NamedTuple):
    """How a motor's current becomes a torque at the output, joint 1 first.

    Attributes:
        k_nm_per_a: Motor constants.
        b: Ratio factors.
        c: Calibration; ``None`` where it is not known.
    """

    k_nm_per_a: tuple[float, ...]
    b: tuple[float, ...]
    c: tuple[float, ...] | None


class GripperMounting(NamedTuple):
    """The maker's gripper on the flange.

    Attributes:
        turned_deg: About the flange's Z axis.
        base_kg, finger_kg: Masses of its housing and of each of the two fingers.
        reach_mm: From the flange to the tips of the fingers.
        strokes_mm: How far the small and the large one open.
    """

    turned_deg: float
    base_kg: float
    finger_kg: float
    reach_mm: float
    strokes_mm: tuple[float, ...]


class ModelData(NamedTuple):
    """One arm of the family.

    Attributes:
        model: Which.
        name: As the maker writes it.
        geometry: With the zeros of today's firmware.
        older_geometry: With those before S-V1.6-3.
        limits: Of the six joints as the arm leaves the factory: they stand in until the arm has
            told its own.
        accelerations_deg_s2: The highest of the six joints, likewise.
        speeds_assumed: Speeds and accelerations are the PiPER's, for want of published ones.
        torque: Of the motors.
        links: Masses of the base and the six links.
        gripper: How it is mounted.
        reach_mm, payload_kg, weight_kg: As the maker publishes them; ``None`` where it does not.
        node_types: What arms of this model were seen to answer as node type (0x4AF).
        notes: What is not certain about these figures, a sentence each.
    """

    model: PiperModel
    name: str
    geometry: Geometry
    older_geometry: Geometry
    limits: tuple[JointLimits, ...]
    accelerations_deg_s2: tuple[float, ...]
    speeds_assumed: bool
    torque: TorqueCoefficients
    links: tuple[LinkMass, ...]
    gripper: GripperMounting
    reach_mm: float | None
    payload_kg: float | None
    weight_kg: float | None
    node_types: tuple[str, ...]
    notes: tuple[str, ...]

    @property
    def geometries(self) -> tuple[Geometry, Geometry]:
        """Today's and the older one: what an arm may have that tells no version."""
        return self.geometry, self.older_geometry

    def tool_mm(self, tool_z_mm: float) -> float:
        """Return how far the tip is beyond the flange: of the tool set, else of the gripper."""
        return tool_z_mm if tool_z_mm > 0.0 else self.gripper.reach_mm

    def geometry_with(self, *, older_zeros: bool) -> Geometry:
        """Return the dimensions with the zeros before S-V1.6-3, or with today's."""
        return self.older_geometry if older_zeros else self.geometry

    def older_zeros(self, version: str) -> bool:
        """Tell whether a firmware counts from the zeros before S-V1.6-3; an unreadable one: no."""
        parsed = FirmwareVersion.parse(version)
        return parsed is not None and quirks_of(parsed, self.model).shifted_zeros

    def geometry_of(self, version: str) -> Geometry:
        """Return the dimensions with the zeros of a firmware."""
        return self.geometry_with(older_zeros=self.older_zeros(version))


def all_models() -> Mapping[PiperModel, ModelData]:
    """Return the arms of the family.

    Raises:
        ModelFileError: The installation lacks a file, or it is damaged.
    """
    return MappingProxyType({model: model_data(model) for model in PiperModel})


def model_data(model: PiperModel = PiperModel.PIPER) -> ModelData:
    """Return the data of a model of the family.

    Raises:
        ModelFileError: As with all of them.
    """
    return _installed(model)


@cache
def _installed(model: PiperModel) -> ModelData:
    """Return the data file of a model, read when it is first asked for."""
    return read_model(model_folder(model))


def model_folder(model: PiperModel) -> Path:
    """Return where a model's data file, robot description and meshes are."""
    return URDF / model.value


def robot_description(model: PiperModel, *, older_zeros: bool = False) -> Path:
    """Return the robot description (URDF) of a model, whose joint angles are those on the bus.

    Args:
        model: Which.
        older_zeros: Of an arm that counts from the zeros before S-V1.6-3.
    """
    suffix = "_older_zeros" if older_zeros else ""
    return model_folder(model) / f"{model.value}{suffix}.urdf"


def read_model(folder: Path) -> ModelData:
    """Return the model whose data file lies in a folder.

    Raises:
        ModelFileError: There is none, or a field of it is missing or wrong.
    """
    path = folder / "model.json"
    try:
        fields = Fields(json.loads(read_file(path)))
        return _model(fields)
    except (OSError, ValueError, RecursionError, FieldError) as error:
        raise ModelFileError(f"{path}: {error}") from error


def _model(fields: Fields) -> ModelData:
    fields.whole("format", allowed=(FORMAT,))
    identifier = fields.text("id")
    if identifier not in list(PiperModel):
        raise fields.bad("id", f"one of {', '.join(PiperModel)}")
    geometry = _geometry(fields)
    limits, accelerations_deg_s2 = _joints(fields)
    torque = fields.object("torque")
    published = fields.object("published")
    result = ModelData(
        model=PiperModel(identifier),
        name=fields.text("name"),
        geometry=geometry,
        older_geometry=geometry.with_zeros(fields.numbers("older_zeros_deg", _SIX)),
        limits=limits,
        accelerations_deg_s2=accelerations_deg_s2,
        speeds_assumed=_speeds_assumed(fields),
        torque=TorqueCoefficients(
            torque.numbers("k_nm_per_a", _SIX),
            torque.numbers("b", _SIX),
            _maybe_six(torque, "c"),
        ),
        links=_links(fields),
        gripper=_gripper(fields.object("gripper")),
        reach_mm=_maybe_number(published, "reach_mm"),
        payload_kg=_maybe_number(published, "payload_kg"),
        weight_kg=_maybe_number(published, "weight_kg"),
        node_types=fields.texts("node_types"),
        notes=fields.texts("notes"),
    )
    for each in (fields, torque, published):
        each.nothing_else()
    return result


def _geometry(fields: Fields) -> Geometry:
    rows = []
    for row in fields.objects("dh", 6):
        rows.append([row.number(name) for name in ("a_mm", "alpha_deg", "d_mm", "theta_deg")])
        row.nothing_else()
    try:
        return Geometry.from_dh(rows)
    except GeometryError as error:
        raise fields.bad("dh", str(error)) from error


def _joints(fields: Fields) -> tuple[tuple[JointLimits, ...], tuple[float, ...]]:
    limits, accelerations_deg_s2 = [], []
    for joint in fields.objects("joints", 6):
        low, high = joint.numbers("range_deg", (2,))
        speed = math.degrees(joint.number("max_speed_rad_s"))
        limits.append(JointLimits(low, high, speed))
        accelerations_deg_s2.append(math.degrees(joint.number("max_acceleration_rad_s2")))
        joint.nothing_else()
    return tuple(limits), tuple(accelerations_deg_s2)


def _speeds_assumed(fields: Fields) -> bool:
    word = fields.text("speeds")
    if word not in _SPEEDS:
        raise fields.bad("speeds", " or ".join(_SPEEDS))
    return _SPEEDS[word]


def _links(fields: Fields) -> tuple[LinkMass, ...]:
    links = []
    for name, link in zip(LINK_NAMES, fields.objects("links", len(LINK_NAMES)), strict=True):
        if link.text("name") != name:
            raise link.bad("name", name)
        x, y, z = link.numbers("centre_mm", (3,))
        links.append(LinkMass(name, link.number("mass_kg"), (x, y, z)))
        link.nothing_else()
    return tuple(links)


def _gripper(fields: Fields) -> GripperMounting:
    mounting = GripperMounting(
        turned_deg=fields.number("turned_deg"),
        base_kg=fields.number("base_kg"),
        finger_kg=fields.number("finger_kg"),
        reach_mm=fields.number("reach_mm"),
        strokes_mm=fields.numbers("strokes_mm", (2,)),
    )
    fields.nothing_else()
    return mounting


def _maybe_number(fields: Fields, name: str) -> float | None:
    return fields.number(name) if fields.given(name) else None


def _maybe_six(fields: Fields, name: str) -> tuple[float, ...] | None:
    return fields.numbers(name, _SIX) if fields.given(name) else None


@dataclass(frozen=True, slots=True)
class ArmModel:
    """An arm as a plan sees it.

    Attributes:
        limits: Of the six joints, as read from the arm.
        accelerations_deg_s2: The highest of the six joints.
        end_limits: Of the tool; ``None`` while the arm has not told them.
        kinematics: Of its geometry.
        tool_mm: How far the gripper reaches beyond the flange.
        stroke_mm: How far the gripper opens; ``None`` if that is not known.
        gripper_turned_deg: How the gripper is mounted, about the flange's Z axis.
        kind: The model and its zeros; "": nothing is said of trajectories of other arms.
    """

    limits: tuple[JointLimits, ...]
    accelerations_deg_s2: tuple[float, ...]
    end_limits: EndLimits | None
    kinematics: Kinematics
    tool_mm: float
    stroke_mm: float | None = None
    gripper_turned_deg: float = 0.0
    kind: str = ""

    @property
    def fingerprint(self) -> str:
        """A short text that is another for another arm: what was planned for one holds for it."""
        return hashlib.sha256(repr(self).encode()).hexdigest()[:16]
