"""S13: another host is noticed, named and respected; only the stop wins against it."""

import can
import pytest

from armui.bus.echo import is_own_echo
from armui.control.jog_ways import JointJog
from armui.control.motion_command import Mover
from armui.control.recovery_steps import Action, Kind
from armui.control.run import Phase, Run
from armui.protocol.codes import MoveMode
from armui.trajectory.program import Waypoint
from tests.company import OtherArm

A = (30.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-30.0, 30.0, -30.0, 0.0, 0.0, 0.0)


@pytest.fixture
def ready(bench):
    bench.ready()
    bench.heard()
    return bench


@pytest.mark.parametrize(
    ("frame", "name"),
    [
        ("150#0000010000000000", "0x150"),
        ("151#0101320000000000", "0x151"),
        ("155#0000000000000000", "0x155"),
        ("159#0000000000000100", "0x159"),
        ("15C#7FFF7FF0007FF7F7", "0x15C"),
        ("471#0702000000000000", "0x471"),
        ("475#0600000000000000", "0x475"),
        ("470#0000000000000000", "0x470"),
        ("183#77706F00006FE8", "0x183"),
    ],
)
def test_each_motion_frame_of_another_host_holds_ours_back(ready, other_host, frame, name):
    bench, controller = ready, ready.controller
    other_host.say(frame)
    bench.run(0.2)

    refusal = controller.situation.cannot_move
    assert refusal.code == "other_host"
    assert refusal.params["frames"] == name
    assert "other_host_moves" in bench.codes()
    assert controller.motion.jog(6, 1.0).code == "other_host"
    bench.run(1.7)
    assert controller.situation.cannot_move is not None
    bench.run(0.5)
    assert controller.situation.other_host is None
    assert "other_host_gone" in bench.codes()


@pytest.mark.parametrize(
    "frame",
    [
        "4AF#0100000000000000",
        "472#0101000000000000",
        "477#0100000000000000",
        "121#0100FF0000000000",
        "165#0000000000000000",
        "300#00",
    ],
)
def test_questions_lamps_and_other_arms_frames_hold_nothing_back(ready, other_host, frame):
    bench = ready
    other_host.say(frame)
    bench.run(0.1)

    assert bench.controller.situation.cannot_move is None


def test_a_stream_is_said_with_its_frames_its_beginning_and_its_rate(ready, other_host):
    bench, controller = ready, ready.controller
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    bench.run(1.0)

    other = controller.situation.other_host
    assert other.frames == "0x151, 0x155, 0x156, 0x157"
    assert other.rate_hz == pytest.approx(200, abs=20)
    assert controller.situation.mover is Mover.OTHER_HOST
    step = controller.recovery.step
    assert step.kind is Kind.OTHER_HOST
    assert step.params["frames"] == other.frames
    stream.end()


def test_against_a_stream_only_the_stop_wins(ready, other_host):
    bench, controller = ready, ready.controller
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    bench.run(0.5)
    assert controller.take_over().code == "other_host_streams"
    controller.emergency_stop()
    bench.run(0.3)

    assert bench.firmware.condition.stopped
    stream.end()


def test_it_is_taken_over_half_a_second_after_its_last_frame(ready, other_host):
    bench, controller = ready, ready.controller
    other_host.move_to(A, 10)
    bench.run(0.4)
    assert controller.take_over() is not None
    bench.run(0.2)
    step = controller.recovery.step
    assert (step.action, step.held) == (Action.TAKE_OVER, True)
    assert controller.recovery.act(step) is None
    bench.step()

    assert controller.situation.cannot_move is None
    assert controller.motion.send_joints(B) is None
    bench.run(8.0)
    assert bench.firmware.body.positions_deg == pytest.approx(B, abs=0.05)


def test_it_goes_on_until_the_arm_rests(ready, other_host):
    bench, controller = ready, ready.controller
    other_host.move_to((100.0, *A[1:]), 10)
    bench.run(3.0)

    assert bench.firmware.body.moving
    assert controller.situation.cannot_move.code == "other_host"
    bench.run(8.0)
    assert controller.situation.cannot_move is None


def test_a_run_cut_off_by_another_host_leaves_its_motion_alone(ready, other_host):
    bench, controller = ready, ready.controller
    points = [Waypoint(MoveMode.MOVE_J, A), Waypoint(MoveMode.MOVE_J, B)]
    assert controller.player.start(Run("r", points, [3.0, 3.0])) is None
    bench.run(0.5)
    bench.heard()
    other_host.move_to((60.0, *A[1:]), 50)
    bench.run(4.0)

    assert controller.player.progress.phase is Phase.FAILED
    assert controller.player.progress.reason.code == "other_host"
    assert bench.firmware.body.positions_deg == pytest.approx((60.0, *A[1:]), abs=0.05)
    assert not [frame for frame in bench.heard() if frame.arbitration_id == 0x150]


def test_a_jog_ends_and_sends_nothing_more(ready, other_host):
    bench, controller = ready, ready.controller
    assert controller.jogging.start(JointJog(6, 1)) is None
    bench.run(0.5)
    other_host.move_to(B, 30)
    bench.run(0.1)
    assert not controller.jogging.active
    bench.heard()
    bench.run(3.0)

    assert bench.firmware.body.positions_deg == pytest.approx(B, abs=0.05)
    assert bench.heard() == []


def test_another_hosts_resume_is_told(ready, other_host):
    bench, controller = ready, ready.controller
    controller.emergency_stop()
    bench.run(0.5)
    other_host.resume()
    bench.run(0.2)

    assert "other_host_moves" in bench.codes()


def test_enabling_waits_while_another_host_streams_targets(ready, other_host):
    bench, controller = ready, ready.controller
    controller.motors.disable()
    bench.run(1.0)
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    bench.run(0.3)

    assert controller.motors.enable().code == "other_host"
    stream.end()


def test_a_leader_arm_is_called_one(ready):
    bench, controller = ready, ready.controller
    leader = OtherArm.leader(bench)
    bench.run(1.0)

    assert controller.situation.cannot_move.code == "leader_arm"
    assert controller.situation.mover is Mover.LEADER
    assert controller.recovery.step.kind is Kind.LEADER_ARM
    leader.close()


@pytest.mark.parametrize(("interface", "echo"), [("socketcan", False), ("gs_usb", True)])
def test_a_program_of_the_same_pc_is_no_echo_on_socketcan(interface, echo):
    """python-can makes is_rx false of every frame sent from this computer there."""
    message = can.Message(arbitration_id=0x155, is_rx=False)

    assert is_own_echo(message, interface) is echo
    assert not is_own_echo(can.Message(arbitration_id=0x155), interface)
