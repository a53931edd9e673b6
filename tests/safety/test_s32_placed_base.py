"""S32, S16: with the base placed in the room, floor and sinking are those of the room."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from armui.cell.area_check import AreaCheck, carried_body
from armui.cell.cell import Cell, placed
from armui.cell.placement import Placement
from armui.cell.work_area import Area, AreaBox
from armui.control.cell.cell_reasons import CELL_NOT_CONFIRMED, CELL_WHILE_MOVING
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.operating_state import JOG_UNDER_WAY
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.control.run.preflight import CHANGED_SINCE_CHECK, CheckBasis, Preflight
from armui.control.safety.recovery_steps import StepKind
from armui.kinematics.axes import JogFrame
from armui.kinematics.forward import flange_rows
from armui.protocol.generation import PiperModel
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.points.program import Trajectory
from armui.ways.rules import TOO_LOW
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, bend, hold
from tests.control.under_way import OUT, to
from tests.family import PIPER
from tests.safety.test_s15_the_cell_is_confirmed import Kept
from tests.trajectory.arms import ARM, joint, run

HANGING = Placement((0.0, 0.0, 1000.0, 180.0, 0.0, 0.0))
ASLANT = Placement((50.0, 0.0, 300.0, 70.0, -20.0, 30.0))
ON_THE_FLOOR = Placement((10.0, 0.0, 0.0, 0.0, 0.0, 0.0))


def lowest_mm(joints_deg, placement):
    """The lower of flange and fingertip in the room, by SciPy."""
    rows = np.reshape(flange_rows(PIPER, joints_deg), (3, 4))
    places = np.array([rows[:, 3], rows[:, 3] + ARM.tool_mm * rows[:, 2]])
    turn = Rotation.from_euler("xyz", placement.pose[3:], degrees=True)
    return float((turn.apply(places) + placement.pose[:3])[:, 2].min())


@pytest.mark.parametrize("placement", [HANGING, ASLANT], ids=["hanging", "aslant"])
def test_a_jog_ends_at_the_lowest_height_over_the_floor_of_the_room(rig, placement):
    bend(rig)
    accepted(rig.controller.cell.take(placed(Cell("bench"), placement)))
    limit = round(lowest_mm(BENT_DEG, placement)) - 15
    rig.controller.jog_floor.lowest_mm = limit
    down = np.array(placement.rising[:3])
    axis = int(np.abs(down).argmax())
    jog = ToolJog(axis, -1 if down[axis] > 0.0 else 1, JogFrame.BASE)
    accepted(rig.controller.jogging.start(jog))
    hold(rig, 4.0)
    assert not rig.controller.jogging.active
    assert limit <= lowest_mm(rig.firmware.joints_deg, placement) < limit + 2.0
    (ended,) = [each for each in rig.events if each.code == "jog_ended"]
    assert ended.params["reason"].reason == TOO_LOW


def test_single_steps_keep_to_it(rig):
    bend(rig)
    accepted(rig.controller.cell.take(placed(Cell("bench"), HANGING)))
    rig.controller.jog_floor.lowest_mm = round(lowest_mm(BENT_DEG, HANGING)) - 5
    rig.heard()
    assert rig.controller.cartesian.step(2, 20.0, JogFrame.BASE).reason == TOO_LOW
    assert rig.heard() == []
    accepted(rig.controller.cartesian.step(2, -20.0, JogFrame.BASE))


def test_below_the_floor_is_said_in_the_line(rig):
    bend(rig)
    low = replace(HANGING, pose=(0.0, 0.0, 200.0, 180.0, 0.0, 0.0))
    accepted(rig.controller.cell.take(placed(Cell("bench"), low)))
    rig.run(0.1)
    step = rig.controller.recovery.step
    assert step.kind is StepKind.BELOW_BASE
    assert step.params["value"] == round(-lowest_mm(BENT_DEG, low))
    accepted(rig.controller.cell.change(placed(rig.controller.cell.cell, HANGING)))
    rig.run(0.1)
    assert rig.controller.recovery.step.kind is StepKind.READY


def found_mm(placement):
    arm = replace(ARM, rising=placement.rising)
    report = check(CheckRequest(run(joint(*BENT_DEG), joint(*BENT_DEG)), arm, BENT_DEG))
    return {each.params["value"] for each in report.findings if each.code == "below_floor"}


def test_the_check_of_a_run_asks_for_the_floor_of_the_room():
    assert found_mm(Placement()) == found_mm(HANGING) == found_mm(ASLANT) == set()
    for turns in ((180.0, 0.0, 0.0), (70.0, -20.0, 30.0)):
        low = Placement((0.0, 0.0, -300.0, *turns))
        assert found_mm(low) == {round(-lowest_mm(BENT_DEG, low), 1)}


def test_a_check_made_with_the_base_elsewhere_is_outdated(rig):
    bend(rig)
    bench = placed(Cell("bench"), ON_THE_FLOOR)
    accepted(rig.controller.cell.take(bench))
    options = RunOptions()
    arm = arm_model(rig.controller)
    assert arm.rising == ON_THE_FLOOR.rising
    request = CheckRequest(Trajectory("t", points=(to(OUT),)), arm, start_deg(rig.controller))
    checked = Preflight(
        request, check(request), CheckBasis.of(rig.controller, options, request.content)
    )
    assert checked.why_outdated(rig.controller, options) is None
    accepted(rig.controller.cell.change(placed(bench, ASLANT)))
    assert checked.why_outdated(rig.controller, options).reason == CHANGED_SINCE_CHECK
    accepted(rig.controller.cell.change(bench))
    assert checked.why_outdated(rig.controller, options) is None


def test_the_base_is_not_placed_anew_while_the_arm_moves(rig):
    bend(rig)
    bench = placed(Cell("bench"), ON_THE_FLOOR)
    accepted(rig.controller.cell.take(bench))
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    hold(rig, 0.3)
    refusal = rig.controller.cell.change(placed(bench, ASLANT))
    assert refusal.reason in {JOG_UNDER_WAY, CELL_WHILE_MOVING}
    assert rig.controller.cell.rising == ON_THE_FLOOR.rising
    rig.controller.jogging.stop()


def test_a_cell_that_only_places_the_base_is_confirmed_before_anything_moves(rig):
    bend(rig)
    rig.controller.cell.take_loaded({"bench": placed(Cell("bench"), HANGING)})
    rig.controller.disconnect_device()
    rig.controller.cell.store = Kept(any="bench")
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: None not in rig.controller.operating_state.enabled)
    rig.run(0.4)
    rig.heard()
    assert rig.controller.motion.send_joints(OUT).reason == CELL_NOT_CONFIRMED
    assert [each for each in rig.heard() if 0x151 <= each.arbitration_id <= 0x15F] == []
    accepted(rig.controller.cell.confirm())
    accepted(rig.controller.motion.send_joints(OUT))


def test_an_arm_that_hangs_sinks_onto_what_is_under_it_in_the_room():
    body = carried_body(PiperModel.PIPER, PIPER, (0.0,) * 6, None)
    rows = flange_rows(PIPER, BENT_DEG)
    under = AreaBox("tray", (rows[3], rows[7], rows[11] + 400.0, 0, 0, 0), (300.0, 300.0, 20.0))
    over = AreaBox("rail", (rows[3], rows[7], -700.0, 0, 0, 0), (300.0, 300.0, 20.0))
    area = Area(boxes=(under, over))
    assert AreaCheck(area, body, HANGING.rising).below(BENT_DEG) == ("tray",)
    assert "tray" not in AreaCheck(area, body).below(BENT_DEG)
