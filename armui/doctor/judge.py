"""From facts to findings. Pure: nothing here looks at anything, nor imports what may be missing."""

from __future__ import annotations

from typing import Final

from armui.doctor.facts import (
    ArmFacts,
    CanFacts,
    Diagnosis,
    DiagnosisLevel,
    Facts,
    HeardFacts,
    LimitFacts,
    LinkFacts,
    PackageFacts,
    ProgramFacts,
    ScreenFacts,
    Section,
    SerialPortFacts,
    UsbAdapterFacts,
)
from armui.protocol.firmware_version import (
    RECOMMENDED,
    FirmwareBug,
    FirmwareVersion,
    quirks_of,
)

# From what was heard on a bus: the failures that owners of real arms report.

_NORMAL: Final = 0
_EMERGENCY_STOP: Final = 1
_FASTEST_DEG_S: Final = 3600.0
_FASTEST_DEG_S2: Final = 20_000.0
"""Far above any joint of this arm; 0xFFFF read back is 37,548 °/s²."""
_TILT_DEG: Final = 89.0
_LOW_V: Final = 21.0
"""The supply has 24 V."""
_SILENT_BY_TEACHING_LEVEL: Final = 255
_UDEV_RULE: Final = (
    'echo \'SUBSYSTEM=="usb", ATTRS{idVendor}=="1d50", MODE="0666"\''
    " | sudo tee /etc/udev/rules.d/90-candlelight.rules"
)
_STROKE_LIMITS_MM: Final = (0, 70, 100)
_PORTS: Final = "/dev/"
_BITRATE_OF_SYSTEM: Final = ("udp_multicast", "virtual")
_USUAL_MODES: Final = ("MOVE P", "MOVE J", "MOVE L", "MOVE C")


def judge_heard(heard: HeardFacts) -> list[Diagnosis]:
    """What a device let hear, or why it did not."""
    name = _name(heard)
    base = {"device": name, "seconds": f"{heard.seconds:.1f}", "count": str(heard.frames)}
    if heard.problem:
        return [_not_opened(heard, base)]
    findings: list[Diagnosis] = []
    if heard.bus_off:
        remedies = (("reset", heard.channel),) if heard.interface == "socketcan" else ()
        fault = DiagnosisLevel.FAULT
        findings.append(_arm_finding("heard_bus_off", fault, base, _restart(heard), remedies))
    if heard.error_frames:
        params = {**base, "count": str(heard.error_frames)}
        level = DiagnosisLevel.WARNING if heard.arm is not None else DiagnosisLevel.FAULT
        findings.append(_arm_finding("error_frames", level, params))
    if heard.arm is not None:
        findings += judge_arm(heard.arm, heard)
        if heard.asked and not heard.answered:
            findings.append(_arm_finding("no_answer", DiagnosisLevel.FAULT, base))
    else:
        findings.append(_no_arm(heard, base))
    if heard.other_offsets:
        offsets = ", ".join(f"0x{each:02X}" for each in heard.other_offsets)
        findings.append(
            _arm_finding("second_arm", DiagnosisLevel.WARNING, {**base, "offsets": offsets})
        )
    if heard.other_hosts and not _is_leader(heard):
        frames = ", ".join(
            f"0x{each.arbitration_id:03X} ({each.rate_hz:.0f}/s)" for each in heard.other_hosts
        )
        findings.append(
            _arm_finding("other_host", DiagnosisLevel.WARNING, {**base, "frames": frames})
        )
    return findings


def _is_leader(heard: HeardFacts) -> bool:
    return heard.leader or bool(heard.shifted_feedback)


def _not_opened(heard: HeardFacts, base: dict[str, str]) -> Diagnosis:
    params = {**base, "text": heard.problem_text, "package": heard.package}
    commands: tuple[str, ...] = ()
    remedies: tuple[tuple[str, ...], ...] = ()
    if heard.problem == "bus_backend_missing":
        commands = (f"python -m pip install {heard.package}",)
    elif heard.interface == "socketcan" and heard.problem in {"bus_down", "bus_gone"}:
        commands = (f"sudo ip link set {heard.channel} up type can bitrate 1000000 restart-ms 100",)
        remedies = _switch_on(heard.channel) if heard.problem == "bus_down" else ()
    elif heard.problem == "bus_permission":
        commands = (_UDEV_RULE, "sudo udevadm control --reload && sudo udevadm trigger")
        port = heard.channel.removeprefix(_PORTS)
        remedies = (("remember", port),) if port != heard.channel else ()
    code = heard.problem if heard.problem in _PROBLEMS else "bus_failed"
    return _arm_finding(code, DiagnosisLevel.FAULT, params, commands, remedies)


_PROBLEMS: Final = (
    "bus_backend_missing",
    "bus_driver_missing",
    "bus_gone",
    "bus_busy",
    "bus_down",
    "bus_permission",
    "bus_bad_argument",
    "bus_failed",
)


def _no_arm(heard: HeardFacts, base: dict[str, str]) -> Diagnosis:
    if _is_leader(heard):
        ids = heard.shifted_feedback or tuple(each.arbitration_id for each in heard.other_hosts)
        params = {**base, "ids": _ids(ids)}
        return _arm_finding(
            "teaching_input", DiagnosisLevel.FAULT, params, _end_teaching_input(heard)
        )
    if heard.frames:
        params = {**base, "ids": _ids(heard.unknown_ids)}
        return _arm_finding("no_arm", DiagnosisLevel.FAULT, params)
    commands = (
        (f"ip -details -statistics link show {heard.channel}",)
        if heard.interface == "socketcan"
        else ()
    )
    return _arm_finding("nothing_heard", DiagnosisLevel.FAULT, base, commands)


def judge_arm(arm: ArmFacts, heard: HeardFacts) -> list[Diagnosis]:
    """An arm whose feedback is heard."""
    params = {
        "device": _name(heard),
        "generation": str(arm.generation),
        "reason": arm.reason,
        "rate": f"{arm.frames_per_s:.0f}",
        "offset": f"0x{arm.feedback_offset:02X}",
        "firmware": arm.firmware or "",
        "identity": f" ({', '.join(arm.identity)})" if arm.identity else "",
    }
    findings = [_arm_finding("arm", DiagnosisLevel.OK, params), *_firmware(arm, heard, params)]
    findings += _model(arm, params)
    if arm.feedback_offset:
        findings.append(_arm_finding("offset", DiagnosisLevel.NOTE, params))
    if arm.teaching_input:
        ids = {**params, "ids": "0x2A1"}
        findings.append(
            _arm_finding("teaching_input", DiagnosisLevel.WARNING, ids, _end_teaching_input(heard))
        )
    findings += _status(arm, params)
    findings += _drivers(arm, params)
    findings += _feedback(arm, heard, params)
    damaged = [str(each.joint) for each in arm.limits if _is_damaged(each)]
    if damaged:
        joints = {**params, "joints": ", ".join(damaged)}
        commands = _send(heard, 0x477, "0002000000000000")
        findings.append(_arm_finding("limits_damaged", DiagnosisLevel.FAULT, joints, commands))
    return findings


def _firmware(arm: ArmFacts, heard: HeardFacts, params: dict[str, str]) -> list[Diagnosis]:
    if arm.firmware is None:
        if arm.generation == 1:
            return []
        return [_arm_finding("firmware_unknown", DiagnosisLevel.NOTE, params, _ask(heard))]
    version = FirmwareVersion.parse(arm.firmware)
    findings = [_arm_finding("firmware", DiagnosisLevel.OK, params)]
    if version is not None and version < RECOMMENDED:
        findings.append(_arm_finding("firmware_old", DiagnosisLevel.NOTE, params))
    if version is not None and FirmwareBug.FEEDBACK_PARTS in quirks_of(version).bugs:
        findings.append(_arm_finding("reference_lost", DiagnosisLevel.NOTE, params))
    return findings


def _model(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    """Which arm of the family it is, by its own pose; a moving arm's fits none."""
    if not arm.models:
        return []
    names = {**params, "fits": ", ".join(arm.models)}
    if arm.chosen_model is not None and arm.chosen_model not in arm.models:
        names["chosen"] = arm.chosen_model
        return [_arm_finding("model_other", DiagnosisLevel.WARNING, names)]
    return [_arm_finding("model", DiagnosisLevel.OK, names)]


def _status(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    if arm.status_code is None:
        return [_arm_finding("status_silent", DiagnosisLevel.WARNING, params)]
    findings: list[Diagnosis] = []
    status = {**params, "status": f"0x{arm.status_code:02X} {arm.status_word}".strip()}
    if arm.status_code == _EMERGENCY_STOP:
        findings.append(_arm_finding("stopped", DiagnosisLevel.WARNING, status))
    elif arm.status_code != _NORMAL:
        findings.append(_arm_finding("status", DiagnosisLevel.WARNING, status))
    if arm.mode_word and arm.mode_word not in _USUAL_MODES:
        findings.append(
            _arm_finding("unusual_mode", DiagnosisLevel.WARNING, {**params, "mode": arm.mode_word})
        )
    return findings


def _drivers(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    findings: list[Diagnosis] = []
    if arm.unreachable:
        joints = {**params, "joints": ", ".join(map(str, arm.unreachable))}
        findings.append(_arm_finding("joints_unreachable", DiagnosisLevel.FAULT, joints))
    if arm.beyond_limit:
        joints = {**params, "joints": ", ".join(map(str, arm.beyond_limit))}
        findings.append(_arm_finding("joints_beyond_limit", DiagnosisLevel.WARNING, joints))
    if arm.driver_faults:
        faults = ", ".join(f"J{joint}: {fault}" for joint, fault in arm.driver_faults)
        findings.append(
            _arm_finding("driver_faults", DiagnosisLevel.FAULT, {**params, "faults": faults})
        )
    if arm.lowest_voltage is not None and 0 < arm.lowest_voltage < _LOW_V:
        voltage = {**params, "voltage": f"{arm.lowest_voltage:.1f}"}
        findings.append(_arm_finding("voltage_low", DiagnosisLevel.WARNING, voltage))
    return findings


def _feedback(arm: ArmFacts, heard: HeardFacts, params: dict[str, str]) -> list[Diagnosis]:
    """Angles and pose that cannot be true, or are easily misread."""
    findings: list[Diagnosis] = []
    if _all_zero(arm) or (arm.teaching is not None and _SILENT_BY_TEACHING_LEVEL in arm.teaching):
        commands = _mend_teaching(arm.teaching, heard) if arm.generation == 2 else ()
        findings.append(_arm_finding("feedback_zero", DiagnosisLevel.FAULT, params, commands))
    tilt = arm.pose[4]
    if tilt is not None and abs(tilt) > _TILT_DEG:
        findings.append(
            _arm_finding("euler_edge", DiagnosisLevel.NOTE, {**params, "ry": f"{tilt:.1f}"})
        )
    return findings


def _mend_teaching(
    teaching: tuple[float, float, float] | None, heard: HeardFacts
) -> tuple[str, ...]:
    """0x47D with friction level 1, the other two as the arm has them, if they are known."""
    if teaching is None:
        return _ask(heard)
    range_percent, stroke_mm, _friction = teaching
    possible = min(max(int(range_percent), 100), 200)
    stroke = int(stroke_mm) if stroke_mm in _STROKE_LIMITS_MM else 0
    return _send(heard, 0x47D, f"{possible:02X}{stroke:02X}010000000000")


def _ask(heard: HeardFacts) -> tuple[str, ...]:
    channel = f" --channel {heard.channel}" if heard.channel else ""
    return (f"armui doctor --ask --interface {heard.interface}{channel}",)


def _all_zero(arm: ArmFacts) -> bool:
    """Whether the end pose is all zero: no pose of this arm is."""
    return all(each == 0 for each in arm.pose)


def _is_damaged(limits: LimitFacts) -> bool:
    low, high = limits.min_deg, limits.max_deg
    speed, acceleration = limits.max_speed_deg_s, limits.max_acceleration_deg_s2
    return (
        (low is not None and high is not None and not low < high)
        or (speed is not None and not 0 < speed < _FASTEST_DEG_S)
        or (acceleration is not None and not 0 < acceleration < _FASTEST_DEG_S2)
    )


def _end_teaching_input(heard: HeardFacts) -> tuple[str, ...]:
    """0x470 with 0xFC and no offsets: a motion output again, after a power cycle."""
    return _send(heard, 0x470, "FC00000000000000")


def _restart(heard: HeardFacts) -> tuple[str, ...]:
    if heard.interface != "socketcan":
        return ()
    return (f"sudo ip link set {heard.channel} type can restart",)


def _send(heard: HeardFacts, arbitration_id: int, data: str) -> tuple[str, ...]:
    """How to send one frame by hand."""
    if heard.interface == "socketcan":
        return (f"cansend {heard.channel} {arbitration_id:03X}#{data}",)
    bitrate = "" if heard.interface in _BITRATE_OF_SYSTEM else ", bitrate=1000000"
    code = (
        f"import can; b = can.Bus(interface='{heard.interface}', "
        f"channel='{heard.channel}'{bitrate}); "
        f"b.send(can.Message(arbitration_id=0x{arbitration_id:03X}, "
        f"is_extended_id=False, data=bytes.fromhex('{data}'))); b.shutdown()"
    )
    return (f'python -c "{code}"',)


def _ids(ids: tuple[int, ...]) -> str:
    return ", ".join(f"0x{each:03X}" for each in ids)


def _name(heard: HeardFacts) -> str:
    return f"{heard.interface} {heard.channel}".strip()


# From what there is of CAN devices.

_USUAL_BITRATE: Final = 1_000_000
_KNOWN_BITRATES: Final = (_USUAL_BITRATE, 500_000)
"""Today's hardware, and what generation 1's protocol text says."""
_USBIPD: Final = (
    "usbipd list",
    "usbipd bind --busid BUSID",
    "usbipd attach --wsl --busid BUSID",
)
"""For a terminal of Windows: they hand a USB device to WSL."""
_PASSIVE_COUNT: Final = 128
_WARNING_COUNT: Final = 96
"""Error counters at which a controller warns and turns passive (ISO 11898-1)."""


def judge_can(facts: CanFacts) -> list[Diagnosis]:
    """Adapters, drivers, permissions, interfaces."""
    findings: list[Diagnosis] = []
    if facts.error:
        findings.append(_finding("search_failed", DiagnosisLevel.FAULT, {"text": facts.error}))
    if facts.wsl and not facts.links and not facts.ports:
        findings.append(_finding("wsl", DiagnosisLevel.WARNING, {}, _USBIPD))
    findings += [_without_driver(each) for each in facts.usb if not each.links]
    findings += [_closed_port(each) for each in facts.ports if not each.may_open]
    for link in facts.links:
        findings += judge_link(link)
    hardware = [each for each in facts.links if each.kind == "can"]
    linked = {each.name for each in facts.links}
    others = [d for d in facts.devices if not (d.interface == "socketcan" and d.channel in linked)]
    findings += [
        _finding(
            "device",
            DiagnosisLevel.OK,
            {"device": f"{each.interface} {each.channel}", "serial": each.serial or "—"},
        )
        for each in others
    ]
    if len(hardware) > 1:
        findings.append(_several(hardware))
    findings += [_kept(each) for each in facts.kept]
    if not facts.links and not others and not facts.usb and not facts.ports:
        findings.append(_finding("no_devices", DiagnosisLevel.WARNING, {}))
    return findings


def judge_link(link: LinkFacts) -> list[Diagnosis]:
    """One CAN interface of Linux."""
    params = {
        "channel": link.name,
        "bitrate": "—" if link.bitrate is None else str(link.bitrate),
        "state": link.state or "—",
        "serial": link.serial or "—",
        "kind": link.kind,
    }
    if not link.up:
        remedies = _switch_on(link.name)
        return [_finding("link_down", DiagnosisLevel.FAULT, params, _up(link), remedies)]
    findings = [_state(link, params)]
    again, anew = _again(link), (_with_bitrate(link.name),)
    if link.bitrate is not None and link.bitrate not in _KNOWN_BITRATES:
        findings.append(_finding("bitrate_odd", DiagnosisLevel.WARNING, params, again, anew))
    elif link.bitrate is not None and link.bitrate != _USUAL_BITRATE:
        findings.append(_finding("bitrate_old", DiagnosisLevel.NOTE, params, again, anew))
    if link.listen_only:
        anew = (_with_bitrate(link.name, _bitrate(link)),)
        findings.append(_finding("link_listen_only", DiagnosisLevel.WARNING, params, again, anew))
    if link.kind == "can" and not link.restart_ms:
        commands = (
            f"sudo ip link set {link.name} down",
            f"sudo ip link set {link.name} up type can restart-ms 100",
        )
        anew = (_with_bitrate(link.name, _bitrate(link)),)
        findings.append(_finding("no_restart", DiagnosisLevel.NOTE, params, commands, anew))
    if link.dropped:
        params = {**params, "count": str(link.dropped)}
        findings.append(_finding("kernel_dropped", DiagnosisLevel.NOTE, params))
    return findings


def _state(link: LinkFacts, params: dict[str, str]) -> Diagnosis:
    errors = max(link.tx_errors or 0, link.rx_errors or 0)
    params = {**params, "tx": _count(link.tx_errors), "rx": _count(link.rx_errors)}
    if link.state == "BUS-OFF":
        commands = (f"sudo ip link set {link.name} type can restart",)
        reset = (("reset", link.name),)
        return _finding("bus_off", DiagnosisLevel.FAULT, params, commands, reset)
    if link.state == "ERROR-PASSIVE" or errors >= _PASSIVE_COUNT:
        anew = (_with_bitrate(link.name),)
        return _finding("error_passive", DiagnosisLevel.FAULT, params, _again(link), anew)
    if link.state == "ERROR-WARNING" or errors >= _WARNING_COUNT:
        return _finding("error_warning", DiagnosisLevel.WARNING, params)
    remember = (_remember(link),) if link.kind == "can" and link.serial else ()
    return _finding("link", DiagnosisLevel.OK, params, remedies=remember)


def _count(value: int | None) -> str:
    return "—" if value is None else str(value)


def _up(link: LinkFacts) -> tuple[str, ...]:
    if link.kind == "vcan":
        return (f"sudo ip link set {link.name} up",)
    return (f"sudo ip link set {link.name} up type can bitrate {_USUAL_BITRATE} restart-ms 100",)


def _switch_on(name: str) -> tuple[tuple[str, ...], ...]:
    return tuple(_with_bitrate(name, each) for each in _KNOWN_BITRATES)


def _with_bitrate(name: str, bitrate: int = _USUAL_BITRATE) -> tuple[str, ...]:
    return ("up", name, str(bitrate))


def _bitrate(link: LinkFacts) -> int:
    return link.bitrate if link.bitrate in _KNOWN_BITRATES else _USUAL_BITRATE


def _remember(link: LinkFacts) -> tuple[str, ...]:
    return ("remember", link.name, str(_bitrate(link)))


def _kept(name: str) -> Diagnosis:
    params, remedies = {"name": name}, (("forget", name),)
    if name.startswith("port-"):
        return _finding("port_kept", DiagnosisLevel.NOTE, params, remedies=remedies)
    return _finding("kept", DiagnosisLevel.NOTE, params, remedies=remedies)


def _again(link: LinkFacts) -> tuple[str, ...]:
    up = f"up type can bitrate {_USUAL_BITRATE} restart-ms 100 listen-only off"
    return (f"sudo ip link set {link.name} down", f"sudo ip link set {link.name} {up}")


def _without_driver(adapter: UsbAdapterFacts) -> Diagnosis:
    params = {"adapter": adapter.name, "usb": adapter.usb_id, "serial": adapter.serial or "—"}
    return _finding("no_driver", DiagnosisLevel.FAULT, params, ("sudo modprobe gs_usb",))


def _closed_port(port: SerialPortFacts) -> Diagnosis:
    group = port.group or "dialout"
    params = {"path": port.path, "group": group}
    commands = (f'sudo usermod -aG {group} "$USER"',)
    remedies = (("remember", port.path.removeprefix(_PORTS)),)
    return _finding("port_closed", DiagnosisLevel.FAULT, params, commands, remedies)


def _several(links: list[LinkFacts]) -> Diagnosis:
    """can0 and can1 may swap at the next replugging; by their serials they can be told apart."""
    names = ", ".join(f"{each.name} ({each.serial or '—'})" for each in links)
    commands = tuple(
        f'echo \'SUBSYSTEM=="net", ATTRS{{serial}}=="{each.serial}", NAME="arm_{each.name}"\''
        " | sudo tee -a /etc/udev/rules.d/90-can.rules"
        for each in links
        if each.serial
    )
    remedies = tuple(_remember(each) for each in links if each.serial)
    return _finding("several", DiagnosisLevel.NOTE, {"names": names}, commands, remedies)


def _finding(
    code: str,
    level: DiagnosisLevel,
    params: dict[str, str],
    commands: tuple[str, ...] = (),
    remedies: tuple[tuple[str, ...], ...] = (),
) -> Diagnosis:
    return Diagnosis(Section.CAN, code, level, params, commands, remedies)


def _arm_finding(
    code: str,
    level: DiagnosisLevel,
    params: dict[str, str],
    commands: tuple[str, ...] = (),
    remedies: tuple[tuple[str, ...], ...] = (),
) -> Diagnosis:
    return Diagnosis(Section.ARM, code, level, params, commands, remedies)


# From the program and the screen.

_APT: Final = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libOpenGL.so.0": "libopengl0",
    "libGLX.so.0": "libglx0",
    "libX11.so.6": "libx11-6",
    "libX11-xcb.so.1": "libx11-xcb1",
    "libdbus-1.so.3": "libdbus-1-3",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libgthread-2.0.so.0": "libglib2.0-0",
    "libwayland-client.so.0": "libwayland-client0",
    "libwayland-cursor.so.0": "libwayland-cursor0",
    "libwayland-egl.so.1": "libwayland-egl1",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-shm.so.0": "libxcb-shm0",
    "libxcb-sync.so.1": "libxcb-sync1",
    "libxcb-util.so.1": "libxcb-util1",
    "libxcb-xfixes.so.0": "libxcb-xfixes0",
    "libxcb-xinerama.so.0": "libxcb-xinerama0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxcb.so.1": "libxcb1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libXrender.so.1": "libxrender1",
}
"""The Debian package of each library that Qt's Linux wheels leave to the system."""

_APT_INSTALL: Final = "sudo apt install"
_SOFTWARE_RENDERERS: Final = ("llvmpipe", "softpipe", "swrast", "software", "gdi generic")


def judge(facts: Facts) -> list[Diagnosis]:
    """Every finding, in the order of sections."""
    findings: list[Diagnosis] = []
    if facts.program is not None:
        findings += judge_program(facts.program)
    if facts.screen is not None:
        findings += judge_screen(facts.screen, facts.program)
    if facts.can is not None:
        findings += judge_can(facts.can)
    for heard in facts.heard:
        findings += judge_heard(heard)
    if facts.can is not None and not facts.heard:
        findings.append(Diagnosis(Section.ARM, "no_device_to_listen", DiagnosisLevel.WARNING))
    return findings


def an_arm_answers(facts: Facts) -> bool:
    """Whether an arm's own feedback was heard; and answers, where questions were sent."""
    return any(
        heard.arm is not None and (heard.answered or not heard.asked) for heard in facts.heard
    )


def judge_program(facts: ProgramFacts) -> list[Diagnosis]:
    """Python and packages."""
    params = {"armui": facts.armui, "version": facts.python, "system": facts.system}
    if facts.python_suffices:
        findings = [Diagnosis(Section.PROGRAM, "python", DiagnosisLevel.OK, params)]
    else:
        findings = [Diagnosis(Section.PROGRAM, "python_old", DiagnosisLevel.FAULT, params)]
    wrong = [each for each in facts.packages if not each.satisfied]
    findings += [_package(each, facts.executable) for each in wrong]
    needed = [each for each in facts.packages if not each.extra]
    if needed and not any(each in wrong for each in needed):
        count = {"count": str(len(needed))}
        findings.append(Diagnosis(Section.PROGRAM, "packages", DiagnosisLevel.OK, count))
    if facts.goes_first is not None:
        findings.append(_priority(facts))
    return findings


def _priority(facts: ProgramFacts) -> Diagnosis:
    if facts.goes_first:
        return Diagnosis(Section.PROGRAM, "priority", DiagnosisLevel.OK)
    text = {"text": facts.priority_reason}
    tool = _installer(facts.families)
    commands = (f"{tool} rtkit",) if tool else ()
    return Diagnosis(Section.PROGRAM, "priority_refused", DiagnosisLevel.NOTE, text, commands)


def _package(facts: PackageFacts, executable: str) -> Diagnosis:
    params = {
        "package": facts.name,
        "wanted": facts.wanted or "*",
        "installed": facts.installed or "",
        "extra": facts.extra,
    }
    command = f'{_quoted(executable)} -m pip install "{facts.name}{facts.wanted}"'
    if facts.installed is not None:
        return Diagnosis(Section.PROGRAM, "package_other", DiagnosisLevel.FAULT, params, (command,))
    if facts.extra:
        return Diagnosis(
            Section.PROGRAM, "package_optional", DiagnosisLevel.NOTE, params, (command,)
        )
    return Diagnosis(Section.PROGRAM, "package_missing", DiagnosisLevel.FAULT, params, (command,))


def judge_screen(facts: ScreenFacts, program: ProgramFacts | None) -> list[Diagnosis]:
    """Windows and the 3D picture."""
    families = () if program is None else program.families
    findings: list[Diagnosis] = []
    if facts.missing_libraries:
        findings.append(
            Diagnosis(
                Section.SCREEN,
                "libraries_missing",
                DiagnosisLevel.FAULT,
                {"libraries": ", ".join(facts.missing_libraries)},
                _install(facts.missing_libraries, families),
            )
        )
    if facts.qt is None:
        text = {"text": facts.qt_error}
        findings.append(Diagnosis(Section.SCREEN, "qt_not_loaded", DiagnosisLevel.FAULT, text))
    elif not facts.has_display:
        findings.append(
            Diagnosis(
                Section.SCREEN,
                "no_display",
                DiagnosisLevel.FAULT,
                {"qt": facts.qt},
                ("export DISPLAY=:0",),
            )
        )
    elif facts.platform is None:
        params = {"qt": facts.qt, "text": facts.qt_error}
        findings.append(
            Diagnosis(Section.SCREEN, "qt_platform_failed", DiagnosisLevel.FAULT, params)
        )
    else:
        params = {"qt": facts.qt, "platform": facts.platform}
        findings.append(Diagnosis(Section.SCREEN, "qt", DiagnosisLevel.OK, params))
    findings.append(_opengl(facts, families))
    return findings


def _opengl(facts: ScreenFacts, families: tuple[str, ...]) -> Diagnosis:
    if facts.opengl is None:
        params = {"text": facts.opengl_error}
        commands = _install(("libEGL.so.1", "libGL.so.1", "libXrender.so.1"), families)
        return Diagnosis(Section.SCREEN, "opengl_failed", DiagnosisLevel.WARNING, params, commands)
    params = {"renderer": facts.opengl}
    if any(word in facts.opengl.lower() for word in _SOFTWARE_RENDERERS):
        return Diagnosis(Section.SCREEN, "opengl_software", DiagnosisLevel.NOTE, params)
    return Diagnosis(Section.SCREEN, "opengl", DiagnosisLevel.OK, params)


def _install(libraries: tuple[str, ...], families: tuple[str, ...]) -> tuple[str, ...]:
    """How this distribution installs libraries that are known by their files."""
    tool = _installer(families)
    if tool == _APT_INSTALL:
        packages = dict.fromkeys(_APT[each] for each in libraries if each in _APT)
        return (f"{tool} {' '.join(packages)}",) if packages else ()
    return (f"{tool} " + " ".join(f"'{each}()(64bit)'" for each in libraries),) if tool else ()


def _installer(families: tuple[str, ...]) -> str:
    """The command that installs what is named behind it; "" for a system that is not known."""
    if {"debian", "ubuntu"} & set(families):
        return _APT_INSTALL
    if {"fedora", "rhel"} & set(families):
        return "sudo dnf install"
    return "sudo zypper install" if {"suse", "opensuse"} & set(families) else ""


def _quoted(path: str) -> str:
    return f'"{path}"' if " " in path else path
