"""S19: after a pause of the program a replay catches up with nothing."""

import numpy as np
import pytest

from armui.control.run.execution import RUN_GAP
from armui.control.run.progress import RunPhase
from armui.control.run.replay import Replay
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted
from tests.control.test_replayer import STILL, wave

PERIOD_S = 0.02


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    return any_rig


def ramp(seconds=20.0, speed_deg_s=10.0):
    """Joint 1 turns evenly: a target tells the recorded time."""
    times = np.arange(0.0, seconds, 0.005)
    samples = np.zeros((len(times), 8))
    samples[:, 0] = times
    samples[:, 1:7] = STILL
    samples[:, 1] = speed_deg_s * (times - seconds / 2)
    samples[:, 7] = np.nan
    return Recording("ramp", samples=samples)


def replaying(rig, recording):
    replayer = rig.controller.replayer
    accepted(replayer.start(Replay(recording)))
    rig.run_until(lambda: replayer.progress.done > 0.1, seconds=60.0)
    return replayer


def recorded_s(replayer, recording):
    return replayer.progress.done * recording.duration_s


@pytest.mark.each_value(full="each time in both generations")
@pytest.mark.parametrize("pause_s", [0.1, 0.2, 0.4])
def test_the_recorded_time_stands_still_while_the_program_does(ready, pause_s):
    recording = ramp()
    replayer = replaying(ready, recording)
    before_s = recorded_s(replayer, recording)
    ready.step(pause_s)
    assert recorded_s(replayer, recording) - before_s == pytest.approx(PERIOD_S, abs=0.005)
    ready.run(0.4)  # and nothing is made up for later
    assert recorded_s(replayer, recording) - before_s == pytest.approx(0.42, abs=0.025)
    assert replayer.progress.phase is RunPhase.MOVING


def test_a_late_tick_is_no_pause(ready):
    recording = ramp()
    replayer = replaying(ready, recording)
    before_s = recorded_s(replayer, recording)
    ready.step(0.07)
    assert recorded_s(replayer, recording) - before_s == pytest.approx(0.07, abs=0.005)


def test_the_arm_is_never_faster_than_recorded_after_a_pause(ready):
    """Two out of three seconds lost at 0.4°/s were caught up at 18°/s."""
    replayer = replaying(ready, ramp(seconds=40.0, speed_deg_s=0.4))
    speeds = []
    for _ in range(8):
        ready.step(0.4)
        before = ready.firmware.joints_deg[0]
        for _ in range(10):
            ready.step()
            now = ready.firmware.joints_deg[0]
            speeds.append(abs(now - before) / PERIOD_S)
            before = now
    assert replayer.running
    assert max(speeds) < 1.0


@pytest.mark.each_value(full="each time in both generations")
@pytest.mark.parametrize("pause_s", [0.6, 3.0, 7200.0])
def test_a_long_pause_ends_the_replay_and_says_why(ready, pause_s):
    replayer = replaying(ready, wave(seconds=20.0))
    ready.time_s += pause_s - PERIOD_S
    ready.step()
    progress = replayer.progress
    assert (progress.phase, progress.refusal.code) == (RunPhase.FAILED, "run_gap")
    assert progress.refusal.params == {"seconds": round(pause_s, 1)}
    told = [event for event in ready.events if event.code == "replay_failed"]
    assert told[-1].params["reason"].reason == RUN_GAP
    ready.run(0.5)
    at = ready.firmware.joints_deg
    ready.run(1.0)
    assert ready.firmware.joints_deg == at


@pytest.mark.each_value(full="each time in both generations")
@pytest.mark.parametrize("held_s", [0.1, 0.3, 0.4])
def test_the_recorded_time_stands_still_while_the_driver_holds_a_target(ready, held_s):
    """What had waited went out at once: joint 1 caught up 3° at the arm's own speed."""
    recording = ramp()
    replayer = replaying(ready, recording)
    ready.heard()
    before_s = recorded_s(replayer, recording)
    ready.hold_driver()
    ready.run(held_s)
    ready.free_driver()
    speeds = []
    for _ in range(25):
        before = ready.firmware.joints_deg[0]
        ready.step()
        speeds.append(abs(ready.firmware.joints_deg[0] - before) / PERIOD_S)
    assert recorded_s(replayer, recording) - before_s == pytest.approx(0.52, abs=0.045)
    assert max(speeds) < 1.5 * 10.0
    assert replayer.progress.phase is RunPhase.MOVING


def test_a_driver_that_holds_a_target_for_half_a_second_ends_the_replay(ready):
    replayer = replaying(ready, ramp())
    ready.hold_driver()
    ready.run_until(lambda: not replayer.running, seconds=2.0)
    ready.run(0.5)
    ready.heard()
    stood_deg = ready.firmware.joints_deg[0]
    ready.free_driver()
    ready.run(2.0)
    assert ready.firmware.joints_deg[0] == pytest.approx(stood_deg, abs=0.5)
