"""S10: what was cancelled stays cancelled, and the arm comes to rest or the window says so."""

import pytest

from armui.control.safety.recovery_steps import Action, StepKind
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import TrajectoryCommand
from tests.accepted import accepted

FAR = (120.0, 60.0, -60.0, 0.0, 0.0, 0.0)


@pytest.fixture
def moving(any_rig):
    any_rig.ready()
    any_rig.controller.motion.set_speed_percent(60)
    accepted(any_rig.controller.motion.send_joints(FAR))
    any_rig.run(0.6)
    return any_rig


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
    rig.node.link.lose_to_arm(0x150)
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
