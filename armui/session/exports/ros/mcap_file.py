"""The MCAP file."""

from __future__ import annotations

from typing import TYPE_CHECKING, BinaryIO, Final

import numpy as np
from mcap.writer import Writer

from armui import __version__
from armui.session.exports.ros.diagnostics import DiagnosticStream
from armui.session.exports.ros.schemas import definition, full_name
from armui.session.exports.ros.streams import make_streams
from armui.session.exports.sink import TimeSpan

if TYPE_CHECKING:
    from armui.session.exports.history import History
    from armui.session.exports.ros.streams import Stream
    from armui.session.exports.sink import ExportFacts

_LATEST_S: Final = float(2**31 - 1)
"""Of a ROS time stamp, whose seconds have 32 bits; before 0 there is none."""


class McapFile:
    """Writes the messages as they come.

    Args:
        stream: Where to.
        facts: Of the recorded arm.

    Attributes:
        items: Messages written so far.
        without_stamp: Frames of the log whose time no ROS time stamp can tell.
    """

    def __init__(self, stream: BinaryIO, facts: ExportFacts) -> None:
        self._streams: list[Stream] = [*make_streams(facts), DiagnosticStream(facts)]
        self._channels: dict[str, int] = {}
        self._schemas: dict[str, int] = {}
        self._counts: dict[int, int] = {}
        self._writer = Writer(stream)
        self._writer.start(profile="ros2", library=f"armui {__version__}")
        self._writer.add_metadata("armui", dict(facts.notes))
        self.items = 0
        self.without_stamp = 0

    def take(self, history: History, span: TimeSpan) -> None:
        """Write what a piece of the log adds, see `Sink`."""
        span = TimeSpan(max(span.begin_s, 0.0), min(span.end_s, _LATEST_S))
        in_ros = TimeSpan(0.0, _LATEST_S).holds(history.frames.times_s)
        self.without_stamp += int(np.count_nonzero(~in_ros))
        found = []
        for stream in self._streams:
            messages = stream.messages(history, span)
            if messages is None:
                continue
            channel = self._channel(stream)
            rows, times_ns, data = messages
            found += [
                (row, channel, time_ns, each)
                for row, time_ns, each in zip(rows, times_ns, data, strict=True)
            ]
        found.sort(key=lambda each: each[0])
        add, counts = self._writer.add_message, self._counts
        for _row, channel, time_ns, each in found:
            counts[channel] += 1
            add(channel, time_ns, each, time_ns, counts[channel])
        self.items += len(found)

    def finish(self) -> None:
        """Write the file's summary."""
        self._writer.finish()  # type: ignore[no-untyped-call]

    def abandon(self) -> None:
        """Nothing is held but memory."""

    def _channel(self, stream: Stream) -> int:
        if stream.topic not in self._channels:
            if stream.schema not in self._schemas:
                self._schemas[stream.schema] = self._writer.register_schema(
                    full_name(stream.schema), "ros2msg", definition(stream.schema).encode()
                )
            channel = self._writer.register_channel(
                stream.topic, "cdr", self._schemas[stream.schema]
            )
            self._channels[stream.topic] = channel
            self._counts[channel] = 0
        return self._channels[stream.topic]
