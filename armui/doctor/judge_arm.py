"""From what was heard on a bus to findings: the failures that owners of real arms report. Pure."""

from __future__ import annotations

from typing import Final

from armui.doctor.facts import ArmFacts, Diagnosis, DiagnosisLevel, HeardFacts, LimitFacts, Section
from armui.protocol.firmware_version import (
    RECOMMENDED,
    FirmwareBug,
    FirmwareVersion,
    quirks_of,
)

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
        findings.append(_finding("heard_bus_off", DiagnosisLevel.FAULT, base, _restart(heard)))
    if heard.error_frames:
        params = {**base, "count": str(heard.error_frames)}
        level = DiagnosisLevel.WARNING if heard.arm is not None else DiagnosisLevel.FAULT
        findings.append(_finding("error_frames", level, params))
    if heard.arm is not None:
        findings += judge_arm(heard.arm, heard)
        if heard.asked and not heard.answered:
            findings.append(_finding("no_answer", DiagnosisLevel.FAULT, base))
    else:
        findings.append(_no_arm(heard, base))
    if heard.other_offsets:
        offsets = ", ".join(f"0x{each:02X}" for each in heard.other_offsets)
        findings.append(
            _finding("second_arm", DiagnosisLevel.WARNING, {**base, "offsets": offsets})
        )
    if heard.other_hosts and not _is_leader(heard):
        frames = ", ".join(
            f"0x{each.arbitration_id:03X} ({each.rate_hz:.0f}/s)" for each in heard.other_hosts
        )
        findings.append(_finding("other_host", DiagnosisLevel.WARNING, {**base, "frames": frames}))
    return findings


def _is_leader(heard: HeardFacts) -> bool:
    return heard.leader or bool(heard.shifted_feedback)


def _not_opened(heard: HeardFacts, base: dict[str, str]) -> Diagnosis:
    params = {**base, "text": heard.problem_text, "package": heard.package}
    commands: tuple[str, ...] = ()
    if heard.problem == "bus_backend_missing":
        commands = (f"python -m pip install {heard.package}",)
    elif heard.interface == "socketcan" and heard.problem in {"bus_down", "bus_gone"}:
        commands = (f"sudo ip link set {heard.channel} up type can bitrate 1000000 restart-ms 100",)
    elif heard.problem == "bus_permission":
        commands = (_UDEV_RULE, "sudo udevadm control --reload && sudo udevadm trigger")
    code = heard.problem if heard.problem in _PROBLEMS else "bus_failed"
    return _finding(code, DiagnosisLevel.FAULT, params, commands)


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
        return _finding("teaching_input", DiagnosisLevel.FAULT, params, _end_teaching_input(heard))
    if heard.frames:
        params = {**base, "ids": _ids(heard.unknown_ids)}
        return _finding("no_arm", DiagnosisLevel.FAULT, params)
    commands = (
        (f"ip -details -statistics link show {heard.channel}",)
        if heard.interface == "socketcan"
        else ()
    )
    return _finding("nothing_heard", DiagnosisLevel.FAULT, base, commands)


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
    findings = [_finding("arm", DiagnosisLevel.OK, params), *_firmware(arm, heard, params)]
    findings += _model(arm, params)
    if arm.feedback_offset:
        findings.append(_finding("offset", DiagnosisLevel.NOTE, params))
    if arm.teaching_input:
        ids = {**params, "ids": "0x2A1"}
        findings.append(
            _finding("teaching_input", DiagnosisLevel.WARNING, ids, _end_teaching_input(heard))
        )
    findings += _status(arm, params)
    findings += _drivers(arm, params)
    findings += _feedback(arm, heard, params)
    damaged = [str(each.joint) for each in arm.limits if _is_damaged(each)]
    if damaged:
        joints = {**params, "joints": ", ".join(damaged)}
        commands = _send(heard, 0x477, "0002000000000000")
        findings.append(_finding("limits_damaged", DiagnosisLevel.FAULT, joints, commands))
    return findings


def _firmware(arm: ArmFacts, heard: HeardFacts, params: dict[str, str]) -> list[Diagnosis]:
    if arm.firmware is None:
        if arm.generation == 1:
            return []
        return [_finding("firmware_unknown", DiagnosisLevel.NOTE, params, _ask(heard))]
    version = FirmwareVersion.parse(arm.firmware)
    findings = [_finding("firmware", DiagnosisLevel.OK, params)]
    if version is not None and version < RECOMMENDED:
        findings.append(_finding("firmware_old", DiagnosisLevel.NOTE, params))
    if version is not None and FirmwareBug.FEEDBACK_PARTS in quirks_of(version).bugs:
        findings.append(_finding("reference_lost", DiagnosisLevel.NOTE, params))
    return findings


def _model(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    """Which arm of the family it is, by its own pose; a moving arm's fits none."""
    if not arm.models:
        return []
    names = {**params, "fits": ", ".join(arm.models)}
    if arm.chosen_model is not None and arm.chosen_model not in arm.models:
        names["chosen"] = arm.chosen_model
        return [_finding("model_other", DiagnosisLevel.WARNING, names)]
    return [_finding("model", DiagnosisLevel.OK, names)]


def _status(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    if arm.status_code is None:
        return [_finding("status_silent", DiagnosisLevel.WARNING, params)]
    findings: list[Diagnosis] = []
    status = {**params, "status": f"0x{arm.status_code:02X} {arm.status_word}".strip()}
    if arm.status_code == _EMERGENCY_STOP:
        findings.append(_finding("stopped", DiagnosisLevel.WARNING, status))
    elif arm.status_code != _NORMAL:
        findings.append(_finding("status", DiagnosisLevel.WARNING, status))
    if arm.mode_word and arm.mode_word not in _USUAL_MODES:
        findings.append(
            _finding("unusual_mode", DiagnosisLevel.WARNING, {**params, "mode": arm.mode_word})
        )
    return findings


def _drivers(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    findings: list[Diagnosis] = []
    if arm.unreachable:
        joints = {**params, "joints": ", ".join(map(str, arm.unreachable))}
        findings.append(_finding("joints_unreachable", DiagnosisLevel.FAULT, joints))
    if arm.beyond_limit:
        joints = {**params, "joints": ", ".join(map(str, arm.beyond_limit))}
        findings.append(_finding("joints_beyond_limit", DiagnosisLevel.WARNING, joints))
    if arm.driver_faults:
        faults = ", ".join(f"J{joint}: {fault}" for joint, fault in arm.driver_faults)
        findings.append(
            _finding("driver_faults", DiagnosisLevel.FAULT, {**params, "faults": faults})
        )
    if arm.lowest_voltage is not None and 0 < arm.lowest_voltage < _LOW_V:
        voltage = {**params, "voltage": f"{arm.lowest_voltage:.1f}"}
        findings.append(_finding("voltage_low", DiagnosisLevel.WARNING, voltage))
    return findings


def _feedback(arm: ArmFacts, heard: HeardFacts, params: dict[str, str]) -> list[Diagnosis]:
    """Angles and pose that cannot be true, or are easily misread."""
    findings: list[Diagnosis] = []
    if _all_zero(arm) or (arm.teaching is not None and _SILENT_BY_TEACHING_LEVEL in arm.teaching):
        commands = _mend_teaching(arm.teaching, heard) if arm.generation == 2 else ()
        findings.append(_finding("feedback_zero", DiagnosisLevel.FAULT, params, commands))
    tilt = arm.pose[4]
    if tilt is not None and abs(tilt) > _TILT_DEG:
        findings.append(
            _finding("euler_edge", DiagnosisLevel.NOTE, {**params, "ry": f"{tilt:.1f}"})
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


def _finding(
    code: str, level: DiagnosisLevel, params: dict[str, str], commands: tuple[str, ...] = ()
) -> Diagnosis:
    return Diagnosis(Section.ARM, code, level, params, commands)
