"""Reads a URDF file into a `Robot`: any file of the arm's kind, six hinges in a row.

Written on the standard library's XML reader instead of a URDF package: those load the meshes with
the description and take longer to import than everything else the picture needs.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from armui.viewport.errors import SceneError
from armui.viewport.robot import (
    ARM_JOINT_COUNT,
    HINGES,
    Joint,
    Matrix,
    Mimic,
    Rgb,
    Robot,
    Visual,
    pose_from_xyz_rpy,
)

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable
    from pathlib import Path

_SOLIDS = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}
_KINDS = HINGES | {"prismatic", "fixed", "floating", "planar"}


def load_robot(path: Path) -> Robot:
    """Read a URDF file of a six-joint arm.

    Args:
        path: the URDF file. Mesh names in it may be relative to its folder, absolute, `file://…`,
            or `package://…`, which is looked for in the file's folder and the folders above.

    Raises:
        SceneError: the file can't be read or is no URDF, a mesh is missing, or the file has no
            chain of six revolute joints. The text names file, reason and remedy.
    """
    return _Reader(path).robot()


class _Reader:
    """One file on its way to a `Robot`; exists so that every error can name the file."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._root = self._parse()
        self._materials = {
            material.get("name", ""): color
            for material in self._root.findall("material")
            if (color := self._color(material)) is not None
        }

    def robot(self) -> Robot:
        links = {
            self._attribute(link, "name"): tuple(self._visual(v) for v in link.findall("visual"))
            for link in self._root.findall("link")
        }
        unordered = [self._joint(element) for element in self._root.findall("joint")]
        self._check_names(links, unordered)
        root = self._root_link(links.keys(), unordered)
        joints = self._in_order(root, unordered)
        arm_joints = self._arm_joints(joints)
        return Robot(
            self._path, root, links, joints, arm_joints, _joint_numbers(joints, arm_joints)
        )

    def _error(self, reason: str, remedy: str) -> SceneError:
        return SceneError(f"{self._path}: {reason}; {remedy}.")

    def _parse(self) -> ET.Element:
        try:
            # URDF files are the user's own, and expat in supported Pythons stops entity bombs.
            root = ET.parse(self._path).getroot()  # noqa: S314 - see above
        except OSError as error:
            reason = error.strerror or str(error)
            raise self._error(
                f"can't be read ({reason})", "choose a URDF file that exists"
            ) from error
        except ET.ParseError as error:
            raise self._error(
                f"is not well-formed XML ({error})", "repair or export it again"
            ) from error
        if root.tag != "robot":
            raise self._error(
                f"is no robot description (its first element is <{root.tag}>, not <robot>)",
                "choose a URDF file; a .xacro file must be expanded first",
            )
        return root

    def _attribute(self, element: ET.Element, name: str) -> str:
        value = element.get(name)
        if value is None:
            raise self._error(f"a <{element.tag}> has no attribute “{name}”", "add it")
        return value

    def _numbers(self, text: str, count: int) -> tuple[float, ...]:
        try:
            numbers = tuple(float(word) for word in text.split())
        except ValueError:
            numbers = ()
        if len(numbers) != count or not all(map(math.isfinite, numbers)):
            raise self._error(f"“{text}” should be {count} number(s)", "correct it")
        return numbers

    def _pose(self, element: ET.Element) -> Matrix:
        origin = element.find("origin")
        if origin is None:
            return np.eye(4)
        return pose_from_xyz_rpy(
            self._numbers(origin.get("xyz", "0 0 0"), 3),
            self._numbers(origin.get("rpy", "0 0 0"), 3),
        )

    def _color(self, material: ET.Element | None) -> Rgb | None:
        color = None if material is None else material.find("color")
        if color is None:
            return None
        red, green, blue, _alpha = self._numbers(self._attribute(color, "rgba"), 4)
        return red, green, blue

    def _visual(self, element: ET.Element) -> Visual:
        pose = self._pose(element)
        material = element.find("material")
        color = self._color(material)
        if color is None and material is not None:
            color = self._materials.get(material.get("name", ""))
        geometry = element.find("geometry")
        shape = None if geometry is None else next(iter(geometry), None)
        if shape is None:
            raise self._error(
                "a <visual> has no shape in its <geometry>", "add a mesh, box, cylinder or sphere"
            )
        if shape.tag == "mesh":
            scale = self._numbers(shape.get("scale", "1 1 1"), 3)
            return Visual(
                "mesh", scale, self._mesh_file(self._attribute(shape, "filename")), pose, color
            )
        if shape.tag not in _SOLIDS:
            raise self._error(
                f"shape <{shape.tag}> is unknown", "use a mesh, box, cylinder or sphere"
            )
        size: list[float] = []
        for name in _SOLIDS[shape.tag]:
            size.extend(self._numbers(self._attribute(shape, name), 3 if name == "size" else 1))
        return Visual(shape.tag, tuple(size), None, pose, color)

    def _mesh_file(self, name: str) -> Path:
        folder = self._path.resolve().parent
        if name.startswith("package://"):
            # The package's own name may be the name of one of the folders or missing on this disk.
            package, _, inside = name.removeprefix("package://").partition("/")
            candidates = [
                above / part
                for above in (folder, *folder.parents)
                for part in (f"{package}/{inside}", inside)
            ]
        else:
            candidates = [folder / name.removeprefix("file://")]
        for candidate in candidates:
            if candidate.is_file():
                return candidate
        raise self._error(
            f"the mesh file “{name}” is missing",
            "put it where the URDF says, or correct the name in the URDF",
        )

    def _joint(self, element: ET.Element) -> Joint:
        name = self._attribute(element, "name")
        kind = self._attribute(element, "type")
        parent, child = element.find("parent"), element.find("child")
        if kind not in _KINDS or parent is None or child is None:
            raise self._error(
                f"joint “{name}” has no parent, no child or an unknown type", "correct it"
            )
        axis_element, limit, mimic = (element.find(tag) for tag in ("axis", "limit", "mimic"))
        axis = np.array(
            self._numbers(
                "1 0 0" if axis_element is None else self._attribute(axis_element, "xyz"), 3
            )
        )
        length = float(np.linalg.norm(axis))
        if length == 0.0:
            raise self._error(f"the axis of joint “{name}” has no length", "correct it")
        lower, upper = (
            0.0 if limit is None else self._numbers(limit.get(bound, "0"), 1)[0]
            for bound in ("lower", "upper")
        )
        return Joint(
            name=name,
            kind=kind,
            parent=self._attribute(parent, "link"),
            child=self._attribute(child, "link"),
            origin=self._pose(element),
            axis=axis / length,
            lower=lower,
            upper=upper,
            mimic=None if mimic is None else self._mimic(mimic),
        )

    def _mimic(self, element: ET.Element) -> Mimic:
        (multiplier,) = self._numbers(element.get("multiplier", "1"), 1)
        (offset,) = self._numbers(element.get("offset", "0"), 1)
        return Mimic(self._attribute(element, "joint"), multiplier, offset)

    def _check_names(self, links: Collection[str], joints: list[Joint]) -> None:
        names, children = Counter[str](), Counter[str]()
        for joint in joints:
            names[joint.name] += 1
            children[joint.child] += 1
            for link in (joint.parent, joint.child):
                if link not in links:
                    raise self._error(
                        f"joint “{joint.name}” names a link “{link}” that is not there",
                        "add the link",
                    )
        for counter, mistake in (
            (names, "more than one joint is called"),
            (children, "more than one parent has link"),
        ):
            for name, count in counter.items():
                if count > 1:
                    raise self._error(f"{mistake} “{name}”", "keep one")

    def _root_link(self, links: Iterable[str], joints: Iterable[Joint]) -> str:
        children = {joint.child for joint in joints}
        roots = [link for link in links if link not in children]
        if len(roots) != 1:
            raise self._error(
                f"has {len(roots)} links without a parent instead of one",
                "join the links by joints",
            )
        return roots[0]

    def _in_order(self, root: str, joints: list[Joint]) -> tuple[Joint, ...]:
        """Parents before children, leaders before the joints that mimic them."""
        placed, known, ordered = {root}, set[str](), list[Joint]()
        waiting = joints
        while waiting:
            ready = [
                joint
                for joint in waiting
                if joint.parent in placed and (joint.mimic is None or joint.mimic.leader in known)
            ]
            if not ready:
                names = ", ".join(joint.name for joint in waiting)
                raise self._error(
                    f"these joints form a loop or mimic no joint: {names}", "correct them"
                )
            ordered += ready
            placed |= {joint.child for joint in ready}
            known |= {joint.name for joint in ready}
            waiting = [joint for joint in waiting if joint.name not in known]
        return tuple(ordered)

    def _arm_joints(self, joints: tuple[Joint, ...]) -> tuple[str, ...]:
        """Names of the hinges that all long branches share: the arm without its fingers."""
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
            raise self._error(
                f"has {found} revolute joints in a row instead of {ARM_JOINT_COUNT}",
                "choose the description of a six-joint arm",
            )
        return shared


def _joint_numbers(joints: Iterable[Joint], arm_joints: tuple[str, ...]) -> dict[str, int]:
    """By link, the number (1–6) of the arm joint that moves it last."""
    numbers: dict[str, int] = {}
    for joint in joints:
        if joint.name in arm_joints:
            numbers[joint.child] = arm_joints.index(joint.name) + 1
        elif joint.parent in numbers:
            numbers[joint.child] = numbers[joint.parent]
    return numbers
