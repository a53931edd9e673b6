"""What the probes make of what this computer shows."""

from __future__ import annotations

import json
import sys

import pytest

from armui.doctor.facts import CanFacts, LinkFacts
from armui.doctor.judge import judge_can
from armui.doctor.probes import program
from armui.doctor.probes.can_devices import links_of, shared_controllers, usb_adapters
from armui.doctor.probes.program import probe_program, satisfies
from armui.doctor.probes.screen import missing_libraries, probe_screen
from armui.doctor.process import adapter_trouble

# ip -details -statistics -json link show, iproute2 6.1, abridged
IP = [
    {"ifname": "lo", "flags": ["LOOPBACK", "UP"], "link_type": "loopback"},
    {
        "ifname": "can0", "flags": ["NOARP", "UP", "LOWER_UP", "ECHO"], "link_type": "can",
        "operstate": "UP",
        "linkinfo": {
            "info_kind": "can",
            "info_data": {
                "ctrlmode": ["LISTEN-ONLY"], "state": "ERROR-PASSIVE",
                "berr_counter": {"tx": 128, "rx": 3}, "restart_ms": 100,
                "bittiming": {"bitrate": 500000, "sample_point": "0.875"}, "clock": 48000000,
            },
            "info_xstats": {"restarts": 0, "bus_error": 0, "bus_off": 2},
        },
        "stats64": {"rx": {"packets": 10, "dropped": 4}, "tx": {"packets": 0, "dropped": 0}},
    },
    {
        "ifname": "can1", "flags": ["NOARP", "ECHO"], "link_type": "can", "operstate": "DOWN",
        "linkinfo": {"info_kind": "can", "info_data": {"state": "STOPPED", "restart_ms": 0}},
    },
    {
        "ifname": "vcan0", "flags": ["NOARP", "UP"], "link_type": "can",
        "linkinfo": {"info_kind": "vcan"},
    },
]  # fmt: skip


def test_interfaces_of_linux():
    can0, can1, vcan0 = links_of(json.dumps(IP), {"can0": "0031002F"})
    assert (can0.name, can0.kind, can0.up, can0.state) == ("can0", "can", True, "ERROR-PASSIVE")
    assert (can0.bitrate, can0.listen_only, can0.restart_ms) == (500_000, True, 100)
    assert (can0.tx_errors, can0.rx_errors, can0.bus_offs, can0.dropped) == (128, 3, 2, 4)
    assert (can0.sent, can0.received) == (0, 10)
    assert can0.serial == "0031002F"
    assert (can1.up, can1.bitrate, can1.tx_errors) == (False, None, None)
    assert (vcan0.kind, vcan0.up, vcan0.bitrate) == ("vcan", True, None)


@pytest.mark.parametrize("text", ["", "no json", "[]"])
def test_an_ip_that_tells_nothing(text):
    assert links_of(text, {}) == []


def test_adapters_on_the_usb(tmp_path):
    def device(name: str, **files: str):
        folder = tmp_path / name
        folder.mkdir()
        for each, text in files.items():
            (folder / each).write_text(text + "\n")
        return folder

    device("1-1", idVendor="1d50", idProduct="606f", product="canable2", serial="0031")
    served = device("1-2", idVendor="1d50", idProduct="606f")
    (served / "1-2:1.0" / "net" / "can0").mkdir(parents=True)
    device("1-3", idVendor="046d", idProduct="c52b", product="a mouse")
    first, second = usb_adapters(tmp_path)
    assert (first.name, first.serial, first.links) == ("canable2", "0031", ())
    assert (second.serial, second.links) == (None, ("can0",))


def test_adapters_on_one_usb_controller(tmp_path):
    """As sysfs has it: links into a tree of devices, a controller above its two root hubs."""
    usb, tty = tmp_path / "bus/usb/devices", tmp_path / "class/tty"
    usb.mkdir(parents=True)
    tty.mkdir(parents=True)
    first = tmp_path / "devices/pci0000:00/0000:00:14.0"
    other = tmp_path / "devices/pci0000:00/0000:00:1d.0"

    def adapter(place, link="", usb_id="1d50:606f"):
        place.mkdir(parents=True)
        for name, text in zip(("idVendor", "idProduct"), usb_id.split(":"), strict=True):
            (place / name).write_text(text + "\n")
        if link:
            (place / f"{place.name}:1.0/net" / link).mkdir(parents=True)
        (usb / place.name).symlink_to(place)

    def port(place, name):
        place.mkdir(parents=True)
        (tty / name).mkdir()
        (tty / name / "device").symlink_to(place)

    adapter(first / "usb1/1-2", "can0")
    adapter(other / "usb3/3-1", "can2")
    adapter(first / "usb1/1-4", usb_id="046d:c52b")  # a mouse
    port(tmp_path / "devices/platform/serial8250", "ttyS0")
    assert shared_controllers(usb, tty) == ()
    adapter(first / "usb2/2-1/2-1.3", "can1")  # behind a hub, on the controller's other bus
    port(first / "usb1/1-3/1-3:1.0", "ttyACM0")
    names = ("can0", "can1", "ttyACM0")
    assert shared_controllers(usb, tty) == (("0000:00:14.0", names),)
    facts = CanFacts(shared=shared_controllers(usb, tty))
    (shared,) = [each for each in judge_can(facts) if each.code == "shared"]
    assert shared.params == {"names": "can0, can1, ttyACM0", "controller": "0000:00:14.0"}
    assert shared_controllers(tmp_path / "none", tmp_path / "none") == ()


def test_the_connection_dialog_is_told_of_one_controller_after_what_is_graver(monkeypatch):
    shared = (("0000:00:14.0", ("can0", "can1")),)
    facts = CanFacts((LinkFacts("can0", "can", False),), shared=shared)
    monkeypatch.setattr("armui.doctor.process.probe_adapters", lambda: facts)
    assert [each.code for each in adapter_trouble()] == ["link_down", "shared"]


@pytest.mark.parametrize(
    ("installed", "wanted", "does"),
    [
        ("2.4.1", ">=1.26", True),
        ("1.25", ">=1.26", False),
        ("6.11.1", ">=6.8,!=6.11.0,!=6.11.1,!=6.12.0", False),
        ("6.11.3", ">=6.8,!=6.11.0,!=6.11.1,!=6.12.0", True),
        ("4.5", ">=4.5.0", True),
        ("45.1.0+local.7", ">=40", True),
        ("1.4.9", "~=1.4", True),
        ("2.0", "~=1.4", False),
        ("3.0", "<3", False),
        ("anything", "", True),
    ],
)
def test_versions(installed, wanted, does):
    assert satisfies(installed, wanted) is does


def test_this_python_and_its_packages():
    facts = probe_program()
    assert facts.executable == sys.executable
    assert facts.python_suffices
    by_name = {each.name.lower(): each for each in facts.packages}
    assert by_name["numpy"].satisfied
    assert by_name["pyside6-essentials"].installed is not None
    assert by_name["gs-usb"].extra == "adapters"
    assert ("jeepney" in by_name) == (sys.platform == "linux")
    assert facts.goes_first == (not facts.priority_reason)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows finds libraries in another way")
def test_system_libraries_that_qt_wants_and_that_are_not_there(tmp_path, monkeypatch):
    ldd = tmp_path / "ldd"
    ldd.write_text(
        "#!/bin/sh\necho '\tlibxcb-cursor.so.0 => not found'\n"
        "echo '\tlibc.so.6 => /lib/libc.so.6 (0x1)'\necho '\tlibEGL.so.1 => not found'\n"
    )
    ldd.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    assert missing_libraries() == ["libxcb-cursor.so.0", "libEGL.so.1"]


@pytest.mark.timeout(120)
def test_this_screen():
    """Whatever runs the tests has Qt, and draws off screen."""
    facts = probe_screen()
    assert facts.qt is not None
    assert facts.platform == "offscreen"
    assert facts.has_display
    assert facts.opengl is not None, facts.opengl_error


@pytest.mark.parametrize(("system", "wanted"), [("linux", "jeepney"), ("win32", "libusb-package")])
def test_what_is_wanted_on_another_system_is_not_missed_on_this_one(monkeypatch, system, wanted):
    requirements = ['jeepney; sys_platform == "linux"', 'libusb-package; sys_platform != "linux"']
    monkeypatch.setattr(program, "_requirements", lambda: requirements)
    monkeypatch.setattr(sys, "platform", system)
    of_this_one = filter(program._is_of_this_system, program._requirements())
    assert [each.split(";")[0] for each in of_this_one] == [wanted]
