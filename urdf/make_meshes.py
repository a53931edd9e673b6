"""Makes the meshes of the four arms: `python urdf/make_meshes.py [FOLDER]`.

They go to `<model>/meshes` in the folder, beside the robot descriptions that show them. An arm is
its dimensions, read from `<model>/model.json`: the joints and their housings are alike, what lies
between them is as long as the model says.

Each link has up to two files: `<link>_shell.stl`, the white covers, and `<link>_joint.stl`, the
dark motors, rings and pads. A file holds one or more closed solids in the frame of its link, in
metres. The same numbers always give the same bytes. Sizes are outer dimensions of the arm in
millimetres.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh
from mesh_shapes import (
    ALONG_X,
    ALONG_Y,
    ALONG_Z,
    across_x,
    across_y,
    across_z,
    disc,
    loft,
    prism,
    rectangle,
    smooth_loft,
)

Parts = dict[str, list[trimesh.Trimesh]]

MODELS = ("piper", "piper_h", "piper_l", "piper_x")


@dataclass(frozen=True)
class Sizes:
    """What differs between the arms, in millimetres.

    Attributes:
        upper_arm: From the shoulder to the elbow.
        elbow: The forearm's offset, square to it; 0 with a parallel wrist.
        forearm: Along it, to the centre of a spherical wrist or to the axis of joint 4.
        wrist: From the axis of joint 4 to that of joint 5; 0 with a spherical wrist.
        hand: From the wrist's centre to the flange.
    """

    upper_arm: float
    elbow: float
    forearm: float
    wrist: float
    hand: float


def sizes_of(model: str) -> Sizes:
    """The dimensions in a model's data file."""
    data = json.loads((Path(__file__).parent / model / "model.json").read_text("utf-8"))
    a = [row["a_mm"] for row in data["dh"]]
    d = [row["d_mm"] for row in data["dh"]]
    if data["dh"][3]["alpha_deg"] == 0:
        return Sizes(a[2], 0.0, a[3], a[4], d[5])
    return Sizes(a[2], a[3], d[3], 0.0, d[5])


def base_link(_sizes: Sizes) -> Parts:
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


def link1(_sizes: Sizes) -> Parts:
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


def link2(sizes: Sizes) -> Parts:
    """Upper arm: a fork at the shoulder, a slim beam, a knee and a fork at the elbow."""
    elbow = sizes.upper_arm
    longer = elbow - 285.03
    deeper = 0.19 * longer  # the beam goes on as it leans
    shell = [
        smooth_loft(
            [
                across_x(35.0, -6.5, -12.0, 22.0, 45.0),
                across_x(47.0, -9.0, -12.0, 22.3, 43.5),
                across_x(61.0, -11.8, -11.5, 22.2, 27.0),
                across_x(77.0, -14.5, -11.0, 21.8, 20.5),
                across_x(135.0 + longer / 2.0, -26.0 - deeper / 2.0, -11.0, 21.8, 20.5),
                across_x(195.0 + longer, -37.4 - deeper, -10.0, 21.8, 20.5),
                across_x(210.0 + longer, -40.0 - deeper, -4.0, 22.6, 23.0),
                across_x(226.0 + longer, -38.5 - deeper, 20.0, 25.0, 30.0),
                across_x(241.0 + longer, -31.0 - deeper / 2.0, 40.0, 24.5, 42.5),
                across_x(257.0 + longer, -17.0, 45.0, 24.0, 45.5),
            ]
        )
    ]
    joint = []
    for side in (-1.0, 1.0):
        outward = np.diag([1.0, 1.0, side])
        shell += [
            prism([(0.0, 0.0, 31.5), (46.0, -9.0, 20.0)], 38.0, 47.0, 3.0, outward),
            prism([(elbow, 0.0, 31.5), (250.0 + longer, -24.0, 22.0)], 38.0, 47.0, 3.0, outward),
        ]
        joint += [disc(23.0, 45.0, 48.5, 1.5, outward, centre=(x, 0.0)) for x in (0.0, elbow)]
    return {"shell": shell, "joint": joint}


def link3(sizes: Sizes) -> Parts:
    """Elbow motor, tapering forearm and the round housing of the wrist's first motor."""
    if sizes.wrist:
        return slim_forearm(sizes)
    axis_x = sizes.elbow
    longer = sizes.forearm - 250.75
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
                    across_y(-100.0 - longer / 2.0, -38.0, -6.0, 19.5, 11.0),
                    across_y(-138.0 - longer, -37.2, -6.8, 16.5, 12.0),
                    across_y(-148.0 - longer, -40.5, -3.5, 19.5, 18.0),
                    across_y(-157.0 - longer, axis_x - 26.0, axis_x + 26.0, 26.0, 26.0),
                    across_y(-163.0 - longer, axis_x - 28.5, axis_x + 28.5, 28.5, 28.5),
                    across_y(-168.0 - longer, axis_x - 28.5, axis_x + 28.5, 28.5, 28.5),
                ]
            ),
            disc(28.5, -208.5 - longer, -164.0 - longer, 1.0, ALONG_Y, centre=(axis_x, 0.0)),
        ],
        "joint": [
            disc(30.0, -36.6, 36.6, 2.0),
            disc(27.3, -214.8 - longer, -205.0 - longer, 1.0, ALONG_Y, centre=(axis_x, 0.0)),
        ],
    }


def slim_forearm(sizes: Sizes) -> Parts:
    """Elbow motor, a slim beam and a fork that holds the motor of a parallel wrist."""
    end = sizes.forearm
    shell = [
        smooth_loft(
            [
                across_x(20.0, -2.0, 0.0, 25.0, 33.0),
                across_x(33.0, -1.5, -3.0, 26.0, 36.0),
                across_x(44.0, -3.0, -4.0, 25.0, 37.5),
                across_x(58.0, -4.5, -3.0, 22.5, 27.0),
                across_x(76.0, -5.5, -1.0, 20.5, 20.5),
                across_x(end - 130.0, -6.5, 0.0, 19.5, 19.0),
                across_x(end - 84.0, -6.5, 1.0, 20.0, 19.5),
                across_x(end - 66.0, -6.0, 3.0, 21.5, 25.0),
                across_x(end - 51.0, -5.0, 6.0, 22.0, 36.0),
                across_x(end - 36.0, -3.0, 8.0, 20.0, 38.5),
            ]
        )
    ]
    joint = [disc(30.0, -36.6, 36.6, 2.0)]
    for side in (-1.0, 1.0):
        outward = np.diag([1.0, 1.0, side])
        shell.append(prism([(end, 0.0, 27.5), (end - 40.0, -4.0, 19.0)], 32.5, 40.0, 3.0, outward))
        joint.append(disc(20.0, 38.5, 41.0, 1.2, outward, centre=(end, 0.0)))
    return {"shell": shell, "joint": joint}


def raised_wrist(sizes: Sizes) -> Parts:
    """The motor in the forearm's fork, and on a slanting arm the housing of the next one."""
    centre = (sizes.wrist, 0.0)
    return {
        "shell": [
            prism([(10.0, -6.0, 18.0), (52.0, -52.0, 21.0)], -22.5, 22.5, 5.0),
            disc(31.0, -80.5, -42.0, 3.0, ALONG_Y, centre=centre),
            disc(28.5, -44.0, -37.5, 1.0, ALONG_Y, centre=centre),
        ],
        "joint": [
            disc(28.0, -31.0, 31.0, 2.0),
            disc(22.0, -82.0, -79.0, 0.8, ALONG_Y, centre=centre),
        ],
    }


def hanging_hand(sizes: Sizes) -> Parts:
    """The last motor across the axis it hangs on."""
    face = -sizes.hand
    return {
        "shell": [
            disc(27.0, -34.5, -20.0, 1.5),
            prism(rectangle(25.0, 24.0, 14.0), -24.0, 22.0, 4.0),
            disc(28.5, face + 4.5, 26.5, 3.0, ALONG_Y),
        ],
        "joint": [
            disc(25.0, -37.0, -32.0, 0.8),
            disc(27.3, face + 2.2, face + 7.0, 0.5, ALONG_Y),
            disc(15.0, 24.0, 28.5, 1.0, ALONG_Y),
        ],
    }


def link4(sizes: Sizes) -> Parts:
    """Turning foot that carries the motor of the wrist's bend."""
    if sizes.wrist:
        return raised_wrist(sizes)
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


def link5(sizes: Sizes) -> Parts:
    """Side plate on the bending axis and the round housing of the last motor."""
    if sizes.wrist:
        return hanging_hand(sizes)
    longer = sizes.hand - 91.0
    return {
        "shell": [
            smooth_loft(
                [
                    across_y(-30.5, -24.0, 24.0, 24.5, 12.0),
                    across_y(-34.0, -26.0, 26.0, 26.5, 14.0),
                    across_y(-44.0, -27.5, 27.5, 28.0, 20.0),
                    across_y(-53.0 - longer, -28.5, 28.5, 28.5, 28.5),
                    across_y(-58.0 - longer, -28.5, 28.5, 28.5, 28.5),
                ]
            ),
            disc(28.5, -86.0 - longer, -54.0 - longer, 1.0, ALONG_Y),
            prism([(0.0, 0.0, 23.5), (0.0, -36.0, 25.0)], -31.0, -22.6, 3.5),
        ],
        "joint": [
            disc(15.0, -31.8, -28.0, 1.0),
            disc(27.3, -88.0 - longer, -80.0 - longer, 0.5, ALONG_Y),
        ],
    }


def link6(_sizes: Sizes) -> Parts:
    """The flange, a thin turning ring."""
    return {"joint": [disc(28.0, -2.6, 0.0, 0.6)]}


def gripper_base(_sizes: Sizes) -> Parts:
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


def finger_left(_sizes: Sizes) -> Parts:
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


def finger_right(sizes: Sizes) -> Parts:
    """The mirror image on the side of -y."""
    return {
        name: [mirrored(solid) for solid in solids] for name, solids in finger_left(sizes).items()
    }


LINKS = (
    base_link, link1, link2, link3, link4, link5, link6, gripper_base, finger_left, finger_right,
)  # fmt: skip


def all_parts(sizes: Sizes) -> dict[str, list[str]]:
    """Which parts, shell or joint, each link has."""
    return {link.__name__: list(link(sizes)) for link in LINKS}


def all_meshes(sizes: Sizes) -> dict[str, trimesh.Trimesh]:
    """Every mesh of an arm in metres, by the name of its file."""
    meshes = {}
    for link in LINKS:
        for part, solids in link(sizes).items():
            mesh = trimesh.util.concatenate(solids)
            mesh.apply_scale(0.001)
            meshes[f"{link.__name__}_{part}.stl"] = mesh
    return meshes


def main(folder: Path) -> None:
    """Write every mesh of every arm into its place in a folder."""
    for model in MODELS:
        place = folder / model / "meshes"
        place.mkdir(parents=True, exist_ok=True)
        total = 0
        for name, mesh in all_meshes(sizes_of(model)).items():
            (place / name).write_bytes(trimesh.exchange.stl.export_stl(mesh))
            total += len(mesh.faces)
        print(f"{model:8} {total:6} triangles")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
