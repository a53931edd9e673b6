"""The base in the room: heights, the room's frame, mountings and files; SciPy is the oracle."""

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from armui.arm.refusal import Refusal
from armui.cell.cell import CELL_CHOICE_BAD, Cell, check_cell, placed
from armui.cell.cell_file import CELL_FIELD_BAD, CELL_VERSION, differences, from_text, to_text
from armui.cell.checks import CELL_FIGURE_BAD, CELL_NAME_TAKEN
from armui.cell.placement import WORLD, Placement
from armui.cell.user_frames import UserFrame
from armui.protocol.codes import Mounting
from armui.sim.mechanics.gravity import DOWN_BY_MOUNTING
from armui.viewport.camera import HOME_CAMERA, ON_THE_FLOOR, ViewDirection
from armui.viewport.robot_shape import pose_rows
from armui.viewport.viewpoint import Viewpoint

ON_A_TABLE = Placement((1000.0, 200.0, 750.0, 0.0, 0.0, 90.0))
UPSIDE_DOWN = Placement((0.0, 0.0, 1200.0, 180.0, 0.0, 0.0))
BENCH = placed(Cell("bench"), ON_A_TABLE)


def random_placements(count=200):
    random = np.random.default_rng(7)
    for _ in range(count):
        place, turns = random.uniform(-3000.0, 3000.0, 3), random.uniform(-180.0, 180.0, 3)
        yield Placement((*place.tolist(), *turns.tolist()))


def test_heights_are_those_of_the_room():
    places = np.random.default_rng(8).uniform(-900.0, 900.0, (5, 3))
    for placement in random_placements():
        turn = Rotation.from_euler("xyz", placement.pose[3:], degrees=True)
        wanted = (turn.apply(places) + placement.pose[:3])[:, 2]
        *up, base_mm = placement.rising
        np.testing.assert_allclose(places @ up + base_mm, wanted, atol=1e-9)


def test_the_frame_of_the_room_is_where_the_room_is_seen_from_the_base():
    for placement in random_placements():
        turn = Rotation.from_euler("xyz", placement.pose[3:], degrees=True).inv()
        frame = placement.world
        assert frame.name == WORLD
        np.testing.assert_allclose(frame.pose[:3], turn.apply(-np.array(placement.pose[:3])))
        found = Rotation.from_euler("xyz", frame.pose[3:], degrees=True)
        assert (found * turn.inv()).magnitude() < 1e-9


def test_a_base_that_is_not_placed_stands_upright_on_the_floor():
    assert Placement().rising == (0.0, 0.0, 1.0, 0.0)
    assert (Placement().world, Placement().mounting) == (None, Mounting.LEVEL)
    assert (Cell("bench").is_empty, BENCH.is_empty) == (True, False)
    assert (Cell("bench").all_frames, len(BENCH.all_frames)) == ((), 1)


MOUNTED = {
    "upright, turned": ((0.0, 0.0, 40.0, 0.0, 0.0, 123.0), Mounting.LEVEL),
    "a little aslant": ((0.0, 0.0, 40.0, 15.0, 0.0, 0.0), Mounting.LEVEL),
    "on its left side": ((0.0, 0.0, 900.0, -90.0, 0.0, 0.0), Mounting.ON_THE_LEFT_SIDE),
    "on its right side": ((0.0, 0.0, 900.0, 90.0, 0.0, 30.0), Mounting.ON_THE_RIGHT_SIDE),
    "hanging": ((0.0, 0.0, 900.0, 180.0, 0.0, 0.0), Mounting.UPSIDE_DOWN),
    "hanging, about Y": ((0.0, 0.0, 900.0, 0.0, 180.0, 0.0), Mounting.UPSIDE_DOWN),
    "at a wall": ((0.0, 0.0, 900.0, 0.0, 90.0, 0.0), None),
    "between": ((0.0, 0.0, 900.0, 45.0, 0.0, 0.0), None),
}


@pytest.mark.parametrize("name", MOUNTED)
def test_a_tilt_wants_the_mounting_that_pulls_the_arm_down_in_the_room(name):
    pose, wanted = MOUNTED[name]
    assert Placement(pose).mounting is wanted
    if wanted is not None:
        turn = Rotation.from_euler("xyz", pose[3:], degrees=True)
        assert turn.apply(DOWN_BY_MOUNTING[wanted])[2] < -0.94


def test_it_is_kept_in_the_file_and_raises_its_version_only_then():
    assert json.loads(to_text(Cell("bench")))["version"] == 1
    assert "placement" not in json.loads(to_text(Cell("bench")))
    entries = json.loads(to_text(BENCH))
    assert entries["version"] == 2
    assert entries["placement"] == {
        "x_mm": 1000.0,
        "y_mm": 200.0,
        "z_mm": 750.0,
        "rx_deg": 0.0,
        "ry_deg": 0.0,
        "rz_deg": 90.0,
    }
    assert from_text(to_text(BENCH), "bench") == BENCH
    assert from_text(to_text(BENCH).replace('"version": 2', '"version": 3'), "bench").reason == (
        CELL_VERSION
    )


BROKEN: dict[str, tuple[dict[str, object], object]] = {
    "a figure missing": ({"x_mm": 1.0}, CELL_FIELD_BAD),
    "too far": ({"x_mm": 5000.1}, CELL_FIGURE_BAD),
    "a text": ({"z_mm": "high"}, CELL_FIELD_BAD),
    "an unknown figure": ({"w_mm": 1.0}, CELL_FIELD_BAD),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_what_is_broken_is_refused_whole(fault):
    change, reason = BROKEN[fault]
    entries = json.loads(to_text(BENCH))
    kept = {} if fault == "a figure missing" else entries["placement"]
    answer = from_text(json.dumps({**entries, "placement": {**kept, **change}}), "bench")
    assert isinstance(answer, Refusal)
    assert answer.reason == reason


def test_two_cells_are_compared_by_it():
    raised = placed(BENCH, Placement((1000.0, 200.0, 760.0, 0.0, 0.0, 90.0)))
    (difference,) = differences(BENCH, raised)
    assert (difference.place, difference.before, difference.after) == ("placement.z_mm", 750, 760)


def test_the_name_of_the_room_is_taken_while_the_base_is_placed():
    frame = UserFrame("world", (1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert check_cell(Cell("bench", frames=(frame,))) is None
    refusal = check_cell(Cell("bench", frames=(frame,), placement=ON_A_TABLE))
    assert refusal.reason == CELL_NAME_TAKEN
    assert check_cell(Cell("bench", frame=WORLD)).reason == CELL_CHOICE_BAD
    shown = Cell("bench", frame=WORLD, placement=ON_A_TABLE)
    assert check_cell(shown) is None
    assert placed(shown, Placement()) == Cell("bench")


def test_the_picture_has_the_room_upright():
    for placement in random_placements(50):
        camera = Viewpoint()
        camera.set_placement(pose_rows(placement.pose))
        turn = Rotation.from_euler("xyz", placement.pose[3:], degrees=True)
        axes = turn.apply(np.array(camera.camera.axes()))
        np.testing.assert_allclose(axes, HOME_CAMERA.axes(), atol=1e-12)
        eye = turn.apply(camera.camera.eye_m) + np.array(placement.pose[:3]) / 1000.0
        assert camera.camera.height_m == pytest.approx(eye[2])
        camera.look_from(ViewDirection.TOP)
        assert turn.apply(camera.camera.axes()[0])[2] == pytest.approx(1.0)
        camera.reset()
        assert camera.camera.placement == pose_rows(placement.pose)
    assert HOME_CAMERA.placement == ON_THE_FLOOR == pose_rows((0.0,) * 6)


def test_an_eye_moved_by_hand_stays_above_the_floor_of_the_room():
    hanging = Viewpoint()
    hanging.set_placement(pose_rows(UPSIDE_DOWN.pose))
    camera = hanging.camera
    for _ in range(40):
        camera = camera.orbit(0.0, -30.0).pan(0.0, -80.0, 600.0)
    assert camera.height_m >= -1e-9
