"""S8: a step starts from our own target only while that stands for what the arm is doing."""

import pytest

from armui.arm.frames import JogFrame
from armui.protocol.codes import TrajectoryCommand

A = (50.0, 30.0, -30.0, 0.0, 0.0, 0.0)
FAR = (140.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-50.0, 30.0, -30.0, 0.0, 0.0, 0.0)


def at(bench, target):
    def there():
        return all(
            abs(a - b) < 0.05
            for a, b in zip(bench.firmware.body.positions_deg, target, strict=True)
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
    assert bench.controller.motion.send_joints(FAR) is None
    bench.run(0.4)
    assert bench.controller.planned_motion.command(TrajectoryCommand.ABORT) is None
    bench.run(pause_s)
    asked = bench.controller.motion.jog(6, 1.0)
    bench.run(2.0)

    assert asked is None
    assert bench.firmware.body.positions_deg[0] < 80.0
    assert bench.firmware.body.positions_deg[5] == pytest.approx(1.0, abs=0.05)


def test_steps_add_up_while_the_arm_is_on_its_way(ready):
    bench = ready
    for _ in range(5):
        assert bench.controller.motion.jog(6, 1.0) is None
        bench.step()
    bench.run(2.0)

    assert bench.firmware.body.positions_deg[5] == pytest.approx(5.0, abs=0.01)


def test_an_arm_that_sags_does_not_creep_down(ready):
    bench = ready
    bench.firmware.body.sag_deg = (0.0, 0.1, -0.1, 0.0, 0.0, 0.0)
    assert bench.controller.motion.send_joints(A) is None
    bench.run(4.0)
    assert bench.controller.state.angles_deg()[1] == pytest.approx(A[1] + 0.1, abs=0.02)

    for _ in range(5):
        assert bench.controller.motion.jog(6, 0.2) is None
        bench.run(1.0)

    assert bench.firmware.body.setpoints_deg == pytest.approx((*A[:5], 1.0), abs=0.01)


@pytest.mark.parametrize(("away_deg", "stands"), [(0.4, True), (0.6, False)])
def test_beyond_half_a_degree_the_arm_has_not_arrived(ready, away_deg, stands):
    bench = ready
    bench.firmware.body.sag_deg = (0.0, -away_deg, 0.0, 0.0, 0.0, 0.0)
    assert bench.controller.motion.send_joints(A) is None
    bench.run(4.0)

    assert (bench.controller.motion.setpoint_deg == A) is stands


@pytest.mark.parametrize(
    "ends",
    [
        lambda bench, _host: bench.controller.emergency_stop(),
        lambda bench, _host: bench.controller.motors.disable(),
        lambda bench, _host: bench.controller.planned_motion.command(TrajectoryCommand.ABORT),
        lambda bench, _host: bench.firmware.power_cycle(),
        lambda _bench, host: host.say("151#0101640000000000"),
        lambda _bench, host: host.say("471#0702000000000000"),
        lambda _bench, host: host.say("475#01AE000000000000"),
        lambda bench, _host: bench.node.line.mute_on.update({0x2A5, 0x2A6, 0x2A7}),
        lambda bench, _host: bench.node.line.mute_on.add(0x2A1),
        lambda bench, _host: bench.controller.zeroing.set_zero(6),
        lambda bench, _host: bench.controller.disconnect_device(),
    ],
    ids=[
        *("stop", "disable", "cancel", "power cycle", "other mode word", "other enable"),
        *("other zero", "angles silent", "status silent", "zero", "disconnected"),
    ],
)
def test_what_ends_our_target(ready, other_host, ends):
    bench = ready
    assert bench.controller.motion.send_joints(A) is None
    bench.run_until(at(bench, A))
    bench.run(0.5)
    assert bench.controller.motion.setpoint_deg == A

    ends(bench, other_host)
    bench.run(0.7)

    assert bench.controller.motion.setpoint_deg is None
