"""From one kind of tool motion to another: each pose is taken for what it was meant."""

import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from tests.accepted import accepted
from tests.family import PIPER

FIRST, SECOND, THIRD = (
    tuple(Kinematics(PIPER).forward(joints_deg))
    for joints_deg in (
        (20.0, 40.0, -40.0, 10.0, 20.0, 15.0),
        (10.0, 45.0, -45.0, 5.0, 20.0, 5.0),
        (-5.0, 40.0, -40.0, 5.0, 20.0, 0.0),
    )
)


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    any_rig.controller.motion.set_speed_percent(100)
    any_rig.controller.cartesian.prepare()
    accepted(any_rig.controller.motion.send_joints((20.0, 40.0, -40.0, 10.0, 20.0, 15.0)))
    arrived(any_rig, FIRST)
    return any_rig


def arrived(rig, pose):
    rig.run(0.2)
    rig.run_until(lambda: not rig.controller.operating_state.moving)
    assert rig.controller.state.end_pose()[:3] == pytest.approx(pose[:3], abs=0.05)


def test_lines_and_point_to_point_may_follow_one_another(ready):
    cartesian = ready.controller.cartesian
    for move_mode, pose in (
        (MoveMode.MOVE_L, SECOND),
        (MoveMode.MOVE_P, FIRST),
        (MoveMode.MOVE_P, SECOND),
        (MoveMode.MOVE_L, FIRST),
    ):
        accepted(cartesian.move(pose, move_mode))
        arrived(ready, pose)


def test_an_arc_may_follow_a_line_and_a_line_an_arc(ready):
    cartesian = ready.controller.cartesian
    accepted(cartesian.move(SECOND, MoveMode.MOVE_L))
    arrived(ready, SECOND)
    accepted(cartesian.move(FIRST, MoveMode.MOVE_L))
    arrived(ready, FIRST)
    accepted(cartesian.move_arc(FIRST, SECOND, THIRD))
    arrived(ready, THIRD)
    accepted(cartesian.move(SECOND, MoveMode.MOVE_L))
    arrived(ready, SECOND)
