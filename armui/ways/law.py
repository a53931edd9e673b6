"""Judges ways by all rules: an arm found outside may only stay or come back (safety S36).

A rule says of each of its bounds how far outside it a pose is. A target keeps every bound in full.
On the way to it, and where the arm begins, measured noise is allowed, by so much once: it is
counted from the *mark*, how far outside the arm was found when somebody else had brought it there.
Our motions only tighten the mark, so that many small steps lead no further than a single one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, Protocol

import numpy as np
import numpy.typing as npt

from armui.arm.refusal import Contact, Refusal
from armui.ways.way import Array, Way

Flags = npt.NDArray[np.bool_]
Marks = Mapping[tuple[str, str], float]
"""How far outside the arm was found, by the name of a rule and that of its bound."""

_EXACT: Final = 1e-3
"""Figures that differ by less are the same."""
_FEW: Final = 8
_MORE: Final = 4
"""`_FEW` ways are examined together after one that breaks a rule, `_MORE` times as many as before
after clear ones.
"""


@dataclass(frozen=True, slots=True)
class Excess:
    """The first place on a way that is further outside a bound than allowed.

    Attributes:
        bound: The index of the bound in the rule.
        outside: How far outside it is there, in the rule's unit.
        joints_deg: The six angles there.
        part: The part of the arm that is outside; "" where the bound says it.
        index: The index of the way's pose before the place.
    """

    bound: int
    outside: float
    joints_deg: tuple[float, ...]
    part: str = ""
    index: int = 0


class Rule(Protocol):
    """A restriction on where the arm may be.

    Attributes:
        name: The name, which is no other rule's.
        bounds: The names of its bounds.
        noise: The tolerance for measured poses, in the rule's unit.
        exact: By how much a target may miss a bound, in its unit: rounding to the steps of the bus.
        may_stay: True if an arm outside may be sent to a place that is outside, too, as along the
            plane it is too near to; false if a target is inside always, as the firmware wants of
            the joints' limits.
        reaches_mm: How far each joint moves any part at most for a radian; empty where mm are not
            what it is about.
    """

    name: str
    bounds: tuple[str, ...]
    noise: float
    exact: float
    may_stay: bool
    reaches_mm: tuple[float, ...]

    def outside(self, joints_deg: Array) -> Array:
        """Return (n, bounds) how far outside each bound (n, 6) angles are; below 0: inside."""
        ...

    def breach(self, way: Way, allowed: Array) -> Excess | None:
        """Return the first place that is further outside than allowed, or ``None``.

        Args:
            way: The way.
            allowed: (bounds,) how far outside it may be; infinite where it is not asked.
        """
        ...

    def finely(self, way: Way) -> Array:
        """Return (n, 6) poses on a way between which nothing changes by more than the noise."""
        ...

    def refuse(self, breach: Excess, *, found_outside: bool) -> Refusal:
        """Return a breach as a reason.

        Args:
            breach: The breach.
            found_outside: True if the arm was outside that bound before.
        """
        ...

    def contact(self, breach: Excess) -> Contact | None:
        """Return where the arm touches at a breach; ``None`` if nothing does."""
        ...


@dataclass(frozen=True, slots=True)
class Judgement:
    """The answer of the rules to a way.

    Attributes:
        refusal: Why it may not be driven, or ``None``.
        marks: The marks once it is driven.
        begin_deg, end_deg: Where it begins and ends.
    """

    refusal: Refusal | None
    marks: Marks
    begin_deg: tuple[float, ...]
    end_deg: tuple[float, ...]


def judge(way: Way, rules: Iterable[Rule], marks: Marks) -> Judgement:
    """Return the judgement of a way by all rules.

    Args:
        way: The way.
        rules: All rules in force.
        marks: The known marks; a bound without one is marked by the way's beginning.
    """
    after = dict(marks)
    for rule in rules:
        found = _judge(way, rule, after)
        if found is not None:
            refusal = _refuse(rule, *found)
            return Judgement(refusal, marks, way.begin_deg, way.end_deg)
    return Judgement(None, after, way.begin_deg, way.end_deg)


def first_breach(way: Way, rule: Rule) -> Excess | None:
    """Return where a way from where the arm is found breaks a rule, or ``None``."""
    found = _judge(way, rule, {})
    return None if found is None else found[0]


def breaches(ways: Sequence[Way], rule: Rule) -> Iterator[tuple[int, Excess]]:
    """Yield the worst place of each planned way that breaks a rule, with the index of the way.

    A plan keeps its bounds on the way, too: the noise is left to the arm that drives it.

    Args:
        ways: The ways, each of which begins where the one before ends.
        rule: The rule.
    """
    allowed = np.full(len(rule.bounds), rule.exact)
    begin, count = 0, len(ways)
    while rule.bounds and begin < len(ways):
        some = ways[begin : begin + count]
        together = Way(
            np.vstack([way.joints_deg for way in some]),
            beside_deg=np.vstack([way.spreads_deg for way in some]),
        )
        first = rule.breach(together, allowed)
        if first is None:
            begin, count = begin + count, _MORE * count
            continue
        # All ways before it are clear; the next ones are examined in small groups again.
        ends = np.cumsum([len(way.joints_deg) for way in some])
        place = int(np.searchsorted(ends, first.index, side="right"))
        worst = _worst_on(some[place], rule, first)
        if worst is not None:
            yield begin + place, worst
        begin, count = begin + place + 1, _FEW


def _worst_on(way: Way, rule: Rule, first: Excess) -> Excess | None:
    """Return the worst place of a way; ``None`` if `first` is within the search's tolerance."""
    worst = max(_worst(way.joints_deg, rule), first, key=lambda each: each.outside)
    if not worst.outside > rule.exact:
        worst = _worst(rule.finely(way), rule)
    return worst if worst.outside > rule.exact else None


def _worst(poses_deg: Array, rule: Rule) -> Excess:
    """Return which of (n, 6) poses is furthest outside a bound."""
    found = rule.outside(poses_deg)
    place, bound = np.unravel_index(int(np.argmax(found)), found.shape)
    return Excess(int(bound), float(found[place, bound]), tuple(poses_deg[place].tolist()))


def judge_end(way: Way, rules: Iterable[Rule], marks: Marks) -> Refusal | None:
    """Return why a way may not end where it does, wherever it begins, or ``None``."""
    for rule in rules:
        if not rule.bounds:
            continue
        begin, end = rule.outside(way.joints_deg[[0, -1]])
        over = end - _allowed_at_end(rule, _marks_of(rule, begin, marks), begin)
        if (over > 0.0).any():
            bound = int(np.argmax(over))
            breach = Excess(bound, float(end[bound]), way.end_deg)
            return _refuse(rule, breach)
    return None


def _refuse(rule: Rule, breach: Excess, found_outside: bool = False) -> Refusal:
    return replace(rule.refuse(breach, found_outside=found_outside), contact=rule.contact(breach))


def _marks_of(rule: Rule, begin: Array, marks: Marks) -> Array:
    found = np.array([marks.get((rule.name, bound), np.nan) for bound in rule.bounds])
    return np.where(np.isnan(found), np.where(begin > rule.noise, begin, 0.0), found)


def _allowed_at_end(rule: Rule, mark: Array, begin: Array) -> Array:
    """Return (bounds,) how far outside a target may be.

    A target must be inside, unless the arm was found outside. A part measured about a bound may
    stay there, and one sagged far beyond it may come back partly.
    """
    if not rule.may_stay:
        return np.full(len(mark), rule.exact)
    trembling = np.clip(begin, rule.exact, rule.noise)
    found = np.where(mark > 0.0, mark + rule.noise, trembling)
    return np.maximum(found, begin - rule.noise)


def _judge(way: Way, rule: Rule, marks: dict[tuple[str, str], float]) -> tuple[Excess, bool] | None:
    """Return where a way breaks a rule, and whether the arm was found outside that bound.

    ``None``: it breaks none, and the marks are those once it is driven.
    """
    if not rule.bounds:
        return None
    begin, end = rule.outside(way.joints_deg[[0, -1]])
    mark = _marks_of(rule, begin, marks)
    at_end = _allowed_at_end(rule, mark, begin)
    beyond = np.flatnonzero(end > at_end)
    # Bounds with the arm outside are followed pose by pose: it may only come back.
    outside = (begin > mark + rule.noise) | (mark > 0.0)
    # A short way cannot reach a bound that is far away at both of its ends.
    room = rule.noise - np.where(outside, -np.inf, np.maximum(begin, end)).max()
    near = not rule.reaches_mm or way.travel_mm(rule.reaches_mm) / 2.0 > room
    breach = rule.breach(way, np.where(outside, np.inf, rule.noise)) if near else None
    if breach is None and outside.any():
        breach = _deeper(way, rule, mark, outside)
    if breach is None and len(beyond):
        worst = int(beyond[np.argmax((end - at_end)[beyond])])
        breach = Excess(worst, float(end[worst]), way.end_deg)
    if breach is not None and not rule.reaches_mm and end[breach.bound] > breach.outside:
        # For a joint's limit the target is reported, as it was typed, not where the way leaves.
        breach = Excess(breach.bound, float(end[breach.bound]), way.end_deg, index=breach.index)
    if breach is not None:
        return breach, bool(outside[breach.bound])
    for index, bound in enumerate(rule.bounds):
        marks[rule.name, bound] = max(0.0, min(float(mark[index]), float(end[index])))
    return None


def _deeper(way: Way, rule: Rule, mark: Array, outside: Flags) -> Excess | None:
    """Return the first place that is further outside than a place before it was, or ``None``."""
    poses = rule.finely(way)
    found = rule.outside(poses)
    least = np.minimum.accumulate(found, axis=0)
    # An arm that sags is further outside than its mark: its present place counts instead.
    sagged = found[0] > mark + rule.noise
    allowed = np.where(sagged, np.maximum(least, 0.0), np.clip(np.minimum(mark, least), 0.0, None))
    allowed = allowed + np.where(sagged & (least > 0.0), 0.0, rule.noise)
    allowed = np.maximum(allowed, rule.noise)
    over = (found > allowed + _EXACT) & outside
    places = np.flatnonzero(over.any(axis=1))
    if not len(places):
        return None
    place = int(places[0])
    bound = int(np.argmax(np.where(over[place], found[place], -np.inf)))
    return Excess(bound, float(found[place, bound]), tuple(poses[place].tolist()))
