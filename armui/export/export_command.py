"""The command line of `armui export`."""

from __future__ import annotations

import argparse
import json
import math
import re
import sys
import time
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Final, TextIO

from armui.protocol.generation import Generation, PiperModel
from armui.session.exports.request import (
    ArmOptions,
    EpisodeOptions,
    ExportCancelledError,
    ExportError,
    ExportFormat,
    ExportProblem,
    ExportProgress,
    ExportRequest,
    default_target,
)
from armui.session.reader import SUFFIXES
from armui.system.command_line import (
    add_generation,
    add_language,
    detach_output,
    no_version,
    say,
    say_sentence,
    write_out,
)
from armui.system.files import NO_STANDARD_INPUT, is_standard_input
from armui.system.sentence import Told

if TYPE_CHECKING:
    from armui.session.exports.request import ExportReport

_WIDTH: Final = 30
_EVERY_S: Final = 0.1

EXIT_COMPLETE = 0
"""Everything asked for was exported."""
EXIT_INCOMPLETE = 1
"""Exported except for the places of the log that cannot be read."""
EXIT_NOTHING = 2
"""Nothing was written."""
EXIT_INTERRUPTED = 130
"""Stopped with Ctrl-C; nothing was written."""


class ProgressBar:
    """A progress bar that overwrites itself; it draws only on a terminal.

    Args:
        stream: The output, usually standard error.
        clock: Monotonic time in seconds.
    """

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._shown = 0
        self._began_s = clock()
        self._drawn_s = -math.inf
        self._wanted = stream.isatty()

    def show(self, done: float | None, words: str) -> None:
        """Draw the bar again, unless it has just been drawn.

        Args:
            done: The share done, 0 to 1; ``None`` if not known.
            words: The text behind it.
        """
        now_s = self._clock()
        if not self._wanted or now_s - self._drawn_s < _EVERY_S:
            return
        self._drawn_s = now_s
        line = words
        if done is not None:
            full = round(done * _WIDTH)
            line = f"[{'#' * full}{'.' * (_WIDTH - full)}] {done:4.0%}  {words}"
            if done > 0:
                left_s = (now_s - self._began_s) * (1.0 - done) / done
                line += "  " + say("{seconds:.0f} s left", seconds=left_s)
        self._stream.write("\r" + line.ljust(self._shown))
        self._stream.flush()
        self._shown = len(line)

    def clear(self) -> None:
        """Clear the line."""
        if self._shown:
            self._stream.write("\r" + " " * self._shown + "\r")
            self._stream.flush()
            self._shown = 0


def problem_text(problem: ExportProblem, detail: str, request: ExportRequest) -> str:
    """Return the reason why nothing was written, with the remedy."""
    target = request.target
    texts: dict[ExportProblem, str] = {
        ExportProblem.NO_LOG: detail,
        ExportProblem.NO_CHANNEL: Told(
            "no frame of the channel {channel!r} near its beginning; there are: {detail}",
            channel=request.wishes.channel,
            detail=detail,
        ),
        ExportProblem.NO_FRAMES: Told("nothing to export: it has no frames; no file was written"),
        ExportProblem.NO_ARM: Told(
            "nothing to export: no frame in it is an arm's; no file was written "
            "(armui decode shows what is in it)"
        ),
        ExportProblem.NO_ANGLES: Told(
            "nothing to export: a table has a row for each set of joint angles (0x2A5-0x2A7), and "
            "none was heard; no file was written (--to mcap wants none)"
        ),
        ExportProblem.NOTHING_THEN: Told(
            "nothing to export: nothing was heard between --from and --to-time; no file was written"
        ),
        ExportProblem.EXISTS: Told(
            "{target} is there already; give another name with -o, or --force to replace it",
            target=target,
        ),
        ExportProblem.SAME_FILE: Told("the target is the log itself; give another name with -o"),
        ExportProblem.CANNOT_WRITE: Told(
            "cannot write {target}: {detail}", target=target, detail=detail
        ),
        ExportProblem.NO_PYARROW: Told(
            "Parquet needs the package pyarrow: pip install 'armui[parquet]' "
            "(CSV has the same table without it)"
        ),
        ExportProblem.NO_EPISODE: Told(
            "nothing to export: no stretch of a second in which the angles were heard and the arm "
            "told no fault; no dataset was written"
        ),
    }
    if problem is ExportProblem.EXISTS and request.format is ExportFormat.LEROBOT:
        return Told(
            "{target} is there already, and a dataset is never replaced; give another name with -o",
            target=target,
        )
    return texts[problem]


def report_lines(report: ExportReport) -> list[str]:
    """Return lines on the result and on anything noteworthy."""
    number, why = report.generation, report.why_generation
    lines: list[str] = [Told("read as generation {number}: {reason}", number=number, reason=why)]
    model, why = report.model, report.why_model
    lines.append(Told("taken for a {model}: {reason}", model=model, reason=why))
    if report.offset:
        lines.append(
            Told(
                "the arm's feedback has the identifier offset 0x{offset:02X} (0x470)",
                offset=report.offset,
            )
        )
    if report.of_other_channels:
        others = ", ".join(report.other_channels)
        lines.append(
            Told(
                "only the channel {channel} was exported; {count:,} frames of {others} were left "
                "out (--channel chooses)",
                channel=report.channel,
                count=report.of_other_channels,
                others=others,
            )
        )
    if report.not_understood:
        lines.append(
            Told(
                "{count:,} frames are none of the arm's and were left out "
                "(armui decode shows them)",
                count=report.not_understood,
            )
        )
    if report.questions:
        lines.append(
            Told(
                "{count:,} frames ask for the firmware version, as armui does when it connects; "
                "generation 1 does not answer them",
                count=report.questions,
            )
        )
    if report.without_stamp:
        lines.append(
            Told(
                "{count:,} frames have a time that no ROS time stamp can tell and were left out",
                count=report.without_stamp,
            )
        )
    lines += [say_sentence(note.reason, note.params) for note in report.notes]
    lines += [damage.text() for damage in report.damages]
    if further := report.damage_count - len(report.damages):
        lines.append(Told("{count} further places cannot be read", count=further))
    return lines


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the command's arguments, which `run` receives as parsed."""
    parser.description = (
        "Export a recorded CAN log: MCAP with ROS 2 messages, a table as CSV or Parquet, or "
        "every frame as a CSV file for each message; its episodes as a dataset of LeRobot."
    )
    parser.epilog = (
        "Exit code: 0 all exported, 1 exported but for places of the log that cannot be read "
        "(named on the error output), 2 nothing written, 130 stopped with Ctrl-C."
    )
    parser.add_argument(
        "log",
        type=Path,
        help=f"log: .log (candump -L) and whatever else python-can reads ({', '.join(SUFFIXES)}), "
        "also with .gz",
    )
    parser.add_argument(
        "--to",
        choices=[str(each) for each in ExportFormat],
        help="format (default: what the target's name says, else mcap); csv-messages makes a "
        "folder with a file for each message, lerobot one with a dataset of LeRobot; parquet and "
        "lerobot need pyarrow",
    )
    parser.add_argument(
        "-o", "--output", type=Path, help="target (default: the log's name with another ending)"
    )
    parser.add_argument(
        "--from", dest="begin", type=_seconds, default=0.0, metavar="S",
        help="from there on, in seconds from the log's first frame",
    )  # fmt: skip
    parser.add_argument(
        "--to-time", dest="end", type=_seconds, default=math.inf, metavar="S",
        help="up to there, likewise",
    )  # fmt: skip
    add_generation(parser)
    parser.add_argument(
        "--firmware", type=_version, metavar="S-V1.8-5",
        help="the arm's firmware, which says where its joints have their zeros (default: what the "
        "log tells, else what fits the end pose in it)",
    )  # fmt: skip
    parser.add_argument(
        "--model", choices=[str(each) for each in PiperModel],
        help="the arm (default: what fits the end pose in the log, else piper)",
    )  # fmt: skip
    parser.add_argument(
        "--channel", help="channel of the log (default: that on which most of an arm is heard)"
    )
    chosen = EpisodeOptions()
    parser.add_argument(
        "--fps", type=_rate, default=chosen.fps, metavar="N",
        help="of a dataset of LeRobot: frames a second, 1 to 200 (30)",
    )  # fmt: skip
    parser.add_argument(
        "--task", default=chosen.task, metavar="TEXT",
        help="of a dataset of LeRobot: what was done, where its episodes don't say it (PiPER)",
    )  # fmt: skip
    parser.add_argument("--force", action="store_true", help="replace a target that is there")
    parser.add_argument(
        "--json", action="store_true", help="progress and result as JSON, one object a line"
    )
    add_language(parser, "language of the messages")


def run(options: argparse.Namespace) -> int:
    """Exports a log.

    Args:
        options: The options declared by `add_arguments`.

    Returns:
        The exit code.
    """
    request = _request(options)
    reporter: _TextReporter = _JsonReporter() if options.json else _TextReporter(request)
    if is_standard_input(request.log):
        reporter.failed(ExportProblem.NO_LOG, NO_STANDARD_INPUT)
        return EXIT_NOTHING
    try:
        # numpy and the readers take a moment, in which --help need not wait
        from armui.session.exports.export import export_log  # noqa: PLC0415 - see above

        report = export_log(request, reporter.progress, lambda: reporter.has_reader, reporter.begun)
    except ExportError as error:
        reporter.failed(error.problem, error.detail)
        return EXIT_NOTHING
    except (ExportCancelledError, KeyboardInterrupt):
        reporter.stopped()
        return EXIT_INTERRUPTED
    reporter.done(report)
    return EXIT_INCOMPLETE if report.damage_count else EXIT_COMPLETE


def _request(options: argparse.Namespace) -> ExportRequest:
    log: Path = options.log
    output: Path | None = options.output
    if options.to is not None:
        export_format = ExportFormat(options.to)
    else:
        ending = "" if output is None else output.suffix.lower().removeprefix(".")
        export_format = ExportFormat(ending) if ending in set(ExportFormat) else ExportFormat.MCAP
    generation = None if options.generation == "auto" else Generation(int(options.generation))
    return ExportRequest(
        log,
        output or default_target(log, export_format),
        export_format,
        options.begin,
        options.end,
        ArmOptions(
            generation,
            options.firmware,
            options.channel,
            None if options.model is None else PiperModel(options.model),
        ),
        options.force,
        EpisodeOptions(options.fps, options.task),
    )


class _TextReporter:
    """Reports the export as text for people.

    Attributes:
        has_reader: True until the reader of the output has gone.
    """

    def __init__(self, request: ExportRequest) -> None:
        self._request = request
        self._bar = ProgressBar(sys.stderr)
        self.has_reader = True

    def begun(self, unfinished: Path) -> None:
        """Do nothing: the name of the unfinished file is not needed here."""

    def progress(self, progress: ExportProgress) -> None:
        self._bar.show(progress.done, say("{count:,} frames", count=progress.frames))

    def failed(self, problem: ExportProblem, detail: str) -> None:
        self._complain(problem_text(problem, detail, self._request))

    def stopped(self) -> None:
        self._complain(Told("stopped; nothing was written"))

    def done(self, report: ExportReport) -> None:
        for text in report_lines(report):
            self._complain(text)
        text = Told("{target}: {count:,} rows", target=self._request.target, count=report.items)
        if self._request.format is ExportFormat.MCAP:
            text = Told("{target}: {count:,} messages", **text.figures)
        elif self._request.format is ExportFormat.LEROBOT:
            text = Told("{target}: {count:,} frames", **text.figures)
        sys.stdout.write(f"{say(text)}\n")

    def _complain(self, text: str) -> None:
        self._bar.clear()
        sys.stderr.write(f"armui export: {self._request.log}: {say(text)}\n")


_TELL_EVERY_S: Final = 0.1


class _JsonReporter(_TextReporter):
    """Reports the export as lines of JSON, for the window and for scripts."""

    def __init__(self) -> None:
        self.has_reader = True
        self._reported_s = -math.inf

    def begun(self, unfinished: Path) -> None:
        self._write({"unfinished": str(unfinished)})

    def progress(self, progress: ExportProgress) -> None:
        now_s = time.monotonic()
        if now_s - self._reported_s >= _TELL_EVERY_S:
            self._reported_s = now_s
            self._write({"done": progress.done, "frames": progress.frames})

    def failed(self, problem: ExportProblem, detail: str) -> None:
        self._write({"problem": str(problem), "detail": say(detail)})

    def stopped(self) -> None:
        self._write({"problem": "stopped", "detail": ""})

    def done(self, report: ExportReport) -> None:
        self._write({"report": asdict(report)})

    def _write(self, line: dict[str, object]) -> None:
        if not self.has_reader:
            return
        try:
            write_out(json.dumps(line) + "\n")
        except BrokenPipeError:  # the window that asked for it is gone
            self.has_reader = False
            detach_output()


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not (math.isfinite(seconds) and seconds >= 0.0):
        raise argparse.ArgumentTypeError(
            say("{text!r} is no number of seconds, 0 or more", text=text)
        )
    return seconds


def _rate(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 1 <= int(text) <= 200):
        raise argparse.ArgumentTypeError(
            say("{text!r} is no rate of 1 to 200 frames a second", text=text)
        )
    return int(text)


def _version(text: str) -> str:
    if not re.fullmatch(r"S-V\d+\.\d+-\d+", text):
        raise no_version(text, "S-V1.8-5")
    return text
