"""Writes the MCAP file."""

from __future__ import annotations

from typing import TYPE_CHECKING, BinaryIO

from mcap.writer import Writer

from armui import __version__
from armui.session.exports.ros.messages import RosMessages, definition, full_name

if TYPE_CHECKING:
    from armui.session.exports.history import ExportFacts, History, TimeSpan
    from armui.session.exports.ros.streams import Stream


class McapFile:
    """Writes the messages as they come.

    Args:
        stream: The output.
        facts: The facts on the recorded arm.

    Attributes:
        items: The number of messages written so far.
    """

    def __init__(self, stream: BinaryIO, facts: ExportFacts) -> None:
        self._messages = RosMessages(facts)
        self._channels: dict[str, int] = {}
        self._schemas: dict[str, int] = {}
        self._counts: dict[int, int] = {}
        self._writer = Writer(stream)
        self._writer.start(profile="ros2", library=f"armui {__version__}")
        self._writer.add_metadata("armui", dict(facts.notes))
        self.items = 0

    @property
    def without_stamp(self) -> int:
        """The number of frames whose time no ROS time stamp can hold."""
        return self._messages.without_stamp

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Write the messages that a piece of the log adds; see `Sink`."""
        found = self._messages.of_piece(history, span)
        add, counts = self._writer.add_message, self._counts
        for _row, stream, time_ns, each in found:
            channel = self._channel(stream)
            counts[channel] += 1
            add(channel, time_ns, each, time_ns, counts[channel])
        self.items += len(found)

    def finish(self) -> None:
        """Write the file's summary."""
        self._writer.finish()  # type: ignore[no-untyped-call]

    def abandon(self) -> None:
        """Do nothing: only memory is held."""

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
