"""`armui sim`: a simulated arm on a bus until Ctrl-C."""

from __future__ import annotations

import argparse
import sys
import threading
from typing import Any, Final

import can

from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node

EXIT_OK: Final = 0
EXIT_NO_BUS: Final = 2

_STATUS_PERIOD_S: Final = 1.0
_BITS_PER_FRAME: Final = 123
"""A standard frame of 8 bytes with the gap behind it and an average of stuffing bits."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Says which options the command takes."""
    parser.add_argument(
        "--interface", default="udp_multicast", help="python-can's name of the bus (udp_multicast)"
    )
    parser.add_argument("--channel", default="", help="the bus's channel, e.g. vcan0")
    parser.add_argument("--bitrate", type=int, help="bit/s, where the program sets it")
    parser.add_argument(
        "--generation", type=int, choices=(1, 2), default=2, help="the protocol it speaks (2)"
    )


def run(options: argparse.Namespace) -> int:
    """Runs the command with options read by `add_arguments`; returns the exit code."""
    return run_arm(options.interface, options.channel, options.bitrate, options.generation)


def run_arm(
    interface: str,
    channel: str,
    bitrate: int | None = None,
    generation: int = Generation.TWO,
    *,
    ending: threading.Event | None = None,
) -> int:
    """Runs an arm and writes a status line a second.

    Args:
        interface: A python-can interface, as `virtual`, `udp_multicast`, `socketcan`.
        channel: Its channel, as `vcan0`; empty for the interface's own choice.
        bitrate: Bits per second; None where the system has set it.
        generation: 1 or 2.
        ending: Ends the command when it is set; without it only Ctrl-C does.

    Returns:
        The exit code: 0 after Ctrl-C, 2 when the bus cannot be opened.
    """
    ending = ending or threading.Event()
    try:
        bus = can.Bus(**_bus_options(interface, channel, bitrate))
    except (can.CanError, OSError, ValueError, TypeError, ImportError) as error:
        sys.stderr.write(
            f"armui sim: cannot open {interface}:{channel or 'default channel'}: {error}. "
            "Check that the interface exists, is up and not in use.\n"
        )
        return EXIT_NO_BUS
    firmware = Firmware(Generation(generation))
    with bus, Node(firmware, bus) as node:
        sys.stdout.write(
            f"Simulated arm, generation {int(generation)}, on {bus.channel_info}. Ctrl-C ends it.\n"
        )
        try:
            _report(node, ending, bitrate or 1_000_000)
        except KeyboardInterrupt:
            sys.stdout.write("\n")
    return EXIT_OK


def _bus_options(interface: str, channel: str, bitrate: int | None) -> dict[str, Any]:
    options: dict[str, Any] = {"interface": interface}
    if channel:
        options["channel"] = channel
    if bitrate is not None:
        options["bitrate"] = bitrate
    return options


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
    """One line for the terminal: what went over the bus in the last second, how the arm is.

    Args:
        node: The running arm.
        sent: Frames sent in that second.
        received: Frames received in that second.
        load_percent: Share of the bus those frames take.
    """
    arm = node.firmware
    enabled = "".join("1" if on else "0" for on in arm.enabled)
    return (
        f"{arm.time_s:8.1f} s  sent {sent}/s  received {received}/s  load {load_percent:.0f} %  "
        f"lost {node.lost}  late {1e3 * node.worst_lateness_s:.1f} ms  "
        f"{arm.control_mode.name} {arm.status.name}  enabled {enabled}\n"
    )
