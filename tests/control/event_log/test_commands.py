"""Every kind of command in the events: who asked, what, the answer, what was read back."""

from __future__ import annotations

from itertools import pairwise
from types import SimpleNamespace

import pytest

from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.codes import EndLoad, MoveMode, TeachingState, TrajectoryCommand
from armui.sim.faults.schedule import fault
from armui.telemetry.events import Asker, EventKind, Level
from tests.accepted import accepted
from tests.control.jogger import bend
from tests.control.under_way import BACK, BESIDE_A_RUN, MOTIONS, OUT, POSE, SETTINGS, run_of, to

OPERATOR, JOG = Asker.OPERATOR, Asker.JOG
ARRIVED = "arrived"


def of(code, result=None, *, answered=False, who=OPERATOR):
    return SimpleNamespace(code=code, result=result, answered=answered, who=who)


def setting(name, joint, value):
    return lambda b: b.controller.settings.save({Parameter(name, joint): value})


KINDS = {
    "enable all": (SETTINGS["enable all"], of("enable_sent", "enabled", answered=True)),
    "enable one": (SETTINGS["enable one"], of("enable_sent_joint", "enabled_joint", answered=True)),
    "disable all": (
        lambda b: b.controller.motors.disable(),
        of("disable_sent", "disabled", answered=True),
    ),
    "disable one": (
        lambda b: b.controller.motors.disable(3),
        of("disable_sent_joint", "disabled_joint", answered=True),
    ),
    "clear error": (
        SETTINGS["clear error"],
        of("clear_error_sent", "clear_error_answered", answered=True),
    ),
    "zero one": (SETTINGS["zero one"], of("zero_sent_joint", "zero_set_joint", answered=True)),
    "zero all": (SETTINGS["zero all"], of("zero_sent", "zero_set", answered=True)),
    "limit": (SETTINGS["limit"], of("settings_sent", "settings_saved", answered=True)),
    "acceleration": (
        SETTINGS["acceleration"],
        of("settings_sent", "settings_saved", answered=True),
    ),
    "factory values": (
        SETTINGS["factory joint limits"],
        of("settings_reset_sent", "settings_reset", answered=True),
    ),
    "load": (
        lambda b: b.controller.end_reports.set_load(EndLoad.FULL),
        of("load_sent", "load_answered", answered=True),
    ),
    "end feedback": (
        lambda b: b.controller.end_reports.switch(on=True),
        of("end_feedback_sent", "end_feedback_on", answered=True),
    ),
    "linkage": (SETTINGS["no linkage"], of("linkage_sent", "linkage_answered", answered=True)),
    "drag teaching": (SETTINGS["drag teaching"], of("teaching_sent", "teaching_done")),
    "run": (SETTINGS["run"], of("run_started", "run_done")),
    "replay": (SETTINGS["replay"], of("run_started", "run_done")),
    "joints": (MOTIONS["joints"], of("sent_joints", ARRIVED)),
    "home": (MOTIONS["home"], of("went_home", ARRIVED)),
    "step": (MOTIONS["step"], of("jogged", ARRIVED)),
    "pose": (MOTIONS["pose"], of("sent_pose", ARRIVED)),
    "tool step": (MOTIONS["tool step"], of("stepped_tool", ARRIVED)),
    "gripper": (BESIDE_A_RUN["gripper"], of("gripper_sent", "gripper_there")),
    "gripper on": (BESIDE_A_RUN["gripper on"], of("gripper_act_sent", "gripper_act_done")),
    "gripper error": (BESIDE_A_RUN["gripper error"], of("gripper_act_sent", "gripper_act_done")),
    "gripper zero": (BESIDE_A_RUN["gripper zero"], of("gripper_act_sent", "gripper_act_done")),
    "stop": (lambda b: b.controller.emergency_stop(), of("stop_sent", "stop_confirmed")),
    "halt": (lambda b: b.controller.halt_and_hold(), of("halt_sent", "halt_at_rest")),
    "lamp": (lambda b: b.controller.lights.set_light(1, 2, 3, 4, 5), of("sent_lamp")),
    "clear the plan": (
        lambda b: b.controller.planned_motion.command(TrajectoryCommand.CLEAR_CURRENT),
        of("plan_sent"),
    ),
    "record": (lambda b: b.controller.recorder.start(), of("recording_started")),
}
"""What the operator does, and the entry it makes; no result: the arm reports nothing of it."""


def commands(rig, since=0):
    return [
        each
        for each in rig.controller.events.entries()
        if each.kind is EventKind.COMMAND and each.number > since
    ]


def only(rig, code):
    """The newest entry of a code."""
    return [each for each in rig.controller.events.entries() if each.code == code][-1]


@pytest.mark.parametrize("name", KINDS)
def test_what_was_asked_what_was_answered_and_what_was_read_back(rig, name):
    act, expected = KINDS[name]
    bend(rig)
    rig.run(0.4)
    number, asked_s = rig.controller.events.newest, rig.time_s
    assert not isinstance(act(rig), Refusal)
    (entry,) = commands(rig, number)
    assert (entry.code, entry.who) == (expected.code, expected.who)
    assert entry.at_s == pytest.approx(asked_s, abs=1e-6)
    assert entry.answer is None
    if expected.result is not None:
        rig.run_until(lambda: rig.controller.events.get(entry.number).result is not None)
    else:
        rig.run(0.6)
    entry = rig.controller.events.get(entry.number)
    assert (entry.answer is not None) == expected.answered
    assert (entry.result and entry.result.code) == expected.result
    if expected.answered:
        assert asked_s <= entry.answer.at_s <= rig.time_s
    if expected.result is not None:
        assert asked_s <= entry.result.at_s <= rig.time_s


def test_what_was_set_is_told_with_its_values(rig):
    bend(rig)
    accepted(setting("max_angle_deg", 2, 100.0)(rig))
    assert only(rig, "settings_sent").params["values"] == (("max_angle_deg", 2, 100.0),)


@pytest.mark.parametrize(
    ("name", "code"), [("joint jog", "jogging_joint"), ("tool jog", "jogging_tool")]
)
def test_a_jog_ends_when_the_arm_has_come_to_rest(rig, name, code):
    bend(rig)
    accepted(MOTIONS[name](rig))
    rig.run(0.6)
    entry = only(rig, code)
    assert (entry.who, entry.result) == (JOG, None)
    rig.controller.jogging.stop()
    rig.run_until(lambda: only(rig, code).result is not None)
    assert only(rig, code).result.code == ARRIVED


def test_a_held_button_that_sends_nothing_gets_no_result(rig):
    bend(rig)
    accepted(MOTIONS["joint jog"](rig))
    rig.controller.jogging.stop()  # at once, before the first setpoint
    rig.run(1.5)
    assert only(rig, "jogging_joint").result is None


def test_the_points_of_a_run_are_its_own(rig):
    bend(rig)
    accepted(rig.controller.player.start(run_of(to(OUT), to(BACK))))
    rig.run_until(lambda: "run_done" in rig.codes())
    rig.run(0.2)
    (points,) = [each for each in commands(rig) if each.code == "run_point"]
    assert (points.who, points.count, points.params) == (Asker.RUN, 2, {"row": 2})
    assert points.result.code == ARRIVED
    started = only(rig, "run_started")
    assert (started.who, started.result.code) == (OPERATOR, "run_done")


def test_what_the_recovery_line_asks_is_its_own(rig):
    rig.ready()
    rig.node.faults.start(broken := fault("overcurrent", 3))
    rig.run_until(lambda: rig.controller.recovery.step.kind is StepKind.OVERCURRENT)
    rig.node.faults.end(broken)
    rig.run(0.1)
    assert rig.controller.recovery.act(rig.controller.recovery.step) is None
    assert only(rig, "clear_error_sent").who is Asker.RECOVERY
    rig.run(1.0)
    accepted(rig.controller.joint_errors.clear(3))
    assert only(rig, "clear_error_sent").who is OPERATOR


def test_a_motion_that_is_stopped_says_by_what(rig):
    bend(rig)
    accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.2)
    rig.controller.emergency_stop()
    rig.run(0.3)
    result = only(rig, "sent_joints").result
    assert (result.code, result.params, result.level) == (
        "motion_cut",
        {"end": "STOPPED"},
        Level.WARNING,
    )


def test_a_motion_that_another_takes_the_place_of(rig):
    bend(rig)
    accepted(rig.controller.motion.send_joints(BACK))
    first = only(rig, "sent_joints")
    rig.run(0.2)
    accepted(rig.controller.motion.go_home())
    rig.run_until(lambda: "went_home" in rig.codes(), seconds=1.0)
    rig.run_until(lambda: only(rig, "went_home").result is not None)
    result = rig.controller.events.get(first.number).result
    assert (result.params, result.level) == ({"end": "REPLACED"}, Level.INFO)
    assert only(rig, "went_home").result.code == ARRIVED


def test_a_motion_cut_off_by_a_lost_cable(rig):
    bend(rig)
    accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.2)
    rig.controller.disconnect_device()
    assert only(rig, "sent_joints").result.code == "motion_cut"


def test_a_command_that_fails(rig):
    rig.connect()
    rig.node.faults.start(fault("overcurrent", 3))
    rig.run(0.5)
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: only(rig, "enable_sent").result is not None)
    result = only(rig, "enable_sent").result
    assert (result.code, result.level, result.params) == (
        "enable_failed",
        Level.FAULT,
        {"joints": "3"},
    )


def test_a_refusal_is_kept_with_its_reason_and_counted(rig):
    rig.connect()
    for _ in range(3):
        assert isinstance(rig.controller.motion.send_joints(OUT), Refusal)
    refused = only(rig, "refused")
    assert (refused.kind, refused.count) == (EventKind.COMMAND, 3)
    assert refused.params["reason"] == rig.controller.operating_state.cannot_move


def test_a_dragged_slider_is_one_line(rig):
    bend(rig)
    for percent in range(40, 60):
        accepted(rig.controller.motion.set_speed_percent(percent))
    speeds = [each for each in commands(rig) if each.code == "sent_speed"]
    assert len(speeds) == 1
    assert speeds[0].params == {"percent": 59}
    assert speeds[0].count >= 20


def test_two_steps_are_two_commands_each_with_its_end(rig):
    bend(rig)
    for _ in range(2):
        accepted(rig.controller.motion.jog(1, 2.0))
        rig.run(1.5)
    steps = [each for each in commands(rig) if each.code == "jogged"]
    assert [each.params["target"] for each in steps] == [12.0, 14.0]
    assert [each.result.code for each in steps] == [ARRIVED, ARRIVED]


def test_the_order_is_that_of_time(rig):
    bend(rig)
    rig.controller.teaching.command(TeachingState.START_RECORDING)
    rig.run(0.5)
    rig.controller.emergency_stop()
    rig.run(0.5)
    assert isinstance(rig.controller.cartesian.move(POSE, MoveMode.MOVE_P), Refusal)
    entries = rig.controller.events.entries()
    times = [each.at_s for each in entries]
    late = [b - a for a, b in pairwise(times) if b < a]
    assert not late
    walls = [each.wall for each in entries]
    assert all(wall.tzinfo is not None for wall in walls)


# The link ------------------------------------------------------------------------------------


def test_an_arm_that_falls_silent_is_offline_from_then_until_it_is_heard(rig):
    rig.ready()
    rig.powered = False
    rig.run_until(lambda: "offline" in rig.codes())
    assert only(rig, "offline").goes_on
    rig.powered = True
    rig.run_until(lambda: rig.codes()[-1] != "offline" and rig.codes().count("online") == 2)
    offline = only(rig, "offline")
    assert offline.ended_s == pytest.approx(only(rig, "online").at_s, abs=0.1)


def test_another_host_is_there_from_its_first_frame_to_its_last(rig, other_host):
    rig.ready()
    begun_s = rig.time_s
    stream = other_host.stream_targets(lambda _t_s: OUT)
    rig.run_until(lambda: "other_host_moves" in rig.codes())
    stream.end()
    rig.run_until(lambda: "other_host_gone" in rig.codes())
    rig.run(0.5)
    named = [each for each in rig.controller.events.entries() if each.code == "other_frames"]
    assert {each.params["id"] for each in named} >= {"0x155", "0x156", "0x157"}
    for each in named:
        assert each.who is Asker.OTHER_HOST
        assert begun_s <= each.at_s <= each.ended_s <= rig.time_s - 2.0
    moves = only(rig, "other_host_moves")
    assert moves.ended_s == only(rig, "other_host_gone").at_s
