"""The functions of axes and buttons, and the speeds of axes; pure.

A gamepad has the layout that SDL gives every gamepad it knows: two sticks, two triggers, the four
buttons a, b, x, y, shoulders, and a cross. On a stick, right and down are positive. The six axes of
a SpaceMouse have the names of the arm's axes: X away from the operator, Y to the left, Z upwards.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from enum import StrEnum
from typing import Final

from armui.gamepad.device_state import DeviceKind, DeviceState

SPEED_AXIS: Final = "right_trigger"
"""The trigger that makes a gamepad faster."""

_PAD_BUTTONS: Final = (
    *("a", "b", "x", "y", "left_shoulder", "right_shoulder"),
    *("back", "start", "left_stick", "right_stick"),
)
_MOUSE_BUTTONS: Final = tuple(str(number) for number in range(1, 33))

BUTTONS: Final[Mapping[DeviceKind, tuple[str, ...]]] = {
    DeviceKind.GAMEPAD: _PAD_BUTTONS,
    DeviceKind.SPACE_MOUSE: _MOUSE_BUTTONS,
}
"""The buttons that can be assigned; the cross moves the arm."""

OPTIONAL: Final = frozenset({"halt", "mode", "episode", "discard"})
"""The actions that may have no button."""

DEAD_ZONES: Final[Mapping[DeviceKind, float]] = {
    DeviceKind.GAMEPAD: 0.18,
    DeviceKind.SPACE_MOUSE: 0.10,
}
"""Within this of its centre an axis is at rest: worn sticks stay up to 0.15 away from it."""

SLOWEST: Final = 0.02
"""The share of the speed just outside the dead zone."""

WITHOUT_TRIGGER: Final = 0.2
"""The share of the operator's speed while the trigger of a gamepad is not pulled."""


class JogMode(StrEnum):
    """The mode of the axes: the joints, or the tool along the axes of a frame."""

    JOINT = "joint"
    BASE = "base"
    TOOL = "tool"
    USER = "user"


@dataclass(frozen=True, slots=True)
class AxisSource:
    """The source of one axis of the arm: an axis of the device, or two of its buttons.

    Attributes:
        axis: The device's axis; empty for buttons.
        sign: −1 reverses the direction.
        plus, minus: The buttons for + and −.
    """

    axis: str = ""
    sign: int = 1
    plus: str = ""
    minus: str = ""


_CROSS_UP: Final = AxisSource(plus="dpad_up", minus="dpad_down")
_CROSS_SIDE: Final = AxisSource(plus="dpad_right", minus="dpad_left")
_PAD_TOOL: Final = (
    AxisSource("left_y", -1),
    AxisSource("left_x", -1),
    AxisSource("right_y", -1),
    _CROSS_SIDE,
    _CROSS_UP,
    AxisSource("right_x", -1),
)
_PAD_JOINTS: Final = (
    AxisSource("left_x", -1),
    AxisSource("left_y", -1),
    AxisSource("right_y", -1),
    AxisSource("right_x", -1),
    _CROSS_UP,
    _CROSS_SIDE,
)
_MOUSE: Final = tuple(AxisSource(axis) for axis in ("x", "y", "z", "rx", "ry", "rz"))

SOURCES: Final[Mapping[DeviceKind, Mapping[JogMode, tuple[AxisSource, ...]]]] = {
    DeviceKind.GAMEPAD: {
        **dict.fromkeys(JogMode, _PAD_TOOL),
        JogMode.JOINT: _PAD_JOINTS,
    },
    DeviceKind.SPACE_MOUSE: dict.fromkeys(JogMode, _MOUSE),
}
"""The source of each axis of the arm (J1–J6, or X, Y, Z, RX, RY, RZ)."""


@dataclass(frozen=True, slots=True)
class Assignment:
    """The assignment of buttons to actions.

    Attributes:
        dead_man: The button that must be held during motion.
        stop: The emergency stop; works at any time.
        halt: Halt and hold; works at any time. Empty: no button.
        mode: Switches to the next mode. Empty: no button.
        episode: Begins an episode of the log, or ends it. Empty: no button.
        discard: Discards the last episode. Empty: no button.
    """

    dead_man: str
    stop: str
    halt: str = ""
    mode: str = ""
    episode: str = ""
    discard: str = ""


ACTIONS: Final = tuple(field.name for field in fields(Assignment))
"""The actions of buttons, by the names of the fields."""


DEFAULTS: Final[Mapping[DeviceKind, Assignment]] = {
    DeviceKind.GAMEPAD: Assignment("left_shoulder", "b", "x", "y", "start"),
    DeviceKind.SPACE_MOUSE: Assignment("1", "2"),
}


def assignment(kind: DeviceKind, kept: Mapping[str, str] | None) -> Assignment:
    """Return the stored assignment of a device, or the default one if it is missing or invalid."""
    first = DEFAULTS[kind]
    if kept is None:
        return first
    figures = asdict(first) | {name: kept[name] for name in ACTIONS if name in kept}
    # an assignment stored before there were episodes may use their default button otherwise
    if "episode" not in kept and figures["episode"] in kept.values():
        figures["episode"] = ""
    wanted = Assignment(**figures)
    return first if wrong_in(kind, wanted) else wanted


def wrong_in(kind: DeviceKind, wanted: Assignment) -> str:
    """Return the first action whose button is missing, unknown or used twice; empty if none."""
    taken: set[str] = set()
    for action, button in asdict(wanted).items():
        if not button and action in OPTIONAL:
            continue
        if button not in BUTTONS[kind] or button in taken:
            return action
        taken.add(button)
    return ""


def swapped(now: Assignment, action: str, button: str) -> Assignment:
    """Return the assignment with another button for an action; the two actions swap buttons."""
    figures = asdict(now)
    old = figures[action]
    for other, has in figures.items():
        if button and has == button and other != action:
            if not old and other not in OPTIONAL:
                return now  # that action would have no button, but needs one
            figures[other] = old
    figures[action] = button
    return Assignment(**figures)


def deflections(state: DeviceState, mode: JogMode) -> tuple[float, ...]:
    """Return the deflection of each axis of the arm, −1 to 1, before dead zone and curve."""
    return tuple(_deflection(state, source) for source in SOURCES[state.info.kind][mode])


def _deflection(state: DeviceState, source: AxisSource) -> float:
    if source.axis:
        return source.sign * state.axes.get(source.axis, 0.0)
    return float((source.plus in state.buttons) - (source.minus in state.buttons))


def shaped(deflection: float, dead_zone: float) -> float:
    """Return the share of the highest speed, −1 to 1: 0 in the dead zone, then rising slowly.

    NaN counts as 0, so that a broken device moves nothing.
    """
    size = abs(deflection)
    if not math.isfinite(size) or size <= dead_zone:
        return 0.0
    out = min(1.0, (size - dead_zone) / (1.0 - dead_zone))
    return math.copysign(SLOWEST + (1.0 - SLOWEST) * out * out, deflection)


def centred(deflections: Sequence[float], dead_zone: float) -> bool:
    """Return whether every axis is at rest; NaN is not at rest."""
    return all(abs(each) <= dead_zone for each in deflections)


def speed_share(state: DeviceState) -> float:
    """Return the trigger's share of the operator's speed; 1 for a SpaceMouse, which has none."""
    if state.info.kind is DeviceKind.SPACE_MOUSE:
        return 1.0
    pulled = state.axes.get(SPEED_AXIS, 0.0)
    pulled = min(1.0, max(0.0, pulled)) if math.isfinite(pulled) else 0.0
    return WITHOUT_TRIGGER + (1.0 - WITHOUT_TRIGGER) * pulled


def strongest(rates: Sequence[float]) -> int:
    """Return the index of the axis that is pushed furthest."""
    return max(range(len(rates)), key=lambda place: abs(rates[place]))
