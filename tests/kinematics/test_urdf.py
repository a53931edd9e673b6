"""The robot descriptions against the arms' Denavit–Hartenberg tables."""

from __future__ import annotations

import importlib
import math
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
import yourdfpy

from armui.arm.models import model_data, robot_description
from armui.kinematics.geometry import DhRow
from armui.protocol.generation import PiperModel
from armui.system.paths import URDF
from armui.viewport.process.urdf_file import load_robot
from tests.family import MODELS

ARM_JOINTS = [f"joint{number}" for number in range(1, 7)]


@pytest.fixture(params=MODELS)
def model(request) -> PiperModel:
    return request.param


@pytest.fixture(params=[False, True], ids=["", "older_zeros"])
def older_zeros(request) -> bool:
    return request.param


@pytest.fixture
def description(model, older_zeros) -> Path:
    return robot_description(model, older_zeros=older_zeros)


@pytest.fixture
def limits_deg(model) -> list[tuple[float, float]]:
    return [(each.min_deg, each.max_deg) for each in model_data(model).limits]


def flange_by_table(rows: Sequence[DhRow], angles_deg: np.ndarray) -> np.ndarray:
    """4×4 flange pose in mm: the textbook product of Rx(alpha) Tx(a) Rz(theta) Tz(d)."""
    pose = np.eye(4)
    for (a, alpha_deg, d, offset_deg), angle_deg in zip(rows, angles_deg, strict=True):
        ca, sa = math.cos(math.radians(alpha_deg)), math.sin(math.radians(alpha_deg))
        theta = math.radians(angle_deg + offset_deg)
        ct, st = math.cos(theta), math.sin(theta)
        pose = pose @ np.array(
            [
                [ct, -st, 0.0, a],
                [st * ca, ct * ca, -sa, -sa * d],
                [st * sa, ct * sa, ca, ca * d],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )
    return pose


def angle_between_deg(first: np.ndarray, second: np.ndarray) -> float:
    """Angle of the rotation between two rotation matrices, exact for tiny angles too."""
    difference = first.T @ second
    axis = np.array(
        [
            difference[2, 1] - difference[1, 2],
            difference[0, 2] - difference[2, 0],
            difference[1, 0] - difference[0, 1],
        ]
    )
    return math.degrees(math.atan2(float(np.linalg.norm(axis)), float(np.trace(difference)) - 1.0))


@pytest.fixture
def urdf(description) -> yourdfpy.URDF:
    return yourdfpy.URDF.load(
        str(description),
        load_meshes=False,
        build_scene_graph=True,
        build_collision_scene_graph=False,
    )


def flange_by_urdf(urdf: yourdfpy.URDF, angles_deg: np.ndarray) -> np.ndarray:
    urdf.update_cfg(dict(zip(ARM_JOINTS, np.radians(angles_deg), strict=True)))
    pose = np.array(urdf.get_transform("flange", "base_link"))
    pose[:3, 3] *= 1000.0
    return pose


@pytest.mark.each_value(full="each model with both zeros")
def test_flange_agrees_with_the_table_over_random_angles(model, older_zeros, urdf, limits_deg):
    data = model_data(model)
    rows = (data.older_geometry if older_zeros else data.geometry).rows
    random = np.random.default_rng(20240613)
    lower, upper = np.array(limits_deg, dtype=float).T
    for angles_deg in (np.zeros(6), *random.uniform(lower, upper, size=(500, 6))):
        expected = flange_by_table(rows, angles_deg)
        found = flange_by_urdf(urdf, angles_deg)
        assert np.linalg.norm(found[:3, 3] - expected[:3, 3]) < 1e-6, angles_deg
        assert angle_between_deg(expected[:3, :3], found[:3, :3]) < 1e-6, angles_deg


@pytest.mark.each_value(full="each model with both zeros")
def test_our_own_kinematics_of_the_picture_agree_with_yourdfpy(description, urdf):
    robot = load_robot(description)
    random = np.random.default_rng(7)
    for angles_deg in random.uniform(-120, 120, size=(50, 6)):
        opening_mm = float(random.uniform(0, 70))
        poses = robot.link_poses(angles_deg, opening_mm)
        joints = dict(zip(ARM_JOINTS, np.radians(angles_deg), strict=True))
        urdf.update_cfg({**joints, "gripper_left": np.array(opening_mm / 2000.0)})
        for link in (
            "link1",
            "link2",
            "link3",
            "link4",
            "link5",
            "flange",
            "gripper_base",
            "finger_left",
            "finger_right",
        ):
            np.testing.assert_allclose(
                poses[link], urdf.get_transform(link, "base_link"), atol=1e-9
            )


def test_limits_axes_and_speed_are_the_arms(model, urdf, limits_deg):
    speeds = [math.radians(each.max_speed_deg_s) for each in model_data(model).limits]
    for name, speed, (lower_deg, upper_deg) in zip(ARM_JOINTS, speeds, limits_deg, strict=True):
        joint = urdf.joint_map[name]
        assert joint.type == "revolute"
        assert list(joint.axis) == [0, 0, 1]
        assert math.degrees(joint.limit.lower) == pytest.approx(lower_deg, abs=1e-9)
        assert math.degrees(joint.limit.upper) == pytest.approx(upper_deg, abs=1e-9)
        assert joint.limit.velocity == pytest.approx(speed)


def test_the_gripper_opens_to_70_mm(urdf):
    def gap_mm(opening_mm: float) -> float:
        urdf.update_cfg({"gripper_left": np.array(opening_mm / 2000.0)})
        left = urdf.get_transform("finger_left", "gripper_base")[1, 3]
        right = urdf.get_transform("finger_right", "gripper_base")[1, 3]
        return float(left - right) * 1000.0

    assert gap_mm(0.0) == pytest.approx(0.0)
    assert gap_mm(70.0) == pytest.approx(70.0)
    assert urdf.joint_map["gripper_left"].limit.upper == pytest.approx(0.035)
    assert urdf.joint_map["gripper_right"].mimic.joint == "gripper_left"


def test_the_gripper_sits_as_the_model_says(model, urdf):
    turned = urdf.get_transform("gripper_base", "flange")
    angle_deg = math.degrees(math.atan2(turned[1, 0], turned[0, 0]))
    assert angle_deg == pytest.approx(model_data(model).gripper.turned_deg)


def test_angles_are_written_with_nine_digits(description):
    for element in ET.parse(description).iter("limit"):
        for bound in (element.get("lower"), element.get("upper")):
            if bound not in {"0", "0.035"}:
                assert len(bound.rpartition(".")[2]) >= 9


def test_meshes_are_named_by_relative_paths_that_exist(description):
    names = [mesh.get("filename") for mesh in ET.parse(description).iter("mesh")]
    assert len(names) == 19
    for name in names:
        assert name is not None
        assert not Path(name).is_absolute()
        assert "://" not in name
        assert (description.parent / name).is_file()


def test_the_committed_descriptions_are_what_the_script_writes(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(URDF))
    script = importlib.import_module("make_descriptions")
    script.main(tmp_path)
    committed = sorted(path.relative_to(URDF) for path in URDF.glob("*/*.urdf"))
    assert sorted(path.relative_to(tmp_path) for path in tmp_path.glob("*/*.urdf")) == committed
    assert len(committed) == 2 * len(MODELS)
    for path in committed:
        assert (tmp_path / path).read_text("utf-8") == (URDF / path).read_text("utf-8")
