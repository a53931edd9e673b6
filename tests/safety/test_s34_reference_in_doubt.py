"""S34: a joint that leaves its place uncommanded while enabled has its reference in doubt."""

import pytest

from armui.control.safety.recovery_steps import Action, StepKind
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import TeachingState, TrajectoryCommand
from armui.sim.faults.schedule import fault
from tests.accepted import accepted
from tests.sim.talk import mode, target

BENT_DEG = (10.0, 60.0, -60.0, 0.0, 20.0, 0.0)
FAR_DEG = (100.0, 60.0, -60.0, 0.0, 20.0, 0.0)


@pytest.fixture
def ready(rig):
    rig.ready()
    accepted(rig.controller.motion.send_joints(BENT_DEG))
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(BENT_DEG))
    rig.run(1.5)
    assert doubtful(rig) == ()
    return rig


def doubtful(rig):
    return rig.controller.operating_state.reference.doubtful


def lose(rig, joint=5, **how):
    rig.firmware.lost_reference.begin(joint - 1, **how)


def test_the_excursion_is_noticed_and_said(ready):
    rig = ready
    lose(rig)
    rig.run(0.5)
    assert doubtful(rig) == (5,)
    rig.run(1.0)
    (left,) = [each for each in rig.events if each.code == "reference_left"]
    assert left.params["joint"] == 5
    assert left.params["place"] == 20.0
    assert rig.firmware.reported_deg == pytest.approx(BENT_DEG)
    assert rig.firmware.true_joints_deg[4] == pytest.approx(-40.0)
    step = rig.controller.recovery.step
    assert (step.kind, step.action, step.alternative) == (
        StepKind.REFERENCE_IN_DOUBT,
        Action.CHECK_REFERENCE,
        Action.ALLOW,
    )


def said(rig):
    return [each for each in rig.codes() if each == "reference_left"]


# What must be noticed ---------------------------------------------------------------------------


def slowly(rig):
    """Half a degree a second, for twenty seconds."""
    lost = rig.firmware.lost_reference
    lost.reported_deg = lambda angles: (*angles[:4], angles[4] + min(10.0, creep()), angles[5])
    since_s = rig.time_s

    def creep():
        return 0.5 * (rig.time_s - since_s)

    rig.run(25.0)


def in_one_report(rig):
    """The angle is another one from one report to the next, and stays so."""
    lost = rig.firmware.lost_reference
    lost.reported_deg = lambda angles: (*angles[:4], angles[4] + 40.0, angles[5])
    rig.run(1.0)


def for_one_report(rig):
    """A single report tells another angle; the next one tells the old one."""
    lost = rig.firmware.lost_reference
    lost.reported_deg = lambda angles: (*angles[:4], angles[4] + 40.0, angles[5])
    rig.step(0.005)
    del lost.reported_deg
    rig.run(1.0)


def while_another_is_jogged(rig):
    rig.controller.motion.set_speed_percent(10)
    for _ in range(10):
        accepted(rig.controller.motion.jog(1, 1.0))
        rig.step()
    lose(rig)
    for _ in range(20):
        accepted(rig.controller.motion.jog(1, 1.0))
        rig.run(0.1)


def during_a_motion_of_others(rig):
    accepted(rig.controller.motion.send_joints(FAR_DEG))
    rig.run(0.4)
    lose(rig)
    rig.run(2.0)


def while_paused(rig):
    accepted(rig.controller.motion.send_joints((*BENT_DEG[:4], -60.0, 0.0)))
    rig.run(0.3)
    accepted(rig.controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.run(1.5)
    assert rig.controller.operating_state.holds
    lose(rig, excursion_deg=-40.0)
    rig.run(1.5)


def in_standby_after_a_motion_that_was_ended(rig):
    accepted(rig.controller.motion.send_joints(FAR_DEG))
    rig.run(0.5)
    rig.controller.halt_and_hold()
    rig.run(2.0)
    lose(rig)
    rig.run(1.5)


def while_the_window_draws_for_long(rig):
    """The program looks at the arm five times a second only."""
    controller = rig.controller
    tick = controller.tick
    lose(rig)
    controller.tick = lambda: None
    for count in range(70):
        rig._pass(0.02)
        if count % 10 == 0:
            tick()
    del controller.tick
    rig.run(0.5)


MISSES = (
    *(slowly, in_one_report, for_one_report, while_another_is_jogged),
    *(during_a_motion_of_others, while_paused),
    *(in_standby_after_a_motion_that_was_ended, while_the_window_draws_for_long),
)


@pytest.mark.parametrize("happens", MISSES, ids=lambda each: each.__name__)
def test_no_excursion_is_missed(ready, happens):
    happens(ready)
    assert doubtful(ready) == (5,)
    assert said(ready) == ["reference_left"]


# What is none -----------------------------------------------------------------------------------


def jogging(rig):
    controller = rig.controller
    controller.motion.set_speed_percent(100)
    for joint, step in ((1, 10.0), (5, -10.0), (2, 5.0), (5, 15.0), (6, 30.0)):
        for _ in range(4):
            accepted(controller.motion.jog(joint, step))
            rig.run(0.1)
    rig.run(3.0)


def tool_motions(rig):
    rig.controller.motion.set_speed_percent(100)
    for axis, step in ((0, 60.0), (2, 60.0), (5, 20.0), (2, -60.0)):
        accepted(rig.controller.cartesian.step(axis, step, JogFrame.BASE))
        rig.run(2.0)


def a_pause_and_going_on(rig):
    controller = rig.controller
    controller.motion.set_speed_percent(100)
    accepted(controller.motion.send_joints(FAR_DEG))
    rig.run(0.3)
    accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.run(3.0)
    accepted(controller.planned_motion.command(TrajectoryCommand.CONTINUE))
    rig.run(4.0)
    assert rig.firmware.joints_deg[0] == pytest.approx(100.0)


def led_by_hand(rig):
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    rig.firmware.hand_guiding.lead_to((40.0, 90.0, -90.0, 20.0, -30.0, 50.0))
    rig.run(3.0)
    rig.firmware.hand_guiding.lead_to((0.0,) * 6)
    rig.run(4.0)
    rig.controller.teaching.command(TeachingState.STOP_RECORDING)
    rig.run(3.0)


def another_host(rig, host):
    host.move_to(FAR_DEG)
    rig.run(4.0)
    host.move_to((*FAR_DEG[:4], -50.0, 40.0))
    rig.run(5.0)
    assert rig.firmware.joints_deg[4] == pytest.approx(-50.0)


def taking_over_in_mid_motion(rig, host):
    host.say(mode(10), *target(*FAR_DEG))
    rig.run(0.8)
    assert rig.controller.take_over() is None
    rig.run(8.0)
    assert rig.firmware.joints_deg[0] > 20.0


def a_stop_and_sinking(rig):
    rig.controller.emergency_stop()
    rig.run(6.0)
    accepted(rig.controller.motors.resume())
    rig.run(3.0)
    accepted(rig.controller.motors.enable())
    rig.run(4.0)


def disabling_and_enabling(rig):
    accepted(rig.controller.motors.disable())
    rig.run(3.0)
    accepted(rig.controller.motors.enable())
    rig.run(3.0)


def one_motor_off(rig):
    accepted(rig.controller.motors.disable(2))
    rig.run(3.0)
    accepted(rig.controller.motors.enable(2))
    rig.run(3.0)


def zeros(rig):
    accepted(rig.controller.zeroing.set_zero(2))
    rig.run(4.0)
    assert "zero_set_joint" in rig.codes()


def a_silence(rig):
    """The cable is out for two seconds, and somebody has turned the arm meanwhile."""
    rig.firmware.feedback_stopped = True
    rig.run(1.0)
    rig.firmware.mechanics.count_anew((*BENT_DEG[:4], -30.0, 0.0))
    rig.firmware.feedback_stopped = False
    rig.run(4.0)


def a_power_cycle(rig):
    rig.firmware.switch_off()
    rig.run(3.0)
    rig.firmware.switch_on()
    rig.run(3.0)
    accepted(rig.controller.motors.enable())
    rig.run(3.0)


def sag(rig):
    rig.firmware.mechanics.sag_deg = (0.0, 1.5, -2.0, 0.0, 3.0, 0.0)
    rig.run(2.0)
    accepted(rig.controller.motion.send_joints(FAR_DEG))
    rig.run(5.0)


def pushed_a_little(rig):
    for push_deg in (4.5, -4.5, 4.0):
        lost = rig.firmware.lost_reference
        lost.begin(4, excursion_deg=push_deg, shift_deg=0.0)
        rig.run(2.0)


def frames_that_come_late(rig):
    """The driver holds everything for 0.4 s, then hands it over at once, while joints turn."""
    controller = rig.controller
    controller.motion.set_speed_percent(100)
    accepted(controller.motion.send_joints((-100.0, *BENT_DEG[1:4], -60.0, 90.0)))
    for _ in range(10):
        rig.step(0.4)
    rig.run(2.0)
    assert rig.firmware.joints_deg[4] == pytest.approx(-60.0)


def a_pair_that_is_silent_for_a_moment(rig):
    """0x2A7 is not heard for 0.4 s while its joints turn at their top speed."""
    controller, firmware = rig.controller, rig.firmware
    controller.motion.set_speed_percent(100)
    accepted(controller.motion.send_joints((*BENT_DEG[:4], -60.0, 100.0)))
    rig.run(0.2)
    periodic = firmware._periodic
    firmware._periodic = lambda names: periodic([n for n in names if n != "JointFeedback56"])
    rig.run(0.4)
    firmware._periodic = periodic
    rig.run(3.0)
    assert firmware.joints_deg[4] == pytest.approx(-60.0)


def a_motion_that_was_blocked(rig):
    controller = rig.controller
    block = fault("stall", 5)
    rig.node.faults.start(block)
    accepted(controller.motion.send_joints((*BENT_DEG[:4], -60.0, 0.0)))
    rig.run(2.0)
    rig.node.faults.end(block)
    controller.joint_errors.clear(5)
    rig.run(1.0)
    accepted(controller.motion.send_joints((*BENT_DEG[:4], -60.0, 0.0)))
    rig.run(3.0)


ALONE = (
    *(jogging, tool_motions, a_pause_and_going_on, led_by_hand, a_stop_and_sinking),
    *(disabling_and_enabling, one_motor_off, zeros, a_silence, a_power_cycle, sag),
    *(pushed_a_little, frames_that_come_late, a_pair_that_is_silent_for_a_moment),
    a_motion_that_was_blocked,
)


@pytest.mark.parametrize("happens", ALONE, ids=lambda each: each.__name__)
def test_no_false_alarm(ready, happens):
    happens(ready)
    assert doubtful(ready) == ()
    assert said(ready) == []


@pytest.mark.parametrize(
    "happens", [another_host, taking_over_in_mid_motion], ids=lambda each: each.__name__
)
def test_no_false_alarm_with_another_host(ready, other_host, happens):
    happens(ready, other_host)
    assert doubtful(ready) == ()
