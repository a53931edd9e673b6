"""S8: a step starts from our own target only while that stands for what the arm is doing."""

import pytest

from armui.arm.frames import JogFrame
from armui.protocol.codes import TrajectoryCommand

A = (50.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-50.0, 30.0, -30.0, 0.0, 0.0, 0.0)


def at(bench, target):
    def there():
        return all(
            abs(a - b) < 0.05 for a, b in zip(bench.firmware.body.positions_deg, target, strict=True)
        )

    return there


@pytest.fixture
def ready(bench):
    bench.ready()
    bench.controller.motion.set_speed_percent(100)
    return bench


def lets_the_other_go(bench):
    """Two seconds after its last frame, with the arm at rest, another host is gone."""
    bench.run(2.6)
    assert bench.controller.situation.cannot_move is None


def test_a_step_after_another_host_moved_the_arm_starts_where_it_is(ready, other_host):
    bench = ready
    assert bench.controller.motion.send_joints(A) is None
    bench.run_until(at(bench, A))
    other_host.move_to(B)
    bench.run_until(at(bench, B))
    lets_the_other_go(bench)

    assert bench.controller.motion.jog(6, 1.0) is None
    bench.run(1.5)

    assert bench.firmware.body.positions_deg == pytest.approx((*B[:5], 1.0), abs=0.05)


def test_a_tool_step_after_another_host_moved_the_arm_starts_where_it_is(ready, other_host):
    bench = ready
    assert bench.controller.motion.send_joints(A) is None
    bench.run_until(at(bench, A))
    assert bench.controller.cartesian.step(2, 5.0, JogFrame.BASE) is None
    bench.run(1.0)
    other_host.move_to(B)
    bench.run_until(at(bench, B))
    lets_the_other_go(bench)
    before = bench.controller.state.end_pose()

    assert bench.controller.cartesian.step(2, 1.0, JogFrame.BASE) is None
    bench.run(1.0)

    after = bench.controller.state.end_pose()
    assert after[2] - before[2] == pytest.approx(1.0, abs=0.2)
    assert after[:2] == pytest.approx(before[:2], abs=0.2)


@pytest.mark.parametrize("pause_s", [0.02, 0.2, 0.6])
def test_a_cancelled_target_does_not_come_back_with_a_step(ready, pause_s):
    bench = ready
    assert bench.controller.motion.send_joints(A) is None
    bench.run(0.5)
    assert bench.controller.planned_motion.command(TrajectoryCommand.ABORT) is None
    bench.run(pause_s)
    asked = bench.controller.motion.jog(6, 1.0)
    bench.run(2.0)

    assert asked is None
    assert abs(bench.firmware.body.positions_deg[0]) < 45.0
    assert bench.firmware.body.positions_deg[5] == pytest.approx(1.0, abs=0.05)


def test_steps_add_up_while_the_arm_is_on_its_way(ready):
    bench = ready
    for _ in range(5):
        assert bench.controller.motion.jog(6, 1.0) is None
        bench.step()
    bench.run(2.0)

    assert bench.firmware.body.positions_deg[5] == pytest.approx(5.0, abs=0.01)


def test_a_hand_that_moved_a_joint_by_less_than_sag_does_not_move_the_target(ready):
    """0.4° away the target stands; beyond half a degree the arm is where it is measured."""
    from armui.control.authority import ARRIVED_DEG

    assert ARRIVED_DEG == 0.5


@pytest.mark.parametrize("away_deg", [0.4, 0.6])
def test_an_arm_that_sags_does_not_creep(ready, away_deg):
    bench = ready
    assert bench.controller.motion.send_joints(A) is None
    bench.run_until(at(bench, A))
    bench.run(0.5)
    body = bench.firmware.body
    body.place = None
    moved = (A[0], A[1] - away_deg, *A[2:])
    bench.firmware.body._motion.place(moved)
    bench.run(0.6)
    assert bench.controller.motion.jog(6, 1.0) is None
    asked = bench.controller.motion.setpoint_deg

    expected = A[1] if away_deg < 0.5 else moved[1]
    assert asked[1] == pytest.approx(expected, abs=0.01)
