"""S13: an arm that moved when it was first heard is nobody's to move until it rests."""

from itertools import count

import pytest

from armui.arm.refusal import Refusal
from armui.control.authority import MET_MOVING
from armui.control.link.link_state import LinkState
from tests.accepted import accepted
from tests.safety.fuzz.traffic import Sender
from tests.safety.fuzz.world import World

THERE = (60.0, 60.0, -60.0, 0.0, 0.0, 0.0)
BACK = (0.0, 20.0, -20.0, 0.0, 0.0, 0.0)
NUMBERS = count()


@pytest.fixture
def world(qapp, generation):
    """The arm, ready to move, with a second host; one clock for all, the adapter's too."""
    world = World(f"met moving {next(NUMBERS)}", generation)
    world.ready()
    yield world
    world.plug_cable_in()
    world.close()


def link(world):
    return world.controller.operating_state.link


def reopen(world, meanwhile=lambda: None):
    """The adapter is pulled, and put in again half a second later."""
    world.unplug_cable()
    world.pass_time(0.3)
    assert link(world) is LinkState.LOST
    meanwhile()
    world.plug_cable_in()
    world.pass_time(0.6)
    assert link(world) is LinkState.ONLINE
    world.pass_time(0.3)


def refused(world):
    said = len(world.traffic.said)
    answer = world.controller.motion.send_joints(BACK)
    assert not [each for each in world.traffic.said[said:] if each.sender is Sender.US]
    return isinstance(answer, Refusal) and answer.reason == MET_MOVING


def test_a_motion_that_another_host_began_while_the_adapter_was_lost(world):
    reopen(world, lambda: world.other.move_to(THERE, 10))
    assert world.firmware.mechanics.moving
    assert refused(world)
    world.pass_time(6.0)
    assert world.firmware.mechanics.positions_deg == pytest.approx(THERE, abs=0.02)
    accepted(world.controller.motion.send_joints(BACK))


def test_the_halt_ends_it_and_the_arm_may_be_moved(world):
    reopen(world, lambda: world.other.move_to(THERE, 10))
    assert refused(world)
    assert world.controller.halt_and_hold() is None
    world.pass_time(1.0)
    assert not world.firmware.mechanics.moving
    accepted(world.controller.motion.send_joints(BACK))


@pytest.mark.parametrize("fails", [True, False])
def test_a_failure_while_the_adapter_is_lost_ends_our_motion_when_it_is_back(world, fails):
    world.controller.motion.set_speed_percent(10)
    accepted(world.controller.motion.send_joints(THERE))
    world.pass_time(0.5)
    reopen(world, world.controller.on_failure if fails else lambda: None)
    world.pass_time(0.5)
    assert world.firmware.mechanics.moving is not fails
    assert world.firmware.mechanics.positions_deg[0] < 55.0


def test_a_failure_is_not_made_up_for_where_nothing_of_ours_moved(world):
    said = len(world.traffic.said)
    reopen(world, world.controller.on_failure)
    ours = [each.frame for each in world.traffic.said[said:] if each.sender is Sender.US]
    assert 0x150 not in {each.arbitration_id for each in ours}


def test_what_moves_on_of_ours_is_slowed_and_held_as_before(world):
    """After a silence the arm still moves by our doing: it may be slower, and nothing else."""
    world.controller.motion.set_speed_percent(20)
    accepted(world.controller.motion.send_joints(THERE))
    world.pass_time(0.3)
    reopen(world)
    assert refused(world)
    world.controller.motion.set_speed_percent(50)
    world.pass_time(0.1)
    assert world.firmware.condition.speed_percent == 20
    world.controller.motion.set_speed_percent(5)
    world.pass_time(0.1)
    assert world.firmware.condition.speed_percent == 5
    world.controller.motion.set_speed_percent(0)
    world.pass_time(1.0)
    assert not world.firmware.mechanics.moving
    assert world.controller.operating_state.holds


def test_what_another_host_began_is_not_hurried_by_a_speed_that_is_lower_than_ours(world):
    """It was told 10 %, and this program 30 % before: 20 % would be twice as fast."""
    world.controller.motion.set_speed_percent(30)
    world.pass_time(0.1)
    reopen(world, lambda: world.other.move_to(THERE, 10))
    world.controller.motion.set_speed_percent(20)
    world.pass_time(0.1)
    assert world.firmware.condition.speed_percent == 10
