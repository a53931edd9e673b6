"""The fuzz itself: a short run holds, and each invariant sees the fault it is there for.

The long run is a command of its own: ``python -m tests.safety.fuzz --seeds 200 --actions 100``, a
tenth of whose actions have a function fail that runs during a motion.
"""

import sys
import time
from functools import wraps

import numpy as np
import pytest

from armui.bus.frame_processor import FrameProcessor
from armui.control.arm_controller import ArmController
from armui.control.authority import Authority
from armui.control.authority_watch import AuthorityWatch
from armui.control.motion.cartesian import Cartesian
from armui.control.motion.joint_motion import Motion
from armui.control.motion.target_stream import TargetJog
from armui.control.motion_end import MotionEnd
from armui.control.safety.interlocks import STOPPED
from armui.control.safety.other_command import OtherCommand
from armui.interface.interface import Interface
from armui.interface.lease import Lessor
from armui.kinematics.axes import JogFrame
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.ways.rules import AreaRule
from tests.safety.fuzz.actors import Actors
from tests.safety.fuzz.breakage import Breakage, InjectedError
from tests.safety.fuzz.runner import Failure, run, shrink
from tests.safety.fuzz.script import Action, script
from tests.safety.fuzz.traffic import Sender, Traffic

A = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
B = (-30.0, 60.0, -60.0, 0.0, 0.0, 0.0)


def promise(actions: list[Action], generation: Generation = Generation.TWO) -> str | None:
    failure = run(actions, generation)
    return None if failure is None else failure.violation.promise


@pytest.mark.parametrize("seed", [3, 4])
def test_random_actions_with_company_break_no_promise(qapp, seed):
    failure = run(script(seed, 50), Generation(1 + seed % 2))
    assert failure is None, f"python -m tests.safety.fuzz --seed {seed} --actions 50: {failure}"


def test_the_same_seed_does_the_same(qapp):
    assert script(7, 50) == script(7, 50)
    assert script(7, 50) != script(8, 50)


def test_a_failure_is_narrowed_down_to_what_it_takes(qapp, monkeypatch):
    monkeypatch.setattr(ArmController, "emergency_stop", lambda _: None)
    actions = [Action("light", (1,)), Action("speed", (30,)), Action("stop"), Action("record")]
    actions += [Action("light", (2,), 0.4)]
    failure = run(actions, Generation.TWO)
    assert failure is not None
    kept, shorter = shrink(actions, failure, Generation.TWO)
    assert 2 in kept
    assert len(kept) <= 2
    assert shorter.violation.key == failure.violation.key


# Planted faults ------------------------------------------------------------------------------


def test_a_stop_that_is_not_sent_is_seen(qapp, monkeypatch):
    actions = [Action("send_joints", (A,), 0.4), Action("stop", wait_s=0.6)]
    assert promise(actions) is None
    monkeypatch.setattr(ArmController, "emergency_stop", lambda _: None)
    assert promise(actions) == "S2–S5"


def test_a_stop_that_cannot_arrive_is_excepted_until_it_can(qapp, monkeypatch):
    actions = [Action("silence", ((0x2A8,),)), Action("unplug"), Action("stop", wait_s=1.2)]
    monkeypatch.setattr(ArmController, "emergency_stop", lambda _: None)
    assert promise(actions) is None
    assert promise([*actions, Action("plug_in", wait_s=1.2)]) == "S2–S5"


def test_a_step_along_the_axes_of_another_frame_is_seen(qapp, monkeypatch):
    actions = [
        Action("user_frame", ((0.0, 0.0, 0.0, 0.0, 0.0, 90.0),)),
        Action("send_joints", (A,), 4.0),
        Action("tool_step", (0, 5.0, "user"), 0.4),
    ]
    assert promise(actions) is None
    step = Cartesian.step

    @wraps(step)
    def along_base(self, axis, amount, _frame):
        return step(self, axis, amount, JogFrame.BASE)

    monkeypatch.setattr(Cartesian, "step", along_base)
    assert promise(actions) == "S7–S11"


def test_a_step_from_an_outdated_target_is_seen(qapp, monkeypatch):
    actions = [
        Action("send_joints", (A,), 1.2),
        Action("other_target", (B, 100), 1.2),
        Action("step", (6, 1.0), 0.4),
    ]
    actions.insert(2, Action("hang", (2.0,), 0.4))  # the other host is gone for over two seconds
    assert promise(actions) is None
    monkeypatch.setattr(Authority, "joint_base_deg", lambda _: A)
    assert promise(actions) == "S7–S11"


def test_a_motion_nobody_asked_for_is_seen(qapp, monkeypatch):
    assert promise([Action("speed", (30,), 0.6)]) is None
    began_s = []

    def restless(motion):
        now_s = motion._context.clock()
        began_s.append(now_s)
        if now_s > began_s[0] + 0.4:
            motion.send_joints(A)

    monkeypatch.setattr(Motion, "follow_arm", restless)
    assert promise([Action("speed", (30,), 0.6)]) == "S7–S11"


def test_a_target_that_comes_back_after_its_cancel_is_seen(qapp, monkeypatch):
    set_speed = Motion.set_speed_percent
    actions = [
        Action("send_joints", (A,), 0.2),
        Action("plan", (6,), 1.2),
        Action("speed", (5,), 0.4),
    ]
    assert promise(actions) is None

    @wraps(set_speed)
    def reviving(motion, percent):
        motion.send_joints(A)
        return set_speed(motion, percent)

    monkeypatch.setattr(Motion, "set_speed_percent", reviving)
    assert promise(actions) == "S7–S11"


def test_our_motion_beside_another_host_s_is_seen(qapp, monkeypatch):
    actions = [Action("other_target", (B, 30), 0.2), Action("send_joints", (A,), 1.2)]
    assert promise(actions) is None
    monkeypatch.setattr(OtherCommand, "why_not", lambda _: None)
    assert promise(actions) == "S13"


def test_moving_by_old_feedback_is_seen(qapp, monkeypatch):
    actions = [Action("silence", ((0x2A5, 0x2A6, 0x2A7),), 1.2)]
    assert promise(actions) is None
    monkeypatch.setattr(Authority, "why_silent", lambda _: None)
    assert promise(actions) == "S9"


def test_an_exception_is_seen_in_a_part_and_in_a_click(qapp, monkeypatch):
    def broken(*_args):
        raise ZeroDivisionError

    with monkeypatch.context() as patch:
        patch.setattr(Actors, "light", lambda *_: patch.setattr(Motion, "follow_arm", broken))
        assert promise([Action("light", (1,), 0.1)]) == "exception"
    monkeypatch.setattr(Motion, "go_home", broken)
    assert promise([Action("go_home")]) == "exception"


def test_what_is_refused_is_no_fault(qapp, monkeypatch):
    monkeypatch.setattr(Motion, "go_home", lambda _: STOPPED())
    assert promise([Action("go_home", wait_s=0.4)]) is None


def test_a_failure_says_what_was_seen(qapp, monkeypatch):
    monkeypatch.setattr(OtherCommand, "why_not", lambda _: None)
    actions = [Action("other_target", (B, 30), 0.2), Action("send_joints", (A,), 1.2)]
    failure = run(actions, Generation.TWO)
    assert isinstance(failure, Failure)
    assert failure.index == 1
    assert "after a motion frame of another host" in failure.violation.text


def test_a_motion_that_goes_on_after_a_failure_is_seen(qapp, monkeypatch):
    advance, fails = AuthorityWatch.follow_arm, [False]

    def failing(watch, now_s):
        if fails[0]:
            raise InjectedError
        advance(watch, now_s)

    def send_then_fail(actors, joints_deg):
        send_joints(actors, joints_deg)
        fails[0] = True

    send_joints = Actors.send_joints
    monkeypatch.setattr(AuthorityWatch, "follow_arm", failing)
    monkeypatch.setattr(Actors, "send_joints", send_then_fail)
    actions = [Action("speed", (5,), 0.2), Action("send_joints", (A,), 2.0)]
    assert promise(actions) is None
    fails[0] = False
    monkeypatch.setattr(MotionEnd, "end_motion", lambda *_args, **_more: None)
    assert promise(actions) == "S23"


def test_a_frame_that_costs_more_than_itself_is_seen(qapp, monkeypatch):
    actions = [Action("strange_frame", ("7F1#FF00000000000000", 1, 0.1), 0.1)]
    assert promise(actions) is None
    process = FrameProcessor.process

    def careless(processor, frame, at_s, flags):
        if frame.arbitration_id == 0x7F1:
            raise IndexError
        process(processor, frame, at_s, flags)

    monkeypatch.setattr(FrameProcessor, "process", careless)
    assert promise(actions) == "exception"


def test_what_was_heard_of_the_arm_before_is_seen_after_an_exchange(qapp, monkeypatch):
    actions = [Action("exchange", (False, "S-V1.8-2", A, 20, 2.0), 2.5)]
    assert promise(actions) is None
    use_codec = FrameProcessor.use_codec
    monkeypatch.setattr(
        FrameProcessor,
        "use_codec",
        lambda processor, codec, forget=True: use_codec(processor, codec, forget=False),
    )
    assert promise(actions) == "S15"


def test_a_motion_into_a_zone_is_seen(qapp, monkeypatch):
    flange = Firmware(Generation.TWO).kinematics.forward(A)
    box = (tuple(flange[:3]), (60.0, 60.0, 60.0))
    actions = [
        Action("send_joints", (B,), 3.0),
        Action("zone", box, 0.1),
        Action("send_joints", (A,), 3.0),
    ]
    assert promise(actions) is None
    monkeypatch.setattr(AreaRule, "breach", lambda *_: None)
    monkeypatch.setattr(AreaRule, "outside", lambda rule, poses: np.full((len(poses), 1), -100.0))
    assert promise(actions) == "S32"


def test_a_press_that_holds_the_window_is_seen(qapp, monkeypatch):
    actions = [Action("step", (1, 1.0), 0.5)] * 5
    assert promise(actions) is None
    step = Actors.step

    def busy(actors, joint, delta_deg):
        until_s = time.thread_time() + 0.06
        while time.thread_time() < until_s:
            pass
        step(actors, joint, delta_deg)

    monkeypatch.setattr(Actors, "step", busy)
    assert promise(actions) == "S2"


# A client of the local interface ---------------------------------------------------------------

here_only = pytest.mark.skipif(sys.platform != "linux", reason="the interface is not offered there")
FAR_STREAM = (60.0, 40.0, -40.0, 10.0, 20.0, 15.0), 0.0, 50.0


@here_only
@pytest.mark.parametrize(
    "end",
    ["operator_takes_back", "client_dies", "client_releases", "interface_on", "client_is_silent"],
)
def test_a_stream_that_outlives_its_lease_is_seen(qapp, monkeypatch, end):
    figures = (False,) if end == "interface_on" else ()
    actions = [Action("client_comes_streaming", (100, *FAR_STREAM), 0.5), Action(end, figures, 2.0)]
    assert promise(actions) is None
    if end == "client_is_silent":
        monkeypatch.setattr(Lessor, "why_over", lambda *_: None)
        actions[0] = Action("client_comes_sending", (5, A), 0.5)
        assert promise(actions) == "S29"
        return
    end_stream = Interface._end_stream
    streams = TargetJog("fuzz.py", FAR_STREAM[0])

    def late(interface):
        end_stream(interface)
        interface._controller.jogging.start(streams)

    monkeypatch.setattr(Interface, "_end_stream", late)
    assert promise([actions[0], actions[1]]) in {"S7–S11", "S29"}


@here_only
def test_a_client_faster_than_granted_is_seen(qapp, monkeypatch):
    actions = [Action("client_comes_sending", (5, A), 2.0)]
    assert promise(actions) is None
    monkeypatch.setattr(Interface, "_cap_speed", lambda *_: None)
    assert promise([Action("speed", (100,)), *actions]) == "S29"


@here_only
def test_the_end_of_a_lease_that_takes_the_power_is_seen(qapp, monkeypatch):
    actions = [
        Action("client_comes_sending", (30, A), 0.5),
        Action("operator_takes_back", (), 1.0),
    ]
    assert promise(actions) is None
    monkeypatch.setattr(
        *(ArmController, "end_motion_of"),
        lambda controller, _, **_how: controller.motors.disable(7),
    )
    assert promise(actions) == "S29"


@here_only
def test_an_operator_who_moves_beside_a_lease_is_seen(qapp, monkeypatch):
    actions = [Action("client_gets_the_arm", (30,)), Action("step", (6, 5.0), 0.5)]
    assert promise(actions) is None
    monkeypatch.setattr(Interface, "_on_begun", lambda *_: None)
    assert promise(actions) == "S29"


def test_what_fails_is_one_of_what_runs_and_the_same_each_time(qapp):
    first, second, other = (Breakage(share, 2) for share in (0.5, 0.5, 0.9))
    for each in (first, second, other):
        each.during(lambda: Codec(Generation.TWO).decode(Frame(0x2A1, bytes(8))))
        each.choose()
    assert first.chosen == second.chosen != other.chosen
    assert first.chosen.startswith("armui.protocol.")
    for _ in range(2):
        with pytest.raises(InjectedError):
            first.during(lambda: Codec(Generation.TWO).decode(Frame(0x2A1, bytes(8))))
    first.during(lambda: Codec(Generation.TWO).decode(Frame(0x2A1, bytes(8))))
    assert first.left == 0


# Who said what ----------------------------------------------------------------------------------


def test_a_lost_frame_is_not_taken_for_the_equal_one_after_it():
    firmware = Firmware(Generation.TWO)
    traffic = Traffic(firmware, lambda: 0.0)
    lost, between = Frame(0x151, bytes([1, 1, 30, 0, 0, 0, 0, 0])), Frame(0x121, bytes(8))
    traffic.note(Sender.US, lost)
    traffic.note(Sender.OTHER, between)
    traffic.note(Sender.OTHER, lost)
    assert traffic._sender_of(between).sender is Sender.OTHER
    assert traffic._sender_of(lost).sender is Sender.OTHER
    assert traffic._sender_of(lost).sender is Sender.NOBODY
