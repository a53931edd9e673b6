"""S9: no motion frame leaves unless the status and all six joint angles are heard."""

import pytest

from armui.arm.frames import JogFrame
from armui.control.jog_ways import JointJog
from armui.protocol.codes import MoveMode
from tests.safety.talk import MOTION_IDS

A = (30.0, 30.0, -30.0, 0.0, 0.0, 0.0)


@pytest.fixture
def ready(any_bench):
    any_bench.ready()
    assert any_bench.controller.motion.send_joints(A) is None
    any_bench.run(4.0)
    any_bench.heard()
    return any_bench


@pytest.mark.parametrize("silent", [0x2A1, 0x2A5, 0x2A6, 0x2A7])
def test_nothing_moves_an_arm_that_is_not_heard(ready, silent):
    bench, controller = ready, ready.controller
    bench.node.line.mute_on.add(silent)
    bench.run(0.7)
    assert controller.situation.link.name == "ONLINE"

    refusals = [
        controller.motion.jog(6, 1.0),
        controller.motion.send_joints(A),
        controller.motion.go_home(),
        controller.cartesian.step(2, 1.0, JogFrame.BASE),
        controller.cartesian.move((300, 0, 300, 0, 90, 0), MoveMode.MOVE_P),
    ]
    controller.motion.set_speed_percent(80)
    bench.run(0.5)

    assert [refusal.code for refusal in refusals] == ["feedback_silent"] * len(refusals)
    assert {refusal.params["frames"] for refusal in refusals} == {f"0x{silent:X}"}
    assert not [frame for frame in bench.heard() if frame.arbitration_id in MOTION_IDS]


def test_a_jog_ends_when_the_angles_fall_silent(ready):
    bench, controller = ready, ready.controller
    assert controller.jogging.start(JointJog(6, 1)) is None
    bench.run(0.3)
    bench.node.line.mute_on.update({0x2A5, 0x2A6, 0x2A7})
    bench.run(0.12)

    assert not controller.jogging.active


def test_the_word_for_it_names_every_frame_that_is_missing(ready):
    bench = ready
    bench.node.line.mute_on.update({0x2A1, 0x2A6})
    bench.run(0.7)

    assert bench.controller.situation.cannot_move.params["frames"] == "0x2A1, 0x2A6"
