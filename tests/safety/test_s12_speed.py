"""S12: the arm is never faster than the window shows because of order or loss."""

import pytest

from armui.control.motion.jog_path import JointJog
from armui.protocol.frame import Frame

HERE = (0.0, 30.0, -30.0, 0.0, 0.0, 0.0)
FAR = (140.0, 30.0, -30.0, 0.0, 0.0, 0.0)


@pytest.fixture
def ready(any_rig):
    any_rig.ready()
    any_rig.controller.motion.set_speed_percent(100)
    assert any_rig.controller.motion.send_joints(HERE) is None
    any_rig.run(2.5)
    any_rig.heard()
    return any_rig


def fastest_deg_s(rig, seconds):
    """The highest speed of joint 1 in that time, measured at the arm."""
    most = 0.0
    for _ in range(round(seconds / 0.02)):
        rig.step()
        most = max(most, abs(rig.firmware.mechanics.speeds_deg_s[0]))
    return most


def test_a_lower_percentage_goes_out_before_the_targets(ready):
    rig = ready
    rig.controller.motion.speed_percent = 5  # chosen while it could not be told
    assert rig.controller.motion.send_joints(FAR) is None
    rig.step()

    assert [frame.arbitration_id for frame in rig.heard()] == [0x151, 0x155, 0x156, 0x157, 0x151]


def test_a_higher_percentage_goes_out_after_the_targets(ready):
    rig = ready
    rig.controller.motion.set_speed_percent(5)
    rig.step()
    rig.heard()
    rig.controller.motion.speed_percent = 100
    assert rig.controller.motion.send_joints(FAR) is None
    rig.step()

    assert [frame.arbitration_id for frame in rig.heard()] == [0x155, 0x156, 0x157, 0x151]


def test_a_motion_whose_mode_word_is_lost_is_as_slow_as_shown(ready):
    rig = ready
    rig.controller.motion.speed_percent = 5
    rig.node.link.lose_to_arm(0x151)  # one of the two
    assert rig.controller.motion.send_joints(FAR) is None

    assert fastest_deg_s(rig, 3.0) < 1.5 * 0.05 * 172.0


def test_a_motion_that_is_measured_too_fast_is_ended_and_said(ready):
    rig = ready
    rig.controller.motion.speed_percent = 5
    rig.node.link.lose_to_arm(0x151, 2)  # both
    assert rig.controller.motion.send_joints(FAR) is None
    rig.run(2.0)

    assert "motion_too_fast" in rig.codes()
    assert not rig.firmware.mechanics.moving
    assert rig.firmware.mechanics.positions_deg[0] < 40.0


def test_a_motion_at_its_own_speed_is_left_alone(ready):
    rig = ready
    for percent, target in ((100, FAR), (30, HERE), (100, FAR), (5, HERE)):
        rig.controller.motion.set_speed_percent(percent)
        assert rig.controller.motion.send_joints(target) is None
        rig.run(1.2)  # the next motion replaces one under way

    assert "motion_too_fast" not in rig.codes()


def test_after_a_jog_the_operators_speed_is_back_in_the_arm(ready):
    rig = ready
    assert rig.controller.jogging.start(JointJog(6, 1)) is None
    rig.run(0.5)
    assert rig.firmware.condition.speed_percent < 100
    rig.controller.jogging.stop()
    rig.run(1.2)

    assert rig.firmware.condition.speed_percent == 100


def test_it_is_not_given_back_while_another_host_has_set_its_own(rig, other_host):
    rig.ready()
    assert rig.controller.jogging.start(JointJog(6, 1)) is None
    rig.run(0.5)
    rig.controller.jogging.stop()
    other_host.speed(70)
    rig.run(0.1)
    rig.heard()
    rig.run(5.0)

    assert rig.firmware.condition.speed_percent == 70
    assert not [frame for frame in rig.heard() if frame.arbitration_id == 0x151]


def test_the_percentage_told_is_the_one_shown(ready):
    rig = ready
    rig.controller.motion.set_speed_percent(42)
    rig.step()

    assert rig.heard() == [Frame(0x151, bytes.fromhex("01 01 2A 00 00 00 00 00"))]
