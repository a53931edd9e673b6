"""Jogging: the arm follows a hold, and is at rest within 100 ms of whatever ends it."""

import math
from contextlib import suppress

import pytest

from armui.arm.parameters import Parameter
from armui.arm.reach import POSE_OUT_OF_REACH
from armui.control.link.link_state import NOT_CONNECTED
from armui.control.motion.jog_pace import REST_S, pace
from armui.control.motion.jog_path import JOG_AT_LIMIT, JointJog, ToolJog
from armui.control.motion.jog_stream import JOG_SINGULAR
from armui.control.operating_state import BUSY
from armui.control.operations.started import Ending, Started
from armui.control.safety.interlocks import NOT_ENABLED
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import AXES, JogFrame
from armui.kinematics.poses import matrix_to_pose, shifted, tool_matrix
from armui.protocol.codes import ArmStatusCode, MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.condition import Condition
from tests.accepted import accepted
from tests.control.jogger import (
    BENT_DEG,
    LOSSES,
    TICK_S,
    bend,
    fastest_deg_s,
    hold,
    release,
    rest_s,
)
from tests.family import FACTORY_LIMITS, PIPER

JOBS = {
    "joint": JointJog(1, 1),
    "base X": ToolJog(0, 1, JogFrame.BASE),
    "tool RY": ToolJog(4, -1, JogFrame.TOOL),
}


@pytest.fixture
def arm_repeats():
    return True  # it is looked at between two steps


def angles(rig):
    return [round(angle, 3) for angle in rig.firmware.joints_deg]


ONE, TWO = Generation
LOST = {  # what is jogged, and how fast, is no matter of the generation
    **{name: (TWO, job, 100) for name, job in JOBS.items()},
    "joint slowly": (TWO, JOBS["joint"], 1),
    "base X at a third": (TWO, JOBS["base X"], 30),
    "joint of generation 1": (ONE, JOBS["joint"], 100),
    "base X of generation 1": (ONE, JOBS["base X"], 100),
}


@pytest.mark.each_pair(full="each loss in each sort of jog")
@pytest.mark.parametrize(
    ("generation", "job", "percent"), LOST.values(), ids=LOST, indirect=["generation"]
)
@pytest.mark.parametrize("loss", LOSSES.values(), ids=LOSSES)
def test_the_arm_rests_within_100_ms_of_any_loss(any_rig, loss, job, percent, record_property):
    rig = any_rig
    bend(rig)
    rig.controller.motion.set_speed_percent(percent)
    accepted(rig.controller.jogging.start(job))
    hold(rig, 0.5)
    assert rig.controller.jogging.active
    assert angles(rig) != list(BENT_DEG)
    loss(rig)
    took_s = rest_s(rig)
    record_property("rest_s", took_s)
    print(f"REST {1e3 * took_s:.0f} ms")
    assert took_s <= 0.1
    assert took_s <= REST_S + 2 * TICK_S
    rig.broken = rig.broken or OSError()  # nothing is left to wait for


@pytest.mark.parametrize("held_s", [0.05, 0.06, 0.07, 0.09, 0.12, 0.15])
def test_a_short_press_ends_as_soon(rig, held_s):
    bend(rig)
    rig.controller.motion.set_speed_percent(100)
    rig.controller.jogging.start(JointJog(2, -1))
    hold(rig, held_s)
    release(rig)
    assert rest_s(rig) <= REST_S + TICK_S


def test_turning_back_at_once_waits_for_the_rest(rig):
    bend(rig)
    rig.controller.motion.set_speed_percent(100)
    jogging = rig.controller.jogging
    jogging.start(JointJog(1, 1))
    hold(rig, 0.3)
    jogging.start(JointJog(1, -1))
    for _ in range(40):
        hold(rig, TICK_S)
        assert fastest_deg_s(rig) < 14.0
    assert rig.firmware.mechanics.speeds_deg_s[0] == pytest.approx(-13.0, abs=1.5)
    release(rig)
    assert rest_s(rig) <= 0.1


def test_the_speed_is_the_cap_scaled_by_the_percentage(any_rig):
    rig = any_rig
    bend(rig)
    for percent, speed_deg_s in ((100, 12.89), (50, 6.446), (10, 1.289)):
        rig.controller.motion.set_speed_percent(percent)
        rig.controller.jogging.start(JointJog(6, -1))
        hold(rig, 0.3)
        before = rig.firmware.joints_deg[5]
        hold(rig, 0.5)
        gone = before - rig.firmware.joints_deg[5]
        release(rig)
        hold(rig, 0.3)
        assert gone == pytest.approx(0.5 * speed_deg_s, rel=0.03)


def test_the_first_setpoint_enters_move_j_and_the_rest_are_targets(any_rig):
    rig = any_rig
    rig.ready()
    rig.controller.motion.set_speed_percent(100)
    rig.run(0.1)
    rig.heard()
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    assert rig.codes()[-1] == "jogging_joint"
    hold(rig, 0.03)
    frames = rig.heard()
    # 0.129° after the first 10 ms: 12.89 °/s, 0x81 steps of 0.001°; 8 % of 171.9 °/s lies above it
    zero = bytes(8)
    assert frames[:4] == [
        Frame(0x155, bytes.fromhex("00 00 00 81 00 00 00 00")),
        Frame(0x156, zero),
        Frame(0x157, zero),
        Frame(0x151, bytes.fromhex("01 01 08 00 00 00 00 00")),
    ]
    assert {frame.arbitration_id for frame in frames[4:]} == {0x155, 0x156, 0x157}
    release(rig)
    hold(rig, 0.05)
    assert rig.heard() == []


def test_the_operator_s_speed_is_given_back(any_rig):
    rig = any_rig
    bend(rig)
    rig.controller.jogging.start(JointJog(1, 1))
    hold(rig, 0.3)
    release(rig)
    rig.heard()
    hold(rig, 0.5)
    assert rig.heard() == [Frame(0x151, bytes.fromhex("01 01 64 00 00 00 00 00"))]
    before = angles(rig)
    hold(rig, 0.2)
    assert angles(rig) == before
    status = rig.controller.state.status.value
    if rig.firmware.generation is Generation.ONE:
        assert status.speed_percent == 100


def test_a_joint_stops_at_its_limit_and_says_so(any_rig):
    rig = any_rig
    bend(rig, (148.0, *BENT_DEG[1:]))
    jogging = rig.controller.jogging
    jogging.start(JointJog(1, 1))
    hold(rig, 0.6)
    assert not jogging.active
    assert angles(rig)[0] == 150.0
    told = rig.events[-1]
    assert told.code == "jog_ended"
    assert told.params["reason"].reason == JOG_AT_LIMIT
    assert dict(told.params["reason"].params) == {"joint": 1, "limit": 150.0}
    jogging.start(JointJog(1, 1))
    hold(rig, 0.1)
    assert not jogging.active
    jogging.start(JointJog(1, -1))
    hold(rig, 0.2)
    assert jogging.active
    assert angles(rig)[0] < 150.0


@pytest.mark.parametrize(
    ("job", "seconds", "reason"),
    [
        (ToolJog(0, 1, JogFrame.BASE), 12.0, "jog_out_of_reach"),
        (ToolJog(2, -1, JogFrame.BASE), 12.0, "jog_at_limit"),
        (ToolJog(3, 1, JogFrame.TOOL), 12.0, "jog_at_limit"),
    ],
)
def test_the_tool_stops_before_what_it_cannot_do(rig, job, seconds, reason):
    bend(rig)
    jogging = rig.controller.jogging
    jogging.start(job)
    for _ in range(round(seconds / TICK_S)):
        hold(rig, TICK_S)
        if not jogging.active:
            break
    told = rig.events[-1]
    assert (told.code, told.params["reason"].code) == ("jog_ended", reason)
    assert rest_s(rig) <= 0.1
    assert rig.controller.operating_state.cannot_move is None  # the arm had nothing to complain of


def test_at_a_singular_pose_the_tool_does_not_go_sideways(rig):
    bend(rig, (0.0, 60.0, -60.0, 0.0, 0.0, 0.0))
    before = angles(rig)
    rig.controller.jogging.start(ToolJog(1, 1, JogFrame.BASE))
    hold(rig, 0.3)
    told = rig.events[-1]
    assert told.params["reason"].reason == JOG_SINGULAR
    assert angles(rig) == pytest.approx(before, abs=0.2)


def test_a_step_that_the_arm_itself_refuses_as_singular_is_not_read_back(rig):
    bend(rig, (0.0, 60.0, -60.0, 0.0, 1.0, 0.0))
    step = accepted(rig.controller.cartesian.step(1, 1.0, JogFrame.BASE))
    rig.run(1.5)
    assert rig.controller.state.status.value.arm_status == ArmStatusCode.SINGULARITY
    assert step.ending is Ending.FAILED
    assert step.result.params == {"end": "refused"}


@pytest.mark.parametrize("said", [2, 3, 4])
def test_a_motion_that_arrives_is_not_told_as_refused_by_a_status_that_stays(
    rig, monkeypatch, said
):
    bend(rig)
    monkeypatch.setattr(Condition, "status", property(lambda _: ArmStatusCode(said)))
    rig.run(0.3)
    started = accepted(rig.controller.motion.send_joints((30.0, *BENT_DEG[1:])))
    rig.run_until(lambda: started.ending is not None)
    assert started.ending is Ending.DONE


def test_a_line_out_of_reach_is_told_so_though_it_begins_where_it_is_singular(rig):
    bend(rig, (0.0, 60.0, -60.0, 0.0, 0.0, 0.0))
    far = (900.0, 300.0, 300.0, 0.0, 85.0, 0.0)
    refusal = rig.controller.cartesian.move(far, MoveMode.MOVE_L)
    assert refusal.reason is POSE_OUT_OF_REACH


@pytest.mark.each_value(full="each axis in both frames")
@pytest.mark.parametrize("axis", range(6))
@pytest.mark.parametrize("frame", JogFrame)
def test_the_tool_goes_along_one_axis_alone(rig, axis, frame):
    tool = (10.0, -20.0, 80.0, 0.0, 30.0, 0.0)
    bend(rig)
    rig.controller.cartesian.tool = tool
    model = Kinematics(PIPER)
    start = tool_matrix(model.matrix(rig.firmware.joints_deg), tool)
    rig.controller.jogging.start(ToolJog(axis, 1, frame))
    hold(rig, 0.6)
    release(rig)
    rest_s(rig)
    end = tool_matrix(model.matrix(rig.firmware.joints_deg), tool)
    if axis < 3:
        along = start[:3, axis] if frame is JogFrame.TOOL else [float(i == axis) for i in range(3)]
        amount = float((end - start)[:3, 3] @ along)
        assert amount > 5.0
    else:
        amount = next(a / 100 for a in range(1, 1200) if abs(_turn(start, end) - a / 100) <= 0.0051)
    reached = matrix_to_pose(end)
    assert reached == pytest.approx(matrix_to_pose(shifted(start, axis, amount, frame)), abs=0.05)
    assert AXES[axis] == rig.events[-1].params["axis"]


def _turn(start, end):
    return math.degrees(
        math.acos(min(1.0, (float((start[:3, :3].T @ end[:3, :3]).trace()) - 1) / 2))
    )


# What takes the arm away from a hold --------------------------------------------------------------


def held(rig):
    bend(rig)
    rig.controller.jogging.start(JointJog(1, 1))
    hold(rig, 0.2)
    assert rig.controller.jogging.active
    rig.heard()
    return rig.controller


def test_the_emergency_stop_ends_it_at_once(any_rig):
    controller = held(any_rig)
    controller.emergency_stop()
    assert not controller.jogging.active
    hold(any_rig, 0.1)
    assert {frame.arbitration_id for frame in any_rig.heard()} == {0x150}
    hold(any_rig, 1.0)
    assert not controller.jogging.active


def test_disabling_ends_it(rig):
    controller = held(rig)
    controller.motors.disable()
    hold(rig, 0.1)
    assert not controller.jogging.active
    assert {frame.arbitration_id for frame in rig.heard()} == {0x471}


def test_another_command_takes_over(rig):
    controller = held(rig)
    controller.motion.go_home()
    hold(rig, 0.05)
    assert not controller.jogging.active
    assert [frame.arbitration_id for frame in rig.heard()] == [0x155, 0x156, 0x157, 0x151]


def test_speed_zero_ends_it_with_the_reason(rig):
    controller = held(rig)
    controller.motion.set_speed_percent(0)
    hold(rig, 0.05)
    assert rig.events[-1].params["reason"].code == "speed_zero"


def test_a_program_that_was_stuck_does_not_go_on_by_itself(rig):
    controller = held(rig)
    rested = rest_s(rig)
    before = angles(rig)
    hold(rig, 0.2)
    assert rested <= 0.1
    assert not controller.jogging.active
    assert angles(rig) == before
    (ended,) = [each for each in rig.events if each.code == "jog_ended"]
    assert ended.params["reason"].code == "jog_held_up"


def test_an_arm_that_can_hear_and_not_be_heard_is_not_led_on(rig):
    controller = held(rig)
    rig.node.link.to_bus = lambda frames, now_s, dt_s: ([], len(frames))
    took_s = 0.0
    places = rig.firmware.joints_deg
    for count in range(30):
        hold(rig, TICK_S)
        if rig.firmware.joints_deg != places:
            took_s = TICK_S * (count + 1)
        places = rig.firmware.joints_deg
    assert took_s <= 0.1
    assert rig.events[-1].params["reason"].code == "jog_no_feedback"
    assert not controller.jogging.active


def test_an_arm_that_does_not_follow_is_given_up(rig):
    controller = held(rig)
    rig.firmware._moves.take_frame = lambda name, signals: True  # it takes no target any more
    hold(rig, 1.0)
    assert not controller.jogging.active
    assert rig.events[-1].params["reason"].code == "jog_not_following"


def test_a_joint_beyond_its_limits_is_led_back_to_them_while_held(rig):
    """The arm takes no target before the first within them."""
    bend(rig, (100.0, *BENT_DEG[1:]))
    accepted(rig.controller.settings.save({Parameter("max_angle_deg", 1): 50.0}))
    rig.run_until(lambda: rig.controller.operating_state.limits[0].max_deg == 50.0)
    accepted(rig.controller.jogging.start(JointJog(1, -1)))
    hold(rig, 1.0)
    assert 60.0 < angles(rig)[0] < 99.0
    rig.controller.jogging.stop()
    rig.run(1.0)
    let_go_deg = angles(rig)[0]
    assert let_go_deg > 60.0
    rig.run(1.0)
    assert angles(rig)[0] == pytest.approx(let_go_deg, abs=0.1)
    accepted(rig.controller.jogging.start(JointJog(1, -1)))
    hold(rig, 8.0)
    assert angles(rig)[0] < 49.0


def test_a_joint_beyond_its_limits_is_led_no_further(rig):
    bend(rig, (100.0, *BENT_DEG[1:]))
    accepted(rig.controller.settings.save({Parameter("max_angle_deg", 1): 50.0}))
    rig.run_until(lambda: rig.controller.operating_state.limits[0].max_deg == 50.0)
    for jog in (JointJog(1, 1), JointJog(2, 1)):
        rig.controller.jogging.start(jog)
        hold(rig, 0.5)
        assert not rig.controller.jogging.active
        reason = rig.events[-1].params["reason"]
        assert reason.code == "joints_outside"
        assert reason.params["joints"] == "J1 100.0° > 50°"
    assert angles(rig)[0] == pytest.approx(100.0, abs=0.1)


def test_an_arm_in_motion_is_not_jogged(rig):
    bend(rig)
    rig.controller.motion.send_joints((100.0, *BENT_DEG[1:]))
    hold(rig, 0.2)
    rig.heard()
    accepted(rig.controller.jogging.start(JointJog(2, 1)))
    hold(rig, 0.5)
    assert rig.events[-1].params["reason"].code == "still_moving"
    assert rig.heard() == []


def test_of_an_arm_that_has_just_been_sent_off_it_begins_where_that_is(rig):
    rig.controller.motion.set_speed_percent(30)
    bend(rig)
    away_deg = (BENT_DEG[0] + 60.0, *BENT_DEG[1:])
    accepted(rig.controller.motion.send_joints(away_deg))
    accepted(rig.controller.jogging.start(JointJog(6, 1)))
    hold(rig, 0.5)
    assert rig.controller.jogging.active
    assert angles(rig)[5] > BENT_DEG[5] + 2.0
    assert angles(rig)[0] == pytest.approx(BENT_DEG[0], abs=3.0), "it goes on where it was sent"


def test_without_an_arm_it_is_refused(rig):
    assert rig.controller.jogging.start(JointJog(1, 1)).reason == NOT_CONNECTED
    rig.connect()
    assert rig.controller.jogging.start(JointJog(1, 1)).reason == NOT_ENABLED
    assert not rig.controller.jogging.active


# The pace -----------------------------------------------------------------------------------------


def test_the_pace_keeps_the_promise_at_every_percentage():
    for percent in range(1, 101):
        for acceleration in (20.0, 100.0, 286.4789):
            now = pace(percent, FACTORY_LIMITS, (acceleration,) * 6)
            for speed, lead in zip(now.speeds_deg_s, now.leads_deg, strict=True):
                assert 0.0 < speed <= 0.045 * acceleration
                top = max(speed, lead / 0.045)
                assert lead / top + top / acceleration <= REST_S + 1e-9
            assert 1 <= now.arm_percent <= max(percent, 1)


def test_a_record_that_cannot_be_closed_holds_no_jog(rig, monkeypatch):
    """What holds a jog lets go before anything that can fail (S23)."""
    rig.ready()

    def fail(*_):
        raise RuntimeError("planted")

    monkeypatch.setattr(Started, "close", fail)
    jogging = rig.controller.jogging
    for let_go in (jogging.stop, jogging.halt, lambda: jogging.end_jog(BUSY())):
        accepted(jogging.start(JointJog(1, 1)))
        with suppress(RuntimeError):
            let_go()
        assert not jogging.active
        assert not jogging._timer.isActive()
