"""The node `armui-ros2` without ROS: what it refuses, its path and figures; before a simulated arm.

In a real ROS: `python -m tests.tools.ros2`.
"""

import importlib
import math
import sys
import threading
import time

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

import armui_client
from armui.control.operating_state import StopState
from armui.kinematics.poses import pose_to_matrix
from armui_ros2 import figures, follower, link
from armui_ros2.trajectory import Code, Limit, Path, Tolerances, Unfit, points_of, tolerances_of
from tests.interface import ros_shapes as ros
from tests.interface.script import Script

JOINTS = figures.ARM_JOINTS
LIMITS = (Limit(-150.0, 150.0, 60.0),) * 6
HOME = (0.0, 40.0, -50.0, 0.0, 20.0, 0.0)
FAR = (90.0, 40.0, -50.0, 0.0, 20.0, 0.0)


def message(*points, names=JOINTS, stamp_s=0):
    """A trajectory: at a time, six angles in degrees, and their speeds."""
    told = ros.JointTrajectory(joint_names=list(names))
    told.header.stamp.sec = stamp_s
    for time_s, angles, *speeds in points:
        point = ros.JointTrajectoryPoint([math.radians(each) for each in angles])
        point.velocities = [math.radians(each) for each in (speeds[0] if speeds else ())]
        point.time_from_start = ros.Moment(nanoseconds=round(time_s * 1e9)).to_msg()
        told.points.append(point)
    return told


def one(value):
    return (value, 0.0, 0.0, 0.0, 0.0, 0.0)


# Trajectories ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("told", "code", "words"),
    [
        (message(), Code.INVALID_GOAL, "no points"),
        (message((1, HOME[:5]), names=JOINTS[:5]), Code.INVALID_JOINTS, "lacks joint6"),
        (message((1, HOME), names=[*JOINTS[:5], "joint7"]), Code.INVALID_JOINTS, "“joint7”"),
        (message((1, HOME), names=[*JOINTS, "joint1"]), Code.INVALID_JOINTS, "named twice"),
        (message((1, HOME[:5])), Code.INVALID_GOAL, "5 values for 6"),
        (message((1, HOME, (0.0,) * 5)), Code.INVALID_GOAL, "velocities has 5 values"),
        (message((1, (math.nan, *HOME[1:]))), Code.INVALID_GOAL, "no number"),
        (message((1, HOME, (math.inf,) * 6)), Code.INVALID_GOAL, "no number"),
        (message((1, HOME), (1, HOME)), Code.INVALID_GOAL, "must increase"),
        (message((-1, HOME)), Code.INVALID_GOAL, "must increase"),
        (message((601, HOME)), Code.INVALID_GOAL, "at most 600 s"),
        (message((1, HOME, one(5.0))), Code.INVALID_GOAL, "must end at rest"),
        (message((1, HOME), stamp_s=995), Code.OLD_HEADER_TIMESTAMP, "-5.0 s from now"),
        (message(*[(1, HOME)] * 10_001), Code.INVALID_GOAL, "at most 10000"),
    ],
)
def test_what_is_no_trajectory_is_refused_in_words(told, code, words):
    with pytest.raises(Unfit, match=words) as found:
        points_of(told, JOINTS, 1000.0)
    assert found.value.code is code


@pytest.mark.parametrize(
    ("told", "words"),
    [
        (message((3, one(151.0))), "Joint 1 would be at 150"),
        (message((1, one(61.0))), r"Joint 1 would turn at 61°/s after 0\.00 s; now it may .* 60"),
        (message((0, one(3.1)), (1, one(0.0))), r"joint 1 at 3\.1°, but it is at 0\.0°"),
        # between two points within the limits, as it comes fast
        (message((10, one(145), one(55)), (11, one(145), one(0))), "Joint 1 would be at 15"),
    ],
)
def test_a_path_that_no_arm_may_go_is_refused_in_words(told, words):
    with pytest.raises(Unfit, match=words):
        Path(points_of(told, JOINTS, 0.0), one(0.0), LIMITS, 3.0)


@pytest.mark.parametrize("begins_s", [0.0, 0.5], ids=["at once", "later"])
def test_it_is_a_straight_line_or_with_speeds_a_cubic(begins_s):
    """Later, it comes from where the arm is, at rest there; the order of the joints is free."""
    times_s, places, speeds = [begins_s, 2.0, 4.0], [0.5, 30.0, 10.0], [0.0, -10.0, 0.0]
    names = [*JOINTS[3:], *JOINTS[:3]]
    sent = [(t, np.roll(one(a), 3)) for t, a in zip(times_s, places, strict=True)]
    with_speeds = [(*each, np.roll(one(v), 3)) for each, v in zip(sent, speeds, strict=True)]
    straight, cubic = (
        Path(points_of(message(*each, names=names), JOINTS, 0.0), one(-0.5), LIMITS, 3.0)
        for each in (sent, with_speeds)
    )
    if begins_s > 0.0:
        times_s, places, speeds = [0.0, *times_s], [-0.5, *places], [0.0, *speeds]
    asked_s = np.linspace(-0.5, 4.5, 101)
    found = [straight.at(each)[0] for each in asked_s]
    assert found == pytest.approx(np.interp(asked_s, times_s, places))
    found = [cubic.at(each)[0] for each in asked_s]
    wanted = CubicHermiteSpline(times_s, places, speeds)
    assert found == pytest.approx(wanted(np.clip(asked_s, 0.0, 4.0)))
    assert cubic.goal_deg == cubic.at(99.0) == pytest.approx(one(10.0))


def test_an_arm_a_little_beyond_its_limits_begins_at_them():
    limits = (Limit(0.0, 100.0, 60.0), *LIMITS[1:])
    points = points_of(message((1, one(10.0))), JOINTS, 0.0)
    path = Path(points, one(-2.0), limits, 3.0)
    assert path.at(0.0) == one(0.0)
    assert path.beyond(one(-2.0))
    assert not path.beyond(one(0.0))
    with pytest.raises(Unfit, match="begins with joint 1"):
        Path(points, one(-4.0), limits, 3.0)


def test_a_goal_may_name_its_own_tolerances():
    usual = Tolerances((15.0,) * 6, (1.0,) * 6, 2.0)
    goal = ros.Goal()
    assert tolerances_of(goal, JOINTS, usual) == usual
    goal.path_tolerance = [ros.JointTolerance("joint2", math.radians(5.0))]
    goal.goal_tolerance = [ros.JointTolerance("joint1", -1.0), ros.JointTolerance("joint3", 0.0)]
    goal.goal_time_tolerance.sec = 7
    found = tolerances_of(goal, JOINTS, usual)
    assert found.path_deg == pytest.approx((15.0, 5.0, 15.0, 15.0, 15.0, 15.0))
    assert found.goal_deg == (math.inf, 1.0, 1.0, 1.0, 1.0, 1.0)
    assert found.goal_time_s == 7.0
    assert found.astray((0.0, 4.9, *[0.0] * 4), (0.0,) * 6) is None
    assert "joint 2" in (found.astray((99.0, 5.1, *[0.0] * 4), (99.0, *[0.0] * 5)) or "")
    for name, far in (("joint9", 1.0), ("joint1", math.nan)):
        goal.path_tolerance = [ros.JointTolerance(name, far)]
        with pytest.raises(Unfit, match=name):
            tolerances_of(goal, JOINTS, usual)


def test_a_rotation_is_the_arm_s():
    for turned in ((10.0, 0.0, 0.0), (20.0, -130.0, 75.0), (-170.0, 80.0, 179.0)):
        x, y, z, w = figures.quaternion(turned)
        matrix = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
        assert np.allclose(matrix, pose_to_matrix((0.0, 0.0, 0.0, *turned))[:3, :3])


# The node -------------------------------------------------------------------------------------


@pytest.fixture
def script(desk, monkeypatch):
    script = Script(desk, monkeypatch)
    for module in (follower, link):
        monkeypatch.setattr(module, "time", script.time)
    # the rig's time may go faster than a slow computer hands on what is measured
    monkeypatch.setattr(follower, "SILENT_S", 30.0)
    return script


@pytest.fixture
def with_node(script, monkeypatch):
    """Runs a function with a node and what it has of ROS, in a thread, from its home."""
    ros.installed(monkeypatch)
    monkeypatch.delitem(sys.modules, "armui_ros2.node", raising=False)
    made = importlib.import_module("armui_ros2.node")

    def run(act, *, home=True, **parameters):
        node = ros.Node(**{"path_tolerance_deg": 0.0, "goal_time_s": 60.0, **parameters})

        def connected():
            with armui_client.connect("before") as arm:
                if home:
                    with arm.lease("home"):
                        arm.move_joints(HOME)
            arm_node = made.ArmNode(node)
            arm_node.start()
            try:
                until(lambda: node.publishers["joint_states"].messages)
                return act(node)
            finally:
                arm_node.close()

        return script.run(connected)

    yield run
    sys.modules.pop("armui_ros2.node", None)


def until(condition):
    until_s = time.monotonic() + 20.0
    while not condition():
        assert time.monotonic() < until_s
        time.sleep(0.001)


def status(node):
    newest = node.publishers["~/status"].messages[-1].status[0]
    return newest.level, {each.key: each.value for each in newest.values}


def follow(node, *points, cancels=lambda: False, **more):
    handle = ros.Handle(ros.Goal(message(*points, **more)), cancels)
    result = node.given["~/follow_joint_trajectory"](handle)
    return handle, result


def test_what_is_measured_is_published_in_rad_and_m_with_its_time(with_node, script):
    def read(node):
        until(lambda: len(node.publishers["joint_states"].messages) >= 4)
        return node

    node = with_node(read, prefix="left_", tf=True)
    messages = node.publishers["joint_states"].messages
    arm = next(each for each in messages if len(each.name) == 6)
    hand = next(each for each in messages if len(each.name) == 2)
    assert arm.name == [f"left_joint{number}" for number in range(1, 7)]
    assert hand.name == ["left_joint7", "left_joint8"]
    assert np.degrees(arm.position) == pytest.approx(HOME, abs=0.3)
    assert len(arm.velocity) == 6
    opening_mm = script.rig.controller.state.gripper.value.opening_mm
    assert hand.position == pytest.approx([-opening_mm / 2000.0, opening_mm / 2000.0])
    for each in (arm, hand):
        age_s = node.now_s - each.header.stamp.sec - each.header.stamp.nanosec * 1e-9
        assert 0.0 <= age_s <= 0.25
    found = node.publishers["/tf"].messages[0].transforms[0]
    assert (found.header.frame_id, found.child_frame_id) == ("left_base_link", "left_flange")
    with_it = script.rig.controller.cartesian.kinematics().forward(np.degrees(arm.position))
    place = found.transform.translation
    assert np.array([place.x, place.y, place.z]) * 1e3 == pytest.approx(with_it[:3], abs=2.0)


def test_what_is_too_old_is_not_published(with_node, script):
    def read(node):
        script.rig.powered = False
        messages = node.publishers["joint_states"].messages
        until(lambda: "too old" in node.publishers["~/status"].messages[-1].status[0].message)
        assert status(node)[0] == b"\3", "stale"
        count, since_s = len(messages), script.rig.time_s
        until(lambda: script.rig.time_s > since_s + 1.0)
        return [each.name for each in messages[count:] if len(each.name) == 6]

    assert with_node(read) == []


def test_a_goal_is_followed_to_its_end(with_node, script):
    there = (20.0, 60.0, -70.0, 10.0, 20.0, -10.0)

    def ask(node):
        rests = (0.0,) * 6
        handle, result = follow(node, (0, HOME, rests), (1.0, there, rests))
        return handle, result, status(node)

    handle, result, (level, values) = with_node(ask)
    assert (handle.state, result.error_code) == ("succeeded", 0), result.error_string
    assert script.rig.firmware.joints_deg == pytest.approx(there, abs=0.3)
    assert level == b"\0"
    assert values["lease"] == "held"
    assert handle.feedback[-1].joint_names == list(JOINTS)
    assert script.desk.view.lease is None, "the node has ended"


@pytest.fixture
def resting(rig):
    rig.lie((0.0, -1.999, 1.971, -1.412, 22.11, -2.608))


@pytest.mark.usefixtures("resting")
def test_a_goal_from_the_rest_pose_enters_the_limits_first(with_node, script):
    raised = (0.0, 20.0, -5.0, 0.0, 20.0, 0.0)
    handle, result = with_node(lambda node: follow(node, (1.0, raised)), home=False)
    assert handle.state == "succeeded", result.error_string
    assert script.rig.firmware.joints_deg == pytest.approx(raised, abs=0.3)


def test_a_refused_goal_says_why_and_moves_nothing(with_node, script):
    def ask(node):
        found = follow(node, (1.0, HOME), names=JOINTS[:5])
        assert script.desk.view.lease is None, "nobody was asked"
        slow = follow(node, (1.0, (55.0, *HOME[1:])))
        return found, slow

    script.percent = 10
    (handle, result), (slow, too_fast) = with_node(ask)
    assert (handle.state, result.error_code) == ("aborted", Code.INVALID_JOINTS)
    assert "lacks joint6" in result.error_string
    assert slow.state == "aborted"
    assert "now it may turn at" in too_fast.error_string, "he has granted a tenth"
    assert script.rig.firmware.joints_deg == pytest.approx(HOME, abs=0.3)


def test_without_a_lease_it_is_refused(with_node, script):
    def ask(node):
        never = follow(node, (2.0, FAR))
        script.percent = None
        declined = node.given["~/lease"](ros.Request(data=True), ros.Response())
        return never, declined

    def meanwhile():
        if script.percent is None and script.desk.view.asked is not None:
            script.desk.decline()

    script.meanwhile = meanwhile
    (handle, result), answer = with_node(ask, trajectories_ask_for_lease=False)
    assert handle.state == "aborted"
    assert "service lease" in result.error_string
    assert answer == ros.Response(success=False, message="The operator has declined.")


def replace(node):
    newer = message((2.0, HOME))
    threading.Thread(target=node.given["joint_trajectory"], args=(newer,)).start()


@pytest.mark.parametrize(
    ("end", "state", "words"),
    [
        (lambda node, script: script.desk.take_back(), "aborted", "taken the arm back"),
        (lambda node, script: script.desk._controller.emergency_stop(), "aborted", "stopped"),
        (lambda node, script: replace(node), "aborted", "newer"),
        (
            lambda node, script: script.desk._controller.motion.set_speed_percent(2),
            "aborted",
            "slowed",
        ),
        (lambda node, script: None, "canceled", "Cancelled"),
    ],
    ids=["taken back", "stop", "replaced", "slowed", "cancelled"],
)
def test_a_goal_that_is_ended_says_why(end, state, words, with_node, script):
    begun: list[bool] = []

    def meanwhile():
        if script.rig.firmware.joints_deg[0] > 10.0 and not begun:
            begun.append(True)
            end(made[0], script)

    made: list[ros.Node] = []
    script.meanwhile = meanwhile

    def ask(node):
        made.append(node)
        return follow(node, (3.0, FAR), cancels=lambda: state == "canceled" and begun)

    within_deg = 20.0 if words == "slowed" else 0.0
    handle, result = with_node(ask, path_tolerance_deg=within_deg)
    assert handle.state == state
    assert words in result.error_string
    script.rig.run(1.0)
    assert script.rig.firmware.joints_deg[0] < 60.0


def test_what_is_given_back_while_it_is_asked_for_is_not_held(with_node, script):
    def ask(node):
        script.percent = None
        asked = threading.Thread(target=follow, args=(node, (2.0, HOME)))
        asked.start()
        until(lambda: script.desk.view.asked is not None)
        answer = node.given["~/lease"](ros.Request(data=False), ros.Response())
        script.percent = 100
        asked.join()
        until(
            lambda: "given back while" in node.publishers["~/status"].messages[-1].status[0].message
        )
        return answer

    assert with_node(ask).success
    assert script.desk.view.lease is None


@pytest.mark.parametrize("name", ["halt", "stop"])
def test_the_arm_is_halted_and_stopped_without_a_lease(name, with_node, script):
    answer = with_node(lambda node: node.given[f"~/{name}"](None, ros.Response()))
    assert answer.success
    stopped = script.rig.controller.operating_state.stop is not StopState.RUNNING
    assert stopped == (name == "stop")


@pytest.mark.parametrize("value", [200, "fast", True, math.nan])
def test_a_parameter_out_of_range_is_said(value, with_node):
    with pytest.raises(ValueError, match=f"stream_hz is {value!r}; it must be 50 to 100"):
        with_node(lambda node: None, stream_hz=value)
