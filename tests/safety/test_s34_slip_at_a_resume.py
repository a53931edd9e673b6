"""B38: what slipped unseen shows at the next resume; it is said from 1° on, and kept with its date.

Whoever resumes: this program, or another host on the bus.
"""

import numpy as np
import pytest

from armui.arm.inspection_record import ResumeEntry
from armui.control.safety.recovery_steps import Action, StepKind
from armui.sim.faults.schedule import fault
from armui.telemetry.jumps import jump_deg
from tests.accepted import accepted

PLACE = (0.0, 40.0, -40.0, 0.0, 20.0, 0.0)
RESUME = "150#0200000000000000"
STOP = "150#0100000000000000"


@pytest.fixture
def ready(rig):
    rig.lie(PLACE)
    rig.ready()
    rig.run(1.5)
    return rig


def said(rig):
    return [each for each in rig.events if each.notice.id == "resume_slipped"]


def kept(rig):
    return rig.controller.reference.record.resumes


def stopped_and_resumed(rig):
    rig.controller.emergency_stop()
    rig.run(1.0)
    accepted(rig.controller.motors.resume())
    rig.run(2.0)


@pytest.mark.parametrize("joint", [2, 5])
def test_a_slip_is_said_and_kept(ready, joint):
    ready.node.faults.start(fault("slip", joint))
    ready.run(0.5)
    assert said(ready) == []
    stopped_and_resumed(ready)
    (event,) = said(ready)
    assert event.params["joints"].startswith(f"J{joint} ")
    (entry,) = kept(ready)
    assert abs(entry.slips_deg[joint - 1]) == pytest.approx(5.0, abs=0.3)
    assert list(entry.slipped) == [joint]
    assert entry.at.startswith("20")


def test_the_line_says_it_until_that_is_noted(ready):
    recovery = ready.controller.recovery
    ready.node.faults.start(fault("slip", 1))
    stopped_and_resumed(ready)
    assert (recovery.step.kind, recovery.step.action) == (StepKind.SLIPPED, Action.ENABLE)
    assert recovery.step.params["joints"].startswith("J1 ")
    accepted(ready.controller.motors.enable())
    ready.run(2.0)
    assert ready.controller.operating_state.cannot_move is None  # it forbids nothing
    assert recovery.step.kind in {StepKind.SLIPPED, StepKind.OUTSIDE}
    if recovery.step.kind is StepKind.OUTSIDE:
        accepted(ready.controller.motion.come_inside())
        ready.run(20.0)
    assert (recovery.step.kind, recovery.step.alternative) == (StepKind.SLIPPED, Action.NOTED)
    assert recovery.act(recovery.step, Action.NOTED) is None
    ready.run(0.1)
    assert recovery.step.kind is StepKind.READY
    stopped_and_resumed(ready)
    assert recovery.step.action is Action.ENABLE
    assert "joints" not in recovery.step.params


def test_an_arm_that_has_not_slipped_drops_and_that_is_no_slip(ready):
    stopped_and_resumed(ready)
    assert said(ready) == []
    (entry,) = kept(ready)
    assert max(map(abs, entry.slips_deg)) < 1.0
    fallen = max(abs(a - b) for a, b in zip(ready.firmware.joints_deg, PLACE, strict=True))
    assert fallen > 5.0


def test_the_resume_of_another_host_counts_too(ready, other_host):
    ready.node.faults.start(fault("slip", 5))
    other_host.say(STOP)
    ready.run(1.0)
    other_host.say(RESUME)
    ready.run(2.0)
    (event,) = said(ready)
    assert event.params["joints"].startswith("J5 ")


def test_resumes_in_a_row_are_one(ready, other_host):
    for _ in range(3):
        other_host.say(RESUME)
        ready.run(0.1)
    ready.run(2.0)
    assert len(kept(ready)) == 1


def test_an_arm_that_is_silent_then_tells_nothing_of_a_slip(ready):
    ready.node.faults.start(fault("slip", 5))
    ready.controller.emergency_stop()
    ready.run(1.0)
    accepted(ready.controller.motors.resume())
    ready.firmware.feedback_stopped = True
    ready.run(0.3)
    ready.firmware.feedback_stopped = False
    ready.run(2.0)
    assert said(ready) == []
    assert kept(ready)[-1].slips_deg == (None,) * 6


# How a jump is told from a fall -------------------------------------------------------------------

TIMES = np.arange(0.0, 0.7, 0.005)
AT_S = 0.15


def fallen(acceleration, stops_deg=40.0):
    """A joint that drops from the moment on, and lands."""
    since = np.maximum(TIMES - AT_S, 0.0)
    return np.minimum(acceleration / 2.0 * since**2, stops_deg)


@pytest.mark.parametrize("acceleration", [0.0, 300.0, 2000.0])
@pytest.mark.parametrize("slip", [0.0, 0.9, 1.1, -5.0, 85.0])
def test_a_jump_is_found_to_a_tenth_in_any_fall(acceleration, slip):
    angles = fallen(acceleration) + np.where(TIMES > AT_S + 0.02, slip, 0.0)
    assert jump_deg(TIMES, angles, AT_S) == pytest.approx(slip, abs=0.2)


def test_frames_that_come_in_bunches_or_not_at_all_jump_no_further():
    bunched = np.floor(TIMES / 0.02) * 0.02 + 1e-4 * np.arange(len(TIMES))
    angles = fallen(2000.0)
    assert jump_deg(bunched, angles, AT_S) == pytest.approx(0.0, abs=0.5)
    lost = np.ones(len(TIMES), dtype=bool)
    lost[[36, 45, 46, 50]] = False
    assert jump_deg(TIMES[lost], angles[lost], AT_S) == pytest.approx(0.0, abs=0.5)


@pytest.mark.each_value(full="each bunch of frames with each slip")
@pytest.mark.parametrize("slip", [0.0, -5.0, 85.0])
@pytest.mark.parametrize("bunch_s", [0.01, 0.02, 0.04])
def test_a_jump_in_bunched_frames_is_found_to_half_a_degree(bunch_s, slip):
    bunched = np.floor(TIMES / bunch_s) * bunch_s + 1e-4 * np.arange(len(TIMES))
    for later_s in np.arange(0.02, 0.06, 0.005):
        angles = fallen(300.0) + np.where(later_s < TIMES - AT_S, slip, 0.0)
        assert jump_deg(bunched, angles, AT_S) == pytest.approx(slip, abs=0.6)


def test_what_jumped_before_the_resume_is_none_of_it():
    angles = np.where(TIMES > AT_S - 0.05, 7.0, 0.0)
    assert jump_deg(TIMES, angles, AT_S) == pytest.approx(0.0)


def test_there_and_back_is_no_slip():
    """An arm that starts anew may tell 0 for a moment."""
    angles = np.where((TIMES > AT_S + 0.02) & (TIMES < AT_S + 0.1), 0.0, 30.0)
    assert jump_deg(TIMES, angles, AT_S) == pytest.approx(0.0)


@pytest.mark.parametrize("kept_rows", [slice(0, 30), slice(29, None)])
def test_too_little_tells_nothing(kept_rows):
    assert jump_deg(TIMES[kept_rows], fallen(300.0)[kept_rows], AT_S) is None


def test_a_slip_is_said_from_one_degree_on():
    entry = ResumeEntry("2026-11-27T10:00:00", (0.99, 1.0, -1.0, None, 0.0, -0.5))
    assert entry.slipped == {2: 1.0, 3: -1.0}
