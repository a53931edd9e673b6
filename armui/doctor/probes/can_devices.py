"""Finds CAN interfaces, adapters on the USB, serial ports, and python-can's devices."""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from armui.doctor.facts import CanFacts, DeviceFacts, LinkFacts, SerialPortFacts, UsbAdapterFacts
from armui.system.files import read_file

_PATIENCE_S: Final = 5.0
_CAN_HARDWARE: Final = "280"
"""The value ARPHRD_CAN in /sys/class/net/*/type."""
_ADAPTER_IDS: Final = {
    "1d50:606f": "candleLight (gs_usb)",
    "1209:2323": "candleLight (gs_usb)",
    "1cd2:606f": "CES CANext FD (gs_usb)",
    "16d0:10b8": "ABE CANdebugger FD (gs_usb)",
    "16d0:0f30": "Xylanta SAINT3 (gs_usb)",
}
"""The adapters supported by Linux' gs_usb driver."""
_NET: Final = Path("/sys/class/net")
_USB: Final = Path("/sys/bus/usb/devices")
_DEV: Final = Path("/dev")
_ETC: Final = Path("/etc")
_USB_PORTS: Final = ("ttyACM", "ttyUSB")
_TTY: Final = Path("/sys/class/tty")
_KERNEL: Final = Path("/proc/sys/kernel/osrelease")
_KEPT: Final = (
    ("systemd/network", r"70-armui-([a-z][a-z0-9_]*)\.network"),
    ("systemd/system", r"armui-can-([a-z][a-z0-9_]*)\.service"),
    ("udev/rules.d", r"70-armui-(port-[A-Za-z0-9_-]+)\.rules"),
)
"""Folder and name of the files written by the helper
(`resources/packaging/linux/adapter_helper.py`).
"""


def probe_can() -> CanFacts:
    """Return the facts on CAN devices; takes up to some seconds."""
    error = ""
    devices: tuple[DeviceFacts, ...] = ()
    try:
        from armui.bus.adapters import find_devices  # noqa: PLC0415 - python-can may be missing

        devices = tuple(
            DeviceFacts(each.interface, str(each.channel), each.serial) for each in find_devices()
        )
    except Exception as caught:  # noqa: BLE001 - third-party drivers may raise anything
        error = str(caught) or type(caught).__name__
    kept = tuple(kept_names(_ETC))
    return replace(probe_adapters(), devices=devices, error=error, kept=kept)


def _is_linux() -> bool:
    return sys.platform == "linux"


def probe_adapters() -> CanFacts:
    """Return the operating system's facts on adapters, without any driver of python-can."""
    if not _is_linux():
        return CanFacts()
    return CanFacts(
        links=probe_links(),
        usb=tuple(usb_adapters(_USB)),
        ports=tuple(_serial_ports(_DEV)),
        shared=shared_controllers(_USB, _TTY),
        wsl=is_wsl(_KERNEL),
    )


def is_wsl(kernel: Path) -> bool:
    """Return whether Linux runs as a guest of Windows, by the name of its kernel."""
    return "microsoft" in _text(kernel).lower()


def kept_names(etc: Path) -> list[str]:
    """Return the names that the adapter's helper applies at every start, by its files."""
    found = set()
    for folder, pattern in _KEPT:
        for each in _folders(etc / folder):
            if match := re.fullmatch(pattern, each.name):
                found.add(match[1])
    return sorted(found)


def probe_links() -> tuple[LinkFacts, ...]:
    """Return the CAN interfaces of Linux; none on other systems."""
    if not _is_linux():
        return ()
    return tuple(links_of(_ip_json(), _serials(_NET)))


def links_of(text: str, serials: Mapping[str, str]) -> list[LinkFacts]:
    """Return the CAN interfaces in the output of ``ip -details -statistics -json link show``.

    Args:
        text: The output; any other text gives none.
        serials: Serial number of the adapter, by interface.
    """
    try:
        links = json.loads(text)
    except ValueError:
        return []
    return [_link(each, serials) for each in links if each.get("link_type") == "can"]


def _link(link: Mapping[str, Any], serials: Mapping[str, str]) -> LinkFacts:
    info = link.get("linkinfo", {})
    data = info.get("info_data", {})
    counters = data.get("berr_counter", {})
    name = str(link.get("ifname", ""))
    frames = link.get("stats64", link.get("stats", {}))
    received = frames.get("rx", {})
    return LinkFacts(
        name=name,
        kind=str(info.get("info_kind", "can")),
        up="UP" in link.get("flags", ()),
        state=str(data.get("state", "")),
        bitrate=data.get("bittiming", {}).get("bitrate"),
        listen_only="LISTEN-ONLY" in data.get("ctrlmode", ()),
        restart_ms=int(data.get("restart_ms", 0)),
        tx_errors=counters.get("tx"),
        rx_errors=counters.get("rx"),
        bus_offs=int(info.get("info_xstats", {}).get("bus_off", 0)),
        dropped=int(received.get("dropped", 0)),
        sent=int(frames.get("tx", {}).get("packets", 0)),
        received=int(received.get("packets", 0)),
        serial=serials.get(name),
    )


def _ip_json() -> str:
    ip = shutil.which("ip", path=os.environ.get("PATH", "") + ":/sbin:/usr/sbin")
    if ip is None:
        return ""
    try:
        done = subprocess.run(  # noqa: S603 - the system's ip, which only shows
            [ip, "-details", "-statistics", "-json", "link", "show"],
            capture_output=True,
            timeout=_PATIENCE_S,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.decode("utf-8", "replace")


def _serials(net: Path) -> dict[str, str]:
    serials = {}
    for link in _folders(net):
        if _text(link / "type") == _CAN_HARDWARE and (serial := _usb_serial(link / "device")):
            serials[link.name] = serial
    return serials


def _usb_serial(device: Path) -> str | None:
    """Return the serial number of the USB device of a link, which is some folders above it."""
    try:
        place = device.resolve(strict=True)
    except OSError:
        return None
    for folder in (place, *place.parents[:3]):
        if serial := _text(folder / "serial"):
            return serial
    return None


def shared_controllers(usb: Path, tty: Path) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the CAN adapters and serial ports that share a USB controller, by its address.

    Args:
        usb: The folder of USB devices.
        tty: The folder of serial ports; those of the USB may be slcan adapters.
    """
    found: dict[str, list[str]] = {}
    for folder in _folders(usb):
        if _usb_id(folder) in _ADAPTER_IDS:
            links = sorted(each.name for each in folder.glob("*/net/*"))
            found.setdefault(_controller(folder), []).append(" ".join(links) or folder.name)
    for port in _folders(tty):
        if port.name.startswith(_USB_PORTS):
            found.setdefault(_controller(port / "device"), []).append(port.name)
    return tuple((at, tuple(names)) for at, names in found.items() if at and len(names) > 1)


def _controller(device: Path) -> str:
    """Return the address of the controller above a USB device's root hub, or an empty text."""
    for folder in device.resolve().parents:
        if re.fullmatch(r"usb\d+", folder.name):
            return folder.parent.name
    return ""


def _usb_id(folder: Path) -> str:
    return f"{_text(folder / 'idVendor')}:{_text(folder / 'idProduct')}"


def usb_adapters(usb: Path) -> list[UsbAdapterFacts]:
    """Return the CAN adapters with a driver in Linux, from the folder of USB devices."""
    found = []
    for folder in _folders(usb):
        usb_id = _usb_id(folder)
        if usb_id in _ADAPTER_IDS:
            links = sorted(each.name for each in folder.glob("*/net/*"))
            name = _text(folder / "product") or _ADAPTER_IDS[usb_id]
            serial = _text(folder / "serial") or None
            found.append(UsbAdapterFacts(usb_id, name, serial, tuple(links)))
    return found


def _serial_ports(dev: Path) -> list[SerialPortFacts]:
    paths = sorted(each for name in _USB_PORTS for each in dev.glob(f"{name}*"))
    return [SerialPortFacts(str(each), _may_open(each), _group(each)) for each in paths]


def _may_open(path: Path) -> bool:
    return os.access(path, os.R_OK | os.W_OK)


def _group(path: Path) -> str:
    if sys.platform != "win32":  # Windows has no groups of files
        with contextlib.suppress(OSError, KeyError):
            return path.group()
    return ""


def _folders(path: Path) -> Iterable[Path]:
    try:
        return sorted(path.iterdir())
    except OSError:
        return ()


def _text(path: Path) -> str:
    try:
        return read_file(path).decode("utf-8", "replace").strip()
    except OSError:
        return ""
