"""Switches the motors on, sends one trajectory, and prints where the joints are: ROS alone."""

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

JOINTS = ["joint1", "joint2", "joint3", "joint4", "joint5", "joint6"]
WAY_RAD = [(2, [0.0, 0.5, -0.2, 0.0, 0.3, 0.0]), (5, [0.6, 0.9, -1.1, 0.2, 0.3, 0.2])]
"""Seconds from the start, and the six angles then."""


class FirstMotion(Node):  # type: ignore[misc]  # of rclpy, where that is not installed
    """A node that reads the joints and the status, and sends."""

    def __init__(self) -> None:
        super().__init__("first_motion")
        self.joints: dict[str, float] = {}
        self.status: dict[str, str] = {}
        self.create_subscription(JointState, "/joint_states", self._on_joints, 10)
        self.create_subscription(DiagnosticArray, "/armui/status", self._on_status, 10)
        self.enable = self.create_client(Trigger, "/armui/enable")
        self.trajectory = self.create_publisher(JointTrajectory, "/joint_trajectory", 10)

    def _on_joints(self, message: JointState) -> None:
        self.joints.update(zip(message.name, message.position, strict=True))

    def _on_status(self, message: DiagnosticArray) -> None:
        self.status = {each.key: each.value for each in message.status[0].values}

    def ended(self) -> int:
        """Return how many trajectories have ended."""
        return int(self.status["trajectories_ended"])


def main() -> None:
    """Move once."""
    rclpy.init()
    node = FirstMotion()
    while not (node.status and node.joints and node.trajectory.get_subscription_count()):
        rclpy.spin_once(node)
    asked = node.enable.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, asked)
    print(asked.result().message)

    before = node.ended()
    message = JointTrajectory(joint_names=JOINTS)
    for seconds, angles in WAY_RAD:
        point = JointTrajectoryPoint(positions=angles)
        point.time_from_start.sec = seconds
        message.points.append(point)
    node.trajectory.publish(message)
    while node.ended() == before:
        rclpy.spin_once(node)
    print(node.status["last_trajectory"])
    print({name: round(node.joints[name], 3) for name in JOINTS})
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
