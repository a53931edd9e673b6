"""The node ``armui``: joint states and status of the arm, trajectories, lease, halt and stop."""

from __future__ import annotations

import math
import sys
import threading
from collections.abc import Callable, Sequence
from typing import Any, Final

import rclpy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.exceptions import ParameterException
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool, Trigger
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

import armui_client
from armui_ros2 import figures
from armui_ros2.follower import CANCELLED, Ended, Follower, Job, Wishes, usual_tolerances
from armui_ros2.link import Link
from armui_ros2.trajectory import Code, Point, Unfit, points_of, tolerances_of

try:
    from control_msgs.action import FollowJointTrajectory
    from rclpy.action import ActionServer, CancelResponse
except ImportError:
    FollowJointTrajectory = None
try:
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage
except ImportError:
    TFMessage = None

THREADS: Final = 8
"""At most three callbacks wait for the operator or an end: the lease, enabling, an action."""

_DEPTH: Final = 10
_STATUS_EVERY_S: Final = 1.0
_FEEDBACK_EVERY_S: Final = 0.1
_DEFAULTS: Final[dict[str, tuple[Any, float, float]]] = {
    "rate_hz": (50.0, 1.0, 200.0),
    "max_age_s": (0.25, 0.01, 10.0),
    "stream_hz": (100.0, 50.0, 100.0),
    "max_speed_percent": (100, 1, 100),
    "start_tolerance_deg": (3.0, 0.1, 10.0),
    "path_tolerance_deg": (15.0, 0.0, 180.0),
    "goal_tolerance_deg": (1.0, 0.1, 180.0),
    "goal_time_s": (2.0, 0.0, 60.0),
}
"""Parameters that are figures: default, least, most."""


class ArmNode:
    """The arm as a node; :meth:`start` begins, :meth:`close` gives the arm back.

    Args:
        node: An ``rclpy`` node, for an executor of several threads: some callbacks wait.

    Raises:
        ValueError: A parameter is out of its range.
    """

    def __init__(self, node: Any) -> None:
        self.node = node
        figure = {name: _figure(node, name, *each) for name, each in _DEFAULTS.items()}
        prefix = _parameter(node, "prefix", "")
        self._joints = [prefix + each for each in figures.ARM_JOINTS]
        self._fingers = [prefix + each for each in figures.FINGERS]
        self._frames = prefix + figures.BASE, prefix + figures.FLANGE
        self._max_age_s = figure["max_age_s"]
        self._usual = usual_tolerances(
            figure["path_tolerance_deg"], figure["goal_tolerance_deg"], figure["goal_time_s"]
        )
        name = f"ROS 2 {node.get_fully_qualified_name()}"
        wishes = Wishes(
            name=name,
            asks=_parameter(node, "trajectories_ask_for_lease", default=True),
            max_speed_percent=int(figure["max_speed_percent"]),
            stream_hz=figure["stream_hz"],
            start_within_deg=figure["start_tolerance_deg"],
            tolerances=self._usual,
        )
        socket = _parameter(node, "socket", "")
        self.link = Link(name, socket, figure["rate_hz"], self._on_state, self._on_link)
        self.follower = Follower(self.link, wishes, self._on_change)
        self._state: armui_client.State | None = None
        self._doing = "Looks for armui"
        self._last = Ended(Code.SUCCESSFUL, "")
        self._ended = 0
        self._silent = False
        self._waits = threading.Lock()
        self._offer(wants_tf=_parameter(node, "tf", default=False))

    def _offer(self, *, wants_tf: bool) -> None:
        node, group = self.node, ReentrantCallbackGroup()
        self._states = node.create_publisher(JointState, "joint_states", _DEPTH)
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._statuses = node.create_publisher(DiagnosticArray, "~/status", kept)
        self._transforms = None
        if wants_tf and TFMessage is None:
            node.get_logger().warning("tf2_msgs is not installed: no transform is published.")
        elif wants_tf:
            self._transforms = node.create_publisher(TFMessage, "/tf", _DEPTH)
        node.create_subscription(JointTrajectory, "joint_trajectory", self._on_trajectory, _DEPTH)
        services: list[tuple[Any, str, Callable[[Any, Any], Any]]] = [
            (Trigger, "~/halt", self._halt),
            (Trigger, "~/stop", self._stop),
            (Trigger, "~/enable", self._enable),
            (SetBool, "~/lease", self._lease),
        ]
        for kind, name, act in services:
            node.create_service(kind, name, act, callback_group=group)
        if FollowJointTrajectory is None:
            node.get_logger().info("control_msgs is not installed: no action is offered.")
        else:
            self._action = ActionServer(
                node,
                FollowJointTrajectory,
                "~/follow_joint_trajectory",
                self._execute,
                callback_group=group,
                cancel_callback=lambda _goal: CancelResponse.ACCEPT,
            )
        node.create_timer(_STATUS_EVERY_S, self._tell, callback_group=group)

    def start(self) -> None:
        """Begin to look for armui, and to take trajectories."""
        self.follower.start()
        self.link.start()

    def close(self) -> None:
        """End what is followed, give the arm back, and close the connection."""
        self.follower.close()
        self.link.close()

    # What is measured ---------------------------------------------------------------------------

    def _on_state(self, state: armui_client.State) -> None:
        """Publish what is measured, stamped with the time of its measuring."""
        self._state = state
        joints, speeds = state.joints_deg, state.joint_speeds_deg_s
        known = self._known(joints)
        if known == self._silent:
            self._silent = not known
            text = "The arm is heard" if known else "The arm's angles are too old: not published"
            self._on_change(text)
        if known and joints.value is not None:
            message = self._joint_state(self._joints, joints.age_s)
            message.position = figures.radians(joints.value)
            if self._known(speeds) and speeds.value is not None:
                message.velocity = figures.radians(speeds.value)
            self._publish(self._states, message)
        opening = state.gripper_mm
        if self._known(opening) and opening.value is not None:
            message = self._joint_state(self._fingers, opening.age_s)
            message.position = figures.fingers_m(opening.value)
            self._publish(self._states, message)
        flange = state.flange_pose_mm_deg
        if self._transforms is not None and self._known(flange) and flange.value is not None:
            self._publish(self._transforms, self._transform(flange.value, flange.age_s))

    def _known(self, measured: armui_client.Measured[Any]) -> bool:
        age_s = measured.age_s
        return measured.value is not None and age_s is not None and age_s <= self._max_age_s

    def _joint_state(self, names: Sequence[str], age_s: float | None) -> Any:
        message = JointState()
        message.header.stamp = self._measured_at(age_s)
        message.name = list(names)
        return message

    def _measured_at(self, age_s: float | None) -> Any:
        age = Duration(nanoseconds=round((age_s or 0.0) * 1e9))
        return (self.node.get_clock().now() - age).to_msg()

    def _transform(self, pose_mm_deg: Sequence[float], age_s: float | None) -> Any:
        found = TransformStamped()
        found.header.stamp = self._measured_at(age_s)
        found.header.frame_id, found.child_frame_id = self._frames
        place, turned = found.transform.translation, found.transform.rotation
        place.x, place.y, place.z = figures.metres(pose_mm_deg[:3])
        turned.x, turned.y, turned.z, turned.w = figures.quaternion(pose_mm_deg[3:])
        return TFMessage(transforms=[found])

    # The status ---------------------------------------------------------------------------------

    def _on_link(self, problem: str) -> None:
        if problem:
            self._state = None
        self._on_change(problem or "Has found armui")

    def _on_change(self, doing: str, *, warns: bool = False) -> None:
        """Say what the node does now: in the log, and in its status."""
        self._doing = doing
        if rclpy.ok():  # else ROS has been shut down meanwhile
            log = self.node.get_logger()
            log.warning(doing) if warns else log.info(doing)
            self._tell()

    def _tell(self) -> None:
        """Publish the status: what the node does, how the last trajectory ended, what the arm says.

        Of the kinds of messages that every ROS 2 has, this is the one for it: a level, words, and
        values by their names; remapped to ``/diagnostics`` the usual monitors show it.
        """
        state, last = self._state, self._last
        level, said = DiagnosticStatus.OK, state.status.value if state is not None else None
        if last.text and last.code is not Code.SUCCESSFUL:
            level = DiagnosticStatus.WARN
        if said is not None and said.arm_status != "normal":
            level = DiagnosticStatus.ERROR
        if state is None or not self._known(state.joints_deg):
            level = DiagnosticStatus.STALE
        follower = self.follower
        lease = "held" if follower.held else "asked for" if follower.asking else "none"
        values = {
            "lease": lease,
            "trajectories_ended": str(self._ended),
            "last_trajectory": last.text,
            "last_trajectory_code": str(int(last.code)),
            "last_trajectory_reason": last.reason,
        }
        if state is not None:
            values["angles_age_s"] = str(state.joints_deg.age_s)
            values["motors_on"] = str(state.enabled.value is not None and all(state.enabled.value))
        if said is not None:
            values |= {"arm_status": str(said.arm_status), "control_mode": str(said.control_mode)}
        status = DiagnosticStatus(level=level, name="armui: arm", message=self._doing)
        status.values = [KeyValue(key=key, value=value) for key, value in values.items()]
        message = DiagnosticArray(status=[status])
        message.header.stamp = self.node.get_clock().now().to_msg()
        self._publish(self._statuses, message)

    def _publish(self, publisher: Any, message: Any) -> None:
        try:
            publisher.publish(message)
        except Exception:
            if rclpy.ok():
                raise

    # Trajectories -------------------------------------------------------------------------------

    def _on_trajectory(self, message: Any) -> None:
        self._begin(message)

    def _begin(self, message: Any, goal: Any = None) -> Job:
        """Follow a trajectory; the job says at once, or later, how it ended."""
        points: list[Point] = []
        tolerances, refused = self._usual, None
        now_s = self.node.get_clock().now().nanoseconds * 1e-9
        try:
            points = points_of(message, self._joints, now_s)
            if goal is not None:
                tolerances = tolerances_of(goal, self._joints, self._usual)
        except Unfit as error:
            refused = Ended(error.code, str(error))
        job = Job(points, tolerances, self._on_end)
        if refused is None:
            self.follower.follow(job)
        else:
            job.end(refused)
        return job

    def _on_end(self, job: Job, ended: Ended) -> None:
        self._last, self._ended = ended, self._ended + 1
        if ended.code is Code.SUCCESSFUL:
            self._on_change(f"A trajectory has ended: {ended.text}")
        else:
            what = "was ended" if job.desired_deg else "is refused"
            self._on_change(f"A trajectory {what}: {ended.text}", warns=True)

    def _execute(self, handle: Any) -> Any:
        """Follow the trajectory of an action's goal, in a thread of the executor, to its end."""
        goal = handle.request
        job = self._begin(goal.trajectory, goal)
        while not job.over.wait(_FEEDBACK_EVERY_S):
            if handle.is_cancel_requested:
                job.end(CANCELLED)
            elif job.desired_deg:
                handle.publish_feedback(self._feedback(job))
        ended = job.ended or CANCELLED
        if ended is CANCELLED:
            handle.canceled()
        elif ended.code is Code.SUCCESSFUL:
            handle.succeed()
        else:
            handle.abort()
        result = FollowJointTrajectory.Result()
        result.error_code, result.error_string = int(ended.code), ended.text
        return result

    def _feedback(self, job: Job) -> Any:
        found = FollowJointTrajectory.Feedback()
        found.header.stamp = self.node.get_clock().now().to_msg()
        found.joint_names = self._joints
        desired, measured = job.desired_deg, job.measured_deg
        apart = [b - a for a, b in zip(measured, desired, strict=True)]
        found.desired = JointTrajectoryPoint(positions=figures.radians(desired))
        found.actual = JointTrajectoryPoint(positions=figures.radians(measured))
        found.error = JointTrajectoryPoint(positions=figures.radians(apart))
        return found

    # Services -----------------------------------------------------------------------------------

    def _halt(self, _request: Any, response: Any) -> Any:
        return _answered(response, "Halted, with power on.", lambda: self.link.arm().halt())

    def _stop(self, _request: Any, response: Any) -> Any:
        text = "Emergency stop. When it is released, the arm drops."
        return _answered(response, text, lambda: self.link.arm().stop())

    def _enable(self, _request: Any, response: Any) -> Any:
        """Switch the motors on: the operator is asked each time, for the lease and for this."""

        def enable() -> None:
            self.follower.take()
            self.link.arm().enable()

        return self._asked(response, "The motors are on.", enable)

    def _lease(self, request: Any, response: Any) -> Any:
        if request.data:
            return self._asked(response, "The lease is held.", self.follower.take)
        return self._asked(response, "The arm is given back.", self.follower.release)

    def _asked(self, response: Any, text: str, act: Callable[[], object]) -> Any:
        """Do what may wait for the operator, unless he is asked already."""
        if not self._waits.acquire(blocking=False):
            response.success, response.message = False, "The operator is asked already: wait."
            return response
        try:
            return _answered(response, text, act)
        finally:
            self._waits.release()


def _answered(response: Any, text: str, act: Callable[[], object]) -> Any:
    """Do something at armui, and say in the response whether it was done, or why not."""
    try:
        act()
    except armui_client.ArmuiError as error:
        response.success, response.message = False, str(error)
    else:
        response.success, response.message = True, text
    return response


def _parameter(node: Any, name: str, default: Any) -> Any:
    return node.declare_parameter(name, default).value


def _figure(node: Any, name: str, default: float, least: float, most: float) -> float:
    # 100 is as good as 100.0
    value = node.declare_parameter(name, default, ParameterDescriptor(dynamic_typing=True)).value
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not (number and math.isfinite(value) and least <= value <= most):
        raise ValueError(f"The parameter {name} is {value!r}; it must be {least:g} to {most:g}.")
    return float(value)


def main(args: Sequence[str] | None = None) -> int:
    """Run the node until Ctrl-C; returns the exit code."""
    rclpy.init(args=args)
    node = rclpy.create_node("armui")
    try:
        arm = ArmNode(node)
    except (ValueError, ParameterException) as error:
        sys.stderr.write(f"armui-ros2: {error}\n")
        return 2
    executor = MultiThreadedExecutor(THREADS)
    executor.add_node(node)
    arm.start()
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        arm.close()
        rclpy.try_shutdown()
        executor.shutdown()
        node.destroy_node()
    return 0


if __name__ == "__main__":
    sys.exit(main())
