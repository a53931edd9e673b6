"""SpaceMice through hidapi: the device's own reports, with or without its maker's driver."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from typing import Any, Final

from armui.gamepad.device_state import DeviceInfo, DeviceKind, DeviceState
from armui.gamepad.space_mouse_reports import SpaceMouseState, after

_VENDORS: Final = (0x256F, 0x046D)
"""3Dconnexion; before 2013 its devices had Logitech's number."""
_OLD_PRODUCTS: Final = frozenset(
    {0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625, 0xC626, 0xC627, 0xC628, 0xC629, 0xC62B}
)
_GENERIC_DESKTOP: Final = 1
_MULTI_AXIS: Final = 8
_REPORT_BYTES: Final = 64
_MOST_REPORTS: Final = 200
"""At once: a device that floods must not keep the thread."""
SILENT_S: Final = 0.5
"""Away from its centre a SpaceMouse tells every 8 to 16 ms; so long without a word it is gone."""


@dataclass(slots=True)
class _Mouse:
    info: DeviceInfo
    device: Any
    heard_s: float | None = None
    state: SpaceMouseState = field(default_factory=SpaceMouseState)


class SpaceMice:
    """See :class:`armui.gamepad.backend.DeviceBackend`."""

    package = "hidapi"

    def __init__(self) -> None:
        self.unusable: tuple[str, ...] = ()
        self._hid: Any = None
        self._mice: dict[bytes, _Mouse] = {}

    def open(self) -> None:
        """Load hidapi; on Linux with the kernel's own driver, which leaves the device to others."""
        if sys.platform == "linux":
            import hidraw as hid  # noqa: PLC0415 - an extra, loaded when it is wanted
        else:
            import hid  # noqa: PLC0415 - as above
        self._hid = hid

    def look(self) -> None:
        """Open what came; what may not be opened is named."""
        unusable = []
        for each in (found for vendor in _VENDORS for found in self._hid.enumerate(vendor, 0)):
            path = each["path"]
            if path in self._mice or not _is_space_mouse(each):
                continue
            name = each.get("product_string") or "SpaceMouse"
            device = self._hid.device()
            try:
                device.open_path(path)
                device.set_nonblocking(True)
            except OSError:
                unusable.append(name)
                continue
            key = f"hid-{path.decode('utf-8', 'replace')}"
            info = DeviceInfo(key, name, DeviceKind.SPACE_MOUSE)
            self._mice[path] = _Mouse(info, device)
        self.unusable = tuple(unusable)

    def read(self, now_s: float) -> tuple[DeviceState, ...]:
        """The SpaceMice now."""
        states = []
        for path, mouse in list(self._mice.items()):
            try:
                _take_reports(mouse, now_s)
            except (OSError, ValueError):  # hidapi tells a device that is gone by either
                mouse.device.close()
                del self._mice[path]
                continue
            told_s = mouse.heard_s
            silent = mouse.state.displaced and told_s is not None and now_s - told_s > SILENT_S
            states.append(DeviceState(mouse.info, mouse.state.axes(), mouse.state.buttons, silent))
        return tuple(states)

    def close(self) -> None:
        """Let the devices go."""
        for mouse in self._mice.values():
            mouse.device.close()
        self._mice.clear()


def _take_reports(mouse: _Mouse, now_s: float) -> None:
    for _ in range(_MOST_REPORTS):
        report = mouse.device.read(_REPORT_BYTES)
        if not report:
            return
        mouse.state = after(mouse.state, bytes(report))
        mouse.heard_s = now_s


def _is_space_mouse(found: dict[str, Any]) -> bool:
    page, usage = found.get("usage_page", 0), found.get("usage", 0)
    if page:
        return bool(page == _GENERIC_DESKTOP and usage == _MULTI_AXIS)
    # where hidapi does not tell what a device is for
    return found["vendor_id"] == _VENDORS[0] or found["product_id"] in _OLD_PRODUCTS
