"""Finds the CAN devices of this computer, opens them, and explains why one can't be opened."""

from __future__ import annotations

import errno
import logging
import socket
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import Any, Final

import can

from armui.arm.device import DEFAULT_BITRATE, Device, bitrate_is_ours
from armui.arm.refusal import Reason, Refusal
from armui.bus.send_errors import causes
from armui.system.command_process import is_packaged
from armui.system.files import error_text

BUS_BACKEND_MISSING = Reason(
    "bus_backend_missing",
    "{device} needs a Python package that is not installed. Install it in a terminal: "
    "pip install {package}",
)
BUS_BACKEND_NOT_PACKED = Reason(
    "bus_backend_not_packed",
    "{device} needs the Python package {package}, which is no part of this installed program, and "
    "cannot be added to it. Use another adapter, or armui from its source with that package.",
)
BUS_BAD_ARGUMENT = Reason(
    "bus_bad_argument",
    "{device} does not accept these settings: {text}. Check interface, channel and bit rate.",
)
BUS_FAILED = Reason(
    "bus_failed",
    "{device} could not be opened: {text}. Check the device and its driver, then connect again.",
)
BUS_GONE = Reason(
    "bus_gone", "{device} is not there. Check that it is plugged in and its cable is sound."
)
BUS_BUSY = Reason(
    "bus_busy", "{device} is in use by another program. Close that program, then connect again."
)
BUS_DOWN = Reason(
    "bus_down",
    "{device} is switched off in the system. Switch it on in a terminal (with your "
    "interface's name for can0): sudo ip link set can0 up type can bitrate 1000000",
)
BUS_DRIVER_MISSING = Reason(
    "bus_driver_missing",
    "The driver for {device} ({interface}) is missing. Install the driver of the adapter's "
    "maker; for socketcan load the kernel's modules: sudo modprobe can_raw",
)
BUS_LIBUSB_MISSING = Reason(
    "bus_libusb_missing",
    "{device} needs the library libusb, which is not on this computer. Install it in a terminal: "
    "on Windows and macOS pip install libusb-package, "
    "on Debian and Ubuntu sudo apt install libusb-1.0-0",
)
SIMULATED_ARM_ENDED = Reason(
    "simulated_arm_ended",
    "The process of the simulated arm has ended. One that was connected is started anew by "
    "itself, as after a power cut; otherwise connect again.",
)
BUS_PERMISSION = Reason(
    "bus_permission",
    "You may not open {device}. On Linux add your account to the group dialout (serial "
    "adapters) or install the adapter's udev rule (USB adapters), then log in again.",
)


_SEARCH_S: Final = 5.0

_NOT_DEVICES: Final = frozenset({"virtual", "udp_multicast", "socketcand", "remote", "serial"})
"""Back-ends without hardware on this computer; they answer a search with made-up devices.

``serial`` is a format of python-can's own, which no adapter speaks. It answers with every serial
port, also those that a PC has built in.
"""

_PACKAGES: Final = {
    "gs_usb": "gs_usb",
    "slcan": "pyserial",
    "serial": "pyserial",
    "robotell": "pyserial",
    "canalystii": "canalystii",
    "cantact": "cantact",
    "candle": "python-can-candle",
    "udp_multicast": "msgpack",
}
"""The package on PyPI that a back-end needs beside python-can."""

_NO_LIBUSB: Final = "NoBackendError"
"""The exception's name in pyusb, a `ValueError`; pyusb itself need not be installed."""
_CODE_OF_ERRNO: Final = {
    errno.ENODEV: BUS_GONE,
    errno.ENXIO: BUS_GONE,
    errno.ENOENT: BUS_GONE,
    errno.EBUSY: BUS_BUSY,
    errno.EADDRINUSE: BUS_BUSY,
    errno.ENETDOWN: BUS_DOWN,
    errno.EAFNOSUPPORT: BUS_DRIVER_MISSING,
    errno.EACCES: BUS_PERMISSION,
    errno.EPERM: BUS_PERMISSION,
}

_CODE_OF_WORDS: Final = (
    (("library not found", "driver", "dll", "is not defined"), BUS_DRIVER_MISSING),
    (
        ("no such device", "could not find", "not found", "no device", "disconnected"),
        BUS_GONE,
    ),
    (("busy", "in use", "already open"), BUS_BUSY),
    (("permission", "access is denied", "access denied"), BUS_PERMISSION),
    (("network is down",), BUS_DOWN),
)
"""For back-ends that give the reason in words only. The last entry of the first line is the error
of python-can's back-ends when the maker's library is missing.
"""

_SERIAL_KEYS: Final = ("serial", "serial_number", "unique_hardware_id", "device_id", "hw_serial")


def interfaces() -> list[str]:
    """Return the back-ends python-can knows on this computer, its plug-ins included."""
    return sorted(can.VALID_INTERFACES)


def find_devices() -> list[Device]:
    """Search for devices with every back-end; takes up to some seconds.

    A back-end that is not installed, or fails while it looks, has no devices. Serial ports, which
    may or may not be adapters, come last.
    """
    found: list[Device] = []
    _offer_libusb()
    with _quiet():
        for interface in sorted(can.VALID_INTERFACES - _NOT_DEVICES):
            try:
                configs = can.detect_available_configs([interface], timeout=_SEARCH_S)
            except Exception:  # noqa: BLE001, S112 - third-party drivers may raise anything
                continue
            found += [_device(interface, config) for config in configs]
        found += _serial_adapters()
    return found


def _serial_adapters() -> list[Device]:
    """Return the serial ports on the USB: slcan adapters cannot be told from other ones."""
    try:
        from serial.tools.list_ports import comports  # noqa: PLC0415 - of the extra `adapters`

        ports = [port for port in comports() if port.vid is not None]
    except Exception:  # noqa: BLE001 - the list of ports may raise anything
        return []
    return [Device("slcan", port.device, serial=port.serial_number or None) for port in ports]


def open_bus(device: Device) -> can.BusABC:
    """Open a device.

    Raises:
        can.CanError, OSError, ValueError, ImportError: see :func:`explain`.
    """
    arguments: dict[str, Any] = {"interface": device.interface, "channel": device.channel}
    if device.bitrate is not None and bitrate_is_ours(device.interface):
        arguments["bitrate"] = device.bitrate
    if device.interface == "gs_usb":
        _offer_libusb()
    with _quiet():
        if device.interface == "udp_multicast":
            from armui.bus.multicast import MulticastBus  # noqa: PLC0415 - takes a while

            return MulticastBus(str(device.channel), **dict(device.options))
        bus = can.Bus(**arguments, **dict(device.options))
    _keep_kernel_queue_short(bus)
    return bus


def _offer_libusb() -> None:
    """Give pyusb the libusb of a Python package: Windows and macOS have none of their own.

    pyusb keeps the library it was given first.
    """
    with suppress(ImportError):
        import libusb_package  # noqa: PLC0415 - of the extra `adapters`, where it is needed

        libusb_package.get_libusb1_backend()


def _keep_kernel_queue_short(bus: can.BusABC) -> None:
    """Let socketcan hold as few frames of ours as the kernel allows.

    A frame in the kernel cannot be recalled, and is sent when a cable is plugged in again. With the
    smallest buffer the socket soon reports that it is full, and the rest waits in the outbox, where
    a stop, its age or the loss of the device drops it.
    """
    if device_socket := getattr(bus, "socket", None):
        with suppress(OSError, AttributeError):
            device_socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 0)


def explain(device: Device, error: BaseException) -> Refusal:
    """Return the reason why opening or using a device raised this exception."""
    params: dict[str, str] = {"device": device.name, "interface": device.interface}
    if device.simulated and isinstance(error, ConnectionError):
        return SIMULATED_ARM_ENDED()
    for cause in causes(error):
        code = _CODE_OF_ERRNO.get(_errno(cause) or 0)
        if code is not None:
            return Refusal(code, params)
        if type(cause).__name__ == _NO_LIBUSB:
            return BUS_LIBUSB_MISSING(**params)
        if isinstance(cause, can.CanInterfaceNotImplementedError | ImportError):
            package = _PACKAGES.get(device.interface, device.interface)
            missing = BUS_BACKEND_NOT_PACKED if is_packaged() else BUS_BACKEND_MISSING
            return missing(**params, package=package)
    text = error_text(error)
    lowered = text.lower()
    for words, code in _CODE_OF_WORDS:
        if any(word in lowered for word in words):
            return Refusal(code, {**params, "text": text})
    bad = isinstance(error, ValueError | TypeError)
    code = BUS_BAD_ARGUMENT if bad else BUS_FAILED
    return Refusal(code, {**params, "text": text})


def _errno(error: BaseException) -> int | None:
    if isinstance(error, OSError) and error.errno is not None:
        return error.errno
    code = getattr(error, "error_code", None)
    return code if isinstance(code, int) else None


def _device(interface: str, config: Mapping[str, Any]) -> Device:
    rest = {key: value for key, value in config.items() if key not in {"interface", "channel"}}
    serial = next((str(rest[key]) for key in _SERIAL_KEYS if rest.get(key)), None)
    channel = config.get("channel", 0)
    return Device(
        interface=interface,
        channel=channel if isinstance(channel, int) else str(channel),
        bitrate=DEFAULT_BITRATE if bitrate_is_ours(interface) else None,
        serial=serial,
        # socketcan's constructor needs nothing but the channel
        options=() if interface == "socketcan" else tuple(sorted(rest.items())),
    )


@contextmanager
def _quiet() -> Iterator[None]:
    """Suppress the back-ends' log messages on missing drivers if no logging is set up."""
    handler = logging.NullHandler()
    logging.getLogger().addHandler(handler)
    try:
        yield
    finally:
        logging.getLogger().removeHandler(handler)
