"""`armui sim`: a simulated arm on a bus until Ctrl-C."""

from __future__ import annotations

import argparse
import sys
import threading
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

import can

from armui.protocol.addressing import OFFSETS
from armui.protocol.firmware_version import RECOMMENDED, FirmwareBug, FirmwareVersion
from armui.protocol.generation import Generation, PiperModel
from armui.sim.arm_type import ArmType
from armui.sim.faults.bugs import NAMES as BUG_NAMES
from armui.sim.faults.bugs import PURPOSES
from armui.sim.faults.schedule import FAULTS, Fault, FaultError, FaultParameter, read_fault
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.sim.parameters.flash import FileFlash, Flash, MemoryFlash
from armui.system.command_line import add_joints, list_names

EXIT_OK: Final = 0
EXIT_CANNOT_BEGIN: Final = 2

_ZEROS_DEG: Final = (0.0,) * 6
_VERSION: Final = str(RECOMMENDED)
_HIGHEST_PORT: Final = 65_535
_OF_THE_VERSION: Final = "those of the version"

_STATUS_PERIOD_S: Final = 1.0
_BITS_PER_FRAME: Final = 123
"""The bits of a standard frame of 8 bytes with the gap behind it and average stuffing."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the options of the command."""
    bugs = {name: PURPOSES[bug] for name, bug in BUG_NAMES.items()}
    faults = {name: _fault_help(name) for name in FAULTS}
    list_names(parser, {"faults (--fault)": faults, "bugs (--bugs)": bugs})
    bus = parser.add_argument_group("the bus")
    bus.add_argument(
        "--interface", default="udp_multicast", help="python-can's name of the bus (udp_multicast)"
    )
    bus.add_argument("--channel", default="", help="the bus's channel, e.g. vcan0")
    bus.add_argument(
        "--port",
        type=_port,
        help="of udp_multicast: another port than python-can's own, by which other programs find "
        "the arm; two arms need two ports, for two groups on one port are one bus",
    )
    bus.add_argument("--bitrate", type=_bitrate, help="bit/s, where the program sets it")
    bus.add_argument(
        "--offset",
        type=_offset,
        help="move its feedback and motion commands by 0x10 or 0x20, for another arm on one bus",
    )
    arm = parser.add_argument_group("the arm")
    arm.add_argument(
        "--generation", type=int, choices=(1, 2), default=2, help="the protocol it speaks (2)"
    )
    arm.add_argument(
        "--firmware",
        type=_version,
        metavar="VERSION",
        help="what it answers when asked for its version, and what it does as this version does: "
        f"MIT, CPV, frames, signs, scales; generation 2 only ({_VERSION})",
    )
    arm.add_argument(
        "--model",
        type=PiperModel,
        choices=list(PiperModel),
        default=PiperModel.PIPER,
        metavar="MODEL",
        help=f"which arm of the family it is: {', '.join(PiperModel)} ({PiperModel.PIPER})",
    )
    add_joints(
        arm,
        "the angles in degrees at which it lies when it is switched on; a real arm lies at "
        "0 -1.999 1.971 -1.412 22.11 -2.608 (0 0 0 0 0 0)",
    )
    arm.add_argument(
        "--flash",
        type=_flash,
        metavar="FILE",
        help="keep its settings in this file; without it they end with the command",
    )
    api = parser.add_argument_group("the local interface, on a private bus")
    api.add_argument(
        "--api-on",
        action="store_true",
        help="serve the local interface, with the program's checks and no window: for the tests "
        "and scripts of clients",
    )
    api.add_argument(
        "--grant", action="store_true", help="grant the lease to whoever asks: nobody else is here"
    )
    api.add_argument("--socket", metavar="PATH", help="where it is served (the user's own place)")
    api.add_argument(
        "--trajectories", metavar="FOLDER", help="the library that clients see (the user's own)"
    )
    wrong = parser.add_argument_group("what goes wrong")
    wrong.add_argument(
        "--fault",
        type=_fault,
        action="append",
        default=[],
        metavar="NAME[:VALUE]@START[-END]",
        help="break something, in seconds from the start; may be given often",
    )
    wrong.add_argument(
        "--bugs",
        type=_bugs,
        nargs="?",
        const=_OF_THE_VERSION,
        default=frozenset(),
        metavar="NAME,...",
        help="have known bugs of firmware versions, to try a host's answers to them: without names "
        "those reported of its version, or all, or some of them",
    )
    wrong.add_argument(
        "--seed", type=int, default=0, help="of all that is left to chance: noise, lost frames (0)"
    )


def run(options: argparse.Namespace) -> int:
    """Runs the command with options read by `add_arguments`; returns the exit code."""
    if options.grant or options.socket or options.trajectories:
        sys.stderr.write("armui sim: --grant, --socket and --trajectories belong to --api-on\n")
        return EXIT_CANNOT_BEGIN
    if options.generation == Generation.ONE and (options.firmware is not None or options.bugs):
        sys.stderr.write(
            "armui sim: --firmware and --bugs belong to generation 2: generation 1 tells no "
            "version\n"
        )
        return EXIT_CANNOT_BEGIN
    if options.port is not None and options.interface != "udp_multicast":
        sys.stderr.write("armui sim: --port belongs to --interface udp_multicast\n")
        return EXIT_CANNOT_BEGIN
    version = options.firmware or _VERSION
    bugs = options.bugs
    if bugs == _OF_THE_VERSION:
        bugs = ArmType.of(options.model, version).quirks.bugs
        if not bugs:
            sys.stderr.write(f"armui sim: no bug of {version} is known; name some after --bugs\n")
    flash: Flash = options.flash or MemoryFlash()
    if options.offset is not None:
        settings = flash.load(options.model)
        settings.linkage = settings.linkage._replace(
            feedback_offset=options.offset, control_offset=options.offset
        )
        flash.save(settings)
    firmware = Firmware(
        Generation(options.generation),
        seed=options.seed,
        joints_deg=options.joints or _ZEROS_DEG,
        version=version,
        model=options.model,
        flash=flash,
        bugs=bugs,
    )
    return run_arm(
        firmware,
        options.interface,
        options.channel,
        options.bitrate,
        port=options.port,
        faults=options.fault,
        seed=options.seed,
    )


def run_arm(
    firmware: Firmware,
    interface: str,
    channel: str,
    bitrate: int | None = None,
    *,
    port: int | None = None,
    faults: Iterable[Fault] = (),
    seed: int = 0,
    ending: threading.Event | None = None,
) -> int:
    """Runs an arm and writes a status line every second.

    Args:
        firmware: The arm.
        interface: A python-can interface, as `virtual`, `udp_multicast`, `socketcan`.
        channel: Its channel, as `vcan0`; empty for the interface's own choice.
        bitrate: In bit/s; None if the system has set it.
        port: Of udp_multicast; None for python-can's own.
        faults: The planned faults.
        seed: The seed of random faults.
        ending: Ends the command when it is set; without it only Ctrl-C does.

    Returns:
        The exit code: 0 after Ctrl-C, 2 when the bus cannot be opened.
    """
    ending = ending or threading.Event()
    asked = {"channel": channel or None, "bitrate": bitrate, "port": port}
    options: dict[str, Any] = {name: each for name, each in asked.items() if each is not None}
    try:
        bus = can.Bus(interface=interface, **options)
    except (can.CanError, OSError, ValueError, TypeError, ImportError) as error:
        # python-can raises this class for a missing package, too
        missing = isinstance(error, ImportError | can.CanInterfaceNotImplementedError)
        advice = (
            "Install what it names with pip; python-can's name of the bus may be wrong, too."
            if missing
            else "Check that the interface exists, is up and not in use."
        )
        place = channel or "default channel"
        sys.stderr.write(f"armui sim: cannot open {interface}:{place}: {error}. {advice}\n")
        return EXIT_CANNOT_BEGIN
    known = bus.channel_info != "unknown"
    place = bus.channel_info if known else f"{interface} {channel}".rstrip()
    place = place if port is None else f"{place}, port {port}"
    if firmware.flash.problem:
        sys.stderr.write(f"armui sim: {firmware.flash.problem}\n")
    try:
        with bus, Node(firmware, bus, faults=faults, seed=seed) as node:
            generation = int(firmware.generation)
            sys.stdout.write(
                f"Simulated arm, generation {generation}, on {place}. Ctrl-C ends it.\n"
            )
            sys.stdout.flush()
            _report(node, ending, bitrate or 1_000_000)
    except KeyboardInterrupt:
        sys.stdout.write("\n")
    return EXIT_OK


def _port(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= _HIGHEST_PORT:
        raise argparse.ArgumentTypeError(f"{text!r} is no port; give 1 to {_HIGHEST_PORT}")
    return int(text)


def _bitrate(text: str) -> int:
    if not text.isdecimal() or not int(text):
        raise argparse.ArgumentTypeError(f"{text!r} is no bit rate; give bit/s, as 1000000")
    return int(text)


def _version(text: str) -> str:
    if FirmwareVersion.parse(text) is None:
        raise argparse.ArgumentTypeError(f"{text!r} is no firmware version; write it as {_VERSION}")
    return text


def _bugs(text: str) -> frozenset[FirmwareBug] | str:
    """Return the named bugs, or unchanged the word that stands for those of the version."""
    if text == _OF_THE_VERSION:
        return text
    if text == "all":
        return frozenset(FirmwareBug)
    names = text.split(",")
    unknown = [name for name in names if name not in BUG_NAMES]
    if unknown:
        raise argparse.ArgumentTypeError(
            f"no bug is called {unknown[0]!r}; there are {', '.join(BUG_NAMES)}, and all"
        )
    return frozenset(BUG_NAMES[name] for name in names)


def _flash(text: str) -> FileFlash:
    path = Path(text)
    if path.is_dir() or not path.absolute().parent.is_dir():
        raise argparse.ArgumentTypeError(f"{text!r} must be a file in a folder that exists")
    return FileFlash(path)


def _fault(text: str) -> Fault:
    try:
        return read_fault(text)
    except FaultError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _fault_help(name: str) -> str:
    kind = FAULTS[name]
    number = "" if kind.parameter is FaultParameter.NONE else f" (VALUE: {kind.parameter.meaning})"
    return f"{kind.purpose}{number}"


def _offset(text: str) -> int:
    words = {f"0x{offset:02x}": offset for offset in OFFSETS}
    try:
        return words[f"0x{int(text, 0):02x}"]
    except (KeyError, ValueError):
        raise argparse.ArgumentTypeError(f"{text!r} is none of {', '.join(words)}") from None


def _report(node: Node, ending: threading.Event, bitrate: int) -> None:
    sent = received = 0
    while not ending.wait(_STATUS_PERIOD_S):
        sent_now, received_now = node.sent, node.received
        frames = sent_now - sent + received_now - received
        load_percent = 100.0 * frames * _BITS_PER_FRAME / (bitrate * _STATUS_PERIOD_S)
        sys.stdout.write(status_line(node, sent_now - sent, received_now - received, load_percent))
        sys.stdout.flush()
        sent, received = sent_now, received_now


def status_line(node: Node, sent: int, received: int, load_percent: float) -> str:
    """Return one line for the terminal: the traffic of the last second, and the arm's state.

    Args:
        node: The running arm.
        sent: Frames sent in that second.
        received: Frames received in that second.
        load_percent: Share of the bus those frames take.
    """
    arm, now = node.firmware, node.firmware.condition
    enabled = "".join("1" if on else "0" for on in arm.enabled)
    broken = ", ".join(f"{each.name}:{each.value:g}" for each in list(node.faults.active))
    faults = f"  broken: {broken}" if broken else ""
    problem = f"  {arm.flash.problem}" if arm.flash.problem else ""
    return (
        f"{arm.time_s:8.1f} s  sent {sent}/s  received {received}/s  load {load_percent:.0f} %  "
        f"lost {node.lost}  late {1e3 * node.worst_lateness_s:.1f} ms  "
        f"{now.control_mode.name} {now.status.name}  enabled {enabled}{faults}{problem}\n"
    )
