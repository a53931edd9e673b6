"""The capsules hold every part of every arm."""

import os
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy

from armui.arm.models import model_data, model_folder, robot_description
from armui.cell.enclosure import PARTS, Capsule, body_of
from armui.kinematics.forward import flange_transforms, link_frames
from armui.protocol.generation import PiperModel
from tests.cell.plain_gaps import enclose

MAKERS = os.environ.get("PIPER_DESCRIPTION", "")
"""The folder of the maker's own description of the PiPER, which is not part of this project."""
OPENING_MM = 70.0


@cache
def robot(path: Path, meshes: Path) -> yourdfpy.URDF:
    def found(fname):
        return str(meshes / Path(fname).name)

    return yourdfpy.URDF.load(str(path), filename_handler=found, build_collision_scene_graph=False)


def own(model, *, older_zeros=False):
    path = robot_description(model, older_zeros=older_zeros)
    return robot(path, model_folder(model) / "meshes")


def random_deg(model, count, seed):
    limits = model_data(model).limits
    low, high = ([getattr(each, name) for each in limits] for name in ("min_deg", "max_deg"))
    return np.random.default_rng(seed).uniform(low, high, (count, 6))


def vertices_mm(urdf, joints_deg, finger_m):
    """All corners of the robot's meshes in its base frame."""
    names = urdf.actuated_joint_names
    values = {f"joint{index + 1}": np.radians(angle) for index, angle in enumerate(joints_deg)}
    urdf.update_cfg({name: values.get(name, finger_m) for name in names})
    placed = [urdf.scene.graph[name] for name in urdf.scene.graph.nodes_geometry]
    return 1000.0 * np.concatenate(
        [
            trimesh.transform_points(urdf.scene.geometry[mesh].vertices, transform)
            for transform, mesh in placed
        ]
    )


def beyond_mm(points, body, joints_deg):
    """How far each point is outside of all capsules; negative inside."""
    capsules = enclose(body, np.array([joints_deg]))
    best = np.full(len(points), np.inf)
    for start, end, radius in zip(
        capsules.starts[0], capsules.ends[0], capsules.radii, strict=True
    ):
        along = end - start
        share = (points - start) @ along / max(float(along @ along), 1e-12)
        nearest = start + np.clip(share, 0.0, 1.0)[:, None] * along
        best = np.minimum(best, np.linalg.norm(points - nearest, axis=1) - radius)
    return best


@pytest.mark.parametrize("older_zeros", [False, True])
@pytest.mark.parametrize("model", PiperModel)
def test_the_frames_of_the_links_are_those_of_the_description(model, older_zeros):
    urdf = own(model, older_zeros=older_zeros)
    geometry = model_data(model).geometry_with(older_zeros=older_zeros)
    poses = random_deg(model, 20, 1)
    frames = link_frames(geometry, poses)
    assert frames[:, 6] == pytest.approx(flange_transforms(geometry, poses), abs=1e-6)
    for pose, placed in zip(poses, frames, strict=True):
        urdf.update_cfg({f"joint{index + 1}": np.radians(a) for index, a in enumerate(pose)})
        for index in range(7):
            name = f"link{index}" if index else "base_link"
            shown = urdf.get_transform(name, "base_link")
            assert placed[index, :3, :3] == pytest.approx(shown[:3, :3], abs=1e-5)
            assert placed[index, :3, 3] == pytest.approx(shown[:3, 3] * 1000.0, abs=0.01)


@pytest.mark.parametrize("model", PiperModel)
def test_every_corner_of_the_meshes_is_inside(model):
    geometry = model_data(model).geometry
    body = body_of(model, geometry, OPENING_MM, base=True)
    for pose, opening in zip(random_deg(model, 12, 2), np.linspace(0, 0.035, 12), strict=True):
        corners = vertices_mm(own(model), pose, opening)
        assert beyond_mm(corners, body, pose).max() < -3.0


@pytest.mark.skipif(not MAKERS, reason="PIPER_DESCRIPTION names no folder of the maker's meshes")
def test_the_makers_own_meshes_are_inside():
    """Its description counts from the zeros before S-V1.6-3, joints 4 to 6 in its own way."""
    urdf = robot(Path(MAKERS, "urdf/piper_description.urdf"), Path(MAKERS, "meshes"))
    body = body_of(
        PiperModel.PIPER, model_data(PiperModel.PIPER).older_geometry, OPENING_MM, base=True
    )
    for pose in random_deg(PiperModel.PIPER, 6, 3):
        shown = pose * (1, 1, 1, -1, 1, -1) - (0, 0, 0, 0, 5, 0)
        assert beyond_mm(vertices_mm(urdf, shown, 0.0), body, pose).max() < 0.0


def test_the_base_counts_only_if_it_is_asked_for():
    geometry = model_data(PiperModel.PIPER).geometry
    bare = body_of(PiperModel.PIPER, geometry, 0.0)
    assert {each.part for each in bare.capsules} == set(PARTS) - {"base", "tool", "held object"}
    assert "base" in {
        each.part for each in body_of(PiperModel.PIPER, geometry, 0, base=True).capsules
    }


def test_a_tool_moves_with_the_flange():
    geometry = model_data(PiperModel.PIPER).geometry
    bare = body_of(PiperModel.PIPER, geometry, 0.0)
    body = bare.with_more(Capsule("tool", 6, (0.0, 0.0, 0.0), (0.0, 0.0, 200.0), 5.0))
    pose = np.array([(10.0, 60.0, -50.0, 20.0, 30.0, 40.0)])
    placed = enclose(body, pose)
    flange = flange_transforms(geometry, pose)[0]
    assert placed.parts[-1] == "tool"
    assert placed.starts[0, -1] == pytest.approx(flange[:3, 3])
    assert placed.ends[0, -1] == pytest.approx(flange[:3, 3] + 200.0 * flange[:3, 2])
