"""The models of the family as data: one file each, `urdf/<model>/model.json`.

Everything that differs between the models of one protocol is there and nowhere else: dimensions,
ranges, torque coefficients, masses, how the gripper is mounted. What differs with the firmware
stands in `armui.protocol.firmware_version`.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
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
    from armui.arm.held_shape import HeldShape
    from armui.arm.state import EndLimits
    from armui.arm.tool_capsule import ToolCapsule
    from armui.kinematics.arm_kinematics import Kinematics

FORMAT: Final = 1
LINK_NAMES: Final = ("base_link", *(f"link{joint}" for joint in range(1, 7)))
_SIX: Final = (6,)
_SPEEDS: Final = {"known": False, "assumed": True}

Rising = tuple[float, float, float, float]
"""How much the X, Y and Z axis of the base rise in the room, and the base's height there, mm."""
STANDING: Final[Rising] = (0.0, 0.0, 1.0, 0.0)
"""The rise of a base that stands upright on the floor."""


class ModelFileError(Exception):
    """A model's data file is missing or wrong; the text names the file and the field."""


class LinkMass(NamedTuple):
    """The mass of a link.

    Attributes:
        name: The link's name in the robot description.
        mass_kg: The link's mass.
        centre_mm: Its centre of mass in the link's own DH frame, that of the robot description:
            the Z axis of link n is the axis of joint n.
    """

    name: str
    mass_kg: float
    centre_mm: tuple[float, float, float]


class TorqueCoefficients(NamedTuple):
    """The coefficients that turn a motor's current into the torque at its output, joint 1 first.

    Attributes:
        k_nm_per_a: Motor constants.
        b: Ratio factors.
        c: Calibration; ``None`` if it is not known.
    """

    k_nm_per_a: tuple[float, ...]
    b: tuple[float, ...]
    c: tuple[float, ...] | None


class GripperMounting(NamedTuple):
    """The maker's gripper on the flange.

    Attributes:
        turned_deg: Its turn about the flange's Z axis.
        base_kg, finger_kg: Masses of its housing and of each of the two fingers.
        reach_mm: The distance from the flange to the tips of the fingers.
        strokes_mm: The openings of the small and of the large gripper.
    """

    turned_deg: float
    base_kg: float
    finger_kg: float
    reach_mm: float
    strokes_mm: tuple[float, ...]


class ModelData(NamedTuple):
    """The data of one model of the family.

    Attributes:
        model: The model.
        name: The name as the maker writes it.
        geometry: The geometry with the zeros of today's firmware.
        older_geometry: The geometry with the zeros before S-V1.6-3.
        limits: The factory limits of the six joints, used until the arm's own have been read.
        accelerations_deg_s2: The highest accelerations of the six joints, likewise.
        speeds_assumed: True if speeds and accelerations are the PiPER's, because none are
            published.
        torque: The motors' coefficients.
        links: Masses of the base and the six links.
        gripper: The gripper and its mounting.
        reach_mm, payload_kg, weight_kg: The maker's published figures; ``None`` if there is none.
        node_types: Node types that arms of this model were seen to answer (0x4AF).
        notes: The doubts about these figures, a sentence each.
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
        """Today's and the older geometry; an arm that names no version may have either."""
        return self.geometry, self.older_geometry

    def tool_mm(self, tool_z_mm: float) -> float:
        """Return the distance from flange to tip: that of the tool set, else the gripper's."""
        return tool_z_mm if tool_z_mm > 0.0 else self.gripper.reach_mm

    def geometry_with(self, *, older_zeros: bool) -> Geometry:
        """Return the geometry with the zeros before S-V1.6-3, or with today's."""
        return self.older_geometry if older_zeros else self.geometry

    def older_zeros(self, version: str) -> bool:
        """Return whether a firmware counts from the zeros before S-V1.6-3; false if unreadable."""
        parsed = FirmwareVersion.parse(version)
        return parsed is not None and quirks_of(parsed, self.model).shifted_zeros

    def geometry_of(self, version: str) -> Geometry:
        """Return the geometry with the zeros of a firmware version."""
        return self.geometry_with(older_zeros=self.older_zeros(version))


def all_models() -> Mapping[PiperModel, ModelData]:
    """Return the data of all models of the family.

    Raises:
        ModelFileError: The installation lacks a file, or it is damaged.
    """
    return MappingProxyType({model: model_data(model) for model in PiperModel})


def model_data(model: PiperModel = PiperModel.PIPER) -> ModelData:
    """Return the data of a model of the family.

    Raises:
        ModelFileError: See :func:`all_models`.
    """
    return _installed(model)


@cache
def _installed(model: PiperModel) -> ModelData:
    """Return the data file of a model, read when it is first asked for."""
    return read_model(model_folder(model))


@cache
def widest_ranges_deg() -> tuple[tuple[float, float], ...]:
    """Return the least and the greatest angle of each joint in any model of the family."""
    limits = [data.limits for data in all_models().values()]
    return tuple(
        (min(each.min_deg for each in joint), max(each.max_deg for each in joint))
        for joint in zip(*limits, strict=True)
    )


def model_folder(model: PiperModel) -> Path:
    """Return the folder of a model's data file, robot description and meshes."""
    return URDF / model.value


def robot_description(model: PiperModel, *, older_zeros: bool = False) -> Path:
    """Return the path of a model's URDF file, whose joint angles are those on the bus.

    Args:
        model: The model.
        older_zeros: True for an arm that counts from the zeros before S-V1.6-3.
    """
    suffix = "_older_zeros" if older_zeros else ""
    return model_folder(model) / f"{model.value}{suffix}.urdf"


def read_model(folder: Path) -> ModelData:
    """Return the model in the data file of a folder.

    Raises:
        ModelFileError: The file is missing, or a field of it is missing or wrong.
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
            torque.numbers("c", _SIX) if torque.given("c") else None,
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


@dataclass(frozen=True, slots=True)
class ArmModel:
    """The data of an arm that planning needs.

    Attributes:
        limits: The limits of the six joints, as read from the arm.
        accelerations_deg_s2: The highest accelerations of the six joints.
        end_limits: The limits of the tool; ``None`` while they have not been read.
        kinematics: The kinematics of its geometry.
        tool_mm: The distance from the flange to the gripper's tip.
        stroke_mm: The gripper's largest opening; ``None`` if not known.
        widest_mm: The same as measured, where the gripper's table is applied to points.
        gripper_turned_deg: The gripper's turn about the flange's Z axis.
        kind: The model and its zeros; if "", trajectories of other arms are not recognised.
        tool: The tool set on the flange; ``None`` if only the gripper's tip counts.
        held: What the hand holds.
        frames: The names of the cell's user frames, and their poses in the base.
        rising: How much each axis of the base rises in the room, and the base's height there, mm.
        around: The work area and the lowest height of checks, as text; "" for neither.
    """

    limits: tuple[JointLimits, ...]
    accelerations_deg_s2: tuple[float, ...]
    end_limits: EndLimits | None
    kinematics: Kinematics
    tool_mm: float
    stroke_mm: float | None = None
    gripper_turned_deg: float = 0.0
    kind: str = ""
    widest_mm: float | None = None
    tool: ToolCapsule | None = None
    held: HeldShape | None = None
    frames: tuple[tuple[str, tuple[float, ...]], ...] = ()
    rising: Rising = STANDING
    around: str = field(default="", repr=False)

    @property
    def tip_mm(self) -> tuple[float, float, float]:
        """The place in the flange of the tip that is watched: the tool's, else the gripper's."""
        return (0.0, 0.0, self.tool_mm) if self.tool is None else self.tool.tip_mm

    @property
    def fingerprint(self) -> str:
        """A short text that differs between arms: a plan made for one fingerprint holds for it."""
        return hashlib.sha256(f"{self!r}{self.around}".encode()).hexdigest()[:16]

    def fingerprint_of(self, frames: Collection[str]) -> str:
        """Return the fingerprint that counts for points which name these user frames alone."""
        named = tuple(frame for frame in self.frames if frame[0] in frames)
        return replace(self, frames=named).fingerprint
