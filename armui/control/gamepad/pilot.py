"""Jogs the arm by gamepad or SpaceMouse, under the rules of a held button.

The devices are read in a thread of their own; here, in the window's thread, each reading goes
through the dead-man logic of :mod:`armui.gamepad.dead_man`, which yields a steered jog. Whatever
takes the hold away ends the jog, and only a new press of the dead-man button begins another.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from armui.arm.refusal import Reason, Refusal
from armui.cell.user_frames import UserFrame
from armui.control.motion.jog_path import MotionFrame
from armui.control.motion.jogging import GAMEPAD_SILENT, axes_text
from armui.control.motion.steered_path import SteeredJog
from armui.control.operating_state import JOG_UNDER_WAY
from armui.gamepad.dead_man import UNATTENDED_S, DeadMan, HoldPhase, Loss
from armui.gamepad.device_reader import OnButtons, Reader, read_devices
from armui.gamepad.device_state import DeviceInfo, DeviceSnapshot, DeviceState
from armui.gamepad.layout import Assignment, JogMode, assignment
from armui.kinematics.axes import JogFrame

if TYPE_CHECKING:
    from armui.control.motion.cartesian import Cartesian
    from armui.control.motion.jogging import Jogging
    from armui.setting_fields import Settings

GAMEPAD_UNATTENDED = Reason(
    "gamepad_unattended",
    "The dead-man button was held for {seconds} s without a movement of the device. Press again.",
)
GAMEPAD_LOST = Reason("gamepad_lost", "{name} is gone. Plug it in again or switch it on.")
GAMEPAD_NOT_IN_FRONT = Reason(
    "gamepad_not_in_front",
    "The main window, or a page taken out of it, is not in front, or a menu is open. Click "
    "into one of them, then press again.",
)


_TICK_MS: Final = 10
"""The device is read, and its jog steered, a hundred times a second."""
SILENT_S: Final = 0.08
"""Readings of devices older than this are not used."""

_FRAMES: Final = {
    JogMode.JOINT: None,
    JogMode.BASE: JogFrame.BASE,
    JogMode.TOOL: JogFrame.TOOL,
}

MakeReader = Callable[[OnButtons, Callable[[], float]], Reader]

_WITHOUT: Final = frozenset({HoldPhase.UP, HoldPhase.SPENT})
"""The phases in which there is no hold to end."""


@dataclass(frozen=True, slots=True)
class PilotView:
    """The state that the window shows.

    Attributes:
        on: True while devices are read.
        devices: The devices found.
        mode: The motion that the axes steer.
        phase: The phase of the hold.
        device: The device whose dead-man button is held, or ``None``.
        axes: The axes that move, as J1+ J3−.
        refusal: The reason that ended the last hold, while the button is still held.
        unusable: The names of devices found that cannot be used.
        missing: The packages that are not installed.
        problems: The error messages of libraries.
    """

    on: bool = False
    devices: tuple[DeviceInfo, ...] = ()
    mode: JogMode = JogMode.JOINT
    phase: HoldPhase = HoldPhase.UP
    device: DeviceInfo | None = None
    axes: str = ""
    refusal: Refusal | None = None
    unusable: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()


class GamepadPilot(QObject):
    """Reads devices while it is switched on, and jogs the arm by them.

    Args:
        jogging: Carries out the jogs.
        cartesian: Knows the user frame in force.
        stop: Sends the emergency stop.
        halt: Has the arm end its motion and hold.
        mark_episode: Begins an episode, or ends the one under way.
        discard_episode: Discards the last episode.
        clock: Monotonic time in seconds.

    Attributes:
        attended: Returns why nothing may be jogged from the window now; without a window nothing
            may.
        make_reader: Makes the reader of the devices.

    Signals:
        changed: A :class:`PilotView`, when it differs.
    """

    changed = Signal(object)
    _buttons = Signal(object, object, object)

    def __init__(
        self,
        jogging: Jogging,
        cartesian: Cartesian,
        *,
        stop: Callable[[], object],
        halt: Callable[[], object],
        mark_episode: Callable[[], object],
        discard_episode: Callable[[], object],
        clock: Callable[[], float],
    ) -> None:
        super().__init__()
        self.attended: Callable[[], Refusal | None] = GAMEPAD_NOT_IN_FRONT
        self.make_reader: MakeReader = read_devices
        self._jogging, self._cartesian = jogging, cartesian
        self._stop, self._halt = stop, halt
        self._mark_episode, self._discard_episode = mark_episode, discard_episode
        self._clock = clock
        self._reader: Reader | None = None
        self._leaving: Reader | None = None
        self._settings: Settings | None = None
        self._mode = JogMode.JOINT
        self._hands: dict[str, DeadMan] = {}
        self._infos: dict[str, DeviceInfo] = {}
        self._holder: str | None = None
        self._driving = False
        self._reason: Refusal | None = None
        self._view = PilotView()
        # The reader emits this signal in its own thread, which is no thread of Qt's.
        self._buttons.connect(self._on_buttons, Qt.ConnectionType.QueuedConnection)
        self._timer = QTimer(self, interval=_TICK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.tick)

    @property
    def view(self) -> PilotView:
        """The state that the window shows now."""
        return self._view

    @property
    def snapshot(self) -> DeviceSnapshot | None:
        """The last reading of the devices, for a display of their axes."""
        return None if self._reader is None else self._reader.latest

    def choose(self, settings: Settings) -> None:
        """Take over the operator's settings; end a hold."""
        before, self._settings = self._settings, settings
        if before is not None and _concerns(before) == _concerns(settings):
            return
        self._take_away(None)
        if before is None or before.gamepad_mode != settings.gamepad_mode:
            self._mode = JogMode(settings.gamepad_mode)
        if settings.gamepad:
            self._timer.start()
            self._begin()
        else:
            self._stop_reading()
        self._show()

    def _begin(self) -> None:
        """Start reading, unless the last reader still holds the libraries: they serve one only."""
        if self._leaving is not None and not self._leaving.running:
            self._leaving = None
        if self._reader is None and self._leaving is None:
            self._reader = self.make_reader(self._buttons.emit, self._clock)

    def _stop_reading(self) -> None:
        self._take_away(None)
        self._timer.stop()
        if self._reader is not None:
            self._reader.stop()
            self._reader, self._leaving = None, self._reader
        self._hands.clear()
        self._infos.clear()
        self._holder = None

    def end(self) -> bool:
        """Stop reading devices and return whether the thread has ended."""
        self._stop_reading()
        self._show()
        return self._leaving is None or self._leaving.end()

    def buttons_of(self, info: DeviceInfo) -> Assignment:
        """Return the assignment of a device's buttons."""
        kept = None if self._settings is None else self._settings.gamepad_buttons.get(info.name)
        return assignment(info.kind, kept)

    def set_mode(self, mode: JogMode) -> None:
        """Set the motion that the axes steer from now on; end a hold."""
        if mode is not self._mode:
            self._take_away(None)
            self._mode = mode
            self._show()

    def lose(self, reason: Refusal) -> None:
        """End the hold with a reason; do nothing if nothing is held."""
        if any(hand.hold.phase not in _WITHOUT for hand in self._hands.values()):
            self._take_away(reason)
            self._show()

    # Reading the devices ----------------------------------------------------------------------

    def tick(self) -> None:
        """Read the devices and act on them; the pilot's own timer calls it."""
        settings = self._settings
        if settings is None or not settings.gamepad:
            return
        self._begin()
        reader = self._reader
        if reader is None:
            return
        snapshot, now_s = reader.latest, self._clock()
        if now_s - snapshot.at_s > SILENT_S:
            self._lose_holder(GAMEPAD_SILENT)
        else:
            self._forget_gone(snapshot)
            for state in snapshot.devices:
                self._look_at(state, now_s, settings)
            self._drive()
        self._show(snapshot)

    def _look_at(self, state: DeviceState, now_s: float, settings: Settings) -> None:
        key = state.info.key
        hand = self._hands.setdefault(key, DeadMan())
        self._infos[key] = state.info
        before = hand.hold.phase
        buttons = self.buttons_of(state.info)
        hold = hand.update(state, buttons, self._mode, now_s, one_axis=settings.gamepad_one_axis)
        if hold.phase is HoldPhase.UP:
            if self._holder == key:
                self._release_hold()
            return
        if before is HoldPhase.UP:
            self._on_pressed(key)
        if hold.lost is Loss.SILENT:
            self._lose_holder(GAMEPAD_SILENT)
        elif hold.lost is Loss.UNATTENDED:
            self._take_away(GAMEPAD_UNATTENDED(seconds=round(UNATTENDED_S)))
        elif hold.phase is not HoldPhase.SPENT and (reason := self.attended()) is not None:
            self._take_away(reason)

    def _on_pressed(self, key: str) -> None:
        """Begin a hold as a dead-man button goes down; that of a second device ends every hold."""
        if self._holder is None:
            self._holder, self._reason = key, None
        elif self._holder != key:
            self._take_away(None)

    def _forget_gone(self, snapshot: DeviceSnapshot) -> None:
        there = {each.info.key for each in snapshot.devices}
        for key in [key for key in self._hands if key not in there]:
            if key == self._holder:
                self._lose_holder(GAMEPAD_LOST)
                self._holder = None
            del self._hands[key], self._infos[key]

    def _drive(self) -> None:
        key = self._holder
        hand = self._hands.get(key) if key is not None else None
        if key is None or hand is None or hand.hold.phase is not HoldPhase.MOVING:
            self._stop_ours()
            return
        frame: MotionFrame | None = _FRAMES.get(self._mode)
        if self._mode is JogMode.USER:  # without a frame in force the jog is refused
            frame = self._cartesian.frame or UserFrame("")
        jog = SteeredJog(hand.hold.rates, frame, self._infos[key].name)
        jogging = self._jogging
        if self._driving:
            if not jogging.steer(jog):  # it has ended, with a reason given elsewhere
                self._take_away(None)
        elif jogging.active:
            self._take_away(JOG_UNDER_WAY())
        else:
            answer = jogging.start(jog)
            if isinstance(answer, Refusal):
                self._take_away(answer)
            else:
                self._driving = True

    # The end of a hold ------------------------------------------------------------------------

    def _lose_holder(self, code: Reason) -> None:
        if self._holder is None:
            return
        hand = self._hands.get(self._holder)
        held = hand is not None and hand.hold.phase not in _WITHOUT
        if held or self._driving:
            self._take_away(Refusal(code, {"name": self._infos[self._holder].name}))

    def _take_away(self, reason: Refusal | None) -> None:
        """End every hold, even while buttons are still down; a new press is needed afterwards."""
        for hand in self._hands.values():
            hand.spend()
        self._reason = reason
        if self._driving and reason is not None and self._jogging.steered is not None:
            self._driving = False
            self._jogging.end_jog(reason)
        self._stop_ours()

    def _release_hold(self) -> None:
        self._holder, self._reason = None, None
        self._stop_ours()

    def _stop_ours(self) -> None:
        """End the jog that a device steers; a jog held by a button on the screen goes on."""
        driving, self._driving = self._driving, False
        if driving and self._jogging.steered is not None:
            self._jogging.stop()

    # Buttons ----------------------------------------------------------------------------------

    def _on_buttons(self, info: DeviceInfo, down: frozenset[str], up: frozenset[str]) -> None:
        """Handle buttons that went down or came up; the reader reports even the shortest press."""
        if self._reader is None:
            return
        buttons = self.buttons_of(info)
        if buttons.stop in down:
            self._stop()
            self._take_away(None)
        elif buttons.halt and buttons.halt in down:
            self._halt()
            self._take_away(None)
        hand = self._hands.get(info.key)
        if buttons.dead_man in up and hand is not None:
            hand.release()
            if self._holder == info.key:
                self._release_hold()
        if buttons.mode and buttons.mode in down and not self._driving:
            none = self._cartesian.frame is None
            modes = [mode for mode in JogMode if mode is not JogMode.USER or not none]
            place = modes.index(self._mode) if self._mode in modes else -1
            self.set_mode(modes[(place + 1) % len(modes)])
        if buttons.episode and buttons.episode in down:
            self._mark_episode()
        if buttons.discard and buttons.discard in down:
            self._discard_episode()
        self._show()

    # Display ----------------------------------------------------------------------------------

    def _show(self, snapshot: DeviceSnapshot | None = None) -> None:
        snapshot = snapshot or self.snapshot or DeviceSnapshot(0.0)
        hand = self._hands.get(self._holder) if self._holder is not None else None
        steered = self._jogging.steered if self._driving else None
        view = PilotView(
            on=self._reader is not None,
            devices=tuple(each.info for each in snapshot.devices),
            mode=self._mode,
            phase=HoldPhase.UP if hand is None else hand.hold.phase,
            device=self._infos.get(self._holder) if self._holder is not None else None,
            axes="" if steered is None else axes_text(steered),
            refusal=self._reason,
            unusable=snapshot.unusable,
            missing=snapshot.missing,
            problems=snapshot.problems,
        )
        if view != self._view:
            self._view = view
            self.changed.emit(view)


def _concerns(settings: Settings) -> tuple[object, ...]:
    return (
        settings.gamepad,
        settings.gamepad_mode,
        settings.gamepad_one_axis,
        settings.gamepad_buttons,
    )
