"""Derives findings from facts.

Pure: it examines nothing, and imports nothing that may be missing.
"""

from __future__ import annotations

from typing import Final

from armui.doctor import judge_heard as heard_kinds
from armui.doctor.facts import (
    CanFacts,
    Diagnosis,
    DiagnosisKind,
    DiagnosisLevel,
    Facts,
    LinkFacts,
    OfArm,
    OfCan,
    OfProgram,
    OfScreen,
    PackageFacts,
    ProgramFacts,
    ScreenFacts,
    SerialPortFacts,
    UsbAdapterFacts,
)
from armui.doctor.judge_heard import KNOWN_BITRATES, judge_heard, switched_on

# The program.

PYTHON = OfProgram("python", "armui {armui}, Python {version}, {system}.", DiagnosisLevel.OK)
PYTHON_OLD = OfProgram(
    "python_old",
    "armui {armui} needs Python 3.11 or newer; this is {version} on {system}. Install a newer "
    "Python.",
)
PACKAGES = OfProgram(
    "packages", "All {count} packages are installed in a suitable version.", DiagnosisLevel.OK
)
PRIORITY = OfProgram(
    "priority",
    "On a busy computer, window, bus and stop may go before other programs.",
    DiagnosisLevel.OK,
)
PRIORITY_REFUSED = OfProgram(
    "priority_refused",
    "On a busy computer, window, bus and stop wait their turn behind other programs: {text}. A "
    "stop may then leave some tenths of a second later. Install rtkit, or close what keeps the "
    "computer busy.",
    DiagnosisLevel.NOTE,
)
PACKAGE_MISSING = OfProgram("package_missing", "The package {package} is missing. Install it.")
PACKAGE_OTHER = OfProgram(
    "package_other", "The package {package} is installed as {installed}; {wanted} is needed."
)
PACKAGE_LOST = OfProgram(
    "package_lost",
    "The program is not whole: of its own packages, {package} is missing or another version "
    "({installed}). Install armui once more, from the file it was installed from.",
)
PACKAGE_OPTIONAL = OfProgram(
    "package_optional",
    "The package {package} is not installed; some adapters need it.",
    DiagnosisLevel.NOTE,
)

FOLDERS_CLOSED = OfProgram(
    "folders_closed",
    "Nothing is kept in these folders, neither settings nor trajectories, recordings or events "
    "that belong there: {folders}. Let this user write there.",
)

# The screen.

QT = OfScreen("qt", "Qt {qt} draws through {platform}.", DiagnosisLevel.OK)
QT_NOT_LOADED = OfScreen("qt_not_loaded", "Qt cannot be loaded: {text}")
LIBRARIES_MISSING = OfScreen(
    "libraries_missing", "System libraries that Qt needs are missing: {libraries}."
)
NO_DISPLAY = OfScreen(
    "no_display",
    "Qt {qt} is installed, but there is no desktop session: start the program in one, or name "
    "its display.",
)
QT_PLATFORM_FAILED = OfScreen("qt_platform_failed", "Qt {qt} cannot open a display: {text}")
OPENGL = OfScreen("opengl", "OpenGL for the 3D picture: {renderer}.", DiagnosisLevel.OK)
OPENGL_SOFTWARE = OfScreen(
    "opengl_software",
    "OpenGL for the 3D picture is drawn by the processor ({renderer}): slower, but it works. A "
    "graphics driver makes it faster.",
    DiagnosisLevel.NOTE,
)
OPENGL_FAILED = OfScreen(
    "opengl_failed",
    "The 3D picture cannot be drawn, the rest of the program works: {text}",
    DiagnosisLevel.WARNING,
)

# CAN devices.

SEARCH_FAILED = OfCan("search_failed", "CAN devices cannot be searched for: {text}")
NO_DEVICES = OfCan(
    "no_devices",
    "No CAN device is found. Plug in the adapter; try another cable and another USB port.",
    DiagnosisLevel.WARNING,
)
DEVICE = OfCan("device", "{device}, serial number {serial}.", DiagnosisLevel.OK)
NO_DRIVER = OfCan(
    "no_driver",
    "{adapter} ({usb}, serial number {serial}) is plugged in, but has no CAN interface: its "
    "driver is not loaded. In a virtual machine, hand the USB device over to it; WSL has no "
    "CAN in its usual kernel.",
)
PORT_CLOSED = OfCan(
    "port_closed",
    "{path} may not be opened by this user; it belongs to the group {group}. Join it, then log "
    "out and in again.",
)
LINK = OfCan(
    "link",
    "{channel} ({kind}) is up, {bitrate} bit/s, {state}, error counters {tx}/{rx}, serial number "
    "{serial}.",
    DiagnosisLevel.OK,
)
LINK_DOWN = OfCan("link_down", "{channel} is switched off. Switch it on with the arm's bit rate.")
BUS_OFF = OfCan(
    "bus_off",
    "{channel} is off the bus (bus-off): too many errors. Check the cable, the terminating "
    "resistors and the bit rate ({bitrate}), then bring it back.",
)
ERROR_PASSIVE = OfCan(
    "error_passive",
    "{channel} sees many errors ({state}, counters {tx}/{rx}): nobody acknowledges, or the bit "
    "rate {bitrate} is not the arm's. Is the arm switched on? CAN_H and CAN_L swapped? 120 Ω at "
    "both ends?",
)
ERROR_WARNING = OfCan(
    "error_warning",
    "{channel} counts errors ({tx}/{rx}): look at cable and terminating resistors.",
    DiagnosisLevel.WARNING,
)
BITRATE_ODD = OfCan(
    "bitrate_odd",
    "{channel} runs at {bitrate} bit/s; arms run at 1000000 (today's) or 500000 (generation 1's "
    "text).",
    DiagnosisLevel.WARNING,
)
BITRATE_OLD = OfCan(
    "bitrate_old",
    "{channel} runs at {bitrate} bit/s, as generation 1's text says; today's arms run at 1000000.",
    DiagnosisLevel.NOTE,
)
LINK_LISTEN_ONLY = OfCan(
    "link_listen_only",
    "{channel} is in listen-only mode: no command and no emergency stop goes out.",
    DiagnosisLevel.WARNING,
)
LINK_DEAF = OfCan(
    "link_deaf",
    "{channel} is deaf: since it was switched on it has sent {sent} frames, received none, and "
    "counts no error. Unplug the adapter and plug it in again. If that does not help, check CAN_H "
    "and CAN_L, the bit rate ({bitrate}), the terminating resistors and the arm's power.",
)
NO_RESTART = OfCan(
    "no_restart",
    "{channel} does not come back by itself from bus-off (restart-ms is 0).",
    DiagnosisLevel.NOTE,
)
KERNEL_DROPPED = OfCan(
    "kernel_dropped",
    "{channel}: the kernel has dropped {count} received frames since it was switched on; the "
    "computer was too busy.",
    DiagnosisLevel.NOTE,
)
SEVERAL = OfCan(
    "several",
    "Several adapters: {names}. Their names may swap at the next plugging in, and settings go to "
    "the wrong arm. Tell arms apart by the serial number, or give the adapters fixed names:",
    DiagnosisLevel.NOTE,
)
SHARED = OfCan(
    "shared",
    "{names} share one USB controller ({controller}): if it fails, all of them go at once. Spread "
    "them over ports of other controllers.",
    DiagnosisLevel.NOTE,
)

KEPT = OfCan(
    "kept",
    "{name} has its name by its adapter's serial number, and is switched on at every start.",
    DiagnosisLevel.NOTE,
)
PORT_KEPT = OfCan(
    "port_kept",
    "A serial adapter ({name}) may be opened by whoever sits at this computer.",
    DiagnosisLevel.NOTE,
)
WSL = OfCan(
    "wsl",
    "This Linux is a guest of Windows (WSL): the adapter has to be handed over to it, before the "
    "arm is powered. In a terminal of Windows, with the adapter's BUSID from the list:",
    DiagnosisLevel.WARNING,
)

NO_DEVICE_TO_LISTEN = OfArm(
    "no_device_to_listen",
    "There is no device to listen to. A simulated arm in another process is heard with "
    "--interface udp_multicast.",
    DiagnosisLevel.WARNING,
)

BY_ID: Final = {
    each.id: each
    for each in (*vars(heard_kinds).values(), *globals().values())
    if isinstance(each, DiagnosisKind)
}
"""Every kind of finding by id, for findings read from another process."""


# Findings on CAN devices.

_USUAL_BITRATE: Final = 1_000_000
_USBIPD: Final = (
    "usbipd list",
    "usbipd bind --busid BUSID",
    "usbipd attach --wsl --busid BUSID",
)
"""Commands for a Windows terminal: they pass a USB device to WSL."""
_PASSIVE_COUNT: Final = 128
_WARNING_COUNT: Final = 96
_SENT_UNHEARD: Final = 3
"""Error counters at which a controller warns and turns passive (ISO 11898-1)."""

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
"""The Debian package of each library that Qt's Linux wheels do not include."""

_APT_INSTALL: Final = "sudo apt install"
_SOFTWARE_RENDERERS: Final = ("llvmpipe", "softpipe", "swrast", "software", "gdi generic")


def judge_can(facts: CanFacts) -> list[Diagnosis]:
    """Return the findings on adapters, drivers, permissions and interfaces."""
    findings: list[Diagnosis] = []
    if facts.error:
        findings.append(SEARCH_FAILED(text=facts.error))
    if facts.wsl and not facts.links and not facts.ports:
        findings.append(WSL(*_USBIPD))
    findings += [_without_driver(each) for each in facts.usb if not each.links]
    findings += [_closed_port(each) for each in facts.ports if not each.may_open]
    for link in facts.links:
        findings += judge_link(link)
    hardware = [each for each in facts.links if each.kind == "can"]
    linked = {each.name for each in facts.links}
    others = [d for d in facts.devices if not (d.interface == "socketcan" and d.channel in linked)]
    findings += [
        DEVICE(device=f"{each.interface} {each.channel}", serial=each.serial or "—")
        for each in others
    ]
    if len(hardware) > 1:
        findings.append(_several(hardware))
    findings += [SHARED(controller=at, names=", ".join(names)) for at, names in facts.shared]
    findings += [_kept(each) for each in facts.kept]
    if not facts.links and not others and not facts.usb and not facts.ports:
        findings.append(NO_DEVICES())
    return findings


def judge_link(link: LinkFacts) -> list[Diagnosis]:
    """Return the findings on one CAN interface of Linux; one that is up can be switched off."""
    params = {
        "channel": link.name,
        "bitrate": "—" if link.bitrate is None else str(link.bitrate),
        "state": link.state or "—",
        "serial": link.serial or "—",
        "kind": link.kind,
    }
    if not link.up:
        return [LINK_DOWN(*_up(link), **params).mended_by(*switched_on(link.name))]
    findings = [_state(link, params)]
    off = ("down", link.name)
    usual = ("up", link.name, str(_USUAL_BITRATE))
    anew = ("up", link.name, str(_bitrate(link)))
    if link.bitrate is not None and link.bitrate not in KNOWN_BITRATES:
        findings.append(BITRATE_ODD(*_again(link), **params).mended_by(usual, off))
    elif link.bitrate is not None and link.bitrate != _USUAL_BITRATE:
        findings.append(BITRATE_OLD(*_again(link), **params).mended_by(usual, off))
    if link.listen_only:
        findings.append(LINK_LISTEN_ONLY(*_again(link), **params).mended_by(anew, off))
    if link.kind == "can" and not link.restart_ms:
        commands = (
            f"sudo ip link set {link.name} down",
            f"sudo ip link set {link.name} up type can restart-ms 100",
        )
        findings.append(NO_RESTART(*commands, **params).mended_by(anew, off))
    if link.dropped:
        findings.append(KERNEL_DROPPED(**params, count=str(link.dropped)))
    return findings


def _state(link: LinkFacts, params: dict[str, str]) -> Diagnosis:
    errors = max(link.tx_errors or 0, link.rx_errors or 0)
    params = {**params, "tx": _count(link.tx_errors), "rx": _count(link.rx_errors)}
    off = ("down", link.name)
    if link.state == "BUS-OFF":
        commands = (f"sudo ip link set {link.name} type can restart",)
        return BUS_OFF(*commands, **params).mended_by(("reset", link.name), off)
    if link.state == "ERROR-PASSIVE" or errors >= _PASSIVE_COUNT:
        usual = ("up", link.name, str(_USUAL_BITRATE))
        return ERROR_PASSIVE(*_again(link), **params).mended_by(usual, off)
    if link.state == "ERROR-WARNING" or errors >= _WARNING_COUNT:
        return ERROR_WARNING(**params)
    if link.sent >= _SENT_UNHEARD and not link.received and not errors and link.kind == "can":
        return LINK_DEAF(**params, sent=str(link.sent)).mended_by(off)
    kept = (_remember(link),) if link.kind == "can" and link.serial else ()
    return LINK(**params).mended_by(*kept, off)


def _count(value: int | None) -> str:
    return "—" if value is None else str(value)


def _up(link: LinkFacts) -> tuple[str, ...]:
    if link.kind == "vcan":
        return (f"sudo ip link set {link.name} up",)
    return (f"sudo ip link set {link.name} up type can bitrate {_USUAL_BITRATE} restart-ms 100",)


def _bitrate(link: LinkFacts) -> int:
    found = link.bitrate
    return found if found is not None and found in KNOWN_BITRATES else _USUAL_BITRATE


def _remember(link: LinkFacts) -> tuple[str, ...]:
    return ("remember", link.name, str(_bitrate(link)))


def _kept(name: str) -> Diagnosis:
    kind = PORT_KEPT if name.startswith("port-") else KEPT
    return kind(name=name).mended_by(("forget", name))


def _again(link: LinkFacts) -> tuple[str, ...]:
    up = f"up type can bitrate {_USUAL_BITRATE} restart-ms 100 listen-only off"
    return (f"sudo ip link set {link.name} down", f"sudo ip link set {link.name} {up}")


def _without_driver(adapter: UsbAdapterFacts) -> Diagnosis:
    params = {"adapter": adapter.name, "usb": adapter.usb_id, "serial": adapter.serial or "—"}
    return NO_DRIVER("sudo modprobe gs_usb", **params)


def _closed_port(port: SerialPortFacts) -> Diagnosis:
    group = port.group or "dialout"
    found = PORT_CLOSED(f'sudo usermod -aG {group} "$USER"', path=port.path, group=group)
    return found.mended_by(("remember", port.path.removeprefix("/dev/")))


def _several(links: list[LinkFacts]) -> Diagnosis:
    """Return the finding that can0 and can1 may swap when replugged, and how to name them."""
    names = ", ".join(f"{each.name} ({each.serial or '—'})" for each in links)
    commands = tuple(
        f'echo \'SUBSYSTEM=="net", ATTRS{{serial}}=="{each.serial}", NAME="arm_{each.name}"\''
        " | sudo tee -a /etc/udev/rules.d/90-can.rules"
        for each in links
        if each.serial
    )
    remedies = [_remember(each) for each in links if each.serial]
    return SEVERAL(*commands, names=names).mended_by(*remedies)


# Findings on the program and the screen.


def judge(facts: Facts) -> list[Diagnosis]:
    """Return every finding, in the order of sections."""
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
        findings.append(NO_DEVICE_TO_LISTEN())
    return findings


def an_arm_answers(facts: Facts) -> bool:
    """Return whether an arm's feedback was heard, and answers, if questions were sent."""
    return any(
        heard.arm is not None and (heard.answered or not heard.asked) for heard in facts.heard
    )


def judge_program(facts: ProgramFacts) -> list[Diagnosis]:
    """Return the findings on Python and packages."""
    params = {"armui": facts.armui, "version": facts.python, "system": facts.system}
    findings = [(PYTHON if facts.python_suffices else PYTHON_OLD)(**params)]
    wrong = [each for each in facts.packages if not each.satisfied]
    findings += [_package(each, facts) for each in wrong]
    needed = [each for each in facts.packages if not each.extra]
    if needed and not any(each in wrong for each in needed):
        findings.append(PACKAGES(count=str(len(needed))))
    if facts.goes_first is not None:
        findings.append(_priority(facts))
    if facts.closed:
        places = dict.fromkeys(each.place for each in facts.closed if each.denied)
        owned = [f'sudo chown -R "$USER" "{each}"' for each in places]
        commands = () if facts.system.startswith("Windows") else owned
        findings.append(FOLDERS_CLOSED(*commands, folders="; ".join(map(str, facts.closed))))
    return findings


def _priority(facts: ProgramFacts) -> Diagnosis:
    if facts.goes_first:
        return PRIORITY()
    tool = _installer(facts.families)
    commands = (f"{tool} rtkit",) if tool else ()
    return PRIORITY_REFUSED(*commands, text=facts.priority_reason)


def _package(facts: PackageFacts, program: ProgramFacts) -> Diagnosis:
    params = {
        "package": facts.name,
        "wanted": facts.wanted or "*",
        "installed": facts.installed or "",
        "extra": facts.extra,
    }
    if program.packaged:
        return PACKAGE_LOST(**{**params, "installed": facts.installed or "—"})
    command = f'{_quoted(program.executable)} -m pip install "{facts.name}{facts.wanted}"'
    if facts.installed is not None:
        return PACKAGE_OTHER(command, **params)
    if facts.extra:
        return PACKAGE_OPTIONAL(command, **params)
    return PACKAGE_MISSING(command, **params)


def judge_screen(facts: ScreenFacts, program: ProgramFacts | None) -> list[Diagnosis]:
    """Return the findings on windows and the 3D picture."""
    families = () if program is None else program.families
    findings: list[Diagnosis] = []
    if facts.missing_libraries:
        findings.append(
            LIBRARIES_MISSING(
                *_install(facts.missing_libraries, families),
                libraries=", ".join(facts.missing_libraries),
            )
        )
    if facts.qt is None:
        findings.append(QT_NOT_LOADED(text=facts.qt_error))
    elif not facts.has_display:
        findings.append(NO_DISPLAY("export DISPLAY=:0", qt=facts.qt))
    elif facts.platform is None:
        findings.append(QT_PLATFORM_FAILED(qt=facts.qt, text=facts.qt_error))
    else:
        findings.append(QT(qt=facts.qt, platform=facts.platform))
    findings.append(_opengl(facts, families))
    return findings


def _opengl(facts: ScreenFacts, families: tuple[str, ...]) -> Diagnosis:
    if facts.opengl is None:
        commands = _install(("libEGL.so.1", "libGL.so.1", "libXrender.so.1"), families)
        return OPENGL_FAILED(*commands, text=facts.opengl_error)
    if any(word in facts.opengl.lower() for word in _SOFTWARE_RENDERERS):
        return OPENGL_SOFTWARE(renderer=facts.opengl)
    return OPENGL(renderer=facts.opengl)


def _install(libraries: tuple[str, ...], families: tuple[str, ...]) -> tuple[str, ...]:
    """Return this distribution's command that installs libraries, given their files."""
    tool = _installer(families)
    if tool == _APT_INSTALL:
        packages = dict.fromkeys(_APT[each] for each in libraries if each in _APT)
        return (f"{tool} {' '.join(packages)}",) if packages else ()
    return (f"{tool} " + " ".join(f"'{each}()(64bit)'" for each in libraries),) if tool else ()


def _installer(families: tuple[str, ...]) -> str:
    """Return the command that installs packages named behind it; "" for unknown systems."""
    if {"debian", "ubuntu"} & set(families):
        return _APT_INSTALL
    if {"fedora", "rhel"} & set(families):
        return "sudo dnf install"
    return "sudo zypper install" if {"suse", "opensuse"} & set(families) else ""


def _quoted(path: str) -> str:
    return f'"{path}"' if " " in path else path
