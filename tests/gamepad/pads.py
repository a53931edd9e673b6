"""Gamepads and SpaceMice in a test's hand, where the program reads its devices from."""

from __future__ import annotations

from collections.abc import Callable

from armui.app import Program
from armui.gamepad.device_reader import OnButtons
from armui.gamepad.device_state import DeviceInfo, DeviceKind, DeviceSnapshot, DeviceState

PAD = DeviceInfo("sdl-1", "Xbox Wireless Controller", DeviceKind.GAMEPAD)
OTHER_PAD = DeviceInfo("sdl-2", "DualSense", DeviceKind.GAMEPAD)
MOUSE = DeviceInfo("hid-1", "SpaceMouse Compact", DeviceKind.SPACE_MOUSE)


class Pads:
    """A reader without a thread: it tells what the test makes it tell.

    Attributes:
        hangs: Nothing is read any more; what was read last stays.
        ended: Whether the program has ended it.
    """

    def __init__(self) -> None:
        self.hangs = False
        self.ended = False
        self.missing: tuple[str, ...] = ()
        self.unusable: tuple[str, ...] = ()
        self.problems: tuple[str, ...] = ()
        self._states: dict[str, DeviceState] = {}
        self._clock: Callable[[], float] = lambda: 0.0
        self._on_buttons: OnButtons | None = None
        self._last = DeviceSnapshot(0.0)

    def make(self, on_buttons: OnButtons, clock: Callable[[], float]) -> Pads:
        self._on_buttons, self._clock, self.ended = on_buttons, clock, False
        return self

    # what the pilot asks

    @property
    def latest(self) -> DeviceSnapshot:
        if not self.hangs:
            states = tuple(self._states.values())
            self._last = DeviceSnapshot(
                self._clock(), states, self.unusable, self.missing, self.problems
            )
        return self._last

    @property
    def running(self) -> bool:
        return False

    def stop(self) -> None:
        self.ended = True

    def end(self) -> bool:
        self.ended = True
        return True

    # what a hand does

    def plug_in(self, info: DeviceInfo = PAD, down: tuple[str, ...] = ()) -> None:
        self._states[info.key] = DeviceState(info, {}, frozenset(down))

    def unplug(self, info: DeviceInfo = PAD) -> None:
        del self._states[info.key]

    def push(self, info: DeviceInfo = PAD, *, silent: bool = False, **axes: float) -> None:
        """Push axes; those that are not named stay."""
        now = self._states[info.key]
        self._states[info.key] = DeviceState(info, {**now.axes, **axes}, now.buttons, silent)

    def press(self, *names: str, info: DeviceInfo = PAD) -> None:
        self._change(info, frozenset(names), frozenset())

    def release(self, *names: str, info: DeviceInfo = PAD) -> None:
        self._change(info, frozenset(), frozenset(names))

    def _change(self, info: DeviceInfo, down: frozenset[str], up: frozenset[str]) -> None:
        now = self._states[info.key]
        self._states[info.key] = DeviceState(info, now.axes, (now.buttons | down) - up)
        if self._on_buttons is not None:
            self._on_buttons(info, down - now.buttons, up & now.buttons)


def switch_on(program: Program, pads: Pads, **choices: object) -> None:
    """Switch the gamepads on as the operator does, with these in their place."""
    program.controller.gamepad.make_reader = pads.make
    store = program.window._preferences
    assert store.change(gamepad=True, **choices) is None  # type: ignore[arg-type]  # by name
