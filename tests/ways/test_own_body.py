"""How near parts of the arm are to each other, on the whole of a way."""

import itertools

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.arm.tool_capsule import ToolCapsule
from armui.cell.held_objects import HeldObject
from armui.cell.held_shape import held_shape
from armui.kinematics.forward import links
from armui.protocol.generation import PiperModel
from armui.ways.own_body import OwnBody, _carried, _pairs, _with
from tests.cell.sampled_ways import (
    HIGH,
    LOW,
    agrees,
    at,
    deviated,
    folded,
    least_just_kept,
    step,
    turn,
)
from tests.ways.segments import segment_distances

REST = (0.0, -2.0, 2.0, -1.4, 22.0, -2.6)
"""The pose in which the maker lays the arm down."""
PEN = ToolCapsule((40.0, 0.0, 160.0), 12.0)
ROD = HeldObject("rod", (0.0, 0.0, 150.0, 0.0, 30.0, 0.0), (20.0, 20.0, 180.0), is_rod=True)
PARCEL = HeldObject("parcel", (0.0, 0.0, 150.0, 0.0, 30.0, 0.0), (60.0, 200.0, 40.0))


def body_of(model, *, tool=None, held=None):
    data = model_data(model)
    gripper = data.gripper
    return OwnBody(data.geometry, gripper.reach_mm, gripper.turned_deg, tool, held)


@pytest.mark.each_value(full="each model with each load")
@pytest.mark.parametrize("model", PiperModel)
@pytest.mark.parametrize("carried", [{}, {"tool": PEN}, {"held": held_shape(PARCEL)}])
def test_gaps_are_those_of_the_parts_at_each_pose(model, carried):
    random = np.random.default_rng(5)
    poses = np.vstack((random.uniform(LOW, HIGH, (3000, 6)), random.uniform(-60, 60, (3000, 6))))
    data, body = model_data(model), body_of(model, **carried)
    gaps = body.gaps(poses)
    arm, gripper = links(data.geometry, poses), data.gripper
    met = (
        *_pairs(data.geometry, arm, gripper.reach_mm, gripper.turned_deg),
        *_with(data.geometry, arm, _carried(arm, carried.get("tool"), carried.get("held"))),
    )
    expected = np.full(gaps.shape, np.inf)
    for fixed, moving in met:
        pair = body.pairs.index(f"{fixed.part}/{moving.part}")
        lines = segment_distances(fixed.start, fixed.end, moving.start, moving.end)
        apart = lines - fixed.radius_mm - moving.radius_mm
        expected[:, pair] = np.minimum(expected[:, pair], apart)
    assert gaps == pytest.approx(expected, abs=1e-6)
    assert (gaps < 0.0).any(axis=1).sum() > 100


def test_a_gap_is_the_distance_of_the_surfaces():
    poses = np.random.default_rng(6).uniform(LOW, HIGH, (500, 6))
    geometry = model_data(PiperModel.PIPER).geometry
    body = body_of(PiperModel.PIPER)
    arm = links(geometry, poses)
    foot = np.zeros((len(poses), 3))
    column = (foot, foot + np.array((0.0, 0.0, geometry.base_mm)))
    forearm = (arm.elbow + geometry.elbow_mm * arm.across + 60.0 * arm.forearm, arm.wrist)
    expected = segment_distances(*column, *forearm) - 38.0 - 28.0
    assert body.gaps(poses)[:, body.pairs.index("base/forearm")] == pytest.approx(expected)


def test_at_rest_hand_and_base_touch():
    body = body_of(PiperModel.PIPER)
    gaps = dict(zip(body.pairs, body.gaps([REST])[0], strict=True))
    assert gaps.pop("base/hand") < 0.0
    assert min(gaps.values()) > 0.0


@pytest.mark.each_value(full="each sort of way with each load")
@pytest.mark.parametrize("kind", [turn, step, folded])
@pytest.mark.parametrize("carried", [{}, {"tool": PEN}, {"held": held_shape(ROD)}])
def test_what_is_told_agrees_with_places_tried_one_by_one(kind, carried):
    random = np.random.default_rng(7)
    told = []
    for model, _ in itertools.product(PiperModel, range(6)):
        body, way = body_of(model, **carried), kind(random)
        least = least_just_kept(random, body.gaps, way)
        breach = body.breach(way, least)
        which = None if breach is None else body.pairs.index(f"{breach.one}/{breach.other}")
        told.append(agrees(body.gaps, way, least, breach, which))
    assert 3 < sum(told) < 21


def test_no_way_that_begins_a_little_off_is_too_near():
    random = np.random.default_rng(8)
    clear = 0
    body = body_of(PiperModel.PIPER)
    for _ in range(40):
        way, spread = turn(random), random.uniform(0.0, 1.0, 6)
        places = np.linspace(0.0, 1.0, 40)
        gaps = np.array(
            [body.gaps(at(deviated(random, way, spread), places)).min(axis=0) for _ in range(16)]
        )
        least = gaps[:8].min(axis=0) - random.uniform(0.0, 30.0)
        if body.breach(way, least, spread) is None:
            clear += 1
            assert (gaps >= least - 1e-5).all()
        assert body.breach(way, gaps.min(axis=0) + 0.01, spread) is not None
    assert clear > 5


@pytest.mark.parametrize("turns", [(0, 0, 0, 0, -8, 0), (0, 0, -5, 0, 0, 0), (3, -1, -4, 2, -6, 1)])
def test_out_of_the_rest_pose_only_leads_what_takes_the_parts_apart(turns):
    body = body_of(PiperModel.PIPER)
    here = body.gaps([REST])[0]
    least = np.where(here < 0.0, here, -np.inf)
    out, further = (np.array((REST, np.add(REST, way * np.array(turns)))) for way in (1.0, -1.0))
    if body.gaps(out)[1].min() < here.min():
        out, further = further, out
    assert body.breach(out, least) is None
    told = body.breach(further, least)
    assert (told.one, told.other) == ("base", "hand")
    assert told.share < 0.1


@pytest.mark.parametrize("pose", [(np.nan,) * 6, (0.0,) * 5])
def test_what_is_no_figure_is_no_way(pose):
    body = body_of(PiperModel.PIPER)
    with pytest.raises(ValueError, match="deg"):
        body.breach([pose, pose], np.zeros(len(body.pairs)))


@pytest.mark.parametrize("carried", [{}, {"tool": PEN}, {"held": held_shape(PARCEL)}])
def test_a_contact_is_between_the_two_parts_that_touch(carried):
    random = np.random.default_rng(7)
    body, data = body_of(PiperModel.PIPER, **carried), model_data(PiperModel.PIPER)
    poses = random.uniform(LOW, HIGH, (2000, 6))
    gaps, arm, gripper = body.gaps(poses), links(data.geometry, poses), data.gripper
    met = (
        *_pairs(data.geometry, arm, gripper.reach_mm, gripper.turned_deg),
        *_with(data.geometry, arm, _carried(arm, carried.get("tool"), carried.get("held"))),
    )
    numbers = {"base": 0, "upper arm": 2, "forearm": 3, "gripper": 6, "tool": 6, "held object": 6}
    told = 0
    for pose, pair in zip(*np.nonzero(gaps < -1.0), strict=True):
        contact = body.contact(poses[pose], int(pair))
        place = np.array([contact.place_mm])
        away: dict[bool, list[float]] = {False: [], True: []}
        for fixed, moving in met:
            if f"{fixed.part}/{moving.part}" == body.pairs[pair]:
                for is_moving, each in ((False, fixed), (True, moving)):
                    start, end = (
                        np.broadcast_to(side, (len(poses), 3))[[pose]]
                        for side in (each.start, each.end)
                    )
                    line = segment_distances(place, place, start, end)[0]
                    away[is_moving].append(line - each.radius_mm)
        assert max(map(min, away.values())) < 1.0, "within both"
        names = body.pairs[pair].split("/")
        assert contact.links[0] == numbers[names[0]]
        assert contact.links[1] == numbers.get(names[1], 5)
        told += 1
    assert told > 50
