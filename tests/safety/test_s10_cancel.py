"""S10: what was cancelled stays cancelled, and the arm comes to rest or the window says so."""

import pytest

from armui.arm.frames import JogFrame
from armui.control.recovery_steps import Action, Kind
from armui.protocol.codes import TrajectoryCommand

FAR = (120.0, 60.0, -60.0, 0.0, 0.0, 0.0)


@pytest.fixture
def moving(any_bench):
    any_bench.ready()
    any_bench.controller.motion.set_speed_percent(60)
    assert any_bench.controller.motion.send_joints(FAR) is None
    any_bench.run(0.6)
    return any_bench


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
    bench, controller = moving, moving.controller
    assert controller.planned_motion.command(TrajectoryCommand.ABORT) is None
    bench.run(pause_s)
    later(controller)
    bench.run(2.5)

    assert bench.firmware.body.positions_deg[0] < 70.0
    assert not bench.firmware.body.moving


def test_an_arm_that_does_not_heed_a_cancel_is_said_and_the_stop_offered(moving):
    bench, controller = moving, moving.controller
    controller.motion.set_speed_percent(10)
    bench.node.line.lose_to_arm(0x150)
    assert controller.planned_motion.command(TrajectoryCommand.ABORT) is None
    bench.run(1.2)

    assert "cancel_unheeded" in bench.codes()
    assert controller.recovery.step.kind is Kind.CANCEL_UNHEEDED
    assert controller.recovery.step.action is Action.STOP

    controller.recovery.act(controller.recovery.step)
    bench.run(0.3)
    assert bench.firmware.condition.stopped


def test_an_arm_that_heeds_it_is_not_complained_of(moving):
    bench = moving
    assert bench.controller.planned_motion.command(TrajectoryCommand.ABORT) is None
    bench.run(2.0)

    assert "cancel_unheeded" not in bench.codes()
