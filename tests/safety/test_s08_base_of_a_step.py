"""S8: a step starts from our own target only while that stands for what the arm is doing."""

import pytest

from armui.control.motion.jog_path import JointJog
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import TrajectoryCommand
from tests.accepted import accepted

A = (50.0, 30.0, -30.0, 0.0, 0.0, 0.0)
FAR = (140.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-50.0, 30.0, -30.0, 0.0, 0.0, 0.0)


def at(rig, target):
    def there():
        return all(
            abs(a - b) < 0.05
            for a, b in zip(rig.firmware.mechanics.positions_deg, target, strict=True)
        )

    return there


@pytest.fixture
def ready(rig):
    rig.ready()
    rig.controller.motion.set_speed_percent(100)
    return rig


def lets_the_other_go(rig):
    """Two seconds after its last frame, with the arm at rest, another host is gone."""
    rig.run(2.6)
    assert rig.controller.operating_state.cannot_move is None


def test_a_step_after_another_host_moved_the_arm_starts_where_it_is(ready, other_host):
    rig = ready
    accepted(rig.controller.motion.send_joints(A))
    rig.run_until(at(rig, A))
    other_host.move_to(B)
    rig.run_until(at(rig, B))
    lets_the_other_go(rig)

    accepted(rig.controller.motion.jog(6, 1.0))
    rig.run(1.5)

    assert rig.firmware.mechanics.positions_deg == pytest.approx((*B[:5], 1.0), abs=0.05)


def test_a_tool_step_after_another_host_moved_the_arm_starts_where_it_is(ready, other_host):
    rig = ready
    accepted(rig.controller.motion.send_joints(A))
    rig.run_until(at(rig, A))
    accepted(rig.controller.cartesian.step(2, 5.0, JogFrame.BASE))
    rig.run(1.0)
    other_host.move_to(B)
    rig.run_until(at(rig, B))
    lets_the_other_go(rig)
    before = rig.controller.state.end_pose()

    accepted(rig.controller.cartesian.step(2, 1.0, JogFrame.BASE))
    rig.run(1.0)

    after = rig.controller.state.end_pose()
    assert after[2] - before[2] == pytest.approx(1.0, abs=0.2)
    assert after[:2] == pytest.approx(before[:2], abs=0.2)


@pytest.mark.parametrize("pause_s", [0.02, 0.2, 0.6])
def test_a_cancelled_target_does_not_come_back_with_a_step(ready, pause_s):
    rig = ready
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(0.4)
    accepted(rig.controller.planned_motion.command(TrajectoryCommand.ABORT))
    rig.run(pause_s)
    accepted(rig.controller.motion.jog(6, 1.0))
    rig.run(2.0)

    assert rig.firmware.mechanics.positions_deg[0] < 80.0
    assert rig.firmware.mechanics.positions_deg[5] == pytest.approx(1.0, abs=0.05)


def test_steps_add_up_while_the_arm_is_on_its_way(ready):
    rig = ready
    for _ in range(5):
        accepted(rig.controller.motion.jog(6, 1.0))
        rig.step()
    rig.run(2.0)

    assert rig.firmware.mechanics.positions_deg[5] == pytest.approx(5.0, abs=0.01)


def test_an_arm_that_sags_does_not_creep_down(ready):
    rig = ready
    rig.firmware.mechanics.sag_deg = (0.0, 0.1, -0.1, 0.0, 0.0, 0.0)
    accepted(rig.controller.motion.send_joints(A))
    rig.run(4.0)
    assert rig.controller.state.angles_deg()[1] == pytest.approx(A[1] + 0.1, abs=0.02)

    for _ in range(5):
        accepted(rig.controller.motion.jog(6, 0.2))
        rig.run(1.0)

    assert rig.firmware.mechanics.setpoints_deg == pytest.approx((*A[:5], 1.0), abs=0.01)


@pytest.mark.parametrize(("away_deg", "stands"), [(0.4, True), (0.6, False)])
def test_beyond_half_a_degree_the_arm_has_not_arrived(ready, away_deg, stands):
    rig = ready
    rig.firmware.mechanics.sag_deg = (0.0, -away_deg, 0.0, 0.0, 0.0, 0.0)
    accepted(rig.controller.motion.send_joints(A))
    rig.run(4.0)

    assert (rig.controller.motion.setpoint_deg == A) is stands


@pytest.mark.parametrize(
    "ends",
    [
        lambda rig, _host: rig.controller.emergency_stop(),
        lambda rig, _host: rig.controller.motors.disable(),
        lambda rig, _host: rig.controller.planned_motion.command(TrajectoryCommand.ABORT),
        lambda rig, _host: rig.firmware.power_cycle(),
        lambda _rig, host: host.say("151#0101640000000000"),
        lambda _rig, host: host.say("471#0702000000000000"),
        lambda _rig, host: host.say("475#01AE000000000000"),
        lambda rig, _host: rig.node.link.mute_on.update({0x2A5, 0x2A6, 0x2A7}),
        lambda rig, _host: rig.node.link.mute_on.add(0x2A1),
        lambda rig, _host: rig.controller.zeroing.set_zero(6),
        lambda rig, _host: rig.controller.disconnect_device(),
    ],
    ids=[
        *("stop", "disable", "cancel", "power cycle", "other mode word", "other enable"),
        *("other zero", "angles silent", "status silent", "zero", "disconnected"),
    ],
)
def test_what_ends_our_target(ready, other_host, ends):
    rig = ready
    accepted(rig.controller.motion.send_joints(A))
    rig.run_until(at(rig, A))
    rig.run(0.5)
    assert rig.controller.motion.setpoint_deg == A

    ends(rig, other_host)
    rig.run(0.7)

    assert rig.controller.motion.setpoint_deg is None


def test_what_moved_while_its_angles_were_not_heard_is_no_place_to_step_from(ready):
    rig = ready
    rig.run(1.0)
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.node.link.mute_on |= {0x2A5, 0x2A6, 0x2A7}
    rig.run_until(lambda: "jog_ended" in rig.codes(), 1.0)
    moved_deg = rig.firmware.mechanics.positions_deg[0]
    assert moved_deg > 0.2

    refusal = rig.controller.motion.jog(5, 0.1)
    rig.run(0.3)

    assert refusal.reason.id == "feedback_silent"
    assert rig.firmware.mechanics.positions_deg[0] >= moved_deg
    rig.node.link.mute_on.clear()
    rig.run(1.0)
    accepted(rig.controller.motion.jog(5, 0.1))
