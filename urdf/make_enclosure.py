"""Makes the capsules that enclose the four arms: `python urdf/make_enclosure.py [FOLDER]`.

They go to `<model>/enclosure.json` in the folder. Each link is covered by a few capsules in its own
frame, found for the meshes beside (run `make_meshes.py` first): the triangles are cut small, dealt
out to a number of groups, and each group gets the capsule of least volume that holds all of it. A
triangle that lies in one capsule with its corners lies in it wholly, so that nothing stands out
between the corners. The two fingers are covered at an opening of 0; who knows the opening moves
their capsules.

The same numbers always give the same capsules.
"""

from __future__ import annotations

import itertools
import json
import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt
import trimesh
from make_meshes import MODELS, sizes_of
from scipy.cluster.vq import kmeans2
from scipy.optimize import minimize
from scipy.spatial import ConvexHull

Array = npt.NDArray[np.float64]

MARGIN_MM = 4.0
"""Added to every radius: covers may be larger than the meshes here."""
PIECE_MM = 9.0
"""No edge of a triangle is longer when they are dealt out."""
GROUPS = {
    "base_link": 3,
    "link1": 2,
    "link2": 5,
    "link3": 5,
    "link4": 2,
    "link5": 3,
    "link6": 1,
    "gripper_base": 3,
    "finger_left": 2,
    "finger_right": 2,
}
"""The number of capsules of each link."""


def bumps_of(model: str) -> dict[str, Array]:
    """What the meshes here leave out and the maker's meshes of the PiPER have, as corners in mm."""
    elbow = sizes_of(model).upper_arm
    return {
        "link2": corners((elbow - 10.6, elbow - 1.2), (-44.0, -37.0), (-3.5, 3.5)),
        "link5": corners((27.0, 30.0), (-11.0, 1.5), (-28.5, -23.5)),
        "gripper_base": corners((-40.5, -30.0), (-12.0, 12.0), (48.0, 54.5)),
    }


def corners(*sides: tuple[float, float]) -> Array:
    """The eight corners of a box."""
    return np.array(list(itertools.product(*sides)))


def triangles_of(folder: Path, link: str) -> Array:
    """The triangles of a link in mm, (n, 3, 3), cut into small ones."""
    bump = bumps_of(folder.name).get(link, np.empty((0, 3)))
    hull = bump[ConvexHull(bump).simplices] if len(bump) else np.empty((0, 3, 3))
    found = [hull]
    for path in sorted(folder.glob(f"meshes/{link}_*.stl")):
        mesh = trimesh.load(path)
        vertices, faces = trimesh.remesh.subdivide_to_size(
            mesh.vertices * 1000.0, mesh.faces, PIECE_MM
        )
        found.append(vertices[faces])
    return np.concatenate(found)


def capsule_around(points: Array) -> tuple[float, Array, Array, float]:
    """The capsule of least volume found around points: its volume, two ends and radius."""
    points = points[ConvexHull(points).vertices]  # it holds all that lies between them
    middle = points.mean(axis=0)
    _, _, directions = np.linalg.svd(points - middle, full_matrices=False)
    tried = []
    for lead in range(3):
        axes = np.roll(directions, -lead, axis=0)

        def made(change: Array, axes: Array = axes) -> tuple[float, Array, Array, float]:
            axis = axes[0] + change[0] * axes[1] + change[1] * axes[2]
            axis = axis / np.linalg.norm(axis)
            centre = middle + change[2] * axes[1] + change[3] * axes[2]
            along = (points - centre) @ axis
            aside = np.linalg.norm(points - centre - along[:, None] * axis, axis=1)
            radius = float(aside.max() * (1.0 + change[4] ** 2)) + 1e-9
            reach = np.sqrt(radius**2 - aside**2)
            low, high = float((along + reach).min()), float((along - reach).max())
            if low > high:
                low = high = (low + high) / 2.0
                radius = float(np.sqrt(((along - low) ** 2 + aside**2).max()))
            volume = np.pi * radius**2 * (high - low + 4.0 / 3.0 * radius)
            return float(volume), centre + low * axis, centre + high * axis, radius

        start = np.array((0.0, 0.0, 0.0, 0.0, 0.05))
        found = minimize(
            lambda change: made(change)[0],
            start,
            method="Nelder-Mead",
            options={"maxiter": 600, "xatol": 1e-3, "fatol": 1.0},
        )
        tried.append(made(found.x))
    return min(tried, key=lambda each: each[0])


def capsules_around(triangles: Array, count: int) -> list[tuple[Array, Array, float]]:
    """That many capsules which hold all triangles, the best of several ways to deal them out."""
    centres = triangles.mean(axis=1)
    tried = []
    for seed in range(6):
        _, group = kmeans2(centres, count, minit="++", seed=seed)
        made = [
            capsule_around(triangles[group == each].reshape(-1, 3)) for each in sorted(set(group))
        ]
        tried.append(made)
    best = min(tried, key=lambda each: sum(volume for volume, *_ in each))
    return [(start, end, radius) for _, start, end, radius in best]


def enclosure_of(folder: Path) -> list[dict[str, object]]:
    """The capsules of one arm, as its file has them."""
    return [
        {
            "link": link,
            "from_mm": [round(float(value), 1) for value in start],
            "to_mm": [round(float(value), 1) for value in end],
            # the ends are rounded by less than 0.1 mm
            "radius_mm": round(radius + MARGIN_MM + 0.1, 1),
        }
        for link, count in GROUPS.items()
        for start, end, radius in capsules_around(triangles_of(folder, link), count)
    ]


def main() -> None:
    """Write the file of each arm."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for model in MODELS:
        lines = ",\n".join(f"    {json.dumps(each)}" for each in enclosure_of(folder / model))
        text = f'{{\n  "format": 1,\n  "capsules": [\n{lines}\n  ]\n}}\n'
        (folder / model / "enclosure.json").write_text(text, "utf-8")


if __name__ == "__main__":
    main()
