"""The command line of `armui decode`."""

from __future__ import annotations

import os
import shutil
import stat
import sys
import tempfile
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from armui.decode.entries import FrameKind, LogFrame, NotALogError, Unreadable
from armui.decode.lines import json_line, text_line
from armui.decode.logs import read_log
from armui.protocol.codec import Codec
from armui.protocol.detect import GenerationDetector
from armui.protocol.generation import Generation
from armui.system.error_text import error_text

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

    from armui.protocol.detect import GenerationVerdict

EXIT_COMPLETE = 0
"""Every frame of the log was read; unknown frames are no failure."""
EXIT_INCOMPLETE = 1
"""The log was read but for some lines, or up to where it breaks off."""
EXIT_NO_LOG = 2
"""The file cannot be opened or is no log."""
EXIT_INTERRUPTED = 130
"""Stopped with Ctrl-C."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the command's arguments; `run` takes what the parser makes of them."""
    parser.description = "Print a recorded CAN log, one line a frame, with signals and units."
    parser.epilog = (
        "Exit code: 0 all read, 1 some lines could not be read (numbered on the error output), "
        "2 the file is no log."
    )
    parser.add_argument(
        "file", type=Path, help="log: .log (candump -L), .asc, .blf, .trc or .csv, also with .gz"
    )
    parser.add_argument(
        "--generation",
        choices=("1", "2", "auto"),
        default="auto",
        help="protocol of the recorded arm; auto looks for evidence in the log (default)",
    )
    parser.add_argument("--json", action="store_true", help="one JSON object a line")


def run(options: argparse.Namespace) -> int:
    """Decodes a log to the standard output.

    Args:
        options: `file`, `generation` and `json`, as `add_arguments` declares them.

    Returns:
        The exit code: 0 complete, 1 some places of the log could not be read, 2 no log.
    """
    path = Path(options.file)
    try:
        if options.generation == "auto":
            with _rereadable(path) as log:
                verdict = _detect(log)
                _complain(path, f"read as generation {int(verdict.generation)}: {verdict.reason}")
                return _decode(path, log, verdict.generation, as_json=options.json)
        return _decode(path, path, Generation(int(options.generation)), as_json=options.json)
    except NotALogError as error:
        _complain(path, str(error))
        return EXIT_NO_LOG
    except BrokenPipeError:
        # The reader of the output, such as head, has seen enough.
        _detach_output()
        return EXIT_COMPLETE
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED


def _decode(path: Path, log: Path, generation: Generation, *, as_json: bool) -> int:
    codec = Codec(generation)
    line = json_line if as_json else text_line
    exit_code = EXIT_COMPLETE
    with closing(read_log(log)) as entries:
        for entry in entries:
            if isinstance(entry, Unreadable):
                _complain(path, f"{entry.place} cannot be read: {entry.reason}")
                exit_code = EXIT_INCOMPLETE
            else:
                sys.stdout.write(line(entry, codec) + "\n")
    sys.stdout.flush()
    return exit_code


def _detect(log: Path) -> GenerationVerdict:
    """Reads the log until its generation is certain, or to its end."""
    detector = GenerationDetector()
    with closing(read_log(log)) as entries:
        for entry in entries:
            if isinstance(entry, LogFrame) and entry.kind is FrameKind.DATA:
                detector.feed(entry.frame, entry.time_s)
            if detector.certain:
                break
    return detector.verdict()


@contextmanager
def _rereadable(path: Path) -> Iterator[Path]:
    """A path to the same bytes that can be read twice: pipes are copied to a temporary file."""
    try:
        is_pipe = stat.S_ISFIFO(path.stat().st_mode)
    except OSError:
        is_pipe = False  # opening it will tell what is wrong
    if not is_pipe:
        yield path
        return
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / path.name
        try:
            with path.open("rb") as source, copy.open("wb") as target:
                shutil.copyfileobj(source, target)
        except OSError as error:
            raise NotALogError(error_text(error)) from error
        yield copy


def _complain(path: Path, text: str) -> None:
    # What is already decoded comes first where both outputs meet in one terminal.
    sys.stdout.flush()
    sys.stderr.write(f"armui decode: {path}: {text}\n")


def _detach_output() -> None:
    """Keeps the interpreter from failing once more when it flushes the closed output at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)
