"""Gamepads through SDL itself, with a virtual one that SDL makes; skipped where SDL is not."""

import importlib.util

import pytest

from armui.gamepad.device_state import DeviceKind
from armui.gamepad.layout import speed_share
from armui.gamepad.sdl_gamepads import SdlGamepads
from tests.gamepad.uinput_pad import UinputPad, why_no_uinput
from tests.waiting import wait_until

pytestmark = [
    pytest.mark.usefixtures("qapp"),
    pytest.mark.skipif(
        importlib.util.find_spec("sdl2") is None, reason="pysdl2 is not installed (armui[gamepad])"
    ),
]


@pytest.fixture
def backend():
    backend = SdlGamepads()
    backend.open()
    yield backend
    backend.close()


@pytest.fixture
def virtual(backend):
    """A gamepad of SDL's own making: the joystick to turn it by, and the library."""
    sdl = backend._sdl
    place = sdl.SDL_JoystickAttachVirtual(sdl.SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0)
    assert place >= 0, sdl.SDL_GetError()
    stick = sdl.SDL_JoystickOpen(place)
    yield sdl, stick, place
    sdl.SDL_JoystickClose(stick)


def test_axes_and_buttons_of_a_gamepad(backend, virtual):
    sdl, stick, _place = virtual
    (at_rest,) = backend.read(0.0)
    assert at_rest.info.kind is DeviceKind.GAMEPAD
    assert at_rest.buttons == frozenset()
    assert not any(at_rest.axes.values())
    sdl.SDL_JoystickSetVirtualAxis(stick, 0, -32768)
    sdl.SDL_JoystickSetVirtualAxis(stick, 3, 16384)
    sdl.SDL_JoystickSetVirtualAxis(stick, 5, 32767)
    for button in (1, 9, 11):
        sdl.SDL_JoystickSetVirtualButton(stick, button, 1)
    (state,) = backend.read(0.0)
    assert state.info == at_rest.info
    assert state.axes["left_x"] == -1.0
    assert state.axes["right_y"] == pytest.approx(0.5, abs=0.001)
    assert speed_share(state) == pytest.approx(1.0, abs=0.001)
    assert state.buttons == {"b", "left_shoulder", "dpad_up"}


def test_a_gamepad_that_goes_is_no_longer_there_and_one_that_comes_is_another(backend, virtual):
    sdl, _stick, place = virtual
    (before,) = backend.read(0.0)
    sdl.SDL_JoystickDetachVirtual(place)
    assert backend.read(0.0) == ()
    again = sdl.SDL_JoystickAttachVirtual(sdl.SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0)
    (after,) = backend.read(0.0)
    assert after.info.key != before.info.key
    sdl.SDL_JoystickDetachVirtual(again)


def test_a_joystick_of_unknown_layout_is_named_and_not_used(backend):
    sdl = backend._sdl
    place = sdl.SDL_JoystickAttachVirtual(sdl.SDL_JOYSTICK_TYPE_THROTTLE, 2, 4, 0)
    assert backend.read(0.0) == ()
    assert len(backend.unusable) == 1
    sdl.SDL_JoystickDetachVirtual(place)
    backend.read(0.0)
    assert backend.unusable == ()


def test_it_can_be_closed_and_opened_again():
    for _ in range(2):
        backend = SdlGamepads()
        backend.open()
        assert backend.read(0.0) == ()
        backend.close()
        backend.close()


@pytest.mark.skipif(bool(why_no_uinput()), reason=why_no_uinput() or "-")
def test_a_gamepad_of_the_kernel(backend):
    """From the kernel's own device files to the state: as a real gamepad comes."""
    with UinputPad() as pad:
        wait_until(lambda: backend.read(0.0) != ())
        pad.push_left(-32768)
        pad.press_left_shoulder()
        wait_until(lambda: "left_shoulder" in backend.read(0.0)[0].buttons)
        (state,) = backend.read(0.0)
        assert state.axes["left_x"] == -1.0
    wait_until(lambda: backend.read(0.0) == ())
