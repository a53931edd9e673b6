"""Each arm of the family moves its tool as asked: steps, poses, lines, arcs, held axes."""

import math

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.control.motion.jog_path import ToolJog
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import JogFrame
from armui.kinematics.poses import Pose, apart
from armui.protocol.codes import MoveMode
from tests.accepted import accepted
from tests.family import MODELS, ranges
from tests.trajectory.arms import collisions

READY_DEG = (10.0, 80.0, -80.0, 10.0, 35.0, 5.0)


@pytest.fixture
def arm_repeats():
    return True  # it is looked at between two steps


@pytest.fixture(params=MODELS)
def model(request):
    return request.param


@pytest.fixture(params=["S-V1.8-9", "S-V1.5-2"])
def version(request):
    return request.param


@pytest.fixture
def standing(rig, model, version):
    rig.lie(READY_DEG, model, version=version)
    rig.connect(model)
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
    rig.controller.motion.set_speed_percent(60)
    return rig


def place(rig, model):
    """Where the simulated arm's flange truly is."""
    geometry = model_data(model).geometry_of(rig.firmware.type.version)
    return Kinematics(geometry).forward(rig.firmware.joints_deg)


def arrived(rig):
    rig.run(0.3)
    rig.run_until(lambda: not rig.controller.operating_state.moving)


@pytest.mark.each_pair(full="each step of each model in both versions")
@pytest.mark.parametrize(("axis", "amount"), [(0, 25.0), (1, -20.0), (2, -30.0), (5, 8.0)])
def test_a_step_of_the_tool_goes_where_it_was_asked(standing, model, axis, amount):
    before = place(standing, model)

    accepted(standing.controller.cartesian.step(axis, amount, JogFrame.BASE))
    arrived(standing)

    after = place(standing, model)
    moved = np.array(after[:3]) - np.array(before[:3])
    wanted = np.zeros(3)
    if axis < 3:
        wanted[axis] = amount
    assert moved == pytest.approx(wanted, abs=0.05)
    assert apart(after, before)[1] == pytest.approx(amount if axis == 5 else 0.0, abs=0.02)


@pytest.mark.each_value(full="each model in both versions")
def test_a_pose_a_line_and_an_arc(standing, model):
    cartesian = standing.controller.cartesian
    x, y, z, rx, ry, rz = place(standing, model)
    for target, move in (
        ((x, y + 40, z - 30, rx, ry, rz), MoveMode.MOVE_P),
        ((x + 10, y - 20, z, rx, ry, rz), MoveMode.MOVE_L),
    ):
        accepted(cartesian.move(target, move))
        arrived(standing)
        off_mm, off_deg = apart(place(standing, model), Pose(*target))
        assert (off_mm, off_deg) == pytest.approx((0.0, 0.0), abs=0.05)

    start = place(standing, model)
    middle = (start[0] - 15, start[1] + 15, *start[2:])
    end = (start[0] - 30, start[1], *start[2:])
    accepted(cartesian.move_arc(start, middle, end))
    arrived(standing)
    assert math.dist(place(standing, model)[:3], end[:3]) < 0.05


@pytest.mark.each_value(full="each model in both versions")
def test_a_held_axis_moves_the_tool_straight(standing, model):
    before = place(standing, model)
    jogging = standing.controller.jogging
    accepted(jogging.start(ToolJog(2, -1, JogFrame.BASE)))
    for _ in range(50):
        jogging.tick()
        standing.step(0.01)
    jogging.stop()
    standing.run(0.5)

    after = place(standing, model)
    assert after[2] < before[2] - 1.0
    assert after[:2] == pytest.approx(before[:2], abs=0.1)
    assert apart(after, before)[1] < 0.1


def test_no_arm_is_said_to_touch_itself_where_it_lies_or_stands(model):
    data = model_data(model)
    poses = np.array([(0.0,) * 6, READY_DEG, (0.0, 90.0, -90.0, 0.0, 0.0, 0.0)])
    found = collisions(data.geometry, poses, data.gripper.reach_mm, data.gripper.turned_deg)
    assert found == {}


def test_a_gripper_led_into_the_column_is_found_on_every_arm(model):
    """Of random poses some touch, and most do not: the capsules are those of an arm."""
    data = model_data(model)
    low, high = ranges(model)
    joints = np.random.default_rng(6).uniform(low, high, size=(3000, 6))
    found = collisions(data.geometry, joints, data.gripper.reach_mm, data.gripper.turned_deg)
    assert 0.02 < len(found) / len(joints) < 0.5
    assert {"base/gripper", "base/hand"} <= set(found.values())
