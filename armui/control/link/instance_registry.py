"""Other copies of this program on the computer, on the same settings file or CAN channel."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.control.events import Event, EventCode
from armui.control.operating_state import OperatingState
from armui.system.files import error_text
from armui.system.presence import PresenceWatch

if TYPE_CHECKING:
    from armui.arm.device import Device
    from armui.control.arm_controller import ArmController

_IN_THIS_PROCESS: Final = frozenset({"virtual"})
"""Back-ends whose channels no other program can reach."""


class InstanceRegistry(QObject):
    """Says that another copy of the program is there, when it comes or is found (safety S21).

    Two copies that drive one arm undo each other's stops and motions; two that change one settings
    file each keep their own choices and find the other's at the next start.

    Args:
        controller: Tells which device is open, and gets the events.
        settings: The settings file.
        folder: Where running programs meet.
        look_s: How often to look.
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
        self._settings = self._watch(
            EventCode.SETTINGS_SHARED, str(settings.absolute()), str(settings)
        )
        controller.operating_state_changed.connect(self._on_operating_state)
        self._on_operating_state(controller.operating_state)

    def close(self) -> None:
        """Withdraw from every place where copies of the program find each other."""
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
            self._channel = self._watch(EventCode.CHANNEL_SHARED, key, device)

    def _watch(self, code: EventCode, key: str, what: object) -> PresenceWatch:
        name = hashlib.sha256(key.encode("utf-8", "surrogatepass")).hexdigest()[:16]
        tell = partial(self._counted.emit, code, what)
        return PresenceWatch(self._folder / f"{code}-{name}", tell, self._look_s)

    def _on_counted(self, code: EventCode, what: object, count: int | OSError) -> None:
        if isinstance(count, OSError):
            if not self._alone:
                params = {"path": str(self._folder), "text": error_text(count)}
                self._tell(EventCode.NOBODY_MET, params)
            self._alone = True
            return
        late = code == EventCode.CHANNEL_SHARED and what != self._device
        if count and not late:
            name = "device" if code == EventCode.CHANNEL_SHARED else "path"
            self._tell(code, {name: what, "count": count})

    def _tell(self, code: EventCode, params: Mapping[str, object]) -> None:
        at = datetime.now().astimezone()
        self._controller.noticed.emit(Event(at, code.level, code, params))
