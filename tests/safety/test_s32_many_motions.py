"""S32, S35, S36: motions of all kinds in random cells: no mesh of the arm comes into any zone.

Few seeds of `tests.safety.many_motions`, which plays thousands; and whether its oracle is right.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.tools import Tool
from armui.cell.work_area import AreaBox, AreaPlane
from armui.protocol.generation import PiperModel
from tests.cell.areas import area_of, wall
from tests.cell.test_area_oracle import gap_mm, meshes_mm, solid
from tests.cell.test_enclosure import own, random_deg, vertices_mm
from tests.control.jogger import BENT_DEG
from tests.safety import many_motions
from tests.safety.many_motions import JOG_KINDS, KINDS
from tests.safety.mesh_oracle import Judge, MeshOracle

SINGLE = ("joints", "MOVE P", "MOVE L", "MOVE C", "home", "second")
MOTIONS: list[tuple[int, int | tuple[str, ...]]] = [
    (44, SINGLE),
    (53, ("quick steps", "small steps")),
    (44, ("run", "replay")),
    (5, 3),
    (2043, tuple(JOG_KINDS)),
]
"""Seeds whose arms hold something and come near to a zone, and what each plays."""


@pytest.mark.parametrize(("seed", "motions"), MOTIONS)
def test_no_motion_of_ours_comes_into_a_zone(qapp, seed, motions):
    """Seed 5 has a motion that came 8 mm too near while ramps of the joints were left out."""
    found = many_motions.play(seed, motions)
    assert len(found) == (motions if isinstance(motions, int) else len(motions))
    assert any(each.taken for each in found)
    assert [each for each in found if each.depth_mm > 0.0 or each.intrudes] == []


def test_every_kind_is_played():
    played = {name for _, names in MOTIONS if not isinstance(names, int) for name in names}
    assert played >= {*KINDS, *JOG_KINDS} - {"second again"}


def test_a_seed_plays_the_same_again(qapp):
    once, again = (many_motions.play(1, 2) for _ in range(2))
    assert [(each.kind, each.taken, each.least) for each in once] == [
        (each.kind, each.taken, each.least) for each in again
    ]


# The oracle -------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", PiperModel)
def test_gaps_are_those_of_the_description_by_another_reader(model):
    """Planes by every corner of the meshes as yourdfpy places them, boxes by python-fcl."""
    rng, robot = np.random.default_rng(3), meshes_mm(model)
    for pose in random_deg(model, 4, 5):
        place = rng.uniform((-300.0, -300.0, 0.0), (300.0, 300.0, 600.0))
        turns = rng.uniform(-180.0, 180.0, 3)
        box = AreaBox("box", (*place, *turns), tuple(rng.uniform(20.0, 200.0, 3)))
        ahead = wall(50.0)
        found = MeshOracle(box, ahead, model=model).look(pose, 30.0)
        by_fcl = gap_mm(robot, pose, 0.015, solid(box))
        assert max(found["box"].mm, 0.0) == pytest.approx(max(by_fcl, 0.0), abs=0.01)
        furthest = vertices_mm(own(model), pose, 0.015)[:, 0].max()
        if furthest > 120.0:  # the base, which reaches less far, is no part of the oracle
            assert found["wall"].mm == pytest.approx(50.0 - furthest, abs=0.01)


def test_a_depth_is_how_far_a_box_must_shrink():
    box = AreaBox("box", (300.0, 0.0, 300.0, 10.0, 20.0, 30.0), (200.0, 200.0, 200.0))
    found = MeshOracle(box).nearest(BENT_DEG)
    assert -100.0 < found.mm < -1.0
    smaller = replace(box, size_mm=tuple(200.0 + 2.0 * found.mm - 0.1 for _ in range(3)))
    larger = replace(box, size_mm=tuple(200.0 + 2.0 * found.mm + 0.1 for _ in range(3)))
    assert MeshOracle(smaller).nearest(BENT_DEG).mm >= 0.0
    assert MeshOracle(larger).nearest(BENT_DEG).mm < 0.0


def test_a_way_is_judged_between_its_ends():
    """A thin post stands in the middle of a turn of joint 1."""
    post = AreaBox("post", (150.0, 214.0, 300.0, 0.0, 0.0, 0.0), (20.0, 20.0, 600.0))
    oracle, beyond = MeshOracle(post), (100.0, *BENT_DEG[1:])
    ends = min(oracle.nearest(each).mm for each in (BENT_DEG, beyond))
    assert ends > 10.0
    fine = [
        oracle.nearest(tuple(np.array(BENT_DEG) + share * (np.array(beyond) - BENT_DEG))).mm
        for share in np.linspace(0.0, 1.0, 200)
    ]
    assert min(fine) < 0.0
    assert oracle.along(BENT_DEG, beyond).mm == pytest.approx(min(fine), abs=1.5)
    judge = Judge(oracle)
    for share in np.linspace(0.0, 1.0, 12):
        judge.see(tuple(np.array(BENT_DEG) + share * (np.array(beyond) - BENT_DEG)))
    assert judge.least.mm == pytest.approx(min(fine), abs=1.5)


def test_what_the_flange_carries_counts_by_its_figures():
    plane = AreaPlane("floor", (0.0, 0.0, -2000.0, 0.0, 0.0, 0.0))
    bare = Cell("c", area=area_of(plane))
    tool = replace(bare, tools=(Tool("t", (0.0, 0.0, 900.0, 0, 0, 0), 10.0),), tool="t")
    rod = HeldObject("h", (0.0, 0.0, 500.0, 0, 0, 0), (40.0, 40.0, 900.0), is_rod=True)
    held = replace(bare, held_objects=(rod,), held="h")
    tip, axis = flange(BENT_DEG)
    sunk = 2000.0 + (tip + 900.0 * axis)[2] - 10.0 * math.hypot(*axis[:2])
    assert MeshOracle.of(tool).nearest(BENT_DEG).mm == pytest.approx(sunk, abs=0.1)
    end = 2000.0 + (tip + 930.0 * axis)[2] - 20.0
    assert MeshOracle.of(held).nearest(BENT_DEG).mm == pytest.approx(end, abs=0.1)
    touching = replace(held, held_objects=(replace(rod, may_touch=("floor",)),))
    assert MeshOracle.of(touching).nearest(BENT_DEG) == MeshOracle.of(bare).nearest(BENT_DEG)


def flange(joints_deg):
    """The flange's place and the direction it points in."""
    own(PiperModel.PIPER).update_cfg(
        {f"joint{n + 1}": np.radians(angle) for n, angle in enumerate(joints_deg)}
        | {"gripper_left": 0.0}
    )
    placed = own(PiperModel.PIPER).get_transform("flange", "base_link")
    return 1e3 * placed[:3, 3], placed[:3, 2]
