"""S16: what was checked with one tool is not driven with another."""

import pytest

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.control.run.preflight import CHANGED_SINCE_CHECK, CheckBasis, Preflight
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.points.program import Trajectory
from tests.accepted import accepted
from tests.control.jogger import bend
from tests.control.under_way import OUT, to

PEN = Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0), 10.0)
BENCH = Cell("bench", (PEN,), "pen")


def with_pen(x_mm, z_mm, radius_mm):
    pen = Tool("pen", (x_mm, 0.0, z_mm, 0.0, 0.0, 0.0), radius_mm)
    return with_part(BENCH, pen, instead_of="pen")


OTHERS = {
    "a longer one": with_pen(0.0, 130.0, 10.0),
    "a thicker one": with_pen(0.0, 100.0, 12.0),
    "one to the side": with_pen(5.0, 100.0, 10.0),
    "none": Cell("bench", (PEN,), ""),
}


@pytest.mark.parametrize("other", OTHERS)
def test_a_check_made_with_another_tool_is_outdated(rig, other):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    options = RunOptions()
    arm = arm_model(rig.controller)
    assert (arm.tip_mm, arm.tool.radius_mm) == ((0.0, 0.0, 100.0), 10.0)
    request = CheckRequest(Trajectory("t", points=(to(OUT),)), arm, start_deg(rig.controller))
    checked = Preflight(
        request, check(request), CheckBasis.of(rig.controller, options, request.content)
    )
    assert checked.why_outdated(rig.controller, options) is None
    accepted(rig.controller.cell.change(OTHERS[other]))
    assert checked.why_outdated(rig.controller, options).reason == CHANGED_SINCE_CHECK
    accepted(rig.controller.cell.change(BENCH))
    assert checked.why_outdated(rig.controller, options) is None
