"""Guesses the content of a column by its title, else by its place and its figures."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Final

from armui.trajectory.columns.model import (
    JOINTS,
    POSE,
    UNITS,
    ColumnQuantity,
    Figures,
    Guess,
    TableColumn,
)

_TITLES: Final[Mapping[ColumnQuantity, tuple[str, ...]]] = {
    ColumnQuantity.TIME: ("t", "time", "timestamp", "stamp", "elapsed", "时间", "时间戳"),
    ColumnQuantity.WAIT: ("wait", "dt", "delta", "delay", "interval", "step", "等待", "间隔"),
    ColumnQuantity.X: ("x", "posx", "px"),
    ColumnQuantity.Y: ("y", "posy", "py"),
    ColumnQuantity.Z: ("z", "posz", "pz"),
    ColumnQuantity.RX: ("rx", "roll", "a"),
    ColumnQuantity.RY: ("ry", "pitch", "b"),
    ColumnQuantity.RZ: ("rz", "yaw", "c"),
    ColumnQuantity.GRIPPER: ("gripper", "grip", "opening", "finger", "夹爪", "gripperopening"),
    ColumnQuantity.SPEED: ("speed", "velocity", "vel", "速度"),
    ColumnQuantity.DWELL: ("dwell", "pause", "hold", "停留", "停留时间"),
    ColumnQuantity.NOTE: ("note", "comment", "label", "remark", "备注", "注释"),
}
_BY_TITLE: Final = {title: quantity for quantity, titles in _TITLES.items() for title in titles}
_JOINT: Final = re.compile(
    r"(?:joint|j|q|theta|axis|axe|achse|gelenk|rax|关节|轴)([0-6])(?:pos|position|angle|角度?)?"
)
_ROBOT_AXIS: Final = re.compile(r"a([1-6])")
"""The joints of other makers' robots; where joints are named otherwise, it may be accelerations."""
_PREFIX: Final = re.compile(
    r"(?:tool|tcp|eef|ee|endeffector|end|flange|tip|robot|arm|pose|position|pos|cartesian|cart"
    r"|target|actual|measured|工具|末端|法兰|位姿|位置|目标|实际)+(?=.)"
)
"""Words in a title that name the part, in front of the quantity."""

_UNIT_WORDS: Final = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "秒"), "s"),
    **dict.fromkeys(("ms", "msec", "毫秒"), "ms"),
    **dict.fromkeys(("us", "µs", "μs", "usec"), "µs"),
    **dict.fromkeys(("ns", "nsec"), "ns"),
    **dict.fromkeys(("rad", "rads", "radian", "radians", "弧度"), "rad"),
    **dict.fromkeys(("deg", "degree", "degrees", "°", "度"), "°"),
    **dict.fromkeys(("mm", "毫米"), "mm"),
    **dict.fromkeys(("m", "meter", "metre", "米"), "m"),
    **dict.fromkeys(("%", "percent"), "%"),
}
_OPENING, _CLOSING = "([{<（［【｛〔「《", ")]}>）］】｝〕」》"
_BRACKET: Final = re.compile(
    f"[{re.escape(_OPENING)}]([^{re.escape(_OPENING + _CLOSING)}]*)[{re.escape(_CLOSING)}]"
)
_PARTS: Final = re.compile(rf"[\s_\-./:,{re.escape(_OPENING + _CLOSING)}]+")

_SURE: Final = 1.0
_UNIT_GUESSED: Final = 0.8
_PLACE_ONLY: Final = 0.5

_FULL_TURN_RAD: Final = 2 * math.pi + 0.01
_LONGEST_M: Final = 2.0
_WIDEST_M: Final = 0.2
_LONGEST_WAIT: Final = 60.0
_EPOCHS: Final = (("ns", 1e17), ("µs", 1e14), ("ms", 1e11))
"""In this century a time since 1970 in these units is above these figures."""


def guess_columns(header: Sequence[str], figures: Sequence[Figures]) -> tuple[Guess, ...]:
    """Return a guess of the content of each column of a table.

    Args:
        header: The titles; empty if there are none.
        figures: Some figures of every column.
    """
    named = _by_titles(header) if header else []
    quantities = [quantity for quantity, _ in named]
    units = [unit for _, unit in named]
    confidence = _UNIT_GUESSED
    if not any(quantities):
        quantities, units = _by_place(figures), units or [""] * len(figures)
        confidence = _PLACE_ONLY
    guesses = []
    for quantity, unit, column in zip(quantities, units, figures, strict=True):
        told = (unit, tuple(column))
        if quantity is None:
            guesses.append(Guess(None, 0.0, *told))
        elif unit in UNITS[quantity]:
            sure = _SURE if confidence == _UNIT_GUESSED else confidence
            guesses.append(Guess(TableColumn(quantity, unit), sure, *told))
        else:
            likely = _unit(quantity, quantities, units, figures)
            guesses.append(Guess(TableColumn(quantity, likely), confidence, *told))
    return tuple(guesses)


def likely_unit(quantity: ColumnQuantity, guess: Guess) -> str:
    """Return the most likely unit of a column that holds a quantity.

    The unit in its title wins; else the figures decide.
    """
    unit = guess.titled_unit
    return unit if unit in UNITS[quantity] else _unit(quantity, [quantity], [""], [guess.figures])


def looks_like_radians(figures: Figures) -> bool:
    """Return whether an angle's figures, not all zero, are small enough for radians."""
    return 0.0 < _largest(figures) <= _FULL_TURN_RAD


def exceeds_radians(figures: Figures) -> bool:
    """Return whether figures of an angle are too large for radians."""
    return _largest(figures) > _FULL_TURN_RAD


def _by_titles(header: Sequence[str]) -> list[tuple[ColumnQuantity | None, str]]:
    """Return the quantity and unit that each title names; each quantity only once."""
    parts = [_parts(title) for title in header]
    bare = [_PREFIX.sub("", title, count=1) for title, _ in parts]
    joints = [_JOINT.fullmatch(title) for title in bare]
    if not any(joints):
        joints = [_ROBOT_AXIS.fullmatch(title) for title in bare]
    numbers = {int(match.group(1)) for match in joints if match is not None}
    first = 0 if 0 in numbers and 6 not in numbers else 1  # some count joints from 0
    named: list[tuple[ColumnQuantity | None, str]] = []
    seen: set[ColumnQuantity | None] = set()
    for (title, unit), match in zip(parts, joints, strict=True):
        quantity = _BY_TITLE.get(title) or _of_pose(title)
        if match is not None and int(match.group(1)) >= first:
            quantity = JOINTS[int(match.group(1)) - first]
        named.append((None if quantity in seen else quantity, unit))
        seen.add(quantity)
    return named


def _of_pose(title: str) -> ColumnQuantity | None:
    """Return what a title says of a pose that says first whose it is, as «tool_x» does."""
    prefix = _PREFIX.match(title)
    quantity = None if prefix is None else _BY_TITLE.get(title[prefix.end() :])
    return quantity if quantity in POSE else None


def _parts(title: str) -> tuple[str, str]:
    """Return a title without its unit, in small letters and one word; and the unit, or "".

    A unit in brackets wins, wherever it stands.
    """
    title = title.lower()
    for bracket in _BRACKET.finditer(title):
        unit = _UNIT_WORDS.get(bracket.group(1).strip(), "")
        if unit:
            bare = title[: bracket.start()] + " " + title[bracket.end() :]
            return "".join(_PARTS.split(bare)), unit
    words = [word for word in _PARTS.split(title.replace("°", " ° ")) if word]
    unit = _UNIT_WORDS.get(words[-1], "") if len(words) > 1 else ""
    return "".join(words[:-1] if unit else words), unit


def _by_place(figures: Sequence[Figures]) -> list[ColumnQuantity | None]:
    """Return the usual order: perhaps a time, six values, perhaps the gripper."""
    numeric = [index for index, column in enumerate(figures) if _numbers(column)]
    quantities: list[ColumnQuantity | None] = [None] * len(figures)
    if len(numeric) > len(JOINTS):
        values = _numbers(figures[numeric[0]])
        rises = all(a <= b for a, b in pairwise(values))
        if rises and values[0] < values[-1]:
            quantities[numeric.pop(0)] = ColumnQuantity.TIME
        elif min(values) >= 0.0 and max(values) <= _LONGEST_WAIT:
            quantities[numeric.pop(0)] = ColumnQuantity.WAIT
    if len(numeric) < len(JOINTS):
        return quantities
    far = any(_largest(figures[index]) > 360.0 for index in numeric[:3])
    for index, quantity in zip(
        numeric, (*(POSE if far else JOINTS), ColumnQuantity.GRIPPER), strict=False
    ):
        quantities[index] = quantity
    return quantities


def _unit(
    quantity: ColumnQuantity,
    quantities: Sequence[ColumnQuantity | None],
    titled: Sequence[str],
    figures: Sequence[Figures],
) -> str:
    """Return the unit that the titles of a quantity's kin say, or their figures suggest."""
    group = next((kin for kin in (JOINTS, POSE[:3], POSE[3:]) if quantity in kin), (quantity,))
    said = {
        unit
        for other, unit in zip(quantities, titled, strict=True)
        if other in group and unit in UNITS[quantity]
    }
    if len(said) == 1:
        return said.pop()
    columns = [figures[index] for index, other in enumerate(quantities) if other in group]
    largest = max(map(_largest, columns), default=0.0)
    units = UNITS[quantity]
    if "rad" in units:
        return "rad" if largest <= _FULL_TURN_RAD else "°"
    if "mm" in units:
        return (
            "m"
            if largest <= (_WIDEST_M if quantity is ColumnQuantity.GRIPPER else _LONGEST_M)
            else "mm"
        )
    if "ms" in units:
        return _time_unit(_numbers(columns[0]), largest)
    return next(iter(units))


def _time_unit(values: Sequence[float], largest: float) -> str:
    for unit, least in _EPOCHS:
        if largest >= least:
            return unit
    whole = all(value == int(value) for value in values)
    return "ms" if whole and largest > _LONGEST_WAIT else "s"


def _numbers(column: Figures) -> list[float]:
    """Return the finite figures of a column; none where most of its cells hold something else."""
    values = [value for value in column if value is not None and math.isfinite(value)]
    return values if 2 * len(values) >= max(1, len(column)) else []


def _largest(column: Figures) -> float:
    return max(map(abs, _numbers(column)), default=0.0)
