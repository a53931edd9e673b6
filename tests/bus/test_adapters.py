import errno
import socket
import sys
from types import ModuleType

import can
import pytest

from armui.arm.device import Device
from armui.bus.adapters import (
    BUS_BACKEND_MISSING,
    BUS_BUSY,
    BUS_GONE,
    BUS_LIBUSB_MISSING,
    explain,
    find_devices,
    open_bus,
)

CAN0 = Device("socketcan", "can0", None)


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (OSError(errno.ENODEV, "No such device"), "bus_gone"),
        (OSError(errno.ENOENT, "No such file or directory"), "bus_gone"),
        (OSError(errno.EBUSY, "Device or resource busy"), "bus_busy"),
        (OSError(errno.ENETDOWN, "Network is down"), "bus_down"),
        (OSError(errno.EACCES, "Permission denied"), "bus_permission"),
        (OSError(errno.EPERM, "Operation not permitted"), "bus_permission"),
        (OSError(errno.EAFNOSUPPORT, "Address family not supported"), "bus_driver_missing"),
        (can.CanOperationError("x", error_code=errno.ENETDOWN), "bus_down"),
        (can.CanInitializationError("could not open port: Access is denied."), "bus_permission"),
        (can.CanInitializationError("The PCAN channel is already in use"), "bus_busy"),
        (OSError("pcanbasic library not found."), "bus_driver_missing"),
        (can.CanInterfaceNotImplementedError("no such interface"), "bus_backend_missing"),
        (ModuleNotFoundError("No module named 'usb'"), "bus_backend_missing"),
        (ValueError("bitrate must be one of …"), "bus_bad_argument"),
        (RuntimeError("something else"), "bus_failed"),
        (RuntimeError(), "bus_failed"),
    ],
)
def test_what_goes_wrong_with_a_device_is_told_apart(error, code):
    refusal = explain(CAN0, error)
    assert refusal.code == code
    assert refusal.params["device"] == "socketcan can0"


def test_the_reason_is_found_behind_the_exception_a_backend_wraps_it_in():
    wrapper = can.CanInitializationError("could not open")
    wrapper.__cause__ = OSError(errno.EBUSY, "busy")
    assert explain(CAN0, wrapper).reason == BUS_BUSY


def test_a_missing_backend_names_the_package_to_install():
    error = can.CanInterfaceNotImplementedError("no serial")
    assert explain(Device("slcan", "/dev/ttyACM0"), error).params["package"] == "pyserial"


class NoBackendError(ValueError):
    """As of pyusb, where no libusb is found: on Windows, and in a bare Debian."""


def test_a_missing_libusb_is_no_bad_argument():
    error = NoBackendError("No backend available")
    refusal = explain(Device("gs_usb", 0), error)
    assert refusal.reason == BUS_LIBUSB_MISSING
    wrapper = can.CanInitializationError("could not open")
    wrapper.__cause__ = error
    assert explain(Device("gs_usb", 0), wrapper).reason == BUS_LIBUSB_MISSING


@pytest.mark.parametrize("is_opened", [True, False], ids=["opened", "searched"])
def test_the_libusb_of_a_package_is_there_before_pyusb_looks_for_one(monkeypatch, is_opened):
    done = []
    package = ModuleType("libusb_package")
    package.__dict__["get_libusb1_backend"] = lambda: done.append("offered")
    monkeypatch.setitem(sys.modules, "libusb_package", package)

    def asked(*_args, **_options):
        done.append("asked")
        return []

    monkeypatch.setattr(can, "detect_available_configs", asked)
    monkeypatch.setattr(can, "Bus", asked)
    if is_opened:
        open_bus(Device("gs_usb", 0))
    else:
        find_devices()
    assert done[:2] == ["offered", "asked"]
    assert done.count("offered") == 1


def test_the_search_is_quiet_and_survives_a_backend_that_fails(monkeypatch, capfd):
    asked = []

    def detect(interfaces, timeout):
        asked.extend(interfaces)
        if interfaces == ["pcan"]:
            raise OSError("driver in pieces")
        if interfaces == ["socketcan"]:
            return [{"interface": "socketcan", "channel": "can0"}]
        if interfaces == ["gs_usb"]:
            return [{"interface": "gs_usb", "channel": "candle", "bus": 1, "address": 4}]
        return []

    monkeypatch.setattr("can.detect_available_configs", detect)
    monkeypatch.setattr("armui.bus.adapters._serial_adapters", list)  # of this computer
    found = find_devices()
    assert [(device.interface, device.channel, device.bitrate) for device in found] == [
        ("gs_usb", "candle", 1_000_000),
        ("socketcan", "can0", None),
    ]
    assert found[0].options == (("address", 4), ("bus", 1))
    assert not {"virtual", "udp_multicast"} & set(asked)
    assert capfd.readouterr() == ("", "")


class Port:
    """A serial port as pyserial lists it."""

    def __init__(self, device, vid=None, serial_number=None):
        self.device = device
        self.vid = vid
        self.serial_number = serial_number


def test_a_serial_port_is_an_slcan_adapter_only_on_the_usb(monkeypatch):
    list_ports = pytest.importorskip("serial.tools.list_ports")
    ports = [Port("/dev/ttyS0"), Port("/dev/ttyACM0", 0x16D0, "208F3"), Port("COM5", 0x1A86, "")]
    monkeypatch.setattr(list_ports, "comports", lambda: ports)

    def detect(interfaces, timeout):
        assert interfaces != ["serial"], "it would list every port"
        found = [{"interface": "socketcan", "channel": "can0"}]
        return found if interfaces == ["socketcan"] else []

    monkeypatch.setattr("can.detect_available_configs", detect)
    assert find_devices() == [
        CAN0,
        Device("slcan", "/dev/ttyACM0", 1_000_000, serial="208F3"),
        Device("slcan", "COM5", 1_000_000),
    ]


def test_ports_that_cannot_be_listed_are_none(monkeypatch):
    list_ports = pytest.importorskip("serial.tools.list_ports")

    def in_pieces():
        raise OSError("registry in pieces")

    monkeypatch.setattr(list_ports, "comports", in_pieces)
    monkeypatch.setattr("can.detect_available_configs", lambda _interfaces, timeout: [])
    assert find_devices() == []


def test_the_real_search_prints_nothing(capfd):
    assert all(not device.simulated for device in find_devices())
    assert capfd.readouterr() == ("", "")


def test_a_device_that_is_not_there_cannot_be_opened():
    device = Device("slcan", "/dev/does-not-exist")
    with pytest.raises((can.CanError, OSError)) as failure:
        open_bus(device)
    assert explain(device, failure.value).reason in {
        BUS_GONE,
        BUS_BACKEND_MISSING,
    }


def test_the_kernel_keeps_as_few_frames_as_it_can(monkeypatch):
    options = []

    class Socket:
        def setsockopt(self, *option):
            options.append(option)

    class Bus:
        socket = Socket()

    monkeypatch.setattr(can, "Bus", lambda **_options: Bus())
    open_bus(CAN0)
    assert options == [(socket.SOL_SOCKET, socket.SO_SNDBUF, 0)]
