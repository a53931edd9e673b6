"""The capsules that enclose an arm with what it carries, and where they are at given joint angles.

They hold every part from the base to the fingers with some millimetres to spare, unlike those of
the check of an arm against itself (:mod:`armui.ways.own_body`), which lie within
the covers. ``urdf/make_enclosure.py`` finds them for the meshes.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Final

import numpy as np

from armui.arm.json_fields import FieldError, Fields
from armui.arm.models import ModelFileError, model_data, model_folder
from armui.kinematics.geometry import Geometry
from armui.protocol.generation import PiperModel
from armui.system.files import read_file

_FORMAT: Final = 1
_FLANGE: Final = 6
_FINGERS: Final = {"finger_left": 1.0, "finger_right": -1.0}
"""The fingers, and the direction along the gripper's Y axis in which each opens."""
_LINKS: Final = {
    "base_link": (0, "base"),
    "link1": (1, "shoulder"),
    "link2": (2, "upper arm"),
    "link3": (3, "forearm"),
    "link4": (4, "wrist"),
    "link5": (5, "hand"),
    "link6": (_FLANGE, "hand"),
    "gripper_base": (_FLANGE, "gripper"),
    "finger_left": (_FLANGE, "gripper"),
    "finger_right": (_FLANGE, "gripper"),
}
PARTS: Final = (
    *("base", "shoulder", "upper arm", "forearm", "wrist", "hand", "gripper"),
    *("tool", "held object"),
)
"""The names of the parts that capsules can have."""


@dataclass(frozen=True, slots=True)
class Capsule:
    """All places within a distance of a straight line.

    Attributes:
        part: The part it belongs to, one of :data:`PARTS`.
        link: The frame it is fixed to: 0 for the base, 1–6 for what the joint of that number turns;
            the flange is 6.
        start_mm, end_mm: The ends of the line in that frame.
        radius_mm: The distance.
        skips: The names of the planes and boxes that it does not count against.
    """

    part: str
    link: int
    start_mm: tuple[float, ...]
    end_mm: tuple[float, ...]
    radius_mm: float
    skips: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Body:
    """An arm with what it carries.

    Attributes:
        geometry: The arm's geometry, with its zeros.
        capsules: The capsules that enclose it.
    """

    geometry: Geometry
    capsules: tuple[Capsule, ...]

    def with_more(self, *capsules: Capsule) -> Body:
        """Return the same with further capsules, as those of a tool or of what the hand holds."""
        return replace(self, capsules=(*self.capsules, *capsules))


def body_of(
    model: PiperModel, geometry: Geometry, opening_mm: float, *, base: bool = False
) -> Body:
    """Return the bare arm with its gripper.

    Args:
        model: The model.
        geometry: Its geometry, with the zeros in force.
        opening_mm: How far the gripper is open at most: its fingers are enclosed at every opening
            up to that.
        base: True to enclose the base, too, which no motion moves.

    Raises:
        ModelFileError: The model's file of capsules is missing or damaged.
    """
    turned = np.radians(model_data(model).gripper.turned_deg)
    turn = np.array(
        ((np.cos(turned), -np.sin(turned), 0), (np.sin(turned), np.cos(turned), 0), (0, 0, 1))
    )
    found: list[Capsule] = []
    for name, start, end, radius_mm in _read(model):
        link, part = _LINKS[name]
        if link == 0 and not base:
            continue
        ends = np.array((start, end))
        for moved in _openings(name, opening_mm):
            placed = ends + np.array((0.0, moved, 0.0))
            if part == "gripper":
                placed = placed @ turn.T
            first, last = (tuple(map(float, each)) for each in placed)
            found.append(Capsule(part, link, first, last, radius_mm))
    return Body(geometry, tuple(found))


def _openings(name: str, opening_mm: float) -> Sequence[float]:
    """Return how far a part is moved along the gripper's Y axis: the fingers are, in steps.

    Their capsules are so wide that one every 15 mm leaves nothing between them.
    """
    way = _FINGERS.get(name)
    if way is None:
        return (0.0,)
    steps = int(np.ceil(opening_mm / 2.0 / 15.0)) + 1
    return [way * float(each) for each in np.linspace(0.0, opening_mm / 2.0, steps)]


@cache
def _read(model: PiperModel) -> tuple[tuple[str, tuple[float, ...], tuple[float, ...], float], ...]:
    """Return link, ends and radius of each capsule in a model's file."""
    path = model_folder(model) / "enclosure.json"
    try:
        fields = Fields(json.loads(read_file(path)))
        fields.whole("format", allowed=(_FORMAT,))
        found = []
        for each in fields.objects("capsules"):
            link = each.text("link")
            if link not in _LINKS:
                raise each.bad("link", f"one of {', '.join(_LINKS)}")
            ends = each.numbers("from_mm", (3,)), each.numbers("to_mm", (3,))
            found.append((link, *ends, each.number("radius_mm")))
            each.nothing_else()
        fields.nothing_else()
    except (OSError, ValueError, RecursionError, FieldError) as error:
        raise ModelFileError(f"{path}: {error}") from error
    return tuple(found)
