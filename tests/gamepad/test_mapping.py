"""From what a device shows to what the arm is asked for: axes, dead zone, curve, speed, buttons."""

import math

import pytest

from armui.gamepad.device_state import DeviceState
from armui.gamepad.layout import (
    BUTTONS,
    DEAD_ZONES,
    DEFAULTS,
    SLOWEST,
    SOURCES,
    WITHOUT_TRIGGER,
    Assignment,
    JogMode,
    assignment,
    centred,
    deflections,
    shaped,
    speed_share,
    swapped,
    wrong_in,
)
from tests.gamepad.pads import MOUSE, PAD

JOINT, BASE, TOOL, _USER = JogMode


def moved(info, mode, axes=(), buttons=()):
    state = DeviceState(info, dict(axes), frozenset(buttons))
    asked = deflections(state, mode)
    names = [f"J{n}" for n in range(1, 7)] if mode is JOINT else ["X", "Y", "Z", "RX", "RY", "RZ"]
    return {name: value for name, value in zip(names, asked, strict=True) if value}


@pytest.mark.parametrize(
    ("info", "mode", "axes", "buttons", "expected"),
    [
        # SDL: down and right are positive; away from the operator is +X, left is +Y
        (PAD, BASE, {"left_y": -1.0}, (), {"X": 1.0}),
        (PAD, BASE, {"left_x": -1.0}, (), {"Y": 1.0}),
        (PAD, BASE, {"right_y": -0.5}, (), {"Z": 0.5}),
        (PAD, BASE, {"right_x": 1.0}, (), {"RZ": -1.0}),
        (PAD, TOOL, {"left_y": 1.0, "left_x": 0.25}, (), {"X": -1.0, "Y": -0.25}),
        (PAD, TOOL, {}, ("dpad_up",), {"RY": 1.0}),
        (PAD, TOOL, {}, ("dpad_left",), {"RX": -1.0}),
        (PAD, TOOL, {}, ("dpad_left", "dpad_right"), {}),
        (PAD, JOINT, {"left_x": -1.0}, (), {"J1": 1.0}),
        (PAD, JOINT, {"left_y": 1.0}, (), {"J2": -1.0}),
        (PAD, JOINT, {"right_y": -1.0}, (), {"J3": 1.0}),
        (PAD, JOINT, {"right_x": 1.0}, (), {"J4": -1.0}),
        (PAD, JOINT, {}, ("dpad_down",), {"J5": -1.0}),
        (PAD, JOINT, {}, ("dpad_right",), {"J6": 1.0}),
        (PAD, JOINT, {"left_trigger": 1.0, "right_trigger": 1.0}, ("a", "left_shoulder"), {}),
        (MOUSE, BASE, {"x": 1.0, "rz": -0.5}, (), {"X": 1.0, "RZ": -0.5}),
        (MOUSE, TOOL, {"rx": 1.0, "ry": 0.5}, ("1",), {"RX": 1.0, "RY": 0.5}),
        (MOUSE, JOINT, {"x": 1.0, "rz": 1.0}, (), {"J1": 1.0, "J6": 1.0}),
    ],
)
def test_which_axis_moves_what(info, mode, axes, buttons, expected):
    assert moved(info, mode, axes, buttons) == expected


@pytest.mark.parametrize("info", [PAD, MOUSE])
@pytest.mark.parametrize("mode", list(JogMode))
def test_every_axis_of_the_arm_has_one_source_of_its_own(info, mode):
    sources = SOURCES[info.kind][mode]
    assert len(set(sources)) == len(sources) == 6
    used = {each for source in sources for each in (source.plus, source.minus) if each}
    assert not used & set(BUTTONS[info.kind])  # what moves cannot be given another task


@pytest.mark.parametrize("zone", [0.1, 0.18])
def test_dead_zone_and_curve(zone):
    assert shaped(0.0, zone) == shaped(zone, zone) == shaped(-zone, zone) == 0.0
    assert shaped(zone + 1e-6, zone) == pytest.approx(SLOWEST, abs=1e-4)
    assert shaped(1.0, zone) == pytest.approx(1.0)
    assert shaped(-1.0, zone) == pytest.approx(-1.0)
    assert shaped(1.7, zone) == pytest.approx(1.0)  # a device may tell more than its end
    places = [zone + step * (1 - zone) / 20 for step in range(1, 21)]
    rates = [shaped(place, zone) for place in places]
    assert rates == sorted(rates)
    assert [shaped(-place, zone) for place in places] == [-rate for rate in rates]
    half = zone + (1 - zone) / 2  # half way is a quarter of the speed: fine near the centre
    assert shaped(half, zone) == pytest.approx(SLOWEST + (1 - SLOWEST) / 4)


@pytest.mark.parametrize("broken", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_moves_nothing_and_is_no_rest(broken):
    assert shaped(broken, 0.18) == 0.0
    assert not centred((0.0, broken), 0.18)


@pytest.mark.parametrize(
    ("pulled", "share"),
    [(0.0, 0.2), (0.5, 0.6), (1.0, 1.0), (-0.3, 0.2), (2.0, 1.0), (math.nan, 0.2)],
)
def test_the_trigger_makes_it_faster(pulled, share):
    assert WITHOUT_TRIGGER == 0.2
    assert speed_share(DeviceState(PAD, {"right_trigger": pulled})) == pytest.approx(share)


def test_a_space_mouse_has_no_trigger():
    assert speed_share(DeviceState(MOUSE)) == 1.0


def test_the_first_assignments_can_be_used():
    for kind, first in DEFAULTS.items():
        assert wrong_in(kind, first) == ""
        assert DEAD_ZONES[kind] > 0


@pytest.mark.parametrize(
    ("kept", "expected"),
    [
        (None, DEFAULTS[PAD.kind]),
        ({}, DEFAULTS[PAD.kind]),
        (
            {"dead_man": "right_shoulder"},
            Assignment("right_shoulder", "b", "x", "y", "start"),
        ),
        # kept before episodes had a button: the one it was given then stays with it
        ({"halt": "start"}, Assignment("left_shoulder", "b", "start", "y")),
        ({"halt": "", "mode": ""}, Assignment("left_shoulder", "b", "", "", "start")),
        # none of these may be used: no stop, an unknown button, one button for two things
        ({"stop": ""}, DEFAULTS[PAD.kind]),
        ({"dead_man": ""}, DEFAULTS[PAD.kind]),
        ({"dead_man": "turbo"}, DEFAULTS[PAD.kind]),
        ({"dead_man": "b"}, DEFAULTS[PAD.kind]),
        ({"dead_man": "dpad_up"}, DEFAULTS[PAD.kind]),
        ({"something": "a"}, DEFAULTS[PAD.kind]),
    ],
)
def test_what_was_kept_is_only_used_if_it_can_be(kept, expected):
    assert assignment(PAD.kind, kept) == expected


def test_a_button_that_is_taken_changes_places():
    first = DEFAULTS[PAD.kind]
    assert swapped(first, "dead_man", "a") == Assignment("a", "b", "x", "y", "start")
    assert swapped(first, "dead_man", "b") == Assignment("b", "left_shoulder", "x", "y", "start")
    assert swapped(first, "halt", "") == Assignment("left_shoulder", "b", "", "y", "start")
    without = swapped(first, "halt", "")
    assert swapped(without, "mode", "") == Assignment("left_shoulder", "b", "", "", "start")
