"""A steered jog: several axes at once, changed on the way, never past what a single one may do."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.control.motion.jog_pace import pace
from armui.control.motion.jog_path import JOG_AT_LIMIT, JOG_OUT_OF_REACH, JointJogPath
from armui.control.motion.jog_stream import JogStream
from armui.control.motion.jogging import axes_text
from armui.control.motion.steered_path import SteeredJog, SteeredToolPath
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import JogFrame
from armui.kinematics.poses import matrix_to_pose, moved, pose_to_matrix, rotation, shifted
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, TICK_S, bend, hold, rest_s
from tests.family import FACTORY_ACCELERATION_DEG_S2, FACTORY_LIMITS, PIPER

DEVICE = "pad"
PACE = pace(100, FACTORY_LIMITS, (FACTORY_ACCELERATION_DEG_S2,) * 6)
TOOL = (10.0, 0.0, 50.0, 0.0, 0.0, 0.0)


@pytest.fixture
def arm_repeats():
    return True  # it is looked at between two steps


def joints(*rates):
    return SteeredJog((*rates, *(0.0,) * (6 - len(rates))), None, DEVICE)


def tool(*rates, frame=JogFrame.BASE):
    return SteeredJog((*rates, *(0.0,) * (6 - len(rates))), frame, DEVICE)


# The joints ---------------------------------------------------------------------------------------


def test_each_joint_goes_at_its_rate():
    path = JointJogPath((0.5, -0.25, 0, 0, 0, 0), BENT_DEG, FACTORY_LIMITS)
    one_second = path.joints_at(path.speed(PACE) * 1.0, BENT_DEG)
    turned = [now - then for now, then in zip(one_second, BENT_DEG, strict=True)]
    speed = PACE.speeds_deg_s[0]
    assert turned == pytest.approx([0.5 * speed, -0.25 * speed, 0, 0, 0, 0])


def test_the_slowest_joint_keeps_the_direction():
    slow = (*FACTORY_LIMITS[:1], JointLimits(-10.0, 190.0, 4.0), *FACTORY_LIMITS[2:])
    at_pace = pace(100, slow, (FACTORY_ACCELERATION_DEG_S2,) * 6)
    path = JointJogPath((1.0, 1.0, 0, 0, 0, 0), BENT_DEG, slow)
    assert path.speed(at_pace) == pytest.approx(4.0)


@pytest.mark.parametrize(
    ("rates", "joint", "limit", "room"),
    [
        ((1.0, 0, 0, 0, 0, 0), 1, FACTORY_LIMITS[0].max_deg, FACTORY_LIMITS[0].max_deg - 10.0),
        ((-1.0, 0, 0, 0, 0, 0), 1, FACTORY_LIMITS[0].min_deg, 10.0 - FACTORY_LIMITS[0].min_deg),
        # joint 5 has 30° left to +70° and goes half as fast: 60° of joint 1's way
        ((1.0, 0, 0, 0, 0.5, 0), 5, FACTORY_LIMITS[4].max_deg, None),
    ],
)
def test_it_ends_at_the_first_limit(rates, joint, limit, room):
    path = JointJogPath(rates, BENT_DEG, FACTORY_LIMITS)
    expected = 2 * (FACTORY_LIMITS[4].max_deg - BENT_DEG[4]) if room is None else room
    assert path.room() == pytest.approx(expected)
    assert path.why_no_further().reason == JOG_AT_LIMIT
    assert path.why_no_further().params == {"joint": joint, "limit": limit}
    assert path.joints_at(path.room(), BENT_DEG)[joint - 1] == pytest.approx(limit)


# The tool -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("frame", list(JogFrame))
@pytest.mark.parametrize("axis", range(6))
def test_one_axis_alone_is_the_step_of_a_button(axis, frame):
    start = pose_to_matrix((200.0, 30.0, 150.0, 10.0, 80.0, 20.0))
    figures = [0.0] * 6
    figures[axis] = 7.0
    here = moved(start, figures[:3], figures[3:], frame)
    assert here == pytest.approx(shifted(start, axis, 7.0, frame), abs=1e-9)
    axes = start[:3, :3] if frame is JogFrame.TOOL else np.eye(3)
    turn = Rotation.from_rotvec(np.radians(7.0) * axes[:, axis % 3]).as_matrix()
    along = 7.0 * axes[:, axis] if axis < 3 else np.zeros(3)
    assert here[:3, 3] == pytest.approx(start[:3, 3] + along, abs=1e-9)
    turned = start[:3, :3] if axis < 3 else turn @ start[:3, :3]
    assert here[:3, :3] == pytest.approx(turned, abs=1e-9)


@pytest.mark.parametrize("turn_deg", [(0.0, 0.0, 0.0), (1e-13, 0, 0), (10, -20, 5), (0, 179, 0)])
def test_rotations_as_another_library_has_them(turn_deg):
    assert rotation(turn_deg) == pytest.approx(
        Rotation.from_rotvec(np.radians(turn_deg)).as_matrix(), abs=1e-12
    )


def test_two_axes_at_once_are_no_faster_than_one():
    kinematics = Kinematics(PIPER)
    path = SteeredToolPath(
        *((1.0, -1.0, 0, 0, 0, 0), JogFrame.BASE, kinematics, BENT_DEG),
        tool=TOOL,
        limits=FACTORY_LIMITS,
    )
    seconds = 0.1
    at = path.joints_at(seconds * path.speed(PACE), BENT_DEG)
    assert not isinstance(at, Refusal)
    here = kinematics.matrix(at) @ pose_to_matrix(TOOL)
    there = kinematics.matrix(BENT_DEG) @ pose_to_matrix(TOOL)
    way = here[:3, 3] - there[:3, 3]
    assert np.linalg.norm(way) == pytest.approx(60.0 * seconds, abs=1e-3)
    assert way[0] == pytest.approx(-way[1], abs=1e-3)
    assert here[:3, :3] == pytest.approx(there[:3, :3], abs=1e-6)


def test_beyond_reach_is_said():
    path = SteeredToolPath(
        *((1.0, 0, 0, 0, 0, 0), JogFrame.BASE, Kinematics(PIPER), BENT_DEG),
        tool=(0.0,) * 6,
        limits=FACTORY_LIMITS,
    )
    assert path.joints_at(1000.0, BENT_DEG) == JOG_OUT_OF_REACH()


# On the way ---------------------------------------------------------------------------------------


def test_another_way_begins_where_the_setpoint_is():
    stream = JogStream(
        JointJogPath((1.0, 0, 0, 0, 0, 0), BENT_DEG, FACTORY_LIMITS), BENT_DEG, BENT_DEG
    )
    assert stream.advance_setpoint(BENT_DEG, 0.01, PACE) is None
    before = stream.setpoint_deg
    stream.follow_path(JointJogPath((0, -1.0, 0, 0, 0, 0), before, FACTORY_LIMITS))
    assert stream.setpoint_deg == before
    assert stream.advance_setpoint(BENT_DEG, 0.01, PACE) is None
    assert stream.setpoint_deg[0] == before[0]
    assert stream.setpoint_deg[1] < before[1]


@pytest.mark.parametrize(
    "jog",
    [
        joints(1.0, -1.0, 0.5, 0, 1.0, -1.0),
        tool(0.7, -0.7, 0.2, 0, 0, 1.0),
        tool(-0.3, 0, 0.5, 0.5, 0, -0.5, frame=JogFrame.TOOL),
    ],
    ids=["joints", "base", "tool"],
)
def test_the_arm_rests_within_100_ms_of_the_last_word(rig, jog):
    bend(rig)
    accepted(rig.controller.jogging.start(jog))
    for tick in range(60):
        # a hand never holds still
        wave = 1.0 - 0.3 * math.sin(tick / 5) ** 2
        rates = tuple(rate * wave for rate in jog.rates)
        assert rig.controller.jogging.steer(SteeredJog(rates, jog.frame, DEVICE))
        hold(rig, TICK_S)
    assert rig.controller.jogging.active
    rig.controller.jogging.stop()
    assert rest_s(rig) <= 0.1


def test_a_reversed_stick_turns_the_arm_about_and_it_still_rests_in_time(rig):
    bend(rig)
    accepted(rig.controller.jogging.start(joints(1.0)))
    places = []
    for tick in range(80):
        assert rig.controller.jogging.steer(joints(1.0 if tick < 40 else -1.0))
        hold(rig, TICK_S)
        places.append(rig.firmware.joints_deg[0])
    assert max(places) > BENT_DEG[0] + 2.0
    assert places[-1] < max(places) - 1.0
    rig.controller.jogging.stop()
    assert rest_s(rig) <= 0.1


def test_the_tool_goes_where_it_is_steered_and_does_not_turn(rig):
    bend(rig)
    kinematics = Kinematics(PIPER)
    before = kinematics.matrix(rig.firmware.joints_deg)
    accepted(rig.controller.jogging.start(tool(0, 0, 1.0)))
    for tick in range(80):
        assert rig.controller.jogging.steer(tool(0, 0, 1.0) if tick < 40 else tool(0, -1.0))
        hold(rig, TICK_S)
    rig.controller.jogging.stop()
    rest_s(rig)
    after = kinematics.matrix(rig.firmware.joints_deg)
    x, y, z = after[:3, 3] - before[:3, 3]
    assert z > 5.0
    assert y < -5.0
    assert x == pytest.approx(0.0, abs=0.3)
    start, end = matrix_to_pose(before), matrix_to_pose(after)
    assert end[3:] == pytest.approx(start[3:], abs=0.1)


def test_nobody_steers_what_has_ended_or_is_another_hold(rig):
    bend(rig)
    jogging = rig.controller.jogging
    assert not jogging.steer(joints(1.0))
    accepted(jogging.start(joints(1.0)))
    assert not jogging.steer(tool(1.0))  # another frame is another jog
    assert jogging.steered == joints(1.0)
    jogging.stop()
    assert not jogging.steer(joints(1.0))
    assert jogging.steered is None


def test_what_moves_in_words():
    assert axes_text(joints(0.5, 0, -0.1)) == "J1+ J3−"
    assert axes_text(tool(0, -1.0, 0, 0, 0, 1.0)) == "Y− RZ+"
