"""Makes a `Robot` of a URDF file with an arm of six hinges in a row.

yourdfpy reads the file and trimesh its meshes; this module checks that it is an arm, and finds its
joints. It is slow to import.
"""

from __future__ import annotations

import io
import math
import re
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Final

import numpy as np
import trimesh
import yourdfpy
from trimesh.resolvers import FilePathResolver

from armui.arm.refusal import Reason
from armui.system.files import check_file, error_text, open_file, read_file
from armui.viewport.messages import URDF_MISSING, SceneError
from armui.viewport.process.robot import (
    ARM_JOINT_COUNT,
    HINGES,
    Joint,
    Mimic,
    Rgb,
    Robot,
    RobotPart,
    Surface,
)

URDF_TOO_DETAILED = Reason(
    "urdf_too_detailed",
    "Robot description: the meshes of {path} have more than {most} triangles together. Export "
    "them with fewer.",
)
URDF_INCOMPLETE = Reason(
    "urdf_incomplete",
    "Robot description: in {path} an element or attribute is missing that URDF demands. Check "
    "that every link, joint and visual is complete.",
)
URDF_UNREADABLE = Reason(
    "urdf_unreadable",
    "Robot description: the file {path} cannot be read: {text}. Choose a file you may read.",
)
URDF_NOT_XML = Reason(
    "urdf_not_xml",
    "Robot description: {path} is not well-formed XML ({text}). Repair or export it again.",
)
URDF_NO_ROBOT = Reason(
    "urdf_no_robot",
    "Robot description: {path} describes no robot: its first element is “{element}”, not "
    "“robot”. Choose a URDF file.",
)
URDF_XACRO = Reason(
    "urdf_xacro",
    "Robot description: {path} is written in words of xacro ({word}), which ROS expands. Expand "
    "it with “xacro {path} > {expanded}” where ROS is installed, and choose {expanded}.",
)
URDF_MALFORMED = Reason(
    "urdf_malformed",
    "Robot description: {path} is not written as URDF demands: {text}. Correct it.",
)
URDF_JOINT_COUNT = Reason(
    "urdf_joint_count",
    "Robot description: {path} has {found} revolute joints in a row instead of {wanted}. "
    "Choose the description of a six-joint arm.",
)
URDF_NO_TREE = Reason(
    "urdf_no_tree",
    "Robot description: in {path} these links do not hang together as one tree: {links}. Every "
    "link but the first needs exactly one joint that carries it.",
)
URDF_BAD_JOINT = Reason(
    "urdf_bad_joint",
    "Robot description: joint “{joint}” in {path} is wrong. It needs a name of its own, a type "
    "and an axis that URDF knows and, if it mimics, a joint to mimic.",
)
MESH_TOO_LARGE = Reason(
    "mesh_too_large",
    "Robot description: the mesh {mesh} reaches farther than {most} m, or nowhere. A mesh in "
    "millimetres needs scale 0.001.",
)
MESH_KIND_UNKNOWN = Reason(
    "mesh_kind_unknown",
    "Robot description: meshes like {mesh} are not supported. Supported kinds: {kinds}.",
)
MESH_FILE_TOO_LARGE = Reason(
    "mesh_file_too_large",
    "Robot description: the mesh {mesh} has {size} MB; {most} MB are read at most. Export it "
    "with fewer triangles.",
)
MESH_UNREADABLE = Reason(
    "mesh_unreadable", "Robot description: the mesh {mesh} cannot be read: {text}. Export it again."
)
MESH_EMPTY = Reason(
    "mesh_empty", "Robot description: the mesh {mesh} holds no surface. Export it again."
)
MESH_MISSING = Reason(
    "mesh_missing",
    "Robot description: the mesh “{mesh}” that {path} names is not there. Put it where the "
    "file says, or correct its name in the file.",
)


_EXPRESSION: Final = re.compile(r"\$[({]")
"""The beginning of what xacro computes, in an attribute."""
_MOST_BYTES: Final = 32_000_000
_MOST_MESH_BYTES: Final = 100_000_000
_MOST_TRIANGLES: Final = 1_000_000
"""The most triangles of all meshes: a million take 2 s to draw by the processor, and 1 GB."""
_LARGEST_M: Final = 100.0
"""No arm is larger; a file in millimetres would be."""
_MESH_KINDS: Final = frozenset({".stl", ".dae", ".obj", ".ply", ".glb", ".gltf", ".off"})
"""The suffixes of meshes. Archives are excluded: their size is unknown before unpacking."""

_KINDS = HINGES | {"prismatic", "fixed", "floating", "planar"}


def load_robot(path: Path) -> Robot:
    """Read a URDF file of a six-joint arm, with its meshes.

    Args:
        path: the URDF file. Mesh names in it may be relative to its folder, absolute, `file://…`,
            or `package://…`, which is looked for in the file's folder and those above.

    Raises:
        SceneError: the file can't be read or is no URDF, a mesh is missing or unreadable, or there
            is no chain of six revolute joints, or it is larger than any arm, or too detailed.
        MemoryError: it takes more memory than there is.
    """
    description = _description(path)
    root, joints = _tree(path, description)
    arm_joints = _arm_joints(path, joints)
    parts: list[RobotPart] = []
    triangles = 0
    for link in description.links:
        for visual in link.visuals:
            parts.append(_part(path, description, link.name, visual))
            triangles += len(parts[-1].surface.faces)
            if triangles > _MOST_TRIANGLES:
                raise SceneError(URDF_TOO_DETAILED, path=str(path), most=_MOST_TRIANGLES)
    return Robot(root, joints, arm_joints, tuple(parts))


def _description(path: Path) -> yourdfpy.Robot:
    """Return the content of the file, as yourdfpy's dataclasses."""
    content = _content(path)
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # for numbers of hundreds of digits
            return yourdfpy.URDF.load(
                io.BytesIO(content), build_scene_graph=False, load_meshes=False
            ).robot
    except ValueError as error:
        raise _malformed(path, str(error)) from error
    except (LookupError, TypeError, AttributeError) as error:
        # yourdfpy raises these where an element or an attribute is missing
        raise SceneError(URDF_INCOMPLETE, path=str(path)) from error


def _content(path: Path) -> bytes:
    """Return the file, which is sound XML: yourdfpy would go on with broken XML."""
    content = b""
    try:
        content = read_file(path, _MOST_BYTES)
        # URDF files are the operator's own, and expat in supported Pythons stops entity bombs.
        element = ET.fromstring(content)  # noqa: S314 - see above
    except FileNotFoundError as error:
        raise SceneError(URDF_MISSING, path=str(path)) from error
    except OSError as error:
        text = error_text(error)
        raise SceneError(URDF_UNREADABLE, path=str(path), text=text) from error
    except (ET.ParseError, LookupError, ValueError) as error:  # LookupError: an unknown encoding
        unbound = re.search(rb"<(xacro:\w+)", content)
        if unbound is not None:  # an included xacro file may lack the namespace: invalid XML
            raise _xacro(path, unbound.group(1).decode()) from error
        raise SceneError(URDF_NOT_XML, path=str(path), text=str(error)) from error
    for each in element.iter():
        namespace, _, name = each.tag.rpartition("}")
        expressions = [value for value in each.attrib.values() if _EXPRESSION.search(value)]
        if namespace.endswith("xacro") or expressions:
            raise _xacro(path, expressions[0] if expressions else f"xacro:{name}")
    if element.tag != "robot":
        raise SceneError(URDF_NO_ROBOT, path=str(path), element=element.tag)
    return content


def _xacro(path: Path, word: str) -> SceneError:
    stem = path.name.removesuffix(".xacro").removesuffix(".urdf")
    expanded = f"{stem}_expanded.urdf" if path.suffix == ".urdf" else f"{stem}.urdf"
    return SceneError(URDF_XACRO, path=path.name, word=word[:60], expanded=expanded)


def _malformed(path: Path, text: str) -> SceneError:
    return SceneError(URDF_MALFORMED, path=str(path), text=text)


def _joint_count(path: Path, found: int) -> SceneError:
    return SceneError(URDF_JOINT_COUNT, path=str(path), found=found, wanted=ARM_JOINT_COUNT)


def _tree(path: Path, description: yourdfpy.Robot) -> tuple[str, tuple[Joint, ...]]:
    """Return the name of the base link, and the joints, parents before children.

    Raises:
        SceneError: there is no link, the links are no single tree, or a joint is wrong.
    """
    links = Counter(link.name for link in description.links)
    if not links:
        raise _joint_count(path, 0)
    children = Counter(joint.child for joint in description.joints)
    roots = [link for link in links if link not in children][:1]
    ordered = _joints_from(roots, description.joints)
    reached = {*roots, *(joint.child for joint in ordered)}
    # a tree has each link once, carries each by one joint at most, and leaves none aside
    odd = {name for name, count in (links | children).items() if count > 1}
    odd |= links.keys() ^ reached
    if odd:
        raise SceneError(URDF_NO_TREE, path=str(path), links=", ".join(sorted(map(str, odd))))
    _check_joints(path, ordered)
    return roots[0], tuple(_joint(path, joint) for joint in ordered)


def _joints_from(roots: Sequence[str], joints: Sequence[yourdfpy.Joint]) -> list[yourdfpy.Joint]:
    """Return the joints that can be reached from these links, level by level."""
    ordered = []
    reached = list(roots)
    for link in reached:  # the children found here are appended, and visited in their turn
        for joint in joints:
            # visiting a link again would never end, if the joints form a circle
            if joint.parent == link and joint.child not in reached:
                ordered.append(joint)
                reached.append(joint.child)
    return ordered


def _check_joints(path: Path, joints: Sequence[yourdfpy.Joint]) -> None:
    """Check names, types, and that a joint that mimics follows one that moves by itself.

    Raises:
        SceneError: one of the joints is wrong.
    """
    names = Counter(joint.name for joint in joints)
    leaders = {joint.name for joint in joints if joint.mimic is None}
    for joint in joints:
        follows_nothing = joint.mimic is not None and joint.mimic.joint not in leaders
        if names[joint.name] > 1 or joint.type not in _KINDS or follows_nothing:
            raise SceneError(URDF_BAD_JOINT, path=str(path), joint=joint.name)


def _joint(path: Path, joint: yourdfpy.Joint) -> Joint:
    origin = np.eye(4) if joint.origin is None else joint.origin
    length = float(np.linalg.norm(joint.axis))
    limit, mimic = joint.limit or yourdfpy.Limit(), joint.mimic
    # an infinite limit is allowed: it means none
    figures = [limit.lower or 0.0, limit.upper or 0.0]
    if mimic is not None:
        # zero times infinity is NaN: other than the limits, these two must be finite
        figures += [0.0 * mimic.multiplier, 0.0 * mimic.offset]
    is_sound = len(joint.axis) == 3 and 0.0 < length < math.inf
    is_sound = is_sound and bool((np.abs(origin) <= _LARGEST_M).all())
    if not is_sound or any(map(math.isnan, figures)):
        raise SceneError(URDF_BAD_JOINT, path=str(path), joint=joint.name)
    return Joint(
        name=joint.name,
        kind=joint.type,
        parent=joint.parent,
        child=joint.child,
        origin=origin,
        axis=joint.axis / length,
        lower=limit.lower or 0.0,
        upper=limit.upper or 0.0,
        mimic=None if mimic is None else Mimic(mimic.joint, mimic.multiplier, mimic.offset),
    )


def _arm_joints(path: Path, joints: Sequence[Joint]) -> tuple[str, ...]:
    """Return names of the hinges that all long branches share: the arm without its fingers."""
    hinges_to: dict[str, tuple[str, ...]] = {}
    for joint in joints:
        before = hinges_to.get(joint.parent, ())
        moves = joint.kind in HINGES and joint.mimic is None
        hinges_to[joint.child] = (*before, joint.name) if moves else before
    parents = {joint.parent for joint in joints}
    branches = [
        hinges
        for link, hinges in hinges_to.items()
        if link not in parents and len(hinges) >= ARM_JOINT_COUNT
    ]
    shared = tuple(names[0] for names in zip(*branches, strict=False) if len(set(names)) == 1)
    if len(shared) != ARM_JOINT_COUNT:
        found = len(shared) if branches else max(map(len, hinges_to.values()), default=0)
        raise _joint_count(path, found)
    return shared


def _part(path: Path, description: yourdfpy.Robot, link: str, visual: yourdfpy.Visual) -> RobotPart:
    try:
        surface = _surface(path, visual.geometry)
        if visual.origin is not None:
            surface.apply_transform(visual.origin)
        plain = Surface(np.array(surface.vertices, float), np.array(surface.faces, int))
        if not (np.abs(plain.vertices) <= _LARGEST_M).all():  # false for NaN, too
            what = link if visual.geometry.mesh is None else visual.geometry.mesh.filename
            raise SceneError(MESH_TOO_LARGE, mesh=what or link, most=_LARGEST_M)
        return RobotPart(link, plain, _color(description, visual.material))
    except ValueError as error:  # from trimesh and numpy: too few numbers in a size or a colour
        raise _malformed(path, f"{link}: {error}") from error


def _surface(path: Path, geometry: yourdfpy.Geometry) -> trimesh.Trimesh:
    """Return the triangles of one shape in its own frame, metres."""
    surface: trimesh.Trimesh
    if geometry.mesh is not None:
        surface = _mesh(_mesh_file(path, geometry.mesh.filename))
        scale = 1.0 if geometry.mesh.scale is None else geometry.mesh.scale
        surface.apply_transform(np.diag([*np.broadcast_to(scale, 3), 1.0]))
    elif geometry.box is not None:
        surface = trimesh.creation.box(extents=geometry.box.size)
    elif geometry.cylinder is not None:
        radius, length = geometry.cylinder.radius, geometry.cylinder.length
        surface = trimesh.creation.cylinder(radius=radius, height=length, sections=48)
    else:
        surface = trimesh.creation.icosphere(radius=geometry.sphere.radius)
    return surface


class _FilesBeside(FilePathResolver):
    """Finds what a mesh refers to: materials, pictures, binary parts."""

    def get(self, name: str) -> bytes:
        """Return the content of a file."""
        check_file(self.absolute(name))
        data: bytes = super().get(name)
        return data


def _mesh(path: Path) -> trimesh.Trimesh:
    if path.suffix.lower() not in _MESH_KINDS:
        text = ", ".join(sorted(_MESH_KINDS))
        raise SceneError(MESH_KIND_UNKNOWN, mesh=str(path), kinds=text)
    size_bytes = path.stat().st_size
    if size_bytes > _MOST_MESH_BYTES:
        raise SceneError(
            MESH_FILE_TOO_LARGE,
            mesh=str(path),
            size=size_bytes // 1_000_000,
            most=_MOST_MESH_BYTES // 1_000_000,
        )
    try:
        with open_file(path) as file:
            beside = _FilesBeside(str(path))
            kind = path.suffix.removeprefix(".")
            surface = trimesh.load(file, file_type=kind, resolver=beside, force="mesh")
    except MemoryError:
        raise
    except Exception as error:
        raise SceneError(MESH_UNREADABLE, mesh=str(path), text=str(error)) from error
    if not isinstance(surface, trimesh.Trimesh) or surface.is_empty:
        raise SceneError(MESH_EMPTY, mesh=str(path))
    return surface


def _mesh_file(path: Path, name: str | None) -> Path:
    folder = str(path.resolve().parent)
    try:
        found = yourdfpy.filename_handler_magic(name or "", dir=folder)
    except TypeError:  # raised for a package name without a file: package://name
        found = folder
    if not Path(found).is_file():
        raise SceneError(MESH_MISSING, path=str(path), mesh=name or "")
    return Path(found)


def _color(description: yourdfpy.Robot, material: yourdfpy.Material | None) -> Rgb | None:
    """Return the colour of a visual's material, which may be defined elsewhere under its name."""
    if material is not None and material.color is None:
        named = (other for other in description.materials if other.name == material.name)
        material = next(named, None)
    if material is None or material.color is None:
        return None
    red, green, blue, _alpha = map(float, material.color.rgba)
    return red, green, blue
