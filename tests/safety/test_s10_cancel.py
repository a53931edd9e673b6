"""S10: what was cancelled stays cancelled, and the arm comes to rest or the window says so."""

import pytest

from armui.control.safety.recovery_steps import Action, StepKind
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import TrajectoryCommand
from armui.protocol.frame import Frame
from tests.accepted import accepted
from tests.company import OtherHost

FAR = (120.0, 60.0, -60.0, 0.0, 0.0, 0.0)


@pytest.fixture
def moving(any_rig):
    any_rig.ready()
    any_rig.controller.motion.set_speed_percent(60)
    accepted(any_rig.controller.motion.send_joints(FAR))
    any_rig.run(0.6)
    return any_rig


@pytest.mark.each_pair(full="each command after each pause, both generations")
@pytest.mark.parametrize(
    "later",
    [
        lambda controller: controller.motion.jog(6, 1.0),
        lambda controller: controller.motion.set_speed_percent(100),
        lambda controller: controller.cartesian.step(2, 1.0, JogFrame.BASE),
        lambda controller: controller.planned_motion.command(TrajectoryCommand.CONTINUE),
        lambda controller: controller.motors.enable(),
    ],
    ids=["joint step", "speed", "tool step", "continue", "enable"],
)
@pytest.mark.parametrize("pause_s", [0.02, 0.4])
def test_nothing_revives_a_cancelled_target(moving, later, pause_s):
    rig, controller = moving, moving.controller
    accepted(controller.planned_motion.command(TrajectoryCommand.ABORT))
    rig.run(pause_s)
    later(controller)
    rig.run(2.5)

    assert rig.firmware.mechanics.positions_deg[0] < 70.0
    assert not rig.firmware.mechanics.moving


def test_an_arm_that_does_not_heed_a_cancel_is_said_and_the_stop_offered(moving):
    rig, controller = moving, moving.controller
    controller.motion.set_speed_percent(10)
    rig.node.link.lose_to_arm(0x150, 2)  # when it is told once more, too
    accepted(controller.planned_motion.command(TrajectoryCommand.ABORT))
    rig.run(1.2)

    assert "cancel_unheeded" in rig.codes()
    assert controller.recovery.step.kind is StepKind.CANCEL_UNHEEDED
    assert controller.recovery.step.action is Action.STOP

    controller.recovery.act(controller.recovery.step)
    rig.run(0.3)
    assert rig.firmware.condition.stopped


def test_an_arm_that_heeds_it_is_not_complained_of(moving):
    rig = moving
    accepted(rig.controller.planned_motion.command(TrajectoryCommand.ABORT))
    rig.run(2.0)

    assert "cancel_unheeded" not in rig.codes()


@pytest.mark.each_value(full="each end in both generations")
@pytest.mark.parametrize("how", ["terminate", "halt", "failure"])
def test_an_end_that_was_lost_is_told_once_more(moving, how):
    rig, controller = moving, moving.controller
    rig.node.link.lose_to_arm(0x150)
    rig.heard()
    if how == "halt":
        assert controller.halt_and_hold() is None
    elif how == "failure":
        controller.on_failure()
    else:
        accepted(controller.planned_motion.command(TrajectoryCommand.ABORT))
    rig.run(0.25)
    assert rig.firmware.mechanics.moving
    rig.run(1.0)
    assert not rig.firmware.mechanics.moving
    assert rig.firmware.mechanics.positions_deg[0] < 100.0
    ends = [one for one in rig.heard() if one.arbitration_id == 0x150]
    assert {bytes(one.data) for one in ends} == {bytes([0, 6, 0, 0, 0, 0, 0, 0])}
    assert len(ends) == 2


@pytest.mark.each_value(full="each command in both generations")
@pytest.mark.parametrize("after", ["stop", "another host's motion", "a motion of ours", "a hand"])
def test_an_end_is_not_told_again_after_what_came_since(moving, after):
    rig, controller = moving, moving.controller
    rig.node.link.lose_to_arm(0x150)
    accepted(controller.planned_motion.command(TrajectoryCommand.ABORT))
    rig.run(0.1)
    rig.heard()
    if after == "stop":
        controller.emergency_stop()
    elif after == "another host's motion":
        other = OtherHost(rig)
        other.move_to((0.0, 20.0, -20.0, 0.0, 0.0, 0.0), 30)
        other.close()
    elif after == "a hand":  # by the arm's own button
        rig.firmware.on_frame(Frame(0x150, bytes([0, 0, 1, 0, 0, 0, 0, 0])))
        rig.firmware.hand_guiding.lead_to((0.0, 20.0, -20.0, 0.0, 0.0, 0.0), speed_deg_s=20.0)
    else:
        accepted(controller.motion.send_joints((0.0, 20.0, -20.0, 0.0, 0.0, 0.0)))
    rig.run(1.5 if after != "a motion of ours" else 3.0)
    heard = list(rig.heard())
    if after == "a motion of ours":
        # the arm brakes for it: once it is sent, no end follows it
        sent = [one.arbitration_id for one in heard]
        heard = heard[sent.index(0x155) :]
        assert rig.firmware.joints_deg[1] == pytest.approx(20.0, abs=1.0)
    assert bytes([0, 6, 0, 0, 0, 0, 0, 0]) not in {bytes(one.data) for one in heard}


@pytest.mark.parametrize(
    "end",
    [
        lambda controller: controller.planned_motion.command(TrajectoryCommand.ABORT),
        lambda controller: controller.halt_and_hold(),
        lambda controller: controller.end_motion(single=True),
    ],
    ids=["abort", "halt", "end"],
)
def test_a_target_whose_mode_word_was_lost_is_not_set_going_by_the_next_one(any_rig, end):
    rig, controller = any_rig, any_rig.controller
    rig.ready()
    rig.node.link.lose_to_arm(0x151)
    accepted(controller.motion.send_joints(FAR))
    end(controller)
    controller.motion.set_speed_percent(20)
    rig.run(1.0)

    assert rig.firmware.mechanics.positions_deg[0] == pytest.approx(0.0, abs=0.01)
