"""The committed meshes: closed, of the arm's sizes, and what the script makes."""

import importlib

import numpy as np
import pytest
import trimesh

from armui.arm.models import model_folder
from armui.protocol.generation import PiperModel
from armui.system.paths import URDF
from armui.viewport.process.geometry import is_closed
from armui.viewport.process.robot import Surface
from armui.viewport.process.urdf_file import load_robot
from tests.family import MODELS

# Outer sizes in the frame of each link, mm, measured on the arms: low x y z, high x y z.
SIZES_MM = {
    "base_link": ((-58.5, -40, 0), (40, 40, 86)),
    "link1": ((-36, -37, -43), (36, 37, 30)),
    "link2": ((-31.5, -65, -48.5), (316.5, 31.5, 48.5)),
    "link3": ((-50.5, -214.8, -40), (30, 30, 40)),
    "link4": ((-30, -28.5, -36), (30, 34, 28.5)),
    "link5": ((-30, -91, -31), (30, 23.5, 30)),
    "gripper_base": ((-30, -72.5, 0), (30, 72.5, 67)),
    "finger_left": ((-28, 0, 63.5), (28, 25, 140)),
    "finger_right": ((-28, -25, 63.5), (28, 0, 140)),
}
OTHERS_MM: dict[PiperModel, dict[str, tuple[tuple[float, ...], tuple[float, ...]]]] = {
    PiperModel.PIPER: {},
    PiperModel.PIPER_H: {
        "link3": ((-50.5, -219.8, -40), (30, 30, 40)),
        "link5": ((-30, -95, -31), (30, 23.5, 30)),
    },
    PiperModel.PIPER_L: {
        "link2": ((-31.5, -74, -48.5), (369.9, 31.5, 48.5)),
        "link3": ((-51.5, -284.7, -40), (30, 30, 40)),
    },
    PiperModel.PIPER_X: {
        "link3": ((-30, -30, -40), (301.1, 30, 41)),
        "link4": ((-28, -81.5, -31), (107, 28, 31)),
        "link5": ((-28.5, -34, -36), (28.5, 28.5, 29)),
    },
}


@pytest.fixture(scope="module", params=MODELS)
def model(request):
    return request.param


@pytest.fixture(scope="module")
def committed(model):
    folder = model_folder(model) / "meshes"
    return {path.name: trimesh.load(path) for path in sorted(folder.glob("*.stl"))}


@pytest.mark.each_value(full="each link of each model")
@pytest.mark.parametrize("link", SIZES_MM)
def test_each_link_has_the_size_of_the_arms(link, model, committed):
    parts = [committed[f"{link}_shell.stl"], committed[f"{link}_joint.stl"]]
    low = np.min([part.bounds[0] for part in parts], axis=0) * 1000.0
    high = np.max([part.bounds[1] for part in parts], axis=0) * 1000.0
    sizes = OTHERS_MM[model].get(link, SIZES_MM[link])
    np.testing.assert_allclose([low, high], sizes, atol=3.0)


def test_every_solid_is_closed_and_turned_outward(committed):
    for name, mesh in committed.items():
        assert mesh.is_watertight, name
        for solid in mesh.split():
            assert solid.volume > 0.0, name


def test_the_whole_arm_is_light_enough_to_draw(committed):
    assert 15_000 <= sum(len(mesh.faces) for mesh in committed.values()) <= 25_000


def test_the_committed_files_are_what_the_script_makes(model, committed, monkeypatch):
    monkeypatch.syspath_prepend(str(URDF))
    script = importlib.import_module("make_meshes")
    made = script.all_meshes(script.sizes_of(model))
    assert made.keys() == committed.keys()
    for name, mesh in made.items():
        # The last bits may differ between processors; a micrometre may not.
        np.testing.assert_allclose(mesh.triangles, committed[name].triangles, atol=1e-6)


@pytest.mark.parametrize("model", MODELS)
def test_every_part_is_a_body_of_which_only_one_side_is_seen(model):
    robot = load_robot(next(model_folder(model).glob("*.urdf")))
    assert all(is_closed(part.surface) for part in robot.parts)


def test_a_surface_with_a_hole_or_inside_out_is_seen_from_both_sides():
    box = trimesh.creation.box()
    whole = Surface(np.array(box.vertices), np.array(box.faces))
    assert is_closed(whole)
    split = Surface(np.array(box.triangles).reshape(-1, 3), np.arange(36).reshape(-1, 3))
    assert is_closed(split)  # the same corners, not merged
    assert not is_closed(Surface(whole.vertices, whole.faces[1:]))
    assert not is_closed(Surface(whole.vertices, whole.faces[:, ::-1]))
    one_turned = whole.faces.copy()
    one_turned[3] = one_turned[3, ::-1]
    assert not is_closed(Surface(whole.vertices, one_turned))
