"""S25: in a mode another host has chosen, no mode word of ours lets the arm fall."""

import pytest

from armui.control.recovery_steps import Action, Kind
from armui.protocol.codes import TrajectoryCommand
from tests.sim.test_direct_control import hold

A = (10.0, 45.0, -45.0, 0.0, 20.0, 0.0)
MIT = "151#010400AD00000000"
HIGH_FOLLOW = "151#010100AD00000000"
CPV = "151#0105320000000000"


@pytest.fixture
def raised(bench):
    """An arm that would fall if it went limp."""
    bench.ready()
    bench.controller.motion.set_speed_percent(60)
    assert bench.controller.motion.send_joints(A) is None
    bench.run(4.0)
    return bench


@pytest.mark.parametrize(
    ("word", "mode"), [(MIT, "mit"), (HIGH_FOLLOW, "high_follow"), (CPV, "cpv")]
)
def test_no_mode_word_of_ours_goes_out(raised, other_host, word, mode):
    bench, controller = raised, raised.controller
    other_host.say(word)
    bench.run(5.0)
    bench.heard()

    controller.motion.set_speed_percent(10)
    refusals = [
        controller.motion.jog(6, 1.0),
        controller.motion.send_joints(A),
        controller.planned_motion.command(TrajectoryCommand.CONTINUE),
    ]
    bench.run(3.0)

    assert bench.heard() == []
    assert {refusal.code for refusal in refusals[:2]} == {"other_mode"}
    assert refusals[0].params["other_mode"] == mode
    assert controller.recovery.step.kind is Kind.OTHER_MODE


def test_the_speed_slider_lets_no_arm_fall(raised, other_host):
    bench = raised
    other_host.say(MIT, *hold(A))
    bench.run(0.5)
    for percent in (10, 0, 100):
        bench.controller.motion.set_speed_percent(percent)
        bench.run(0.5)

    assert bench.firmware.joints_deg == pytest.approx(A, abs=1.0)


def test_the_way_back_is_the_reset(raised, other_host):
    bench, controller = raised, raised.controller
    other_host.say(MIT)
    bench.run(3.0)
    step = controller.recovery.step
    assert step.action is Action.RESET
    assert step.dangerous

    assert controller.recovery.act(step) is None
    bench.run(0.5)
    assert controller.motors.resume() is None
    bench.run(3.0)
    assert controller.motors.enable() is None
    bench.run(1.0)

    assert controller.situation.cannot_move is None


def test_high_follow_is_over_after_the_reset(raised, other_host):
    bench, controller = raised, raised.controller
    other_host.say(HIGH_FOLLOW)
    bench.run(3.0)
    assert controller.situation.cannot_move.code == "other_mode"
    controller.emergency_stop()
    bench.run(0.5)
    assert controller.motors.resume() is None
    bench.run(3.0)
    assert controller.motors.enable() is None
    bench.run(1.0)

    assert controller.situation.cannot_move is None
