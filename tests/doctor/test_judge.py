"""From facts to findings: which, how grave, and with which command to copy."""

from __future__ import annotations

from dataclasses import replace

import pytest

from armui.doctor.facts import (
    ArmFacts,
    CanFacts,
    DeviceFacts,
    Diagnosis,
    DiagnosisLevel,
    Facts,
    HeardFacts,
    LimitFacts,
    LinkFacts,
    OtherFrames,
    PackageFacts,
    ProgramFacts,
    ScreenFacts,
    SerialPortFacts,
    UsbAdapterFacts,
)
from armui.doctor.judge import an_arm_answers, judge, judge_can, judge_program, judge_screen
from armui.doctor.judge_heard import judge_heard
from armui.doctor.report import Words
from armui.system.plain_words import LANGUAGES, translation

WORDS = [Words(translation(language)) for language in LANGUAGES]
UBUNTU = ("ubuntu", "debian")
ARM = ArmFacts(
    generation=2, reason="", firmware="S-V1.8-9", status_code=0, status_word="Normal",
    mode_word="MOVE J", joints_deg=(0.0,) * 6, pose=(56.128, 0.0, 213.266, 0.0, 85.0, 0.0),
)  # fmt: skip
GOOD_LINK = LinkFacts("can0", "can", True, "ERROR-ACTIVE", 1_000_000, restart_ms=100)


def program(*packages: PackageFacts, suffices: bool = True) -> ProgramFacts:
    return ProgramFacts("0.1.0", "3.11.9", suffices, "/usr/bin/python3", "Linux", UBUNTU, packages)


def on_can0(arm: ArmFacts | None = ARM, **more) -> HeardFacts:
    return HeardFacts("socketcan", "can0", 2.0, more.pop("frames", 6_000), arm=arm, **more)


def codes(findings: list[Diagnosis]) -> list[str]:
    for words in WORDS:
        assert all(words.text(each) for each in findings), "each has its figures"
    return [each.code for each in findings]


def grave(findings: list[Diagnosis]) -> dict[str, Diagnosis]:
    """What is not in order, by code."""
    bad = [each for each in findings if each.severity is not DiagnosisLevel.OK]
    return dict(zip(codes(bad), bad, strict=True))


def changed(**more) -> HeardFacts:
    facts = {field: getattr(ARM, field) for field in ARM.__dataclass_fields__}
    return on_can0(ArmFacts(**{**facts, **more}))


# --- this computer ----------------------------------------------------------------------------


def test_a_package_that_is_missing_names_the_command_of_this_python():
    found = judge_program(program(PackageFacts("cantools", ">=40", None, False)))
    assert grave(found)["package_missing"].commands == (
        '/usr/bin/python3 -m pip install "cantools>=40"',
    )
    assert "packages" not in codes(found)


def test_in_a_packaged_program_nobody_is_sent_to_pip():
    facts = program(PackageFacts("cantools", ">=40", None, False))
    found = grave(judge_program(replace(facts, packaged=True)))["package_lost"]
    assert found.commands == ()
    assert found.params["package"] == "cantools"


def test_packages_of_an_extra_are_only_noted():
    found = judge_program(
        program(
            PackageFacts("numpy", ">=1.26", "2.4", True),
            PackageFacts("gs-usb", ">=0.3", None, False, "adapters"),
        )
    )
    assert [each.severity for each in found] == [
        DiagnosisLevel.OK,
        DiagnosisLevel.NOTE,
        DiagnosisLevel.OK,
    ]


def test_another_version_than_wanted_is_a_fault():
    found = judge_program(program(PackageFacts("pyvista", ">=0.44", "0.30", False)))
    assert grave(found)["package_other"].params["installed"] == "0.30"


def test_an_old_python_is_a_fault():
    assert (
        grave(judge_program(program(suffices=False)))["python_old"].severity is DiagnosisLevel.FAULT
    )


@pytest.mark.parametrize(
    ("families", "commands"),
    [
        (UBUNTU, ("sudo apt install rtkit",)),
        (("fedora",), ("sudo dnf install rtkit",)),
        (("opensuse",), ("sudo zypper install rtkit",)),
        ((), ()),
    ],
)
def test_a_system_that_lets_the_program_go_first_and_one_that_does_not(families, commands):
    facts = ProgramFacts("0.1.0", "3.11.9", True, "/usr/bin/python3", "Linux", families)
    assert "priority" not in codes(judge_program(facts)), "it was not tried"
    granted = replace(facts, goes_first=True)
    assert codes(judge_program(granted))[-1] == "priority"
    refused = replace(facts, goes_first=False, priority_reason="not at the seat")
    found = grave(judge_program(refused))["priority_refused"]
    assert found.severity is DiagnosisLevel.NOTE
    assert found.params["text"] == "not at the seat"
    assert found.commands == commands


def test_libraries_that_qt_wants_are_installed_by_their_package():
    facts = ScreenFacts(
        True, "6.11.3", None, "xcb", ("libxcb-cursor.so.0", "libEGL.so.1"), opengl="NVIDIA"
    )
    found = grave(judge_screen(facts, program()))
    assert found["libraries_missing"].commands == ("sudo apt install libxcb-cursor0 libegl1",)
    assert found["qt_platform_failed"].severity is DiagnosisLevel.FAULT


def test_fedora_installs_libraries_by_their_files():
    facts = ScreenFacts(True, "6", "xcb", missing_libraries=("libEGL.so.1",), opengl="NVIDIA")
    here = ProgramFacts("0", "3.11", True, "python3", "Linux", ("fedora",))
    found = grave(judge_screen(facts, here))
    assert found["libraries_missing"].commands == ("sudo dnf install 'libEGL.so.1()(64bit)'",)


@pytest.mark.parametrize(
    ("facts", "expected"),
    [
        (ScreenFacts(True, "6", "xcb", opengl="NVIDIA RTX, 4.6"), []),
        (ScreenFacts(True, "6", "xcb", opengl="llvmpipe (LLVM 15)"), ["opengl_software"]),
        (ScreenFacts(True, None, None, "no PySide6", opengl="NVIDIA"), ["qt_not_loaded"]),
        (ScreenFacts(False, "6", "offscreen", opengl="NVIDIA"), ["no_display"]),
        (ScreenFacts(True, "6", "xcb", opengl_error="no EGL"), ["opengl_failed"]),
    ],
)
def test_the_screen(facts, expected):
    assert list(grave(judge_screen(facts, program()))) == expected


# --- CAN devices ------------------------------------------------------------------------------

UP = "sudo ip link set can0 up type can bitrate 1000000 restart-ms 100"


@pytest.mark.parametrize(
    ("link", "code", "command"),
    [
        (LinkFacts("can0", "can", False), "link_down", UP),
        (LinkFacts("vcan0", "vcan", False), "link_down", "sudo ip link set vcan0 up"),
        (LinkFacts("can0", "can", True, "BUS-OFF", 1_000_000, restart_ms=1), "bus_off",
         "sudo ip link set can0 type can restart"),
        (LinkFacts("can0", "can", True, "ERROR-PASSIVE", 1_000_000, restart_ms=1),
         "error_passive", "sudo ip link set can0 down"),
        (LinkFacts("can0", "can", True, "ERROR-ACTIVE", 1_000_000, restart_ms=1, tx_errors=128),
         "error_passive", "sudo ip link set can0 down"),
        (LinkFacts("can0", "can", True, "ERROR-ACTIVE", 250_000, restart_ms=1), "bitrate_odd",
         "sudo ip link set can0 down"),
        (LinkFacts("can0", "can", True, "ERROR-ACTIVE", 500_000, restart_ms=1), "bitrate_old",
         "sudo ip link set can0 down"),
        (LinkFacts("can0", "can", True, "ERROR-ACTIVE", 1_000_000, True, 1),
         "link_listen_only", "sudo ip link set can0 down"),
        (LinkFacts("can0", "can", True, "ERROR-ACTIVE", 1_000_000), "no_restart",
         "sudo ip link set can0 down"),
    ],
)  # fmt: skip
def test_an_interface_of_linux(link, code, command):
    found = grave(judge_can(CanFacts(links=(link,))))
    assert list(found) == [code]
    assert found[code].commands[0] == command


def test_counters_that_only_warn_and_frames_dropped():
    link = LinkFacts(
        "can0", "can", True, "ERROR-WARNING", 1_000_000, restart_ms=1, rx_errors=100, dropped=7
    )
    found = grave(judge_can(CanFacts(links=(link,))))
    assert list(found) == ["error_warning", "kernel_dropped"]


def test_a_good_interface_is_no_complaint():
    found = judge_can(CanFacts(links=(GOOD_LINK,), devices=(DeviceFacts("socketcan", "can0"),)))
    assert codes(found) == ["link"]
    assert found[0].severity is DiagnosisLevel.OK


def test_an_adapter_without_its_driver():
    adapter = UsbAdapterFacts("1d50:606f", "candleLight USB to CAN adapter", "0031")
    found = grave(judge_can(CanFacts(usb=(adapter,))))
    assert found["no_driver"].commands == ("sudo modprobe gs_usb",)


def test_a_serial_port_that_may_not_be_opened():
    port = SerialPortFacts("/dev/ttyACM0", False, "dialout")
    found = grave(judge_can(CanFacts(ports=(port,))))
    assert found["port_closed"].commands == ('sudo usermod -aG dialout "$USER"',)


def test_two_adapters_may_swap():
    links = tuple(
        LinkFacts(n, "can", True, "ERROR-ACTIVE", 1_000_000, restart_ms=1, serial=s)
        for n, s in (("can0", "A1"), ("can1", "B2"))
    )
    found = grave(judge_can(CanFacts(links=links)))["several"]
    assert "can0 (A1), can1 (B2)" in found.params["names"]
    assert 'ATTRS{serial}=="B2"' in found.commands[1]


def test_nothing_at_all():
    assert codes(judge(Facts(can=CanFacts()))) == ["no_devices", "no_device_to_listen"]


# --- the bus and the arm ----------------------------------------------------------------------


def test_an_arm_in_order():
    found = judge_heard(on_can0())
    assert grave(found) == {}
    assert codes(found) == ["arm", "firmware"]


@pytest.mark.parametrize("code", ["bus_busy", "bus_gone", "bus_driver_missing", "bus_failed"])
def test_a_device_that_cannot_be_opened(code):
    heard = HeardFacts("socketcan", "can0", problem=code, problem_text="why")
    assert list(grave(judge_heard(heard))) == [code]


def test_a_back_end_without_its_package_and_an_adapter_without_permission():
    heard = HeardFacts("slcan", "x", problem="bus_backend_missing", package="pyserial")
    assert judge_heard(heard)[0].commands == ("python -m pip install pyserial",)
    packaged = replace(heard, problem="bus_backend_not_packed")
    (finding,) = judge_heard(packaged)
    assert (finding.code, finding.commands) == ("bus_backend_not_packed", ())
    closed = HeardFacts("gs_usb", "0", problem="bus_permission")
    assert "udev" in judge_heard(closed)[0].commands[0]


def test_silence_foreign_frames_and_error_frames():
    assert list(grave(judge_heard(on_can0(None, frames=0)))) == ["nothing_heard"]
    foreign = grave(judge_heard(on_can0(None, frames=9, unknown_ids=(0x100, 0x200))))
    assert foreign["no_arm"].params["ids"] == "0x100, 0x200"
    errors = grave(judge_heard(on_can0(None, frames=0, error_frames=50, bus_off=True)))
    assert list(errors) == ["heard_bus_off", "error_frames", "nothing_heard"]
    assert errors["error_frames"].severity is DiagnosisLevel.FAULT


def test_an_adapter_that_sends_and_hears_nothing_is_deaf():
    (silent,) = judge_heard(on_can0(None, frames=0))
    assert silent.commands[-1] == "armui doctor --ask --interface socketcan --channel can0"
    assert list(grave(judge_heard(on_can0(None, frames=0, asked=True)))) == ["bus_deaf"]
    errors = grave(judge_heard(on_can0(None, frames=0, asked=True, error_frames=2)))
    assert list(errors) == ["error_frames", "nothing_heard"]
    nowhere = HeardFacts("udp_multicast", "239.74.163.2", 2.0, asked=True)
    assert list(grave(judge_heard(nowhere))) == ["nothing_heard"]
    told_by_window = HeardFacts("gs_usb", "0", problem="bus_deaf")
    assert list(grave(judge_heard(told_by_window))) == ["bus_deaf"]


def test_an_interface_that_has_sent_and_received_nothing_is_deaf():
    deaf = replace(GOOD_LINK, sent=12)
    (found,) = [each for each in judge_can(CanFacts(links=(deaf,))) if each.code == "link_deaf"]
    assert found.params["sent"] == "12"
    others = (
        replace(deaf, received=1),
        replace(deaf, sent=2),
        replace(deaf, rx_errors=1),
        replace(deaf, kind="vcan"),
    )
    for other in others:
        assert "link_deaf" not in [each.code for each in judge_can(CanFacts(links=(other,)))]


# Each failure of the field that can be seen from outside.


@pytest.mark.parametrize(
    "heard",
    [
        on_can0(None, shifted_feedback=tuple(range(0x3A1, 0x3A9))),
        on_can0(None, leader=True, other_hosts=(OtherFrames(0x155, 400, 200.0),)),
    ],
)
def test_an_arm_that_has_become_a_teaching_input(heard):
    found = grave(judge_heard(heard))
    assert list(found) == ["teaching_input"]
    assert found["teaching_input"].commands == ("cansend can0 470#FC00000000000000",)
    assert not an_arm_answers(Facts(heard=(heard,)))


def test_limits_damaged_in_the_flash():
    # -0.1 deg for both limits; 0xFFFF in units of 0.01 rad/s2 is 37,548 deg/s2
    limits = (
        LimitFacts(1, -150.0, 150.0, 171.0, 286.0),
        LimitFacts(2, -0.1, -0.1, 171.0, 286.0),
        LimitFacts(3, None, None, None, 37_548.0),
    )
    found = grave(judge_heard(changed(limits=limits)))
    assert found["limits_damaged"].params["joints"] == "2, 3"
    assert found["limits_damaged"].commands == ("cansend can0 477#0002000000000000",)


def test_feedback_that_is_all_zero():
    found = grave(judge_heard(changed(pose=(0.0,) * 6, firmware="S-V1.5-8")))
    assert found["feedback_zero"].commands[0].startswith("armui doctor --ask")
    asked = grave(judge_heard(changed(pose=(0.0,) * 6, teaching=(100.0, 70.0, 255.0))))
    # 100 % = 0x64, 70 mm = 0x46, friction level 1
    assert asked["feedback_zero"].commands == ("cansend can0 47D#6446010000000000",)


def test_angles_of_the_end_near_their_edge():
    assert "euler_edge" in grave(judge_heard(changed(pose=(0, 0, 300.0, 0, -89.7, 0))))


@pytest.mark.parametrize(
    ("firmware", "expected"),
    [
        ("S-V1.8-9", []),
        ("S-V1.9-0", []),
        ("S-V1.8-6", ["firmware_old", "reference_lost"]),
        ("S-V1.5-8", ["firmware_old"]),
        (None, ["firmware_unknown"]),
    ],
)
def test_what_is_known_of_a_firmware(firmware, expected):
    assert list(grave(judge_heard(changed(firmware=firmware)))) == expected


@pytest.mark.parametrize(
    ("more", "code"),
    [
        ({"status_code": 1, "status_word": "Emergency stop"}, "stopped"),
        ({"status_code": 7, "status_word": "Collision"}, "status"),
        ({"status_code": None}, "status_silent"),
        ({"mode_word": "MOVE M"}, "unusual_mode"),
        ({"unreachable": (4,)}, "joints_unreachable"),
        ({"beyond_limit": (2,)}, "joints_beyond_limit"),
        ({"driver_faults": ((3, "undervoltage"),)}, "driver_faults"),
        ({"lowest_voltage": 19.5}, "voltage_low"),
        ({"feedback_offset": 0x10}, "offset"),
        ({"teaching_input": True}, "teaching_input"),
    ],
)
def test_what_the_arm_says_of_itself(more, code):
    assert list(grave(judge_heard(changed(**more)))) == [code]


def test_another_host_and_a_second_arm():
    found = grave(
        judge_heard(on_can0(other_hosts=(OtherFrames(0x151, 200, 100.0),), other_offsets=(0x20,)))
    )
    assert list(found) == ["second_arm", "other_host"]
    assert "0x151 (100/s)" in found["other_host"].params["frames"]


def test_a_remedy_for_any_back_end():
    heard = HeardFacts("gs_usb", "0", 2.0, 9, shifted_feedback=(0x3A1,))
    (command,) = judge_heard(heard)[0].commands
    assert "can.Bus(interface='gs_usb', channel='0', bitrate=1000000)" in command
    assert "bytes.fromhex('FC00000000000000')" in command


@pytest.mark.parametrize(
    ("heard", "answers"),
    [
        (on_can0(), True),
        (on_can0(asked=True, answered=True), True),
        (on_can0(asked=True, answered=False), False),
        (on_can0(None), False),
    ],
)
def test_the_exit_code_is_about_an_arm_alone(heard, answers):
    assert an_arm_answers(Facts(heard=(heard,))) is answers
    assert ("no_answer" in codes(judge_heard(heard))) is (heard.asked and not heard.answered)
