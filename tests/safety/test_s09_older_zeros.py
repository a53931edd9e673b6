"""An arm with the zeros before S-V1.6-3: picture, kinematics and its own pose are one answer.

Taken for one of today, its tool would be 10 mm from where the window shows it.
"""

from dataclasses import replace

import pytest

from armui.arm.models import model_data, robot_description
from armui.control.link.link_state import LinkState
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.control.run.preflight import MODEL_CHANGED_SINCE_CHECK, CheckBasis, Preflight
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import Pose, apart
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.points.program import Trajectory
from armui.viewport.process.urdf_file import load_robot
from tests.accepted import accepted
from tests.arm_rig import ArmRig
from tests.control.under_way import OUT, to
from tests.family import MODELS
from tests.moments import now

LEANING_DEG = (10.0, 60.0, -60.0, 5.0, 30.0, 0.0)
OLDER, NEWER = "S-V1.5-2", "S-V1.8-9"


def off_mm(controller, pose):
    """How far a pose is from where the arm says that its flange is."""
    return apart(Pose(*controller.state.end_pose()), pose)[0]


@pytest.mark.each_value(full="each model in both versions")
@pytest.mark.parametrize("version", [OLDER, NEWER])
@pytest.mark.parametrize("model", MODELS)
def test_picture_and_kinematics_have_the_flange_where_the_arm_says(app_driver, model, version):
    app_driver.lie(LEANING_DEG, model, version=version)
    app_driver.connect(model)
    controller = app_driver.controller
    # by the version alone, before the arm has stood for a comparison
    assert now(controller.operating_state.model_fit).older_zeros == (version == OLDER)
    app_driver.run(2.0)

    fit = now(controller.operating_state.model_fit)
    assert fit.confirmed
    assert fit.older_zeros == (version == OLDER)
    joints_deg = controller.state.angles_deg()
    assert off_mm(controller, controller.cartesian.kinematics().forward(joints_deg)) < 0.06
    assert arm_model(controller).kinematics.geometry == fit.geometry
    path = app_driver.window._robot.path
    assert path == robot_description(model, older_zeros=version == OLDER)
    shown = load_robot(path).link_poses(joints_deg, 0.0)["flange"][:3, 3] * 1e3
    assert tuple(shown) == pytest.approx(controller.state.end_pose()[:3], abs=0.06)
    mark = app_driver.find("model_mark")
    assert ("before S-V1.6-3" in mark.toolTip()) == (version == OLDER)


def test_a_check_made_for_the_other_zeros_is_outdated(rig):
    rig.lie(LEANING_DEG, version=OLDER)
    rig.connect()
    rig.run(1.0)
    arm = arm_model(rig.controller)
    request = CheckRequest(Trajectory("t", points=(to(OUT),)), arm, start_deg(rig.controller))
    outcome = check(request)
    basis = CheckBasis.of(rig.controller, RunOptions(), request.content)
    assert Preflight(request, outcome, basis).why_outdated(rig.controller, basis.options) is None
    todays = replace(arm, kinematics=Kinematics(model_data().geometry))
    outdated = Preflight(request, outcome, replace(basis, arm=todays))
    refusal = outdated.why_outdated(rig.controller, basis.options)
    assert refusal.reason == MODEL_CHANGED_SINCE_CHECK


def test_another_arm_on_the_adapter_has_its_own_zeros(app_driver):
    app_driver.lie(LEANING_DEG, version=OLDER)
    app_driver.connect()
    app_driver.run(1.0)
    app_driver.controller.disconnect_device()
    assert app_driver.window._robot.path == robot_description(PiperModel.PIPER)

    app_driver.lie(LEANING_DEG, version=NEWER)
    app_driver.connect()
    app_driver.run(1.0)
    assert not now(app_driver.controller.operating_state.model_fit).older_zeros


@pytest.mark.parametrize("version", [OLDER, NEWER])
def test_an_arm_that_names_no_version_tells_its_zeros_by_its_pose(qapp, request, version):
    rig = ArmRig(request.node.nodeid, Generation.ONE)
    rig.firmware = Firmware(Generation.ONE, joints_deg=LEANING_DEG, version=version)
    rig.node = Node(rig.firmware, rig._arm_bus)
    try:
        rig.connect()
        rig.run(1.5)
        fit = now(rig.controller.operating_state.model_fit)
        assert rig.controller.state.firmware is None
        assert fit.confirmed
        assert fit.older_zeros == (version == OLDER)
        assert rig.controller.cartesian.why_unknown() is None
    finally:
        rig.close()


def test_the_zeros_stay_what_they_are_while_the_arm_moves_fast(rig):
    """Angles and pose are heard some milliseconds apart: a moving arm decides nothing."""
    rig.lie(LEANING_DEG, version=OLDER)
    rig.connect()
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
    rig.controller.motion.set_speed_percent(100)
    accepted(rig.controller.motion.send_joints(OUT))
    older = model_data().older_geometry
    for _ in range(40):
        rig.run(0.05)
        assert rig.controller.cartesian.kinematics().geometry == older
    assert rig.firmware.joints_deg == pytest.approx(OUT, abs=0.01)


def test_the_zeros_are_kept_as_assumed_until_the_same_adapter_tells_others(rig):
    rig.lie(LEANING_DEG, version=OLDER)
    rig.connect()
    rig.run(1.0)
    rig.run_until(lambda: now(rig.controller.operating_state.model_fit).older_zeros)
    rig.unplug(OSError("gone"))
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.LOST)
    assert now(rig.controller.operating_state.model_fit).older_zeros
