"""S10, S20, S23, S28: a replay of the arm's own, begun by our word, ends as any motion of ours."""

import pytest

from armui.protocol.codes import TeachingState
from armui.protocol.frame import Frame
from tests.accepted import accepted

AWAY_DEG = (60.0, 40.0, -40.0, 0.0, 0.0, 0.0)
ENDS = {bytes([0, 6, 0, 0, 0, 0, 0, 0]), bytes([0, 0, 6, 0, 0, 0, 0, 0])}


@pytest.fixture
def taught(any_rig):
    """A hand has led the arm away and back, at 30°/s."""
    any_rig.ready()
    start_deg = any_rig.firmware.joints_deg
    accepted(any_rig.controller.teaching.command(TeachingState.START_RECORDING))
    any_rig.run(0.2)
    for place in (AWAY_DEG, start_deg):
        any_rig.firmware.hand_guiding.lead_to(place, speed_deg_s=30.0)
        any_rig.run(2.2)
    accepted(any_rig.controller.teaching.command(TeachingState.STOP_RECORDING))
    any_rig.run(0.3)
    return any_rig


def replay(rig, command=TeachingState.RUN_RECORDING):
    accepted(rig.controller.teaching.command(command))
    rig.run_until(lambda: rig.firmware.mechanics.moving)
    rig.run(0.5)
    rig.heard()


def rests(rig):
    return not rig.firmware.mechanics.moving and all(rig.firmware.enabled)


EVERY_END = {
    "halt": lambda controller: controller.halt_and_hold(),
    "failure": lambda controller: controller.on_failure(),
    "the system": lambda controller: controller.end_all_motion(),
    "from any thread": lambda controller: controller.abort_from_any_thread(),
}


@pytest.mark.each_value(full="each end in both generations")
@pytest.mark.parametrize("end", EVERY_END.values(), ids=EVERY_END)
def test_it_ends_and_does_not_come_back(taught, end):
    replay(taught)
    end(taught.controller)
    taught.run(1.0)
    assert rests(taught)
    held_deg = taught.firmware.joints_deg
    taught.run(1.5)
    assert taught.firmware.joints_deg == held_deg
    assert "teaching_unanswered" not in taught.codes()


@pytest.mark.each_value(full="each end in both generations")
@pytest.mark.parametrize("end", EVERY_END.values(), ids=EVERY_END)
def test_it_ends_as_it_begins_before_the_arm_has_said_so(taught, end):
    accepted(taught.controller.teaching.command(TeachingState.RUN_RECORDING))
    taught._settle_what_was_said()
    end(taught.controller)
    taught.run(2.5)
    assert rests(taught)
    assert max(map(abs, taught.firmware.joints_deg)) < 15.0
    if end is not EVERY_END["from any thread"]:  # where the window hangs, nothing else is done
        assert "teaching_unanswered" not in taught.codes()


def test_it_ends_with_the_program(taught):
    replay(taught)
    taught.controller.shutdown()
    for _ in range(100):
        taught.firmware.step(0.01)
    assert rests(taught)


def test_an_end_that_was_lost_is_told_once_more(taught):
    replay(taught)
    taught.node.link.lose_to_arm(0x150, 2)
    taught.controller.on_failure()
    taught.run(0.2)
    assert taught.firmware.mechanics.moving
    taught.run(1.0)
    assert rests(taught)
    ends = [bytes(each.data) for each in taught.heard() if each.arbitration_id == 0x150]
    assert set(ends) == ENDS
    assert len(ends) == 4


def test_an_arm_that_goes_on_with_it_is_said(taught):
    replay(taught)
    taught.node.link.lose_to_arm(0x150, 100)
    assert taught.controller.halt_and_hold() is None
    taught.run(1.6)
    assert taught.firmware.mechanics.moving
    assert "cancel_unheeded" in taught.codes()


def test_one_that_somebody_else_began_is_not_ours_to_end(taught):
    """By the button on the arm: a failure of ours ends what is ours."""
    taught.firmware.on_frame(Frame(0x150, bytes([0, 0, 3, 0, 0, 0, 0, 0])))
    taught.run(0.5)
    taught.controller.on_failure()
    taught.run(0.5)
    assert taught.firmware.mechanics.moving
