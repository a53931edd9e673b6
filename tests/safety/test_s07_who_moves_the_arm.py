"""S7: one object knows who moves the arm, and what is outdated never leaves."""

import pytest

from armui.control.motion.motion_command import Mover
from armui.protocol.codes import TeachingState
from tests.accepted import accepted
from tests.sim.talk import frame, mode, target

A = (40.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-40.0, 30.0, -30.0, 0.0, 0.0, 0.0)


def mover(rig) -> Mover:
    return rig.controller.operating_state.mover


def test_nobody_then_gravity_then_nobody(any_rig):
    rig = any_rig
    rig.connect()
    rig.run(0.5)
    assert mover(rig) is Mover.GRAVITY
    accepted(rig.controller.motors.enable())
    rig.run(1.0)
    assert mover(rig) is Mover.NOBODY


def test_ours_while_it_is_under_way(any_rig):
    rig = any_rig
    rig.ready()
    accepted(rig.controller.motion.send_joints(A))
    rig.run(0.4)
    assert mover(rig) is Mover.OURS
    rig.run(5.0)
    assert mover(rig) is Mover.NOBODY


def test_a_hand_in_drag_teaching(any_rig):
    rig = any_rig
    rig.ready()
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    assert mover(rig) is Mover.HAND


@pytest.mark.parametrize("silent", [0x2A1, 0x2A6])
def test_not_known_while_the_arm_is_not_heard(any_rig, silent):
    rig = any_rig
    rig.ready()
    rig.node.link.mute_on.add(silent)
    rig.run(0.7)
    assert mover(rig) is Mover.UNKNOWN


def test_not_known_while_it_moves_and_nobody_is_heard_to_move_it(rig):
    rig.ready()
    for line in (*target(80.0, 30.0, -30.0, 0.0, 0.0, 0.0), mode(50)):
        rig.firmware.on_frame(frame(line))  # by another way than this bus
    rig.run(0.6)
    assert rig.firmware.mechanics.moving
    assert mover(rig) is Mover.UNKNOWN


def test_frames_of_a_command_that_is_over_are_dropped(rig):
    """Two targets are asked for while the driver is busy: only the newer one leaves, whole."""
    rig.ready()
    rig.heard()
    port = rig.controller._connection._worker._outbox._port
    with port.driver:
        accepted(rig.controller.motion.send_joints(A))
        accepted(rig.controller.motion.send_joints(B))
    rig.run(0.2)

    assert [each.arbitration_id for each in rig.heard()] == [0x155, 0x156, 0x157, 0x151]
    rig.run(6.0)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(B, abs=0.05)


def test_what_waits_when_another_host_takes_the_arm_never_leaves(rig, other_host):
    rig.ready()
    port = rig.controller._connection._worker._outbox._port
    with port.driver:
        accepted(rig.controller.motion.send_joints(A))
        rig.heard()
        other_host.say("155#0000000000000000")
        while not rig.controller._connection.traffic.series:
            rig.controller.tick()
        rig.controller.tick()
    rig.run(0.3)

    assert [each.arbitration_id for each in rig.heard()] == [0x155]  # the other host's


def test_an_enable_of_motors_that_are_on_takes_no_motion_from_us(rig):
    controller = rig.controller
    rig.ready()
    accepted(controller.motion.send_joints(A))
    rig.run(0.4)
    accepted(controller.motors.enable())
    rig.run(0.3)
    assert mover(rig) is Mover.OURS
    assert controller.operating_state.uncommanded is None
    controller.motion.set_speed_percent(0)
    rig.run(0.5)
    assert controller.operating_state.held_target_deg == pytest.approx(A)
