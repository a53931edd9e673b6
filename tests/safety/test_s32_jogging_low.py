"""S32, S16: jogging below the base plane is said, and ends where the operator wants it to."""

import pytest
from PySide6.QtWidgets import QCheckBox, QSpinBox

from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.motion.steered_path import SteeredJog
from armui.control.safety.recovery_steps import StepKind
from armui.kinematics.axes import JogFrame
from armui.kinematics.forward import flange_rows
from armui.trajectory.planning.check import CheckRequest, check
from armui.ui import words
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.words import findings
from armui.ways.rules import TOO_LOW
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, bend, hold
from tests.family import PIPER
from tests.moments import now
from tests.trajectory.arms import ARM, joint, run

REACH_MM = ARM.tool_mm
DOWN = {
    "tool": ToolJog(2, -1, JogFrame.BASE),
    "joint": JointJog(2, 1),
    "gamepad": SteeredJog((0.0, 0.0, -1.0, 0.0, 0.0, 0.0), JogFrame.BASE, "pad"),
    "gamepad by joints": SteeredJog((0.0, 1.0, 0.0, 0.0, 0.0, 0.0), None, "pad"),
}
LOW_DEG = (10.0, 115.0, -60.0, 15.0, 40.0, 20.0)


def tip_mm(joints_deg):
    rows = flange_rows(PIPER, joints_deg)
    return rows[11] + min(0.0, REACH_MM * rows[10])


def hold_down(rig, jog, seconds):
    for _ in range(round(seconds / 0.02)):
        if isinstance(jog, SteeredJog):
            rig.controller.jogging.steer(jog)
        hold(rig, 0.02)


@pytest.mark.parametrize("jog", DOWN.values(), ids=DOWN)
def test_a_jog_ends_at_the_lowest_height(rig, jog):
    bend(rig)
    limit = round(tip_mm(BENT_DEG)) - 15
    rig.controller.jog_floor.lowest_mm = limit
    accepted(rig.controller.jogging.start(jog))
    hold_down(rig, jog, 4.0)
    assert not rig.controller.jogging.active
    assert limit <= tip_mm(rig.firmware.joints_deg) < limit + 2.0
    (ended,) = [each for each in rig.events if each.code == "jog_ended"]
    assert ended.params["reason"].reason == TOO_LOW
    assert ended.params["reason"].params["minimum"] == limit
    assert f"motions end at {limit} mm" in words.refusal(ended.params["reason"])


def test_without_a_limit_it_goes_on(rig):
    bend(rig)
    accepted(rig.controller.jogging.start(DOWN["tool"]))
    hold(rig, 1.5)
    assert rig.controller.jogging.active
    assert tip_mm(rig.firmware.joints_deg) < tip_mm(BENT_DEG) - 40.0


def test_an_arm_below_its_limit_only_goes_up(rig):
    bend(rig)
    rig.controller.jog_floor.lowest_mm = round(tip_mm(BENT_DEG)) + 50
    rig.controller.jogging.start(DOWN["tool"])
    hold(rig, 0.3)
    assert not rig.controller.jogging.active
    accepted(rig.controller.jogging.start(ToolJog(2, 1, JogFrame.BASE)))
    hold(rig, 0.5)
    assert rig.controller.jogging.active
    assert tip_mm(rig.firmware.joints_deg) > tip_mm(BENT_DEG) + 10.0


def test_single_steps_keep_to_it(rig):
    bend(rig)
    controller = rig.controller
    controller.jog_floor.lowest_mm = round(tip_mm(BENT_DEG)) + 5
    rig.run(0.1)  # set above the arm, it is told as a zone put around the arm is
    step = controller.recovery.step
    assert (step.kind, step.params["value"]) == (StepKind.BELOW_LOWEST, 5)
    controller.jog_floor.lowest_mm -= 10
    rig.run(0.1)
    assert controller.recovery.step.kind is StepKind.READY
    for step in (
        lambda: controller.motion.jog(2, 10.0),
        lambda: controller.cartesian.step(2, -20.0, JogFrame.BASE),
    ):
        rig.heard()
        refusal = step()
        assert refusal.reason == TOO_LOW
        assert rig.heard() == []
    accepted(controller.motion.jog(2, -10.0))


def test_below_the_base_plane_is_amber_in_the_line(rig):
    bend(rig, LOW_DEG)
    below = -tip_mm(LOW_DEG)
    assert below > 20.0
    step = rig.controller.recovery.step
    assert step.kind is StepKind.BELOW_BASE
    assert step.params["value"] == round(below)
    assert f"{round(below)} mm below" in words.step(step)
    rig.controller.motion.send_joints(BENT_DEG)
    rig.run_until(lambda: rig.controller.recovery.step.kind is StepKind.READY)
    assert rig.controller.operating_state.below_base_mm is None


FOLDED_DEG = (10.0, 123.0, -8.0, 15.0, 58.0, 20.0)
STRETCHED_DEG = (10.0, 44.0, -5.0, 15.0, 20.0, 20.0)


def test_the_check_blames_the_way_and_not_the_row():
    assert tip_mm(LOW_DEG) < 0.0 < min(map(tip_mm, (BENT_DEG, FOLDED_DEG, STRETCHED_DEG)))
    report = check(CheckRequest(run(joint(*BENT_DEG), joint(*BENT_DEG)), ARM, LOW_DEG))
    assert [each.code for each in report.findings] == ["far_from_start"], "it comes up"
    report = check(CheckRequest(run(joint(*STRETCHED_DEG)), ARM, FOLDED_DEG))
    (low,) = [each for each in report.findings if each.code == "below_floor"]
    assert low.approach
    assert "On the way there from where the arm stands now" in findings.finding(low)
    report = check(CheckRequest(run(joint(*LOW_DEG), joint(*BENT_DEG)), ARM, BENT_DEG))
    found = [each for each in report.findings if each.code == "below_floor"]
    assert [(each.row, each.approach) for each in found] == [(0, False)]


def test_a_run_below_the_chosen_height_is_refused():
    """What was chosen for motions holds for runs, too: nobody can accept it away."""
    program = run(joint(*BENT_DEG), joint(*LOW_DEG))
    lowest_mm = tip_mm(LOW_DEG) + 5.0
    (low,) = check(CheckRequest(program, ARM, BENT_DEG, lowest_mm=lowest_mm)).errors
    assert (low.code, low.row) == ("below_lowest", 1)
    assert low.params["value"] == pytest.approx(tip_mm(LOW_DEG), abs=0.06)
    lower = CheckRequest(program, ARM, BENT_DEG, lowest_mm=tip_mm(LOW_DEG) - 5.0)
    assert check(lower).errors == ()


def test_the_operator_chooses_the_height(app_driver):
    assert now(app_driver.store.settings.jog_floor_mm) is None
    assert app_driver.controller.jog_floor.lowest_mm is None
    app_driver.window.pages.show("settings")
    dialog = app_driver.dialog(SettingsDialog)
    spin = dialog.findChild(QSpinBox, "jog_floor_spin")
    assert not spin.isEnabled()
    app_driver.click(dialog.findChild(QCheckBox, "jog_floor_box"))
    assert now(app_driver.store.settings.jog_floor_mm) == 0
    spin.setValue(-30)
    assert now(app_driver.controller.jog_floor.lowest_mm) == -30
    app_driver.click(dialog.findChild(QCheckBox, "jog_floor_box"))
    assert now(app_driver.store.settings.jog_floor_mm) is None
