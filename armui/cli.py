"""The command line: the program itself, and the commands in the table below."""

from __future__ import annotations

import argparse
import importlib
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from armui import __version__
from armui.system.command_line import (
    CommandParser,
    add_device,
    add_joints,
    add_language,
    has_display,
    list_names,
    no_version,
    say,
    with_output,
)
from armui.system.end_signals import end_at_once_on_ctrl_c, ignore_from_now_on, interrupting
from armui.system.files import NO_STANDARD_INPUT, error_text, is_standard_input, open_file

_SIGNALLED: Final = 128
"""The number a shell adds to that of the signal that ended a command."""
_COMMANDS: Final = {
    "api": ("armui.interface.api_command", "say what the local interface offers to programs"),
    "decode": ("armui.decode", "print a recorded CAN log frame by frame, in words and units"),
    "doctor": ("armui.doctor", "say what is wrong with this computer, the bus and the arm"),
    "export": ("armui.export", "write a recorded CAN log as MCAP, CSV or Parquet"),
    "mcp": ("armui.interface.mcp_command", "serve the local interface to a language model"),
    "record": ("armui.record", "record what is on a bus to files, without a window"),
    "sim": ("armui.sim.sim_command", "run the simulated arm on a CAN bus until Ctrl-C"),
}
"""The module of each command, with ``add_arguments(parser)`` and ``run(options)``, and its purpose.

They are imported only when used: the window starts without them.
"""
_REPLAY: Final = "show a recorded CAN log in the window, as if it were live"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command.

    Returns:
        The exit code: 0 for success, 2 if the command could not begin, 128 plus the signal's number
        if a signal ended it.
    """
    if arguments is None:
        end_at_once_on_ctrl_c()
    words = list(sys.argv[1:] if arguments is None else arguments)
    if words and words[0] in _COMMANDS:
        code = with_output(f"armui {words[0]}", lambda: _run_command(words[0], words[1:]))
        if arguments is None:
            ignore_from_now_on()
        return code
    parser, asked = _parser(), words
    if words and words[0] == "replay":
        parser, asked = _replay_parser(), words[1:]
    if not {"-h", "--help", "--version"} & set(words):  # the window needs no standard output
        return _run_window(parser, parser.parse_args(asked))
    return with_output("armui", lambda: _run_window(parser, parser.parse_args(asked)))


def _run_command(name: str, words: Sequence[str]) -> int:
    module = importlib.import_module(_COMMANDS[name][0])
    parser = _command_parser(name)
    options = parser.parse_args(words)
    if getattr(options, "api_on", False):
        module = importlib.import_module("armui.headless")
    heard: list[int] = []
    try:
        with interrupting() as heard:
            code: int = module.run(options)
    except KeyboardInterrupt:
        return _SIGNALLED + (heard[-1] if heard else signal.SIGINT)
    return code


def _command_parser(name: str) -> CommandParser:
    module_name, purpose = _COMMANDS[name]
    parser = CommandParser(f"armui {name}", description=purpose)
    importlib.import_module(module_name).add_arguments(parser)
    return parser


def parsers() -> list[CommandParser]:
    """Return what reads the command line of the window, of a replay, and of each command."""
    return [_parser(), _replay_parser(), *map(_command_parser, _COMMANDS)]


def _run_window(parser: CommandParser, options: argparse.Namespace) -> int:
    if (options.interface is None) != (options.channel is None):
        parser.error("--interface and --channel go together")
    if options.sim and options.interface is not None:
        parser.error("--sim is a device of its own: leave out --interface")
    if options.generation is not None and not options.sim:
        parser.error("--generation belongs to --sim: a real arm says for itself which it is")
    if options.firmware is not None and (not options.sim or options.generation == 1):
        parser.error("--firmware belongs to --sim in generation 2: a real arm tells its own")
    if options.joints is not None and not options.sim:
        parser.error("--joints belongs to --sim: a real arm says for itself how it lies")
    log = getattr(options, "replay", None)
    if log is not None and (problem := _why_no_log(log)):
        print(f"armui replay: {log}: {problem}", file=sys.stderr)
        return 2
    file = getattr(options, "file", None)
    if file is not None and not file.is_file():
        parser.error(
            say("{file!r} is neither a file nor a command: see armui --help", file=str(file))
        )
    if not has_display():
        print(
            "armui:",
            say(
                "no display found. Start it in a desktop session, or set DISPLAY or "
                "WAYLAND_DISPLAY. `armui doctor` tells more."
            ),
            file=sys.stderr,
        )
        return 2
    try:
        from armui import app  # noqa: PLC0415 - Qt is loaded only for the window
        from armui.start import StartOptions  # noqa: PLC0415 - needs packages that may be missing
    except ImportError as error:  # a package, or a system library that Qt wants
        print(
            "armui:",
            say(
                "the window cannot be loaded: {error}. `armui doctor` says what is missing, and "
                "how to install it.",
                error=error,
            ),
            file=sys.stderr,
        )
        return 2

    return app.run(
        StartOptions(
            sim_generation=(options.generation or 2) if options.sim else None,
            sim_firmware=options.firmware,
            sim_joints_deg=None if options.joints is None else tuple(options.joints),
            interface=options.interface,
            channel=options.channel,
            bitrate=options.bitrate,
            model=getattr(options, "model", None),
            replay=log,
            file=file,
            language=options.lang,
            api_on=getattr(options, "api_on", False),
            live_on=getattr(options, "live_on", False),
        )
    )


def _why_no_log(path: Path) -> str:
    """Return why a file cannot be replayed, before any window opens; "": it can be read."""
    if is_standard_input(path):
        return say(NO_STANDARD_INPUT)
    try:
        open_file(path).close()
    except OSError as error:
        return say(error_text(error))
    return ""


def _replay_parser() -> CommandParser:
    parser = CommandParser(
        "armui replay",
        description="Show a recorded CAN log, of this program or of another one, as if it were "
        "live: a window with 3D view, joints, curves and a time line. Nothing is sent.",
    )
    parser.add_argument(
        "replay", type=Path, metavar="FILE", help="the log: .blf, .asc, .log, .trc, .csv, ..."
    )
    add_language(parser, "language of the windows")
    parser.set_defaults(sim=False, generation=None, firmware=None, joints=None)
    parser.set_defaults(interface=None, channel=None, bitrate=None)
    return parser


def _version(text: str) -> str:
    from armui.protocol.firmware_version import (  # noqa: PLC0415 - Python 3.10 can't load it
        RECOMMENDED,
        FirmwareVersion,
    )

    if FirmwareVersion.parse(text) is None:
        raise no_version(text, RECOMMENDED)
    return text


def _parser() -> CommandParser:
    commands = {name: purpose for name, (_module, purpose) in _COMMANDS.items()}
    parser = CommandParser(
        "armui",
        usage="armui [OPTION ...] [FILE]\n       armui COMMAND [OPTION ...]",
        description="Host program for the AgileX PiPER arm on a CAN bus. Without a command it "
        "opens its window.",
    )
    list_names(
        parser,
        {"commands": {**commands, "replay": _REPLAY}},
        "armui COMMAND --help tells more of one.",
    )
    parser.add_argument("--version", action="version", version=f"armui {__version__}")
    parser.add_argument(
        "file",
        nargs="?",
        type=Path,
        metavar="FILE",
        help="a trajectory to open in the editor; nothing moves",
    )
    add_language(parser, "language of the windows")
    arm = parser.add_argument_group("the arm to connect to")
    add_device(arm)
    arm.add_argument(
        "--model",
        choices=("piper", "piper_h", "piper_l", "piper_x"),
        help="which arm it is (the one chosen for it the last time)",
    )
    parser.add_argument(
        "--api-on",
        action="store_true",
        help="serve the local interface for your scripts in this run; you grant what moves the arm",
    )
    parser.add_argument(
        "--live-on",
        action="store_true",
        help="serve the live stream for Foxglove in this run; nobody can send anything by it",
    )
    simulated = parser.add_argument_group("the simulated arm")
    simulated.add_argument("--sim", action="store_true", help="connect to it")
    simulated.add_argument(
        "--generation", type=int, choices=(1, 2), help="the protocol it speaks (2)"
    )
    simulated.add_argument(
        "--firmware",
        type=_version,
        metavar="VERSION",
        help="its firmware version, as S-V1.7-3 (S-V1.8-9)",
    )
    add_joints(
        simulated,
        "the angles in degrees at which it lies when it is switched on (as a real arm lies: "
        "0 -1.999 1.971 -1.412 22.11 -2.608)",
    )
    return parser
