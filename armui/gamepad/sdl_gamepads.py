"""Reads gamepads through SDL 2, which knows the layout of some thousand models."""

from __future__ import annotations

import warnings
from typing import Any, Final

from armui.gamepad.device_state import DeviceInfo, DeviceKind, DeviceState

_AXES: Final = ("left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger")
"""The axes in SDL's order."""
_BUTTONS: Final = (
    *("a", "b", "x", "y", "back", "guide", "start", "left_stick", "right_stick"),
    *("left_shoulder", "right_shoulder", "dpad_up", "dpad_down", "dpad_left", "dpad_right"),
)
"""The buttons in SDL's order."""
_FULL: Final = 32767.0
_SPACE_MOUSE_VENDOR: Final = 0x256F
_HINTS: Final = {
    b"SDL_NO_SIGNAL_HANDLERS": b"1",  # Ctrl-C and SIGTERM belong to the program
    # the windows are Qt's: SDL has none that could have the focus
    b"SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS": b"1",
    b"SDL_JOYSTICK_THREAD": b"1",  # on Windows: detect devices in a thread of SDL's own
}


class SdlGamepads:
    """Reads gamepads; see :class:`armui.gamepad.device_reader.DeviceBackend`."""

    package = "pysdl2"

    def __init__(self) -> None:
        self.unusable: tuple[str, ...] = ()
        self._sdl: Any = None
        self._open: dict[int, tuple[DeviceInfo, Any]] = {}

    def open(self) -> None:
        """Load SDL and start its gamepads."""
        # the package warns at import about where its SDL library comes from
        warnings.filterwarnings("ignore", message="Using SDL2 binaries")
        import sdl2  # noqa: PLC0415 - an extra, loaded when it is wanted

        for name, value in _HINTS.items():
            sdl2.SDL_SetHint(name, value)
        if sdl2.SDL_Init(sdl2.SDL_INIT_GAMECONTROLLER) != 0:
            raise OSError(sdl2.SDL_GetError().decode("utf-8", "replace"))
        self._sdl = sdl2

    def scan(self) -> None:
        """Do nothing: SDL notices devices by itself, and :meth:`read` opens new ones."""

    def read(self, now_s: float) -> tuple[DeviceState, ...]:  # noqa: ARG002 - SDL says what goes
        """Return the present state of the gamepads."""
        sdl = self._sdl
        sdl.SDL_GameControllerUpdate()
        # the state is polled and nobody reads SDL's event queue: empty it, or it would fill up
        sdl.SDL_FlushEvents(sdl.SDL_FIRSTEVENT, sdl.SDL_LASTEVENT)
        self._open_new()
        states = []
        for number, (info, pad) in list(self._open.items()):
            if sdl.SDL_GameControllerGetAttached(pad):
                states.append(self._state(info, pad))
            else:
                sdl.SDL_GameControllerClose(pad)
                del self._open[number]
        return tuple(states)

    def close(self) -> None:
        """Release the gamepads and SDL."""
        if self._sdl is None:
            return
        for _info, pad in self._open.values():
            self._sdl.SDL_GameControllerClose(pad)
        self._open.clear()
        self._sdl.SDL_Quit()
        self._sdl = None

    def _open_new(self) -> None:
        sdl = self._sdl
        unusable = []
        for place in range(sdl.SDL_NumJoysticks()):
            if not sdl.SDL_IsGameController(place):
                # a SpaceMouse is no gamepad either, but the other back-end reads it
                if sdl.SDL_JoystickGetDeviceVendor(place) != _SPACE_MOUSE_VENDOR:
                    unusable.append(_text(sdl.SDL_JoystickNameForIndex(place)))
                continue
            number = sdl.SDL_JoystickGetDeviceInstanceID(place)
            if number < 0 or number in self._open:
                continue
            pad = sdl.SDL_GameControllerOpen(place)
            if pad:
                name = _text(sdl.SDL_GameControllerName(pad))
                info = DeviceInfo(f"sdl-{number}", name, DeviceKind.GAMEPAD)
                self._open[number] = (info, pad)
        self.unusable = tuple(unusable)

    def _state(self, info: DeviceInfo, pad: Any) -> DeviceState:
        sdl = self._sdl
        # SDL's axes reach from −32768 to 32767
        axes = {
            name: max(-1.0, sdl.SDL_GameControllerGetAxis(pad, place) / _FULL)
            for place, name in enumerate(_AXES)
        }
        down = frozenset(
            name
            for place, name in enumerate(_BUTTONS)
            if sdl.SDL_GameControllerGetButton(pad, place)
        )
        return DeviceState(info, axes, down)


def _text(name: bytes | None) -> str:
    return name.decode("utf-8", "replace").strip() if name else "?"
