"""Writes the MCAP file."""

from __future__ import annotations

from typing import TYPE_CHECKING, BinaryIO, Final

import numpy as np
from mcap.writer import Writer

from armui import __version__
from armui.session.exports.history import TimeSpan
from armui.session.exports.ros.diagnostics import DiagnosticStream
from armui.session.exports.ros.streams import make_streams

if TYPE_CHECKING:
    from armui.session.exports.history import ExportFacts, History
    from armui.session.exports.ros.streams import Stream

# The definitions of the ROS 2 messages that are written, as MCAP wants them.
#
# Fields as in the packages sensor_msgs, geometry_msgs, tf2_msgs, diagnostic_msgs, std_msgs and
# builtin_interfaces of ROS 2, all of which are the same from Foxy to Rolling; without comments.

_FIELDS: Final = {
    "builtin_interfaces/Time": "int32 sec\nuint32 nanosec",
    "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id",
    "sensor_msgs/JointState": (
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
        "float64[] effort"
    ),
    "geometry_msgs/Vector3": "float64 x\nfloat64 y\nfloat64 z",
    "geometry_msgs/Point": "float64 x\nfloat64 y\nfloat64 z",
    "geometry_msgs/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w",
    "geometry_msgs/Pose": ("geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation"),
    "geometry_msgs/PoseStamped": "std_msgs/Header header\ngeometry_msgs/Pose pose",
    "geometry_msgs/Transform": (
        "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation"
    ),
    "geometry_msgs/TransformStamped": (
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform"
    ),
    "tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms",
    "diagnostic_msgs/KeyValue": "string key\nstring value",
    "diagnostic_msgs/DiagnosticStatus": (
        "byte OK=0\nbyte WARN=1\nbyte ERROR=2\nbyte STALE=3\n"
        "byte level\nstring name\nstring message\nstring hardware_id\n"
        "diagnostic_msgs/KeyValue[] values"
    ),
    "diagnostic_msgs/DiagnosticArray": (
        "std_msgs/Header header\ndiagnostic_msgs/DiagnosticStatus[] status"
    ),
}
_LINE: Final = "=" * 80

_LATEST_S: Final = float(2**31 - 1)
"""The last second of a ROS time stamp, whose seconds have 32 bits; none is before 0."""


def full_name(name: str) -> str:
    """Return the name of a message type as ROS 2 writes it: ``sensor_msgs/msg/JointState``."""
    package, _, kind = name.partition("/")
    return f"{package}/msg/{kind}"


def definition(name: str) -> str:
    """Return the definition of a message type, followed by those of the types in it.

    Args:
        name: The type's name, as ``sensor_msgs/JointState``.
    """
    parts = [f"{_LINE}\nMSG: {needed}\n{_FIELDS[needed]}\n" for needed in _needed(name)]
    return f"{_FIELDS[name]}\n{''.join(parts)}"


def _needed(name: str) -> dict[str, None]:
    """Return the types in a type, and those in them, each once."""
    found: dict[str, None] = {}
    for line in _FIELDS[name].splitlines():
        kind = line.split(" ", 1)[0].removesuffix("[]")
        if kind in _FIELDS:
            found[kind] = None
            found.update(_needed(kind))
    return found


class McapFile:
    """Writes the messages as they come.

    Args:
        stream: The output.
        facts: The facts on the recorded arm.

    Attributes:
        items: The number of messages written so far.
        without_stamp: The number of frames whose time no ROS time stamp can hold.
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

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Write the messages that a piece of the log adds; see `Sink`."""
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
