"""The company on the test rig's bus: what it says, when, and what the arms make of it."""

import pytest

from armui.protocol.codes import ControlMode
from tests.accepted import accepted
from tests.company import OtherArm
from tests.sim.talk import ENABLE, mode, target, tell, text

THERE = (20.0, 30.0, -30.0, 10.0, -20.0, 30.0)


@pytest.fixture
def second_arm(rig):
    arm = OtherArm(rig)
    yield arm
    arm.close()


@pytest.fixture
def leader(rig):
    arm = OtherArm.leader(rig)
    yield arm
    arm.close()


def heard(rig):
    return [text(each) for each in rig.node.heard]


def test_a_stream_keeps_its_rate_by_the_rig_s_clock(rig, other_host):
    stream = other_host.stream_targets(lambda t_s: (t_s, 0, 0, 0, 0, 0), rate_hz=200.0)
    rig.run(0.5)
    assert stream.rounds == 100
    told = [line for line in heard(rig) if line.startswith("155#")]
    # 0, 5, 10 ms … as 0.000°, 0.005°, 0.010°
    assert told[:3] == ["155#0000000000000000", "155#0000000500000000", "155#0000000A00000000"]
    assert len(told) == 100
    stream.end()
    rig.run(0.5)
    assert stream.rounds == 100


def test_a_slow_stream_speaks_at_once_and_then_every_period(rig, other_host):
    stream = other_host.stream(lambda t_s: [mode(round(t_s))], rate_hz=1.0)
    rig.step(0.02)
    assert heard(rig) == ["151#0101000000000000"]
    rig.run(2.0)
    assert heard(rig)[1:] == ["151#0101010000000000", "151#0101020000000000"]
    assert stream.rounds == 3


def test_a_host_in_mit_and_its_speed_without_it(rig, other_host):
    tell(rig.firmware, ENABLE)
    other_host.speed(30, move=6, mit=True)
    rig.step()
    assert rig.firmware.condition.direct
    other_host.speed(30)
    rig.step()
    assert not rig.firmware.condition.direct


def test_a_second_arm_has_its_own_feedback_and_obeys_its_own_targets(rig, second_arm):
    rig.ready()
    assert second_arm.firmware.enabled == (True,) * 6  # 0x471 has no offset
    accepted(rig.controller.motion.send_joints(THERE))
    rig.run(1.5)
    assert rig.firmware.joints_deg == pytest.approx(THERE, abs=0.01)
    assert second_arm.firmware.joints_deg == (0.0,) * 6
    # 0x161, 0x165–0x167
    other = [line.replace("15", "16", 1) for line in [mode(50), *target(*THERE)]]
    rig.node.heard.clear()
    tell(second_arm.firmware, *other)
    rig.run(1.5)
    assert second_arm.firmware.joints_deg == pytest.approx(THERE, abs=0.01)
    assert {each.arbitration_id for each in rig.node.heard} >= {0x2B1, 0x2B5, 0x2B6, 0x2B7}


def test_a_leader_leads_the_rig_s_arm(rig, leader):
    tell(rig.firmware, ENABLE)
    leader.firmware.hand_guiding.lead_to(THERE, speed_deg_s=40.0)
    rig.run(2.0)
    assert rig.firmware.joints_deg == pytest.approx(THERE, abs=0.01)
    assert rig.firmware.condition.control_mode is ControlMode.CAN_CONTROL
    said = {each.arbitration_id for each in rig.node.heard}
    assert said == {0x151, 0x155, 0x156, 0x157, 0x159}


def test_the_drivers_of_a_leader_may_go_on_sending(rig, leader):
    leader.firmware.drivers_tell = True
    rig.run(0.2)
    said = {each.arbitration_id for each in rig.node.heard}
    # each arm leaves out what it says itself, and 0x251–0x266 are both arms': look at the sender
    assert {each.arbitration_id for each in leader.firmware.step(0.2)} >= {0x251, 0x256, 0x261}
    assert 0x151 in said


def test_one_frame_of_a_command_gets_lost_on_demand(rig):
    rig.ready()
    rig.node.link.lose_to_arm(0x156)
    accepted(rig.controller.motion.send_joints(THERE))
    rig.run(0.2)
    assert 0x156 not in {each.arbitration_id for each in rig.node.heard}
    assert 0x155 in {each.arbitration_id for each in rig.node.heard}


def test_one_message_falls_silent_on_demand(rig):
    rig.connect()
    rig.node.link.mute_on.add(0x2A1)
    rig.run(1.0)
    now_s = rig.time_s
    state = rig.controller.state
    assert now_s - state.status.at_s == pytest.approx(1.0, abs=0.1)
    assert now_s - state.last_feedback_s < 0.1
