"""S7: a motion that the arm never took is said to have vanished, and one that it took is not.

A control offset kept in the arm (0x470) is told by no feedback: our frames go past it.
"""

import pytest

from armui.control.motion.jog_path import JointJog
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import LinkageRole, MoveMode
from armui.protocol.frame import Frame
from armui.sim.parameters.settings import LinkageSettings
from tests.accepted import accepted

HERE = (10.0, 60.0, -70.0, 0.0, 40.0, 0.0)
TO_JOINTS = (20.0, 70.0, -60.0, 5.0, 30.0, 0.0)
STRETCHED = (0.0, 52.0, -62.0, 0.0, 21.0, 0.0)
TAKE_COMMAND = Frame(0x161, bytes.fromhex("01 02 0A 00 00 00 00 00"))
"""CAN control, MOVE L at 10 %, under the arm's own offset."""


def ready(rig, offset):
    """An enabled arm that listens under an offset of which its feedback tells nothing."""
    rig.lie(HERE)
    rig.firmware.settings.linkage = LinkageSettings(LinkageRole.MOTION_OUTPUT, 0x00, offset)
    rig.firmware._linkage.take_effect()
    rig.connect()
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: all(rig.controller.operating_state.enabled))
    accepted(rig.controller.motion.set_speed_percent(20))
    rig.run(0.5)
    return rig.controller


def up(controller, by_mm):
    x, y, z, *turns = controller.state.end_pose()
    return (x, y, z + by_mm, *turns)


MOTIONS = {
    "joints": lambda c: c.motion.send_joints(TO_JOINTS),
    "step": lambda c: c.motion.jog(6, 5.0),
    "pose": lambda c: c.cartesian.move(up(c, -20.0), MoveMode.MOVE_P),
    "line": lambda c: c.cartesian.move(up(c, -20.0), MoveMode.MOVE_L),
    "tool step": lambda c: c.cartesian.step(2, -20.0, JogFrame.BASE),
}
NOWHERE = {
    "joints": lambda c: c.motion.send_joints(c.state.angles_deg()),
    "step": lambda c: c.motion.jog(6, 0.1),
    "pose": lambda c: c.cartesian.move(up(c, 0.0), MoveMode.MOVE_P),
}


@pytest.mark.each_value(full="each motion in both generations")
@pytest.mark.parametrize("motion", MOTIONS.values(), ids=MOTIONS)
def test_it_is_said_of_an_arm_that_listens_elsewhere(any_rig, motion):
    rig = any_rig
    controller = ready(rig, 0x10)
    accepted(motion(controller))
    rig.run(2.0)
    assert rig.codes().count("motion_unheeded") == 1
    assert rig.firmware.joints_deg == pytest.approx(HERE, abs=0.01)


@pytest.mark.parametrize("motion", [MOTIONS["line"], MOTIONS["joints"]], ids=["line", "joints"])
def test_also_where_the_mode_of_before_looks_like_ours(rig, motion):
    controller = ready(rig, 0x10)
    rig.firmware.on_frame(TAKE_COMMAND)
    rig.run(0.5)
    accepted(motion(controller))
    rig.run(2.0)
    assert rig.codes().count("motion_unheeded") == 1


def test_a_held_jog_that_moves_nothing_is_said_to_move_nothing(rig):
    controller = ready(rig, 0x10)
    accepted(controller.jogging.start(JointJog(1, 1)))
    rig.run(2.0)
    controller.jogging.stop()
    rig.run(1.0)
    assert rig.codes().count("motion_unheeded") == 1


@pytest.mark.each_value(full="each motion in both generations")
@pytest.mark.parametrize("motion", MOTIONS.values(), ids=MOTIONS)
def test_nothing_is_said_of_a_motion_that_is_taken(any_rig, motion):
    controller = ready(any_rig, 0x00)
    accepted(motion(controller))
    any_rig.run(4.0)
    assert "motion_unheeded" not in any_rig.codes()


def test_nothing_is_said_of_a_small_step_of_the_tool_that_hardly_turns_the_joints(rig):
    controller = ready(rig, 0x00)
    accepted(controller.motion.send_joints(STRETCHED))
    rig.run(6.0)
    accepted(controller.cartesian.step(0, 1.02, JogFrame.BASE))
    rig.run(2.0)
    turned = zip(rig.firmware.joints_deg, STRETCHED, strict=True)
    assert 0.1 < max(abs(now - before) for now, before in turned) < 0.2
    assert "motion_unheeded" not in rig.codes()


@pytest.mark.parametrize("motion", NOWHERE.values(), ids=NOWHERE)
def test_nothing_is_said_of_a_motion_that_leads_nowhere(rig, motion):
    controller = ready(rig, 0x00)
    accepted(motion(controller))
    rig.run(2.0)
    assert "motion_unheeded" not in rig.codes()


def test_nothing_is_said_of_the_slowest_motion(rig):
    controller = ready(rig, 0x00)
    accepted(controller.motion.set_speed_percent(1))
    accepted(controller.motion.send_joints(TO_JOINTS))
    rig.run(3.0)
    assert "motion_unheeded" not in rig.codes()


def test_nothing_is_said_of_a_motion_that_was_stopped_or_cancelled_at_once(rig):
    controller = ready(rig, 0x00)
    controller.motion.send_joints(TO_JOINTS)
    controller.halt_and_hold()
    rig.run(2.0)
    controller.motion.send_joints(TO_JOINTS)
    controller.emergency_stop()
    rig.run(2.0)
    assert "motion_unheeded" not in rig.codes()


def test_the_next_step_starts_from_where_the_arm_is(rig):
    controller = ready(rig, 0x10)
    controller.motion.send_joints(TO_JOINTS)
    rig.run(2.0)
    assert controller.motion.setpoint_deg is None
