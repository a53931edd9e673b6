"""Random ways of the joints, and what is told about them against places tried one by one."""

import numpy as np

LOW = np.array((-150.0, 0.0, -170.0, -100.0, -70.0, -120.0))
HIGH = np.array((150.0, 180.0, 0.0, 100.0, 70.0, 120.0))
FURTHEST_MM = np.array((1000.0, 1000.0, 700.0, 350.0, 350.0, 250.0))
"""No joint moves anything by more for a radian, whichever the model."""
SAMPLED_MM = 0.25
SAME_MM = 1e-5
OFFSETS_MM = (-30.0, -3.0, -0.6, -0.1, -0.01, 0.05, 0.3, 3.0)


def turn(random):
    """Some joints turn far."""
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
    """Many poses, as those of a line of the tool."""
    turns = np.linspace(0.0, 1.0, 40)[:, None] * random.uniform(-40.0, 40.0, 6)
    return random.uniform(LOW, HIGH) + turns + 2.0 * np.sin(3.0 * np.radians(turns))


def corners(random):
    return random.uniform(LOW, HIGH) + random.uniform(-20.0, 20.0, (5, 6))


def folded(random):
    """Near the rest pose, where parts of the arm are near each other."""
    return random.uniform(-60.0, 60.0, (3, 6))


def at(way, places):
    """The poses of a way at places: 1.5 is midway between the second and the third."""
    index = np.minimum(np.floor(places).astype(int), len(way) - 2)
    return way[index] + (places - index)[:, None] * (way[index + 1] - way[index])


def deviated(random, way, spread):
    """A way that begins off by no more than the spread, often at its bounds."""
    off = spread * np.clip(random.uniform(-2.0, 2.0, 6), -1.0, 1.0)
    return way + off * np.linspace(1.0, 0.0, len(way))[:, None]


def least_excess(gaps, way, least_mm):
    """The least of gap less what is kept on a way; what may be below 0 is sampled by 0.25 mm."""
    places = np.arange(len(way), dtype=float)
    values = (gaps(way) - least_mm).min(axis=1)
    while True:
        travel = np.radians(np.abs(np.diff(at(way, places), axis=0))) @ FURTHEST_MM
        may_be = (values[:-1] + values[1:] - travel) / 2.0 < 0.0
        middles = ((places[:-1] + places[1:]) / 2.0)[may_be & (travel > SAMPLED_MM)]
        if not len(middles):
            return float(values.min())
        order = np.argsort(np.concatenate((places, middles)), kind="stable")
        found = (gaps(at(way, middles)) - least_mm).min(axis=1)
        places = np.concatenate((places, middles))[order]
        values = np.concatenate((values, found))[order]


def least_just_kept(random, gaps, way):
    """What is kept so that a way only just keeps it from one thing, or not quite."""
    sampled = gaps(at(way, np.linspace(0.0, len(way) - 1.0, 100))).min(axis=0)
    least = sampled - random.uniform(0.0, 60.0, len(sampled))
    asked = int(random.integers(len(sampled)))
    least[asked] = sampled[asked] + random.choice(OFFSETS_MM)
    return least


def agrees(gaps, way, least_mm, breach, which):
    """Judge an answer, and return whether something was told.

    Args:
        gaps: The function that measures at poses.
        way: The way.
        least_mm: What is kept.
        breach: The answer.
        which: The index of what it names.
    """
    if breach is None:
        assert least_excess(gaps, way, least_mm) > -SAME_MM
        return False
    place = np.array([breach.index + breach.share])
    there = at(way, place)
    found = gaps(there)[0, which]
    assert breach.gap_mm > found - SAME_MM
    assert found < least_mm[which] + 0.5
    if place[0] > 0.0:
        # nothing on the way to it is too near
        before = np.vstack((way[: breach.index + 1], there))
        assert least_excess(gaps, before, least_mm) > -SAME_MM
    return True
