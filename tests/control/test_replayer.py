"""Recordings: what the recorder keeps of the simulated arm, and how a replay follows it."""

import math
from datetime import UTC, datetime

import numpy as np
import pytest

from armui.control.link.link_state import NOT_CONNECTED
from armui.control.operating_state import BUSY
from armui.control.run.progress import ENDLESS, RunPhase
from armui.control.run.replay import REPLAY_LAGGING, Replay
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted

STILL = (0.0, 30.0, -30.0, 0.0, 0.0, 0.0)


def wave(seconds=4.0, rate_hz=100.0, swing_deg=10.0, gripper_mm=math.nan):
    """Joint 1 swings, joint 2 goes up; the rest stays."""
    times = np.arange(0.0, seconds, 1.0 / rate_hz)
    samples = np.zeros((len(times), 8))
    samples[:, 0] = times
    samples[:, 1:7] = STILL
    samples[:, 1] = swing_deg * np.sin(2.0 * np.pi * times / seconds)
    samples[:, 2] += 5.0 * times / seconds
    samples[:, 7] = gripper_mm
    return Recording("wave", samples=samples, modified=datetime(2026, 1, 1, tzinfo=UTC))


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    return any_rig


def phase(rig):
    return rig.controller.replayer.progress.phase


def over(rig):
    return lambda: not rig.controller.replayer.running


def test_the_arm_follows_the_recording(ready):
    recording = wave()
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(recording)))
    ready.run(0.2)
    assert replayer.progress.remaining_s is None  # nobody knows how long the way there takes
    ready.run_until(lambda: replayer.progress.done > 0.0)
    assert replayer.progress.remaining_s == pytest.approx(4.0, abs=0.1)
    assert ready.firmware.joints_deg == pytest.approx(recording.joints_deg[0], abs=0.1)
    began_s = ready.time_s
    path = []

    def followed():
        path.append(ready.firmware.joints_deg)
        return over(ready)()

    ready.run_until(followed)
    assert (phase(ready), ready.controller.replayer.progress.refusal) == (RunPhase.DONE, None)
    assert 4.0 <= ready.time_s - began_s <= 5.0
    assert ready.firmware.joints_deg == pytest.approx(recording.joints_deg[-1], abs=0.1)
    first = [joints[0] for joints in path]
    assert max(first) == pytest.approx(10.0, abs=0.3)
    assert min(first) == pytest.approx(-10.0, abs=0.3)


def test_a_factor_changes_the_time_and_not_the_way(ready):
    replayer = ready.controller.replayer
    replayer.start(Replay(wave(), speed_percent=50))
    ready.run_until(lambda: replayer.progress.done > 0.0)
    began_s = ready.time_s
    path = []

    def followed():
        path.append(ready.firmware.joints_deg[0])
        return over(ready)()

    ready.run_until(followed)
    assert 8.0 <= ready.time_s - began_s <= 9.0
    assert max(path) == pytest.approx(10.0, abs=0.3)


def test_laps_begin_where_the_recording_begins(ready):
    replayer = ready.controller.replayer
    replayer.start(Replay(wave(), cycles=2))
    ready.run_until(over(ready), seconds=60.0)
    assert (phase(ready), replayer.progress.cycle) == (RunPhase.DONE, 2)


def test_a_pause_holds_the_arm(ready):
    replayer = ready.controller.replayer
    replayer.start(Replay(wave(), cycles=ENDLESS))
    ready.run_until(lambda: replayer.progress.done > 0.3)
    accepted(replayer.pause())
    ready.run(1.0)
    at = ready.firmware.joints_deg
    ready.run(3.0)
    assert ready.firmware.joints_deg == at
    accepted(replayer.go_on())
    ready.run_until(lambda: replayer.progress.cycle == 2)
    replayer.stop()
    ready.run_until(over(ready))
    assert phase(ready) is RunPhase.STOPPED


def test_a_program_that_hangs_does_not_leave_the_arm_moving(ready):
    replayer = ready.controller.replayer
    replayer.start(Replay(wave()))
    ready.run_until(lambda: replayer.progress.done > 0.2)
    ready.firmware.step(0.5)  # nobody sends
    at = ready.firmware.joints_deg
    ready.firmware.step(1.0)
    assert ready.firmware.joints_deg == at


def test_an_emergency_stop_ends_the_replay(ready):
    replayer = ready.controller.replayer
    replayer.start(Replay(wave()))
    ready.run_until(lambda: replayer.progress.done > 0.2)
    ready.controller.emergency_stop()
    assert (phase(ready), replayer.progress.refusal.code) == (RunPhase.FAILED, "run_stopped")
    ready.run(0.5)
    assert ready.firmware.condition.stopped


def test_an_arm_that_does_not_follow_is_noticed(ready):
    replayer = ready.controller.replayer
    replayer.start(Replay(wave(swing_deg=60.0)))
    ready.run_until(lambda: replayer.progress.done > 0.05)
    ready.firmware.on_frame = lambda _frame: []
    ready.run_until(over(ready))
    assert replayer.progress.refusal.reason == REPLAY_LAGGING


def test_a_slow_replay_may_lag_less(ready):
    """What a hand or an obstacle holds is noticed as near as the pace allows."""
    replayer, away_deg, follows = ready.controller.replayer, {}, ready.firmware.on_frame
    for percent in (100, 20):
        accepted(replayer.start(Replay(wave(swing_deg=60.0), speed_percent=percent)))
        ready.run_until(lambda: replayer.progress.done > 0.2, seconds=60.0)
        ready.firmware.on_frame = lambda _frame: []
        ready.run_until(over(ready), seconds=60.0)
        away_deg[percent] = replayer.progress.refusal.params["away"]
        ready.firmware.on_frame = follows
        ready.run(2.0)
    assert 5.0 <= away_deg[20] < 0.8 * away_deg[100]


def test_a_replay_that_is_slowed_and_sped_up_again_is_no_obstacle(ready):
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(wave(seconds=8.0, swing_deg=100.0))))
    for percent in (10, 100, 30, 100):
        ready.run_until(lambda: replayer.progress.done > 0.0, seconds=60.0)
        ready.run(1.2)
        accepted(ready.controller.motion.set_speed_percent(percent))
    ready.run_until(over(ready), seconds=60.0)
    assert (phase(ready), replayer.progress.refusal) == (RunPhase.DONE, None)


def test_a_joint_may_be_as_late_as_the_one_that_brakes_longest(ready):
    """The joints arrive together: joint 6, at 164 °/s, takes more than half a second to brake."""
    fast = wave(seconds=2.2)
    swing = -np.cos(np.pi * fast.times_s / 2.2)
    fast.samples[:, 1], fast.samples[:, 6] = 30.0 * swing, 115.0 * swing
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(fast)))
    ready.run_until(over(ready))
    assert (phase(ready), replayer.progress.refusal) == (RunPhase.DONE, None)


@pytest.mark.parametrize(
    ("replay", "code"),
    [
        (Replay(Recording("nothing")), "run_empty"),
        (Replay(wave(seconds=60.0, swing_deg=170.0)), "joint_out_of_limits"),
    ],
)
def test_what_the_arm_cannot_follow_is_not_begun(ready, replay, code):
    at = ready.firmware.joints_deg
    assert ready.controller.replayer.start(replay).code == code
    ready.run(0.5)
    assert ready.firmware.joints_deg == at


def test_one_too_fast_for_the_arm_is_capped_at_what_it_can(ready):
    replayer = ready.controller.replayer
    accepted(replayer.start(Replay(wave(seconds=2.5, swing_deg=120.0))))
    percent = ready.controller.operating_state.speed_percent
    assert 20 < percent < 100, "the slider shows the cap"
    refusal = ready.controller.motion.set_speed_percent(percent + 1)
    assert (refusal.code, refusal.params["percent"]) == ("replay_too_fast", percent)
    assert replayer.speed_percent == percent
    ready.run_until(over(ready))
    assert (phase(ready), ready.controller.replayer.progress.refusal) == (RunPhase.DONE, None)


def test_the_gripper_follows_where_it_was_recorded(rig):
    rig.ready()
    rig.controller.replayer.start(Replay(wave(gripper_mm=25.0)))
    rig.run_until(over(rig))
    assert rig.controller.state.gripper.value.opening_mm == pytest.approx(25.0, abs=0.5)


def test_what_the_arm_does_is_recorded(ready):
    recorder = ready.controller.recorder
    accepted(recorder.start())
    assert recorder.start().reason == BUSY
    ready.controller.motion.send_joints([10, 20, -20, 0, 0, 0])
    ready.run(3.0)
    recording = recorder.finish("led by hand").joined()
    generation_1 = recording.samples[:, 7]
    assert np.isnan(generation_1).all() == (int(ready.controller.operating_state.generation) == 1)
    assert recording.duration_s == pytest.approx(3.0, abs=0.1)
    assert (np.diff(recording.times_s) >= 0.0).all()
    assert recording.joints_deg[0] == pytest.approx([0.0] * 6, abs=0.5)
    assert recording.joints_deg[-1] == pytest.approx([10, 20, -20, 0, 0, 0], abs=0.1)
    assert recorder.dropped == 0


def test_a_lost_arm_leaves_what_was_recorded(ready):
    recorder = ready.controller.recorder
    recorder.start()
    ready.run(1.0)
    ready.controller.disconnect_device()
    assert not recorder.recording
    assert recorder.finish("cut").joined().duration_s == pytest.approx(1.0, abs=0.1)


def test_nothing_recorded_is_nothing(any_rig):
    assert any_rig.controller.recorder.start().reason == NOT_CONNECTED
    assert any_rig.controller.recorder.finish("empty") is None
