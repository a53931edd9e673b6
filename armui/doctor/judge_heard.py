"""Derives findings from the traffic on a bus: failures reported by owners of real arms. Pure."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from armui.arm.device import has_wire
from armui.doctor.facts import ArmFacts, Diagnosis, DiagnosisLevel, HeardFacts, LimitFacts, OfArm
from armui.protocol.firmware_version import RECOMMENDED, FirmwareBug, FirmwareVersion, quirks_of

BUS_BACKEND_MISSING = OfArm("bus_backend_missing", "{device}: the package {package} is missing.")
BUS_BACKEND_NOT_PACKED = OfArm(
    "bus_backend_not_packed",
    "{device} needs the Python package {package}, which is no part of this installed program, and "
    "cannot be added to it. Use another adapter, or armui from its source with that package.",
)
BUS_DRIVER_MISSING = OfArm("bus_driver_missing", "{device}: the maker's driver is missing: {text}")
BUS_GONE = OfArm("bus_gone", "{device} is not there (any more): {text}")
BUS_BUSY = OfArm(
    "bus_busy", "{device} is in use by another program. End that program, or listen there."
)
BUS_DOWN = OfArm("bus_down", "{device} is switched off.")
BUS_PERMISSION = OfArm("bus_permission", "{device} may not be opened by this user: {text}")
BUS_BAD_ARGUMENT = OfArm(
    "bus_bad_argument", "{device} cannot be opened with these settings: {text}"
)
BUS_FAILED = OfArm("bus_failed", "{device} cannot be opened: {text}")
HEARD_BUS_OFF = OfArm(
    "heard_bus_off",
    "{device} went off the bus (bus-off) while it was listened to: cable, terminating resistors, "
    "bit rate.",
)
ERROR_FRAMES = OfArm(
    "error_frames",
    "{device}: {count} error frames in {seconds} s. Bit rate other than the arm's, a loose plug, "
    "or no terminating resistor.",
)
NOTHING_HEARD = OfArm(
    "nothing_heard",
    "{device}: not one frame in {seconds} s. Is the arm switched on, the CAN cable plugged in, "
    "the bit rate 1000000? The arm may also be told to keep silent (0x422): a power cycle ends "
    "that.",
)
BUS_DEAF = OfArm(
    "bus_deaf",
    "{device} is deaf: it sends, hears not one frame, and reports no error. Unplug the adapter and "
    "plug it in again. If that does not help, check CAN_H and CAN_L, the bit rate, the terminating "
    "resistors (120 Ω), a receive filter of the adapter, and the arm's power.",
)
NO_ARM = OfArm(
    "no_arm", "{device}: {count} frames in {seconds} s, but no feedback of an arm. Heard: {ids}."
)
NO_ANSWER = OfArm(
    "no_answer",
    "{device}: feedback is heard, but no question was answered: commands do not get through. "
    "Another offset of the commands (0x470), or an adapter that only listens.",
)
ARM = OfArm(
    "arm", "{device}: an arm of generation {generation}, {rate} frames/s.", DiagnosisLevel.OK
)
FIRMWARE = OfArm("firmware", "Firmware {firmware}{identity}.", DiagnosisLevel.OK)
FIRMWARE_UNKNOWN = OfArm(
    "firmware_unknown",
    "The firmware's version was not heard: the arm tells it only when asked.",
    DiagnosisLevel.NOTE,
)
FIRMWARE_OLD = OfArm(
    "firmware_old",
    "The maker recommends firmware S-V1.8-9 or later; {firmware} has known faults. Updates come "
    "from the maker's support.",
    DiagnosisLevel.NOTE,
)
MODEL = OfArm("model", "Model by the pose it reports: {fits}.", DiagnosisLevel.OK)
MODEL_OTHER = OfArm(
    "model_other",
    "Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a "
    "{fits}: tool moves and checks would be wrong.",
    DiagnosisLevel.WARNING,
)
REFERENCE_LOST = OfArm(
    "reference_lost",
    "With {firmware} a joint may lose its reference without a fault: angles look right, the arm "
    "stands elsewhere. Compare the 3D picture with the arm; only stop and release (the arm drops) "
    "or a power cycle mends it.",
    DiagnosisLevel.NOTE,
)
OFFSET = OfArm(
    "offset",
    "The arm's feedback is shifted by {offset} (0x470): the program follows it by itself.",
    DiagnosisLevel.NOTE,
)
SECOND_ARM = OfArm(
    "second_arm",
    "{device}: a second arm is heard, its feedback shifted by {offsets}.",
    DiagnosisLevel.WARNING,
)
TEACHING_INPUT = OfArm(
    "teaching_input",
    "{device}: the arm is a teaching-input arm: it leads others and takes no commands "
    "({ids}). Make it a motion output again (0x470, 0xFC), then switch it off and on.",
)
OTHER_HOST = OfArm(
    "other_host",
    "{device}: another program or host commands the arm: {frames}. End it before you move the arm "
    "from here.",
    DiagnosisLevel.WARNING,
)
STATUS_SILENT = OfArm(
    "status_silent",
    "The arm's status (0x2A1) is not heard, though other feedback is.",
    DiagnosisLevel.WARNING,
)
STOPPED = OfArm(
    "stopped",
    "The arm is in emergency stop. Release drops the arm: hold it.",
    DiagnosisLevel.WARNING,
)
STATUS = OfArm("status", "The arm reports {status}.", DiagnosisLevel.WARNING)
UNUSUAL_MODE = OfArm(
    "unusual_mode",
    "The arm is in {mode}: another program has set it. A new mode word leaves the joints limp and "
    "the arm falls.",
    DiagnosisLevel.WARNING,
)
JOINTS_UNREACHABLE = OfArm(
    "joints_unreachable",
    "Joint {joints}: no communication with the main controller. Switch the arm off and on; if it "
    "stays, the cable inside is at fault.",
)
JOINTS_BEYOND_LIMIT = OfArm(
    "joints_beyond_limit", "Joint {joints} is beyond its limit.", DiagnosisLevel.WARNING
)
DRIVER_FAULTS = OfArm("driver_faults", "Drivers report: {faults}.")
VOLTAGE_LOW = OfArm(
    "voltage_low",
    "The drivers see only {voltage} V; the supply should have 24 V. A supply that is too weak, or "
    "a long cable.",
    DiagnosisLevel.WARNING,
)
FEEDBACK_ZERO = OfArm(
    "feedback_zero",
    "The feedback is all zero: seen with a teaching level of 255 in 0x47E (S-V1.5-8). Make the "
    "arm a teaching input and a motion output again, and set the teaching level to 1 (0x47D).",
)
EULER_EDGE = OfArm(
    "euler_edge",
    "RY is {ry}°: near ±90° the three angles of the end pose jump by up to 360°. That is how they "
    "are, not a fault; never subtract them.",
    DiagnosisLevel.NOTE,
)
LIMITS_DAMAGED = OfArm(
    "limits_damaged",
    "Joint {joints}: the limits kept in the arm are damaged. Set joint limits, speeds and "
    "accelerations to factory values (0x477), then read and set each.",
)

_PROBLEMS: Final = {
    each.id: each
    for each in (
        BUS_BACKEND_MISSING,
        BUS_BACKEND_NOT_PACKED,
        BUS_DRIVER_MISSING,
        BUS_GONE,
        BUS_BUSY,
        BUS_DOWN,
        BUS_PERMISSION,
        BUS_BAD_ARGUMENT,
        BUS_DEAF,
    )
}
"""The kind of finding for each reason why a device was not opened; any other means that it failed.
"""

_NORMAL: Final = 0
_EMERGENCY_STOP: Final = 1
_FASTEST_DEG_S: Final = 3600.0
_FASTEST_DEG_S2: Final = 20_000.0
"""An acceleration far above any joint of this arm; 0xFFFF read back is 37,548 °/s²."""
_TILT_DEG: Final = 89.0
"""From this RY on, up to ±90°, RX and RZ are ambiguous."""
_LOW_V: Final = 21.0
"""A voltage below this is too low; the supply has 24 V."""
_SILENT_BY_TEACHING_LEVEL: Final = 255
KNOWN_BITRATES: Final = (1_000_000, 500_000)
"""The bit rates of today's hardware, and of generation 1's protocol text."""
_UDEV_RULE: Final = (
    'echo \'SUBSYSTEM=="usb", ATTRS{idVendor}=="1d50", MODE="0666"\''
    " | sudo tee /etc/udev/rules.d/90-candlelight.rules"
)
_STROKE_LIMITS_MM: Final = (0, 70, 100)
_BITRATE_OF_SYSTEM: Final = ("udp_multicast", "virtual")
_USUAL_MODES: Final = ("MOVE P", "MOVE J", "MOVE L", "MOVE C")


def judge_heard(heard: HeardFacts) -> list[Diagnosis]:
    """Return the findings on the traffic of a device, or why there was none."""
    name = _name(heard)
    base = {"device": name, "seconds": f"{heard.seconds:.1f}", "count": str(heard.frames)}
    if heard.problem:
        return [_not_opened(heard, base)]
    findings: list[Diagnosis] = []
    if heard.bus_off:
        off = HEARD_BUS_OFF(*_restart(heard), **base)
        of_system = heard.interface == "socketcan"
        findings.append(off.mended_by(("reset", heard.channel)) if of_system else off)
    if heard.error_frames:
        level = DiagnosisLevel.WARNING if heard.arm is not None else DiagnosisLevel.FAULT
        found = ERROR_FRAMES(**base | {"count": str(heard.error_frames)})
        findings.append(replace(found, severity=level))
    if heard.arm is not None:
        findings += judge_arm(heard.arm, heard)
        if heard.asked and not heard.answered:
            findings.append(NO_ANSWER(**base))
    else:
        findings.append(_no_arm(heard, base))
    if heard.other_offsets:
        offsets = ", ".join(f"0x{each:02X}" for each in heard.other_offsets)
        findings.append(SECOND_ARM(**base, offsets=offsets))
    if heard.other_hosts and not _is_leader(heard):
        frames = ", ".join(
            f"0x{each.arbitration_id:03X} ({each.rate_hz:.0f}/s)" for each in heard.other_hosts
        )
        findings.append(OTHER_HOST(**base, frames=frames))
    return findings


def _is_leader(heard: HeardFacts) -> bool:
    return heard.leader or bool(heard.shifted_feedback)


def switched_on(interface: str) -> tuple[tuple[str, ...], ...]:
    """Return the helper's commands that switch an interface on, one for each possible bit rate."""
    return tuple(("up", interface, str(each)) for each in KNOWN_BITRATES)


def _not_opened(heard: HeardFacts, base: dict[str, str]) -> Diagnosis:
    params = {**base, "text": heard.problem_text, "package": heard.package}
    commands: tuple[str, ...] = ()
    remedies: tuple[tuple[str, ...], ...] = ()
    if heard.problem == "bus_backend_missing":
        commands = (f"python -m pip install {heard.package}",)
    elif heard.interface == "socketcan" and heard.problem in {"bus_down", "bus_gone"}:
        commands = (f"sudo ip link set {heard.channel} up type can bitrate 1000000 restart-ms 100",)
        remedies = () if heard.problem == "bus_gone" else switched_on(heard.channel)
    elif heard.problem == "bus_permission":
        commands = (_UDEV_RULE, "sudo udevadm control --reload && sudo udevadm trigger")
        port = heard.channel.removeprefix("/dev/")
        remedies = () if port == heard.channel else (("remember", port),)
    return _PROBLEMS.get(heard.problem, BUS_FAILED)(*commands, **params).mended_by(*remedies)


def _no_arm(heard: HeardFacts, base: dict[str, str]) -> Diagnosis:
    if _is_leader(heard):
        ids = heard.shifted_feedback or tuple(each.arbitration_id for each in heard.other_hosts)
        return TEACHING_INPUT(*_end_teaching_input(heard), **base, ids=_ids(ids))
    if heard.frames:
        return NO_ARM(**base, ids=_ids(heard.unknown_ids))
    commands = (
        (f"ip -details -statistics link show {heard.channel}",)
        if heard.interface == "socketcan"
        else ()
    )
    if not has_wire(heard.interface, heard.channel):
        return NOTHING_HEARD(*commands, **base)
    if heard.asked and not heard.error_frames:
        return BUS_DEAF(*commands, **base)
    return NOTHING_HEARD(*commands, *(() if heard.asked else _ask(heard)), **base)


def judge_arm(arm: ArmFacts, heard: HeardFacts) -> list[Diagnosis]:
    """Return the findings on an arm whose feedback is heard."""
    params = {
        "device": _name(heard),
        "generation": str(arm.generation),
        "reason": arm.reason,
        "rate": f"{arm.frames_per_s:.0f}",
        "offset": f"0x{arm.feedback_offset:02X}",
        "firmware": arm.firmware or "",
        "identity": f" ({', '.join(arm.identity)})" if arm.identity else "",
    }
    findings = [ARM(**params), *_firmware(arm, heard, params)]
    findings += _model(arm, params)
    if arm.feedback_offset:
        findings.append(OFFSET(**params))
    if arm.teaching_input:
        found = TEACHING_INPUT(*_end_teaching_input(heard), **params, ids="0x2A1")
        findings.append(replace(found, severity=DiagnosisLevel.WARNING))
    findings += _status(arm, params)
    findings += _drivers(arm, params)
    findings += _feedback(arm, heard, params)
    damaged = [str(each.joint) for each in arm.limits if _is_damaged(each)]
    if damaged:
        commands = _send(heard, 0x477, "0002000000000000")
        findings.append(LIMITS_DAMAGED(*commands, **params, joints=", ".join(damaged)))
    return findings


def _firmware(arm: ArmFacts, heard: HeardFacts, params: dict[str, str]) -> list[Diagnosis]:
    if arm.firmware is None:
        if arm.generation == 1:
            return []
        return [FIRMWARE_UNKNOWN(*_ask(heard), **params)]
    version = FirmwareVersion.parse(arm.firmware)
    findings = [FIRMWARE(**params)]
    if version is not None and version < RECOMMENDED:
        findings.append(FIRMWARE_OLD(**params))
    if version is not None and FirmwareBug.FEEDBACK_PARTS in quirks_of(version).bugs:
        findings.append(REFERENCE_LOST(**params))
    return findings


def _model(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    """Return the finding on the arm's model by its pose; none while it moves, as nothing fits."""
    if not arm.models:
        return []
    names = {**params, "fits": ", ".join(arm.models)}
    if arm.chosen_model is not None and arm.chosen_model not in arm.models:
        names["chosen"] = arm.chosen_model
        return [MODEL_OTHER(**names)]
    return [MODEL(**names)]


def _status(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    if arm.status_code is None:
        return [STATUS_SILENT(**params)]
    findings: list[Diagnosis] = []
    status = {**params, "status": f"0x{arm.status_code:02X} {arm.status_word}".strip()}
    if arm.status_code == _EMERGENCY_STOP:
        findings.append(STOPPED(**status))
    elif arm.status_code != _NORMAL:
        findings.append(STATUS(**status))
    if arm.mode_word and arm.mode_word not in _USUAL_MODES:
        findings.append(UNUSUAL_MODE(**params, mode=arm.mode_word))
    return findings


def _drivers(arm: ArmFacts, params: dict[str, str]) -> list[Diagnosis]:
    findings: list[Diagnosis] = []
    if arm.unreachable:
        joints = ", ".join(map(str, arm.unreachable))
        findings.append(JOINTS_UNREACHABLE(**params, joints=joints))
    if arm.beyond_limit:
        joints = ", ".join(map(str, arm.beyond_limit))
        findings.append(JOINTS_BEYOND_LIMIT(**params, joints=joints))
    if arm.driver_faults:
        faults = ", ".join(f"J{joint}: {fault}" for joint, fault in arm.driver_faults)
        findings.append(DRIVER_FAULTS(**params, faults=faults))
    if arm.lowest_voltage is not None and 0 < arm.lowest_voltage < _LOW_V:
        findings.append(VOLTAGE_LOW(**params, voltage=f"{arm.lowest_voltage:.1f}"))
    return findings


def _feedback(arm: ArmFacts, heard: HeardFacts, params: dict[str, str]) -> list[Diagnosis]:
    """Return the findings on angles and a pose that cannot be true, or are easily misread."""
    findings: list[Diagnosis] = []
    if _all_zero(arm) or (arm.teaching is not None and _SILENT_BY_TEACHING_LEVEL in arm.teaching):
        commands = _mend_teaching(arm.teaching, heard) if arm.generation == 2 else ()
        findings.append(FEEDBACK_ZERO(*commands, **params))
    tilt = arm.pose[4]
    if tilt is not None and abs(tilt) > _TILT_DEG:
        findings.append(EULER_EDGE(**params, ry=f"{tilt:.1f}"))
    return findings


def _mend_teaching(
    teaching: tuple[float, float, float] | None, heard: HeardFacts
) -> tuple[str, ...]:
    """Return the command for 0x47D with friction level 1, the other two values left as they are."""
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
    """Return whether the end pose is all zero: no pose of this arm is."""
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
    """Return the command for 0x470 that makes the arm a motion output after a power cycle."""
    return _send(heard, 0x470, "FC00000000000000")


def _restart(heard: HeardFacts) -> tuple[str, ...]:
    if heard.interface != "socketcan":
        return ()
    return (f"sudo ip link set {heard.channel} type can restart",)


def _send(heard: HeardFacts, arbitration_id: int, data: str) -> tuple[str, ...]:
    """Return a command that sends one frame by hand."""
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
