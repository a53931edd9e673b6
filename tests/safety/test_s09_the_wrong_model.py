"""The operator has chosen another model than the arm is: nothing is computed with wrong lengths.

Joints can be moved one by one, within the limits the arm itself has told: no length counts there.
"""

from dataclasses import replace

import pytest

from armui.arm.model_check import MODEL_OTHER
from armui.arm.models import model_data
from armui.control.motion.jog_path import ToolJog
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode
from armui.protocol.generation import PiperModel
from tests.accepted import accepted
from tests.control.under_way import OUT, run_of, to
from tests.family import MODELS
from tests.moments import now

LEANING_DEG = (10.0, 60.0, -60.0, 5.0, 30.0, 0.0)


def enable(rig):
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)


PAIRS = [(true, chosen) for true in MODELS for chosen in MODELS if true is not chosen]


@pytest.mark.parametrize(("true", "chosen"), PAIRS, ids=lambda each: each.value)
def test_a_tool_step_with_the_wrong_model_is_refused_and_sends_nothing(rig, true, chosen):
    rig.lie(LEANING_DEG, true)
    rig.connect(chosen)
    enable(rig)
    rig.heard()

    # at once, before the comparison has been made twice
    refusal = rig.controller.cartesian.step(2, 5.0, JogFrame.BASE)

    assert refusal.reason == MODEL_OTHER
    rig.run(2.0)
    fit = now(rig.controller.operating_state.model_fit)
    assert (fit.chosen, fit.other) == (chosen, true)
    for tried in (
        lambda: rig.controller.cartesian.step(0, 5.0, JogFrame.TOOL),
        lambda: rig.controller.cartesian.move((300, 0, 300, 0, 90, 0), MoveMode.MOVE_P),
        lambda: rig.controller.jogging.start(ToolJog(0, 1, JogFrame.BASE)),
    ):
        refusal = tried()
        assert refusal.reason == MODEL_OTHER
        assert refusal.params["fits"] == model_data(true).name
    rig.run(0.2)
    assert rig.heard() == []


@pytest.mark.parametrize("true", [each for each in MODELS if each is not PiperModel.PIPER])
def test_the_wrong_model_is_warned_of_once_and_never_changed(rig, true):
    rig.lie(LEANING_DEG, true)
    rig.connect()
    rig.run(10.0)

    assert rig.codes().count("model_other") == 1
    assert now(rig.controller.operating_state.model) is PiperModel.PIPER
    assert rig.controller.cartesian.kinematics().geometry == model_data(PiperModel.PIPER).geometry


@pytest.mark.each_value(full="each model in both versions")
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("version", ["S-V1.8-9", "S-V1.5-2"])
def test_the_right_model_is_confirmed_without_a_word(rig, model, version):
    rig.lie(LEANING_DEG, model, version=version)
    rig.connect(model)
    rig.run(2.0)

    assert now(rig.controller.operating_state.model_fit).confirmed
    assert "model_other" not in rig.codes()
    assert "model_none" not in rig.codes()


@pytest.mark.parametrize("true", [PiperModel.PIPER_L, PiperModel.PIPER_X])
def test_a_joint_still_moves_within_the_limits_the_arm_has_told(rig, true):
    rig.lie(LEANING_DEG, true)
    rig.connect()
    enable(rig)
    rig.run(2.0)

    assert (
        now(rig.controller.operating_state.limits)[3].max_deg
        == {
            PiperModel.PIPER_L: 127.0,
            PiperModel.PIPER_X: 89.0,
        }[true]
    )
    accepted(rig.controller.motion.jog(1, 2.0))
    rig.run(2.0)
    assert rig.firmware.joints_deg[0] == pytest.approx(12.0, abs=0.01)


def test_until_the_limits_are_read_the_model_s_table_stands_in_marked(rig):
    rig.lie(LEANING_DEG, PiperModel.PIPER_H)
    rig.controller.connect_device(replace(rig.device, model=PiperModel.PIPER_H))
    rig.step()

    operating = rig.controller.operating_state
    assert not any(operating.limits_read)
    assert [each.max_deg for each in operating.limits] == [150, 180, 0, 135, 89.5, 180]


def test_no_trajectory_begins_with_the_wrong_model(rig):
    rig.lie(LEANING_DEG, PiperModel.PIPER_H)
    rig.connect()
    enable(rig)
    rig.run(2.0)
    rig.heard()

    refusal = rig.controller.player.start(run_of(to(OUT)))

    assert refusal.reason == MODEL_OTHER
    rig.run(0.2)
    assert rig.heard() == []
