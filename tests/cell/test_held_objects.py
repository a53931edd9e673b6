"""What the hand holds, as capsules and edges: never smaller than it, by places all over it."""

from dataclasses import replace

import numpy as np
import pytest

from armui.cell.area_check import AreaCheck, carried_body
from armui.cell.cell import CELL_CHOICE_BAD, Cell, check_cell, with_part
from armui.cell.cell_file import from_text, to_text
from armui.cell.checks import CELL_FIGURE_BAD, CELL_NAME_TAKEN
from armui.cell.held_objects import HeldObject
from armui.cell.held_shape import held_shape
from armui.cell.work_area import AreaBox, AreaPlane, Zone
from armui.kinematics.forward import flange_transforms
from armui.kinematics.poses import matrix_to_pose, pose_to_matrix
from armui.protocol.codes import EndLoad
from armui.protocol.generation import PiperModel
from armui.trajectory.planning.check import BELOW_FLOOR, CheckRequest
from armui.trajectory.planning.check import check as checked
from tests.cell.areas import area_of
from tests.cell.test_enclosure import random_deg
from tests.each import check_each
from tests.family import PIPER
from tests.trajectory.arms import ARM, HERE, collisions, joint, run

MARGIN_MM = 10.0


def places(held, count, rng):
    """Places all over the surface of an object in the flange: corners, edges, sides."""
    half = np.array(held.size_mm) / 2.0
    if held.is_rod:
        radius = max(half[0], half[1])
        directions = rng.normal(size=(count, 3))
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        along = np.zeros((count, 3))
        along[:, 2] = rng.choice((-1.0, -0.4, 0.0, 0.7, 1.0), count) * max(half[2] - radius, 0.0)
        local = along + radius * directions
    else:
        local = rng.uniform(-1.0, 1.0, (count, 3))
        local[np.arange(count), rng.integers(0, 3, count)] = rng.choice((-1.0, 1.0), count)
        corners = np.array(np.meshgrid(*[(-1.0, 1.0)] * 3)).reshape(3, -1).T
        local = np.concatenate((local, corners)) * half
    frame = pose_to_matrix(held.pose)
    return local @ frame[:3, :3].T + frame[:3, 3]


def random_object(rng):
    pose = (*rng.uniform((-60, -60, 60), (60, 60, 220)), *rng.uniform(-180, 180, 3))
    return HeldObject("it", pose, tuple(rng.uniform(5.0, 220.0, 3)), bool(rng.integers(0, 2)))


def check_of_held(held, zone, *, alone=True):
    """The check of an arm with something in its hand; of that alone, without the arm."""
    cell = Cell("c", area=area_of(zone), held_objects=(held,), held=held.name)
    body = carried_body(PiperModel.PIPER, PIPER, (0.0,) * 6, cell)
    if alone:
        capsules = tuple(each for each in body.capsules if each.part == "held object")
        body = replace(body, capsules=capsules)
    return AreaCheck(cell.area, body)


def box_gap_mm(points, box):
    frame = pose_to_matrix(box.pose)
    beyond = np.abs((points - frame[:3, 3]) @ frame[:3, :3]) - np.array(box.size_mm) / 2.0
    return float(np.linalg.norm(np.maximum(beyond, 0.0), axis=1).min())


def test_no_touch_of_a_held_object_is_unsaid():
    """1,000 random objects, poses and obstacles: what the check says against places on it."""
    rng = np.random.default_rng(11)
    poses = random_deg(PiperModel.PIPER, 1000, 5)
    unsaid, said, further_mm = 0, 0, []
    for number, joints_deg in enumerate(poses):
        held = random_object(rng)
        flange = flange_transforms(PIPER, np.array(joints_deg))
        points = places(held, 400, rng) @ flange[:3, :3].T + flange[:3, 3]
        aside = points.mean(axis=0) + rng.normal(size=3) * 120.0
        turn = tuple(rng.uniform(-180.0, 180.0, 3))
        if number % 2:
            zone: Zone = AreaPlane("zone", (*aside, *turn))
            normal = pose_to_matrix(zone.pose)[:3, 2]
            gap = float(((points - aside) @ normal).min())
        else:
            zone = AreaBox("zone", (*aside, *turn), tuple(rng.uniform(10, 150, 3)))
            gap = box_gap_mm(points, zone)
        found = check_of_held(held, zone).gaps([joints_deg]).min() < MARGIN_MM
        unsaid += not found and gap <= MARGIN_MM - 2.0
        if found:
            said += 1
            further_mm.append(gap - MARGIN_MM)
    assert unsaid == 0
    assert said > 200
    # false alarms: by no more than the hull is wider, 16 mm for five bars of 220 mm, and by what
    # lies between the places
    assert max(further_mm) < 16.3 + 12.0


def test_planes_are_asked_of_it_exactly():
    cube = HeldObject("cube", (0.0, 0.0, 140.0, 0.0, 0.0, 30.0), (60.0, 40.0, 50.0))
    shape = held_shape(cube)
    ups = (0.0, 0.0, 1.0)
    assert float(shape.lowest(0.0, ups)) == pytest.approx(115.0)
    assert float(shape.lowest(0.0, (0.0, 0.0, -1.0))) == pytest.approx(-165.0)
    rod = HeldObject("rod", (0.0, 0.0, 100.0, 90.0, 0.0, 0.0), (20.0, 30.0, 200.0), is_rod=True)
    assert float(held_shape(rod).lowest(0.0, ups)) == pytest.approx(85.0)
    assert float(held_shape(rod).lowest(0.0, (0.0, 1.0, 0.0))) == pytest.approx(-100.0)


def test_it_may_touch_what_it_names_and_the_fingers_may_not():
    joints_deg = (0.0, 60.0, -60.0, 0.0, 30.0, 0.0)
    flange = flange_transforms(PIPER, np.array(joints_deg))

    def part(may_touch, ahead_mm):
        """What is nearest to a tray so far ahead of the flange; the cube ends at 190 mm."""
        middle = flange[:3, 3] + ahead_mm * flange[:3, 2]
        *_, rx, ry, rz = matrix_to_pose(flange)
        zone = AreaBox("tray", (*middle, rx, ry, rz), (20.0, 20.0, 20.0))
        pose = (0.0, 0.0, 180.0, 0.0, 0.0, 0.0)
        cube = HeldObject("cube", pose, (20.0, 20.0, 20.0), may_touch=may_touch)
        found = check_of_held(cube, zone, alone=False).nearest_entries(joints_deg)
        return [entry.part for entry in found if entry.gap_mm < MARGIN_MM]

    assert part((), 201.0) == ["held object"]
    assert part(("table",), 201.0) == ["held object"]
    assert part(("tray",), 201.0) == []
    assert part(("tray",), 145.0) == ["gripper"]


def test_a_held_object_that_hits_the_arm_is_found():
    """It reaches back through the wrist, into the forearm."""
    back = HeldObject("bar", (0.0, 0.0, -150.0, 0.0, 0.0, 0.0), (30.0, 30.0, 400.0))
    geometry, joints = ARM.kinematics.geometry, np.array([HERE])
    assert collisions(geometry, joints, ARM.tool_mm) == {}
    hits = collisions(geometry, joints, ARM.tool_mm, held=held_shape(back))
    assert [pair.split("/")[1] for pair in hits.values()] == ["held object"]


def test_the_lowest_place_of_what_is_held_is_said():
    cube = HeldObject("cube", (0.0, 0.0, 140.0, 0.0, 0.0, 0.0), (50.0, 50.0, 50.0))
    low = (0.0, 90.0, -30.0, 0.0, 40.0, 0.0)
    rng = np.random.default_rng(2)
    flange = flange_transforms(ARM.kinematics.geometry, np.array(low))
    depth = -float((places(cube, 10, rng) @ flange[2, :3] + flange[2, 3]).min())
    arm = replace(ARM, held=held_shape(cube))
    outcome = checked(CheckRequest(run(joint(*low)), arm, HERE))
    found = [each for each in outcome.findings if each.kind == BELOW_FLOOR]
    assert [each.params["value"] for each in found] == [pytest.approx(depth, abs=0.051)]


def test_it_is_kept_in_the_cells_file():
    held = HeldObject("杯", (1.0, 2.0, 3.0, 4.0, 5.0, 6.0), (10.0, 20.0, 30.0), True, 0.4, ("t",))
    cell = Cell("bench", held_objects=(held,), held="杯")
    assert from_text(to_text(cell), "bench") == cell
    assert from_text(to_text(cell).replace('"held": "杯"', '"held": "x"'), "bench").params == {
        "value": "x"
    }


CUBE = HeldObject("cube")
BAD = {
    CELL_CHOICE_BAD: Cell("c", held_objects=(CUBE,), held="ball"),
    CELL_NAME_TAKEN: Cell("c", held_objects=(CUBE, HeldObject("Cube"))),
    CELL_FIGURE_BAD: Cell("c", held_objects=(HeldObject("cube", size_mm=(0.0, 1.0, 1.0)),)),
}


def test_impossible_objects_are_refused():
    def check(reason):
        assert check_cell(BAD[reason]).reason == reason

    check_each(BAD, check)


def test_renamed_it_is_still_held():
    cell = Cell("c", held_objects=(CUBE,), held="cube")
    renamed = with_part(cell, HeldObject("box"), instead_of="cube")
    assert (renamed.held, renamed.held_object) == ("box", HeldObject("box"))


def test_the_class_of_payload():
    loads = {0.0: EndLoad.EMPTY, 0.2: EndLoad.HALF, 0.75: EndLoad.HALF, 0.8: EndLoad.FULL}
    assert {mass: HeldObject("x", mass_kg=mass).load for mass in loads} == loads
