"""S9: no motion frame leaves unless the status and all six joint angles are heard."""

import pytest

from armui.control.motion.cartesian import POSE_UNKNOWN
from armui.control.motion.jog_path import JointJog
from armui.control.motion.point_frames import ARC_START_UNKNOWN
from armui.control.run.progress import Run
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint
from tests.accepted import accepted
from tests.safety.talk import MOTION_IDS

A = (30.0, 30.0, -30.0, 0.0, 0.0, 0.0)
BENT = (-50.0, 0.0, 20.0, 0.0)


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    accepted(any_rig.controller.motion.send_joints(A))
    any_rig.run(4.0)
    any_rig.heard()
    return any_rig


@pytest.mark.each_value(full="each silence in both generations")
@pytest.mark.parametrize("silent", [0x2A1, 0x2A5, 0x2A6, 0x2A7])
def test_nothing_moves_an_arm_that_is_not_heard(ready, silent):
    rig, controller = ready, ready.controller
    rig.node.link.mute_on.add(silent)
    rig.run(0.7)
    assert controller.operating_state.link.name == "ONLINE"

    refusals = [
        controller.motion.jog(6, 1.0),
        controller.motion.send_joints(A),
        controller.motion.go_home(),
        controller.cartesian.step(2, 1.0, JogFrame.BASE),
        controller.cartesian.move((300, 0, 300, 0, 90, 0), MoveMode.MOVE_P),
    ]
    controller.motion.set_speed_percent(80)
    rig.run(0.5)

    assert [refusal.code for refusal in refusals] == ["feedback_silent"] * len(refusals)
    assert {refusal.params["frames"] for refusal in refusals} == {f"0x{silent:X}"}
    assert not [frame for frame in rig.heard() if frame.arbitration_id in MOTION_IDS]


def test_a_jog_ends_when_the_angles_fall_silent(ready):
    rig, controller = ready, ready.controller
    accepted(controller.jogging.start(JointJog(6, 1)))
    rig.run(0.3)
    rig.node.link.mute_on.update({0x2A5, 0x2A6, 0x2A7})
    rig.run(0.12)

    assert not controller.jogging.active


@pytest.mark.each_value(full="each silence in both generations")
@pytest.mark.parametrize("silent", [0x2A2, 0x2A3, 0x2A4])
def test_a_pose_that_is_not_heard_is_none(ready, silent):
    """The arm goes elsewhere meanwhile: no arc begins, and no step is measured, at its old pose."""
    rig, controller = ready, ready.controller
    forward = controller.cartesian.kinematics().forward
    begin, *more = ((40.0, 50.0, *BENT), (50.0, 55.0, *BENT), (60.0, 50.0, *BENT))
    middle, end = (tuple(forward(each)) for each in more)
    points = [Waypoint(MoveMode.MOVE_J, begin), Waypoint(MoveMode.MOVE_C, end, middle)]
    rig.node.link.mute_on.add(silent)
    accepted(controller.player.start(Run("arc", points, [2.0, 2.0])))
    rig.run(4.0)

    assert controller.player.progress.refusal == ARC_START_UNKNOWN()
    assert controller.cartesian.step(2, 1.0, JogFrame.BASE) == POSE_UNKNOWN()
    assert controller.state.end_pose() is None
    assert rig.firmware.joints_deg[0] == pytest.approx(40.0, abs=0.1)


def test_the_word_for_it_names_every_frame_that_is_missing(ready):
    rig = ready
    rig.node.link.mute_on.update({0x2A1, 0x2A6})
    rig.run(0.7)

    assert rig.controller.operating_state.cannot_move.params["frames"] == "0x2A1, 0x2A6"
