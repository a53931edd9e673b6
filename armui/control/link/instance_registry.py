"""Finds other running copies of this program on the same settings file or CAN channel."""

from __future__ import annotations

import hashlib
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.control.events import Event, Notice
from armui.control.operating_state import OperatingState
from armui.system.files import error_text
from armui.system.presence import PresenceWatch
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.arm.device import Device
    from armui.control.arm_controller import ArmController

SETTINGS_SHARED = Notice(
    "settings_shared",
    "Another armui on this computer uses the same settings file. What is changed here is "
    "kept. What is kept there of single arms and devices is followed here at once; other changes "
    "made there appear at the next start.",
    Level.WARNING,
    EventKind.PROGRAM,
)
CHANNEL_SHARED = Notice(
    "channel_shared",
    "Another armui on this computer is connected to {device}, too. Both can move the arm: "
    "close one of them.",
    Level.WARNING,
    EventKind.PROGRAM,
)
NOBODY_MET = Notice(
    "nobody_met",
    "armui cannot tell whether another copy runs on this computer: {path} cannot be used "
    "({text}). Do not start the program twice for one arm.",
    Level.WARNING,
    EventKind.PROGRAM,
)

_IN_THIS_PROCESS: Final = frozenset({"virtual"})
"""The back-ends whose channels no other program can reach."""


class InstanceRegistry(QObject):
    """Warns when another copy of the program starts or is found (safety S21).

    Two copies on one arm undo each other's stops and motions. Of two copies on one settings file
    each keeps its own choices, and finds the other's at the next start; what they keep of arms and
    devices is merged by entry, and followed.

    Args:
        controller: Tells which device is open, and gets the events.
        settings: The settings file.
        folder: The folder in which running copies register.
        look_s: The interval of looking for other copies.
    """

    _counted = Signal(object, object, object)

    def __init__(
        self, controller: ArmController, settings: Path, folder: Path, look_s: float = 1.0
    ) -> None:
        super().__init__()
        self._controller = controller
        self._folder = folder
        self._look_s = look_s
        self._alone = False
        self._device: Device | None = None
        self._channel: PresenceWatch | None = None
        self._counted.connect(self._on_counted)
        self._settings = self._watch(SETTINGS_SHARED, str(settings.absolute()), str(settings))
        controller.operating_state_changed.connect(self._on_operating_state)
        self._on_operating_state(controller.operating_state)

    def close(self) -> None:
        """Remove this copy's registrations."""
        self._controller.operating_state_changed.disconnect(self._on_operating_state)
        self._settings.close()
        if self._channel is not None:
            self._channel.close()
            self._channel = None

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        device = operating_state.device
        if device == self._device:
            return
        self._device = device
        if self._channel is not None:
            self._channel.close()
            self._channel = None
        if device is not None and device.interface not in _IN_THIS_PROCESS:
            key = f"{device.interface} {device.channel} {device.serial or ''}"
            self._channel = self._watch(CHANNEL_SHARED, key, device)

    def _watch(self, notice: Notice, key: str, what: object) -> PresenceWatch:
        name = hashlib.sha256(key.encode("utf-8", "surrogatepass")).hexdigest()[:16]
        on_count = partial(self._counted.emit, notice, what)
        return PresenceWatch(self._folder / f"{notice}-{name}", on_count, self._look_s)

    def _on_counted(self, notice: Notice, what: object, count: int | OSError) -> None:
        if isinstance(count, OSError):
            if not self._alone:
                self._emit_event(NOBODY_MET, path=str(self._folder), text=error_text(count))
            self._alone = True
            return
        late = notice == CHANNEL_SHARED and what != self._device
        if count and not late:
            name = "device" if notice == CHANNEL_SHARED else "path"
            self._emit_event(notice, count=count, **{name: what})

    def _emit_event(self, notice: Notice, **params: object) -> None:
        at = datetime.now().astimezone()
        self._controller.noticed.emit(Event(at, notice, params))
