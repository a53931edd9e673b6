"""S36: who is outside may only stay or come back; what is tolerated for noise is granted once."""

from dataclasses import replace

import numpy as np
import pytest

from armui.arm.refusal import Contact, Reason
from armui.ways.law import Excess, Marks, judge, judge_end
from armui.ways.way import Way, rest_of, straight_way

TOO_FAR = Reason("too_far", "{value} too far")
STILL = (0.0,) * 6


class Wall:
    """Joint 1 may turn to 10; noise is 1."""

    name = "wall"
    bounds: tuple[str, ...] = ("wall",)
    noise, exact = 1.0, 0.01
    reaches_mm: tuple[float, ...] = ()

    def __init__(self, *, may_stay: bool = True) -> None:
        self.may_stay = may_stay

    def outside(self, joints_deg):
        return joints_deg[:, :1] - 10.0

    def breach(self, way, allowed):
        found = self.outside(way.joints_deg) + np.array(way.spread_deg[0])
        over = np.flatnonzero(found[:, 0] > allowed[0])
        if not len(over):
            return None
        place = int(over[0])
        return Excess(0, float(found[place, 0]), tuple(way.joints_deg[place]))

    def finely(self, way):
        shares = np.linspace(0.0, 1.0, 50)[:, None]
        parts = [
            a + shares * (b - a)
            for a, b in zip(way.joints_deg[:-1], way.joints_deg[1:], strict=True)
        ]
        return np.vstack([way.joints_deg[:1], *parts])

    def refuse(self, breach, *, found_outside):
        return TOO_FAR(value=breach.outside, found=found_outside)

    def contact(self, breach):
        return Contact(breach.joints_deg, (1,), (0.0, 0.0, 0.0))


def at(angle):
    return (float(angle), *STILL[1:])


def go(marks, *angles, wall=None):
    way = Way(np.array([at(angle) for angle in angles]))
    return judge(way, [wall or Wall()], marks)


def test_a_refusal_knows_where_and_counts_as_the_same_elsewhere():
    one, other = (go({}, 0.0, angle).refusal for angle in (12.0, 12.4))
    assert one.contact.joints_deg == pytest.approx(at(12.0))
    assert one.contact != other.contact
    one, other = (replace(each, params={}) for each in (one, other))
    assert one == other
    assert repr(one) == repr(other), "by which the log of events counts what repeats"


@pytest.mark.parametrize(
    ("angles", "passes"),
    [
        ((0, 9.9), True),
        ((0, 10), True),
        ((0, 10.5), False),
        ((0, 10.9, 10), True),
        ((0, 11.2, 10), False),
        ((10.8, 10.8), True),
        ((10.8, 10.9), False),
        ((10.8, 9), True),
    ],
    ids=str,
)
def test_a_target_keeps_the_bound_in_full_and_noise_is_allowed_on_the_way(angles, passes):
    assert (go({}, *angles).refusal is None) is passes


def test_noise_is_granted_once_however_many_motions_there_are():
    marks: Marks = {}
    place = 9.0
    for _ in range(100):
        judged = go(marks, place, place + 0.3)
        if judged.refusal is None:
            marks, place = judged.marks, place + 0.3
    assert place <= 10.01


@pytest.mark.parametrize("step", [0.2, 0.9, 3.0])
def test_an_arm_found_outside_goes_no_further_out_by_any_number_of_motions(step):
    """It was found 20 outside: 1 more is noise, and only once."""
    marks: Marks = {}
    place = 30.0
    for _ in range(50):
        judged = go(marks, place, place + step)
        if judged.refusal is None:
            marks, place = judged.marks, place + step
    assert place <= 31.0


def test_what_has_come_back_does_not_go_out_again():
    back = go({}, 30.0, 20.0)
    assert back.refusal is None
    assert go(back.marks, 20.0, 20.5).refusal is None
    assert go(back.marks, 20.0, 22.0).refusal.params["found"]
    assert go(back.marks, 20.0, 9.0).refusal is None


def test_the_way_back_leads_no_deeper_between():
    assert go({}, 30.0, 33.0, 12.0).refusal.params["found"]
    assert go({}, 30.0, 12.0, 20.0).refusal.params["found"]
    assert go({}, 30.0, 12.0, 12.5).refusal is None


def test_where_a_target_outside_is_never_taken_only_a_whole_way_back_passes():
    limits = Wall(may_stay=False)
    assert go({}, 30.0, 20.0, wall=limits).refusal is not None
    assert go({}, 30.0, 10.0, wall=limits).refusal is None
    assert go({}, 10.9, 10.9, wall=limits).refusal is not None


def test_an_arm_that_sags_beyond_its_mark_is_held_to_where_it_stands():
    marks = go({}, 0.0, 10.0).marks
    assert go(marks, 13.0, 13.5).refusal is not None
    assert go(marks, 13.0, 13.0).refusal is not None
    assert go(marks, 13.0, 11.5).refusal is None
    assert go(marks, 13.0, 5.0).refusal is None


def test_an_arm_that_may_be_off_at_the_beginning_is_given_room():
    way = straight_way(at(0), at(9.5), spread_deg=(1.6, *STILL[1:]))
    assert judge(way, [Wall()], {}).refusal is not None


def test_the_end_is_judged_without_the_way():
    assert judge_end(straight_way(at(11), at(12)), [Wall()], {("wall", "wall"): 0.0}) is not None
    assert judge_end(straight_way(at(50), at(9)), [Wall()], {}) is None


def test_the_rest_of_a_way_begins_where_the_arm_stands():
    way = Way(np.array([at(each) for each in (0, 10, 20, 30)]))
    left = rest_of(way, at(11))
    assert left.joints_deg[:, 0].tolist() == [11.0, 20.0, 30.0]
    assert rest_of(way, at(30)).end_deg == at(30)
