"""Makes the meshes that piper.urdf shows: `python urdf/make_meshes.py [FOLDER]`.

Each link has up to two files: `<link>_shell.stl`, the white covers, and `<link>_joint.stl`, the
dark motors, rings and pads. A file holds one or more closed solids in the frame of its link, in
metres. The same numbers always give the same bytes.

Everything is made of two ideas. A *section* is the hull of a few circles, sampled at fixed
directions: a disc, a rounded rectangle and a teardrop are sections with the same number of points,
in the same order. A *loft* joins sections into a closed skin. Sizes are outer dimensions of the
arm in millimetres.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

Array = NDArray[np.float64]
Circle = tuple[float, float, float]
"""Centre x, centre y, radius."""

_POINTS = 36
_POINTS_OF_SMALL_PARTS = 16
_FILLET_STEPS = 2
_SMOOTH_STEPS = 2

# Which way a section's own x and y and the direction of its extrusion point.
ALONG_X = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
ALONG_Y = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
ALONG_Z = np.eye(3)


def section(circles: list[Circle], inset: float = 0.0, points: int = _POINTS) -> Array:
    """Outline of the hull of circles, each made smaller by `inset`; (points, 2)."""
    directions = np.linspace(0.0, 2.0 * math.pi, points, endpoint=False)
    units = np.column_stack([np.cos(directions), np.sin(directions)])
    centres = np.array([circle[:2] for circle in circles])
    radii = np.array([max(circle[2] - inset, 0.05) for circle in circles])
    farthest = np.argmax(units @ centres.T + radii, axis=1)
    return centres[farthest] + radii[farthest, np.newaxis] * units


def rectangle(half_x: float, half_y: float, corner: float) -> list[Circle]:
    """Circles whose hull is a rectangle with round corners."""
    corner = min(corner, half_x, half_y)
    return [
        (sign_x * (half_x - corner), sign_y * (half_y - corner), corner)
        for sign_x in (-1.0, 1.0)
        for sign_y in (-1.0, 1.0)
    ]


def loft(rings: Array) -> trimesh.Trimesh:
    """Closed skin over rings of points (rings, points, 3), both ends covered."""
    count, points = rings.shape[:2]
    vertices = [*rings.reshape(-1, 3), rings[0].mean(axis=0), rings[-1].mean(axis=0)]
    here = np.arange(points)
    following = (here + 1) % points
    faces = []
    for ring in range(count - 1):
        low, high = ring * points, (ring + 1) * points
        faces.append(np.column_stack([low + here, low + following, high + following]))
        faces.append(np.column_stack([low + here, high + following, high + here]))
    first_centre, last_centre, last = count * points, count * points + 1, (count - 1) * points
    faces.append(np.column_stack([np.full(points, first_centre), following, here]))
    faces.append(np.column_stack([np.full(points, last_centre), last + here, last + following]))
    solid = trimesh.Trimesh(np.array(vertices), np.concatenate(faces), process=False)
    if solid.volume < 0.0:
        solid.invert()
    return solid


def prism(
    circles: list[Circle],
    low: float,
    high: float,
    fillet: float = 1.5,
    axes: Array = ALONG_Z,
    *,
    points: int = _POINTS,
) -> trimesh.Trimesh:
    """A section pushed from `low` to `high`, with rounded rims."""
    rims = []
    for step in range(_FILLET_STEPS + 1):
        angle = 0.5 * math.pi * step / _FILLET_STEPS
        rims.append((fillet * (1.0 - math.sin(angle)), fillet * (1.0 - math.cos(angle))))
    levels = [(inset, low + rise) for inset, rise in rims]
    levels += [(inset, high - rise) for inset, rise in reversed(rims)]
    rings = [
        np.column_stack([section(circles, inset, points), np.full(points, level)])
        for inset, level in levels
    ]
    return loft(np.array(rings) @ axes)


def disc(
    radius: float,
    low: float,
    high: float,
    fillet: float = 1.5,
    axes: Array = ALONG_Z,
    *,
    centre: tuple[float, float] = (0.0, 0.0),
) -> trimesh.Trimesh:
    """A round prism; `centre` in the section's own plane."""
    points = _POINTS if radius > 10.0 else _POINTS_OF_SMALL_PARTS
    return prism([(*centre, radius)], low, high, fillet, axes, points=points)


def smooth_loft(stations: list[Array]) -> trimesh.Trimesh:
    """Skin that runs smoothly, without overshoot, through rings of points (points, 3)."""
    keys = np.arange(len(stations), dtype=float)
    fine = np.linspace(0.0, keys[-1], (len(stations) - 1) * _SMOOTH_STEPS + 1)
    return loft(PchipInterpolator(keys, np.array(stations), axis=0)(fine))


def across_x(x: float, y: float, tilt_deg: float, half_height: float, half_width: float) -> Array:
    """Ring of the upper arm: a rounded rectangle across a direction in the xy plane."""
    outline = section(rectangle(half_height, half_width, 11.0))
    tilt = math.radians(tilt_deg)
    return np.column_stack(
        [
            x - outline[:, 0] * math.sin(tilt),
            y + outline[:, 0] * math.cos(tilt),
            outline[:, 1],
        ]
    )


def across_y(y: float, x_low: float, x_high: float, half_width: float, corner: float) -> Array:
    """Ring of the forearm: a rounded rectangle across the y axis."""
    outline = section(rectangle((x_high - x_low) / 2.0, half_width, corner))
    return np.column_stack(
        [outline[:, 0] + (x_low + x_high) / 2.0, np.full(_POINTS, y), outline[:, 1]]
    )


def across_z(z: float, circles: list[Circle]) -> Array:
    """Ring across the z axis."""
    return np.column_stack([section(circles), np.full(_POINTS, z)])


Parts = dict[str, list[trimesh.Trimesh]]


def base_link() -> Parts:
    """Foot plate, column, rear housing with the cable socket."""
    corners = [(x, y, 4.0) for x in (-51.0, 36.0) for y in (-36.0, 36.0)]
    arch = [(0.0, 54.0, 31.0), (-29.0, 5.0, 2.0), (29.0, 5.0, 2.0)]
    return {
        "shell": [
            prism(corners, 0.0, 3.5, 1.0),
            disc(36.0, 2.0, 84.0, 2.0),
            prism(arch, -55.0, -4.0, 4.0, ALONG_X),
        ],
        "joint": [
            disc(33.0, 80.0, 86.0, 0.8),
            disc(9.0, -58.5, -50.0, 1.0, ALONG_X, centre=(0.0, 21.0)),
            *(
                disc(3.2, 2.0, 4.6, 0.6, ALONG_Z, centre=(x, y))
                for x in (-45.0, 30.0)
                for y in (-35.0, 35.0)
            ),
        ],
    }


def link1() -> Parts:
    """Turntable with the shoulder motor across it."""
    return {
        "shell": [
            disc(36.0, -36.0, -29.5, 1.5),
            smooth_loft(
                [
                    across_z(-31.0, [(0.0, 0.0, 34.0)]),
                    across_z(-26.0, rectangle(30.0, 33.0, 20.0)),
                    across_z(-18.0, rectangle(26.5, 33.0, 10.0)),
                    across_z(-4.0, rectangle(29.0, 33.0, 6.0)),
                ]
            ),
        ],
        "joint": [disc(30.0, -36.8, 36.8, 2.0, ALONG_Y), disc(20.0, -43.0, -35.0, 1.0)],
    }


def link2() -> Parts:
    """Upper arm: a fork at the shoulder, a slim beam, a knee and a fork at the elbow."""
    elbow = 285.03
    shell = [
        smooth_loft(
            [
                across_x(35.0, -6.5, -12.0, 22.0, 45.0),
                across_x(47.0, -9.0, -12.0, 22.3, 43.5),
                across_x(61.0, -11.8, -11.5, 22.2, 27.0),
                across_x(77.0, -14.5, -11.0, 21.8, 20.5),
                across_x(135.0, -26.0, -11.0, 21.8, 20.5),
                across_x(195.0, -37.4, -10.0, 21.8, 20.5),
                across_x(210.0, -40.0, -4.0, 22.6, 23.0),
                across_x(226.0, -38.5, 20.0, 25.0, 30.0),
                across_x(241.0, -31.0, 40.0, 24.5, 42.5),
                across_x(257.0, -17.0, 45.0, 24.0, 45.5),
            ]
        )
    ]
    joint = []
    for side in (-1.0, 1.0):
        outward = np.diag([1.0, 1.0, side])
        shell += [
            prism([(0.0, 0.0, 31.5), (46.0, -9.0, 20.0)], 38.0, 47.0, 3.0, outward),
            prism([(elbow, 0.0, 31.5), (250.0, -24.0, 22.0)], 38.0, 47.0, 3.0, outward),
        ]
        joint += [disc(23.0, 45.0, 48.5, 1.5, outward, centre=(x, 0.0)) for x in (0.0, elbow)]
    return {"shell": shell, "joint": joint}


def link3() -> Parts:
    """Elbow motor, tapering forearm and the round housing of the wrist's first motor."""
    axis_x = -21.98
    return {
        "shell": [
            smooth_loft(
                [
                    across_y(-18.0, -33.0, 14.0, 33.0, 10.0),
                    across_y(-32.5, -36.0, 7.5, 36.0, 10.0),
                    across_y(-37.0, -37.5, 6.5, 40.0, 10.0),
                    across_y(-45.0, -38.5, 4.5, 38.0, 10.0),
                    across_y(-57.0, -39.0, -1.0, 27.0, 10.0),
                    across_y(-70.0, -38.5, -5.0, 22.0, 10.0),
                    across_y(-100.0, -38.0, -6.0, 19.5, 11.0),
                    across_y(-138.0, -37.2, -6.8, 16.5, 12.0),
                    across_y(-148.0, -40.5, -3.5, 19.5, 18.0),
                    across_y(-157.0, axis_x - 26.0, axis_x + 26.0, 26.0, 26.0),
                    across_y(-163.0, axis_x - 28.5, axis_x + 28.5, 28.5, 28.5),
                    across_y(-168.0, axis_x - 28.5, axis_x + 28.5, 28.5, 28.5),
                ]
            ),
            disc(28.5, -208.5, -164.0, 1.0, ALONG_Y, centre=(axis_x, 0.0)),
        ],
        "joint": [
            disc(30.0, -36.6, 36.6, 2.0),
            disc(27.3, -214.8, -205.0, 1.0, ALONG_Y, centre=(axis_x, 0.0)),
        ],
    }


def link4() -> Parts:
    """Turning foot that carries the motor of the wrist's bend."""
    return {
        "shell": [
            disc(29.0, -35.6, -28.5, 1.5),
            smooth_loft(
                [
                    across_z(-30.0, [(0.0, 0.0, 28.0)]),
                    across_z(-25.0, rectangle(27.0, 22.0, 18.0)),
                    across_z(-14.0, rectangle(24.5, 20.5, 8.0)),
                    across_z(-4.0, rectangle(27.5, 20.5, 6.0)),
                ]
            ),
            prism([(0.0, 0.0, 28.5), (0.0, -20.0, 15.0)], 24.5, 34.0, 4.0, ALONG_Y),
        ],
        "joint": [disc(28.0, -22.0, 25.5, 2.0, ALONG_Y), disc(13.0, 32.0, 34.6, 1.0, ALONG_Y)],
    }


def link5() -> Parts:
    """Side plate on the bending axis and the round housing of the last motor."""
    return {
        "shell": [
            smooth_loft(
                [
                    across_y(-30.5, -24.0, 24.0, 24.5, 12.0),
                    across_y(-34.0, -26.0, 26.0, 26.5, 14.0),
                    across_y(-44.0, -27.5, 27.5, 28.0, 20.0),
                    across_y(-53.0, -28.5, 28.5, 28.5, 28.5),
                    across_y(-58.0, -28.5, 28.5, 28.5, 28.5),
                ]
            ),
            disc(28.5, -86.0, -54.0, 1.0, ALONG_Y),
            prism([(0.0, 0.0, 23.5), (0.0, -36.0, 25.0)], -31.0, -22.6, 3.5),
        ],
        "joint": [
            disc(15.0, -31.8, -28.0, 1.0),
            disc(27.3, -88.0, -80.0, 0.5, ALONG_Y),
        ],
    }


def link6() -> Parts:
    """The flange, a thin turning ring."""
    return {"joint": [disc(28.0, -2.6, 0.0, 0.6)]}


def gripper_base() -> Parts:
    """Round motor housing and the cross beam the fingers run on."""
    beam = [(0.0, 0.0, 30.0), (0.0, 64.0, 8.5), (0.0, -64.0, 8.5)]
    end = prism([(x, y, 2.0) for x in (-8.0, 8.0) for y in (63.0, 70.5)], 50.0, 67.0, 1.5)
    return {
        "shell": [
            disc(28.5, 0.4, 48.0, 1.0),
            prism(beam, 46.0, 56.0, 2.5),
            end,
            mirrored(end),
        ],
        "joint": [
            disc(28.9, 7.0, 9.5, 0.3),
            prism(rectangle(4.0, 64.0, 1.0), 54.0, 61.0, 0.5),
        ],
    }


def mirrored(solid: trimesh.Trimesh) -> trimesh.Trimesh:
    """The mirror image of a solid on the other side of the xz plane."""
    image = trimesh.Trimesh(solid.vertices * [1.0, -1.0, 1.0], solid.faces, process=False)
    image.invert()
    return image


def finger_left() -> Parts:
    """The finger on the side of +y: wide at the carriage, slim at the tip, with a dark pad."""
    shape = (  # z, half width in x, thickness in y
        (66.0, 27.0, 22.0),
        (68.0, 28.0, 23.0),
        (73.0, 27.5, 22.8),
        (80.0, 24.3, 20.0),
        (88.0, 21.2, 16.3),
        (96.0, 18.8, 13.2),
        (104.0, 16.9, 10.6),
        (114.0, 15.0, 8.0),
        (126.0, 13.2, 5.6),
        (138.5, 11.0, 4.2),
        (140.0, 10.0, 3.6),
    )
    stations = []
    for z, half_x, thickness in shape:
        outline = rectangle(half_x, thickness / 2.0 - 0.6, 2.0)
        stations.append(across_z(z, [(x, y + thickness / 2.0 + 0.6, r) for x, y, r in outline]))
    pad = [
        across_z(z, [(x, y + 1.0, r) for x, y, r in rectangle(half_x, 1.0, 0.8)])
        for z, half_x in ((92.0, 13.0), (138.0, 8.0))
    ]
    carriage = [(x, y, 2.0) for x in (-9.0, 9.0) for y in (3.0, 20.0)]
    return {
        "shell": [smooth_loft(stations)],
        "joint": [loft(np.array(pad)), prism(carriage, 61.6, 67.0, 1.0)],
    }


def finger_right() -> Parts:
    """The mirror image on the side of -y."""
    return {name: [mirrored(solid) for solid in solids] for name, solids in finger_left().items()}


LINKS = (
    base_link, link1, link2, link3, link4, link5, link6, gripper_base, finger_left, finger_right,
)  # fmt: skip


def all_meshes() -> dict[str, trimesh.Trimesh]:
    """Every mesh in metres, by the name of its file."""
    meshes = {}
    for link in LINKS:
        for part, solids in link().items():
            mesh = trimesh.util.concatenate(solids)
            mesh.apply_scale(0.001)
            meshes[f"{link.__name__}_{part}.stl"] = mesh
    return meshes


def main(folder: Path) -> None:
    """Write every mesh into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    total = 0
    for name, mesh in all_meshes().items():
        (folder / name).write_bytes(trimesh.exchange.stl.export_stl(mesh))
        total += len(mesh.faces)
        print(f"{name:24} {len(mesh.faces):6} triangles")
    print(f"{'all':24} {total:6} triangles")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "meshes")
