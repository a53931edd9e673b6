"""S37: an arm that is not heard may be moving, and what was measured last is said with it."""

import errno

import can
import pytest

from armui.control.link.link_state import LinkState
from armui.control.safety.uncommanded_motion import MotionKind
from armui.ui import words
from tests.accepted import accepted
from tests.arm_rig import STEP_S
from tests.control.jogger import bend
from tests.safety.test_s37_sinking import Truth

FAR_DEG = (60.0, 40.0, -60.0, 15.0, 40.0, 20.0)


def pull_the_adapter(rig):
    rig.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    rig.step()
    assert rig.controller.operating_state.link is LinkState.LOST


def cut_the_cable(rig):
    rig.powered = False
    rig.run(0.6)
    assert rig.controller.operating_state.link is LinkState.OFFLINE


def seen(rig):
    return rig.controller.operating_state.uncommanded


def line(rig):
    return words.step(rig.controller.recovery.step)


@pytest.mark.parametrize("lose", [pull_the_adapter, cut_the_cable])
def test_lost_on_its_way(rig, lose):
    bend(rig)
    rig.controller.motion.set_speed_percent(20)
    truth = Truth(rig)
    accepted(rig.controller.motion.send_joints(FAR_DEG))
    truth.run(1.5)
    speeds_mm_s = truth.speeds_mm_s()
    lose(rig)
    motion = seen(rig)
    assert motion.kind is MotionKind.UNHEARD
    assert min(speeds_mm_s) - 1 <= motion.speed_mm_s <= max(speeds_mm_s) + 1
    assert motion.speed_mm_s > 20
    moved = f"The arm may be moving: it moved at {motion.speed_mm_s} mm/s when last heard, 1 s ago."
    assert line(rig).startswith(moved)
    assert "arm_unheard_moving" in rig.codes()
    rig.run(5.0)
    assert seen(rig).speed_mm_s == motion.speed_mm_s
    assert 5 <= seen(rig).seconds <= 6
    rig.step(115.0)
    assert line(rig).startswith("The arm may be moving: it moved at ")
    assert "2 min ago" in line(rig)


def test_lost_at_rest(rig):
    bend(rig)
    rig.run(1.0)
    cut_the_cable(rig)
    assert seen(rig).speed_mm_s == 0
    assert line(rig).startswith("The arm may be moving: it stood still when last heard, 1 s ago. ")
    assert "arm_unheard_moving" not in rig.codes()


def test_lost_while_it_sinks_and_heard_again(rig, qtbot):
    bend(rig)
    rig.controller.emergency_stop()
    rig.run(1.5)
    speed_mm_s = seen(rig).speed_mm_s
    pull_the_adapter(rig)
    assert seen(rig).kind is MotionKind.UNHEARD
    assert abs(seen(rig).speed_mm_s - speed_mm_s) <= 3
    rig.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())  # the bus thread's pause is a real one
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    rig.run(1.0)
    assert seen(rig).kind is MotionKind.SINKS


def test_of_an_arm_that_was_never_heard_nothing_is_claimed(rig):
    rig.powered = False
    rig.controller.connect_device(rig.device)
    rig.run(2.0)
    assert rig.controller.operating_state.link is LinkState.OFFLINE
    assert seen(rig) is None


def test_after_disconnecting_nothing_is_claimed(rig):
    bend(rig)
    cut_the_cable(rig)
    rig.controller.disconnect_device()
    assert seen(rig) is None


def test_between_two_ticks_nobody_is_accused(rig):
    """A quarter of a second without a frame is no silence, and an arm at rest stays at rest."""
    bend(rig)
    rig.run(1.0)
    rig.powered = False
    rig.run(0.25)
    assert seen(rig) is None
    rig.powered = True
    for _ in range(round(1.0 / STEP_S)):
        rig.step()
        assert seen(rig) is None
