"""The command line of `armui record`."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack, closing
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Final

from armui.arm.device import DEFAULT_BITRATE, Device, bitrate_is_ours
from armui.arm.refusal import Refusal
from armui.bus.adapters import explain
from armui.record.listening import SIMULATED, BusListener, opened
from armui.session.recording.collector import Collector, FrameRing
from armui.session.recording.counted import counted, keep
from armui.session.recording.kinds import RecordingFormat, is_name, name_for, why_not_written
from armui.session.recording.lane import FrameLane
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.session_recording import SessionRecording
from armui.session.recording.writer import RecordingPlan, TimeBase
from armui.system.clock import steady_s
from armui.system.command_line import add_device, add_language, say, say_sentence
from armui.system.end_signals import handled_by, interrupting
from armui.system.files import error_text, size_text

if TYPE_CHECKING:
    import can

EXIT_OK: Final = 0
EXIT_CUT_SHORT: Final = 1
EXIT_CANNOT_BEGIN: Final = 2

_MEGABYTE: Final = 1_000_000
_TOLD_S: Final = 0.5
_END_S: Final = 10.0
_AT_ONCE_S: Final = 1.0
_LOOK_S: Final = 0.1
_KEPT_S: Final = 1.0
"""The ring is kept short, because nothing reads it."""
_LARGEST_MB: Final = 4000


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the options of the command."""
    parser.description = (
        "Record every frame on a CAN bus until Ctrl-C. Nothing is sent. What is written can be "
        "read at any moment; a kill loses the last second at most."
    )
    parser.epilog = (
        "Exit code: 0 recorded as asked; 1 cut short: the disk or the device failed, what was "
        "written is whole; 2 it could not begin."
    )
    add_device(parser)
    parser.add_argument(
        "--sim", action="store_true", help="record a simulated arm that lives in this command"
    )
    parser.add_argument(
        "--generation", type=int, choices=(1, 2), help="protocol of the simulated arm (2)"
    )
    parser.add_argument(
        "-o", "--folder", type=Path, default=Path(), help="where to (the current folder)"
    )
    parser.add_argument("--name", help="of the log (session-DATE-TIME)")
    parser.add_argument(
        "--format",
        choices=[each.value[1:] for each in RecordingFormat],
        default="blf",
        help="of the files (blf)",
    )
    parser.add_argument(
        "--size",
        type=_megabytes,
        default=100,
        metavar="MB",
        help="a file that is as large is followed by another (100)",
    )
    parser.add_argument(
        "--duration", type=_seconds, metavar="SECONDS", help="end by itself after so long"
    )
    parser.add_argument("--quiet", action="store_true", help="no progress line")
    add_language(parser, "language of the messages")


def run(options: argparse.Namespace, clock: Callable[[], float] = steady_s) -> int:
    """Runs the command with options read by `add_arguments`; returns the exit code."""
    device = _device(options)
    if device is None:
        return EXIT_CANNOT_BEGIN
    name = options.name or name_for(datetime.now().astimezone())
    if not is_name(name):
        return _cannot_begin(
            say('{name!r} is no name for a file; leave out / \\ : * ? " < > |', name=name)
        )
    ending: list[int] = []
    with handled_by(lambda number, _frame: ending.append(number)), ExitStack() as stack:
        try:
            bus = stack.enter_context(opened(device))
        except Exception as error:  # noqa: BLE001 - third-party drivers raise anything
            return _cannot_begin(
                f"{_refusal_text(explain(device, error))}\n{say('`armui doctor` tells more.')}"
            )
        return _record(bus, device, options, ending, name=name, clock=clock)


def _record(
    bus: can.BusABC,
    device: Device,
    options: argparse.Namespace,
    ending: list[int],
    *,
    name: str,
    clock: Callable[[], float],
) -> int:
    lane = FrameLane()
    collector = Collector(lane, FrameRing(_KEPT_S))
    plan = RecordingPlan(
        folder=options.folder,
        name=name,
        kind=RecordingFormat(f".{options.format}"),
        base=TimeBase(clock(), time.time()),
        rotate_bytes=options.size * _MEGABYTE,
        channel=str(device.channel),
        facts={"reason": "command", "device": device.name},
    )
    recording = SessionRecording(plan, clock)
    collector.add(recording.put)
    collector.start()
    listener = BusListener(bus, device, lane, clock)
    problem = ""
    told_s = clock()
    while not ending and recording.running:
        if options.duration is not None and clock() - recording.begun_s >= options.duration:
            break
        try:
            listener.listen()
        except Exception as error:  # noqa: BLE001 - third-party drivers raise anything
            text = error_text(error)
            problem = say("{device} is gone: {text}", device=device.name, text=text)
            break
        if clock() - told_s >= _TOLD_S and not options.quiet:
            told_s = clock()
            _print_progress(recording, lane, clock())
    facts = {"reason": problem or ("signal" if ending else "duration"), "dropped": lane.dropped}
    collector.remove(recording.put, lambda: recording.end(facts))
    collector.end()
    ended = _wait_for(recording, ending)
    code = _summary(recording, lane, problem, ended=ended, quiet=options.quiet)
    if ended and recording.frames and recording.path is not None:
        _count(recording.path)
    return code


def _wait_for(recording: SessionRecording, ending: list[int]) -> bool:
    """Wait until a recording is written; false if the disk hangs or another signal ends the wait.

    Signals that come at once with the first, as of a script that sends several, do not.
    """
    heard = len(ending)
    began_s = time.monotonic()
    while not recording.wait(_LOOK_S):
        waited_s = time.monotonic() - began_s
        if waited_s < _AT_ONCE_S:
            heard = len(ending)
        if len(ending) > heard or waited_s > _END_S:
            return False
    return True


def _count(path: Path) -> None:
    """Write the number of faults in the frames to the sidecar, for the window's list.

    A further signal cancels the counting.
    """
    try:
        with interrupting(), closing(RecordedSession(path)) as session:
            keep(path.parent, session.name, counted(session))
    except KeyboardInterrupt:
        return
    except Exception as error:  # noqa: BLE001 - the recording itself is intact
        text = say("its faults were not counted: {text}", text=error_text(error))
        sys.stderr.write(f"armui record: {text}\n")


def _summary(
    recording: SessionRecording, lane: FrameLane, problem: str, *, ended: bool, quiet: bool
) -> int:
    """Print the result of the recording; return the exit code."""
    if not quiet and sys.stderr.isatty():
        sys.stderr.write("\n")
    if recording.failure is not None:
        problem = _explained(recording)
    elif not ended:
        problem = say("the disk does not answer; its last frames may be missing")
    if problem and recording.path is None:
        return _cannot_begin(problem)
    lost = recording.lost + lane.dropped
    if lost:
        text = say("{count} frames were lost: the disk was too slow", count=lost)
        sys.stderr.write(f"armui record: {text}\n")
    if problem:
        sys.stderr.write(f"armui record: {problem}\n")
    if recording.path is not None and recording.frames:
        size = size_text(recording.total_bytes)
        text = say("{count} frames, {size}", count=recording.frames, size=size)
        sys.stdout.write(f"{recording.path}: {text}\n")
    elif not problem:
        text = say("not one frame was heard; `armui doctor` tells more")
        sys.stderr.write(f"armui record: {text}\n")
    return EXIT_CUT_SHORT if problem or lost else EXIT_OK


def _explained(recording: SessionRecording) -> str:
    folder = recording.plan.folder
    return _refusal_text(why_not_written(recording.failure or OSError("unknown"), folder))


def _refusal_text(reason: Refusal) -> str:
    return say_sentence(reason.reason, reason.params)


def _print_progress(recording: SessionRecording, lane: FrameLane, now_s: float) -> None:
    """Write the progress over the line before; nothing if the output is no terminal."""
    if not sys.stderr.isatty():
        return
    elapsed_s = now_s - recording.begun_s
    minutes, seconds = divmod(int(elapsed_s), 60)
    size = size_text(recording.total_bytes)
    lost = recording.lost + lane.dropped
    frames = say("{count} frames, {size}", count=recording.frames, size=size)
    text = f"{minutes:3d}:{seconds:02d}  {frames}"
    if lost:
        text += "  " + say("{count} lost", count=lost)
    sys.stderr.write(f"\r{text:<60}")
    sys.stderr.flush()


def _device(options: argparse.Namespace) -> Device | None:
    """Return the device to listen to, or ``None`` after printing what the options lack."""
    if options.sim:
        if options.interface is not None:
            _cannot_begin(say("--sim is a device of its own: leave out --interface"))
            return None
        generation = options.generation or 2
        channel = f"{SIMULATED}-{generation}"
        return Device("virtual", channel, None, simulated=True, generation=generation)
    if options.interface is None or options.channel is None:
        _cannot_begin(say("name the bus: --interface and --channel, or --sim"))
        return None
    channel_number = int(options.channel) if options.channel.isdigit() else options.channel
    ours = bitrate_is_ours(options.interface)
    bitrate = (options.bitrate or DEFAULT_BITRATE) if ours else None
    return Device(options.interface, channel_number, bitrate, listen_only=True)


def _cannot_begin(text: str) -> int:
    sys.stderr.write(f"armui record: {text}\n")
    return EXIT_CANNOT_BEGIN


def _megabytes(text: str) -> int:
    size = int(text) if text.isdigit() else 0
    if not 1 <= size <= _LARGEST_MB:
        raise argparse.ArgumentTypeError(
            say("{text!r} is not within 1 to {most} MB", text=text, most=_LARGEST_MB)
        )
    return size


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0.0 < seconds < float("inf"):
        raise argparse.ArgumentTypeError(say("{text!r} is no number of seconds", text=text))
    return seconds
