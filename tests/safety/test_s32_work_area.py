"""S32: no motion of ours enters the forbidden side of a work area; who else does is told."""

from dataclasses import replace

import pytest

from armui.cell.area_check import AREA_IN_THE_WAY, AREA_ONLY_OUT
from armui.cell.work_area import AreaBox
from armui.control.devices.teaching_phase import AREA_WAY_UNKNOWN
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.motion.motion_command import Mover
from armui.control.motion.steered_path import SteeredJog
from armui.control.operating_state import JOG_UNDER_WAY
from armui.control.safety.recovery_steps import StepKind
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode, TeachingState
from armui.trajectory.planning.check import AREA_TOO_NEAR, CheckRequest, check
from armui.ui import words
from tests.accepted import accepted
from tests.cell.areas import TABLE, area_of, check_of, gap_mm, put, wall
from tests.control.jogger import BENT_DEG, bend, hold
from tests.control.jogger import LOSSES as LOST
from tests.trajectory.arms import ARM, joint, run

OUTWARDS = {
    "tool": ToolJog(0, 1, JogFrame.BASE),
    "joint": JointJog(2, 1),
    "gamepad": SteeredJog((1.0, 0.0, 0.0, 0.0, 0.0, 0.0), JogFrame.BASE, "pad"),
    "gamepad by joints": SteeredJog((0.0, 1.0, 0.0, 0.0, 0.0, 0.0), None, "pad"),
}


def wall_before(joints_deg, by_mm):
    """A wall so far beyond the arm."""
    return wall(gap_mm(joints_deg, wall(0.0)) * -1.0 + by_mm)


def drive(rig, jog, seconds):
    """Hold a jog until it ends; return the least gap that the simulated arm had on its way."""
    nearest = 1e9
    for _ in range(round(seconds / 0.02)):
        if isinstance(jog, SteeredJog):
            rig.controller.jogging.steer(jog)
        hold(rig, 0.02)
        nearest = min(nearest, gap_mm(rig.firmware.joints_deg, *rig.zones))
        if not rig.controller.jogging.active:
            break
    for _ in range(10):
        hold(rig, 0.02)
        nearest = min(nearest, gap_mm(rig.firmware.joints_deg, *rig.zones))
    return nearest


@pytest.mark.parametrize("jog", OUTWARDS.values(), ids=OUTWARDS)
def test_a_jog_at_full_speed_ends_before_a_plane(rig, jog):
    bend(rig)
    rig.zones = (wall_before(BENT_DEG, 40.0),)
    put(rig.controller, *rig.zones)
    accepted(rig.controller.jogging.start(jog))
    nearest = drive(rig, jog, 6.0)
    assert not rig.controller.jogging.active
    assert 9.0 <= nearest < 13.0
    (ended,) = [each for each in rig.events if each.code == "jog_ended"]
    assert ended.params["reason"].reason == AREA_IN_THE_WAY
    assert "“wall”" in words.refusal(ended.params["reason"])
    assert rig.controller.operating_state.intrusion is None


def test_a_jog_ends_before_a_box_and_goes_on_beside_it(rig):
    bend(rig)
    x, y, z = rig.controller.cartesian.tool_pose(rig.controller.state)[:3]
    rig.zones = (AreaBox("crate", (x + 260.0, y, z, 0.0, 0.0, 30.0), (150.0, 150.0, 300.0)),)
    put(rig.controller, *rig.zones)
    accepted(rig.controller.jogging.start(OUTWARDS["tool"]))
    assert 9.0 <= drive(rig, OUTWARDS["tool"], 6.0) < 13.0
    assert not rig.controller.jogging.active
    accepted(rig.controller.jogging.start(ToolJog(2, 1, JogFrame.BASE)))
    drive(rig, None, 0.5)
    assert rig.controller.jogging.active


def test_without_an_area_it_goes_on(rig):
    bend(rig)
    rig.zones = (wall_before(BENT_DEG, 40.0),)
    put(rig.controller, replace(rig.zones[0], on=False))
    accepted(rig.controller.jogging.start(OUTWARDS["tool"]))
    assert drive(rig, OUTWARDS["tool"], 3.0) < 0.0
    assert rig.controller.jogging.active


def test_an_arm_inside_is_only_moved_out(rig):
    bend(rig)
    put(rig.controller, wall_before(BENT_DEG, -20.0))
    hold(rig, 0.1)
    step = rig.controller.recovery.step
    assert step.kind is StepKind.IN_AREA
    assert step.params == {"name": "wall", "part": "gripper", "value": 30}
    assert "only be moved out" in words.step(step)
    rig.controller.jogging.start(OUTWARDS["tool"])
    hold(rig, 0.3)
    assert not rig.controller.jogging.active
    assert rig.events[-1].params["reason"].reason == AREA_ONLY_OUT
    refusal = rig.controller.motion.jog(2, 5.0)
    assert refusal.reason == AREA_ONLY_OUT
    inwards = ToolJog(0, -1, JogFrame.BASE)
    accepted(rig.controller.jogging.start(inwards))
    hold(rig, 1.5)
    assert rig.controller.jogging.active
    rig.controller.jogging.stop()
    rig.run_until(lambda: rig.controller.recovery.step.kind is StepKind.READY)
    assert rig.codes()[-1] == "area_left"


def test_an_arm_that_is_not_heard_has_left_nothing_and_come_into_nothing(rig):
    bend(rig)
    put(rig.controller, wall_before(BENT_DEG, -20.0))
    hold(rig, 0.1)
    told = len(rig.codes())
    rig.node.link.off = True
    hold(rig, 2.0)
    rig.node.link.off = False
    hold(rig, 2.0)
    assert {"offline", "online"} <= set(rig.codes()[told:])
    assert rig.controller.recovery.step.kind is StepKind.IN_AREA
    assert not {"area_left", "area_entered", "area_around"} & set(rig.codes()[told:])


def test_single_motions_are_refused_by_their_way(rig):
    bend(rig)
    controller = rig.controller
    put(controller, wall_before(BENT_DEG, 30.0))
    x, y, z, *turn = controller.cartesian.tool_pose(controller.state)
    across = tuple(a + b for a, b in zip(BENT_DEG, (0.0, 30.0, 0.0, 0.0, 0.0, 0.0), strict=True))
    for send in (
        lambda: controller.motion.send_joints(across),
        lambda: controller.motion.jog(2, 30.0),
        lambda: controller.cartesian.step(0, 40.0, JogFrame.BASE),
        lambda: controller.cartesian.move((x + 40.0, y, z, *turn), MoveMode.MOVE_L),
        lambda: controller.cartesian.move((x + 40.0, y, z, *turn), MoveMode.MOVE_P),
        # its ends are free, the way between them is not
        lambda: controller.cartesian.move_arc(
            (x, y, z, *turn), (x + 30.0, y + 30.0, z, *turn), (x, y + 60.0, z, *turn)
        ),
    ):
        rig.heard()
        refusal = send()
        assert refusal.reason == AREA_IN_THE_WAY
        assert rig.heard() == []
    accepted(controller.cartesian.step(0, 10.0, JogFrame.BASE))


def test_a_turn_past_a_box_is_refused_although_both_ends_are_free(rig):
    bend(rig)
    x, y, z = rig.controller.cartesian.tool_pose(rig.controller.state)[:3]
    put(rig.controller, AreaBox("post", (x, y + 250.0, z, 0.0, 0.0, 0.0), (20.0, 20.0, 400.0)))
    beyond = (110.0, *BENT_DEG[1:])
    refusal = rig.controller.motion.send_joints(beyond)
    assert refusal.reason == AREA_IN_THE_WAY
    accepted(rig.controller.motion.send_joints((-60.0, *BENT_DEG[1:])))


def test_runs_are_refused_with_row_and_place():
    area = check_of(wall_before(BENT_DEG, 30.0))
    away = (*BENT_DEG[:1], BENT_DEG[1] + 30.0, *BENT_DEG[2:])
    outcome = check(CheckRequest(run(joint(*BENT_DEG), joint(*away)), ARM, BENT_DEG, area=area))
    (found,) = [each for each in outcome.errors if each.kind == AREA_TOO_NEAR]
    assert (found.row, found.approach, found.params["name"]) == (1, False, "wall")
    assert found.joints_deg is not None
    assert BENT_DEG[1] < found.joints_deg[1] <= away[1]
    assert found.place_mm is not None
    outcome = check(CheckRequest(run(joint(*BENT_DEG), joint(*BENT_DEG)), ARM, away, area=area))
    assert outcome.errors == ()  # from where it is found it may come out
    assert check(CheckRequest(run(joint(*BENT_DEG)), ARM, BENT_DEG, area=area)).errors == ()


def test_the_area_is_not_changed_while_a_jog_is_held(rig):
    bend(rig)
    put(rig.controller, wall_before(BENT_DEG, 500.0))
    accepted(rig.controller.jogging.start(OUTWARDS["tool"]))
    hold(rig, 0.3)
    cell = rig.controller.cell.cell
    refusal = rig.controller.cell.change(replace(cell, area=area_of(TABLE)))
    assert refusal.reason == JOG_UNDER_WAY
    assert rig.controller.cell.cell == cell


def test_an_area_holds_before_its_cell_is_confirmed(rig):
    bend(rig)
    put(rig.controller, wall_before(BENT_DEG, -20.0))
    rig.controller.cell.forget_arm()
    hold(rig, 0.1)
    assert rig.controller.operating_state.intrusion.name == "wall"


def slow_driver(rig):
    rig.hold_driver()
    hold(rig, 0.2)
    rig.free_driver()


def silent_angles(rig):
    rig.node.link.mute_on.add(0x2A6)
    hold(rig, 0.5)
    rig.node.link.mute_on.clear()


def busy_pc(rig):
    """Nothing calls the controller for a while, and time passes for the arm."""
    rig.time_s += 0.3
    rig.node.poll(0.3)


LOSSES = (*LOST.values(), slow_driver, silent_angles, busy_pc)


@pytest.mark.parametrize("loss", LOSSES, ids=lambda loss: loss.__name__)
def test_whatever_is_lost_before_a_plane_the_arm_stays_out(rig, loss):
    bend(rig)
    rig.zones = (wall_before(BENT_DEG, 25.0),)
    put(rig.controller, *rig.zones)
    jog = OUTWARDS["tool"]
    accepted(rig.controller.jogging.start(jog))
    while gap_mm(rig.firmware.joints_deg, *rig.zones) > 13.0:
        hold(rig, 0.01)
    loss(rig)
    nearest = 1e9
    for _ in range(50):
        rig.time_s += 0.02
        rig.node.poll(0.02)
        nearest = min(nearest, gap_mm(rig.firmware.joints_deg, *rig.zones))
    assert nearest >= 9.0


@pytest.mark.parametrize("stops", [False, True], ids=["told", "stopped"])
def test_another_host_that_enters_is_told_at_once_and_stopped_if_wanted(rig, other_host, stops):
    bend(rig)
    beyond = (*BENT_DEG[:1], BENT_DEG[1] + 30.0, *BENT_DEG[2:])
    put(rig.controller, wall_before(BENT_DEG, 20.0))
    cell = rig.controller.cell.cell
    stopping = replace(cell, area=replace(cell.area, stops_others=stops))
    accepted(rig.controller.cell.change(stopping))
    other_host.move_to(beyond, 30)
    rig.run_until(lambda: "area_entered" in rig.codes())
    (entered,) = [each for each in rig.events if each.code == "area_entered"]
    assert entered.params["name"] == "wall"
    assert 1 <= entered.params["value"] < 12
    assert rig.controller.area_guard.nearest_entries(rig.controller.state)[0].gap_mm > 0.0
    assert "too near to “wall”" in words.event(entered), "it is not inside"
    rig.run(4.0)
    assert (abs(rig.firmware.joints_deg[1] - beyond[1]) < 0.1) is not stops


def test_a_hand_that_enters_is_told_at_once(rig):
    bend(rig)
    put(rig.controller, wall_before(BENT_DEG, 20.0))
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    rig.firmware.hand_guiding.lead_to((*BENT_DEG[:1], BENT_DEG[1] + 30.0, *BENT_DEG[2:]))
    rig.run_until(lambda: "area_entered" in rig.codes())
    assert rig.controller.operating_state.intrusion.value_mm < 12


def test_a_way_that_only_the_arm_knows_is_refused(rig):
    bend(rig)
    put(rig.controller, wall_before(BENT_DEG, 20.0))
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    assert rig.controller.operating_state.mover is Mover.HAND
    accepted(rig.controller.teaching.command(TeachingState.STOP_RECORDING))
    rig.run(0.5)
    refusal = rig.controller.teaching.command(TeachingState.RUN_RECORDING)
    assert refusal.reason == AREA_WAY_UNKNOWN
