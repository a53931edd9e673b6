"""What an arm tells decides which model it is: from 100 standing poses of each simulated arm."""

import numpy as np
import pytest

from armui.arm.model_check import MODEL_DIFFERS, MODEL_OTHER, ModelFit, fitting_arms, fitting_models
from armui.arm.models import model_data
from armui.kinematics.forward import flange_transforms
from armui.protocol.codec import Codec, Message
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from tests.family import MODELS, ranges

NEWER, OLDER = "S-V1.8-9", "S-V1.5-2"


def standing_poses(model, count, seed):
    low, high = ranges(model)
    return np.random.default_rng(seed).uniform(low, high, size=(count, 6)).tolist()


def told(model, version, joints_deg):
    """What a simulated arm that stands there says: its angles and its pose, in the bus's steps."""
    codec = Codec(Generation.TWO)
    heard = {}
    for frame in Firmware(Generation.TWO, joints_deg=joints_deg, version=version, model=model).step(
        0.03
    ):
        message = codec.decode(frame)
        if isinstance(message, Message):
            heard[message.name] = message.signals
    angles = [
        heard[f"JointFeedback{pair}"][f"J{joint}"] for pair in ("12", "34", "56") for joint in pair
    ]
    pose = [
        heard[f"EndPose{part}"][axis]
        for part, axes in ((1, ("X", "Y")), (2, ("Z", "RX")), (3, ("RY", "RZ")))
        for axis in axes
    ]
    return angles, pose


@pytest.mark.each_value(full="each model in both versions")
@pytest.mark.parametrize("version", [NEWER, OLDER])
@pytest.mark.parametrize("model", MODELS)
def test_the_right_model_is_said_from_100_poses(model, version):
    for joints_deg in standing_poses(model, 100, 3):
        angles, pose = told(model, version, joints_deg)
        assert fitting_models(angles, pose, version) == {model}, joints_deg


@pytest.mark.each_value(full="each model in both versions")
@pytest.mark.parametrize("version", [NEWER, OLDER])
@pytest.mark.parametrize("model", MODELS)
def test_an_arm_that_tells_no_version_is_never_taken_for_another_alone(model, version):
    """Of both conventions of the zeros the right one counts, too."""
    alone = 0
    for joints_deg in standing_poses(model, 100, 4):
        angles, pose = told(model, version, joints_deg)
        fitting = fitting_models(angles, pose, None)
        assert model in fitting, joints_deg
        alone += fitting == {model}
    assert alone >= 99


@pytest.mark.parametrize(("version", "zeros"), [(NEWER, OLDER), (OLDER, NEWER)])
@pytest.mark.parametrize("model", MODELS)
def test_an_arm_with_other_zeros_than_its_version_has_tells_them_by_its_pose(model, version, zeros):
    for joints_deg in standing_poses(model, 20, 5):
        angles, pose = told(model, zeros, joints_deg)
        fitting = fitting_arms(angles, pose, version)
        assert fitting == {(model, zeros == OLDER)}, joints_deg


def test_what_the_comparison_says_of_the_choice():
    piper, longer = PiperModel.PIPER, PiperModel.PIPER_L
    assert ModelFit(piper).wrong is None
    assert ModelFit(piper, frozenset({piper})).confirmed
    assert ModelFit(piper, frozenset({piper, longer})).wrong is None
    assert not ModelFit(piper, frozenset({piper, longer})).confirmed
    assert ModelFit(piper, frozenset({longer})).other is longer
    wrong = ModelFit(piper, frozenset({longer})).wrong
    assert (wrong.reason, wrong.params) == (
        MODEL_OTHER,
        {"chosen": "PiPER", "fits": "PiPER L"},
    )
    assert ModelFit(piper, frozenset()).wrong.reason == MODEL_DIFFERS
    assert ModelFit(piper, frozenset()).other is None


def test_the_reference_figures_hold():
    """The models are as far apart as the facts say, so that a millimetre decides."""
    rng = np.random.default_rng(8)
    joints = rng.uniform(*ranges(PiperModel.PIPER), size=(20_000, 6))
    flanges = {model: flange_transforms(model_data(model).geometry, joints) for model in MODELS}
    for one in MODELS:
        for other in MODELS[: MODELS.index(one)]:
            apart_mm = np.linalg.norm(flanges[one][:, :3, 3] - flanges[other][:, :3, 3], axis=1)
            turned = flanges[one][:, :3, :3].swapaxes(1, 2) @ flanges[other][:, :3, :3]
            cosines = (np.trace(turned, axis1=1, axis2=2) - 1.0) / 2.0
            differs = (apart_mm > 8.0) | (cosines < 0.5)
            assert differs.all(), (one, other)
