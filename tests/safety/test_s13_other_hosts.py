"""S13: another host is noticed, named and respected; only the stop wins against it."""

import can
import pytest

from armui.arm.state import GripperFault
from armui.bus.worker import is_own_echo
from armui.control.motion.jog_path import JointJog
from armui.control.motion.motion_command import Mover
from armui.control.operations.started import Ending
from armui.control.run.progress import Run, RunPhase
from armui.control.safety.other_command import LEADER_ARM, OTHER_HOST, OTHER_HOST_STREAMS
from armui.control.safety.recovery_steps import Action, StepKind
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint
from tests.accepted import accepted
from tests.company import OtherArm

A = (30.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-30.0, 30.0, -30.0, 0.0, 0.0, 0.0)


@pytest.fixture
def ready(rig):
    rig.ready()
    rig.heard()
    return rig


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
    rig, controller = ready, ready.controller
    other_host.say(frame)
    rig.run(0.2)

    refusal = controller.operating_state.cannot_move
    assert refusal.reason == OTHER_HOST
    assert refusal.params["frames"] == name
    assert "other_host_moves" in rig.codes()
    assert controller.motion.jog(6, 1.0).reason == OTHER_HOST
    rig.run(1.7)
    assert controller.operating_state.cannot_move is not None
    rig.run(0.5)
    assert controller.operating_state.other_host is None
    assert "other_host_gone" in rig.codes()


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
    rig = ready
    other_host.say(frame)
    rig.run(0.1)

    assert rig.controller.operating_state.cannot_move is None


def test_a_stream_is_said_with_its_frames_its_beginning_and_its_rate(ready, other_host):
    rig, controller = ready, ready.controller
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    rig.run(1.0)

    other = controller.operating_state.other_host
    assert other.frames == "0x151, 0x155, 0x156, 0x157"
    assert other.rate_hz == pytest.approx(200, abs=20)
    assert controller.operating_state.mover is Mover.OTHER_HOST
    step = controller.recovery.step
    assert step.kind is StepKind.OTHER_HOST
    assert step.params["frames"] == other.frames
    stream.end()


def test_against_a_stream_only_the_stop_wins(ready, other_host):
    rig, controller = ready, ready.controller
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    rig.run(0.5)
    assert controller.take_over().reason == OTHER_HOST_STREAMS
    controller.emergency_stop()
    rig.run(0.3)

    assert rig.firmware.condition.stopped
    stream.end()


def test_it_is_taken_over_half_a_second_after_its_last_frame(ready, other_host):
    rig, controller = ready, ready.controller
    other_host.move_to(A, 10)
    rig.run(0.4)
    assert controller.take_over() is not None
    rig.run(0.2)
    step = controller.recovery.step
    assert (step.action, step.held) == (Action.TAKE_OVER, True)
    assert controller.recovery.act(step) is None
    rig.step()

    assert controller.operating_state.cannot_move is None
    accepted(controller.motion.send_joints(B))
    rig.run(8.0)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(B, abs=0.05)


def test_it_goes_on_until_the_arm_rests(ready, other_host):
    rig, controller = ready, ready.controller
    other_host.move_to((100.0, *A[1:]), 10)
    rig.run(3.0)

    assert rig.firmware.mechanics.moving
    assert controller.operating_state.cannot_move.reason == OTHER_HOST
    rig.run(8.0)
    assert controller.operating_state.cannot_move is None


def test_a_run_cut_off_by_another_host_leaves_its_motion_alone(ready, other_host):
    rig, controller = ready, ready.controller
    points = [Waypoint(MoveMode.MOVE_J, A), Waypoint(MoveMode.MOVE_J, B)]
    accepted(controller.player.start(Run("r", points, [3.0, 3.0])))
    rig.run(0.5)
    rig.heard()
    other_host.move_to((60.0, *A[1:]), 50)
    rig.run(4.0)

    assert controller.player.progress.phase is RunPhase.FAILED
    assert controller.player.progress.refusal.reason == OTHER_HOST
    assert rig.firmware.mechanics.positions_deg == pytest.approx((60.0, *A[1:]), abs=0.05)
    assert not [frame for frame in rig.heard() if frame.arbitration_id == 0x150]


def test_a_jog_ends_and_sends_nothing_more(ready, other_host):
    rig, controller = ready, ready.controller
    accepted(controller.jogging.start(JointJog(6, 1)))
    rig.run(0.5)
    other_host.move_to(B, 30)
    rig.run(0.1)
    assert not controller.jogging.active
    rig.heard()
    rig.run(3.0)

    assert rig.firmware.mechanics.positions_deg == pytest.approx(B, abs=0.05)
    assert rig.heard() == []


def test_another_hosts_resume_is_told(ready, other_host):
    rig, controller = ready, ready.controller
    controller.emergency_stop()
    rig.run(0.5)
    other_host.resume()
    rig.run(0.2)

    assert "other_host_moves" in rig.codes()


def test_enabling_waits_while_another_host_streams_targets(ready, other_host):
    rig, controller = ready, ready.controller
    controller.motors.disable()
    rig.run(1.0)
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    rig.run(0.3)

    assert controller.motors.enable().reason == OTHER_HOST
    stream.end()


@pytest.mark.parametrize("act", ["enable", "clear_error", "move"])
def test_the_gripper_gives_way_to_another_hosts_command(ready, other_host, act):
    """It shows no effect, so ours would be repeated after 0.5 s, over the other's target."""
    rig, gripper = ready, ready.controller.gripper
    rig.firmware.gripper.fail(GripperFault.OVERCURRENT)
    rig.firmware.gripper.command = lambda _signals, **_more: None
    rig.run(0.1)
    figures = {"enable": (1.0,), "clear_error": (), "move": (30.0, 1.0)}
    started = accepted(getattr(gripper, act)(*figures[act]))
    rig.run(0.1)
    assert len([each for each in rig.heard() if each.arbitration_id == 0x159]) == 1
    # 20 mm = 20000 = 4E20; 1 N·m = 1000 = 03E8; byte 6: enable
    other_host.say("159#00004E2003E80100")
    rig.run(2.0)

    said = [each.data.hex() for each in rig.heard() if each.arbitration_id == 0x159]
    assert said == ["00004e2003e80100"]
    assert started.ending is Ending.CUT_OFF
    assert not {"gripper_act_failed", "gripper_not_there"} & set(rig.codes())


def test_a_leader_arm_is_called_one(ready):
    rig, controller = ready, ready.controller
    leader = OtherArm.leader(rig)
    rig.run(1.0)

    assert controller.operating_state.cannot_move.reason == LEADER_ARM
    assert controller.operating_state.mover is Mover.LEADER
    assert controller.recovery.step.kind is StepKind.LEADER_ARM
    leader.close()


@pytest.mark.parametrize(("interface", "echo"), [("socketcan", False), ("gs_usb", True)])
def test_a_program_of_the_same_pc_is_no_echo_on_socketcan(interface, echo):
    """python-can makes is_rx false of every frame sent from this computer there."""
    message = can.Message(arbitration_id=0x155, is_rx=False)

    assert is_own_echo(message, interface) is echo
    assert not is_own_echo(can.Message(arbitration_id=0x155), interface)
