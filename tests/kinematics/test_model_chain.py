"""One answer all the way: what an arm says, what the window shows, what the program computes.

1,000 random poses of each model, half of them with today's zeros and half with those before
S-V1.6-3: the simulated arm's end pose on the bus, the figures over the picture, the poses of the
picture's links (by its own way and by yourdfpy), the check's places, the inverse kinematics.
"""

import math

import numpy as np
import pytest
import yourdfpy

from armui.arm.model_check import ModelFit, fitting_arms
from armui.arm.models import ArmModel, model_data, robot_description
from armui.arm.reach import check_pose
from armui.arm.refusal import Refusal
from armui.arm.tracker import Tracker
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.forward import flange_transforms
from armui.kinematics.inverse import solutions
from armui.kinematics.poses import Pose, apart, matrix_to_pose
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.trajectory.planning.planned_path import sampled_path
from armui.viewport.hud import figures
from armui.viewport.process.urdf_file import load_robot
from tests.examples import examples
from tests.family import FACTORY_ACCELERATION_DEG_S2, MODELS, ranges

POSES = examples(500)
BUS_MM = 2e-3
"""Rounding: 0.001 mm of the pose, and 0.001° of each angle at the end of an arm of 0.8 m."""
BUS_OF_ANGLES_MM = 0.06


@pytest.fixture(params=MODELS)
def model(request):
    return request.param


@pytest.fixture(params=["S-V1.8-9", "S-V1.5-2"])
def version(request):
    return request.param


@pytest.fixture
def joints(model):
    low, high = ranges(model)
    rows = np.random.default_rng(2026).uniform(low, high, size=(POSES, 6))
    return np.round(rows, 3)


def heard_from_the_bus(model, version, joints_deg):
    """What the program's own tracker makes of a simulated arm's frames."""
    codec = Codec(Generation.TWO)
    tracker = Tracker(codec)
    arm = Firmware(Generation.TWO, joints_deg=joints_deg, model=model, version=version)
    for frame in arm.step(0.006):
        tracker.update(codec.decode(frame), 1.0)
    return tracker.snapshot()


@pytest.mark.each_value(full="each model in both versions")
@pytest.mark.timeout(240)
def test_one_answer_along_the_whole_chain(model, version, joints):
    data = model_data(model)
    fit = ModelFit(model, older_zeros=version == "S-V1.5-2")
    kinematics = Kinematics(fit.geometry)
    description = robot_description(model, older_zeros=fit.older_zeros)
    robot = load_robot(description)
    foreign = yourdfpy.URDF.load(
        str(description), load_meshes=False, build_collision_scene_graph=False
    )
    computed = flange_transforms(fit.geometry, joints)
    arm = ArmModel(
        limits=data.limits,
        accelerations_deg_s2=(FACTORY_ACCELERATION_DEG_S2,) * 6,
        end_limits=None,
        kinematics=kinematics,
        tool_mm=0.0,
    )
    checked = sampled_path(np.arange(float(POSES)), joints, np.zeros(POSES, dtype=int), arm)
    ways = solutions(fit.geometry, computed)[0]
    for index, (angles, place) in enumerate(zip(joints.tolist(), computed, strict=True)):
        state = heard_from_the_bus(model, version, angles)
        # the bus: angles as given, the pose rounded
        assert state.angles_deg() == pytest.approx(angles, abs=0.0006 + 0.002)
        told = Pose(*state.end_pose())
        arms = fitting_arms(state.angles_deg(), told, version)
        assert arms == {(model, fit.older_zeros)}, index
        off_mm, off_deg = apart(told, matrix_to_pose(place))
        assert off_mm < BUS_OF_ANGLES_MM, index
        assert off_deg < 0.02, index
        # the window's figures are those of the bus
        assert figures(state.end_pose()) == [f"{round(each, 3) + 0.0:.3f}" for each in told]
        # the picture's flange, twice
        shown = robot.link_poses(angles, 0.0)["flange"]
        assert np.linalg.norm(shown[:3, 3] * 1e3 - place[:3, 3]) < 1e-6
        assert np.abs(shown[:3, :3] - place[:3, :3]).max() < 1e-9
        foreign.update_cfg({f"joint{n}": math.radians(each) for n, each in enumerate(angles, 1)})
        theirs = foreign.get_transform("flange", "base_link")
        assert np.abs(theirs - shown).max() < 1e-9
        # the check's place, and single poses
        assert np.linalg.norm(checked.places_mm[index] - place[:3, 3]) < 1e-9
        assert np.abs(kinematics.matrix(angles) - place).max() < 1e-9
        # and back again
        own = np.abs((ways[index] - angles + 180.0) % 360.0 - 180.0).max(axis=1)
        assert np.nanmin(own) < 1e-6
        back = check_pose(kinematics, kinematics.forward(angles), angles, data.limits)
        assert not isinstance(back, Refusal)
        assert back == pytest.approx(angles, abs=1e-5)
