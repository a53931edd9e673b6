"""S11: a motion held back is shown, counts as moving, and goes on only by the operator's word."""

import pytest

from armui.arm.refusal import Refusal
from armui.control.motion.motion_command import Hold
from armui.control.safety.interlocks import SPEED_ZERO
from armui.control.safety.recovery_steps import Action, StepKind
from armui.protocol.codes import MotionState, Mounting, TrajectoryCommand
from armui.protocol.generation import Generation
from tests.accepted import accepted
from tests.company import OtherHost
from tests.sim.talk import mode

FAR = (80.0, 40.0, -40.0, 0.0, 0.0, 0.0)


@pytest.fixture(params=["speed", "pause"])
def held(request, any_rig):
    rig, controller = any_rig, any_rig.controller
    rig.ready()
    accepted(controller.motion.send_joints(FAR))
    rig.run(0.6)
    if request.param == "speed":
        controller.motion.set_speed_percent(0)
    else:
        accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.run(1.5)
    assert not rig.firmware.mechanics.moving
    return rig


def test_it_is_shown_and_counts_as_moving(held):
    operating_state = held.controller.operating_state
    assert operating_state.moving
    assert operating_state.holds
    assert operating_state.occupied is not None
    assert held.controller.recovery.step.kind in {StepKind.PAUSED, StepKind.HELD_AT_ZERO}
    assert held.controller.recovery.step.held
    assert held.controller.recovery.step.alternative is Action.GIVE_UP


@pytest.mark.parametrize("held_up_s", [0.0, 0.4])
@pytest.mark.parametrize("press", ["speed", "pause"])
def test_one_held_back_at_its_press_stays_so_whatever_the_arm_reports_of_before(
    rig, press, held_up_s
):
    """It says standby and arrived, until the frames of the motion have left and are taken in."""
    controller = rig.controller
    rig.ready()
    if held_up_s:
        rig.hold_driver()
    accepted(controller.motion.send_joints(FAR))
    if press == "speed":
        accepted(controller.motion.set_speed_percent(0))
    else:
        accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.step(0.01)
    rig.run(held_up_s)
    rig.free_driver()
    rig.run(0.6)
    assert controller.operating_state.holds
    accepted(controller.motion.set_speed_percent(30))
    rig.run(0.5)
    assert not rig.firmware.mechanics.moving
    accepted(controller.planned_motion.command(TrajectoryCommand.CONTINUE))
    rig.run(0.3)
    assert rig.firmware.mechanics.moving


@pytest.mark.parametrize("ended_by", ["halt", "another motion"])
@pytest.mark.parametrize("press", ["speed", "pause"])
def test_nothing_is_held_back_of_a_motion_that_brakes_at_its_end(rig, press, ended_by):
    controller = rig.controller
    rig.ready()
    accepted(controller.motion.send_joints(FAR))
    rig.run(0.6)
    if ended_by == "halt":
        assert controller.halt_and_hold() is None
    else:
        accepted(controller.motion.send_joints((0.0,) * 6))
    if press == "speed":
        accepted(controller.motion.set_speed_percent(0))
    else:
        accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.run(1.5)
    assert not controller.operating_state.holds
    accepted(controller.motion.set_speed_percent(30))
    assert not controller.operating_state.moving
    accepted(controller.motion.send_joints(FAR))
    rig.run(0.4)
    assert rig.firmware.mechanics.moving


@pytest.mark.each_value(full="each motion held back, in both generations")
def test_no_other_command_sets_it_going(held):
    rig, controller = held, held.controller
    stood_deg = rig.firmware.mechanics.positions_deg
    rig.run(120.0 / 20)
    controller.motion.set_speed_percent(30)
    rig.run(0.5)
    controller.motion.jog(6, 1.0)
    controller.motion.send_joints(FAR)
    controller.motors.enable()
    rig.run(3.0)

    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.01)
    assert controller.operating_state.holds


@pytest.mark.each_value(full="each motion held back, in both generations")
def test_it_goes_on_by_continue_at_the_speed_that_is_shown(held):
    rig, controller = held, held.controller
    controller.motion.set_speed_percent(50)
    step = controller.recovery.step
    assert controller.recovery.act(step) is None
    rig.run(4.0)

    assert rig.firmware.mechanics.positions_deg == pytest.approx(FAR, abs=0.01)
    assert rig.firmware.condition.speed_percent == 50
    assert not controller.operating_state.holds


@pytest.mark.each_value(full="each motion held back, in both generations")
def test_it_is_dropped_for_good(held):
    rig, controller = held, held.controller
    stood_deg = rig.firmware.mechanics.positions_deg
    assert controller.recovery.act(controller.recovery.step, Action.GIVE_UP) is None
    rig.run(0.5)
    controller.motion.set_speed_percent(60)
    rig.run(2.0)

    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.01)
    assert not controller.operating_state.holds
    assert controller.operating_state.cannot_move is None


def test_it_does_not_go_on_at_zero_percent(any_rig):
    rig, controller = any_rig, any_rig.controller
    rig.ready()
    accepted(controller.motion.send_joints(FAR))
    rig.run(0.6)
    controller.motion.set_speed_percent(0)
    rig.run(1.0)

    refusal = controller.planned_motion.command(TrajectoryCommand.CONTINUE)

    assert refusal.reason == SPEED_ZERO
    assert controller.operating_state.holds == {Hold.SPEED_ZERO}


@pytest.mark.each_value(full="each motion held back, in both generations")
def test_it_is_not_forgotten_while_the_arm_is_silent(held):
    rig, controller = held, held.controller
    rig.node.link.mute_on.update({0x2A1, 0x2A5, 0x2A6, 0x2A7})
    rig.run(1.0)
    rig.node.link.mute_on.clear()
    rig.run(0.5)

    assert controller.operating_state.holds
    assert isinstance(controller.motion.jog(6, 1.0), Refusal)


@pytest.mark.each_value(full="each motion held back, in both generations")
def test_it_is_not_forgotten_over_a_lost_cable(held):
    rig, controller = held, held.controller
    rig.node.link.off = True
    rig.run(2.0)
    rig.node.link.off = False
    rig.run(3.0)
    stood_deg = rig.firmware.mechanics.positions_deg
    controller.motion.set_speed_percent(60)
    rig.run(1.0)

    assert controller.operating_state.holds
    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.01)


@pytest.mark.each_value(full="all of it in both generations")
@pytest.mark.parametrize("percent", [80, 1])
@pytest.mark.parametrize("how", ["speed", "pause"])
def test_holding_back_a_single_motion_is_told_again_when_it_was_lost(any_rig, how, percent):
    """At 1 % a joint moves at 1.8 °/s: slower than what may be the trembling of one that holds."""
    rig, controller = any_rig, any_rig.controller
    rig.ready()
    controller.motion.set_speed_percent(percent)
    accepted(controller.motion.send_joints(FAR))
    rig.run(0.6)
    if how == "speed":
        rig.node.link.lose_to_arm(0x151)
        controller.motion.set_speed_percent(0)
    else:
        rig.node.link.lose_to_arm(0x150)
        accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.run(1.5)
    assert controller.operating_state.holds
    stood_deg = rig.firmware.mechanics.positions_deg
    rig.heard()
    rig.run(0.5)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.01)
    assert not {0x150, 0x151} & {frame.arbitration_id for frame in rig.heard()}


def test_a_pause_that_was_gone_on_with_or_dropped_is_not_told_again(any_rig):
    rig, controller = any_rig, any_rig.controller
    for after in (TrajectoryCommand.CONTINUE, TrajectoryCommand.ABORT):
        rig.ready()
        accepted(controller.motion.send_joints(FAR))
        rig.run(0.6)
        rig.heard()
        for command in (TrajectoryCommand.PAUSE, after):
            accepted(controller.planned_motion.command(command))
        rig.run(0.5)
        pauses = [one for one in rig.heard() if one.arbitration_id == 0x150 and one.data[1] == 1]
        assert len(pauses) <= 1  # an end drops what still waits
        rig.controller.planned_motion.command(TrajectoryCommand.ABORT)
        rig.run(1.0)


BEGIN = (30.0, 20.0, -20.0, 0.0, 0.0, 0.0)


@pytest.fixture(params=["zero percent", "pause", "lost word to go on", "before this program"])
def left_by_another(any_rig, request):
    """An arm that holds back a motion that is not this program's."""
    rig = any_rig
    other = OtherHost(rig)
    rig.ready()
    rig.run(0.5)
    if request.param == "lost word to go on":  # of our own motion: heard here, not by the arm
        accepted(rig.controller.motion.send_joints(FAR))
        rig.run(0.6)
        rig.controller.motion.set_speed_percent(0)
        rig.run(0.5)
        rig.node.link.lose_to_arm(0x150)
        other.resume()
    else:
        other.move_to(FAR, 30)
        rig.run(0.6)
        other.say("150#0001000000000000" if request.param == "pause" else mode(0))
    if request.param == "before this program":
        rig.controller.disconnect_device()
        rig.run(3.0)
        rig.connect()
    rig.run(3.0)
    if request.param == "lost word to go on":
        rig.controller.motion.set_speed_percent(50)
        rig.run(1.0)
    assert rig.controller.operating_state.cannot_move is None
    assert not rig.firmware.mechanics.moving
    assert rig.firmware.condition.motion_state is not MotionState.REACHED
    rig.heard()
    yield rig
    other.close()


@pytest.mark.each_value(full="each motion left by another, in both generations")
def test_what_another_host_left_held_back_is_cancelled_before_a_step(left_by_another):
    rig, controller = left_by_another, left_by_another.controller
    stood_deg = rig.firmware.mechanics.positions_deg
    accepted(controller.motion.jog(6, 1.0))
    gone_deg = 0.0
    for _ in range(50):
        rig.run(0.02)
        gone_deg = max(
            gone_deg, *(abs(now - stood) for now, stood in _five(rig.firmware, stood_deg))
        )

    sent = [(one.arbitration_id, one.data[1]) for one in rig.heard()]
    assert sent[0] == (0x150, 6)
    assert gone_deg < 0.02
    assert rig.firmware.mechanics.positions_deg[5] == pytest.approx(stood_deg[5] + 1.0, abs=0.02)


@pytest.mark.each_value(full="each motion left by another, in both generations")
def test_what_another_host_left_held_back_is_told_with_its_remedy(left_by_another):
    rig, controller = left_by_another, left_by_another.controller
    step = controller.recovery.step
    assert (step.kind, step.action) == (StepKind.LEFT_HELD_BACK, Action.GIVE_UP)
    stood_deg = rig.firmware.mechanics.positions_deg
    controller.recovery.act(step, Action.GIVE_UP, controller.mark)
    rig.run(1.0)
    assert (0x150, 6) in {(one.arbitration_id, one.data[1]) for one in rig.heard()}
    assert controller.recovery.step.kind is StepKind.READY
    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.02)


def test_an_arm_that_has_arrived_where_another_host_sent_it_is_ready(any_rig):
    rig, other = any_rig, OtherHost(any_rig)
    rig.ready()
    other.move_to(BEGIN, 100)
    rig.run(6.0)
    assert rig.controller.recovery.step.kind is StepKind.READY
    other.close()


def _five(firmware, stood_deg):
    return zip(firmware.mechanics.positions_deg[:5], stood_deg[:5], strict=True)


@pytest.mark.each_value(full="each motion left by another, in both generations")
def test_another_speed_does_not_set_going_what_another_host_left(left_by_another):
    rig, controller = left_by_another, left_by_another.controller
    stood_deg = rig.firmware.mechanics.positions_deg
    for percent in (0, 60):
        controller.motion.set_speed_percent(percent)
        rig.run(1.0)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.01)

    accepted(controller.motion.send_joints(BEGIN))
    rig.run(6.0)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(BEGIN, abs=0.02)
    assert rig.firmware.condition.speed_percent == 60


@pytest.mark.each_value(full="each motion left by another, in both generations")
def test_a_mounting_does_not_set_going_what_another_host_left(left_by_another):
    rig, controller = left_by_another, left_by_another.controller
    if rig.firmware.generation is Generation.ONE:
        assert isinstance(controller.mounting.tell(Mounting.ON_THE_LEFT_SIDE), Refusal)
        return
    stood_deg = rig.firmware.mechanics.positions_deg
    accepted(controller.mounting.tell(Mounting.ON_THE_LEFT_SIDE))
    rig.run(1.0)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(stood_deg, abs=0.02)


def test_an_arm_that_has_arrived_is_told_nothing_more_before_a_step(any_rig):
    rig = any_rig
    other = OtherHost(rig)
    rig.ready()
    other.move_to(BEGIN, 100)
    rig.run(6.0)
    rig.heard()
    accepted(rig.controller.motion.jog(6, 1.0))
    rig.run(0.1)
    assert 0x150 not in {one.arbitration_id for one in rig.heard()}
    other.close()
