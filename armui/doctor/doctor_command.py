"""The command line of `armui doctor`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from armui.arm.refusal import Refusal
from armui.doctor.facts import CanFacts, Facts, HeardFacts, ProgramFacts, ScreenFacts
from armui.doctor.judge import an_arm_answers, judge
from armui.doctor.probes.can_devices import probe_can
from armui.doctor.probes.listening import listen
from armui.doctor.probes.program import probe_program
from armui.doctor.probes.screen import TRIALS, probe_screen
from armui.doctor.problem_report import collect, doctor_files, save
from armui.doctor.report import Words, as_json, as_text
from armui.system.command_line import add_language, say
from armui.system.files import size_text
from armui.system.plain_words import Language, language_of_system, settings_file, translation

EXIT_ARM_ANSWERS: Final = 0
EXIT_NO_ARM: Final = 1
EXIT_NO_REPORT: Final = 2

_SECONDS: Final = 2.0
_LONGEST_S: Final = 60.0
_DEFAULT_CHANNELS: Final = {"udp_multicast": "ff15:7079:7468:6f6e:6465:6d6f:6d63:6173"}
"""The channel on which `armui sim` is heard when neither command names one."""


@dataclass(frozen=True, slots=True)
class Probes:
    """The functions that examine this computer; tests replace them."""

    program: Callable[[], ProgramFacts] = probe_program
    screen: Callable[[], ScreenFacts] = probe_screen
    can: Callable[[], CanFacts] = probe_can
    hear: Callable[..., HeardFacts] = listen


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the options of the command."""
    parser.description = (
        "Look at this computer, its CAN devices and the bus, and say what is wrong, each with a "
        "command that mends it. Nothing is sent but with --ask."
    )
    parser.epilog = (
        "Exit code: 0 an arm answers, 1 none does, 2 the file of --report was not written."
    )
    parser.add_argument("--json", action="store_true", help="one JSON object instead of text")
    parser.add_argument(
        "--interface", help="python-can's name of the adapter to listen to (default: all found)"
    )
    parser.add_argument("--channel", help="the adapter's channel, e.g. can0")
    parser.add_argument("--bitrate", type=int, help="bit/s, where the program sets it (1000000)")
    parser.add_argument(
        "--ask",
        action="store_true",
        help="send questions to the arm, too: version, limits, teaching handle. They move and "
        "change nothing, but other programs on the bus see them",
    )
    parser.add_argument(
        "--seconds",
        type=_seconds,
        default=_SECONDS,
        help=f"so long each device is listened to ({_SECONDS:g})",
    )
    parser.add_argument(
        "--no-listen", action="store_true", help="leave the bus alone: open no device"
    )
    # A probe that may crash is run in a process of its own.
    parser.add_argument("--try", dest="trial", choices=sorted(TRIALS), help=argparse.SUPPRESS)
    parser.add_argument(
        "--report",
        type=Path,
        metavar="FILE.zip",
        help="keep what was found in a zip file, too, with log, settings and versions, to be sent "
        "to whoever helps; an existing file is left as it is",
    )
    add_language(parser, "language of the report")


def run(options: argparse.Namespace, probes: Probes = Probes()) -> int:
    """Runs the command with options read by `add_arguments`; returns the exit code."""
    if options.trial is not None:
        TRIALS[options.trial]()
        return 0
    facts = gather_facts(options, probes)
    findings = judge(facts)
    answers = an_arm_answers(facts)
    language: Language = options.lang or language_of_system(settings_file())
    words = Words(translation(language))
    text, json_text = (
        render(findings, words, arm_answers=answers, asked=options.ask)
        for render in (as_text, as_json)
    )
    _print_text(json_text if options.json else text)
    if options.report is not None and not _keep(options.report, text, json_text, words):
        return EXIT_NO_REPORT
    return EXIT_ARM_ANSWERS if answers else EXIT_NO_ARM


def _print_text(text: str) -> None:
    try:
        sys.stdout.write(text)
    except UnicodeEncodeError:  # a terminal that cannot show Chinese
        sys.stdout.write(text.encode("ascii", "backslashreplace").decode("ascii"))


def _keep(path: Path, text: str, json_text: str, words: Words) -> bool:
    """Write the report of a problem; return whether it was written.

    Standard output may be read as JSON, so the result is printed to standard error.
    """
    files = collect(doctor_files(text, json_text))
    saved = save(path, files)
    if isinstance(saved, Refusal):
        sys.stderr.write(f"{words.plain(saved.reason).format_map(saved.params)}\n")
        return False
    lines = [f"{saved}:", *(f"  {each.name}  {size_text(len(each.data))}" for each in files)]
    sys.stderr.write("\n".join(lines) + "\n")
    return True


def gather_facts(options: argparse.Namespace, probes: Probes) -> Facts:
    """Return every fact that the options ask for."""
    program, screen, can = probes.program(), probes.screen(), probes.can()
    heard = () if options.no_listen else _listen(options, can, probes)
    return Facts(program, screen, can, heard)


def _listen(options: argparse.Namespace, can: CanFacts, probes: Probes) -> tuple[HeardFacts, ...]:
    try:
        from armui.arm.device import DEFAULT_BITRATE, Device, bitrate_is_ours  # noqa: PLC0415
    except ImportError:  # the missing package is reported as a finding
        return ()
    down = {each.name for each in can.links if not each.up}
    if options.interface is None:
        places = [
            (each.interface, each.channel)
            for each in can.devices
            if not (each.interface == "socketcan" and each.channel in down)
        ]
    else:
        channel = options.channel or _DEFAULT_CHANNELS.get(options.interface, "")
        places = [(options.interface, channel)]
    bitrate = options.bitrate or DEFAULT_BITRATE
    return tuple(
        probes.hear(
            Device(interface, _number(channel), bitrate if bitrate_is_ours(interface) else None),
            options.seconds,
            ask=options.ask,
        )
        for interface, channel in places
    )


def _number(channel: str) -> int | str:
    """Return a channel as a number, as back-ends that count their channels want it."""
    return int(channel) if channel.isdigit() else channel


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0.1 <= seconds <= _LONGEST_S:
        raise argparse.ArgumentTypeError(
            say("{text!r} is not within 0.1 to {most:g} seconds", text=text, most=_LONGEST_S)
        )
    return seconds
