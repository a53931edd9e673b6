"""ROS where none is installed: messages of the same shape, and a node that keeps what it is given.

Fields are those of the definitions of ROS; another one cannot be set.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from types import ModuleType
from typing import Any


@dataclass(slots=True)
class Stamp:
    sec: int = 0
    nanosec: int = 0


@dataclass(slots=True)
class Header:
    stamp: Stamp = field(default_factory=Stamp)
    frame_id: str = ""


@dataclass(slots=True)
class JointState:
    header: Header = field(default_factory=Header)
    name: list[str] = field(default_factory=list)
    position: list[float] = field(default_factory=list)
    velocity: list[float] = field(default_factory=list)
    effort: list[float] = field(default_factory=list)


@dataclass(slots=True)
class KeyValue:
    key: str = ""
    value: str = ""


@dataclass(slots=True)
class DiagnosticStatus:
    level: bytes = b"\0"
    name: str = ""
    message: str = ""
    hardware_id: str = ""
    values: list[KeyValue] = field(default_factory=list)


for level, number in (("OK", b"\0"), ("WARN", b"\1"), ("ERROR", b"\2"), ("STALE", b"\3")):
    setattr(DiagnosticStatus, level, number)


@dataclass(slots=True)
class DiagnosticArray:
    header: Header = field(default_factory=Header)
    status: list[DiagnosticStatus] = field(default_factory=list)


@dataclass(slots=True)
class JointTrajectoryPoint:
    positions: list[float] = field(default_factory=list)
    velocities: list[float] = field(default_factory=list)
    accelerations: list[float] = field(default_factory=list)
    effort: list[float] = field(default_factory=list)
    time_from_start: Stamp = field(default_factory=Stamp)


@dataclass(slots=True)
class JointTrajectory:
    header: Header = field(default_factory=Header)
    joint_names: list[str] = field(default_factory=list)
    points: list[JointTrajectoryPoint] = field(default_factory=list)


@dataclass(slots=True)
class Vector3:
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0


@dataclass(slots=True)
class Quaternion:
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    w: float = 1.0


@dataclass(slots=True)
class Transform:
    translation: Vector3 = field(default_factory=Vector3)
    rotation: Quaternion = field(default_factory=Quaternion)


@dataclass(slots=True)
class TransformStamped:
    header: Header = field(default_factory=Header)
    child_frame_id: str = ""
    transform: Transform = field(default_factory=Transform)


@dataclass(slots=True)
class TFMessage:
    transforms: list[TransformStamped] = field(default_factory=list)


@dataclass(slots=True)
class JointTolerance:
    name: str = ""
    position: float = 0.0
    velocity: float = 0.0
    acceleration: float = 0.0


@dataclass(slots=True)
class Goal:
    trajectory: JointTrajectory = field(default_factory=JointTrajectory)
    path_tolerance: list[JointTolerance] = field(default_factory=list)
    goal_tolerance: list[JointTolerance] = field(default_factory=list)
    goal_time_tolerance: Stamp = field(default_factory=Stamp)


@dataclass(slots=True)
class Result:
    error_code: int = 0
    error_string: str = ""


@dataclass(slots=True)
class Feedback:
    header: Header = field(default_factory=Header)
    joint_names: list[str] = field(default_factory=list)
    desired: JointTrajectoryPoint = field(default_factory=JointTrajectoryPoint)
    actual: JointTrajectoryPoint = field(default_factory=JointTrajectoryPoint)
    error: JointTrajectoryPoint = field(default_factory=JointTrajectoryPoint)


class FollowJointTrajectory:
    Goal, Result, Feedback = Goal, Result, Feedback


@dataclass(slots=True)
class Response:
    """Of `std_srvs/Trigger` and `std_srvs/SetBool`."""

    success: bool = False
    message: str = ""


@dataclass(slots=True)
class Request:
    data: bool = False


class Moment:
    """A time or a duration of rclpy."""

    def __init__(self, *, nanoseconds: int = 0) -> None:
        self.nanoseconds = nanoseconds

    def __sub__(self, other: Moment) -> Moment:
        return Moment(nanoseconds=self.nanoseconds - other.nanoseconds)

    def to_msg(self) -> Stamp:
        return Stamp(*divmod(self.nanoseconds, 1_000_000_000))


class Publisher:
    def __init__(self) -> None:
        self.messages: list[Any] = []

    def publish(self, message: Any) -> None:
        self.messages.append(message)


class Node:
    """Keeps what it is given, and is its own clock and log.

    Attributes:
        now_s: The time of ROS.
        publishers: By their topics.
        given: What is called, by its topic, service or action.
    """

    def __init__(self, **parameters: Any) -> None:
        self.parameters = parameters
        self.now_s = 1000.0
        self.publishers: dict[str, Publisher] = {}
        self.given: dict[str, Any] = {}
        self.value: Any = None

    def declare_parameter(self, name: str, default: Any, _descriptor: object = None) -> Any:
        found = Node()
        found.value = self.parameters.get(name, default)
        return found

    def get_fully_qualified_name(self) -> str:
        return "/armui"

    def get_clock(self) -> Node:
        return self

    def now(self) -> Moment:
        return Moment(nanoseconds=round(self.now_s * 1e9))

    def get_logger(self) -> Node:
        return self

    def info(self, _text: str) -> None:
        """Nobody reads it."""

    warning = info

    def create_publisher(self, _kind: type, topic: str, _qos: object) -> Publisher:
        return self.publishers.setdefault(topic, Publisher())

    def create_subscription(self, _kind: type, topic: str, act: Any, _qos: object) -> None:
        self.given[topic] = act

    def create_service(self, _kind: type, name: str, act: Any, **_more: object) -> None:
        self.given[name] = act

    def create_timer(self, _period_s: float, _act: Any, **_more: object) -> None:
        """The status is published at each change as well."""


def action_server(node: Node, _kind: type, name: str, act: Any, **_more: object) -> None:
    node.given[name] = act


class Handle:
    """A goal of an action, as its server hands it on; `cancels` is asked whether it is over."""

    def __init__(self, request: Goal, cancels: Any = lambda: False) -> None:
        self.request = request
        self.cancels = cancels
        self.state = ""
        self.feedback: list[Feedback] = []

    @property
    def is_cancel_requested(self) -> bool:
        return bool(self.cancels())

    def publish_feedback(self, message: Feedback) -> None:
        self.feedback.append(message)

    def succeed(self) -> None:
        self.state = "succeeded"

    def abort(self) -> None:
        self.state = "aborted"

    def canceled(self) -> None:
        self.state = "canceled"


class Anything:
    """What the node hands on to rclpy alone."""

    ACCEPT = TRANSIENT_LOCAL = None

    def __init__(self, *_args: object, **_more: object) -> None:
        pass


MODULES: dict[str, dict[str, Any]] = {
    "control_msgs.action": {"FollowJointTrajectory": FollowJointTrajectory},
    "diagnostic_msgs.msg": {
        "DiagnosticArray": DiagnosticArray,
        "DiagnosticStatus": DiagnosticStatus,
        "KeyValue": KeyValue,
    },
    "geometry_msgs.msg": {"TransformStamped": TransformStamped},
    "rcl_interfaces.msg": {"ParameterDescriptor": Anything},
    "rclpy": {"ok": lambda: True},
    "rclpy.action": {"ActionServer": action_server, "CancelResponse": Anything},
    "rclpy.callback_groups": {"ReentrantCallbackGroup": Anything},
    "rclpy.duration": {"Duration": Moment},
    "rclpy.exceptions": {"ParameterException": Exception},
    "rclpy.executors": {"ExternalShutdownException": Exception, "MultiThreadedExecutor": Anything},
    "rclpy.qos": {"DurabilityPolicy": Anything, "QoSProfile": Anything},
    "sensor_msgs.msg": {"JointState": JointState},
    "std_srvs.srv": {"SetBool": Anything, "Trigger": Anything},
    "tf2_msgs.msg": {"TFMessage": TFMessage},
    "trajectory_msgs.msg": {
        "JointTrajectory": JointTrajectory,
        "JointTrajectoryPoint": JointTrajectoryPoint,
    },
}


def installed(monkeypatch: Any) -> None:
    """Have these modules found."""
    for name, content in MODULES.items():
        for each in {name.partition(".")[0], name}:
            if each not in sys.modules or each == name:
                monkeypatch.setitem(sys.modules, each, ModuleType(each))
        vars(sys.modules[name]).update(content)
