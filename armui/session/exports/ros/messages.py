"""The messages of all topics that a piece of a log adds, and the definitions of their types."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.session.exports.history import TimeSpan
from armui.session.exports.ros.cdr import CdrWriter
from armui.session.exports.ros.diagnostics import DiagnosticStream
from armui.session.exports.ros.streams import FixedStream, make_streams

if TYPE_CHECKING:
    from armui.session.exports.history import ExportFacts, History
    from armui.session.exports.ros.streams import Stream

# The definitions of the ROS 2 messages that are written, as MCAP and Foxglove want them.
#
# Fields as in the packages sensor_msgs, geometry_msgs, tf2_msgs, diagnostic_msgs, rcl_interfaces,
# std_msgs and builtin_interfaces of ROS 2, all of which are the same from Foxy to Rolling; without
# comments.

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
    "rcl_interfaces/Log": (
        "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\n"
        "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\n"
        "string function\nuint32 line"
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


def log_message(time_ns: int, level: int, text: str) -> bytes:
    """Return a rcl_interfaces/Log of this program; the level is one of its constants."""
    writer = CdrWriter()
    writer.time(time_ns)
    writer.int8(level)
    for words in ("armui", text, "", ""):
        writer.text(words)
    writer.count(0)
    return writer.data


class RosMessage(NamedTuple):
    """One message.

    Attributes:
        row: The number of the frame from which it was made.
        stream: The stream that made it.
        time_ns: The frame's time as recorded.
        data: The message as CDR.
    """

    row: int
    stream: Stream
    time_ns: int
    data: bytes


class RosMessages:
    """Makes the messages of all topics.

    Args:
        facts: The facts on the arm.

    Attributes:
        streams: That of each topic.
        without_stamp: The number of frames whose time no ROS time stamp can hold.
    """

    def __init__(self, facts: ExportFacts) -> None:
        self._facts = facts
        self.streams: list[Stream] = [*make_streams(facts), DiagnosticStream(facts)]
        self.without_stamp = 0

    def repeat_fixed(self) -> None:
        """Have the next piece repeat the transforms of the parts that never move."""
        moving = [each for each in self.streams if not isinstance(each, FixedStream)]
        self.streams = [FixedStream(self._facts), *moving]

    def of_piece(self, history: History, span: TimeSpan) -> list[RosMessage]:
        """Return the messages that a piece adds, in the order of its frames; see `Sink`."""
        span = TimeSpan(max(span.begin_s, 0.0), min(span.end_s, _LATEST_S))
        in_ros = TimeSpan(0.0, _LATEST_S).holds(history.frames.times_s)
        self.without_stamp += int(np.count_nonzero(~in_ros))
        found = []
        for stream in self.streams:
            messages = stream.messages(history, span)
            if messages is not None:
                found += [
                    RosMessage(row, stream, time_ns, each)
                    for row, time_ns, each in zip(*messages, strict=True)
                ]
        found.sort(key=lambda each: each.row)
        return found
