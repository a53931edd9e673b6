"""S25: in a mode another host has chosen, no mode word of ours lets the arm fall."""

import pytest

from armui.arm.refusal_codes import RefusalCode
from armui.control.safety.recovery_steps import Action, StepKind
from armui.protocol.codes import TrajectoryCommand
from tests.sim.test_direct_control import STIFF, hold

A = (10.0, 45.0, -45.0, 0.0, 20.0, 0.0)
MIT = "151#010600AD00000000"
HIGH_FOLLOW = "151#010100AD00000000"
CPV = "151#0105320000000000"


@pytest.fixture
def raised(rig):
    """An arm that would fall if it went limp."""
    rig.ready()
    rig.controller.motion.set_speed_percent(60)
    assert rig.controller.motion.send_joints(A) is None
    rig.run(4.0)
    return rig


@pytest.mark.parametrize(
    ("word", "mode"), [(MIT, "mit"), (HIGH_FOLLOW, "high_follow"), (CPV, "cpv")]
)
def test_no_mode_word_of_ours_goes_out(raised, other_host, word, mode):
    rig, controller = raised, raised.controller
    other_host.say(word)
    rig.run(5.0)
    rig.heard()

    controller.motion.set_speed_percent(10)
    refusals = [
        controller.motion.jog(6, 1.0),
        controller.motion.send_joints(A),
        controller.planned_motion.command(TrajectoryCommand.CONTINUE),
    ]
    rig.run(3.0)

    assert rig.heard() == []
    assert {refusal.code for refusal in refusals[:2]} == {"other_mode"}
    assert refusals[0].params["other_mode"] == mode
    assert controller.recovery.step.kind is StepKind.OTHER_MODE


def test_the_speed_slider_lets_no_arm_fall(raised, other_host):
    rig = raised
    other_host.say(MIT, *hold(A, **STIFF))
    rig.run(0.5)
    for percent in (10, 0, 100):
        rig.controller.motion.set_speed_percent(percent)
        rig.run(0.5)

    assert rig.firmware.joints_deg == pytest.approx(A, abs=1.0)


def resume_and_enable(rig):
    rig.run(0.5)
    assert rig.controller.motors.resume() is None
    rig.run(3.0)
    assert rig.controller.motors.enable() is None
    rig.run(1.0)


def test_the_way_back_is_the_reset(raised, other_host):
    rig, controller = raised, raised.controller
    other_host.say(MIT)
    rig.run(3.0)
    step = controller.recovery.step
    assert step.action is Action.RESET
    assert step.dangerous

    assert controller.recovery.act(step) is None
    resume_and_enable(rig)
    assert controller.operating_state.cannot_move is None


def test_high_follow_is_over_after_the_reset(raised, other_host):
    rig, controller = raised, raised.controller
    other_host.say(HIGH_FOLLOW)
    rig.run(3.0)
    assert controller.operating_state.cannot_move.code == RefusalCode.OTHER_MODE
    controller.emergency_stop()
    resume_and_enable(rig)
    assert controller.operating_state.cannot_move is None
