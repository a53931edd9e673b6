"""The first place on a way that is too near, against places tried one by one."""

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.cell.area_check import AreaCheck, carried_body
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.work_area import AreaBox, AreaPlane
from armui.kinematics.forward import links
from armui.kinematics.poses import pose_to_matrix
from armui.protocol.generation import PiperModel
from tests.cell.areas import TABLE, area_of, check_of, wall
from tests.cell.plain_gaps import box_gaps, enclose, plane_gaps
from tests.cell.sampled_ways import (
    HIGH,
    LOW,
    agrees,
    at,
    corners,
    dense,
    deviated,
    least_just_kept,
    step,
    turn,
    whole,
)

BENT = np.array((0.0, 60.0, -60.0, 0.0, 40.0, 0.0))
BODY = carried_body(PiperModel.PIPER, model_data(PiperModel.PIPER).geometry, (0.0,) * 6, None)


def bent(*turns):
    """The bent pose, with the first joints turned on by so much."""
    return BENT + np.append(turns, np.zeros(6 - len(turns)))


def random_zones(random, planes, boxes):
    return (
        *(
            AreaPlane(
                f"plane {number}",
                (*random.uniform(-500.0, 500.0, 3), *random.uniform(-180.0, 180.0, 3)),
            )
            for number in range(planes)
        ),
        *(
            AreaBox(
                f"box {number}",
                (
                    *random.uniform((-600.0, -600.0, -100.0), (600.0, 600.0, 800.0)),
                    *random.uniform(-180.0, 180.0, 3),
                ),
                tuple(random.uniform(10.0, 250.0, 3)),
            )
            for number in range(boxes)
        ),
    )


@pytest.mark.each_value(full="five times as many random zones")
@pytest.mark.parametrize("kind", [turn, step, whole, dense, corners])
@pytest.mark.parametrize("seed", range(5))
def test_what_is_told_agrees_with_places_tried_one_by_one(kind, seed):
    random = np.random.default_rng(seed)
    told = []
    for number in range(30):
        zones = random_zones(random, int(random.integers(0, 2)), int(random.integers(1, 4)))
        check = check_of(*zones, model=list(PiperModel)[number % len(PiperModel)])
        way = kind(random)
        least = least_just_kept(random, check.gaps, way)
        breach = check.breach(way, least)
        which = None if breach is None else zones.index(breach.zone)
        told.append(agrees(check.gaps, way, least, breach, which))
    assert 3 < sum(told) < 27


@pytest.mark.parametrize("kind", [turn, step, dense])
def test_no_way_that_begins_a_little_off_is_too_near(kind):
    random = np.random.default_rng(3)
    clear = 0
    for _ in range(20):
        check = check_of(*random_zones(random, 1, 2))
        way, spread = kind(random), random.uniform(0.0, 1.0, 6)
        places = np.linspace(0.0, len(way) - 1.0, 30)
        gaps = np.array(
            [check.gaps(at(deviated(random, way, spread), places)).min(axis=0) for _ in range(16)]
        )
        least = gaps[:8].min(axis=0) - random.uniform(0.0, 30.0)
        if check.breach(way, least, spread) is None:
            clear += 1
            assert (gaps >= least - 1e-5).all()
        assert check.breach(way, gaps.min(axis=0) + 0.01, spread) is not None
    assert clear > 3


@pytest.mark.parametrize("turned", [0, 1, 2, 3, 4])
def test_a_spread_counts_by_how_far_it_leads_towards_a_zone(turned):
    check = check_of(AreaPlane("ceiling", (0.0, 0.0, 800.0, 180.0, 0.0, 0.0)))
    spread = np.zeros(6)
    spread[turned] = 1.0
    # at the way's begin the arm may be anywhere in this
    (gaps,) = check.gaps(BENT + np.linspace(-1.0, 1.0, 201)[:, None] * spread).T
    assert check.breach([BENT, BENT], [gaps.min() - 0.3], spread) is None
    assert check.breach([BENT, BENT], [gaps.min() + 0.01], spread) is not None


@pytest.mark.parametrize(
    "zone", [AreaBox("box", (330.0, 20.0, 250.0, 20.0, 30.0, 40.0), (100.0, 90.0, 60.0)), wall(330)]
)
def test_what_lies_at_its_least_gap_may_leave(zone):
    check = check_of(TABLE, zone)
    away = np.array((BENT, bent(0.0, -30.0)))
    least, there = check.gaps(away)
    assert there[1] > least[1] + 50.0
    assert check.breach(away, least) is None
    back = check.breach(away[::-1], least + np.array((0.0, 0.001)))
    assert back.zone == zone
    assert back.index + back.share > 0.9


def test_turning_about_the_table_s_normal_stays_as_near_as_it_is():
    check = check_of(TABLE)
    way = np.array((BENT, bent(140.0)))
    assert check.breach(way, check.gaps([BENT])[0]) is None


def test_the_first_of_several_is_told():
    near = AreaBox("near", (250.0, 150.0, 350.0, 0.0, 0.0, 0.0), (60.0, 60.0, 300.0))
    far = AreaBox("far", (0.0, 270.0, 350.0, 0.0, 0.0, 0.0), (60.0, 60.0, 300.0))
    way = np.array((BENT, bent(60.0), bent(120.0)))
    check = check_of(far, near)
    there, back = (check.breach(each, (10.0, 10.0)) for each in (way, way[::-1]))
    assert (there.zone, back.zone) == (near, far)
    assert there.part in {"hand", "gripper", "forearm", "wrist"}
    only = check.breach(way, (10.0, -np.inf))
    assert only.zone == far
    assert only.index + only.share > there.index + there.share
    assert check.breach(way, (-np.inf, -np.inf)) is None


def test_a_pose_alone_and_nothing_at_all():
    check = check_of(TABLE)
    (gap,) = check.gaps([BENT])[0]
    assert check.breach([BENT], [gap - 0.01]) is None
    told = check.breach([BENT], [gap + 0.01])
    assert (told.index, told.share) == (0, 0.0)
    assert told.gap_mm == pytest.approx(gap)
    assert check.breach([BENT, BENT, BENT], [gap - 0.01]) is None
    assert check.breach(np.empty((0, 6)), [gap]) is None
    assert check_of().breach([BENT, -BENT], []) is None


@pytest.mark.parametrize(
    ("way", "least", "spread"),
    [
        (np.full((2, 6), np.nan), [10.0], None),
        (np.zeros((2, 6)), [np.nan], None),
        (np.zeros((2, 6)), [10.0], (np.inf,) * 6),
        (np.zeros((2, 6)), [10.0], (-1.0,) * 6),
        (np.zeros((2, 5)), [10.0], None),
    ],
)
def test_what_is_no_figure_is_no_way(way, least, spread):
    with pytest.raises(ValueError, match=r"deg|mm"):
        check_of(TABLE).breach(way, least, spread)


def test_what_may_touch_a_zone_is_not_asked_of_it():
    pose = (0.0, 0.0, 150.0, 0.0, 0.0, 0.0)
    held = HeldObject("rod", pose, (10.0, 10.0, 100.0), may_touch=("table",))
    cell = Cell("bench", held_objects=(held,), held="rod", area=area_of(TABLE))
    body = carried_body(PiperModel.PIPER, BODY.geometry, (0.0,) * 6, cell)
    bare, holding = check_of(TABLE), AreaCheck(area_of(TABLE), body)
    way = np.array((BENT, bent(0.0, 30.0)))
    least = bare.gaps(way).min(axis=0)
    assert holding.gaps(way) == pytest.approx(bare.gaps(way))
    assert holding.breach(way, least - 0.5) is None
    assert holding.breach(way, least + 0.1).part != "held object"


def test_gaps_are_those_of_the_nearest_part():
    random = np.random.default_rng(4)
    zones = random_zones(random, 3, 20)
    check = check_of(*zones)
    poses = random.uniform(LOW, HIGH, (40, 6))
    capsules = enclose(BODY, poses)
    frames = pose_to_matrix(np.array([zone.pose for zone in zones]))
    sizes = np.array([box.size_mm for box in zones[3:]])
    planes, boxes = plane_gaps(capsules, frames[:3]), box_gaps(capsules, frames[3:], sizes)
    all_gaps = np.concatenate((planes, boxes), axis=2)
    assert check.gaps(poses) == pytest.approx(all_gaps.min(axis=1))
    for pose, each in zip(poses, all_gaps, strict=True):
        looked = check.nearest_entries(pose)
        assert [entry.gap_mm for entry in looked] == pytest.approx(np.sort(each.min(axis=0)))
        nearest = capsules.parts[np.unravel_index(each.argmin(), each.shape)[0]]
        assert looked[0].part == nearest


def test_gaps_of_no_pose_and_of_no_zone():
    assert check_of(TABLE).gaps(np.empty((0, 6))).shape == (0, 1)
    assert check_of().gaps([BENT]).shape == (1, 0)


def test_a_contact_is_between_the_link_and_what_it_comes_to():
    pose = (0.0, 90.0, -60.0, 0.0, 30.0, 0.0)
    arm = links(model_data(PiperModel.PIPER).geometry, np.array([pose]))
    before, _, high = (arm.flange[0] + 150.0 * arm.hand[0]).tolist()
    post = AreaBox("post", (before + 50.0, 0.0, high, 0.0, 0.0, 0.0), (20.0,) * 3)
    check = check_of(wall(before), post)
    for zone, gap_mm in enumerate(check.gaps(pose)[0].tolist()):
        contact = check.contact(pose, zone)
        assert (contact.joints_deg, contact.links) == (pose, (6,))
        surface = before + 40.0 if zone else before
        assert contact.place_mm[0] == pytest.approx(surface - gap_mm / 2.0, abs=3.0)
        assert np.abs(np.subtract(contact.place_mm[1:], (0.0, high))).max() < 60.0
