"""S37: what is late in arriving is never told as the arm's doing."""

from typing import Any

import pytest

from armui.control.link.link_state import LinkState
from armui.control.link.link_watch import FEEDBACK_LATE
from armui.control.motion.jog_path import JointJog
from armui.control.motion.motion_command import Mover
from armui.control.run.execution import RUN_GAP
from armui.control.run.preflight import MOVED_SINCE_CHECK, Checks
from armui.control.run.progress import RunPhase
from armui.control.run.replay import Replay
from armui.control.safety.interlocks import ENABLED_UNKNOWN
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.codes import TrajectoryCommand
from armui.telemetry.events import Level
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.points.program import Trajectory
from armui.ui.background import Background
from tests.accepted import accepted
from tests.app_driver import AtOnce
from tests.control.jogger import fastest_deg_s
from tests.control.test_replayer import wave
from tests.control.under_way import run_of, to
from tests.late_bus import LateBus
from tests.moments import now

BENT = (10.0, 60.0, -60.0, 0.0, 20.0, 0.0)
FAR = (100.0, 60.0, -60.0, 0.0, 20.0, 0.0)

ACCUSED = {
    *("motion_too_fast", "reference_left", "motion_unheeded", "cancel_unheeded"),
    *("gripper_not_there", "run_failed", "replay_failed", "enable_failed", "disable_failed"),
    *("gripper_act_failed", "motion_cut", "jog_ended"),
}


@pytest.fixture
def ready(rig):
    """An enabled arm at rest, and the bus to it."""
    rig.lie(BENT)
    rig.ready()
    rig.run(1.5)
    rig.events.clear()
    rig.late = LateBus(rig)
    return rig


def accused(rig):
    doubtful = rig.controller.operating_state.reference.doubtful
    return [code for code in rig.codes() if code in ACCUSED] + [f"J{joint}" for joint in doubtful]


def set_out(rig, percent=30, target=FAR):
    rig.controller.motion.set_speed_percent(percent)
    accepted(rig.controller.motion.send_joints(target))


# Nothing is concluded from it ---------------------------------------------------------------------


@pytest.mark.parametrize("percent", [5, 30, 100])
def test_a_motion_that_a_starving_arm_takes_late_is_its_motion(ready, percent):
    """It neither has vanished, nor is it uncommanded when it begins."""
    set_out(ready, percent)
    ready.late.starve(0.44)
    ready.run(0.4)
    assert ready.controller.operating_state.mover is Mover.OURS
    ready.run(6.0)
    assert accused(ready) == []


@pytest.mark.parametrize("held_s", [0.06, 0.1, 0.2, 0.44])
def test_what_comes_all_at_once_was_not_driven_at_once(ready, held_s):
    """The oldest come first and the others a tenth of a second later: it seems to run."""
    set_out(ready)
    ready.run(0.6)
    for _ in range(4):
        ready.late.hold_up(held_s)
        ready.late.hand_over(1)
        ready.late.hold_up(0.04)
        ready.late.hand_over(1)
        ready.late.hold_up(0.06)
        ready.late.hand_over()
        ready.run(0.1)
    ready.run(3.0)
    assert accused(ready) == []
    assert ready.firmware.joints_deg == pytest.approx(FAR, abs=0.01)


def test_many_short_waits_are_no_speed_either(ready):
    """Each is too short to be a gap; together they hold up a tenth of a second."""
    set_out(ready)
    ready.run(0.6)
    for _ in range(6):
        for _ in range(3):
            ready.late.hold_up(0.04)
            ready.late.hand_over(1)
        ready.late.hold_up(0.04)
        ready.late.hand_over()
        ready.run(0.06)
    ready.run(3.0)
    assert accused(ready) == []


@pytest.mark.parametrize("begins_s", [0.4, 0.5, 0.6])
def test_an_end_that_was_heeded_is_seen_late(ready, begins_s):
    set_out(ready, 60)
    ready.run(0.6)
    accepted(ready.controller.planned_motion.command(TrajectoryCommand.ABORT))
    ready.run(begins_s)
    ready.late.hold_up(0.44)
    ready.late.hand_over()
    ready.run(2.0)
    assert not ready.firmware.mechanics.moving
    assert accused(ready) == []


def test_a_run_that_was_ended_is_seen_at_rest_late(ready):
    controller = ready.controller
    accepted(controller.player.start(run_of(to(FAR), to(BENT))))
    ready.run(0.6)
    controller.player.stop()
    ready.run(0.2)
    for _ in range(4):  # the arm stands for long, and it is not heard for long enough to tell
        ready.late.hold_up(0.44)
        ready.late.hand_over()
        ready.run(0.06)
    assert now(controller.player.phase) is RunPhase.STOPPING
    ready.run(1.0)
    assert controller.player.phase is RunPhase.STOPPED
    assert accused(ready) == []


@pytest.mark.parametrize("held_s", [0.3, 0.6, 1.5])
def test_an_arm_halted_from_here_holds_nothing_of_another_host_after_a_silence(ready, held_s):
    """It stands short of its target by our word, and nobody else was heard."""
    set_out(ready)
    ready.run(0.6)
    assert ready.controller.halt_and_hold() is None
    ready.run(2.0)
    ready.late.starve(held_s)
    steps = set()
    for _ in range(100):
        ready.run(0.02)
        steps.add(ready.controller.recovery.step.kind)
    assert StepKind.READY in steps
    assert StepKind.LEFT_HELD_BACK not in steps


@pytest.mark.parametrize("silent_s", [0.3, 0.6, 1.5])
def test_a_checked_way_begins_where_the_arm_stood_before_a_silence(ready, silent_s):
    """Not heard, it is not said to have moved; heard elsewhere it is."""
    checked: list[Any] = []
    content = Trajectory("Test", points=(to(FAR),))
    Checks(ready.controller, Background(AtOnce())).begin(content, RunOptions(), checked.append)
    ready.run_until(lambda: bool(checked))
    ready.late.starve(silent_s)
    for _ in range(60):
        assert checked[0].why_moved(ready.controller) is None
        ready.run(0.02)
    set_out(ready)
    ready.run(0.6)
    assert checked[0].why_moved(ready.controller).reason == MOVED_SINCE_CHECK


def test_a_replay_is_not_behind_by_what_arrives_late(ready):
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(wave(seconds=4.0, swing_deg=60.0))))
    ready.run_until(lambda: replayer.progress.done > 0.05)
    for _ in range(4):
        ready.late.hold_up(0.44)
        ready.late.hand_over()
        ready.run(0.1)
    ready.run_until(lambda: not replayer.running)
    assert (replayer.phase, accused(ready)) == (RunPhase.DONE, [])


@pytest.mark.parametrize("approaches", [True, False])
def test_a_replay_waits_for_motors_that_are_heard_late(ready, approaches):
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(wave(seconds=4.0, swing_deg=60.0))))
    ready.run_until(lambda: approaches or replayer.progress.done > 0.05)
    ready.late.hold_up(0.44)
    ready.late.hand_over(1)
    ready.late.hold_up(0.3)
    assert None in ready.controller.operating_state.enabled
    ready.late.hand_over()
    ready.run_until(lambda: not replayer.running)
    assert (replayer.phase, accused(ready)) == (RunPhase.DONE, [])


@pytest.mark.parametrize(("held_s", "told"), [(0.44, RUN_GAP), (0.0, ENABLED_UNKNOWN)])
def test_what_ends_a_run_while_feedback_comes_late_is_told_as_that(ready, held_s, told):
    player = ready.controller.player
    accepted(player.start(run_of(to(FAR), to(BENT))))
    ready.run(0.6)
    ready.node.link.lose_to_bus(0x262, 999)
    while player.running:
        ready.late.hold_up(held_s)
        ready.late.hand_over()
        ready.run(0.06)
    assert player.progress.refusal.reason == told


def test_a_gripper_that_a_starving_arm_moves_late_is_not_blocked(ready):
    accepted(ready.controller.gripper.move(60.0, 1.0))
    ready.late.starve(0.44)
    ready.late.hold_up(0.3)
    ready.late.hand_over()
    ready.run(4.0)
    assert "gripper_there" in ready.codes()
    assert accused(ready) == []


def test_motors_that_a_starving_arm_switches_late_are_switched(ready):
    accepted(ready.controller.motors.disable())
    for _ in range(3):
        ready.late.hold_up(0.44)
        ready.late.hand_over(1)
    ready.late.hand_over()
    ready.run(1.0)
    assert accused(ready) == []
    assert "disabled" in ready.codes()


def test_where_a_joint_was_in_a_gap_nobody_knows(ready):
    """It was pushed and let go, and nothing of it was reported."""
    lost = ready.firmware.lost_reference
    for_s = 0.3
    ready.firmware.feedback_stopped = True
    lost.reported_deg = lambda angles: (*angles[:4], angles[4] + 40.0, angles[5])
    ready.run(for_s)
    del lost.reported_deg
    ready.firmware.feedback_stopped = False
    ready.run(3.0)
    assert accused(ready) == []


# What the arm does is still told ------------------------------------------------------------------


def test_a_motion_that_is_too_fast_is_ended_after_a_gap_too(ready):
    set_out(ready, 100, (20.0, *FAR[1:]))
    ready.run(2.0)
    ready.controller.motion.speed_percent = 5
    ready.node.link.lose_to_arm(0x151, 2)
    accepted(ready.controller.motion.send_joints((-150.0, *FAR[1:])))
    ready.late.hold_up(0.3)
    ready.late.hand_over()
    ready.run(0.4)
    assert "motion_too_fast" in ready.codes()
    ready.run(1.0)
    assert not ready.firmware.mechanics.moving


def test_a_motion_that_the_arm_does_not_take_is_said_after_a_gap_too(ready):
    ready.node.link.lose_to_arm(0x151, 9)
    for target in (0x155, 0x156, 0x157):
        ready.node.link.lose_to_arm(target, 9)
    set_out(ready)
    ready.late.hold_up(0.3)
    ready.late.hand_over()
    ready.run(2.0)
    assert accused(ready) == ["motion_unheeded"]


def test_an_end_that_is_not_heeded_is_said_after_a_gap_too(ready):
    set_out(ready, 10)
    ready.run(0.6)
    ready.node.link.lose_to_arm(0x150, 2)
    accepted(ready.controller.planned_motion.command(TrajectoryCommand.ABORT))
    ready.run(0.6)
    ready.late.hold_up(0.3)
    ready.late.hand_over()
    ready.run(0.6)
    assert "cancel_unheeded" in ready.codes()


def test_a_joint_that_is_elsewhere_after_a_gap_is_in_doubt(ready):
    lost = ready.firmware.lost_reference
    ready.firmware.feedback_stopped = True
    lost.reported_deg = lambda angles: (*angles[:4], angles[4] + 40.0, angles[5])
    ready.run(0.3)
    ready.firmware.feedback_stopped = False
    ready.run(1.0)
    assert ready.controller.operating_state.reference.doubtful == (5,)


def test_an_arm_that_does_not_follow_a_jog_is_said(ready):
    ready.node.link.lose_to_arm(0x155, 999)
    accepted(ready.controller.jogging.start(JointJog(1, 1)))
    ready.run(2.0)
    (ended,) = [each for each in ready.events if each.code == "jog_ended"]
    assert ended.params["reason"].reason.id == "jog_not_following"


# A pause that the arm has not made yet ------------------------------------------------------------


def held_when(rig, execution):
    """The joints' speeds when it is told that the arm holds; nothing of it is told at the press."""
    speeds_deg_s = []
    rig.controller.noticed.connect(
        lambda event: (
            speeds_deg_s.append(fastest_deg_s(rig)) if event.code == "pause_holds" else None
        )
    )
    assert fastest_deg_s(rig) > 5.0
    accepted(execution.pause())
    rig.run(0.1)
    assert speeds_deg_s == []
    rig.run(3.0)
    return speeds_deg_s


def test_a_run_that_pauses_holds_once_it_is_measured_at_rest(ready):
    player = ready.controller.player
    accepted(player.start(run_of(to(FAR), to(BENT))))
    ready.run(0.6)
    assert held_when(ready, player) == [pytest.approx(0.0, abs=0.1)]
    accepted(player.go_on())
    ready.run(0.3)
    accepted(player.pause())
    ready.run(3.0)
    assert ready.codes().count("pause_holds") == 2


def test_a_replay_that_pauses_holds_once_it_is_measured_at_rest(ready):
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(wave(seconds=4.0, swing_deg=60.0))))
    ready.run_until(lambda: replayer.progress.done > 0.25)
    assert held_when(ready, replayer) == [pytest.approx(0.0, abs=0.1)]


# It is called what it is --------------------------------------------------------------------------


def told_late(rig):
    return [each for each in rig.events if each.code == "feedback_late"]


def test_a_gap_is_told_once_in_ten_seconds_with_the_longest_of_them(ready):
    ready.late.hold_up(0.2)
    ready.late.hand_over()
    ready.run(0.1)
    (told,) = told_late(ready)
    assert told.params == {"value": 200}
    assert (told.level, told.notice) == (Level.WARNING, FEEDBACK_LATE)
    for held_s in (0.14, 0.3, 0.12):
        ready.late.hold_up(held_s)
        ready.late.hand_over()
        ready.run(0.2)
    assert len(told_late(ready)) == 1
    ready.run(9.0)
    assert [each.params for each in told_late(ready)[1:]] == [{"value": 300}]
    ready.run(11.0)
    assert len(told_late(ready)) == 2
    assert accused(ready) == []


def test_less_than_a_tenth_of_a_second_is_not_told(ready):
    for _ in range(5):
        ready.late.hold_up(0.06)
        ready.late.hand_over()
        ready.run(0.2)
    assert told_late(ready) == []


def test_of_an_arm_that_is_not_heard_it_is_told_that_it_is_offline(ready):
    ready.late.hold_up(1.0)
    assert ready.controller.operating_state.link is LinkState.OFFLINE
    ready.late.hand_over()
    ready.run(2.0)
    assert told_late(ready) == []
    assert "offline" in ready.codes()
