"""S36, S32: what is allowed for noise is allowed once: no number of small motions creeps in.

A wall stands 11 mm before the arm, 10 are kept. Whatever moves the arm by less than a millimetre,
however often, its meshes stay as far away as a single motion must: 10 mm, less 1 for what is
measured. The judge measures the meshes; see :mod:`tests.safety.mesh_oracle`.
"""

from dataclasses import replace

import pytest

from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.placement import Placement
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import AreaBox, AreaPlane
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.motion.steered_path import SteeredJog
from armui.control.parameters.arm_model import arm_model
from armui.kinematics.axes import JogFrame
from armui.kinematics.forward import flange_rows
from armui.protocol.codes import MoveMode
from armui.trajectory.planning.check import CheckRequest
from armui.trajectory.planning.check import check as check_way
from armui.trajectory.points.program import Trajectory
from tests.accepted import accepted
from tests.cell.areas import area_of, gap_mm, wall
from tests.control.jogger import BENT_DEG, bend, hold
from tests.control.under_way import run_of, to
from tests.family import FACTORY_LIMITS, PIPER
from tests.safety.inline_rig import inline_rig
from tests.safety.mesh_oracle import MeshOracle
from tests.safety.test_s32_jogging_low import tip_mm
from tests.safety.test_s32_placed_base import ASLANT, lowest_mm
from tests.safety.watched_arm import Watch, settle, told

MARGIN_MM = 10.0
SLACK_MM = 1.0
BEFORE_MM = 11.0
PRESSES = 45
"""What is refused costs no time: only while this fails it takes minutes."""
LEAST_MM = MARGIN_MM - SLACK_MM
TILTED = UserFrame("jig", (0.0, 0.0, 0.0, 20.0, -30.0, 0.0))
"""A frame whose X axis points outwards and up."""


@pytest.fixture
def rig(qapp, request):
    with inline_rig(request.node.nodeid) as rig:
        yield rig


@pytest.fixture
def bent(rig):
    """A bent arm at 100 %; a zone 11 mm before it is put up by :func:`before`."""
    bend(rig)
    return rig


def before(rig, zone, cell=None):
    """Put a zone up and watch the arm."""
    cell = replace(cell or Cell("bench"), area=area_of(zone, margin_mm=MARGIN_MM))
    accepted(rig.controller.cell.take(cell))
    rig.run(0.1)
    return Watch(rig, MeshOracle.of(cell))


def near_wall(joints_deg=BENT_DEG):
    return wall(-gap_mm(joints_deg, wall(0.0)) + BEFORE_MM)


def tool_step(rig, frame=JogFrame.BASE, axis=0, amount=0.9):
    return rig.controller.cartesian.step(axis, amount, frame)


def pose_step(rig, mode):
    """Measured, 0.8 mm further, as an operator types it."""
    x, *rest = rig.controller.cartesian.tool_pose(rig.controller.state)
    return rig.controller.cartesian.move((x + 0.8, *rest), mode)


def typed_joints(rig):
    """Each press as a new target: what is measured, J2 a little further out."""
    angles = [round(angle, 3) for angle in rig.controller.state.angles_deg()]
    angles[1] += 0.3
    return rig.controller.motion.send_joints(angles)


def small_arc(rig):
    x, y, z, *turn = rig.controller.cartesian.tool_pose(rig.controller.state)
    middle, end = (x + 0.8, y + 1.0, z, *turn), (x + 0.8, y + 3.0, z, *turn)
    return rig.controller.cartesian.move_arc((x, y, z, *turn), middle, end)


def single_run(rig):
    """A run of one point, checked as the window does, and let go if nothing speaks against it."""
    x, *rest = rig.controller.cartesian.tool_pose(rig.controller.state)
    here_deg = rig.controller.state.angles_deg()
    ahead = rig.controller.cartesian.kinematics().inverse((x + 0.8, *rest), here_deg)[0]
    point = to(tuple(round(angle, 3) for angle in ahead))
    area = rig.controller.area_guard.check()
    request = CheckRequest(
        Trajectory("t", points=(point,)), arm_model(rig.controller), here_deg, area=area
    )
    if check_way(request).errors:
        return None
    return rig.controller.player.start(run_of(point))


STEPS = {
    "tool step": tool_step,
    "tool step in a user frame": lambda rig: tool_step(rig, TILTED),
    "tool turn": lambda rig: tool_step(rig, axis=4, amount=-0.3),
    "MOVE P": lambda rig: pose_step(rig, MoveMode.MOVE_P),
    "MOVE L": lambda rig: pose_step(rig, MoveMode.MOVE_L),
    "MOVE C": small_arc,
    "typed joints": typed_joints,
    "joint step": lambda rig: rig.controller.motion.jog(2, 0.2),
    "two joints in turn": lambda rig: rig.controller.motion.jog(
        *((2, 0.3), (1, -0.1))[rig.presses % 2]
    ),
    "run": single_run,
}
TAPS = {
    "tool": ToolJog(0, 1, JogFrame.BASE),
    "joint": JointJog(2, 1),
    "user frame": ToolJog(0, 1, TILTED),
    "steered": SteeredJog((1.0, 0.0, 0.2, 0.0, 0.0, 0.0), JogFrame.BASE, "pad"),
    "steered joints": SteeredJog((0.0, 1.0, 0.0, 0.0, 0.0, 0.0), None, "pad"),
}


def press(rig, step, presses=PRESSES):
    """Press so often, each time when the arm rests; return how many were taken."""
    taken = 0
    for rig.presses in range(presses):
        answer = step(rig)
        if answer is not None:
            taken += settle(rig, answer)
    return taken


def tap(rig, jog, presses=PRESSES):
    """Tap a button so often, each time for 40 ms."""
    for _ in range(presses):
        rig.controller.jogging.start(jog)
        for _ in range(4):
            if isinstance(jog, SteeredJog):
                rig.controller.jogging.steer(jog)
            hold(rig, 0.01)
        rig.controller.jogging.stop()
        hold(rig, 0.15)


def in_jig(cell=None):
    return replace(cell or Cell("bench"), frames=(TILTED,), frame=TILTED.name)


@pytest.mark.parametrize("name", STEPS)
def test_no_small_motion_creeps_towards_a_wall(bent, name):
    watch = before(bent, near_wall(), in_jig())
    assert press(bent, STEPS[name]) > 0
    assert watch.least.mm >= LEAST_MM


@pytest.mark.parametrize("name", TAPS)
def test_no_tapped_button_creeps_towards_a_wall(bent, name):
    watch = before(bent, near_wall(), in_jig())
    tap(bent, TAPS[name], 30)
    assert watch.least.mm >= LEAST_MM


@pytest.mark.parametrize("pace", ["at rest", "quickly", "slowly"])
def test_neither_the_pace_of_the_presses_nor_the_speed_matters(bent, pace):
    watch = before(bent, near_wall())
    if pace == "slowly":
        bent.controller.motion.set_speed_percent(5)
    if pace == "quickly":
        for _ in range(PRESSES):
            tool_step(bent)
            bent.run(0.04)
        bent.run(2.0)
    else:
        press(bent, tool_step, 30)
    assert watch.least.mm >= LEAST_MM


def test_steps_of_another_kind_between_grant_nothing_anew(bent):
    """In, sideways, in, up, by turns of joints and of the tool: none sets the mark back."""
    watch = before(bent, near_wall())
    ways = (
        tool_step,
        lambda rig: tool_step(rig, axis=1, amount=5.0),
        STEPS["typed joints"],
        lambda rig: tool_step(rig, axis=1, amount=-5.0),
        STEPS["MOVE L"],
        lambda rig: rig.controller.motion.jog(6, 1.0),
    )
    press(bent, lambda rig: ways[rig.presses % len(ways)](rig))
    assert watch.least.mm >= LEAST_MM


def test_coming_back_grants_nothing_anew(bent):
    """Two steps in, one out, over and over: it comes to rest where the first two do."""
    watch = before(bent, near_wall())
    press(bent, lambda rig: tool_step(rig, amount=-0.8 if rig.presses % 3 == 2 else 0.9))
    assert watch.least.mm >= LEAST_MM


def crate(joints_deg, by_mm):
    """A crate before the hand, so far beyond the arm."""
    x, y, z = flange_rows(PIPER, joints_deg)[3::4]
    near = AreaBox("crate", (x + 200.0, y, z, 0.0, 0.0, 0.0), (100.0, 400.0, 400.0))
    off = gap_mm(joints_deg, near)
    return replace(near, pose=(x + 200.0 - off + by_mm, y, z, 0.0, 0.0, 0.0))


@pytest.mark.parametrize("name", ["tool step", "joint step", "MOVE L", "typed joints"])
def test_a_box_is_kept_as_a_plane_is(bent, name):
    watch = before(bent, crate(BENT_DEG, BEFORE_MM))
    press(bent, STEPS[name])
    assert watch.least.mm >= LEAST_MM


def test_the_elbow_is_kept_as_the_hand_is(bent):
    """The arm's back comes to a wall behind it while the hand goes away from it."""
    back = AreaPlane("back", (0.0, 0.0, 0.0, 0.0, 90.0, 0.0))
    off = gap_mm(BENT_DEG, back)
    watch = before(bent, replace(back, pose=(off - BEFORE_MM, 0.0, 0.0, 0.0, 90.0, 0.0)))
    press(bent, lambda rig: rig.controller.motion.jog(2, -0.2))
    assert watch.least.mm >= LEAST_MM


NEEDLE = Tool("needle", (20.0, 0.0, 190.0, 0.0, 20.0, 0.0), 4.0)
BAR = HeldObject("bar", (0.0, 0.0, 180.0, 0.0, 0.0, 0.0), (60.0, 60.0, 240.0))
ROD = HeldObject("rod", (0.0, 30.0, 200.0, 40.0, 0.0, 0.0), (30.0, 30.0, 200.0), is_rod=True)
CARRIED = {
    "tool": Cell("bench", tools=(NEEDLE,), tool="needle"),
    "held box": Cell("bench", held_objects=(BAR,), held="bar"),
    "held rod": Cell("bench", held_objects=(ROD,), held="rod"),
    "tool and box": Cell("bench", tools=(NEEDLE,), tool="needle", held_objects=(BAR,), held="bar"),
}


@pytest.mark.parametrize("name", CARRIED)
def test_what_the_arm_carries_is_kept_out_as_it_is(bent, name):
    """The wall is put up by the meshes: what stands for them is wider, by so much at most."""
    cell, spare_mm = CARRIED[name], 12.0
    oracle = MeshOracle.of(replace(cell, area=area_of(wall(0.0))))
    reach_mm = -oracle.nearest(BENT_DEG).mm
    watch = before(bent, wall(reach_mm + BEFORE_MM + spare_mm), cell)
    assert press(bent, tool_step) > 0
    assert watch.least.mm >= LEAST_MM


DOWN = {
    "tool step": lambda rig: tool_step(rig, axis=2, amount=-0.9),
    "joint step": lambda rig: rig.controller.motion.jog(2, 0.2),
    "tapped": None,
    "MOVE L": lambda rig: lower(rig, MoveMode.MOVE_L),
    "MOVE P": lambda rig: lower(rig, MoveMode.MOVE_P),
    "typed joints": lambda rig: typed_further(rig, 5, 0.3),
}


def lower(rig, mode):
    x, y, z, *turn = rig.controller.cartesian.tool_pose(rig.controller.state)
    return rig.controller.cartesian.move((x, y, z - 0.8, *turn), mode)


@pytest.mark.each_value(full="each motion on both bases")
@pytest.mark.parametrize("placement", [Placement(), ASLANT], ids=["upright", "aslant"])
@pytest.mark.parametrize("name", DOWN)
def test_the_lowest_height_is_kept_by_small_motions(bent, name, placement):
    height_mm = (lambda at: lowest_mm(at, placement)) if placement.is_set else tip_mm
    accepted(bent.controller.cell.take(Cell("bench", placement=placement)))
    limit = round(height_mm(BENT_DEG)) - 2
    bent.controller.jog_floor.lowest_mm = limit
    if name == "tapped":
        tap(bent, JointJog(2, 1), 25)
    else:
        press(bent, DOWN[name], 30)
    assert height_mm(bent.firmware.joints_deg) >= limit - SLACK_MM


AT_LIMIT = {
    "joint step": lambda rig, joint, way: rig.controller.motion.jog(joint, way * 0.3),
    "typed joints": lambda rig, joint, way: typed_further(rig, joint, way * 0.3),
    "tapped": lambda rig, joint, way: tap(rig, JointJog(joint, way), 1),
}


def typed_further(rig, joint, by_deg):
    angles = [round(angle, 3) for angle in rig.controller.state.angles_deg()]
    angles[joint - 1] += by_deg
    return rig.controller.motion.send_joints(angles)


@pytest.mark.parametrize("name", AT_LIMIT)
@pytest.mark.parametrize(("joint", "way"), [(1, 1), (1, -1), (4, 1), (6, -1)])
def test_no_small_motion_leads_beyond_a_joints_limit(rig, joint, way, name):
    limits = FACTORY_LIMITS[joint - 1]
    bound = limits.max_deg if way > 0 else limits.min_deg
    near = [*BENT_DEG]
    near[joint - 1] = bound - way
    bend(rig, tuple(near))
    if name == "tapped":
        tap(rig, JointJog(joint, way), 12)
    else:
        for _ in range(12):
            settle(rig, AT_LIMIT[name](rig, joint, way))
    at = rig.firmware.true_joints_deg[joint - 1]
    assert abs(at - (bound - way)) > 0.3, "it did not move at all"
    assert way * (at - bound) <= 0.05


def test_a_motion_along_the_wall_stays_possible(bent):
    """11 mm before it a step sideways, and one away, is taken, and adds up."""
    watch = before(bent, near_wall())
    y_mm = bent.controller.cartesian.tool_pose(bent.controller.state)[1]
    assert press(bent, lambda rig: tool_step(rig, axis=1, amount=2.0), 10) == 10
    assert press(bent, lambda rig: tool_step(rig, axis=0, amount=-1.0), 5) == 5
    now_mm = bent.controller.cartesian.tool_pose(bent.controller.state)[1]
    assert now_mm == pytest.approx(y_mm + 20.0, abs=0.5)
    assert watch.least.mm >= LEAST_MM


def test_a_step_that_is_too_far_is_refused_with_its_zone(bent):
    before(bent, near_wall())
    assert told(tool_step(bent, amount=5.0)).params["name"] == "wall"
