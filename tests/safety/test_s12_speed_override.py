"""S12, S11: the speed in a run lowers at once, raises in order, and holds back at 0 %."""

import math
from itertools import pairwise

import numpy as np
import pytest

from armui.arm.figures import FIGURE_NOT_WHOLE, WHOLE_OUT_OF_RANGE
from armui.control.motion.jog_path import JointJog
from armui.control.motion.motion_command import Hold
from armui.control.run.player import RUN_SPEED_ZERO
from armui.control.run.progress import Run, RunPhase
from armui.control.run.replay import Replay
from armui.control.safety.interlocks import SPEED_ZERO
from armui.protocol.codes import MoveMode
from armui.protocol.frame import Frame
from armui.trajectory.points.program import Waypoint
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted
from tests.arm_rig import STEP_S

HERE = (0.0, 30.0, -30.0, 0.0, 0.0, 0.0)
FAR = (140.0, 30.0, -30.0, 0.0, 0.0, 0.0)
HIGHEST_DEG_S = 180.0
"""No joint is faster at 100 %."""


def made_ready(rig):
    rig.ready()
    rig.controller.motion.set_speed_percent(40)
    accepted(rig.controller.motion.send_joints(HERE))
    rig.run(3.0)
    rig.heard()
    return rig


@pytest.fixture
def ready(any_rig):
    return made_ready(any_rig)


def started(rig, *places, percent=80, dwell_s=0.0, **more):
    points = [
        Waypoint(MoveMode.MOVE_J, each, speed_percent=percent, dwell_s=dwell_s) for each in places
    ]
    run = Run("run", points, [2.0] * len(points), **more)
    accepted(rig.controller.player.start(run))
    return rig.controller.player


def even_turn(seconds=20.0, speed_deg_s=12.0):
    times = np.arange(0.0, seconds, 0.01)
    samples = np.zeros((len(times), 8))
    samples[:, 0] = times
    samples[:, 1:7] = HERE
    samples[:, 1] = speed_deg_s * (times - seconds / 2)
    samples[:, 7] = np.nan
    return Recording("turn", samples=samples)


def replaying(rig):
    replayer = rig.controller.replayer
    accepted(replayer.start(Replay(even_turn())))
    rig.run_until(lambda: replayer.progress.done > 0.05, seconds=60.0)
    rig.heard()
    return replayer


def speeds_deg_s(rig, seconds):
    """How fast joint 1 was at each step, measured at the arm."""
    speeds = []
    for _ in range(round(seconds / STEP_S)):
        before = rig.firmware.joints_deg[0]
        rig.step()
        speeds.append(abs(rig.firmware.joints_deg[0] - before) / STEP_S)
    return speeds


def mode_words(rig):
    return [frame.data[2] for frame in rig.heard() if frame.arbitration_id == 0x151]


def override(rig, percent):
    return rig.controller.motion.set_speed_percent(percent)


# Lowered at once --------------------------------------------------------------------------------


def test_in_a_run_it_is_on_the_bus_with_the_press(ready):
    player = started(ready, FAR)
    ready.run(0.6)
    ready.heard()
    accepted(override(ready, 25))
    ready.step()

    assert ready.heard() == [Frame(0x151, bytes.fromhex("01 01 14 00 00 00 00 00"))]  # 25 % of 80
    assert max(speeds_deg_s(ready, 2.0)[40:]) < 1.02 * 0.20 * HIGHEST_DEG_S
    assert player.phase is RunPhase.MOVING
    assert "motion_too_fast" not in ready.codes()


def test_the_next_points_are_sent_with_it(ready):
    started(ready, (20.0, *HERE[1:]), HERE, (20.0, *HERE[1:]), percent=50)
    override(ready, 20)
    ready.run_until(lambda: not ready.controller.player.running)

    assert set(mode_words(ready)[1:]) == {10}


def test_a_higher_one_goes_out_after_the_targets_a_lower_one_before(ready):
    player = started(ready, (10.0, *HERE[1:]), HERE, (10.0, *HERE[1:]), dwell_s=0.3)
    ready.run_until(lambda: player.phase is RunPhase.DWELLING)
    override(ready, 10)
    ready.heard()
    ready.run_until(lambda: player.phase is RunPhase.MOVING)
    lower = [frame.arbitration_id for frame in ready.heard()]
    ready.run_until(lambda: player.phase is RunPhase.DWELLING, seconds=60.0)
    override(ready, 100)
    ready.heard()
    ready.run_until(lambda: player.phase is RunPhase.MOVING)
    higher = [frame.arbitration_id for frame in ready.heard()]

    assert lower == [0x151, 0x155, 0x156, 0x157, 0x151]
    assert higher == [0x155, 0x156, 0x157, 0x151]


def test_in_a_replay_the_recorded_time_slows_down_and_the_way_stays(ready):
    replayer = replaying(ready)
    override(ready, 25)
    slowed = speeds_deg_s(ready, 3.0)
    assert slowed[-20:] == pytest.approx([3.0] * 20, abs=0.6)
    assert max(abs(b - a) for a, b in pairwise(slowed)) < 300 * STEP_S  # no jerk: 286 °/s²
    assert not mode_words(ready)

    override(ready, 100)
    assert speeds_deg_s(ready, 3.0)[-20:] == pytest.approx([12.0] * 20, abs=0.6)
    assert replayer.phase is RunPhase.MOVING
    assert ready.firmware.joints_deg[1:] == pytest.approx(HERE[1:], abs=0.01)


def test_on_the_way_to_the_first_sample_it_slows_down_too(ready):
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(even_turn())))
    ready.run(1.5)
    ready.heard()
    override(ready, 20)
    ready.step()
    assert mode_words(ready) == [15], "its own cap is the lesser one"
    override(ready, 3)
    ready.step()
    assert mode_words(ready) == [3]
    assert max(speeds_deg_s(ready, 1.0)[20:]) < 1.02 * 0.03 * HIGHEST_DEG_S
    override(ready, 0)
    ready.run(0.5)
    assert replayer.phase is RunPhase.PAUSED
    assert ready.controller.operating_state.holds == {Hold.PAUSE}
    assert max(speeds_deg_s(ready, 0.5)) < 0.01
    override(ready, 100)
    ready.run(0.5)
    assert max(speeds_deg_s(ready, 0.5)) < 0.01
    accepted(replayer.go_on())
    ready.run_until(lambda: replayer.progress.done > 0.05, seconds=60.0)
    assert "motion_too_fast" not in ready.codes()


def test_in_a_jog_the_operators_speed_counts_at_once(ready):
    ready.controller.motion.set_speed_percent(100)
    accepted(ready.controller.jogging.start(JointJog(6, 1)))
    ready.run(0.5)

    def turned_deg(seconds):
        before = ready.firmware.joints_deg[5]
        ready.run(seconds)
        return ready.firmware.joints_deg[5] - before

    fast = turned_deg(0.5)
    ready.controller.speed_override.step(-80)
    ready.run(0.1)
    assert turned_deg(0.5) == pytest.approx(0.2 * fast, rel=0.1)
    ready.controller.speed_override.step(-100)
    ready.run(0.3)
    assert turned_deg(0.5) == pytest.approx(0.0, abs=0.01)
    assert not ready.controller.operating_state.jogging


def test_in_a_single_motion_the_operators_speed_counts_at_once(ready):
    ready.controller.motion.set_speed_percent(100)
    accepted(ready.controller.motion.send_joints(FAR))
    ready.run(0.4)
    ready.controller.speed_override.step(-95)
    assert max(speeds_deg_s(ready, 1.5)[40:]) < 1.02 * 0.05 * HIGHEST_DEG_S
    assert ready.controller.speed_override.percent == 5
    assert "motion_too_fast" not in ready.codes()


def test_a_single_motion_that_was_not_heard_is_slowed_as_soon_as_it_is(ready):
    ready.controller.motion.set_speed_percent(60)
    accepted(ready.controller.motion.send_joints(FAR))
    ready.run(0.4)
    ready.node.link.mute_on.update({0x2A1, 0x2A5, 0x2A6, 0x2A7})
    ready.run(0.6)
    ready.controller.motion.set_speed_percent(5)  # cannot be told now
    ready.step()
    assert ready.firmware.condition.speed_percent == 60
    ready.node.link.mute_on.clear()
    ready.run(0.2)

    assert ready.firmware.mechanics.moving
    assert ready.firmware.condition.speed_percent == 5


# 0 % is a pause ----------------------------------------------------------------------------------


@pytest.mark.each_value(full="each motion in both generations")
@pytest.mark.parametrize("what", ["run", "replay"])
def test_0_percent_holds_back_and_only_continue_goes_on(ready, what):
    if what == "run":
        part = started(ready, FAR)
        ready.run(0.6)
    else:
        part = replaying(ready)
    accepted(override(ready, 0))
    assert part.progress.phase is RunPhase.PAUSED
    assert ready.controller.operating_state.running
    ready.run(1.5)
    stood_deg = ready.firmware.joints_deg
    assert part.go_on().reason == RUN_SPEED_ZERO
    override(ready, 60)
    ready.run(1.0)
    ready.controller.motion.jog(6, 1.0)
    ready.controller.motion.send_joints(FAR)
    ready.controller.motion.set_speed_percent(90)
    ready.run(1.0)
    assert ready.firmware.joints_deg == pytest.approx(stood_deg, abs=0.01)
    assert part.progress.phase is RunPhase.PAUSED

    accepted(part.go_on())
    ready.run_until(lambda: not part.running, seconds=60.0)
    assert part.phase is RunPhase.DONE
    assert "motion_too_fast" not in ready.codes()


@pytest.mark.each_value(full="each length of the pause in both generations")
@pytest.mark.parametrize("meanwhile_s", [0.0, 0.06, 0.16])
def test_0_percent_stays_a_pause_when_it_is_raised_before_the_arm_stands(ready, meanwhile_s):
    """Down to 0 % and up again with one drag of the slider: the replay is still slowing down."""
    replayer = replaying(ready)
    override(ready, 0)
    ready.run(meanwhile_s)
    override(ready, 60)
    ready.run(1.0)
    assert replayer.phase is RunPhase.PAUSED
    assert max(speeds_deg_s(ready, 0.5)) < 0.01
    accepted(replayer.go_on())
    assert speeds_deg_s(ready, 1.5)[-20:] == pytest.approx([7.2] * 20, abs=0.6)


def test_what_goes_on_is_told_a_lower_speed_before(ready):
    player = started(ready, FAR)
    ready.run(0.6)
    override(ready, 0)
    ready.run(1.0)
    override(ready, 10)
    ready.heard()
    accepted(player.go_on())
    ready.step()
    sent = [(frame.arbitration_id, frame.data[1:3].hex()) for frame in ready.heard()]
    assert sent == [(0x151, "0108"), (0x150, "0200")]


def test_while_it_dwells_nothing_is_sent_and_nothing_goes_on(ready):
    player = started(ready, (5.0, *HERE[1:]), HERE, dwell_s=0.5)
    ready.run_until(lambda: player.phase is RunPhase.DWELLING)
    ready.heard()
    override(ready, 0)
    ready.run(2.0)
    assert ready.heard() == []
    assert player.phase is RunPhase.PAUSED


def test_step_by_step_does_not_go_on_at_0_percent(ready):
    player = started(ready, (5.0, *HERE[1:]), HERE, step_by_step=True)
    ready.run_until(lambda: player.phase is RunPhase.WAITING)
    override(ready, 0)
    ready.heard()
    assert player.go_on().reason == RUN_SPEED_ZERO
    ready.step()
    assert ready.heard() == []
    override(ready, 50)
    assert player.go_on() is None  # a step is no command of its own


def test_0_percent_stays_after_the_run_and_nothing_begins_at_it(ready):
    player = started(ready, FAR)
    override(ready, 30)
    override(ready, 0)
    player.stop()
    ready.run_until(lambda: not player.running)
    ready.run(0.1)
    assert ready.controller.operating_state.speed_percent == 0
    assert player.start(Run("run", [Waypoint(MoveMode.MOVE_J, HERE)], [2.0])).reason == SPEED_ZERO
    assert ready.controller.replayer.start(Replay(even_turn())).reason == SPEED_ZERO


def test_a_figure_that_is_no_percentage_is_refused(ready):
    for value in (-1, 101):
        assert override(ready, value).reason == WHOLE_OUT_OF_RANGE
    assert override(ready, math.nan).reason == FIGURE_NOT_WHOLE
    assert ready.controller.speed_override.percent == 40


# Afterwards, others, losses ----------------------------------------------------------------------


@pytest.mark.each_value(full="each motion in both generations")
@pytest.mark.parametrize("what", ["run", "replay"])
def test_afterwards_the_operators_percentage_is_back_in_the_arm(ready, what):
    if what == "run":
        started(ready, (20.0, *HERE[1:]))
    else:
        replaying(ready)
    override(ready, 20)
    part = ready.controller.player if what == "run" else ready.controller.replayer
    ready.run(0.5)
    part.stop()
    ready.run_until(lambda: not part.running, seconds=60.0)
    ready.run(1.5)
    assert ready.firmware.condition.speed_percent == 20, "the lower one of before and of the run"


@pytest.mark.each_value(full="each motion in both generations")
@pytest.mark.parametrize("what", ["run", "replay"])
def test_what_was_raised_in_a_run_goes_back(ready, what):
    part = started(ready, FAR, speed_percent=40) if what == "run" else replaying(ready)
    accepted(override(ready, 90))
    assert ready.controller.operating_state.speed_percent == 90
    ready.run(0.5)
    part.stop()
    ready.run_until(lambda: not part.running, seconds=60.0)
    ready.run(1.5)
    assert ready.controller.operating_state.speed_percent == 40
    assert ready.firmware.condition.speed_percent == 40


@pytest.mark.parametrize("mit", [False, True], ids=["planned", "MIT"])
def test_it_sends_nothing_once_another_host_has_the_arm(rig, other_host, mit):
    ready = made_ready(rig)
    started(ready, FAR)
    ready.run(0.5)
    other_host.speed(70, move=4 if mit else 1, mit=mit)
    ready.run(0.3)
    ready.heard()
    override(ready, 10)
    ready.controller.speed_override.step(-10)
    ready.run(1.0)
    assert mode_words(ready) == []
    assert ready.firmware.condition.speed_percent == 70


def test_a_lower_percentage_that_is_lost_is_told_again(ready):
    started(ready, FAR)
    ready.run(0.6)
    ready.node.link.lose_to_arm(0x151)
    override(ready, 70)
    ready.run(0.2)
    assert ready.firmware.condition.speed_percent == 56  # 70 % of 80


def test_lost_for_good_it_ends_the_run(ready):
    player = started(ready, FAR)
    ready.run(0.5)
    ready.node.link.lose_to_arm(0x151, 100)
    override(ready, 10)
    ready.run_until(lambda: not player.running, seconds=3.0)
    assert "motion_too_fast" in ready.codes()
    assert player.phase is RunPhase.FAILED
    ready.run(1.0)
    assert not ready.firmware.mechanics.moving


@pytest.mark.each_value(full="each motion at each percentage in both generations")
@pytest.mark.parametrize("percent", [80, 1])
@pytest.mark.parametrize("what", ["run", "approach"])
def test_a_pause_that_is_lost_is_told_again(ready, what, percent):
    """At 1 % a joint moves at 1.8 °/s: slower than what may be the trembling of one that holds."""
    if what == "run":
        part = started(ready, FAR, percent=percent)
    else:
        part = ready.controller.replayer
        override(ready, percent)
        accepted(part.start(Replay(even_turn())))
    ready.run(0.5)
    ready.node.link.lose_to_arm(0x150)
    override(ready, 0)
    ready.run(1.5)
    assert part.progress.phase is RunPhase.PAUSED
    assert max(speeds_deg_s(ready, 0.5)) < 0.01
    ready.heard()
    ready.run(0.5)
    assert ready.heard() == []


def test_a_pause_that_was_gone_on_with_is_not_told_again(ready):
    player = started(ready, FAR)
    ready.run(0.5)
    player.pause()
    accepted(player.go_on())
    ready.run(0.5)
    assert [frame.data[1] for frame in ready.heard() if frame.arbitration_id == 0x150] == [1, 2]
    assert ready.firmware.mechanics.moving


def test_a_pause_that_is_lost_for_good_ends_the_run(ready):
    player = started(ready, FAR)
    ready.run(0.5)
    ready.node.link.lose_to_arm(0x150, 2)
    override(ready, 0)
    ready.run_until(lambda: not player.running, seconds=3.0)
    assert "motion_too_fast" in ready.codes()
    ready.run(1.0)
    assert not ready.firmware.mechanics.moving


def test_a_slow_run_is_not_given_up(ready):
    """At 4 % the way takes 25 times as long as the run was expected to."""
    player = started(ready, (60.0, *HERE[1:]), percent=100)
    override(ready, 4)
    ready.run(8.0)
    assert player.running
    assert player.progress.remaining_s == pytest.approx((2.0 - 8.0 * 0.04) / 0.04, rel=0.1)
    override(ready, 100)
    ready.run_until(lambda: not player.running)
    assert player.phase is RunPhase.DONE


# A driver that holds what it is given -------------------------------------------------------------


def turning_fast(ready):
    """A run in the middle of a long way, and a driver that keeps the next frame."""
    player = started(ready, (-140.0, *HERE[1:]), FAR)
    ready.run_until(lambda: ready.firmware.mechanics.speeds_deg_s[0] > 100.0)
    ready.heard()
    ready.hold_driver()
    return player


def sent(ready):
    return [(frame.arbitration_id, frame.data[:3].hex()) for frame in ready.heard()]


def test_a_driver_that_is_slow_for_a_moment_tells_the_lowest_last(ready):
    player = turning_fast(ready)
    accepted(override(ready, 50))
    ready.run(0.04)
    accepted(override(ready, 25))
    ready.run(0.04)
    assert sent(ready) == []
    ready.free_driver()
    ready.run(0.3)

    assert sent(ready) == [(0x151, "010128"), (0x151, "010114"), (0x151, "010114")]
    assert ready.firmware.condition.speed_percent == 20  # 25 % of 80
    assert player.phase is RunPhase.MOVING
    assert not {"motion_too_fast", "bus_blocked"} & set(ready.codes())


@pytest.mark.each_value(full="all of it in both generations")
@pytest.mark.parametrize(("percent", "held"), [(25, (0x151, "010114")), (0, (0x150, "000100"))])
def test_a_lower_speed_that_the_driver_keeps_ends_the_run_and_nothing_late_follows(
    ready, percent, held
):
    player = turning_fast(ready)
    accepted(override(ready, percent))
    ready.run_until(lambda: not player.running, seconds=3.0)
    assert "motion_too_fast" in ready.codes()
    assert player.phase is RunPhase.FAILED
    ready.run(1.0)
    assert "bus_blocked" in ready.codes()
    accepted(ready.controller.motion.set_speed_percent(10))
    ready.run(2.0)
    assert sent(ready) == []

    ready.free_driver()
    ready.run(0.2)
    assert sent(ready) == [held, (0x150, "000600")]  # the arm ends a motion if it is still at one
    ready.run(3.0)
    assert "bus_unblocked" in ready.codes()
    assert set(sent(ready)) <= {(0x151, "010128")}  # the operator's own 40 %
    assert not ready.firmware.mechanics.moving


@pytest.mark.each_value(full="each time that the driver is blocked, in both generations")
@pytest.mark.parametrize("blocked_s", [0.3, 2.5])
def test_a_replay_at_0_percent_ends_where_it_was_held_back_whatever_the_driver_kept(
    ready, blocked_s
):
    replayer = replaying(ready)
    ready.hold_driver()
    ready.run(0.04)
    accepted(override(ready, 0))
    ready.run(blocked_s)
    assert sent(ready) == []
    stood_deg = ready.firmware.joints_deg[0]
    assert ("bus_blocked" in ready.codes()) is (blocked_s > 0.5)

    ready.free_driver()
    ready.run(3.0)
    late = sent(ready)
    assert {each[0] for each in late} <= {0x155, 0x156, 0x157}
    assert blocked_s < 0.5 or len(late) == 1  # what was in the driver cannot be recalled
    # no further than it went on being recorded until it was held back, in 0.2 s
    assert 0.0 <= ready.firmware.joints_deg[0] - stood_deg < 12.0 * 0.2
    assert not ready.firmware.mechanics.moving
    assert replayer.phase is RunPhase.PAUSED


def test_a_replay_that_the_driver_keeps_from_the_arm_ends_and_nothing_late_follows(ready):
    replayer = replaying(ready)
    ready.hold_driver()
    accepted(override(ready, 25))
    ready.run_until(lambda: not replayer.running, seconds=5.0)
    assert replayer.phase is RunPhase.FAILED
    assert {"bus_blocked", "replay_failed"} <= set(ready.codes())
    ready.run(1.0)
    stood_deg = ready.firmware.joints_deg[0]
    assert sent(ready) == []

    ready.free_driver()
    ready.run(0.2)
    kept, abort = sent(ready)
    assert kept[0] == 0x155
    assert abort == (0x150, "000600")
    ready.run(3.0)
    assert set(sent(ready)) <= {(0x151, "010128")}
    assert ready.firmware.joints_deg[0] == pytest.approx(stood_deg, abs=0.5)


# Arms and computers of every kind -----------------------------------------------------------------


@pytest.mark.each_value(full="all percentages in both generations")
@pytest.mark.parametrize("percents", [(5,), (0,), (60, 20, 5, 0)])
def test_joints_of_low_acceleration_are_given_their_time(any_rig, percents):
    """From 70 °/s to rest a joint of 30 °/s² takes more than two seconds."""
    any_rig.firmware.settings.accelerations_deg_s2[:] = [30.0] * 6
    ready = made_ready(any_rig)
    player = started(ready, (145.0, *HERE[1:]), (-145.0, *HERE[1:]), percent=100)
    ready.run_until(lambda: ready.firmware.mechanics.speeds_deg_s[0] < -70.0)
    for percent in percents:
        override(ready, percent)
        ready.run(0.3)
    ready.run(3.0)
    assert player.progress.refusal is None
    assert player.running


def test_a_line_is_given_the_time_to_brake(ready):
    start = (0.0, 70.0, -60.0, 0.0, 30.0, 0.0)
    accepted(ready.controller.motion.send_joints(start))
    ready.run(4.0)
    pose = ready.firmware.kinematics.forward(start)
    end = (pose[0], pose[1] + 250.0, *pose[2:])
    run = Run("line", [Waypoint(MoveMode.MOVE_L, end, speed_percent=100)], [3.0])
    accepted(ready.controller.player.start(run))
    ready.run(0.7)
    override(ready, 0)
    ready.run(2.0)
    assert ready.controller.player.phase is RunPhase.PAUSED
    assert not ready.firmware.mechanics.moving
    assert "motion_too_fast" not in ready.codes()


def test_after_a_pause_of_the_program_the_pace_is_that_of_the_override(ready):
    replayer = replaying(ready)
    override(ready, 10)
    ready.run(1.0)
    before_deg = ready.firmware.joints_deg[0]
    ready.step(0.3)  # the program was held up; the recorded time goes on by one period
    ready.run(0.5)
    assert ready.firmware.joints_deg[0] - before_deg == pytest.approx(1.2 * 0.52, abs=0.25)
    assert replayer.phase is RunPhase.MOVING


def test_a_pause_of_the_program_ends_the_coming_to_a_stand(ready):
    """The arm rests at the last target by then: nothing sets it moving once more."""
    replayer = replaying(ready)
    override(ready, 0)
    ready.run(0.04)
    ready.heard()
    for timer in (replayer._timer, ready.controller._timer):
        timer.stop()
    for _ in range(50):  # the program is held up; the arm is heard all the time
        ready._pass(STEP_S)
    ready.run(0.5)
    assert not {0x155, 0x156, 0x157} & {frame.arbitration_id for frame in ready.heard()}
    assert replayer.phase is RunPhase.PAUSED
    override(ready, 100)
    accepted(replayer.go_on())
    assert speeds_deg_s(ready, 1.0)[-10:] == pytest.approx([12.0] * 10, abs=0.6)
