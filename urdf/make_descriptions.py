"""Writes the robot descriptions of the four arms: `python urdf/make_descriptions.py [FOLDER]`.

Each goes to `<model>/<model>.urdf` in the folder; joints and limits are those of
`<model>/model.json`. The link frames are the frames of the modified DH table, so a joint's angle in
the description is the angle on the bus. Firmware before S-V1.6-3 counts joints 2 and 3 from other
zeros: what its angles mean is described by `<model>/<model>_older_zeros.urdf`.
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

from make_meshes import MODELS, Sizes, all_parts, sizes_of

_DIGITS = 12
_BEAM_DEG = math.degrees(-0.23)
"""How the beam of the upper arm leans."""
_HEADER = """<?xml version="1.0" encoding="utf-8"?>
<!--
  {name}, six-joint arm, with the two-finger gripper.
  Written by make_descriptions.py from model.json.

  Geometry: the modified (Craig) Denavit-Hartenberg table of firmware {firmware}. Each link
  frame is the DH frame of the same number, so joint i turns about the z axis of link i, and a joint
  angle here is the angle on the bus (there in degrees, here in radians). Row i (a, alpha, d, theta
  offset) becomes
      <origin xyz="a  -d*sin(alpha)  d*cos(alpha)" rpy of Rx(alpha)*Rz(offset)>

      i   a/mm     alpha/deg   d/mm     offset/deg   limits/deg
{table}

  Lengths in metres, angles in radians. Speed limits are those of model.json ({speeds}); effort: the
  8 N.m that a torque command of the bus can ask for. Masses and their centres stand in model.json;
  inertial elements are left out, since no inertia that could be trusted is published.
  The meshes are made by make_meshes.py, in metres, each in the frame of its link.
-->
<robot name="{model}">
  <material name="shell">
    <color rgba="0.94 0.95 0.96 1"/>
  </material>
  <material name="joint">
    <color rgba="0.20 0.22 0.25 1"/>
  </material>
"""
_FLANGE = """
  <!-- the pose the arm reports (0x2A2-0x2A4) is the pose of this frame -->
  <joint name="flange_joint" type="fixed">
    <parent link="link6"/>
    <child link="flange"/>
  </joint>

  <link name="flange"/>

  <joint name="gripper_base_joint" type="fixed">{origin}
    <parent link="flange"/>
    <child link="gripper_base"/>
  </joint>
"""
_FINGERS = """
  <!-- Each finger travels half of the opening of 0-70 mm. Its force and speed are not published;
       effort and velocity, which the format demands, are this file's own choice. -->"""
_FINGER = """
  <joint name="gripper_{side}" type="prismatic">
    <parent link="gripper_base"/>
    <child link="finger_{side}"/>
    <axis xyz="0 {sign} 0"/>
    <limit lower="0" upper="0.035" effort="20" velocity="0.1"/>{mimic}
  </joint>
"""
_MIMIC = '\n    <mimic joint="gripper_left" multiplier="1" offset="0"/>'

Body = tuple[tuple[float, float, float], tuple[float, float, float], str]
"""Of a collision element: its middle in mm, its roll, pitch and yaw in degrees, and its shape."""


def cylinder(radius: float, length: float) -> str:
    """A cylinder along its own z axis, in mm."""
    return f'<cylinder radius="{_figure(radius / 1e3)}" length="{_figure(length / 1e3)}"/>'


def box(x: float, y: float, z: float) -> str:
    """A box, in mm."""
    return f'<box size="{_figure(x / 1e3)} {_figure(y / 1e3)} {_figure(z / 1e3)}"/>'


def bodies(sizes: Sizes) -> dict[str, list[Body]]:
    """Plain bodies for collisions, by link; a little within the covers."""
    level, lying = (0.0, 0.0, 0.0), (90.0, 0.0, 0.0)
    middle = (0.0, 0.0, 0.0)
    upper, longer = sizes.upper_arm, sizes.upper_arm - 285.03
    finger = box(56.0, 25.0, 76.5)
    found: dict[str, list[Body]] = {
        "base_link": [
            ((0.0, 0.0, 45.0), level, cylinder(36.0, 90.0)),
            ((-30.0, 0.0, 42.5), level, box(50.0, 60.0, 85.0)),
        ],
        "link1": [(middle, lying, cylinder(31.0, 74.0))],
        "link2": [
            (middle, level, cylinder(31.5, 97.0)),
            ((upper, 0.0, 0.0), level, cylinder(31.5, 97.0)),
            (
                (125.0 + longer / 2, -29.0, 0.0),
                (0.0, 0.0, _BEAM_DEG),
                box(260.0 + longer, 44.0, 60.0),
            ),
        ],
        "link6": [((0.0, 0.0, -3.5), level, cylinder(29.5, 7.0))],
        "gripper_base": [
            ((0.0, 0.0, 23.0), level, cylinder(30.5, 46.0)),
            ((0.0, 0.0, 54.0), level, box(50.0, 146.0, 26.0)),
        ],
        "finger_left": [((0.0, 12.5, 101.8), level, finger)],
        "finger_right": [((0.0, -12.5, 101.8), level, finger)],
    }
    if sizes.wrist:
        end = sizes.forearm
        found["link3"] = [
            (middle, level, cylinder(30.5, 80.0)),
            ((end, 0.0, 0.0), level, cylinder(27.5, 80.0)),
            ((end / 2, -5.0, 0.0), level, box(end - 60.0, 42.0, 50.0)),
        ]
        found["link4"] = [
            (middle, level, cylinder(28.5, 64.0)),
            ((sizes.wrist, -59.5, 0.0), lying, cylinder(31.0, 44.0)),
            ((32.0, -30.0, 0.0), (0.0, 0.0, -47.0), box(70.0, 40.0, 45.0)),
        ]
        found["link5"] = [
            ((0.0, -2.0, 0.0), lying, cylinder(28.5, 60.0)),
            ((0.0, 0.0, -28.0), level, cylinder(27.0, 16.0)),
        ]
        return found
    reach, hand = sizes.forearm - 250.75, sizes.hand - 91.0
    found["link3"] = [
        (middle, level, cylinder(30.5, 80.0)),
        ((sizes.elbow, -190.0 - reach, 0.0), lying, cylinder(29.5, 52.0)),
        ((sizes.elbow, -100.0 - reach / 2, 0.0), level, box(42.0, 150.0 + reach, 50.0)),
    ]
    found["link4"] = [
        (middle, lying, cylinder(31.0, 64.0)),
        ((0.0, 0.0, -31.0), level, cylinder(31.0, 10.0)),
    ]
    found["link5"] = [
        ((0.0, -57.0 - hand, 0.0), lying, cylinder(30.5, 56.0)),
        ((0.0, 0.0, -26.5), level, cylinder(24.0, 9.0)),
    ]
    return found


def describe(model: str, data: dict[str, Any], sizes: Sizes, *, older_zeros: bool = False) -> str:
    """The robot description of a model, as the text of its file.

    Args:
        model: Its name.
        data: What stands in its data file.
        sizes: Of its links.
        older_zeros: With those of firmware before S-V1.6-3.
    """
    shifts = data["older_zeros_deg"] if older_zeros else (0.0,) * len(data["dh"])
    rows = [
        (row["a_mm"], row["alpha_deg"], row["d_mm"], row["theta_deg"] + shift)
        for row, shift in zip(data["dh"], shifts, strict=True)
    ]
    ranges = [joint["range_deg"] for joint in data["joints"]]
    table = "\n".join(
        f"      {number}   {a:<9g}{alpha:<12g}{d:<9g}{theta:<13g}{low:g} .. {high:g}"
        for number, ((a, alpha, d, theta), (low, high)) in enumerate(
            zip(rows, ranges, strict=True), start=1
        )
    )
    shapes, meshes = bodies(sizes), all_parts(sizes)
    firmware = "before S-V1.6-3" if older_zeros else "S-V1.6-3 and later"
    text = _HEADER.format(
        name=data["name"], model=model, table=table, firmware=firmware, speeds=data["speeds"]
    )
    text += _link("base_link", meshes, shapes)
    for number, (row, (low, high)) in enumerate(zip(rows, ranges, strict=True), start=1):
        parent = "base_link" if number == 1 else f"link{number - 1}"
        speed = data["joints"][number - 1]["max_speed_rad_s"]
        text += _joint(number, parent, row, math.radians(low), math.radians(high), speed=speed)
        text += _link(f"link{number}", meshes, shapes)
    turned = math.radians(data["gripper"]["turned_deg"])
    origin = f'\n    <origin xyz="0 0 0" rpy="0 0 {_angle(turned)}"/>' if turned else ""
    text += _FLANGE.format(origin=origin) + _link("gripper_base", meshes, shapes) + _FINGERS
    for side, sign, mimic in (("left", "1", ""), ("right", "-1", _MIMIC)):
        text += _FINGER.format(side=side, sign=sign, mimic=mimic)
        text += _link(f"finger_{side}", meshes, shapes)
    return text + "</robot>\n"


def roll_pitch_yaw(alpha_deg: float, theta_deg: float) -> tuple[float, float, float]:
    """The angles of Rx(alpha)·Rz(theta) in radians, for α of 0 or ±90°."""
    theta = math.radians(math.remainder(theta_deg, 360.0))
    if alpha_deg == 0:
        return 0.0, 0.0, theta
    # Rx(±90°)·Rz(t) = Ry(∓t)·Rx(±90°)
    return math.radians(alpha_deg), -math.copysign(1.0, alpha_deg) * theta, 0.0


def _joint(
    number: int,
    parent: str,
    row: tuple[float, float, float, float],
    low: float,
    high: float,
    *,
    speed: float,
) -> str:
    a, alpha_deg, d, theta_deg = row
    alpha = math.radians(alpha_deg)
    xyz = (a / 1e3, -d / 1e3 * math.sin(alpha), d / 1e3 * math.cos(alpha))
    angles = " ".join(_angle(each) for each in roll_pitch_yaw(alpha_deg, theta_deg))
    return f"""
  <joint name="joint{number}" type="revolute">
    <origin xyz="{" ".join(map(_figure, xyz))}" rpy="{angles}"/>
    <parent link="{parent}"/>
    <child link="link{number}"/>
    <axis xyz="0 0 1"/>
    <limit lower="{_angle(low)}" upper="{_angle(high)}" effort="8" velocity="{speed:g}"/>
  </joint>
"""


def _link(name: str, meshes: dict[str, list[str]], shapes: dict[str, list[Body]]) -> str:
    text = f'\n  <link name="{name}">\n'
    for part in meshes[name]:
        text += f"""    <visual>
      <geometry>
        <mesh filename="meshes/{name}_{part}.stl"/>
      </geometry>
      <material name="{part}"/>
    </visual>
"""
    for middle, turned_deg, shape in shapes[name]:
        xyz = " ".join(_figure(each / 1e3) for each in middle)
        rpy = " ".join(_angle(math.radians(each)) for each in turned_deg)
        text += f"""    <collision>
      <origin xyz="{xyz}" rpy="{rpy}"/>
      <geometry>
        {shape}
      </geometry>
    </collision>
"""
    return text + "  </link>\n"


def _angle(radians: float) -> str:
    return "0" if abs(radians) < 1e-12 else f"{radians:.{_DIGITS}f}"


def _figure(value: float) -> str:
    return f"{round(value, 9) + 0.0:.9g}"


def main(folder: Path) -> None:
    """Write every description into its place in a folder."""
    for model in MODELS:
        data = json.loads((Path(__file__).parent / model / "model.json").read_text("utf-8"))
        for older_zeros in (False, True):
            path = folder / model / f"{model}{'_older_zeros' if older_zeros else ''}.urdf"
            path.parent.mkdir(parents=True, exist_ok=True)
            text = describe(model, data, sizes_of(model), older_zeros=older_zeros)
            path.write_text(text, "utf-8", newline="\n")
            print(path)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
