"""The lease ends by itself and by the operator, and its end halts the arm with power on (S29)."""

import pytest

from armui.control.motion.jog_path import JointJog
from armui.control.motion.planned_motion import NOTHING_HELD
from armui.control.operating_state import StopState
from armui.protocol.codes import TrajectoryCommand
from tests.accepted import accepted
from tests.app_driver import Slow
from tests.company import OtherHost
from tests.interface.conftest import with_lease

FAR = [60.0, 60.0, -60.0, 0.0, 0.0, 0.0]
LOW = [10.0, 125.0, -60.0, 15.0, 40.0, 20.0]


def begin_motion(client, desk):
    client.ask("motion.send", lease=client.lease, angles_deg=FAR)
    desk.rig.run(0.3)
    assert desk.rig.controller.operating_state.moving


def stand_still(desk):
    desk.rig.run(1.5)
    before = tuple(desk.rig.firmware.joints_deg)
    desk.rig.run(0.5)
    assert desk.rig.firmware.joints_deg == pytest.approx(before, abs=0.05)
    return before


def reason_of(client):
    client.wait(lambda: client.told("lease"))
    return client.told("lease")[-1]["reason"]["reason"]


def release(client, desk):
    client.ask("lease.release", lease=client.lease)


def go(client, desk):
    client.close()


def silence(client, desk):
    desk.rig.run(1.2)


def take_back(client, desk):
    desk.take_back()


def switch_off(client, desk):
    desk.switch(on=False)


@pytest.mark.parametrize("end", [release, go, silence, take_back, switch_off])
def test_its_end_halts_the_motion_with_power_on(leased, desk, end):
    begin_motion(leased, desk)
    end(leased, desk)
    desk.rig.run(0.3)
    assert desk.view.lease is None
    there = stand_still(desk)
    assert there[0] < FAR[0] - 5.0, "the motion went on to its target"
    assert all(desk.rig.controller.operating_state.enabled)


@pytest.mark.parametrize("heard_again", [False, True])
def test_its_end_halts_what_went_on_in_a_silence(leased, desk, heard_again):
    """No step starts from its target any more, but the arm is on its way there."""
    begin_motion(leased, desk)
    desk.rig.node.link.mute_on.add(0x2A6)
    desk.rig.run(0.3)
    leased.ask("ping")
    desk.rig.run(0.3)
    if heard_again:
        desk.rig.node.link.mute_on.clear()
        desk.rig.run(0.1)
    assert desk.view.lease is not None
    take_back(leased, desk)
    desk.rig.run(0.3)
    there = stand_still(desk)
    assert there[0] < FAR[0] - 5.0, "the motion went on to its target"


@pytest.mark.parametrize("end", [release, go, take_back])
def test_its_end_halts_the_gripper_where_it_is(leased, desk, end):
    leased.ask("gripper.move", lease=leased.lease, travel=60.0, effort=1.0)
    desk.rig.run(0.3)
    gripper = desk.rig.firmware.gripper
    end(leased, desk)
    desk.rig.run(0.3)
    assert desk.view.lease is None
    at_end = gripper.travel
    desk.rig.run(1.0)
    assert gripper.travel == pytest.approx(at_end, abs=1.0)
    assert at_end < 50.0
    assert gripper.enabled


def emergency_stop(rig):
    rig.controller.emergency_stop()


def halt(rig):
    rig.controller.halt_and_hold()


def jog(rig):
    rig.controller.jogging.start(JointJog(1, -1))


def send(rig):
    rig.controller.begin("motion.send", [0.0, 10.0, -10.0, 0.0, 0.0, 0.0])


def disable(rig):
    rig.controller.motors.disable()


@pytest.mark.parametrize(
    ("act", "reason"),
    [
        (emergency_stop, "lease_stopped"),
        (halt, "lease_stopped"),
        (jog, "lease_operator_moved"),
        (send, "lease_operator_moved"),
        (disable, "lease_operator_moved"),
    ],
)
def test_whatever_the_operator_does_ends_it_at_once(leased, desk, act, reason):
    begin_motion(leased, desk)
    act(desk.rig)
    assert desk.view.lease is None
    assert reason_of(leased) == reason
    wrong = leased.refused("motion.send", lease=leased.lease, angles_deg=FAR)
    assert wrong["data"]["reason"] == "lease_not_held"


def test_his_motion_goes_on_undisturbed(leased, desk):
    begin_motion(leased, desk)
    send(desk.rig)
    desk.rig.run(4.0)
    assert desk.rig.firmware.joints_deg == pytest.approx((0, 10, -10, 0, 0, 0), abs=0.1)


def stream_fast(client, desk):
    """Until the setpoint leads the arm by more than a jog's."""
    rig = desk.rig
    for _ in range(30):
        client.ask("stream.target", lease=client.lease, joints_deg=[90.0, *FAR[1:]])
    stream = rig.controller.jogging._hold.stream
    assert stream.setpoint_deg[0] - rig.firmware.joints_deg[0] > 3.0


def test_his_motion_goes_on_undisturbed_beside_a_fast_stream(leased, desk):
    desk.rig.controller.motion.set_speed_percent(100)
    stream_fast(leased, desk)
    send(desk.rig)
    desk.rig.run(4.0)
    assert desk.rig.firmware.joints_deg == pytest.approx((0, 10, -10, 0, 0, 0), abs=0.1)


@pytest.mark.parametrize(
    "act",
    [
        lambda rig: rig.controller.begin("gripper.move", 20.0, 1.0),
        lambda rig: rig.controller.begin("jog.begin", JointJog(1, -1)),
    ],
    ids=["gripper", "jog"],
)
def test_what_replaces_no_motion_of_the_client_ends_it_too(leased, desk, act):
    begin_motion(leased, desk)
    act(desk.rig)
    assert desk.view.lease is None
    desk.rig.run(0.3)
    desk.rig.controller.jogging.stop()
    there = stand_still(desk)
    assert there[0] < FAR[0] - 5.0, "the client's motion went on to its target"
    assert all(desk.rig.controller.operating_state.enabled)


def test_the_operators_gripper_moves_though_the_lease_ends_by_it(leased, desk):
    begin_motion(leased, desk)
    desk.rig.controller.begin("gripper.move", 20.0, 1.0)
    desk.rig.run(3.0)
    assert desk.rig.firmware.gripper.travel == pytest.approx(20.0, abs=1.0)


def test_a_motion_that_waits_for_its_check_goes_with_the_lease(leased, desk):
    slow = Slow()
    desk.rig.controller.gate._background = slow.submit
    far = [100.0, 120.0, -120.0, 80.0, 60.0, 100.0]
    leased.ask("motion.send", lease=leased.lease, angles_deg=far)
    assert slow.waiting, "it was checked at once"
    desk.take_back()
    slow.work()
    desk.rig.run(2.0)
    assert desk.rig.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)


def test_the_motion_of_another_host_is_not_ended_with_it(leased, desk):
    host = OtherHost(desk.rig)
    host.move_to((30, 20, -20, 0, 0, 0))
    desk.rig.run(0.3)
    assert desk.view.lease is None
    desk.rig.run(5.0)
    assert desk.rig.firmware.joints_deg == pytest.approx((30, 20, -20, 0, 0, 0), abs=0.2)
    host.close()


def test_what_ends_with_the_lease_is_neither_paused_nor_continued(leased, desk):
    controller = desk.rig.controller
    begin_motion(leased, desk)
    accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    assert desk.view.lease is None
    desk.rig.run(1.0)
    assert not controller.operating_state.moving

    with_lease(leased, desk)
    begin_motion(leased, desk)
    controller.motion.set_speed_percent(0)
    desk.rig.run(0.5)
    controller.motion.set_speed_percent(30)
    assert controller.planned_motion.command(TrajectoryCommand.CONTINUE) == NOTHING_HELD()
    assert desk.view.lease is None
    assert desk.rig.codes().count("plan_sent") == 1, "that it is to end"


def test_what_the_operator_has_slowed_stays_slow(leased, desk):
    motion = desk.rig.controller.motion
    leased.ask("motion.set_speed", lease=leased.lease, percent=50)
    motion.set_speed_percent(5)
    wrong = leased.refused("motion.set_speed", lease=leased.lease, percent=6)
    assert wrong["data"]["reason"] == "lease_too_fast"
    leased.ask("motion.set_speed", lease=leased.lease, percent=4)
    assert motion.speed_percent == 4


def test_a_second_host_ends_it(leased, desk):
    host = OtherHost(desk.rig)
    host.move_to((1, 0, 0, 0, 0, 0))
    desk.rig.run(0.3)
    assert desk.view.lease is None
    assert reason_of(leased) == "other_host"
    host.close()


def test_a_silent_arm_ends_it(leased, desk):
    desk.rig.powered = False
    for _ in range(4):
        leased.begin("ping")
        desk.rig.run(0.3)
    assert desk.view.lease is None
    desk.rig.powered = True
    assert reason_of(leased) == "lease_arm_changed"


def test_another_connection_ends_it(leased, desk):
    desk.rig.controller.disconnect_device()
    desk.rig.run(0.1)
    assert desk.view.lease is None
    assert reason_of(leased) == "lease_arm_changed"


def test_nobody_there_for_half_a_minute_is_a_refusal(client, desk):
    asked = client.begin("lease.request", purpose="x", moves=True, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    for _ in range(32):
        desk.rig.run(1.0)
    assert client.answer(asked)["error"]["data"]["reason"] == "lease_not_granted"
    assert desk.view.asked is None
    desk.grant(50)
    assert desk.view.lease is None


def test_the_second_without_a_word_begins_with_the_grant(client, desk):
    """Who waits for the operator has nothing to say meanwhile."""
    client.begin("lease.request", purpose="x", moves=True, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    desk.rig.run(5.0)
    desk.grant(50)
    desk.rig.run(0.9)
    assert desk.view.lease is not None
    desk.rig.run(0.2)
    assert desk.view.lease is None


def test_two_clients_for_one_lease(leased, connect, desk):
    other = connect("other")
    wrong = other.refused("lease.request", purpose="x", moves=True, max_speed_percent=50)
    assert wrong["data"]["reason"] == "lease_taken"
    wrong = other.refused("motion.send", lease=leased.lease, angles_deg=FAR)
    assert wrong["data"]["reason"] == "lease_not_held", "the number of another's lease"


def test_stop_and_halt_need_none(client, desk):
    client.ask("halt")
    client.ask("stop")
    controller = desk.rig.controller
    desk.rig.run_until(lambda: controller.operating_state.stop is StopState.STOPPED)


def test_the_operators_speed_slows_it_and_more_than_granted_is_refused(client, desk):
    with_lease(client, desk, percent=40)
    motion = desk.rig.controller.motion
    wrong = client.refused("motion.set_speed", lease=client.lease, percent=41)
    assert wrong["data"]["reason"] == "lease_too_fast"
    wrong = client.refused("motion.set_speed", lease=client.lease, percent=1.5)
    assert wrong["message"] == "“percent” must be a whole number from 0 to 100."
    wrong = client.refused("motion.set_speed", lease=client.lease, percent=-1)
    assert wrong["data"]["reason"] == "whole_out_of_range"
    client.ask("motion.set_speed", lease=client.lease, percent=30)
    assert motion.speed_percent == 30
    motion.set_speed_percent(100)
    desk.rig.run(0.1)
    assert motion.speed_percent == 40, "above what was granted"
    assert desk.view.lease is not None, "a speed is no motion"
    motion.set_speed_percent(5)
    desk.rig.run(0.1)
    assert motion.speed_percent == 5


def test_one_without_motions_moves_nothing(client, desk):
    asked = client.begin("lease.request", purpose="lamps", moves=False, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    desk.grant(50)
    client.lease = client.answer(asked)["result"]["lease"]
    wrong = client.refused("motion.home", lease=client.lease)
    assert wrong["data"]["reason"] == "lease_moves_nothing"
    wrong = client.refused("stream.target", lease=client.lease, joints_deg=FAR)
    assert wrong["data"]["reason"] == "lease_moves_nothing"


def test_what_needs_consent_is_asked_each_time(leased, desk):
    for given in (False, True, False):
        enabled = leased.begin("motors.disable", lease=leased.lease)
        leased.wait(lambda: desk.view.consent is not None)
        assert desk.view.consent.operation == "motors.disable"
        if given:
            break
        desk.consent(given=False)
        assert leased.answer(enabled)["error"]["data"]["reason"] == "lease_declined"
        assert all(desk.rig.controller.operating_state.enabled)
    desk.consent(given=True)
    assert "number" in leased.answer(enabled)["result"]
    desk.rig.run(1.0)
    assert not any(desk.rig.controller.operating_state.enabled)


def test_below_the_floor_it_is_the_operator_who_agrees(leased, desk):
    rig = desk.rig
    low = leased.refused("motion.send", lease=leased.lease, angles_deg=LOW)
    assert low["data"]["reason"] == "leads_below"
    agreed = -low["data"]["figures"]["value"]
    sent = leased.begin("motion.send", lease=leased.lease, angles_deg=LOW, agreed_mm=agreed)
    leased.wait(lambda: desk.view.consent is not None)
    assert desk.view.consent.arguments["agreed_mm"] == agreed
    rig.run(0.3)
    assert rig.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)
    desk.consent(given=True)
    assert "number" in leased.answer(sent)["result"]
    leased.wait(lambda: rig.firmware.joints_deg[1] > 30.0)


@pytest.mark.parametrize("height_mm", [5.0, -6000.0])
def test_a_height_that_nobody_can_agree_to_is_refused_unasked(leased, desk, height_mm):
    low = leased.refused("motion.send", lease=leased.lease, angles_deg=LOW, agreed_mm=height_mm)
    assert low["data"]["reason"] == "figure_out_of_range"
    assert desk.view.consent is None


def test_a_consent_of_an_ended_lease_does_nothing(leased, desk):
    leased.begin("motors.disable", lease=leased.lease)
    leased.wait(lambda: desk.view.consent is not None)
    desk.take_back()
    desk.consent(given=True)
    desk.rig.run(1.0)
    assert all(desk.rig.controller.operating_state.enabled)


def test_granted_for_the_session_it_is_not_asked_again(client, desk):
    asked = client.begin("lease.request", purpose="x", moves=True, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    desk.grant(50, for_session=True)
    lease = client.answer(asked)["result"]["lease"]
    client.ask("lease.release", lease=lease)
    again = client.ask("lease.request", purpose="x", moves=True, max_speed_percent=50)
    assert again["lease"] > lease
    client.ask("lease.release", lease=again["lease"])
    client.begin("lease.request", purpose="x", moves=True, max_speed_percent=60)
    client.wait(lambda: desk.view.asked is not None)


def test_granted_without_motions_for_the_session_it_is_asked_before_it_moves(client, desk):
    asked = client.begin("lease.request", purpose="lamps", moves=False, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    desk.grant(50, for_session=True)
    client.ask("lease.release", lease=client.answer(asked)["result"]["lease"])
    client.begin("lease.request", purpose="moves", moves=True, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    assert desk.view.lease is None


def test_events_name_client_and_operation(leased, desk):
    leased.ask("motion.send", lease=leased.lease, angles_deg=FAR)
    told = {event.code: event.params for event in desk.rig.events}
    assert "a script" in told["lease_asked"]["client"]
    assert "a script" in told["client_asks"]["client"]
    assert told["lease_granted"]["percent"] == 100


@pytest.mark.parametrize("act", ["halt_and_hold", "emergency_stop", "end_all_motion"])
def test_what_was_granted_for_the_session_ends_when_the_operator_steps_in(client, desk, act):
    asked = client.begin("lease.request", purpose="a", moves=True, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    desk.grant(50, for_session=True)
    client.answer(asked)
    getattr(desk.rig.controller, act)()
    client.wait(lambda: desk.view.lease is None)
    client.begin("lease.request", purpose="a", moves=True, max_speed_percent=50)
    client.wait(lambda: desk.view.asked is not None)
    assert desk.view.lease is None
