"""Reads SpaceMice through hidapi: the device's own reports, with or without the maker's driver.

Report 1 carries the translation, report 2 the rotation, each as three signed numbers of 16 bits,
low byte first; newer devices put all six into report 1. Report 3 carries one bit for each button.
The device counts X to the right, Y towards the operator and Z downwards; here X leads away from the
operator, Y to the left and Z upwards, like the arm's own axes for a person behind it.
"""

from __future__ import annotations

import struct
import sys
from dataclasses import dataclass, field
from typing import Any, Final

from armui.gamepad.device_state import DeviceInfo, DeviceKind, DeviceState

_FULL: Final = 350.0
"""The device's value at the end of its travel."""
_TRANSLATION, _ROTATION, _BUTTONS = 1, 2, 3
_BOTH_BYTES: Final = 13
_HALF_BYTES: Final = 7
_MOST_BUTTONS: Final = 32

_VENDORS: Final = (0x256F, 0x046D)
"""The vendor numbers of 3Dconnexion; before 2013 its devices had Logitech's."""
_OLD_PRODUCTS: Final = frozenset(
    {0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625, 0xC626, 0xC627, 0xC628, 0xC629, 0xC62B}
)
_GENERIC_DESKTOP: Final = 1
_MULTI_AXIS: Final = 8
_REPORT_BYTES: Final = 64
_MOST_REPORTS: Final = 200
"""The most reports read at once: a flood must not occupy the thread."""
SILENT_S: Final = 0.5
"""Off its centre a SpaceMouse reports every 8 to 16 ms; after this silence it counts as gone."""


@dataclass(frozen=True, slots=True)
class SpaceMouseState:
    """The values reported last.

    Attributes:
        figures: X, Y, Z, RX, RY, RZ as the device counts them.
        buttons: The numbers of the pressed buttons, from 1.
    """

    figures: tuple[int, ...] = (0,) * 6
    buttons: frozenset[str] = frozenset()

    def axes(self) -> dict[str, float]:
        """Return the deflections by the arm's axes, −1 to 1."""
        x, y, z, rx, ry, rz = (max(-1.0, min(1.0, each / _FULL)) for each in self.figures)
        return {"x": -y, "y": -x, "z": -z, "rx": -ry, "ry": -rx, "rz": -rz}

    @property
    def displaced(self) -> bool:
        """True if the cap is off its centre, where the device reports all the time."""
        return any(self.figures)


def after(state: SpaceMouseState, report: bytes) -> SpaceMouseState:
    """Return the state after a report; an unknown or too short one changes nothing."""
    if not report:
        return state
    number, body = report[0], report[1:]
    if number == _TRANSLATION and len(report) >= _BOTH_BYTES:
        return SpaceMouseState(struct.unpack_from("<6h", body), state.buttons)
    if number in {_TRANSLATION, _ROTATION} and len(report) >= _HALF_BYTES:
        three = struct.unpack_from("<3h", body)
        first, second = state.figures[:3], state.figures[3:]
        six = (*three, *second) if number == _TRANSLATION else (*first, *three)
        return SpaceMouseState(six, state.buttons)
    if number == _BUTTONS and body:
        bits = int.from_bytes(body[:4], "little")
        down = frozenset(str(place + 1) for place in range(_MOST_BUTTONS) if bits >> place & 1)
        return SpaceMouseState(state.figures, down)
    return state


@dataclass(slots=True)
class _Mouse:
    info: DeviceInfo
    device: Any
    heard_s: float | None = None
    state: SpaceMouseState = field(default_factory=SpaceMouseState)


class SpaceMice:
    """Reads SpaceMice; see :class:`armui.gamepad.device_reader.DeviceBackend`."""

    package = "hidapi"

    def __init__(self) -> None:
        self.unusable: tuple[str, ...] = ()
        self._hid: Any = None
        self._mice: dict[bytes, _Mouse] = {}

    def open(self) -> None:
        """Load hidapi; on Linux with the kernel's driver, so that others can use the device."""
        if sys.platform == "linux":
            import hidraw as hid  # noqa: PLC0415 - an extra, loaded when it is wanted
        else:
            import hid  # noqa: PLC0415 - as above
        self._hid = hid

    def scan(self) -> None:
        """Open new devices; those that may not be opened are named in `unusable`."""
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
        """Return the present state of the SpaceMice."""
        states = []
        for path, mouse in list(self._mice.items()):
            try:
                _take_reports(mouse, now_s)
            except (OSError, ValueError):  # raised by hidapi when the device was unplugged
                mouse.device.close()
                del self._mice[path]
                continue
            told_s = mouse.heard_s
            silent = mouse.state.displaced and told_s is not None and now_s - told_s > SILENT_S
            states.append(DeviceState(mouse.info, mouse.state.axes(), mouse.state.buttons, silent))
        return tuple(states)

    def close(self) -> None:
        """Release the devices."""
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
    # hidapi on this system does not report what a device is for: decide by its maker and product
    return found["vendor_id"] == _VENDORS[0] or found["product_id"] in _OLD_PRODUCTS
