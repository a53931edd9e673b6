"""S11: a motion held back is shown, counts as moving, and goes on only by the operator's word."""

import pytest

from armui.control.motion_command import Hold
from armui.control.recovery_steps import Action, Kind
from armui.protocol.codes import TrajectoryCommand

FAR = (80.0, 40.0, -40.0, 0.0, 0.0, 0.0)


@pytest.fixture(params=["speed", "pause"])
def held(request, any_bench):
    bench, controller = any_bench, any_bench.controller
    bench.ready()
    assert controller.motion.send_joints(FAR) is None
    bench.run(0.6)
    if request.param == "speed":
        controller.motion.set_speed_percent(0)
    else:
        assert controller.planned_motion.command(TrajectoryCommand.PAUSE) is None
    bench.run(1.5)
    assert not bench.firmware.body.moving
    return bench


def test_it_is_shown_and_counts_as_moving(held):
    situation = held.controller.situation
    assert situation.moving
    assert situation.holds
    assert situation.occupied is not None
    assert held.controller.recovery.step.kind in {Kind.PAUSED, Kind.HELD_AT_ZERO}
    assert held.controller.recovery.step.held
    assert held.controller.recovery.step.alternative is Action.GIVE_UP


def test_no_other_command_sets_it_going(held):
    bench, controller = held, held.controller
    stood_deg = bench.firmware.body.positions_deg
    bench.run(120.0 / 20)
    controller.motion.set_speed_percent(30)
    bench.run(0.5)
    controller.motion.jog(6, 1.0)
    controller.motion.send_joints(FAR)
    controller.motors.enable()
    bench.run(3.0)

    assert bench.firmware.body.positions_deg == pytest.approx(stood_deg, abs=0.01)
    assert controller.situation.holds


def test_it_goes_on_by_continue_at_the_speed_that_is_shown(held):
    bench, controller = held, held.controller
    controller.motion.set_speed_percent(50)
    step = controller.recovery.step
    assert controller.recovery.act(step) is None
    bench.run(4.0)

    assert bench.firmware.body.positions_deg == pytest.approx(FAR, abs=0.01)
    assert bench.firmware.condition.speed_percent == 50
    assert not controller.situation.holds


def test_it_is_dropped_for_good(held):
    bench, controller = held, held.controller
    stood_deg = bench.firmware.body.positions_deg
    assert controller.recovery.act(controller.recovery.step, Action.GIVE_UP) is None
    bench.run(0.5)
    controller.motion.set_speed_percent(60)
    bench.run(2.0)

    assert bench.firmware.body.positions_deg == pytest.approx(stood_deg, abs=0.01)
    assert not controller.situation.holds
    assert controller.situation.cannot_move is None


def test_it_does_not_go_on_at_zero_percent(any_bench):
    bench, controller = any_bench, any_bench.controller
    bench.ready()
    assert controller.motion.send_joints(FAR) is None
    bench.run(0.6)
    controller.motion.set_speed_percent(0)
    bench.run(1.0)

    refusal = controller.planned_motion.command(TrajectoryCommand.CONTINUE)

    assert refusal.code == "speed_zero"
    assert controller.situation.holds == {Hold.SPEED_ZERO}


def test_it_is_not_forgotten_while_the_arm_is_silent(held):
    bench, controller = held, held.controller
    bench.node.line.mute_on.update({0x2A1, 0x2A5, 0x2A6, 0x2A7})
    bench.run(1.0)
    bench.node.line.mute_on.clear()
    bench.run(0.5)

    assert controller.situation.holds
    assert controller.motion.jog(6, 1.0) is not None


def test_it_is_not_forgotten_over_a_lost_cable(held):
    bench, controller = held, held.controller
    bench.node.line.off = True
    bench.run(2.0)
    bench.node.line.off = False
    bench.run(3.0)
    stood_deg = bench.firmware.body.positions_deg
    controller.motion.set_speed_percent(60)
    bench.run(1.0)

    assert controller.situation.holds
    assert bench.firmware.body.positions_deg == pytest.approx(stood_deg, abs=0.01)
