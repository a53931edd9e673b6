"""From what there is of CAN devices to findings. Pure."""

from __future__ import annotations

from typing import Final

from armui.doctor.facts import CanFacts, LinkFacts, SerialPortFacts, UsbAdapterFacts
from armui.doctor.finding import Diagnosis, DiagnosisLevel, Section

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
