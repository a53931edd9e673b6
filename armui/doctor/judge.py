"""From facts to findings. Pure: nothing here looks at anything, nor imports what may be missing."""

from __future__ import annotations

from typing import Final

from armui.doctor.facts import (
    CanFacts,
    Diagnosis,
    DiagnosisLevel,
    Facts,
    LinkFacts,
    PackageFacts,
    ProgramFacts,
    ScreenFacts,
    Section,
    SerialPortFacts,
    UsbAdapterFacts,
)
from armui.doctor.judge_arm import judge_heard

_USUAL_BITRATE: Final = 1_000_000
_KNOWN_BITRATES: Final = (_USUAL_BITRATE, 500_000)
"""Today's hardware, and what generation 1's protocol text says."""
_PASSIVE_COUNT: Final = 128
_WARNING_COUNT: Final = 96
"""Error counters at which a controller warns and turns passive (ISO 11898-1)."""


def judge_can(facts: CanFacts) -> list[Diagnosis]:
    """Adapters, drivers, permissions, interfaces."""
    findings: list[Diagnosis] = []
    if facts.error:
        findings.append(_finding("search_failed", DiagnosisLevel.FAULT, {"text": facts.error}))
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
        return [_finding("link_down", DiagnosisLevel.FAULT, params, _up(link))]
    findings = [_state(link, params)]
    if link.bitrate is not None and link.bitrate not in _KNOWN_BITRATES:
        findings.append(_finding("bitrate_odd", DiagnosisLevel.WARNING, params, _again(link)))
    elif link.bitrate is not None and link.bitrate != _USUAL_BITRATE:
        findings.append(_finding("bitrate_old", DiagnosisLevel.NOTE, params, _again(link)))
    if link.listen_only:
        findings.append(_finding("link_listen_only", DiagnosisLevel.WARNING, params, _again(link)))
    if link.kind == "can" and not link.restart_ms:
        commands = (
            f"sudo ip link set {link.name} down",
            f"sudo ip link set {link.name} up type can restart-ms 100",
        )
        findings.append(_finding("no_restart", DiagnosisLevel.NOTE, params, commands))
    if link.dropped:
        params = {**params, "count": str(link.dropped)}
        findings.append(_finding("kernel_dropped", DiagnosisLevel.NOTE, params))
    return findings


def _state(link: LinkFacts, params: dict[str, str]) -> Diagnosis:
    errors = max(link.tx_errors or 0, link.rx_errors or 0)
    params = {**params, "tx": _count(link.tx_errors), "rx": _count(link.rx_errors)}
    if link.state == "BUS-OFF":
        commands = (f"sudo ip link set {link.name} type can restart",)
        return _finding("bus_off", DiagnosisLevel.FAULT, params, commands)
    if link.state == "ERROR-PASSIVE" or errors >= _PASSIVE_COUNT:
        return _finding("error_passive", DiagnosisLevel.FAULT, params, _again(link))
    if link.state == "ERROR-WARNING" or errors >= _WARNING_COUNT:
        return _finding("error_warning", DiagnosisLevel.WARNING, params)
    return _finding("link", DiagnosisLevel.OK, params)


def _count(value: int | None) -> str:
    return "—" if value is None else str(value)


def _up(link: LinkFacts) -> tuple[str, ...]:
    if link.kind == "vcan":
        return (f"sudo ip link set {link.name} up",)
    return (f"sudo ip link set {link.name} up type can bitrate {_USUAL_BITRATE} restart-ms 100",)


def _again(link: LinkFacts) -> tuple[str, ...]:
    up = f"up type can bitrate {_USUAL_BITRATE} restart-ms 100 listen-only off"
    return (f"sudo ip link set {link.name} down", f"sudo ip link set {link.name} {up}")


def _without_driver(adapter: UsbAdapterFacts) -> Diagnosis:
    params = {"adapter": adapter.name, "usb": adapter.usb_id, "serial": adapter.serial or "—"}
    return _finding("no_driver", DiagnosisLevel.FAULT, params, ("sudo modprobe gs_usb",))


def _closed_port(port: SerialPortFacts) -> Diagnosis:
    group = port.group or "dialout"
    params = {"path": port.path, "group": group}
    return _finding(
        "port_closed", DiagnosisLevel.FAULT, params, (f'sudo usermod -aG {group} "$USER"',)
    )


def _several(links: list[LinkFacts]) -> Diagnosis:
    """can0 and can1 may swap at the next replugging; by their serials they can be told apart."""
    names = ", ".join(f"{each.name} ({each.serial or '—'})" for each in links)
    commands = tuple(
        f'echo \'SUBSYSTEM=="net", ATTRS{{serial}}=="{each.serial}", NAME="arm_{each.name}"\''
        " | sudo tee -a /etc/udev/rules.d/90-can.rules"
        for each in links
        if each.serial
    )
    return _finding("several", DiagnosisLevel.NOTE, {"names": names}, commands)


def _finding(
    code: str, level: DiagnosisLevel, params: dict[str, str], commands: tuple[str, ...] = ()
) -> Diagnosis:
    return Diagnosis(Section.CAN, code, level, params, commands)


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
