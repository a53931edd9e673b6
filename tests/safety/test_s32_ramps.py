"""S32, S35: a motion of the joints is judged by the way that their own ramps lead the arm.

The joints start and arrive together, but one that turns far accelerates for longer, and the others
are ahead of it meanwhile. In each scene an even turn stays 24 mm or more away from the box, and the
arm with its pen goes right into it: found by :mod:`tests.safety.many_motions`.
"""

from dataclasses import replace

import pytest

from armui.cell.area_check import AREA_IN_THE_WAY
from armui.cell.cell import Cell
from armui.cell.tools import Tool
from armui.cell.work_area import AreaBox
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import tool_pose
from armui.protocol import commands
from armui.protocol.codec import Codec
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from tests.accepted import accepted
from tests.cell.areas import area_of
from tests.control.jogger import BENT_DEG, bend
from tests.family import PIPER
from tests.safety.inline_rig import inline_rig
from tests.safety.mesh_oracle import MeshOracle
from tests.safety.watched_arm import rest, settle, told, watch

PEN = Tool("pen", (0.0, 0.0, 220.0, 0.0, 0.0, 0.0), 5.0)


def cube(*place):
    return AreaBox("cube", (*place, 0.0, 0.0, 0.0), (30.0,) * 3)


SCENES = {
    "down": (cube(540.0, 137.0, 182.0), (10.0, 100.0, -40.0, -25.0, -40.0, 20.0)),
    "aside": (cube(263.0, 377.0, -16.0), (70.0, 110.0, -20.0, 15.0, -40.0, 20.0)),
    "up": (cube(76.0, 428.0, 622.0), (90.0, 65.0, -100.0, 25.0, 0.0, 20.0)),
}
scenes = pytest.mark.parametrize(("box", "target"), SCENES.values(), ids=SCENES)


@pytest.fixture
def rig(qapp, request):
    with inline_rig(request.node.nodeid) as rig:
        bend(rig)
        yield rig


def with_pen(*zones):
    return replace(Cell("bench", area=area_of(*zones)), tools=(PEN,), tool="pen")


@scenes
def test_an_even_turn_would_stay_away_and_the_arm_does_not(rig, box, target):
    """What the next tests are about; a host that asks nobody sends the frames here."""
    oracle = MeshOracle.of(with_pen(box))
    assert oracle.along(BENT_DEG, target).mm > 23.0
    accepted(rig.controller.cell.take(with_pen(box)))
    seen = watch(rig)
    for frame in commands.move_joints(Codec(Generation.TWO), target, speed_percent=100):
        rig.firmware.on_frame(frame)
    rest(rig)
    assert rig.firmware.true_joints_deg == pytest.approx(target, abs=0.1)
    assert seen.end().mm < -5.0


@scenes
@pytest.mark.parametrize("percent", [100, 20])
def test_it_is_refused_at_any_speed(rig, box, target, percent):
    """Who begins slowly may go faster on the way."""
    accepted(rig.controller.cell.take(with_pen(box)))
    rig.controller.motion.set_speed_percent(percent)
    refusal = told(rig.controller.motion.send_joints(target, -1000.0))
    assert refusal.reason == AREA_IN_THE_WAY
    flange = Kinematics(PIPER).forward(target)
    tip = tool_pose(flange, rig.controller.cartesian.tool)
    refusal = told(rig.controller.cartesian.move(tip, MoveMode.MOVE_P, -1000.0))
    assert refusal.reason == AREA_IN_THE_WAY


@scenes
def test_a_box_further_aside_is_no_reason(rig, box, target):
    away = replace(box, pose=(*box.pose[:2], box.pose[2] - 150.0, *box.pose[3:]))
    accepted(rig.controller.cell.take(with_pen(away)))
    seen = watch(rig)
    assert settle(rig, rig.controller.motion.send_joints(target, -1000.0))
    assert rig.firmware.true_joints_deg == pytest.approx(target, abs=0.1)
    assert seen.end().mm > 9.0
