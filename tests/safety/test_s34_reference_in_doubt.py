"""S34: a joint that leaves its place uncommanded while enabled has its reference in doubt."""

import json
from dataclasses import replace

import pytest

from armui.arm.reference_record import ReferenceRecord, read_record
from armui.control.link.link_state import LinkState
from armui.control.motion.jog_path import JointJog
from armui.control.run.progress import RunPhase
from armui.control.safety.interlocks import SPEED_ZERO
from armui.control.safety.recovery_steps import Action, StepKind
from armui.control.safety.reference_control import BROUGHT_BY_HAND, JOINTS_UNANSWERED, LOOK_FIRST
from armui.control.safety.reference_status import REFERENCE_CHECK_OPEN, REFERENCE_IN_DOUBT
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import TeachingState, TrajectoryCommand
from armui.settings import SettingsStore
from armui.sim.faults.schedule import fault
from armui.sim.mechanics.unpowered_joints import UnpoweredJoints
from tests.accepted import accepted
from tests.control.test_recovery import check_reference
from tests.control.under_way import OUT, run_of, to
from tests.moments import now
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
        rig.controller.motion.jog(1, 1.0)  # refused while a joint is told to be beyond its limits
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


def test_another_arm_in_its_place_is_no_excursion(ready):
    """The cable goes to another arm, which stands elsewhere, after a silence."""
    rig = ready
    rig.powered = False
    rig.run(0.7)
    rig.powered = True
    rig.firmware.mechanics.count_anew((-50.0, 30.0, -30.0, 40.0, -40.0, 90.0))
    rig.run(4.0)
    assert doubtful(rig) == ()


def test_a_stop_right_behind_it_excepts_nothing_that_was_confirmed(ready):
    rig = ready
    lose(rig)
    rig.run(0.4)
    rig.controller.emergency_stop()
    rig.run(2.0)
    assert doubtful(rig) == (5,)


def test_a_stop_in_the_same_moment_excepts_it(ready):
    rig = ready
    lose(rig)
    rig.run(0.1)
    rig.controller.emergency_stop()
    rig.run(4.0)
    assert doubtful(rig) == ()


def test_a_driver_that_then_says_disabled_excepts_it(ready):
    """Its motor is off before its report says so: the joint falls, and is not lost."""
    rig = ready
    rig.firmware.mechanics.power_off([4], UnpoweredJoints.FREE)
    rig.run(2.0)
    assert doubtful(rig) == ()


# What follows from it -----------------------------------------------------------------------------


@pytest.fixture
def lost(ready):
    lose(ready)
    ready.run(3.0)
    assert doubtful(ready) == (5,)
    return ready


def test_runs_and_fast_motions_want_a_press_and_slow_ones_none(lost):
    controller = lost.controller
    lost.heard()
    for begin in (
        lambda: controller.player.start(run_of(to(OUT))),
        lambda: controller.motion.send_joints(FAR_DEG),
        lambda: controller.motion.jog(1, 1.0),
        controller.motion.go_home,
        lambda: controller.jogging.start(JointJog(1, 1)),
        lambda: controller.cartesian.step(2, 5.0, JogFrame.BASE),
    ):
        refusal = begin()
        assert refusal.reason == REFERENCE_IN_DOUBT
        assert refusal.params == {"joints": "5", "maximum": 10}
    assert lost.heard() == []
    accepted(controller.motion.set_speed_percent(10))
    accepted(controller.motion.jog(1, 1.0))
    lost.run(1.0)
    assert controller.player.start(run_of(to(OUT))).reason == REFERENCE_IN_DOUBT


def test_a_slow_motion_is_not_made_fast_under_way(lost):
    controller = lost.controller
    accepted(controller.motion.set_speed_percent(10))
    accepted(controller.motion.send_joints(FAR_DEG))
    lost.run(0.3)
    assert controller.motion.set_speed_percent(60).reason == REFERENCE_IN_DOUBT
    assert lost.firmware.condition.speed_percent == 10


def test_a_fast_motion_under_way_may_be_made_slower(ready):
    controller = ready.controller
    accepted(controller.motion.set_speed_percent(40))
    accepted(controller.motion.send_joints((-FAR_DEG[0], *FAR_DEG[1:])))
    ready.run(0.3)
    lose(ready)
    ready.run_until(lambda: doubtful(ready) == (5,))
    assert controller.operating_state.moving
    accepted(controller.motion.set_speed_percent(20))
    ready.run(0.1)
    assert ready.firmware.condition.speed_percent == 20
    assert controller.motion.set_speed_percent(30).reason == REFERENCE_IN_DOUBT
    assert ready.firmware.condition.speed_percent == 20


def test_the_press_holds_for_a_minute_and_for_what_began_in_it(lost):
    controller = lost.controller
    step = controller.recovery.step
    assert controller.recovery.act(step, Action.ALLOW) is None
    assert now(controller.recovery.step.kind) is StepKind.REFERENCE_AGREED
    lost.run(58.0)
    accepted(controller.motion.set_speed_percent(1))
    accepted(controller.motion.send_joints((40.0, *BENT_DEG[1:])))
    lost.run(5.0)
    assert controller.operating_state.reference.allowed
    controller.halt_and_hold()
    lost.run(3.0)
    assert not controller.operating_state.reference.allowed
    assert now(controller.recovery.step.kind) is StepKind.REFERENCE_IN_DOUBT


def test_a_stop_and_another_excursion_take_the_agreement_back(lost):
    controller = lost.controller
    accepted(controller.reference.allow())
    lose(lost, 4)
    lost.run(1.0)
    assert doubtful(lost) == (4, 5)
    assert not controller.operating_state.reference.allowed
    accepted(controller.reference.allow())
    controller.emergency_stop()
    assert not controller.operating_state.reference.allowed


def test_an_excursion_ends_the_run(ready):
    controller = ready.controller
    accepted(controller.player.start(run_of(to(FAR_DEG), to(BENT_DEG))))
    ready.run(0.4)
    lose(ready)
    ready.run_until(lambda: not controller.operating_state.running)
    assert controller.player.phase is RunPhase.FAILED
    assert doubtful(ready) == (5,)


def test_only_the_check_clears_it(lost):
    controller = lost.controller
    accepted(controller.zeroing.set_zero(5))
    lost.run(3.0)
    controller.emergency_stop()
    lost.run(1.0)
    accepted(controller.motors.resume())
    lost.run(2.0)
    accepted(controller.motors.enable())
    lost.run(2.0)
    assert doubtful(lost) == (5,)


def test_the_joint_in_doubt_is_driven_by_nothing_during_the_check(lost):
    controller, reference = lost.controller, lost.controller.reference
    accepted(reference.begin())
    lost.heard()
    assert reference.drive(6).reason == LOOK_FIRST
    reference.note_elsewhere((2,))
    for joint in (2, 5):
        refusal = reference.drive(joint)
        assert (refusal.reason, refusal.params) == (BROUGHT_BY_HAND, {"joint": joint})
    controller.motion.set_speed_percent(1)
    for begin in (
        lambda: controller.motion.jog(1, 1.0),
        lambda: controller.motion.send_joints(FAR_DEG),
        lambda: controller.jogging.start(JointJog(1, 1)),
        lambda: controller.player.start(run_of(to(OUT))),
        lambda: controller.teaching.command(TeachingState.START_RECORDING),
    ):
        assert begin().reason == REFERENCE_CHECK_OPEN
    assert [each for each in lost.heard() if each.arbitration_id in (0x155, 0x156, 0x157)] == []
    controller.motion.set_speed_percent(0)
    assert reference.drive(1).reason == SPEED_ZERO
    controller.motion.set_speed_percent(4)
    lost.run(0.1)
    lost.heard()  # the speeds, which a busy computer sends late
    accepted(reference.drive(1))
    lost.run(0.1)
    heard = lost.heard()
    assert {each.data[2] for each in heard if each.arbitration_id == 0x151} == {4}  # not 5 %
    (sent,) = [each.data for each in heard if each.arbitration_id == 0x157]
    # J5 stays where it is measured: 20.000° = 20,000 = 0x00004E20; J6 at 0
    assert sent.hex() == "00004e2000000000"
    lost.run(8.0)
    assert lost.firmware.joints_deg[0] == pytest.approx(0.0)


def test_the_check_drives_slowly_after_a_pause_too(lost):
    controller, reference = lost.controller, lost.controller.reference
    controller.motion.set_speed_percent(60)
    accepted(reference.begin())
    reference.note_elsewhere(())
    lost.run(0.1)
    accepted(reference.drive(1))
    lost.run(0.2)
    accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    lost.run(0.3)
    lost.heard()
    accepted(controller.planned_motion.command(TrajectoryCommand.CONTINUE))
    lost.run(0.3)
    assert {each.data[2] for each in lost.heard() if each.arbitration_id == 0x151} <= {5}
    assert lost.firmware.condition.speed_percent == 5


def test_a_check_that_finds_it_off_keeps_the_doubt_and_one_after_the_reset_ends_it(lost):
    controller, reference = lost.controller, lost.controller.reference
    accepted(reference.begin())
    reference.note_elsewhere(())
    assert controller.begin("reference.finish").reason == JOINTS_UNANSWERED
    for joint in (1, 2, 3, 4, 6):
        reference.answer(joint, 0.0)
    reference.answer(5, 60.0)
    accepted(reference.finish())
    assert doubtful(lost) == (5,)
    assert reference.record.off_deg == {5: 60.0}
    check_reference(lost)
    assert doubtful(lost) == ()
    assert reference.record.off_deg == {}
    assert reference.record.checked_at
    assert lost.codes()[-1] == "reference_fits"


def test_the_hand_brings_it_to_its_mark_and_the_report_tells_the_error(lost):
    """Its motor is off; turned by 40° to its mark it reports 60°."""
    controller, reference, firmware = lost.controller, lost.controller.reference, lost.firmware
    accepted(reference.begin())
    reference.note_elsewhere(())
    accepted(controller.motors.disable(5))
    lost.run(1.0)
    here = firmware.mechanics.positions_deg
    turn_deg = -firmware.true_joints_deg[4]
    firmware.mechanics.count_anew((*here[:4], here[4] + turn_deg, here[5]))
    lost.run(0.5)
    assert firmware.true_joints_deg[4] == pytest.approx(0.0, abs=0.5)
    assert reference.at_mark(5) == pytest.approx(60.0, abs=0.6)


def test_the_check_ends_with_its_arm(lost):
    accepted(lost.controller.reference.begin())
    lost.firmware.feedback_stopped = True
    lost.run(2.0)
    assert not lost.controller.operating_state.reference.checking


def test_it_is_remembered_through_a_power_cycle(lost, memory):
    lost.firmware.switch_off()
    lost.run(2.0)
    lost.firmware.switch_on()
    lost.run(3.0)
    assert doubtful(lost) == (5,)
    assert "reference_still_in_doubt" in lost.codes()
    assert lost.controller.recovery.step.kind is StepKind.REFERENCE_IN_DOUBT


@pytest.fixture(autouse=True)
def memory(rig):
    memory = rig.controller.reference_memory = Memory()
    return memory


class Memory(dict[str, ReferenceRecord]):
    """What the settings keep."""

    def keep(self, arm, record):
        self[arm] = record


@pytest.mark.parametrize("how", ["again", "another program", "another arm"])
def test_it_is_kept_for_the_arm(app_driver, how):
    app_driver.device = replace(app_driver.device, simulated=False)
    app_driver.ready()
    app_driver.run(1.5)
    lose(app_driver)
    app_driver.run(2.0)
    assert doubtful(app_driver) == (5,)
    ((key, entry),) = app_driver.store.settings.references.items()
    assert entry["doubtful"] == (5,)
    app_driver.controller.disconnect_device()
    if how == "another arm":
        app_driver.store.change(references={"else": entry})
    if how == "another program":
        text = app_driver.store.path.read_text()
        assert SettingsStore(app_driver.store.path).settings.references == {
            key: json.loads(text)["references"][key]
        }
    app_driver.connect()
    app_driver.run(0.5)
    assert doubtful(app_driver) == (() if how == "another arm" else (5,))


def test_that_of_a_simulated_arm_ends_with_it(app_driver):
    """Each connection begins with a new one; what the operator has taught is kept."""
    app_driver.ready()
    app_driver.run(1.5)
    accepted(app_driver.controller.reference.teach())
    lose(app_driver)
    app_driver.run(2.0)
    assert doubtful(app_driver) == (5,)
    ((key, entry),) = app_driver.store.settings.references.items()
    assert (tuple(entry["doubtful"]), tuple(entry["pose_deg"])) == ((), (0.0,) * 6)
    app_driver.controller.disconnect_device()
    app_driver.connect()
    app_driver.run(0.5)
    assert doubtful(app_driver) == ()
    assert app_driver.controller.reference.record.pose_deg == (0.0,) * 6
    before = ReferenceRecord((3,), pose_deg=(1.0,) * 6)
    app_driver.controller.disconnect_device()
    app_driver.store.change(references={key: before.as_entry()})
    app_driver.connect()
    app_driver.run(0.5)
    assert doubtful(app_driver) == (), "kept by an earlier version"
    assert app_driver.controller.reference.record.pose_deg == (1.0,) * 6


def test_a_silence_of_the_same_simulated_arm_ends_no_doubt(lost):
    lost.firmware.feedback_stopped = True
    lost.run(1.0)
    lost.firmware.feedback_stopped = False
    lost.run(3.0)
    assert doubtful(lost) == (5,)


def test_a_simulated_arm_whose_device_was_lost_is_another_one(lost, qtbot):
    lost.unplug(OSError(19, "No such device"))
    lost.run_until(lambda: lost.controller.operating_state.link is LinkState.LOST)
    lost.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in lost.codes())
    lost.run(3.0)
    assert now(lost.controller.operating_state.link) is LinkState.ONLINE
    assert doubtful(lost) == ()


@pytest.mark.parametrize(
    "entry",
    [
        *(7, {"doubtful": [7]}, {"doubtful": [True]}, {"pose_deg": [1.0]}, {"off_deg": {"x": 1}}),
        *({"pose_deg": [0, 0, 0, 0, 0, 1e9]}, {"checked_at": 3}, {"off_deg": {"5": "a"}}),
    ],
)
def test_what_is_no_record_is_left_out(entry):
    assert read_record(entry) is None


def test_a_record_is_the_same_again():
    record = ReferenceRecord((2, 5), "2026-01-01", "2026-01-02", {5: 61.5}, (1.0,) * 6, "a.jpg")
    assert read_record(json.loads(json.dumps(record.as_entry()))) == record
