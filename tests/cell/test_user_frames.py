"""User frames: by three points and as data, against scipy's rotations."""

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from armui.arm.refusal import Refusal
from armui.cell.cell import CELL_CHOICE_BAD, Cell, check_cell, with_part, without_part
from armui.cell.cell_file import CELL_FIELD_BAD, from_text, to_text
from armui.cell.checks import CELL_FIGURE_BAD, CELL_NAME_TAKEN
from armui.cell.user_frames import (
    FRAME_POINTS_IN_LINE,
    FRAME_POINTS_NEAR,
    UserFrame,
    frame_from_points,
)
from armui.kinematics.poses import from_base, to_base

TABLE = UserFrame("table", (300.0, -50.0, 20.0, 0.0, 0.0, 90.0))
RAMP = UserFrame("ramp", (10.0, 20.0, 30.0, 15.0, -20.0, 25.0))
ROUNDS = 1000


def rotation_of(pose):
    """R = Rz·Ry·Rx, which scipy calls extrinsic xyz."""
    return Rotation.from_euler("xyz", pose[3:], degrees=True)


def test_three_points_in_the_plane_of_the_table():
    frame = frame_from_points((300, -50, 20), (300, 100, 20), (100, 0, 20))
    assert frame == pytest.approx((300, -50, 20, 0, 0, 90), abs=1e-9)


def test_a_point_on_the_other_side_turns_z_over():
    frame = frame_from_points((0, 0, 0), (100, 0, 0), (30, -80, 0))
    assert rotation_of(frame).apply((0, 0, 1)) == pytest.approx((0, 0, -1), abs=1e-12)


def test_a_thousand_frames_by_three_points_are_the_oracles():
    random = np.random.default_rng(20)
    for _round in range(ROUNDS):
        turn = Rotation.random(random_state=random)
        origin = random.uniform(-700.0, 700.0, 3)
        along, off, slant = random.uniform((25, 25, -120), (400, 300, 120))
        on_x = origin + turn.apply((along, 0.0, 0.0))
        aside = origin + turn.apply((slant, off, 0.0))
        frame = frame_from_points(origin.tolist(), on_x.tolist(), aside.tolist())
        assert not isinstance(frame, Refusal)
        assert frame[:3] == pytest.approx(origin, abs=1e-9)
        assert (rotation_of(frame).inv() * turn).magnitude() < 1e-7


def test_a_thousand_poses_go_into_a_frame_and_back():
    random = np.random.default_rng(21)
    for _round in range(ROUNDS):
        low, high = (
            np.array((-700.0,) * 3 + (-180, -89, -180)),
            np.array((700.0,) * 3 + (180, 89, 180)),
        )
        pose, frame = random.uniform(low, high, (2, 6))
        held = from_base(pose, frame)
        expected = rotation_of(frame).inv().apply(pose[:3] - frame[:3])
        assert held[:3] == pytest.approx(expected, abs=1e-9)
        turned = rotation_of(frame).inv() * rotation_of(pose)
        assert (rotation_of(held).inv() * turned).magnitude() < 1e-7
        assert to_base(held, frame) == pytest.approx(tuple(pose), abs=1e-6)


def test_points_that_give_no_frame_are_refused_with_their_figures():
    near = frame_from_points((0, 0, 0), (19.9, 0, 0), (0, 50, 0))
    assert (near.reason, near.params) == (
        FRAME_POINTS_NEAR,
        {"point": "+X", "value": pytest.approx(19.9), "minimum": 20.0},
    )
    near = frame_from_points((0, 0, 0), (100, 0, 0), (0, 0, 12))
    assert (near.reason, near.params["point"]) == (FRAME_POINTS_NEAR, "+Y")
    for aside in ((100, 17, 0), (-100, 17, 0), (50, 0, 0)):
        line = frame_from_points((0, 0, 0), (100, 0, 0), aside)
        assert line.reason == FRAME_POINTS_IN_LINE
        assert line.params["minimum"] == 10.0
    assert frame_from_points((0, 0, 0), (100, 0, 0), (100, 17, 0)).params["value"] == pytest.approx(
        9.648, abs=1e-3
    )
    assert not isinstance(frame_from_points((0, 0, 0), (100, 0, 0), (-100, 18, 0)), Refusal)


def test_a_new_frame_is_chosen_and_a_renamed_one_stays_so():
    cell = with_part(Cell("bench"), TABLE)
    assert (cell.frame, cell.chosen_frame, cell.frames) == ("table", TABLE, (TABLE,))
    cell = with_part(cell, RAMP)
    assert with_part(cell, UserFrame("desk"), instead_of="table").frame == "ramp"
    cell = with_part(cell, UserFrame("slope", RAMP.pose), instead_of="ramp")
    assert (cell.frame, cell.chosen_frame.pose) == ("slope", RAMP.pose)
    cell = without_part(cell, UserFrame, "slope")
    assert (cell.frame, cell.chosen_frame, cell.frames) == ("", None, (TABLE,))
    assert not cell.is_empty


def test_frames_are_kept_in_the_file_and_older_files_have_none():
    cell = with_part(with_part(Cell("bench"), TABLE), RAMP)
    assert from_text(to_text(cell), "bench") == cell
    entries = json.loads(to_text(cell))
    assert entries["version"] == 1
    assert entries["frames"][1] == {
        "name": "ramp", "x_mm": 10.0, "y_mm": 20.0, "z_mm": 30.0,
        "rx_deg": 15.0, "ry_deg": -20.0, "rz_deg": 25.0,
    }  # fmt: skip
    del entries["frames"], entries["frame"]
    assert from_text(json.dumps(entries), "bench") == Cell("bench")


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"frame": "desk"}, CELL_CHOICE_BAD),
        ({"frames": {}}, CELL_FIELD_BAD),
        ({"frames": [{"name": "table"}]}, CELL_FIELD_BAD),
    ],
)
def test_frames_that_are_broken_are_refused_whole(change, reason):
    entries = {**json.loads(to_text(with_part(Cell("bench"), TABLE))), **change}
    assert from_text(json.dumps(entries), "bench").reason == reason


def test_a_frame_with_a_figure_too_much_or_a_name_twice_is_refused():
    far = UserFrame("far", (5000.1, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert check_cell(Cell("a", frames=(far,))).reason == CELL_FIGURE_BAD
    turned = UserFrame("turned", (0.0, 0.0, 0.0, 0.0, 0.0, 181.0))
    assert check_cell(Cell("a", frames=(turned,))).params["field"] == "rz_deg"
    assert check_cell(Cell("a", frames=(RAMP, UserFrame("RAMP")))).reason == CELL_NAME_TAKEN
