"""The client that others use, against the interface of a simulated arm: `armui-client`."""

import inspect
import itertools
import os
import signal
import subprocess
import sys
import threading
import time
from importlib import util
from pathlib import Path

import pytest

import armui_client
from armui.interface import lease as leases
from armui.interface.methods import METHODS
from armui.interface.state_report import FIELDS
from armui.kinematics.poses import Pose
from armui.system import paths

HERE = Path(armui_client.__file__).parents[1]
THERE = (10.0, 20.0, -30.0, 0.0, 10.0, 0.0)
FAR = (120.0, 20.0, -30.0, 0.0, 10.0, 0.0)
READY = (0.0, 60.0, -60.0, 0.0, 30.0, 0.0)


def joints(script):
    return pytest.approx(script.rig.firmware.joints_deg, abs=0.3)


# What is measured -----------------------------------------------------------------------------


def test_the_state_is_typed_and_has_ages(with_arm, script):
    state = with_arm(lambda arm: arm.state())
    assert state.joints_deg.get() == joints(script)
    assert state.joints_deg.fresh
    assert 0.0 <= state.joints_deg.age_s <= 0.5
    assert state.enabled.value == (True,) * 6
    assert isinstance(state.status.value, armui_client.Status)
    assert state.status.value.joints_beyond_limits == ()
    assert state.sequence > 0
    assert {*inspect.signature(armui_client.State).parameters} == {"sequence", *FIELDS}


def test_what_was_not_asked_for_or_is_old_is_no_value(with_arm, script):
    def read(arm):
        few = arm.state(["joints_deg"])
        with pytest.raises(armui_client.Stale):
            few.supply_v.get()
        with pytest.raises(armui_client.Stale, match="wanted: at most 0 s"):
            armui_client.Measured(1.0, age_s=0.1, fresh=True).get(max_age_s=0.0)
        return few

    assert with_arm(read).supply_v == armui_client.Measured()


def test_whether_it_is_enabled_is_waited_for(with_arm, script):
    assert with_arm(lambda arm: arm.is_enabled())
    script.rig.powered = False
    script.rig.run(1.5)
    with pytest.raises(armui_client.Timeout, match="whether its motors are on"):
        with_arm(lambda arm: arm.is_enabled(timeout_s=0.2))
    script.meanwhile = lambda: setattr(script.rig, "powered", True)
    assert with_arm(lambda arm: arm.is_enabled())


def test_an_unknown_field_is_invalid(with_arm):
    with pytest.raises(armui_client.Invalid, match="is called “angles”"):
        with_arm(lambda arm: arm.state(["angles"]))


def test_states_are_yielded_until_the_loop_is_left(with_arm):
    def read(arm):
        seen = list(itertools.islice(arm.subscribe(rate_hz=100, fields=["joints_deg"]), 5))
        assert arm._connection.heard.gone is None
        return seen

    states = with_arm(read)
    assert len(states) == 5
    assert all(each.joints_deg.value is not None for each in states)


def test_events_are_yielded(with_arm):
    def read(arm):
        events = arm.events(timeout_s=10.0)
        with arm.lease("events"):
            return [next(events).id, next(events).id]

    assert with_arm(read) == ["lease_asked", "lease_granted"]


def test_no_event_is_a_timeout(with_arm):
    with pytest.raises(armui_client.Timeout, match="No event came within"):
        with_arm(lambda arm: next(arm.events(timeout_s=0.05)))


def test_kinematics_there_and_back(with_arm):
    def ask(arm):
        pose = arm.fk(READY)
        return pose, arm.ik(pose, near_deg=READY), arm.ik(pose), arm.ik((5e3, 0, 0, 0, 0, 0))

    pose, near, _, none = with_arm(ask)
    assert len(pose) == len(Pose(*pose)) == 6
    assert near[0] == pytest.approx(READY, abs=0.01)
    assert none == []


def test_operations_are_listed_with_what_speaks_against_them(with_arm):
    offered = {each.id: each for each in with_arm(lambda arm: arm.operations())}
    assert offered["motion.send"].moves
    assert not offered["motion.send"].asks_the_operator
    assert offered["motion.send"].why_not is None
    assert offered["motors.enable"].asks_the_operator
    assert offered["motors.resume"].why_not


# Moving ---------------------------------------------------------------------------------------


def start(arm):
    arm.move_joints(READY)
    return arm.fk(READY)


def by(pose, index, amount):
    return [value + amount * (place == index) for place, value in enumerate(pose)]


def move_pose(arm):
    arm.move_pose(by(start(arm), 2, 20.0))


def move_line(arm):
    arm.move_line(by(start(arm), 2, -20.0))


def arc(arm):
    pose = start(arm)
    arm.arc(pose, by(by(pose, 1, 20.0), 2, 20.0), by(pose, 1, 40.0))


def step_tool(arm):
    start(arm)
    arm.step_tool(2, 15.0)


def stream(arm):
    with arm.stream() as targets:
        assert targets.hold((3.0, *READY[1:5], 0.0), 2.0) is None


def gripper(arm):
    arm.gripper(40.0, torque_nm=1.5)
    with pytest.raises(armui_client.Invalid, match="use gripper"):
        arm.gripper_angle(10.0)


MOVES = {
    "arc": (arc, lambda rig: rig.controller.state.pose[1].value == pytest.approx(40.0, abs=1.5)),
    "gripper": (gripper, lambda rig: rig.controller.state.gripper.value.opening_mm > 39.0),
    "home": (lambda arm: arm.home(), lambda rig: max(map(abs, rig.firmware.joints_deg)) < 0.1),
    "move_joints": (
        lambda arm: arm.move_joints(THERE),
        lambda rig: rig.firmware.joints_deg == pytest.approx(THERE, abs=0.1),
    ),
    "move_line": (move_line, None),
    "move_pose": (move_pose, None),
    "step_joint": (
        lambda arm: arm.step_joint(2, 7.5),
        lambda rig: rig.firmware.joints_deg[1] == pytest.approx(7.5, abs=0.1),
    ),
    "step_tool": (step_tool, None),
    "stream": (stream, lambda rig: rig.firmware.joints_deg[0] == pytest.approx(3.0, abs=0.2)),
    "set_speed": (
        lambda arm: arm.set_speed(40),
        lambda rig: rig.controller.motion.speed_percent == 40,
    ),
    "lamp": (lambda arm: arm.lamp(2, 255, 0, 0), lambda rig: "sent_lamps" in rig.codes()),
    "enable": (lambda arm: arm.enable(), lambda rig: "consent_granted" in rig.codes()),
    "disable": (
        lambda arm: arm.disable(3),
        lambda rig: rig.controller.operating_state.enabled[2] is False,
    ),
}
RISE_MM = {"move_line": -20.0, "move_pose": 20.0, "step_tool": 15.0}
ELSEWHERE = {
    "begin_episode", "call", "check", "close", "discard_episode", "end_episode", "end_motion",
    "events", "fk", "go_on", "gripper_angle", "halt", "ik", "is_connected", "is_enabled", "lease",
    "operations", "pause", "plan", "run", "state", "stop", "subscribe", "trajectories",
    "trajectory",
}  # fmt: skip
"""Methods that other tests call."""


@pytest.mark.parametrize("name", MOVES)
def test_each_motion_is_waited_for(name, with_lease, with_arm, script):
    act, is_so = MOVES[name]
    with_lease(act)
    script.rig.run(0.1)
    if is_so is None:
        height = script.rig.controller.state.pose[2].value
        rise = height - with_arm(lambda arm: arm.fk(READY))[2]
        assert rise == pytest.approx(RISE_MM[name], abs=1.5)
    else:
        assert is_so(script.rig)


def test_no_public_method_is_left_out_here():
    public = {name for name in vars(armui_client.Arm) if not name.startswith("_")}
    assert public == {*MOVES, *ELSEWHERE}


def test_any_operation_and_method_by_its_id(with_lease, script):
    def ask(arm):
        done = arm.call("motion.step", joint=1, delta_deg=4)
        pose = arm.call("kinematics.fk", joints_deg=list(READY))
        with pytest.raises(armui_client.Invalid, match="no method"):
            arm.call("jog.begin")
        with pytest.raises(armui_client.Invalid, match="missing"):
            arm.call("motion.step", joint=1)
        return done, pose

    done, pose = with_lease(ask)
    assert (done.state, done.reason, done.ended) == ("done", "arrived", True)
    assert done.text == "Target reached, as the arm reports"
    assert "flange_pose_mm_deg" in pose
    assert script.rig.firmware.joints_deg[0] == pytest.approx(4.0, abs=0.1)


def test_the_methods_that_need_no_lease_are_the_server_s(client):
    """What is asked without a lease is known on both sides."""
    without = armui_client.arm._WITHOUT_LEASE
    for name in METHODS:
        if name in {"hello", "stop", "halt", "lease.request"}:  # they do something
            assert name in without
            continue
        answer = client.answer(client.begin(name, joints_deg=list(READY)))
        reason = answer.get("error", {}).get("data", {}).get("reason")
        assert (reason == "lease_not_held") == (name not in without), name


def test_at_once_and_waited_for_later(with_lease):
    def ask(arm):
        begun = arm.move_joints(THERE, wait=False)
        assert not begun.ended
        with pytest.raises(armui_client.Timeout, match=r"motion\.send has not ended"):
            begun.wait(timeout_s=0.001)
        return begun.wait()

    assert with_lease(ask).state == "done"


def test_a_motion_ended_by_another_one_has_failed(with_lease, script):
    def ask(arm):
        first = arm.move_joints(FAR, wait=False)
        time.sleep(0.1)
        arm.move_joints(THERE)
        first.wait()

    with pytest.raises(armui_client.Failed) as found:
        with_lease(ask)
    assert found.value.state == "cut_off"
    assert found.value.reason
    assert str(found.value).startswith("Did not reach its end")


def test_that_the_lease_has_ended_may_be_told_after_the_motion_s_end(with_arm):
    def ask(arm):
        connection = arm._connection
        begun = armui_client.Operation(connection, "motion.home", 10**6, lease=10**6)
        cut_off = {"number": begun.number, "state": "cut_off"}
        ended = {"reason": "lease_stopped", "text": "Halted.", "figures": {}}
        lease = {"lease": begun.number, "state": "ended", "reason": ended}
        connection._take({"method": "operation", "params": cut_off})
        later = threading.Timer(0.05, connection._take, [{"method": "lease", "params": lease}])
        later.start()
        begun.wait()

    with pytest.raises(armui_client.LeaseLost, match="Halted"):
        with_arm(ask)


def test_arrays_and_tuples_are_six_numbers(with_lease):
    with pytest.raises(armui_client.Invalid, match="not 3"):
        with_lease(lambda arm: arm.move_joints((1, 2, 3)))


def test_what_is_not_a_number_is_sent_nobody(with_lease):
    with pytest.raises(ValueError, match="JSON"):
        with_lease(lambda arm: arm.move_joints([float("nan")] * 6))


# Refusals and the lease -----------------------------------------------------------------------


def test_a_refusal_has_its_reason_and_figures(with_lease):
    with pytest.raises(armui_client.Refused, match="limit of 150°") as found:
        with_lease(lambda arm: arm.step_joint(1, 400))
    assert found.value.reason == "step_beyond_limit"
    assert found.value.figures == {"joint": 1, "limit": 150.0}


def test_without_a_lease_it_is_refused(with_arm):
    with pytest.raises(armui_client.Refused) as found:
        with_arm(lambda arm: arm.home())
    assert found.value.reason == "lease_not_held"


def test_a_lease_that_is_given_back_can_be_taken_again(with_arm, script):
    def ask(arm):
        lease = arm.lease("one")
        with lease:
            assert lease.held
            arm.step_joint(1, 2)
        assert not lease.held
        lease.release()
        with pytest.raises(armui_client.Refused):
            arm.step_joint(1, 2)
        with arm.lease("two", max_speed_percent=20, moves=True) as second:
            arm.step_joint(1, 2)
            with pytest.raises(armui_client.Refused) as found:
                arm.set_speed(50)
        return second.max_speed_percent, found.value.reason

    script.percent = 15
    assert with_arm(ask) == (15, "lease_too_fast")
    assert script.desk.view.lease is None
    assert script.rig.firmware.joints_deg[0] == pytest.approx(4.0, abs=0.1)


def test_a_lease_without_motions_sets_and_moves_nothing(with_arm):
    def ask(arm):
        with arm.lease("lamps", moves=False):
            arm.lamp(1, 0, 255, 0)
            arm.home()

    with pytest.raises(armui_client.Refused) as found:
        with_arm(ask)
    assert found.value.reason == "lease_moves_nothing"


def test_nobody_there_is_a_refusal(with_arm, script, monkeypatch):
    monkeypatch.setattr(leases, "GRANT_WITHIN_S", 1.0)
    script.percent = None
    with pytest.raises(armui_client.Refused) as found:
        with_arm(lambda arm: arm.lease("nobody").take())
    assert found.value.reason == "lease_not_granted"


def test_a_lease_granted_too_late_is_given_back(with_arm, script):
    script.percent = None

    def ask(arm):
        with pytest.raises(armui_client.Timeout, match=r"lease\.request"):
            arm.lease("too late", timeout_s=0.05).take()
        script.percent = 100
        while "lease_ended" not in script.rig.codes():
            arm.state()
        return arm._connection.heard.lease

    assert with_arm(ask) is None
    assert script.desk.view.lease is None


def test_an_operation_that_the_operator_declines_leaves_the_lease(with_lease, script):
    script.consents = False

    def ask(arm):
        with pytest.raises(armui_client.Refused) as found:
            arm.disable()
        arm.step_joint(1, 2)
        return found.value.reason

    assert with_lease(ask) == "lease_declined"


def test_doing_nothing_keeps_the_lease(with_arm, script):
    def ask(arm):
        with arm.lease("thinking") as lease:
            script.time.sleep(5.0)
            return lease.held

    assert with_arm(ask)


@pytest.mark.parametrize(
    ("end", "reason"),
    [
        (lambda desk: desk._controller.emergency_stop(), "lease_stopped"),
        (lambda desk: desk._controller.halt_and_hold(), "lease_stopped"),
        (lambda desk: desk.take_back(), "lease_taken_back"),
        (lambda desk: desk._controller.motion.go_home(), "lease_operator_moved"),
    ],
    ids=["stop", "halt", "take back", "moves"],
)
def test_what_the_operator_does_ends_the_motion_s_wait(end, reason, with_lease, script):
    turned: list[bool] = []

    def meanwhile():
        if script.rig.firmware.joints_deg[0] > 20.0 and not turned:
            turned.append(True)
            end(script.desk)

    script.meanwhile = meanwhile

    def ask(arm):
        try:
            arm.move_joints(FAR)
        finally:
            with pytest.raises(armui_client.LeaseLost) as again:
                arm.home()
            assert again.value.reason == reason
            arm.state()  # what needs no lease goes on

    with pytest.raises(armui_client.LeaseLost) as found:
        with_lease(ask)
    assert found.value.reason == reason
    assert str(found.value)
    script.rig.run(2.0)
    assert script.rig.firmware.joints_deg[0] < 60.0


def test_a_lease_lost_while_the_operator_is_asked(with_lease, script):
    script.consents = None

    def meanwhile():
        if script.desk.view.consent is not None:
            script.desk.take_back()

    script.meanwhile = meanwhile
    with pytest.raises(armui_client.LeaseLost) as found:
        with_lease(lambda arm: arm.disable())
    assert found.value.reason == "lease_taken_back"


@pytest.mark.parametrize("name", ["stop", "halt"])
def test_another_thread_stops(name, with_lease, script):
    def ask(arm):
        def soon():
            while arm.state().joints_deg.get()[0] < 10.0:
                pass
            getattr(arm, name)()

        other = threading.Thread(target=soon)
        other.start()
        try:
            arm.move_joints(FAR)
        finally:
            other.join()

    with pytest.raises(armui_client.LeaseLost) as found:
        with_lease(ask)
    assert found.value.reason == "lease_stopped"
    script.rig.run(1.0)
    assert script.rig.firmware.joints_deg[0] < 100.0


@pytest.mark.parametrize("kind", [KeyboardInterrupt, ZeroDivisionError])
def test_an_interrupt_halts_and_gives_back(kind, with_lease, script):
    def ask(arm):
        arm.move_joints(FAR, wait=False)
        while arm.state().joints_deg.get()[0] < 10.0:
            pass
        raise kind

    with pytest.raises(kind):
        with_lease(ask)
    assert script.desk.view.lease is None
    script.rig.run(1.0)
    assert script.rig.firmware.joints_deg[0] < 100.0
    assert not script.rig.controller.operating_state.moving
    assert all(script.rig.controller.operating_state.enabled)
    ended = [event for event in script.rig.events if event.code == "lease_ended"]
    halted = "lease_stopped" if kind is KeyboardInterrupt else "lease_released"
    assert [event.params["reason"].code for event in ended] == [halted]


FAR_AWAY = """
import armui_client
with armui_client.connect("far") as arm, arm.lease("far"):
    arm.move_joints([120, 0, 0, 0, 0, 0])
"""


@pytest.mark.parametrize(
    ("number", "reason"), [(signal.SIGINT, "lease_stopped"), (signal.SIGKILL, "lease_client_gone")]
)
def test_a_script_that_is_interrupted_or_killed_leaves_a_halted_arm(number, reason, script):
    environment = {**os.environ, "PYTHONPATH": str(HERE)}
    words = [sys.executable, "-c", FAR_AWAY]
    sent: list[int] = []

    def meanwhile():
        # once: at its end Python has nothing to say it with
        if not sent and script.rig.firmware.joints_deg[0] > 10.0:
            sent.append(number)
            process.send_signal(number)

    with subprocess.Popen(words, env=environment, stderr=subprocess.PIPE, text=True) as process:
        script.meanwhile = meanwhile
        _, told = script.run(lambda: process.communicate(timeout=30.0))
    script.rig.run(1.0)
    assert number is signal.SIGKILL or told.rstrip().endswith("KeyboardInterrupt")
    assert script.rig.firmware.joints_deg[0] < 100.0
    assert not script.rig.controller.operating_state.moving
    ended = [event for event in script.rig.events if event.code == "lease_ended"]
    assert [event.params["reason"].code for event in ended] == [reason]


def test_an_interrupt_in_the_moment_of_the_grant_gives_it_back(with_arm, monkeypatch):
    def act(arm):
        ask = arm._connection.ask

        def interrupted(*args, **more):
            ask(*args, **more)
            raise KeyboardInterrupt

        with monkeypatch.context() as patch:
            patch.setattr(arm._connection, "ask", interrupted)
            with pytest.raises(KeyboardInterrupt):
                arm.lease("interrupted").take()
        with arm.lease("again") as lease:
            return lease.held

    assert with_arm(act), "held by nobody, and nobody else gets it"


def test_an_interrupt_in_the_middle_of_a_line_does_not_swallow_the_halt(with_lease, script):
    class Torn:
        """The socket, interrupted once in the middle of what it sends."""

        def __init__(self, whole):
            self.whole = whole

        def __getattr__(self, name):
            return getattr(self.whole, name)

        def sendall(self, line):
            if threading.current_thread().name == "armui-client":  # is never interrupted
                self.whole.sendall(line)
                return
            connection._socket = self.whole
            self.whole.sendall(line[: len(line) // 2])
            raise KeyboardInterrupt

    connection = None

    def ask(arm):
        nonlocal connection
        connection = arm._connection
        arm.move_joints(FAR, wait=False)
        while arm.state().joints_deg.get()[0] < 10.0:
            pass
        with connection._writing:
            connection._socket = Torn(connection._socket)
        while True:
            arm.state()

    with pytest.raises(KeyboardInterrupt):
        with_lease(ask)
    ended = [event for event in script.rig.events if event.code == "lease_ended"]
    assert [event.params["reason"].code for event in ended] == ["lease_stopped"]
    script.rig.run(1.0)
    assert script.rig.firmware.joints_deg[0] < 100.0


# The stream -----------------------------------------------------------------------------------


def test_a_stream_keeps_its_pace_and_is_followed(with_lease, script):
    def ask(arm):
        began_s = script.time.monotonic()
        with arm.stream(rate_hz=50) as targets:
            for step in range(100):
                targets.target((0.2 * step, 0, 0, 0, 0, 0))
            took_s = script.time.monotonic() - began_s
            targets.hold((19.8, 0, 0, 0, 0, 0), 0.5)
            return took_s, targets.refused

    took_s, refused = with_lease(ask)
    assert took_s == pytest.approx(2.0, abs=0.3)
    assert refused == 0
    assert script.rig.firmware.joints_deg[0] == pytest.approx(19.8, abs=0.3)


def test_a_target_that_cannot_be_followed_is_raised_or_returned(with_lease, script):
    def ask(arm):
        with arm.stream() as raising, pytest.raises(armui_client.Refused, match="Joint 1"):
            raising.hold((200.0, 0, 0, 0, 0, 0), 0.2)
        with arm.stream(raises=False) as returning:
            refusal = returning.hold((200.0, 0, 0, 0, 0, 0), 0.2)
            assert returning.refused > 0
            returning.hold((2.0, 0, 0, 0, 0, 0), 1.0)
            return refusal

    refusal = with_lease(ask)
    assert refusal.figures["joint"] == 1
    assert script.rig.firmware.joints_deg[0] == pytest.approx(2.0, abs=0.2)


def test_a_stream_ends_with_the_lease(with_lease, script):
    def meanwhile():
        if script.rig.firmware.joints_deg[0] > 1.0:
            script.desk.take_back()

    script.meanwhile = meanwhile

    def ask(arm):
        with arm.stream(raises=False) as targets:
            targets.hold((20.0, 0, 0, 0, 0, 0), 20.0)

    with pytest.raises(armui_client.LeaseLost) as found:
        with_lease(ask)
    assert found.value.reason == "lease_taken_back"


@pytest.mark.parametrize("rate_hz", [9.0, 101.0])
def test_a_rate_that_no_stream_has(rate_hz, with_arm):
    with pytest.raises(armui_client.Invalid, match="10 to 100"):
        with_arm(lambda arm: arm.stream(rate_hz=rate_hz))


# The connection -------------------------------------------------------------------------------


def test_nobody_is_there(tmp_path):
    with pytest.raises(armui_client.Disconnected, match="--api-on"):
        armui_client.connect("a test", path=tmp_path / "none")


def test_a_name_that_armui_does_not_take(script):
    with pytest.raises(armui_client.Invalid, match="1 to 80 characters"):
        script.run(lambda: armui_client.connect("x" * 81))


def test_the_interface_is_switched_off(with_lease, script):
    def meanwhile():
        if script.rig.firmware.joints_deg[0] > 20.0:
            script.desk.switch(on=False)

    script.meanwhile = meanwhile

    def ask(arm):
        try:
            arm.move_joints(FAR)
        finally:
            while arm._connection.heard.gone is None:
                time.sleep(0.001)
            with pytest.raises(armui_client.Disconnected):
                arm.state()

    with pytest.raises((armui_client.Disconnected, armui_client.LeaseLost)):
        with_lease(ask)
    script.rig.run(1.0)
    assert script.rig.firmware.joints_deg[0] < 100.0


def test_a_closed_connection_says_so(script):
    def ask():
        arm = armui_client.connect("a test")
        states = arm.subscribe(rate_hz=50)
        next(states)
        was = [arm.is_connected]
        arm.close()
        assert [*was, arm.is_connected] == [True, False]
        arm.close()
        arm.state()

    with pytest.raises(armui_client.Disconnected, match="is closed"):
        script.run(ask)


def test_one_client_too_many_reads_why(script):
    def ask():
        arms = []
        try:
            for _ in range(9):
                arms.append(armui_client.connect("many"))  # noqa: PERF401 - those before count
        finally:
            for each in arms:
                each.close()

    with pytest.raises(armui_client.Disconnected, match="At most 8 clients"):
        script.run(ask)


def test_no_answer_is_a_timeout(with_arm, desk, monkeypatch):
    monkeypatch.setattr(desk._server, "_answer", lambda *_args, **_more: None)
    with pytest.raises(armui_client.Timeout, match=r"hello within 0\.1 s"):
        with_arm(lambda arm: None, timeout_s=0.1)


def test_many_threads_ask_at_once(with_arm):
    def ask(arm):
        found: list[tuple[float, armui_client.Six]] = []

        def one(angle):
            found.extend((angle, arm.fk((angle, 0, 0, 0, 0, 0))) for _ in range(20))

        threads = [threading.Thread(target=one, args=(float(each),)) for each in range(6)]
        for each in threads:
            each.start()
        for each in threads:
            each.join()
        return found, [arm.fk((float(each), 0, 0, 0, 0, 0)) for each in range(6)]

    found, right = with_arm(ask)
    assert len(found) == 120
    assert all(pose == right[int(angle)] for angle, pose in found)


@pytest.mark.parametrize("mode", [0o700, 0o777, None])
def test_the_socket_is_looked_for_where_armui_has_it(mode, tmp_path, monkeypatch):
    monkeypatch.delenv("ARMUI_SOCKET", raising=False)
    folder = tmp_path / "run"
    if mode is not None:
        folder.mkdir()
        folder.chmod(mode)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(folder))
    assert armui_client.socket_path() == paths.runtime() / "api.sock"
    monkeypatch.setattr(armui_client.connection, "_is_private", lambda _folder: False)
    monkeypatch.setattr(paths, "is_private", lambda _folder: False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    assert armui_client.socket_path() == paths.runtime() / "api.sock"
    monkeypatch.setenv("ARMUI_SOCKET", "/x/y.sock")
    assert os.fspath(armui_client.socket_path()) == "/x/y.sock"


# What a user reads ----------------------------------------------------------------------------


def module(path):
    spec = util.spec_from_file_location(f"example_{path.stem}", path)
    assert spec is not None
    found = util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


@pytest.mark.parametrize(
    "path", sorted((HERE / "examples").glob("*.py")), ids=lambda each: each.stem
)
def test_each_example_runs(path, script, capsys):
    script.run(module(path).main)
    told = capsys.readouterr().out
    expected = {
        "read": 16,
        "move": 3,
        "pick_and_place": 2,
        "sine": 1,
        "tray": 6,
    }
    assert len(told.splitlines()) == expected[path.stem]
    assert "left out" not in told
    assert script.desk.view.lease is None


def test_the_script_of_readme_runs(script, capsys):
    readme = (HERE / "README.md").read_text(encoding="utf-8")
    first = readme.split("```python\n")[1].split("```")[0]
    script.run(lambda: exec(first, {}))
    assert capsys.readouterr().out
    assert "went_home" not in script.rig.codes()
    assert max(map(abs, script.rig.firmware.joints_deg)) > 10.0
