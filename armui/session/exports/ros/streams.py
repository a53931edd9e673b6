"""The messages of each topic but the diagnostics: joint states, targets, poses, transforms."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final, NamedTuple, Protocol

import numpy as np

from armui.protocol.codes import DEGREES_PER
from armui.session.exports.export_columns import TIME_BASE, RowTimes, table_rows
from armui.session.exports.ros.cdr import CdrTemplate, CdrWriter
from armui.session.log_model import ANGLES, END_POSE, joint_signals

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from armui.kinematics.geometry import Geometry
    from armui.protocol.codec import Codec
    from armui.session.exports.history import ExportFacts, History, TimeSpan

# Where each link of the arm is in the one before it, as ROS has it: metres and quaternions.
#
# The frames are those of the robot descriptions in `urdf/`, from the maker's modified DH tables:
# joint n turns about the Z axis of link n.

BASE: Final = "base_link"
FLANGE: Final = "flange"
LINKS: Final = tuple(f"link{joint}" for joint in range(1, 7))
"""The names of the links that the joints turn."""
JOINT_NAMES: Final = tuple(f"joint{joint}" for joint in range(1, 7))
FINGERS: Final = ("finger_left", "finger_right")
FINGER_JOINTS: Final = ("gripper_left", "gripper_right")
GRIPPER_BASE: Final = "gripper_base"
_MM_PER_M: Final = 1000.0

_US_PER_S: Final = 1_000_000
_NS_PER_US: Final = 1_000


def link_transforms(geometry: Geometry, joints_deg: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (n, 6, 7): each link's x, y, z in m and quaternion x, y, z, w in the link before.

    Args:
        geometry: The arm's geometry.
        joints_deg: (n, 6) joint angles.
    """
    along_x, turns_deg, along_z, zeros_deg = np.array(geometry.rows).T
    half = np.radians(joints_deg + zeros_deg) / 2.0
    turned = np.radians(turns_deg) / 2.0
    cos_x, sin_x = np.cos(turned), np.sin(turned)
    cos_z, sin_z = np.cos(half), np.sin(half)
    along_z = along_z / _MM_PER_M
    result = np.empty((*joints_deg.shape, 7))
    result[..., 0] = along_x / _MM_PER_M
    result[..., 1] = -along_z * np.sin(2.0 * turned)
    result[..., 2] = along_z * np.cos(2.0 * turned)
    result[..., 3] = sin_x * cos_z
    result[..., 4] = -sin_x * sin_z
    result[..., 5] = cos_x * sin_z
    result[..., 6] = cos_x * cos_z
    return result


def mounted_transforms(gripper_turned_deg: float) -> NDArray[np.float64]:
    """Return (1, 2, 7): the flange in link 6, and the gripper in the flange, turned about its Z."""
    result = np.zeros((1, 2, 7))
    result[..., 6] = 1.0
    half_rad = np.radians(gripper_turned_deg) / 2.0
    result[0, 1, 5:] = np.sin(half_rad), np.cos(half_rad)
    return result


def finger_transforms(openings_mm: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (n, 2, 7): the fingers in the gripper, each half the opening from its middle."""
    result = np.zeros((len(openings_mm), 2, 7))
    result[:, 0, 1] = openings_mm / 2.0 / _MM_PER_M
    result[:, 1, 1] = -result[:, 0, 1]
    result[..., 6] = 1.0
    return result


def pose_figures(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (n, 7): x, y, z in m and the quaternion of (n, 6) poses in mm and °, R = Rz·Ry·Rx."""
    half = np.radians(poses[:, 3:]) / 2.0
    (cx, cy, cz), (sx, sy, sz) = np.cos(half).T, np.sin(half).T
    result = np.empty((len(poses), 7))
    result[:, :3] = poses[:, :3] / _MM_PER_M
    result[:, 3] = sx * cy * cz - cx * sy * sz
    result[:, 4] = cx * sy * cz + sx * cy * sz
    result[:, 5] = cx * cy * sz - sx * sy * cz
    result[:, 6] = cx * cy * cz + sx * sy * sz
    return result


class TimedMessages(NamedTuple):
    """Messages of one topic.

    Attributes:
        rows: The number of the frame from which each was made, ascending.
        times_ns: The frame's time as recorded.
        data: The messages as CDR.
    """

    rows: list[int]
    times_ns: list[int]
    data: list[bytes]


class Stream(Protocol):
    """Makes the messages of one topic.

    Attributes:
        topic: Its name.
        schema: The type of its messages, as ``sensor_msgs/JointState``.
    """

    topic: str
    schema: str

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds, or ``None``; see `Sink.write_span`."""


def nanoseconds(times_s: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return times in whole nanoseconds, rounded to microseconds: no log's clock is finer."""
    return np.rint(times_s * _US_PER_S).astype(np.int64) * _NS_PER_US


def signals_at(
    history: History, at: RowTimes, wanted: Sequence[tuple[str, str]]
) -> NDArray[np.float64]:
    """Return (n, m) values of m signals as last heard at n frames; NaN for values too old."""
    values = np.full((len(at.rows), len(wanted)), np.nan)
    for place, (message, signal) in enumerate(wanted):
        samples = history.samples(message)
        if samples is not None:
            last, fresh = samples.fresh_at(at.rows, at.times_s)
            column = samples.column(signal).astype(np.float64)
            values[:, place] = np.where(fresh, column[last], np.nan)
    return values


def _whole(figures: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Mark the rows without a missing figure (NaN)."""
    return np.asarray(~np.isnan(figures).any(axis=1), np.bool_)


def _only(at: RowTimes, keep: NDArray[np.bool_]) -> RowTimes:
    return RowTimes(at.rows[keep], at.times_s[keep])


def _timed(
    at: RowTimes, template: CdrTemplate, figures: dict[str, NDArray[np.float64]]
) -> TimedMessages:
    times_ns = nanoseconds(at.times_s)
    data = template.fill(times_ns, figures)
    return TimedMessages(at.rows.tolist(), times_ns.tolist(), data)


class JointStream:
    """`sensor_msgs/JointState` of the six joints, at each full set of angles.

    Measured values are positions and, from drivers heard within half a second, velocities;
    commanded values are positions. Efforts stay empty: the protocol has motor currents, no torques.

    Args:
        codec: The arm's codec.
        commanded: True for the targets instead of the measured values.
    """

    schema = "sensor_msgs/JointState"

    def __init__(self, codec: Codec, *, commanded: bool) -> None:
        self.topic = "/joint_commands" if commanded else "/joint_states"
        message = "JointTarget" if commanded else "JointFeedback"
        self._base = f"{message}56" if commanded else TIME_BASE
        self._angles = joint_signals(message)
        self._speeds = () if commanded else tuple((f"DriverFast{n}", "Speed") for n in range(1, 7))
        unit = codec.unit("DriverFast1", "Speed")
        self._speed_rad = math.radians(DEGREES_PER[unit])
        self._plain = _joint_template(JOINT_NAMES, with_speeds=False)
        self._moving = _joint_template(JOINT_NAMES, with_speeds=True)

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        at = table_rows(history, span, self._base)
        if at is None:
            return None
        angles = signals_at(history, at, self._angles)
        whole = _whole(angles)
        at, angles = _only(at, whole), np.radians(angles[whole])
        speeds = signals_at(history, at, self._speeds) * self._speed_rad
        known = np.zeros(len(at.rows), np.bool_)
        if self._speeds:
            known |= ~np.isnan(speeds).all(axis=1)
        plain = _timed(_only(at, ~known), self._plain, {"position": angles[~known]})
        figures = {"position": angles[known], "velocity": speeds[known]}
        moving = _timed(_only(at, known), self._moving, figures)
        return moving if not plain.rows else plain if not moving.rows else _merged(plain, moving)


class GripperStream:
    """`sensor_msgs/JointState` of the fingers: each half of the opening, in m; generation 2."""

    topic = "/gripper/joint_states"
    schema = "sensor_msgs/JointState"

    def __init__(self) -> None:
        self._template = _joint_template(FINGER_JOINTS, with_speeds=False)

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        found = _openings(history, span)
        if found is None:
            return None
        at, openings_mm = found
        halves = np.repeat(openings_mm[:, np.newaxis] / 2.0 / _MM_PER_M, 2, axis=1)
        return _timed(at, self._template, {"position": halves})


class EndPoseStream:
    """`geometry_msgs/PoseStamped` of the flange as reported by the arm (0x2A2–0x2A4)."""

    topic = "/end_pose"
    schema = "geometry_msgs/PoseStamped"

    def __init__(self) -> None:
        writer = CdrWriter()
        writer.header(0, BASE)
        writer.floats([0.0] * 7, "pose")
        self._template = CdrTemplate(writer)

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        at = table_rows(history, span, "EndPose3")
        if at is None:
            return None
        poses = signals_at(history, at, END_POSE)
        whole = _whole(poses)
        figures = {"pose": pose_figures(poses[whole])}
        return _timed(_only(at, whole), self._template, figures)


class LinkStream:
    """`tf2_msgs/TFMessage` of the six links, computed from the measured angles.

    Args:
        facts: The facts on the arm.
    """

    topic = "/tf"
    schema = "tf2_msgs/TFMessage"

    def __init__(self, facts: ExportFacts) -> None:
        self._geometry = facts.geometry
        parents = (BASE, *LINKS)
        self._template = _transform_template(list(zip(parents, LINKS, strict=False)))

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        at = table_rows(history, span)
        if at is None:
            return None
        angles = signals_at(history, at, ANGLES)
        whole = _whole(angles)
        transforms = link_transforms(self._geometry, angles[whole])
        return _timed(_only(at, whole), self._template, _by_place(transforms))


class FingerStream:
    """`tf2_msgs/TFMessage` of the two fingers; generation 2."""

    topic = "/tf"
    schema = "tf2_msgs/TFMessage"

    def __init__(self) -> None:
        self._template = _transform_template([(GRIPPER_BASE, each) for each in FINGERS])

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        found = _openings(history, span)
        if found is None:
            return None
        at, openings_mm = found
        return _timed(at, self._template, _by_place(finger_transforms(openings_mm)))


class FixedStream:
    """One `tf2_msgs/TFMessage` at the first frame: the parts mounted on link 6 never move.

    Args:
        facts: The facts on the arm.
    """

    topic = "/tf_static"
    schema = "tf2_msgs/TFMessage"

    def __init__(self, facts: ExportFacts) -> None:
        pairs = [(LINKS[-1], FLANGE), (FLANGE, GRIPPER_BASE)]
        self._mounted = mounted_transforms(facts.gripper_turned_deg)
        self._template = _transform_template(pairs)
        self._written = False

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        frames = history.frames
        inside = np.flatnonzero(span.holds(frames.times_s))[:1]
        if self._written or not len(inside) or history.samples(TIME_BASE) is None:
            return None
        self._written = True
        at = RowTimes(frames.rows[inside], frames.times_s[inside])
        return _timed(at, self._template, _by_place(self._mounted))


def make_streams(facts: ExportFacts) -> list[Stream]:
    """Return a stream for each topic of this generation, but for the diagnostics."""
    streams: list[Stream] = [
        FixedStream(facts),
        JointStream(facts.codec, commanded=False),
        LinkStream(facts),
        EndPoseStream(),
        JointStream(facts.codec, commanded=True),
    ]
    if "Opening" in facts.codec.signals("GripperFeedback"):
        streams += [GripperStream(), FingerStream()]
    return streams


def _openings(history: History, span: TimeSpan) -> tuple[RowTimes, NDArray[Any]] | None:
    samples = history.samples("GripperFeedback")
    at = table_rows(history, span, "GripperFeedback")
    if samples is None or at is None:
        return None
    openings_mm = samples.column("Opening")[samples.last_at(at.rows)]
    there = ~np.isnan(openings_mm)  # else an angle is reported, not an opening
    if not there.any():
        return None
    return RowTimes(at.rows[there], at.times_s[there]), openings_mm[there]


def _joint_template(names: Sequence[str], *, with_speeds: bool) -> CdrTemplate:
    writer = CdrWriter()
    writer.header(0, "")
    writer.texts(names)
    writer.float_sequence([0.0] * len(names), "position")
    writer.float_sequence([0.0] * len(names) if with_speeds else [], "velocity")
    writer.float_sequence([])
    return CdrTemplate(writer)


def _transform_template(pairs: Sequence[tuple[str, str]]) -> CdrTemplate:
    writer = CdrWriter()
    writer.count(len(pairs))
    for place, (parent, child) in enumerate(pairs):
        writer.header(0, parent, f"stamp{place}")
        writer.text(child)
        writer.floats([0.0] * 7, f"transform{place}")
    return CdrTemplate(writer)


def _by_place(transforms: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    return {f"transform{place}": transforms[:, place] for place in range(transforms.shape[1])}


def _merged(one: TimedMessages, other: TimedMessages) -> TimedMessages:
    """Return the messages of both, in the order of their rows."""
    rows = np.array([*one.rows, *other.rows])
    order = np.argsort(rows, kind="stable").tolist()
    times_ns, data = one.times_ns + other.times_ns, one.data + other.data
    return TimedMessages(
        rows[order].tolist(), [times_ns[each] for each in order], [data[each] for each in order]
    )
