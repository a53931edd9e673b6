"""Guesses the content of a column by its title, else by its place and its figures."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Final

from armui.arm.models import widest_ranges_deg
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
    ColumnQuantity.TIME: (
        *("t", "ts", "time", "timestamp", "stamp", "elapsed", "elapsedtime", "relativetime"),
        *("epoch", "rostime", "unixtime", "systemtime", "recordtime", "timefromstart", "clock"),
        *("seconds", "secs", "sec", "时间", "时间戳"),
    ),
    ColumnQuantity.WAIT: (
        *("wait", "waittime", "dt", "delta", "deltat", "deltatime", "timedelta", "timediff"),
        *("delay", "delaytime", "interval", "sleep", "sleeptime", "period"),
        *("等待", "等待时间", "间隔", "间隔时间", "时间间隔", "延时"),
    ),
    ColumnQuantity.X: ("x", "posx", "px", "xaxis"),
    ColumnQuantity.Y: ("y", "posy", "py", "yaxis"),
    ColumnQuantity.Z: ("z", "posz", "pz", "zaxis"),
    ColumnQuantity.RX: ("rx", "roll", "a", "rxaxis"),
    ColumnQuantity.RY: ("ry", "pitch", "b", "ryaxis"),
    ColumnQuantity.RZ: ("rz", "yaw", "c", "rzaxis"),
    ColumnQuantity.SPEED: ("speed", "velocity", "vel", "速度"),
    ColumnQuantity.DWELL: (
        *("dwell", "pause", "hold", "dwelltime", "pausetime", "holdtime", "停留", "停留时间"),
    ),
    ColumnQuantity.NOTE: ("note", "comment", "label", "remark", "description", "备注", "注释"),
}
_BY_TITLE: Final = {title: quantity for quantity, titles in _TITLES.items() for title in titles}
_JOINT: Final = re.compile(
    r"(?:(?<![a-z0-9])|(?<=robot)|(?<=arm))"
    r"(joint|jnt|j|q|theta|axis|axe|achse|gelenk|rax|关节|轴)_?(\d{1,2})(?!\d)"
)
_ELEMENT: Final = re.compile(
    r"(?<![a-z0-9])(positions?|pos|states?|actions?|qpos|angles?|joints?)_?(\d{1,2})$"
)
"""The title of an element of an array that holds the six joints, perhaps the gripper."""
_GRIPPER: Final = re.compile(r"(?<![a-z0-9])(grippers?|grip|jaw|finger|opening|夹爪)")
_ROBOT_AXIS: Final = re.compile(r"a([1-6])")
"""Titles of other makers' joints; accelerations, where other titles name the joints."""
_PREFIX: Final = re.compile(
    r"(?:tool|tcp|eef|ee|endeffector|end|flange|tip|robot|arm|pose|position|pos|cartesian|cart"
    r"|target|actual|measured|工具|末端|法兰|位姿|位置|目标|实际)+(?=.)"
)
"""Words in a title that name the part, in front of the quantity."""
_OF_PLACE: Final = re.compile(
    r"pos(?:ition)?s?|angles?|val(?:ue)?s?|opening|width|distance|stroke|rad|角度?|位置|值|开口|行程"
)
"""Words behind the name of a joint for its position."""
_OF_ROLE: Final = re.compile(
    r"actual|measured|target|cmd|command(?:ed)?|state|feedback|fb|ref|desired|goal|实际|目标"
)
_OF_OTHER: Final = re.compile(
    r"vel|speed|effort|torque|tau|curr|amp|temp|acc|err|delta|diff|min|max|limit|std|gripper|finger"
    r"|hand|name|status|code|volt|force|enable|速度|力矩|电流|温度|电压"
)
"""Words that show that a figure is no position of a joint."""

_UNIT_WORDS: Final = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "秒"), "s"),
    **dict.fromkeys(("ms", "msec", "毫秒"), "ms"),
    **dict.fromkeys(("us", "µs", "μs", "usec"), "µs"),
    **dict.fromkeys(("ns", "nsec"), "ns"),
    **dict.fromkeys(("rad", "rads", "radian", "radians", "弧度"), "rad"),
    **dict.fromkeys(("deg", "degree", "degrees", "°", "度"), "°"),
    **dict.fromkeys(("mdeg", "millidegree", "millidegrees", "0.001°", "0.001deg"), "0.001°"),
    **dict.fromkeys(("0.1°", "0.1deg", "decidegree", "decidegrees", "ddeg"), "0.1°"),
    **dict.fromkeys(("mrad", "milliradian", "milliradians", "0.001rad"), "mrad"),
    **dict.fromkeys(("mm", "毫米"), "mm"),
    **dict.fromkeys(("um", "µm", "μm", "micron", "microns", "0.001mm"), "µm"),
    **dict.fromkeys(("m", "meter", "metre", "米"), "m"),
    **dict.fromkeys(("%", "percent"), "%"),
}
_OPENING, _CLOSING = "([{<（［【｛〔「《", ")]}>）］】｝〕」》"
_BRACKET: Final = re.compile(
    f"[{re.escape(_OPENING)}]([^{re.escape(_OPENING + _CLOSING)}]*)[{re.escape(_CLOSING)}]"
)
_NORMALISED: Final = re.compile(r"\d\.pos$|norm|^(?:observation\.state|action)")
_AS_ROS: Final = re.compile(r"joint_?\d")
_NUMBERED: Final = re.compile(r"([1-6])[号_ ]?(关节|轴)")
_CAMEL: Final = re.compile(r"(?<=[a-z])(?=[A-Z][a-z]{2})")
_PARTS: Final = re.compile(rf"[\s_\-./:,{re.escape(_OPENING + _CLOSING)}]+")

_SURE: Final = 1.0
_UNIT_GUESSED: Final = 0.8
_PLACE_ONLY: Final = 0.5

_FULL_TURN_RAD: Final = 2 * math.pi + 0.01
"""A larger angle is not in radians: a full turn, and 0.01 for rounding."""
_FULL_TURN_DEG: Final = 360.0
_BEYOND_DEG: Final = 20.0
"""Arms in the field carry other limits than the factory's, and lie beyond them at rest."""
_FAR_BEYOND_DEG: Final = 45.0
"""A target in plain degrees may be wrong, which the check tells better than a question."""
_AT_REST_DEG: Final = 2.5
"""An arm in its rest pose lies up to 2° outside its limits."""
_NORMAL: Final = 100.5
"""Normalised figures are within ±100, but for rounding."""
_NARROWEST_M: Final = 0.001
_LONGEST_M: Final = 2.0
_WIDEST_M: Final = 0.2
_HIGHEST_MM: Final = 2000.0
_WIDEST_MM: Final = 200.0
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
    elif ColumnQuantity.TIME in quantities and ColumnQuantity.WAIT not in quantities:
        place = quantities.index(ColumnQuantity.TIME)
        if _are_waits(_numbers(figures[place])):
            quantities[place] = ColumnQuantity.WAIT
    custom = _custom(header, quantities, figures)
    guesses = []
    for quantity, unit, column in zip(quantities, units, figures, strict=True):
        told = (unit, tuple(column), custom if quantity in JOINTS else "")
        if quantity is None:
            guesses.append(Guess(None, 0.0, *told))
        elif unit in UNITS[quantity]:
            sure = _SURE if confidence == _UNIT_GUESSED else confidence
            guesses.append(Guess(TableColumn(quantity, unit), sure, *told))
        else:
            likely = _unit(quantity, quantities, units, figures)
            guesses.append(Guess(TableColumn(quantity, likely), confidence, *told))
    return tuple(guesses)


def _custom(
    header: Sequence[str], quantities: Sequence[ColumnQuantity | None], figures: Sequence[Figures]
) -> str:
    """Return the unit in which programs with such titles write joints, "" if not known.

    ROS and the maker's tools name joints ``joint1`` and write radians; so do those that write the
    gripper in metres. LeRobot writes ``joint1.pos`` or arrays, normalised to ±100 unless it was
    told otherwise: "%".
    """
    places = [place for place, each in enumerate(quantities) if each in JOINTS and header]
    titles = [header[place].lower() for place in places]
    opened = [figures[p] for p, each in enumerate(quantities) if each is ColumnQuantity.GRIPPER]
    if titles and opened and _NARROWEST_M < _largest(opened[0]) <= _WIDEST_M:
        return "rad"
    if any(map(_NORMALISED.search, titles)):
        return "%"
    return "rad" if titles and all(map(_AS_ROS.search, titles)) else ""


def units_in_doubt(angles: Sequence[tuple[ColumnQuantity, Guess]]) -> tuple[str, ...]:
    """Return among which units only the operator can choose; none where titles or figures tell.

    Degrees come first where figures would not fit the joints' range in them, or may be normalised
    to each joint's range; "%" beside them says that they may be, as none lies outside ±100.

    Args:
        angles: Angles of one kind of which no title tells the unit.
    """
    largest = max((_largest(guess.figures) for _, guess in angles), default=0.0)
    if not largest:
        return ()
    fitting = [
        unit
        for unit in UNITS[JOINTS[0]]
        if all(
            _fits(each, guess.figures, unit, _FAR_BEYOND_DEG if unit == "°" else _BEYOND_DEG)
            for each, guess in angles
        )
    ]
    custom = {guess.custom for _, guess in angles}
    if largest <= _FULL_TURN_RAD and "rad" in fitting:
        return () if custom == {"rad"} else ("rad", "°")
    if angles[0][0] not in JOINTS:
        return ()
    if largest <= _FULL_TURN_DEG:
        is_normalised = largest <= _FULL_TURN_RAD or ("%" in custom and largest <= _NORMAL)
        if is_normalised or "°" not in fitting:
            return ("°", "%") if largest <= _NORMAL else ("°",)
        return ()
    likely = tuple(unit for unit in fitting if unit not in {"rad", "°"})
    return () if len(likely) == 1 else likely or ("°",)


def farthest(quantity: ColumnQuantity, guess: Guess) -> tuple[float, float, float, float]:
    """Return the figure of a joint's column that lies farthest beyond the joint's range.

    Returns:
        How far it lies beyond, below 0 within; the figure; and the least and the greatest angle of
        the joint in any model of the family. All are in degrees, as if the column were.
    """
    low, high = widest_ranges_deg()[JOINTS.index(quantity)]
    return max((max(low - v, v - high), v, low, high) for v in _numbers(guess.figures) or [low])


def _fits(
    quantity: ColumnQuantity, figures: Figures, unit: str, beyond_deg: float = _BEYOND_DEG
) -> bool:
    """Return whether an arm of the family can come to angles, if they are in a unit."""
    if quantity not in JOINTS:
        return True
    low, high = widest_ranges_deg()[JOINTS.index(quantity)]
    factor = UNITS[quantity][unit]
    angles = [factor * value for value in _numbers(figures)]
    return all(low - beyond_deg <= angle <= high + beyond_deg for angle in angles)


def likely_unit(quantity: ColumnQuantity, guess: Guess) -> str:
    """Return the most likely unit of a column that holds a quantity.

    The unit in its title wins; else the figures decide.
    """
    unit = guess.titled_unit
    return unit if unit in UNITS[quantity] else _unit(quantity, [quantity], [""], [guess.figures])


def _by_titles(header: Sequence[str]) -> list[tuple[ColumnQuantity | None, str]]:
    """Return the quantity and unit that each title names; each quantity only once."""
    parts = [_parts(title) for title in header]
    found = _joints(parts)
    named: list[tuple[ColumnQuantity | None, str]] = []
    seen: set[ColumnQuantity | None] = set()
    for place, (words, unit) in enumerate(parts):
        title = words.replace("_", "")
        quantity = found.get(place) or _BY_TITLE.get(title) or _of_pose(title)
        if title.endswith("headerstamp"):
            quantity = ColumnQuantity.TIME
        named.append((None if quantity in seen else quantity, unit))
        seen.add(quantity)
    return named


def _joints(parts: Sequence[tuple[str, str]]) -> dict[int, ColumnQuantity]:
    """Return the columns of the joints and the gripper by place.

    Where several arms or roles have some, as target and actual, they are of the one with most.
    """
    groups: dict[tuple[str, ...], dict[int, int]] = {}
    for place, (words, unit) in enumerate(parts):
        if unit and unit not in UNITS[JOINTS[0]]:
            continue
        for pattern in (_JOINT, _ELEMENT):
            match = pattern.search(words)
            if match is None:
                continue
            group = _group(words[: match.start()], words[match.end() :])
            if group is not None:
                kind = (match.group(1) if pattern is _ELEMENT else "", *group)
                groups.setdefault(kind, {}).setdefault(int(match.group(2)), place)
                break
    if not groups:
        bare = [_ROBOT_AXIS.fullmatch(_PREFIX.sub("", words, count=1)) for words, _ in parts]
        found = {int(match.group(1)): place for place, match in enumerate(bare) if match}
        groups = {("",): found} if found else {}
    best = max(groups, key=lambda each: len(groups[each].keys() & set(range(7))), default=None)
    numbers = {} if best is None else groups[best]
    is_array = best is not None and bool(best[0])
    first = 0 if 0 in numbers and (is_array or 6 not in numbers) else 1  # some count from 0
    quantities = {
        numbers[first + index]: joint
        for index, joint in enumerate(JOINTS)
        if first + index in numbers
    }
    grippers = {
        place: _group(words[: match.start()], words[match.end() :])
        for place, (words, unit) in enumerate(parts)
        if (match := _GRIPPER.match(words) or _GRIPPER.search(words))
        and (not unit or unit in UNITS[ColumnQuantity.GRIPPER])
    }
    fitting = [place for place, group in grippers.items() if group is not None]
    beside = [place for place in fitting if best is not None and grippers[place] == best[1:]]
    if is_array and first + len(JOINTS) in numbers and not fitting:
        beside = [numbers[first + len(JOINTS)]]
    for place in (beside or fitting)[:1]:
        quantities[place] = ColumnQuantity.GRIPPER
    return quantities


def _group(before: str, behind: str) -> tuple[str, ...] | None:
    """Return the arm or role that a title of a position names; ``None`` if it is no position."""
    words = [word for word in behind.split("_") if word and not _OF_PLACE.fullmatch(word)]
    if _OF_OTHER.search(before) or not all(map(_OF_ROLE.fullmatch, words)):
        return None
    return (*filter(None, before.split("_")), "|", *words)


def _of_pose(title: str) -> ColumnQuantity | None:
    """Return the pose figure of a title that begins with the part, as «tool_x» does."""
    prefix = _PREFIX.match(title)
    quantity = None if prefix is None else _BY_TITLE.get(title[prefix.end() :])
    return quantity if quantity in POSE else None


def _parts(title: str) -> tuple[str, str]:
    """Return a title without its unit, in lower case, its words separated by ``_``; and the unit.

    A unit in brackets wins, wherever it stands; "" is none.
    """
    title = _NUMBERED.sub(r"\2\1", _CAMEL.sub("_", title).lower())
    for bracket in _BRACKET.finditer(title):
        unit = _UNIT_WORDS.get(bracket.group(1).strip().replace("_", ""), "")
        if unit:
            bare = title[: bracket.start()] + " " + title[bracket.end() :]
            return "_".join(filter(None, _PARTS.split(bare))), unit
    words = [word for word in _PARTS.split(title.replace("°", " ° ")) if word]
    unit = _UNIT_WORDS.get(words[-1], "") if len(words) > 1 else ""
    return "_".join(words[:-1] if unit else words), unit


def _are_waits(values: Sequence[float]) -> bool:
    """Return whether figures called times do not rise, and are short."""
    falls = any(a > b for a, b in pairwise(values))
    return falls and min(values) >= 0.0 and max(values) <= _LONGEST_WAIT


def _by_place(figures: Sequence[Figures]) -> list[ColumnQuantity | None]:
    """Return guesses by the usual order: perhaps a time, six values, perhaps the gripper."""
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
    far = any(_largest(figures[index]) > _FULL_TURN_DEG for index in numeric[:3])
    six = [(joint, figures[index]) for joint, index in zip(JOINTS, numeric, strict=False)]
    steps = ("0.001°",) if max(map(_largest, figures)) > _HIGHEST_MM else ("0.1°", "mrad")
    far = far and not any(all(_fits(*each, unit, _AT_REST_DEG) for each in six) for unit in steps)
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
        if largest <= _FULL_TURN_RAD:
            return "rad"
        told = [
            (each, column)
            for each, column in zip(quantities, figures, strict=True)
            if each in group
        ]
        smaller = ("0.1°", "mrad", "0.001°") if largest > _FULL_TURN_DEG else ()
        fitting = (
            unit for unit in smaller if all(_fits(each, column, unit) for each, column in told)
        )
        return next(fitting, "°") if quantity in JOINTS or not smaller else "0.001°"
    if "mm" in units:
        is_gripper = quantity is ColumnQuantity.GRIPPER
        if largest <= (_WIDEST_M if is_gripper else _LONGEST_M):
            return "m"
        return "mm" if largest <= (_WIDEST_MM if is_gripper else _HIGHEST_MM) else "µm"
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
