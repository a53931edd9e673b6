"""A stranger's node: it knows ROS and its messages alone, nothing of armui but names of topics.

    python stranger.py read SECONDS
    python stranger.py call SERVICE [true|false]
    python stranger.py send TRAJECTORY

A trajectory is JSON: `joint_names` and `points`, each of `time`, `positions` and `velocities`, in
s and rad; a list of several is sent a second apart. What was found is printed as JSON.
"""

import itertools
import json
import math
import sys
import time

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool, Trigger
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

WITHIN_S = 60.0
MOVED_RAD = math.radians(0.2)


class Stranger:
    def __init__(self):
        rclpy.init()
        self.node = rclpy.create_node("stranger")
        self.heard = []
        self.status = {}
        self.node.create_subscription(JointState, "/joint_states", self.on_joints, 100)
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.node.create_subscription(DiagnosticArray, "/armui/status", self.on_status, kept)

    def on_joints(self, message):
        now = self.node.get_clock().now()
        stamp = Time.from_msg(message.header.stamp)
        age_ms = (now - stamp).nanoseconds * 1e-6
        places = dict(zip(message.name, message.position, strict=True))
        self.heard.append((stamp.nanoseconds * 1e-9, age_ms, places, list(message.velocity)))

    def on_status(self, message):
        (status,) = message.status
        self.status = {each.key: each.value for each in status.values}

    def wait(self, done, within_s=WITHIN_S):
        until_s = time.monotonic() + within_s
        while not done():
            if time.monotonic() > until_s:
                raise SystemExit("nothing came")
            rclpy.spin_once(self.node, timeout_sec=0.05)

    def of_arm(self):
        return [each for each in self.heard if "joint1" in each[2]]

    def pace(self, heard):
        stamps = [each[0] for each in heard]
        ages = sorted(each[1] for each in heard)
        gaps = [b - a for a, b in itertools.pairwise(stamps)]
        return {
            "rate_hz": round((len(heard) - 1) / (stamps[-1] - stamps[0]), 1),
            "longest_gap_ms": round(1e3 * max(gaps), 1),
            "age_ms": {
                "p50": round(ages[len(ages) // 2], 2),
                "p99": round(ages[int(0.99 * (len(ages) - 1))], 2),
                "most": round(ages[-1], 2),
            },
        }

    def read(self, seconds):
        self.wait(lambda: bool(self.of_arm()))
        self.heard.clear()
        until_s = time.monotonic() + float(seconds)
        self.wait(lambda: time.monotonic() > until_s)
        heard = self.of_arm()
        fingers = [each for each in self.heard if "joint7" in each[2]]
        return {
            **self.pace(heard),
            "positions": heard[-1][2],
            "speeds": heard[-1][3],
            "fingers": fingers[-1][2],
            "status": self.status,
        }

    def call(self, service, value=None):
        kind = Trigger if value is None else SetBool
        client = self.node.create_client(kind, f"/armui/{service}")
        assert client.wait_for_service(10.0)
        request = kind.Request()
        if value is not None:
            request.data = value == "true"
        began_s = time.monotonic()
        future = client.call_async(request)
        self.wait(future.done)
        answer = future.result()
        return {
            "success": answer.success,
            "message": answer.message,
            "took_ms": round(1e3 * (time.monotonic() - began_s)),
        }

    def message(self, told):
        message = JointTrajectory(joint_names=told["joint_names"])
        for each in told["points"]:
            point = JointTrajectoryPoint(positions=each["positions"])
            point.velocities = each.get("velocities", [])
            point.time_from_start = Duration(seconds=each["time"]).to_msg()
            message.points.append(point)
        return message

    def send(self, told):
        told = json.loads(told)
        several = told if isinstance(told, list) else [told]
        publisher = self.node.create_publisher(JointTrajectory, "/joint_trajectory", 1)
        self.wait(lambda: publisher.get_subscription_count() and self.status and self.of_arm())
        ended = int(self.status["trajectories_ended"])
        for number, each in enumerate(several):
            if number:
                until_s = time.monotonic() + 1.0
                self.wait(lambda until_s=until_s: time.monotonic() > until_s)
            self.heard.clear()
            sent = self.node.get_clock().now()
            publisher.publish(self.message(each))
        wanted = ended + len(several)
        self.wait(lambda: int(self.status["trajectories_ended"]) >= wanted and self.of_arm())
        heard = self.of_arm()
        return {
            **{name: each for name, each in self.status.items() if name.startswith("last")},
            **(self.pace(heard) if len(heard) > 1 else {}),
            "lease": self.status["lease"],
            **errors(several[-1], heard, sent.nanoseconds * 1e-9),
        }


def place(points, time_s):
    """Where a trajectory is, in rad: as trajectory_msgs and its usual controllers say it."""
    if time_s <= points[0]["time"]:
        return points[0]["positions"]
    for one, other in itertools.pairwise(points):
        if time_s <= other["time"]:
            span = other["time"] - one["time"]
            u = (time_s - one["time"]) / span
            a, b = one["positions"], other["positions"]
            if not one.get("velocities"):
                return [x + u * (y - x) for x, y in zip(a, b, strict=True)]
            v, w = one["velocities"], other["velocities"]
            return [
                (2 * u**3 - 3 * u**2 + 1) * x
                + (u**3 - 2 * u**2 + u) * span * p
                + (3 * u**2 - 2 * u**3) * y
                + (u**3 - u**2) * span * q
                for x, y, p, q in zip(a, b, v, w, strict=True)
            ]
    return points[-1]["positions"]


def errors(told, heard, sent_s):
    """How far the measured joints were from the trajectory, at the times of their measuring.

    Once as if it had begun when it was sent, and once as late as fits best.
    """
    points, names = told["points"], told["joint_names"]
    whole = [each for each in heard if all(name in each[2] for name in names)]
    if len(whole) < 2 or not points:
        return {}
    at = [(each[0] - sent_s, [each[2][name] for name in names]) for each in whole]
    began = at[0][1]
    if points[0]["time"] > 0.0:
        points = [{**points[0], "time": 0.0, "positions": began}, *points]
    moved = [time_s for time_s, joints in at if apart(joints, began) > MOVED_RAD]
    sent_most, sent_rms = error(points, at, 0.0)
    shifts = {late_ms: error(points, at, late_ms * 1e-3) for late_ms in range(0, 800, 5)}
    late_ms = min(shifts, key=lambda each: shifts[each][1])
    return {
        "moved_after_ms": round(1e3 * moved[0]) if moved else None,
        "travelled_deg": round(math.degrees(apart(at[-1][1], began)), 2),
        "error_deg": {"most": sent_most, "rms": sent_rms},
        "late_ms": late_ms,
        "error_late_deg": {"most": shifts[late_ms][0], "rms": shifts[late_ms][1]},
    }


def apart(joints, others):
    return max(abs(a - b) for a, b in zip(joints, others, strict=True))


def error(points, at, late_s):
    found = [
        math.degrees(apart(joints, place(points, time_s - late_s)))
        for time_s, joints in at
        if 0.0 < time_s - late_s <= points[-1]["time"]
    ] or [0.0]
    return round(max(found), 2), round(math.sqrt(sum(x * x for x in found) / len(found)), 2)


def main():
    name, *args = sys.argv[1:]
    stranger = Stranger()
    print(json.dumps(getattr(stranger, name)(*args)))
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
