"""S7: one object knows who moves the arm, and what is outdated never leaves."""

import pytest

from armui.control.motion_command import Mover
from armui.protocol.codes import TeachingState
from tests.sim.talk import frame, mode, target

A = (40.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-40.0, 30.0, -30.0, 0.0, 0.0, 0.0)


def mover(bench) -> Mover:
    return bench.controller.situation.mover


def test_nobody_then_gravity_then_nobody(any_bench):
    bench = any_bench
    bench.connect()
    bench.run(0.5)
    assert mover(bench) is Mover.GRAVITY
    assert bench.controller.motors.enable() is None
    bench.run(1.0)
    assert mover(bench) is Mover.NOBODY


def test_ours_while_it_is_under_way(any_bench):
    bench = any_bench
    bench.ready()
    assert bench.controller.motion.send_joints(A) is None
    bench.run(0.4)
    assert mover(bench) is Mover.OURS
    bench.run(5.0)
    assert mover(bench) is Mover.NOBODY


def test_a_hand_in_drag_teaching(any_bench):
    bench = any_bench
    bench.ready()
    assert bench.controller.teaching.command(TeachingState.START_RECORDING) is None
    bench.run(0.5)
    assert mover(bench) is Mover.HAND


@pytest.mark.parametrize("silent", [0x2A1, 0x2A6])
def test_not_known_while_the_arm_is_not_heard(any_bench, silent):
    bench = any_bench
    bench.ready()
    bench.node.line.mute_on.add(silent)
    bench.run(0.7)
    assert mover(bench) is Mover.UNKNOWN


def test_not_known_while_it_moves_and_nobody_is_heard_to_move_it(bench):
    bench.ready()
    for line in (*target(80.0, 30.0, -30.0, 0.0, 0.0, 0.0), mode(50)):
        bench.firmware.on_frame(frame(line))  # by another way than this bus
    bench.run(0.6)
    assert bench.firmware.body.moving
    assert mover(bench) is Mover.UNKNOWN


def test_frames_of_a_command_that_is_over_are_dropped(bench):
    """Two targets are asked for while the driver is busy: only the newer one leaves, whole."""
    bench.ready()
    bench.heard()
    port = bench.controller._connection._worker._outbox._port
    with port.driver:
        assert bench.controller.motion.send_joints(A) is None
        assert bench.controller.motion.send_joints(B) is None
    bench.run(0.2)

    assert [each.arbitration_id for each in bench.heard()] == [0x155, 0x156, 0x157, 0x151]
    bench.run(6.0)
    assert bench.firmware.body.positions_deg == pytest.approx(B, abs=0.05)


def test_what_waits_when_another_host_takes_the_arm_never_leaves(bench, other_host):
    bench.ready()
    port = bench.controller._connection._worker._outbox._port
    with port.driver:
        assert bench.controller.motion.send_joints(A) is None
        bench.heard()
        other_host.say("155#0000000000000000")
        while not bench.controller._connection.traffic.series:
            bench.controller.tick()
        bench.controller.tick()
    bench.run(0.3)

    assert [each.arbitration_id for each in bench.heard()] == [0x155]  # the other host's
