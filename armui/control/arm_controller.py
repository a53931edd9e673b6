"""Every action of the operator: checked, sent, and followed until the arm's own feedback shows it.

The controller lives in the GUI thread. It never waits: a tick looks at what the bus thread has
heard and moves on whatever is under way.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from armui.arm.device import Device
from armui.arm.limits import check_joints
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.bus.link import BusReport
from armui.control import gate, reports
from armui.control.assessment import Circumstances, assess
from armui.control.connection import Connection
from armui.control.device_finder import DeviceFinder
from armui.control.joint_errors import JointErrors
from armui.control.lights import Lights
from armui.control.notices import CODES
from armui.control.request import Outcome, Request
from armui.control.setpoint import Setpoint
from armui.control.situation import Busy, LinkState, Notice, Situation, StopState
from armui.control.speed import speed_frames
from armui.control.stop import StopKeeper, is_stopped
from armui.protocol import commands
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.bus.worker import Opener

_TICK_MS: Final = 33
_HOME_DEG: Final = (0.0,) * 6
_FIRST_SPEED_PERCENT: Final = 30

_ENABLE_REPEAT_S: Final = 0.5
_ENABLE_ATTEMPTS: Final = 3
"""Real arms often want the enable command twice."""
_RESUME_REPEAT_S: Final = 0.5
_RESUME_ATTEMPTS: Final = 2


class ArmController(QObject):
    """What the windows talk to.

    Every command answers at once: ``None``, it is under way, or a :class:`Refusal`, nothing was
    sent. What becomes of it is told by the signals.

    Args:
        opener: Opens a device; see :data:`armui.bus.worker.Opener`.
        simulated: Arms made of software, listed with the devices found.
        find: The search for devices.
        clock: Monotonic time in seconds.

    Attributes:
        lights: The lamps of the joints.
        joint_errors: Clears the errors of the joints' drivers.

    Signals:
        state_changed: An :class:`ArmState`, at most 30 times a second, when something was heard.
        situation_changed: A :class:`Situation`, when it differs.
        noticed: A :class:`Notice`.
        devices_found: A list of :class:`Device`, the answer to :meth:`search_devices`.
        searching_changed: Whether a search is under way.
    """

    state_changed = Signal(object)
    situation_changed = Signal(object)
    noticed = Signal(object)
    devices_found = Signal(object)
    searching_changed = Signal(bool)

    def __init__(
        self,
        opener: Opener,
        simulated: Sequence[Device] = (),
        find: Callable[[], list[Device]] | None = None,
        clock: Callable[[], float] = time.monotonic,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._clock = clock
        self._finder = DeviceFinder(simulated, find, self)
        self._finder.found.connect(self.devices_found)
        self._finder.searching_changed.connect(self.searching_changed)
        self._connection = Connection(opener, clock, self)
        self._connection.changed.connect(self._on_connection)
        self._stop = StopKeeper(self._connection.send_urgent)
        self.lights = Lights(self._connection, self._notice)
        self.joint_errors = JointErrors(self._connection, self._notice, clock)
        self._request: tuple[Busy, Request] | None = None
        self._speed_percent = _FIRST_SPEED_PERCENT
        self._setpoint = Setpoint()
        self._was_online = False
        self._was_unconfirmed = False
        self._limits_told = False
        self._state = ArmState()
        self._situation = Situation(speed_percent=self._speed_percent)
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(_TICK_MS)
        self._timer.timeout.connect(self.tick)

    @property
    def state(self) -> ArmState:
        """The arm as last heard."""
        return self._state

    @property
    def situation(self) -> Situation:
        """What the operator can do now."""
        return self._situation

    @property
    def setpoint_deg(self) -> tuple[float, ...] | None:
        """The angles last sent, as long as they stand for what the arm is doing."""
        return self._setpoint.angles_deg

    # Devices ----------------------------------------------------------------------------------

    def search_devices(self) -> None:
        """Look for devices; :attr:`devices_found` tells."""
        self._finder.start()

    @staticmethod
    def interfaces() -> list[str]:
        """The back-ends python-can knows on this computer."""
        from armui.bus.adapters import interfaces  # noqa: PLC0415 - loaded when asked for

        return interfaces()

    def connect_device(self, device: Device) -> None:
        """Leave the present device, if any, and open this one."""
        self.disconnect_device()
        self._connection.open(device)
        self._timer.start()
        self._refresh()

    def disconnect_device(self) -> None:
        """Close the device. The arm goes on with what it was told last."""
        device = self._connection.device
        if device is None:
            return
        self._forget_arm()
        self._connection.close()
        self._timer.stop()
        self._state = ArmState()
        self._notice("disconnected", device=device)
        self.state_changed.emit(self._state)
        self._refresh()

    def shutdown(self) -> None:
        """Close the device and end every thread; nothing is sent."""
        self._finder.wait()
        self.disconnect_device()

    # The stop ---------------------------------------------------------------------------------

    def emergency_stop(self) -> None:
        """Stop the arm at once: past every other frame, whatever else is under way (0x150)."""
        self._setpoint.clear()
        self._request = None
        if self._connection.device is None:
            self._notice("stop_not_sent")
            return
        frames = commands.emergency_stop(self._connection.codec)
        on_the_bus = self._stop.request(frames, self._clock())
        self._notice("stop_sent" if on_the_bus else "stop_not_sent")
        self._refresh()

    def resume(self) -> Refusal | None:
        """End the emergency stop: power is cut at once, the arm DROPS; then it must be enabled."""
        if self._situation.stop is not StopState.STOPPED:
            return self._refuse(Refusal("not_stopped"))
        self._notice("resume_sent")
        self._start(
            Busy.RESUMING,
            commands.resume(self._connection.codec),
            lambda state: state.status is not None and not is_stopped(state),
            _RESUME_REPEAT_S,
            _RESUME_ATTEMPTS,
        )
        return None

    # Motors and speed -------------------------------------------------------------------------

    def enable_motors(self) -> Refusal | None:
        """Enable all six motors (0x471), again until the drivers say that all are on."""
        return self._switch_motors(on=True)

    def disable_motors(self) -> Refusal | None:
        """Disable all six motors (0x471): the arm DROPS."""
        return self._switch_motors(on=False)

    def set_speed_percent(self, percent: float) -> Refusal | None:
        """Set the speed of motions, 0–100 % of the arm's maximum (0x151 byte 2).

        The arm is told at once, in the mode it is in; it keeps that mode.
        """
        if not 0 <= percent <= 100:
            return self._refuse(Refusal("speed_out_of_range", {"value": percent}))
        self._speed_percent = round(percent)
        if gate.why_no_command(self._situation.link, self._situation.stop, None) is None:
            frames = speed_frames(self._connection.codec, self._state, self._speed_percent)
            if frames and self._connection.send(frames):
                self._notice("sent_speed", percent=self._speed_percent)
        self._refresh()
        return None

    # Motion -----------------------------------------------------------------------------------

    def jog(self, joint: int, delta_deg: float) -> Refusal | None:
        """Move one joint by a step at once; the other five stay where they are or were going."""
        base_deg = self._setpoint.jog_base_deg(
            self._state, self._clock(), moving=self._situation.moving
        )
        if base_deg is None:
            return self._refuse(self._situation.cannot_move or Refusal("joints_unknown"))
        target_deg = list(base_deg)
        target_deg[joint - 1] = round(target_deg[joint - 1] + delta_deg, 3)
        return self._move(target_deg, "jogged", joint=joint, target=target_deg[joint - 1])

    def jog_lagging(self, joint: int, step_deg: float) -> bool:
        """Whether the arm is so far behind that a held button should not step on."""
        return self._setpoint.lagging(self._state, joint, step_deg)

    def send_joints(self, angles_deg: Sequence[float]) -> Refusal | None:
        """Move to six angles in degrees (MOVE J, 0x155–0x157 and 0x151)."""
        return self._move(angles_deg, "sent_joints", **reports.numbered(angles_deg))

    def go_home(self) -> Refusal | None:
        """Move to the factory zero angles."""
        return self._move(_HOME_DEG, "went_home")

    # How commands are carried out ---------------------------------------------------------------

    def _move(self, angles_deg: Sequence[float], code: str, **figures: object) -> Refusal | None:
        """Send six angles if that may be, and tell so with a notice."""
        self._refresh()
        refusal = self._situation.cannot_move or check_joints(angles_deg, self._situation.limits)
        if refusal is not None:
            return self._refuse(refusal)
        frames = commands.move_joints(
            self._connection.codec, angles_deg, speed_percent=self._speed_percent
        )
        if not self._connection.send(frames):
            return self._refuse(Refusal("link_lost"))
        self._setpoint.set(angles_deg, self._clock())
        self._notice(code, **figures)
        return None

    def _switch_motors(self, *, on: bool) -> Refusal | None:
        self._refresh()
        if self._situation.cannot_enable is not None:
            return self._refuse(self._situation.cannot_enable)
        self._setpoint.clear()
        command = commands.enable_motors if on else commands.disable_motors
        self._notice("enable_sent" if on else "disable_sent")
        self._start(
            Busy.ENABLING if on else Busy.DISABLING,
            command(self._connection.codec),
            lambda state: all(enabled is on for enabled in state.enabled()),
            _ENABLE_REPEAT_S,
            _ENABLE_ATTEMPTS,
        )
        return None

    def _start(
        self,
        busy: Busy,
        frames: Sequence[Frame],
        seen: Callable[[ArmState], bool],
        repeat_s: float,
        attempts: int,
    ) -> None:
        request = Request(frames, seen, self._connection.send, repeat_s, attempts)
        self._request = (busy, request)
        request.advance(self._state, self._clock())
        self._refresh()

    def _refuse(self, refusal: Refusal | None) -> Refusal:
        refusal = refusal or Refusal("not_connected")
        self._notice("refused", reason=refusal)
        return refusal

    def _notice(self, code: str, **params: object) -> None:
        self.noticed.emit(Notice(datetime.now().astimezone(), CODES[code], code, params))

    # What time and the arm bring ----------------------------------------------------------------

    def tick(self) -> None:
        """Take in what was heard and move on what is under way; the controller's timer calls it."""
        now_s = self._clock()
        heard = self._connection.advance(now_s)
        changed = heard is not self._state
        self._state = heard
        self._follow_online()
        self._follow_stop(now_s)
        self._follow_request(now_s)
        self.joint_errors.advance()
        self._follow_handshake()
        self._refresh()
        if changed:
            self.state_changed.emit(heard)

    def _follow_online(self) -> None:
        online = self._connection.link is LinkState.ONLINE
        if online is not self._was_online:
            self._was_online = online
            if online:
                self._limits_told = False
            else:
                self._setpoint.clear()
            if self._connection.link in {LinkState.ONLINE, LinkState.OFFLINE}:
                self._notice("online" if online else "offline")

    def _follow_stop(self, now_s: float) -> None:
        if self._stop.advance(self._state, now_s):
            self._notice("stop_confirmed")
        unconfirmed = self._stop.unconfirmed(now_s)
        if unconfirmed and not self._was_unconfirmed:
            self._notice("stop_unconfirmed")
        self._was_unconfirmed = unconfirmed
        if is_stopped(self._state):
            self._setpoint.clear()

    def _follow_request(self, now_s: float) -> None:
        if self._request is None:
            return
        busy, request = self._request
        outcome = request.advance(self._state, now_s)
        if outcome is Outcome.WAITING:
            return
        self._request = None
        code, figures = reports.on_request(busy, self._state, done=outcome is Outcome.DONE)
        self._notice(code, **figures)

    def _follow_handshake(self) -> None:
        handshake = self._connection.handshake
        if handshake is None or not handshake.done or self._limits_told:
            return
        self._limits_told = True
        for code, figures in reports.on_handshake(self._state, handshake.generation):
            self._notice(code, **figures)

    def _on_connection(self, report: BusReport, code: str) -> None:
        if code == "link_lost":
            self._setpoint.clear()
            self._request = None
        elif code == "connect_failed":
            self._timer.stop()
            self._forget_arm()
        self._notice(code, device=report.device, reason=report.problem)
        self._refresh()

    def _forget_arm(self) -> None:
        self._stop.forget()
        self.joint_errors.forget()
        self._request = None
        self._setpoint.clear()
        self._was_online = False

    def _refresh(self) -> None:
        situation = self._assess(self._clock())
        if situation != self._situation:
            self._situation = situation
            self.situation_changed.emit(situation)

    def _assess(self, now_s: float) -> Situation:
        busy = self._request[0] if self._request is not None else None
        around = Circumstances(
            link=self._connection.link,
            device=self._connection.device,
            link_problem=self._connection.problem,
            stop=self._stop.state(
                self._state,
                online=self._connection.link is LinkState.ONLINE,
                resuming=busy is Busy.RESUMING,
            ),
            stop_unconfirmed=self._stop.unconfirmed(now_s),
            busy=busy,
            speed_percent=self._speed_percent,
            generation=self._connection.generation,
        )
        return assess(self._state, around, now_s)
