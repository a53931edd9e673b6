"""The first place on a way that is too near, against places tried one by one."""

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.cell.area_check import AreaCheck, carried_body
from armui.cell.cell import Cell
from armui.cell.clearance import box_gaps, plane_gaps
from armui.cell.enclosure import enclose
from armui.cell.held_objects import HeldObject
from armui.cell.work_area import AreaBox, AreaPlane
from armui.kinematics.poses import pose_to_matrix
from armui.protocol.generation import PiperModel
from tests.cell.areas import TABLE, area_of, check_of, wall

LOW = np.array((-150.0, 0.0, -170.0, -100.0, -70.0, -120.0))
HIGH = np.array((150.0, 180.0, 0.0, 100.0, 70.0, 120.0))
BENT = np.array((0.0, 60.0, -60.0, 0.0, 40.0, 0.0))
FURTHEST_MM = np.array((1000.0, 1000.0, 700.0, 350.0, 350.0, 250.0))
"""No joint moves anything by more for a radian, whichever the model."""
SAMPLED_MM = 0.25
BODY = carried_body(PiperModel.PIPER, model_data(PiperModel.PIPER).geometry, (0.0,) * 6, None)
OFFSETS_MM = (-30.0, -3.0, -0.6, -0.1, 0.05, 0.3, 0.7, 3.0)


def bent(*turns):
    """The bent pose, with the first joints turned on by so much."""
    return BENT + np.append(turns, np.zeros(6 - len(turns)))


def at(way, places):
    """The poses of a way at places, as `Breach` counts them."""
    index = np.minimum(np.floor(places).astype(int), len(way) - 2)
    return way[index] + (places - index)[:, None] * (way[index + 1] - way[index])


def least_excess(check, way, least_mm, *, below_mm=0.7):
    """The least of gap less what is kept on a way, and the first place sampled where it is below 0.

    All places where it may be below `below_mm` are sampled by `SAMPLED_MM`.
    """
    places = np.arange(len(way), dtype=float)
    values = (check.gaps(way) - least_mm).min(axis=1)
    while True:
        travel = np.radians(np.abs(np.diff(at(way, places), axis=0))) @ FURTHEST_MM
        known = (values[:-1] + values[1:] - travel) / 2.0
        open_ = np.flatnonzero((known < below_mm) & (travel > SAMPLED_MM))
        if not len(open_):
            break
        middles = (places[open_] + places[open_ + 1]) / 2.0
        order = np.argsort(np.concatenate((places, middles)), kind="stable")
        found = (check.gaps(at(way, middles)) - least_mm).min(axis=1)
        places = np.concatenate((places, middles))[order]
        values = np.concatenate((values, found))[order]
    below = np.flatnonzero(values < 0.0)
    return values.min(), places[below[0]] if len(below) else None


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


def turn(random):
    start = random.uniform(LOW, HIGH)
    end = start.copy()
    joints = random.choice(6, random.integers(1, 4), replace=False)
    end[joints] += random.uniform(-200.0, 200.0, len(joints))
    return np.array((start, end))


def step(random):
    start = random.uniform(LOW, HIGH)
    return np.array((start, start + random.uniform(-1.0, 1.0, 6)))


def whole(random):
    return random.uniform(LOW, HIGH, (2, 6))


def dense(random):
    start = random.uniform(LOW, HIGH)
    turns = np.linspace(0.0, 1.0, 40)[:, None] * random.uniform(-40.0, 40.0, 6)
    return start + turns + 2.0 * np.sin(3.0 * np.radians(turns))


def corners(random):
    return random.uniform(LOW, HIGH) + random.uniform(-20.0, 20.0, (5, 6))


@pytest.mark.parametrize("kind", [turn, step, whole, dense, corners])
@pytest.mark.parametrize("seed", range(3))
def test_what_is_told_agrees_with_places_tried_one_by_one(kind, seed):
    random = np.random.default_rng(seed)
    told = clear = 0
    for number in range(50):
        zones = random_zones(random, int(random.integers(0, 2)), int(random.integers(1, 4)))
        check = check_of(*zones, model=list(PiperModel)[number % len(PiperModel)])
        way = kind(random)
        sampled = check.gaps(at(way, np.linspace(0.0, len(way) - 1.0, 100)))
        # every zone is asked, one of them so that the way only just keeps off it, or not quite
        least = sampled.min(axis=0) - random.uniform(0.0, 100.0, len(zones))
        asked = int(random.integers(len(zones)))
        least[asked] = sampled[:, asked].min() + random.choice(OFFSETS_MM)
        breach = check.breach(way, least)
        excess, first = least_excess(check, way, least)
        if breach is None:
            clear += 1
            assert excess > -1e-5
            continue
        told += 1
        assert excess < 0.6
        place = breach.index + breach.share
        assert first is None or place <= first + 1e-9
        index = check.zones.index(breach.zone)
        (gaps,) = check.gaps(at(way, np.array([place])))
        assert gaps[index] <= breach.gap_mm + 1e-6
        assert breach.gap_mm < least[index] + 0.5
    assert told > 5
    assert clear > 5


def deviated(random, way, spread):
    """A way that begins off by no more than the spread."""
    off = spread * random.choice((-1.0, 1.0, random.uniform(-1.0, 1.0)), 6)
    return way + off * np.linspace(1.0, 0.0, len(way))[:, None]


@pytest.mark.parametrize("kind", [turn, step, dense])
def test_no_way_that_begins_a_little_off_is_too_near(kind):
    random = np.random.default_rng(3)
    clear = 0
    for _ in range(40):
        check = check_of(*random_zones(random, 1, 2))
        way, spread = kind(random), random.uniform(0.0, 1.0, 6)
        ways = [deviated(random, way, spread) for _ in range(6)]
        places = np.linspace(0.0, len(way) - 1.0, 60)
        gaps = np.array([check.gaps(at(each, places)).min(axis=0) for each in ways])
        least = gaps.min(axis=0) - random.uniform(0.0, 60.0)
        if check.breach(way, least, spread) is None:
            clear += 1
            for each in (*ways, *(deviated(random, way, spread) for _ in range(10))):
                assert (check.gaps(at(each, places)) >= least - 1e-5).all()
        nearer = gaps.min(axis=0) + 0.01
        assert check.breach(way, nearer, spread) is not None
    assert clear > 5


def test_a_tool_step_from_a_spread_start_is_not_told_far_too_early():
    check = check_of(TABLE)
    way = np.array((BENT, bent(0.0, 0.0, 1.0, 0.0, -1.0)))
    spread = np.array((0.5, 0.0, 0.0, 0.0, 0.0, 0.0))
    (gap,) = check.gaps(way).min(axis=0)
    assert check.breach(way, [gap - 1.0], spread) is None


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
    held = HeldObject("rod", (0.0, 0.0, 150.0, 0.0, 0.0, 0.0), (10.0, 10.0, 100.0), ("table",))
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
        looked = check.look(pose)
        assert [entry.gap_mm for entry in looked] == pytest.approx(np.sort(each.min(axis=0)))
        nearest = capsules.parts[np.unravel_index(each.argmin(), each.shape)[0]]
        assert looked[0].part == nearest


def test_gaps_of_no_pose_and_of_no_zone():
    assert check_of(TABLE).gaps(np.empty((0, 6))).shape == (0, 1)
    assert check_of().gaps([BENT]).shape == (1, 0)
