"""Streams of a client: the path between targets is ours (S29, S30, S32)."""

import itertools
import math

import pytest

from armui.control.motion.jogging import STREAM_HELD_UP
from armui.control.motion.target_stream import STREAM_DEG_S
from armui.ways.way import straight_way
from tests.interface.conftest import Desk, RawClient, until_settled, with_lease
from tests.safety.operation_places import REST_DEG

MID = [0.0, 60.0, -60.0, 0.0, 0.0, 0.0]


def place(desk, joints_deg=MID):
    desk.rig.controller.begin("motion.send", joints_deg)
    desk.rig.run_until(lambda: desk.rig.firmware.joints_deg == pytest.approx(joints_deg, abs=0.05))
    desk.rig.run(1.0)


def stream(client, desk, targets, every_s=0.02, step_s=0.01):
    """Send targets at their times; returns times with the six angles of the arm then."""
    path = []
    for target in targets:
        number = client.begin("stream.target", lease=client.lease, joints_deg=list(target))
        client.wait(lambda n=number: n in client.answers)
        for _ in range(round(every_s / step_s) - 1):
            desk.rig.step(step_s)
            path.append((desk.rig.time_s, *desk.rig.firmware.joints_deg))
    return path


def fastest_deg_s(path):
    """How fast joint 1 was at most."""
    pairs = itertools.pairwise(path)
    return max(abs(b[1] - a[1]) / (b[0] - a[0]) for a, b in pairs)


def answers(client):
    return [each.get("error", {}).get("data", {}).get("reason") for each in client.answers.values()]


@pytest.fixture
def streaming(client, desk):
    place(desk)
    return with_lease(client, desk)


def sine(seconds, amplitude=20.0, period_s=4.0, every_s=0.02):
    for step in range(round(seconds / every_s)):
        angle = amplitude * math.sin(2.0 * math.pi * step * every_s / period_s)
        yield [each + angle * (1 if joint % 2 else -1) for joint, each in enumerate(MID)]


def test_a_sine_is_followed_without_steps_back(streaming, desk):
    path = stream(streaming, desk, sine(4.0))
    assert not [each for each in answers(streaming) if each]
    steps = [b[1] - a[1] for a, b in itertools.pairwise(path)]
    moving = [each for each in steps if abs(each) > 1e-6]
    reversed_ = sum(a * b < 0.0 for a, b in itertools.pairwise(moving))
    assert len(moving) > 100
    assert reversed_ <= 4, "a sine of one period turns round twice"


def test_a_target_beyond_the_limits_is_refused_and_the_next_one_followed(streaming, desk):
    stream(streaming, desk, [[5.0, *MID[1:]]] * 20)
    stream(streaming, desk, [[170.0, *MID[1:]]] * 5)
    assert "joint_out_of_limits" in answers(streaming)
    rests = desk.rig.firmware.joints_deg[0]
    assert rests == pytest.approx(5.0, abs=0.5), "a refused target was clamped"
    assert desk.view.lease is not None
    stream(streaming, desk, [[10.0, *MID[1:]]] * 40)
    assert desk.rig.firmware.joints_deg[0] == pytest.approx(10.0, abs=0.1)


def test_the_gripper_moves_beside_it(streaming, desk):
    for step in range(20):
        stream(streaming, desk, [[float(step), *MID[1:]]])
        streaming.ask("gripper.move", lease=streaming.lease, travel=20.0 + step, effort=1.0)
    stream(streaming, desk, [[19.0, *MID[1:]]] * 40)
    assert desk.rig.firmware.joints_deg[0] == pytest.approx(19.0, abs=0.1)
    assert desk.rig.firmware.gripper.travel == pytest.approx(39.0, abs=0.5)
    begun = [each for each in streaming.told("operation") if each["state"] == "under_way"]
    assert len([each for each in begun if each["operation"] == "jog.begin"]) == 1


def test_without_a_target_it_rests_and_the_lease_stays(streaming, desk):
    stream(streaming, desk, [[40.0, *MID[1:]]] * 20)
    assert desk.rig.firmware.joints_deg[0] < 35.0
    for _ in range(10):
        streaming.begin("ping")
        desk.rig.run(0.1)
    rests = desk.rig.firmware.joints_deg[0]
    assert rests < 39.0, "it went on to the last target"
    desk.rig.run(0.3)
    assert desk.rig.firmware.joints_deg[0] == pytest.approx(rests, abs=0.01)
    assert desk.view.lease is not None


def test_a_stream_ended_by_a_gap_says_what_a_program_can_do(streaming, desk):
    """Nobody holds a button of a client's: it is told to send again, which begins anew."""
    stream(streaming, desk, [[20.0, *MID[1:]]] * 10)
    desk.rig.step(0.15)
    (ended,) = [each for each in desk.rig.events if each.code == "jog_ended"]
    assert ended.params["reason"].reason == STREAM_HELD_UP
    stream(streaming, desk, [[20.0, *MID[1:]]] * 40)
    assert "stream_held_up" in answers(streaming)
    assert desk.rig.firmware.joints_deg[0] == pytest.approx(20.0, abs=0.1)


def test_it_is_never_faster_than_a_stream_may_be(streaming, desk):
    path = stream(streaming, desk, [[100.0, *MID[1:]]] * 60)
    assert 0.75 * STREAM_DEG_S <= fastest_deg_s(path) <= 1.05 * STREAM_DEG_S


def test_the_operators_speed_holds(client, desk):
    place(desk)
    with_lease(client, desk, percent=10)
    path = stream(client, desk, [[60.0, *MID[1:]]] * 60)
    assert 10.0 <= fastest_deg_s(path) <= 0.1 * 171.9 * 1.05


def test_killed_at_full_speed_it_travels_no_further_than_promised(streaming, desk):
    stream(streaming, desk, [[140.0, *MID[1:]]] * 50)
    before = desk.rig.firmware.joints_deg[0]
    streaming.close()
    desk.rig.run(2.0)
    gone = desk.rig.firmware.joints_deg[0] - before
    assert 0.0 <= gone <= 60.0 * 0.045 + 60.0**2 / (2.0 * 286.0) + 60.0 * 0.05
    assert desk.view.lease is None


def test_into_its_own_body_it_is_refused_before(streaming, desk):
    folded = [-12.0, 83.0, -3.0, 32.0, 40.0, 70.0]  # the gripper against the base
    stream(
        streaming,
        desk,
        [
            [a + (b - a) * step / 150 for a, b in zip(MID, folded, strict=True)]
            for step in range(151)
        ],
    )
    stream(streaming, desk, [folded] * 50)
    assert {each for each in answers(streaming) if each} == {"hits_itself"}
    pose = desk.rig.firmware.joints_deg
    assert desk.rig.controller.gate.judge(straight_way(pose, pose)) is None
    assert desk.view.lease is not None
    stream(streaming, desk, [MID] * 150)
    assert desk.rig.firmware.joints_deg == pytest.approx(MID, abs=0.2), "it does not come back"


def test_a_replaced_target_is_said_to_be(streaming, desk):
    numbers = [
        streaming.begin("stream.target", lease=streaming.lease, joints_deg=[step, *MID[1:]])
        for step in range(5)
    ]
    results = [streaming.answer(number)["result"] for number in numbers]
    assert results[-1] == {}
    assert {"superseded": True} in results


def test_another_clients_targets_replace_none(streaming, connect):
    other = connect("another")
    mine = streaming.begin("stream.target", lease=streaming.lease, joints_deg=MID)
    others = [other.begin("stream.target", lease=1, joints_deg=MID) for _ in range(3)]
    for each in (streaming, other):  # the server has read them, and the window has taken none
        ping = each.begin("ping")
        while ping not in each.answers:
            assert each.read()
    assert streaming.answer(mine)["result"] == {}
    assert other.answer(others[-1])["error"]["data"]["reason"] == "lease_not_held"


def test_stream_end(streaming, desk):
    stream(streaming, desk, [[20.0, *MID[1:]]] * 10)
    assert desk.rig.controller.operating_state.jogging
    streaming.ask("stream.end", lease=streaming.lease)
    desk.rig.run(0.2)
    assert not desk.rig.controller.operating_state.jogging
    assert desk.view.lease is not None


def test_why_it_has_ended_is_the_answer_to_the_next_target(streaming, desk):
    there = [60.0, *MID[1:]]
    stream(streaming, desk, [there] * 5)
    desk.rig.firmware._moves.take_frame = lambda name, signals: True  # it takes no target any more
    stream(streaming, desk, [there] * 60)
    assert "motion_unheeded" in answers(streaming)
    assert desk.view.lease is not None


def test_an_arm_outside_its_limits_is_told_as_that_and_not_led_anywhere(rig, tmp_path):
    rig.lie(REST_DEG)
    rig.ready()
    rig.run(0.5)
    desk = Desk(rig, tmp_path / "r" / "api.sock")
    desk.switch(on=True)
    until_settled(desk)
    client = with_lease(RawClient(rig, desk.view.path), desk)
    stream(client, desk, [(5.0, 20.0, -30.0, 0.0, 20.0, 0.0)] * 5)
    assert "joints_outside" in answers(client)
    assert rig.firmware.joints_deg == pytest.approx(REST_DEG, abs=0.1)
    client.close()
    assert desk.end()
