"""Jogging: the arm follows a hold, and is at rest within 100 ms of whatever ends it."""

import math

import pytest

from armui.arm.frames import AXES, JogFrame
from armui.arm.kinematics import Kinematics, matrix_to_pose
from armui.arm.limits import FACTORY_LIMITS
from armui.arm.poses import shifted, tool_matrix
from armui.control.jog_pace import REST_S, pace
from armui.control.jog_ways import JointJog, ToolJog
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
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

JOBS = {
    "joint": JointJog(1, 1),
    "base X": ToolJog(0, 1, JogFrame.BASE),
    "tool RY": ToolJog(4, -1, JogFrame.TOOL),
}


def angles(bench):
    return [round(angle, 3) for angle in bench.firmware.joints_deg]


@pytest.mark.parametrize(
    ("job", "percent"),
    [*((job, 100) for job in JOBS.values()), (JOBS["joint"], 1), (JOBS["base X"], 30)],
    ids=[*JOBS, "joint slowly", "base X at a third"],
)
@pytest.mark.parametrize("loss", LOSSES.values(), ids=LOSSES)
def test_the_arm_rests_within_100_ms_of_any_loss(any_bench, loss, job, percent, record_property):
    bench = any_bench
    bend(bench)
    bench.controller.motion.set_speed_percent(percent)
    assert bench.controller.jogging.start(job) is None
    hold(bench, 0.5)
    assert bench.controller.jogging.active
    assert angles(bench) != list(BENT_DEG)
    loss(bench)
    took_s = rest_s(bench)
    record_property("rest_s", took_s)
    print(f"REST {1e3 * took_s:.0f} ms")
    assert took_s <= 0.1
    assert took_s <= REST_S + 2 * TICK_S
    bench.broken = bench.broken or OSError()  # nothing is left to wait for


@pytest.mark.parametrize("held_s", [0.05, 0.06, 0.07, 0.09, 0.12, 0.15])
def test_a_short_press_ends_as_soon(bench, held_s):
    bend(bench)
    bench.controller.motion.set_speed_percent(100)
    bench.controller.jogging.start(JointJog(2, -1))
    hold(bench, held_s)
    release(bench)
    assert rest_s(bench) <= REST_S + TICK_S


def test_turning_back_at_once_waits_for_the_rest(bench):
    bend(bench)
    bench.controller.motion.set_speed_percent(100)
    jogging = bench.controller.jogging
    jogging.start(JointJog(1, 1))
    hold(bench, 0.3)
    jogging.start(JointJog(1, -1))
    for _ in range(40):
        hold(bench, TICK_S)
        assert fastest_deg_s(bench) < 14.0
    assert bench.firmware.body.speeds_deg_s[0] == pytest.approx(-13.0, abs=1.5)
    release(bench)
    assert rest_s(bench) <= 0.1


def test_the_speed_is_the_cap_scaled_by_the_percentage(any_bench):
    bench = any_bench
    bend(bench)
    for percent, speed_deg_s in ((100, 12.89), (50, 6.446), (10, 1.289)):
        bench.controller.motion.set_speed_percent(percent)
        bench.controller.jogging.start(JointJog(6, -1))
        hold(bench, 0.3)
        before = bench.firmware.joints_deg[5]
        hold(bench, 0.5)
        gone = before - bench.firmware.joints_deg[5]
        release(bench)
        hold(bench, 0.3)
        assert gone == pytest.approx(0.5 * speed_deg_s, rel=0.03)


def test_the_first_setpoint_enters_move_j_and_the_rest_are_targets(any_bench):
    bench = any_bench
    bench.ready()
    bench.controller.motion.set_speed_percent(100)
    bench.run(0.1)
    bench.heard()
    assert bench.controller.jogging.start(JointJog(1, 1)) is None
    assert bench.codes()[-1] == "jogging_joint"
    hold(bench, 0.03)
    frames = bench.heard()
    # 0.129° after the first 10 ms: 12.89 °/s, 0x81 steps of 0.001°; 8 % of 171.9 °/s lies above it
    zero = bytes(8)
    assert frames[:4] == [
        Frame(0x155, bytes.fromhex("00 00 00 81 00 00 00 00")),
        Frame(0x156, zero),
        Frame(0x157, zero),
        Frame(0x151, bytes.fromhex("01 01 08 00 00 00 00 00")),
    ]
    assert {frame.arbitration_id for frame in frames[4:]} == {0x155, 0x156, 0x157}
    release(bench)
    hold(bench, 0.05)
    assert bench.heard() == []


def test_the_operator_s_speed_is_given_back(any_bench):
    bench = any_bench
    bend(bench)
    bench.controller.jogging.start(JointJog(1, 1))
    hold(bench, 0.3)
    release(bench)
    bench.heard()
    hold(bench, 0.5)
    assert bench.heard() == [Frame(0x151, bytes.fromhex("01 01 64 00 00 00 00 00"))]
    before = angles(bench)
    hold(bench, 0.2)
    assert angles(bench) == before
    status = bench.controller.state.status.value
    if bench.firmware.generation is Generation.ONE:
        assert status.speed_percent == 100


def test_a_joint_stops_at_its_limit_and_says_so(any_bench):
    bench = any_bench
    bend(bench, (148.0, *BENT_DEG[1:]))
    jogging = bench.controller.jogging
    jogging.start(JointJog(1, 1))
    hold(bench, 0.6)
    assert not jogging.active
    assert angles(bench)[0] == 150.0
    told = bench.notices[-1]
    assert told.code == "jog_ended"
    assert told.params["reason"].code == "jog_at_limit"
    assert dict(told.params["reason"].params) == {"joint": 1, "limit": 150.0}
    jogging.start(JointJog(1, 1))
    hold(bench, 0.1)
    assert not jogging.active
    jogging.start(JointJog(1, -1))
    hold(bench, 0.2)
    assert jogging.active
    assert angles(bench)[0] < 150.0


@pytest.mark.parametrize(
    ("job", "seconds", "reason"),
    [
        (ToolJog(0, 1, JogFrame.BASE), 12.0, "jog_out_of_reach"),
        (ToolJog(2, -1, JogFrame.BASE), 12.0, "jog_at_limit"),
        (ToolJog(3, 1, JogFrame.TOOL), 12.0, "jog_at_limit"),
    ],
)
def test_the_tool_stops_before_what_it_cannot_do(bench, job, seconds, reason):
    bend(bench)
    jogging = bench.controller.jogging
    jogging.start(job)
    for _ in range(round(seconds / TICK_S)):
        hold(bench, TICK_S)
        if not jogging.active:
            break
    told = bench.notices[-1]
    assert (told.code, told.params["reason"].code) == ("jog_ended", reason)
    assert rest_s(bench) <= 0.1
    assert bench.controller.situation.cannot_move is None  # the arm had nothing to complain of


def test_at_a_singular_pose_the_tool_does_not_go_sideways(bench):
    bend(bench, (0.0, 60.0, -60.0, 0.0, 0.0, 0.0))
    before = angles(bench)
    bench.controller.jogging.start(ToolJog(1, 1, JogFrame.BASE))
    hold(bench, 0.3)
    told = bench.notices[-1]
    assert told.params["reason"].code == "jog_singular"
    assert angles(bench) == pytest.approx(before, abs=0.2)


@pytest.mark.parametrize("axis", range(6))
@pytest.mark.parametrize("frame", JogFrame)
def test_the_tool_goes_along_one_axis_alone(bench, axis, frame):
    tool = (10.0, -20.0, 80.0, 0.0, 30.0, 0.0)
    bend(bench)
    bench.controller.cartesian.tool = tool
    model = Kinematics()
    start = tool_matrix(model.matrix(bench.firmware.joints_deg), tool)
    bench.controller.jogging.start(ToolJog(axis, 1, frame))
    hold(bench, 0.6)
    release(bench)
    rest_s(bench)
    end = tool_matrix(model.matrix(bench.firmware.joints_deg), tool)
    if axis < 3:
        along = start[:3, axis] if frame is JogFrame.TOOL else [float(i == axis) for i in range(3)]
        amount = float((end - start)[:3, 3] @ along)
        assert amount > 5.0
    else:
        amount = next(a / 100 for a in range(1, 1200) if abs(_turn(start, end) - a / 100) <= 0.0051)
    reached = matrix_to_pose(end)
    assert reached == pytest.approx(matrix_to_pose(shifted(start, axis, amount, frame)), abs=0.05)
    assert AXES[axis] == bench.notices[-1].params["axis"]


def _turn(start, end):
    return math.degrees(
        math.acos(min(1.0, (float((start[:3, :3].T @ end[:3, :3]).trace()) - 1) / 2))
    )


# What takes the arm away from a hold --------------------------------------------------------------


def held(bench):
    bend(bench)
    bench.controller.jogging.start(JointJog(1, 1))
    hold(bench, 0.2)
    assert bench.controller.jogging.active
    bench.heard()
    return bench.controller


def test_the_emergency_stop_ends_it_at_once(any_bench):
    controller = held(any_bench)
    controller.emergency_stop()
    assert not controller.jogging.active
    hold(any_bench, 0.1)
    assert {frame.arbitration_id for frame in any_bench.heard()} == {0x150}
    hold(any_bench, 1.0)
    assert not controller.jogging.active


def test_disabling_ends_it(bench):
    controller = held(bench)
    controller.motors.disable()
    hold(bench, 0.1)
    assert not controller.jogging.active
    assert {frame.arbitration_id for frame in bench.heard()} == {0x471}


def test_another_command_takes_over(bench):
    controller = held(bench)
    controller.motion.go_home()
    hold(bench, 0.05)
    assert not controller.jogging.active
    assert [frame.arbitration_id for frame in bench.heard()] == [0x155, 0x156, 0x157, 0x151]


def test_speed_zero_ends_it_with_the_reason(bench):
    controller = held(bench)
    controller.motion.set_speed_percent(0)
    hold(bench, 0.05)
    assert bench.notices[-1].params["reason"].code == "speed_zero"


def test_a_program_that_was_stuck_does_not_go_on_by_itself(bench):
    controller = held(bench)
    rested = rest_s(bench)
    before = angles(bench)
    hold(bench, 0.2)
    assert rested <= 0.1
    assert not controller.jogging.active
    assert angles(bench) == before
    assert bench.notices[-1].params["reason"].code == "jog_held_up"


def test_an_arm_that_can_hear_and_not_be_heard_is_not_led_on(bench):
    controller = held(bench)
    bench.node.line.to_bus = lambda frames, now_s, dt_s: ([], len(frames))
    took_s = 0.0
    places = bench.firmware.joints_deg
    for count in range(30):
        hold(bench, TICK_S)
        if bench.firmware.joints_deg != places:
            took_s = TICK_S * (count + 1)
        places = bench.firmware.joints_deg
    assert took_s <= 0.1
    assert bench.notices[-1].params["reason"].code == "jog_no_feedback"
    assert not controller.jogging.active


def test_an_arm_that_does_not_follow_is_given_up(bench):
    controller = held(bench)
    bench.firmware._moves.take = lambda name, signals: True  # it takes no target any more
    hold(bench, 1.0)
    assert not controller.jogging.active
    assert bench.notices[-1].params["reason"].code == "jog_not_following"


def test_an_arm_in_motion_is_not_jogged(bench):
    bend(bench)
    bench.controller.motion.send_joints((100.0, *BENT_DEG[1:]))
    hold(bench, 0.2)
    bench.heard()
    assert bench.controller.jogging.start(JointJog(2, 1)) is None
    hold(bench, 0.5)
    assert bench.notices[-1].params["reason"].code == "still_moving"
    assert bench.heard() == []


def test_without_an_arm_it_is_refused(bench):
    assert bench.controller.jogging.start(JointJog(1, 1)).code == "not_connected"
    bench.connect()
    assert bench.controller.jogging.start(JointJog(1, 1)).code == "not_enabled"
    assert not bench.controller.jogging.active


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
