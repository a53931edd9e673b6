"""Steps, jogs and typed targets in a user frame end where scipy's rotations have them."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.control.motion.jog_path import ToolJog
from armui.control.motion.steered_path import SteeredJog
from armui.control.run.preflight import CheckBasis
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.points.program import Trajectory, Waypoint
from tests.accepted import accepted
from tests.control.jogger import bend, hold, release, rest_s
from tests.family import PIPER

TOOL = (10.0, -20.0, 80.0, 0.0, 30.0, 0.0)
RAMP = UserFrame("ramp", (240.0, 30.0, 90.0, 25.0, -35.0, 130.0))


BENCH = with_part(with_part(Cell("bench"), Tool("tip", TOOL)), RAMP)


def in_force(rig):
    """At a comfortable pose, with a cell whose tool and frame are in force."""
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    rig.heard()


def turn_of(pose):
    return Rotation.from_euler("xyz", pose[3:], degrees=True)


def tip(rig):
    """Where the simulated arm's tip is: its place, and its rotation by scipy."""
    flange = Kinematics(PIPER).forward(rig.firmware.joints_deg)
    turn = turn_of(flange)
    tool = rig.controller.cartesian.tool
    return np.array(flange[:3]) + turn.apply(tool[:3]), turn * turn_of(tool)


def settle(rig):
    rig.run(0.1)
    rig.run_until(lambda: not rig.controller.operating_state.moving)
    rig.run(0.4)


@pytest.mark.each_value(full="each axis there and back")
@pytest.mark.parametrize("axis", range(6))
@pytest.mark.parametrize("amount", [10.0, -4.0])
def test_a_step_goes_along_or_about_an_axis_of_the_frame(rig, axis, amount):
    in_force(rig)
    before_mm, before = tip(rig)
    accepted(rig.controller.cartesian.step(axis, amount, RAMP))
    settle(rig)
    after_mm, after = tip(rig)
    direction = turn_of(RAMP.pose).as_matrix()[:, axis % 3]
    if axis < 3:
        assert after_mm == pytest.approx(before_mm + amount * direction, abs=0.05)
        assert (before.inv() * after).magnitude() < np.radians(0.02)
    else:
        expected = Rotation.from_rotvec(np.radians(amount) * direction) * before
        assert after_mm == pytest.approx(before_mm, abs=0.05)
        assert (expected.inv() * after).magnitude() < np.radians(0.02)


def test_random_frames_step_where_scipy_has_it(rig):
    in_force(rig)
    random = np.random.default_rng(7)
    for number in range(8):
        pose = (*random.uniform(-400.0, 400.0, 3), *random.uniform(-85.0, 85.0, 3))
        frame = UserFrame(f"f{number}", tuple(round(float(each), 3) for each in pose))
        cell = rig.controller.cell.cell
        accepted(rig.controller.cell.change(with_part(cell, frame)))
        before_mm, _before = tip(rig)
        accepted(rig.controller.cartesian.step(0, 10.0, frame))
        settle(rig)
        expected = before_mm + 10.0 * turn_of(frame.pose).as_matrix()[:, 0]
        assert tip(rig)[0] == pytest.approx(expected, abs=0.05)
        accepted(rig.controller.cartesian.step(0, -10.0, frame))
        settle(rig)


JOGS = {
    "held": lambda axis, way: ToolJog(axis, way, RAMP),
    "steered": lambda axis, way: SteeredJog(
        tuple(float(way) if each == axis else 0.0 for each in range(6)), RAMP, "pad"
    ),
}


@pytest.mark.each_value(full="each axis in each frame")
@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("how", JOGS)
def test_a_jog_stays_on_the_axis_of_the_frame(rig, axis, how):
    in_force(rig)
    jog = JOGS[how](axis, -1)
    before_mm, before = tip(rig)
    accepted(rig.controller.jogging.start(jog))
    for _ in range(30):
        if how == "steered":
            assert rig.controller.jogging.steer(jog)
        hold(rig, 0.02)
    release(rig)
    rest_s(rig)
    after_mm, after = tip(rig)
    along = -turn_of(RAMP.pose).as_matrix()[:, axis]
    gone_mm = float((after_mm - before_mm) @ along)
    assert gone_mm > 5.0
    assert after_mm == pytest.approx(before_mm + gone_mm * along, abs=0.05)
    assert (before.inv() * after).magnitude() < np.radians(0.05)


def test_a_pose_of_the_frame_is_sent_as_one_of_the_base(rig):
    in_force(rig)
    cartesian = rig.controller.cartesian
    place_mm, turn = tip(rig)
    frame = turn_of(RAMP.pose)
    own_mm = frame.inv().apply(place_mm - np.array(RAMP.pose[:3]))
    shown = cartesian.in_frame(cartesian.tool_pose(rig.controller.state))
    assert shown[:3] == pytest.approx(own_mm, abs=0.01)
    assert (turn_of(shown).inv() * frame.inv() * turn).magnitude() < 1e-4
    wanted = (own_mm[0] + 12.0, own_mm[1] - 7.0, own_mm[2] + 5.0, *shown[3:])
    accepted(cartesian.move(cartesian.in_base(wanted), MoveMode.MOVE_L))
    settle(rig)
    expected = np.array(RAMP.pose[:3]) + frame.apply(wanted[:3])
    assert tip(rig)[0] == pytest.approx(expected, abs=0.05)


def test_the_log_names_the_axis_with_its_frame_and_the_frame_of_what_was_sent(rig):
    in_force(rig)
    accepted(rig.controller.cartesian.step(1, 2.0, RAMP))
    assert rig.events[-1].params["axis"] == "Y (ramp)"
    settle(rig)
    accepted(rig.controller.jogging.start(ToolJog(2, 1, RAMP)))
    assert rig.events[-1].params["axis"] == "Z (ramp)"
    accepted(rig.controller.jogging.start(JOGS["steered"](0, 1)))
    assert rig.events[-1].code == "device_jogs_frame"
    assert rig.events[-1].params["frame"] == "ramp"


def test_another_shown_frame_leaves_a_check_valid_and_another_place_does_not(rig):
    """The place of a frame counts for those points alone that name it."""
    in_force(rig)
    cells = rig.controller.cell
    pose = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
    contents = [
        Trajectory("t", points=(Waypoint(MoveMode.MOVE_P, pose, frame=frame),))
        for frame in ("ramp", "")
    ]

    def bases():
        return [CheckBasis.of(rig.controller, RunOptions(), each) for each in contents]

    def why_others():
        pairs = zip(before, bases(), strict=True)
        return [one.why_other(now) and one.why_other(now).code for one, now in pairs]

    before = bases()
    accepted(cells.change(replace(BENCH, frame="")))
    assert why_others() == [None, None]
    accepted(cells.change(replace(BENCH, frames=(UserFrame("ramp"),))))
    assert why_others() == ["changed_since_check", None]
