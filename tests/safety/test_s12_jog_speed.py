"""S12: a jog and a step are as fast as the top bar shows, whichever buttons they are pressed on."""

import pytest

from armui.control.motion.jog_pace import BRAKING_S
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.kinematics.axes import JogFrame
from tests.accepted import accepted
from tests.safety.speeds import fastest_deg_s, ready_at

HERE = (0.0, 60.0, -60.0, 0.0, 40.0, 0.0)
SLACK = 1.1
REST_S = 0.1
"""What the arm has been told by then is driven."""


@pytest.fixture
def ready(any_rig):
    return ready_at(any_rig, HERE)


def told(rig):
    return [frame.data[2] for frame in rig.heard() if frame.arbitration_id == 0x151]


def highest_deg_s(rig):
    """Of a jog of joint 1 at 100 %: it must brake within its time."""
    heard = rig.controller.state.accelerations_deg_s2[0]
    return (heard.value if heard is not None else 286.5) * BRAKING_S


@pytest.mark.each_value(full="each jog in both generations")
@pytest.mark.parametrize("jog", [JointJog(1, 1), ToolJog(1, 1, JogFrame.BASE)])
def test_a_lower_percentage_slows_a_held_jog_at_once(ready, jog):
    rig = ready
    accepted(rig.controller.jogging.start(jog))
    before = fastest_deg_s(rig, 1.0)
    assert before > 3.0, rig.codes()
    accepted(rig.controller.motion.set_speed_percent(10))
    rig.run(REST_S)
    slowed = fastest_deg_s(rig, 0.5)
    assert rig.controller.jogging.active, "it goes on, slower"
    assert 0.0 < slowed <= SLACK * 0.1 * max(before, highest_deg_s(rig))


def test_the_arm_is_told_the_lower_percentage_before_the_next_target(ready):
    rig = ready
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.run(0.5)
    rig.heard()
    accepted(rig.controller.motion.set_speed_percent(10))
    rig.run(0.1)
    heard = [frame.arbitration_id for frame in rig.heard()]
    assert heard.index(0x151) < heard.index(0x155)


def test_a_jog_at_a_share_is_as_slow_from_the_beginning(ready):
    rig = ready
    rig.controller.motion.set_speed_percent(20)
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    assert 0.0 < fastest_deg_s(rig, 1.0) <= SLACK * 0.2 * highest_deg_s(rig)


def test_a_lower_percentage_slows_a_step_under_way_at_once(ready):
    rig = ready
    accepted(rig.controller.motion.jog(1, 60.0))
    rig.run(0.2)
    assert fastest_deg_s(rig, 0.1) > 20.0
    rig.heard()
    accepted(rig.controller.motion.set_speed_percent(5))
    rig.step()
    assert told(rig) == [5]
    rig.run(0.5)  # it brakes from where it was
    assert fastest_deg_s(rig, 0.3) <= SLACK * 0.05 * 180.0
