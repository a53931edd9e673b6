"""S13, S25: a frame that the operator sends by hand counts as another host's."""

from dataclasses import replace

import pytest

from armui.control.link.bus_access import FRAME_NOT_HELD
from armui.control.link.link_state import LISTEN_ONLY, NOT_CONNECTED, OFFLINE
from armui.control.motion.jog_path import JointJog
from armui.control.motion.motion_command import End, Mover
from armui.control.run.progress import Run, RunPhase
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.interlocks import STOP_REQUESTED, STOPPED
from armui.control.safety.other_command import OTHER_HOST, OTHER_HOST_STREAMS, OTHER_MODE
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint
from tests.accepted import accepted
from tests.sim.talk import DISABLE, frame, mode, target

A = (30.0, 30.0, -30.0, 0.0, 0.0, 0.0)
B = (-30.0, 30.0, -30.0, 0.0, 0.0, 0.0)
MIT = "151#010600AD00000000"
QUESTION = "472#0101000000000000"


@pytest.fixture
def ready(rig):
    rig.ready()
    rig.heard()
    return rig


def send(rig, *lines, held=True):
    refusals = [rig.controller.bus.send(frame(line), held=held) for line in lines]
    return [None if refusal is None else refusal.code for refusal in refusals]


def said(rig):
    return [f"{each.arbitration_id:03X}#{each.data.hex().upper()}" for each in rig.heard()]


def move_by_hand(rig, joints_deg, percent=30):
    lines = (*target(*joints_deg), mode(percent))
    assert send(rig, *lines) == [None] * 4
    return list(lines)


def test_the_arm_obeys_and_our_own_motion_waits(ready):
    rig, controller = ready, ready.controller
    lines = move_by_hand(rig, A)
    rig.run(0.3)

    assert said(rig) == lines
    assert controller.operating_state.mover is Mover.OTHER_HOST
    assert controller.operating_state.cannot_move.reason == OTHER_HOST
    assert controller.motion.jog(6, 1.0).reason == OTHER_HOST
    rig.run(8.0)
    assert rig.firmware.mechanics.positions_deg == pytest.approx(A, abs=0.05)
    assert controller.operating_state.cannot_move is None


def test_it_is_noted_frame_by_frame(ready):
    rig = ready
    move_by_hand(rig, A)

    told = [e.params["frame"] for e in rig.events if e.code == "frame_sent_by_hand"]
    assert told[-1] == "0x151 [8] 01 01 1E 00 00 00 00 00"
    assert len(told) == 4


def test_our_command_ends_before_the_frame_leaves(ready):
    rig, controller = ready, ready.controller
    accepted(controller.motion.send_joints(A))
    rig.run(0.5)
    assert controller._authority.command is not None
    send(rig, mode(10))

    assert controller._authority.command is None
    assert controller._authority.ended is End.OTHER_HOST
    # a step does not start from the target that was ours
    assert controller.motion.jog(6, 1.0).reason == OTHER_HOST


def test_what_waits_of_ours_is_dropped(ready):
    rig, controller = ready, ready.controller
    with controller._connection._worker._outbox._port.driver:
        accepted(controller.motion.send_joints(A))
        assert send(rig, mode(10)) == [None]
    rig.run(0.1)

    assert said(rig) == [mode(10)]


def test_a_run_ends_and_cuts_nothing_off(ready):
    rig, controller = ready, ready.controller
    points = [Waypoint(MoveMode.MOVE_J, A), Waypoint(MoveMode.MOVE_J, B)]
    accepted(controller.player.start(Run("r", points, [3.0, 3.0])))
    rig.run(0.5)
    rig.heard()
    move_by_hand(rig, (60.0, *A[1:]), 50)
    rig.run(5.0)

    assert controller.player.progress.phase is RunPhase.FAILED
    assert controller.player.progress.refusal.reason == OTHER_HOST
    assert rig.firmware.mechanics.positions_deg == pytest.approx((60.0, *A[1:]), abs=0.05)
    assert not [each for each in rig.heard() if each.arbitration_id == 0x150]


def test_a_jog_ends(ready):
    rig, controller = ready, ready.controller
    accepted(controller.jogging.start(JointJog(6, 1)))
    rig.run(0.3)
    move_by_hand(rig, A)
    rig.step()

    assert not controller.jogging.active


def test_the_operator_may_take_the_arm_back(ready):
    rig, controller = ready, ready.controller
    move_by_hand(rig, A, 10)
    rig.run(0.3)
    assert controller.take_over().reason == OTHER_HOST_STREAMS
    rig.run(0.4)
    assert controller.take_over() is None
    rig.step()
    assert controller.operating_state.cannot_move is None


def test_questions_and_lamps_change_nothing(ready):
    rig, controller = ready, ready.controller
    accepted(controller.motion.send_joints(A))
    rig.run(0.3)
    assert send(rig, QUESTION, "121#0101FF10101000" + "00", held=False) == [None, None]

    assert controller._authority.command is not None
    assert controller.operating_state.other_host is None


@pytest.mark.parametrize(
    "line", [mode(10), *target(*A), DISABLE, "475#0100000000000000", "300#00", "470#FC00000000"]
)
def test_what_acts_needs_the_held_press(ready, line):
    rig = ready
    assert send(rig, line, held=False) == [FRAME_NOT_HELD.id]
    rig.run(0.1)
    assert said(rig) == []
    assert rig.codes()[-1] == "refused"


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("2A1#0000000000000000", "frame_is_the_arms"),
        ("2C5#0000000000000000", "frame_is_the_arms"),
        ("251#0000000000000000", "frame_is_the_arms"),
        ("476#5000000000000000", "frame_is_the_arms"),
        ("4A5#00", "frame_of_upgrade"),
        ("0B1#00", "frame_of_upgrade"),
        ("150#0200000000000000", "frame_resumes"),
        ("160#0200000000000000", "frame_resumes"),
        ("170#02", "frame_resumes"),
    ],
)
def test_what_is_never_sent(ready, line, code):
    rig = ready
    ear = can_ear(rig)
    assert send(rig, line) == [code]
    rig.run(0.1)
    assert int(line[:3], 16) not in ear()


def can_ear(rig):
    """The identifiers of all frames the arm gets."""
    got = []
    on_frame = rig.firmware.on_frame

    def hear(each):
        got.append(each.arbitration_id)
        return on_frame(each)

    rig.firmware.on_frame = hear
    return lambda: got


def test_a_connection_that_only_listens_sends_none(rig):
    rig.controller.connect_device(replace(rig.device, listen_only=True))
    rig.run(1.0)
    rig.heard()

    assert send(rig, QUESTION, mode(10), DISABLE) == [LISTEN_ONLY.id] * 3
    rig.run(0.2)
    assert said(rig) == []


def test_without_a_device_there_is_nobody_to_send_to(rig):
    assert send(rig, QUESTION) == [NOT_CONNECTED.id]


def test_a_silent_arm_is_asked_but_not_moved(ready):
    rig = ready
    rig.powered = False
    rig.run(1.0)
    rig.heard()

    assert send(rig, mode(10)) == [OFFLINE.id]
    assert send(rig, QUESTION, DISABLE) == [None, None]


def test_an_arm_whose_angles_are_silent_is_not_moved(ready):
    rig = ready
    silence(rig, 0x2A6)
    rig.run(1.0)

    assert send(rig, mode(10)) == [FEEDBACK_SILENT.id]


def silence(rig, arbitration_id):
    step = rig.firmware.step
    rig.firmware.step = lambda dt_s: [
        each for each in step(dt_s) if each.arbitration_id != arbitration_id
    ]


def test_while_a_stop_is_not_confirmed_nothing_is_sent(ready):
    rig, controller = ready, ready.controller
    rig.powered = False
    controller.emergency_stop()
    rig.heard()

    assert send(rig, QUESTION, mode(10)) == [STOP_REQUESTED.id] * 2


def test_a_stopped_arm_is_not_moved(ready):
    rig, controller = ready, ready.controller
    controller.emergency_stop()
    rig.run(0.5)
    rig.heard()

    assert send(rig, mode(10), "471#0702000000000000") == [STOPPED.id] * 2
    assert said(rig) == []


def test_the_stop_passes_a_frame_that_waits(ready):
    rig, controller = ready, ready.controller
    with controller._connection._worker._outbox._port.driver:
        assert send(rig, mode(10)) == [None]
        controller.emergency_stop()
    rig.run(0.5)

    assert rig.firmware.condition.stopped
    assert mode(10) not in said(rig)


def test_no_motion_of_another_host_is_interfered_with(ready, other_host):
    rig = ready
    stream = other_host.stream_targets(lambda _t_s: A, rate_hz=200, speed_percent=30)
    rig.run(0.5)
    rig.heard()

    assert send(rig, mode(10), "159#0000000000000100") == [OTHER_HOST.id] * 2
    # a question is answered, and what ends motion is never refused
    assert send(rig, QUESTION, "150#0006000000000000") == [None, None]
    stream.end()


def test_a_setting_waits_for_the_end_of_a_run(ready):
    rig, controller = ready, ready.controller
    points = [Waypoint(MoveMode.MOVE_J, A), Waypoint(MoveMode.MOVE_J, B)]
    accepted(controller.player.start(Run("r", points, [3.0, 3.0])))
    rig.run(0.5)

    assert send(rig, "475#01AE000000000000", "422#0100000000000000") == ["run_under_way"] * 2
    assert controller.player.running


def test_no_mode_word_lets_an_arm_fall_that_another_host_drives(ready, other_host):
    rig = ready
    other_host.say(MIT)
    rig.run(3.0)
    rig.heard()

    assert send(rig, mode(10), MIT) == ["other_mode"] * 2
    assert said(rig) == []


def test_a_mode_that_leaves_the_joints_limp_is_another_hosts_from_then_on(ready):
    """S25: after it nothing of this program sends a mode word, a second one by hand neither."""
    rig, controller = ready, ready.controller
    assert send(rig, MIT) == [None]
    rig.run(3.0)
    rig.heard()

    assert controller.recovery.step.kind is StepKind.OTHER_MODE
    assert controller.motion.jog(6, 1.0).reason == OTHER_MODE
    assert send(rig, mode(10)) == [OTHER_MODE.id]
    rig.run(0.5)
    assert said(rig) == []


def test_another_connection_begins_without_what_was_sent_before(ready):
    rig, controller = ready, ready.controller
    send(rig, MIT)
    rig.run(0.2)
    controller.disconnect_device()
    rig.firmware.switch_off()
    rig.firmware.switch_on()
    rig.controller.connect_device(rig.device)

    assert controller._connection.traffic.series == {}
