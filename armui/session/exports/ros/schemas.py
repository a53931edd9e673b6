"""The definitions of the ROS 2 messages that are written, as MCAP wants them.

Fields as in the packages sensor_msgs, geometry_msgs, tf2_msgs, diagnostic_msgs, std_msgs and
builtin_interfaces of ROS 2, all of which are the same from Foxy to Rolling; without comments.
"""

from __future__ import annotations

from typing import Final

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


def full_name(name: str) -> str:
    """The name of a message type as ROS 2 writes it: ``sensor_msgs/msg/JointState``."""
    package, _, kind = name.partition("/")
    return f"{package}/msg/{kind}"


def definition(name: str) -> str:
    """The definition of a message type, followed by those of the types in it.

    Args:
        name: As ``sensor_msgs/JointState``.
    """
    parts = [f"{_LINE}\nMSG: {needed}\n{_FIELDS[needed]}\n" for needed in _needed(name)]
    return f"{_FIELDS[name]}\n{''.join(parts)}"


def _needed(name: str) -> dict[str, None]:
    """The types in a type, and those in them, each once."""
    found: dict[str, None] = {}
    for line in _FIELDS[name].splitlines():
        kind = line.split(" ", 1)[0].removesuffix("[]")
        if kind in _FIELDS:
            found[kind] = None
            found.update(_needed(kind))
    return found
