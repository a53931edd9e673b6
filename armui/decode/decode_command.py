"""The command line of `armui decode`."""

from __future__ import annotations

import argparse
import json
import sys
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from armui.decode.lines import LineFormat
from armui.protocol.codec import Codec
from armui.protocol.detect import GenerationDetector
from armui.protocol.firmware_version import (
    RECOMMENDED,
    VERSION_ID,
    AnswerCollector,
    FirmwareVersion,
    is_question,
    quirks_of,
)
from armui.protocol.generation import Generation
from armui.session.batch_builder import LOG_NO_TIMES
from armui.session.frames import NOT_OF_THE_ARM, NotALogError
from armui.session.gripper_jumps import GRIPPER, GripperJumps
from armui.session.log_model import detect_generation, feed
from armui.session.reader import SUFFIXES, LogFile
from armui.system.command_line import (
    add_generation,
    add_language,
    no_version,
    say,
    say_sentence,
    write_out,
)
from armui.system.files import error_text
from armui.system.sentence import Told

if TYPE_CHECKING:
    from armui.session.frames import Channel, FrameBatch

_MIT_IDS = range(0x15A, 0x160)

EXIT_COMPLETE = 0
"""Every frame of the log was read; unknown frames are no failure."""
EXIT_INCOMPLETE = 1
"""The log was read except for some lines, or up to where it breaks off."""
EXIT_NO_LOG = 2
"""The file cannot be opened or is no log."""
EXIT_INTERRUPTED = 130
"""Stopped with Ctrl-C."""


class FirmwareFinder:
    """Searches batches for firmware versions.

    Attributes:
        versions: The versions by channel, in the order they were first heard.
        has_mit: True if MIT frames have passed.
    """

    def __init__(self) -> None:
        self.versions: dict[Channel, FirmwareVersion] = {}
        self.has_mit = False
        self._collectors: dict[Channel, AnswerCollector] = {}

    def feed(self, batch: FrameBatch) -> None:
        """Process the frames of a batch in their order."""
        plain = (batch.flags & NOT_OF_THE_ARM) == 0
        self.has_mit |= bool(np.isin(batch.ids[plain], _MIT_IDS).any())
        for row in np.flatnonzero(plain & (batch.ids == VERSION_ID)).tolist():
            payload = batch.data(row)
            if is_question(payload):
                continue
            channel = batch.channel_names[int(batch.channels[row])]
            collector = self._collectors.setdefault(channel, AnswerCollector())
            identity = collector.take(payload, float(batch.times_s[row]))
            version = identity and FirmwareVersion.parse(identity.software)
            if version is not None:
                self.versions[channel] = version

    @property
    def first(self) -> FirmwareVersion | None:
        """The version of the arm that named one first; ``None`` if none has."""
        return next(iter(self.versions.values()), None)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the command's arguments, which `run` receives as parsed."""
    parser.description = "Print a recorded CAN log, one line a frame, with signals and units."
    parser.epilog = (
        "Exit code: 0 all read, 1 some lines could not be read (numbered on the error output), "
        "2 the file is no log."
    )
    parser.add_argument(
        "file",
        type=Path,
        help="log: .log (candump), .csv (python-can, SavvyCAN, ZLG) and whatever else python-can "
        f"reads ({', '.join(SUFFIXES)}), also with .gz; - is the standard input",
    )
    add_generation(parser)
    parser.add_argument(
        "--firmware", type=_version, metavar=str(RECOMMENDED),
        help="the arm's firmware, which says how its MIT frames are laid out, where the log does "
        f"not tell it (default: {RECOMMENDED})",
    )  # fmt: skip
    parser.add_argument("--json", action="store_true", help="one JSON object a line")
    add_language(parser, "language of the messages")


def run(options: argparse.Namespace) -> int:
    """Decodes a log to the standard output.

    Args:
        options: `file`, `generation`, `firmware` and `json`, as `add_arguments` declares them.

    Returns:
        The exit code: 0 complete, 1 some places of the log could not be read, 2 no log.
    """
    path = Path(options.file)
    try:
        with LogFile(path, pipes=True) as log:
            return _decode(log, options.generation, options.firmware, as_json=options.json)
    except NotALogError as error:
        _complain(path, error_text(error))
        return EXIT_NO_LOG
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED


def _version(text: str) -> FirmwareVersion:
    version = FirmwareVersion.parse(text)
    if version is None:
        raise no_version(text, RECOMMENDED)
    return version


def _decode(log: LogFile, wanted: str, firmware: FirmwareVersion | None, *, as_json: bool) -> int:
    batches = log.batches()
    detector = GenerationDetector() if wanted == "auto" and log.is_pipe else None
    generation = Generation.TWO if wanted == "auto" else Generation(int(wanted))
    if wanted == "auto" and detector is None:
        looked_at, verdict = detect_generation(batches)
        generation = verdict.generation
        reason = verdict.reason
        text = Told("read as generation {number}: {reason}", number=int(generation), reason=reason)
        _complain(log.path, text)
        batches = chain(looked_at, batches)
    codec = Codec(generation, firmware=firmware)
    lines = LineFormat(codec, as_json=as_json)
    said = 0
    told = noted = 0
    layout = _Layout(log.path, firmware)
    jumps = GripperJumps()
    for batch in batches:
        if detector is not None and not detector.certain:
            # A pipe is shown as it arrives, and its beginning cannot be read again.
            feed(detector, batch)
            generation, reason = detector.verdict()
            if told != generation:
                figures = {"number": int(generation), "reason": reason}
                text = Told("read as generation {number}: {reason}", **figures)
                if told:
                    text = Told("from here on read as generation {number}: {reason}", **figures)
                _complain(log.path, text)
                told = int(generation)
                codec = Codec(generation, firmware=layout.firmware)
                lines.speak(codec)
        if generation is Generation.TWO and layout.search(batch):
            codec = Codec(generation, firmware=layout.firmware)
            lines.speak(codec)
        texts = lines.lines(batch)
        if LOG_NO_TIMES() not in log.damages.notes:
            _mark_jumps(texts, batch, codec, jumps, as_json=as_json)
        noted = _report_notes(log, noted)
        write_out("\n".join(texts) + "\n")
        said = _report_damages(log, said)
    _report_damages(log, said)
    _report_notes(log, noted)
    if log.damages.not_kept:
        further = Told("{count} further places cannot be read", count=log.damages.not_kept)
        _complain(log.path, further)
    return EXIT_INCOMPLETE if log.damages.count else EXIT_COMPLETE


def _mark_jumps(
    texts: list[str], batch: FrameBatch, codec: Codec, jumps: GripperJumps, *, as_json: bool
) -> None:
    """Mark the lines in which the gripper's reading jumps."""
    wire_id, layout = next(each for each in codec.layouts.items() if each[1].name == GRIPPER)
    own = (batch.ids == wire_id) & ((batch.flags & NOT_OF_THE_ARM) == 0)
    for index in np.unique(batch.channels[own]).tolist():
        rows = np.flatnonzero(own & (batch.channels == index))
        found = jumps.found(layout, batch.times_s[rows], batch.payloads[rows], index)
        for row, jump in [(int(rows[place]), jump) for place, jump in found]:
            text = f"from {jump.before:g} to {jump.after:g} {jump.unit} in {jump.within_ms:g} ms"
            oddity = {"oddity": {"kind": "impossible jump", "detail": text}}
            texts[row] = (
                f"{texts[row][:-1]}, {json.dumps(oddity)[1:]}"
                if as_json
                else f"{texts[row]}  (impossible jump: {text})"
            )


class _Layout:
    """The firmware whose MIT frames a log is read with: that of the log, else the one asked for."""

    def __init__(self, path: Path, asked: FirmwareVersion | None) -> None:
        self._path = path
        self._finder = FirmwareFinder()
        self._reported: dict[Channel, FirmwareVersion] = {}
        self._warned = False
        self.firmware = asked
        if asked is not None:
            _complain(
                path,
                Told(
                    "firmware {version}, as --firmware says, unless the log tells another",
                    version=asked,
                ),
            )

    def search(self, batch: FrameBatch) -> bool:
        """Search a batch and report news; return whether the firmware is another."""
        self._finder.feed(batch)
        for channel, version in self._finder.versions.items():
            if self._reported.get(channel) != version:
                self._reported[channel] = version
                self._report_version(channel, version)
        before, self.firmware = self.firmware, self._finder.first or self.firmware
        if self.firmware is None and self._finder.has_mit and not self._warned:
            self._warned = True
            _complain(
                self._path,
                Told(
                    "the log names no firmware: MIT frames are read as those of S-V1.8-8 and "
                    "later; say --firmware if the arm is older"
                ),
            )
        return before != self.firmware

    def _report_version(self, channel: Channel, version: FirmwareVersion) -> None:
        first = self._finder.first
        text = Told("firmware {version}, as the log tells", version=version)
        if first is not None and quirks_of(first).mit_layout != quirks_of(version).mit_layout:
            text = Told(
                "firmware {version} on {channel}; all MIT frames are read as those of {first}",
                version=version,
                channel=channel,
                first=first,
            )
        _complain(self._path, text)


def _report_damages(log: LogFile, said: int) -> int:
    """Print the damaged places met since the last call."""
    for damage in log.damages.since(said):
        _complain(log.path, damage.text())
    return len(log.damages)


def _report_notes(log: LogFile, said: int) -> int:
    """Print the notes on the log that are new since the last call."""
    for note in log.damages.notes[said:]:
        _complain(log.path, say_sentence(note.reason, note.params))
    return len(log.damages.notes)


def _complain(path: Path, text: str) -> None:
    # Where both outputs share a terminal, the lines decoded so far come first.
    sys.stdout.flush()
    sys.stderr.write(f"armui decode: {path}: {say(text)}\n")
