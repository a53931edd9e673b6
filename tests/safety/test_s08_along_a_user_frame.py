"""Jogs and steps along a user frame keep what those along the base keep; none is guessed."""

from dataclasses import replace

import pytest

from armui.cell.area_check import AREA_IN_THE_WAY
from armui.cell.cell import Cell, with_part
from armui.cell.user_frames import UserFrame
from armui.control.cell.cell_reasons import CELL_NOT_CONFIRMED
from armui.control.motion.cartesian import FRAME_NOT_IN_FORCE
from armui.control.motion.jog_path import ToolJog
from armui.control.motion.jogging import JOG_NO_FEEDBACK
from armui.control.motion.steered_path import SteeredJog
from armui.control.operating_state import JOG_UNDER_WAY
from armui.kinematics.axes import JogFrame
from armui.ways.rules import TOO_LOW
from tests.accepted import accepted
from tests.cell.areas import area_of, gap_mm, wall
from tests.control.jogger import BENT_DEG, bend, hold
from tests.safety.test_s15_the_cell_is_confirmed import MOTION, Kept
from tests.safety.test_s32_jogging_low import tip_mm

TURNED = UserFrame("turned", (100.0, 0.0, 50.0, 0.0, 0.0, 90.0))
"""Its −Y is the base's X, its X the base's Y."""
FLIPPED = UserFrame("flipped", (0.0, 0.0, 0.0, 180.0, 0.0, 0.0))
OTHER = UserFrame("other", (0.0, 0.0, 0.0, 0.0, 0.0, 45.0))
BENCH = with_part(Cell("bench", frames=(OTHER, FLIPPED)), TURNED)
UP_X = ToolJog(1, -1, TURNED)
PAD_X = SteeredJog((0.0, -1.0, 0.0, 0.0, 0.0, 0.0), TURNED, "pad")


@pytest.fixture
def ready(rig):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    rig.heard()
    return rig


def drive(rig, jog, seconds):
    for _ in range(round(seconds / 0.02)):
        if isinstance(jog, SteeredJog):
            rig.controller.jogging.steer(jog)
        hold(rig, 0.02)
        if not rig.controller.jogging.active:
            break
    hold(rig, 0.2)


def ended(rig):
    (event,) = [each for each in rig.events if each.code == "jog_ended"]
    return event.params["reason"]


def test_a_step_after_another_host_moved_the_arm_starts_where_it_is(ready, other_host):
    rig = ready
    accepted(rig.controller.cartesian.step(0, 5.0, TURNED))
    rig.run(1.0)
    there = (0.0, *BENT_DEG[1:])
    other_host.move_to(there)
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(there, abs=0.05))
    rig.run(2.6)
    before = rig.controller.state.end_pose()
    accepted(rig.controller.cartesian.step(1, -2.0, TURNED))
    rig.run(1.0)
    after = rig.controller.state.end_pose()
    assert after[0] - before[0] == pytest.approx(2.0, abs=0.2)
    assert after[1:3] == pytest.approx(before[1:3], abs=0.2)


def test_steps_add_up_from_our_target_also_when_the_frame_changes_between_them(ready):
    rig = ready
    before = rig.controller.state.end_pose()
    accepted(rig.controller.cartesian.step(1, -3.0, TURNED))
    rig.run(1.0)
    accepted(rig.controller.cell.change(replace(BENCH, frame="flipped")))
    accepted(rig.controller.cartesian.step(2, -3.0, FLIPPED))
    rig.run(1.0)
    after = rig.controller.state.end_pose()
    expected = (before[0] + 3.0, before[1], before[2] + 3.0)
    assert after[:3] == pytest.approx(expected, abs=0.05)


def test_another_host_ends_a_jog(ready, other_host):
    accepted(ready.controller.jogging.start(UP_X))
    hold(ready, 0.3)
    other_host.move_to(BENT_DEG)
    hold(ready, 0.3)
    assert not ready.controller.jogging.active
    assert ready.controller.jogging.start(UP_X).code == "other_host"


def test_silence_ends_a_jog(ready):
    accepted(ready.controller.jogging.start(UP_X))
    hold(ready, 0.3)
    ready.node.link.mute_on.update({0x2A5, 0x2A6, 0x2A7})
    hold(ready, 0.3)
    assert ended(ready).reason == JOG_NO_FEEDBACK


@pytest.mark.parametrize("percent", [10, 50])
def test_it_is_as_fast_as_along_the_base(ready, percent):
    ready.controller.motion.set_speed_percent(percent)
    travelled = []
    for jog in (UP_X, ToolJog(0, -1, JogFrame.BASE)):
        before = ready.controller.state.end_pose()
        accepted(ready.controller.jogging.start(jog))
        hold(ready, 0.5)
        ready.controller.jogging.stop()
        ready.run(0.6)
        travelled.append(ready.controller.state.end_pose()[0] - before[0])
    assert 0.4 * 0.6 * percent / 2 < travelled[0] < 60.0 * percent / 100 * 0.5 + 1.0
    assert travelled[0] == pytest.approx(-travelled[1], rel=0.15)


@pytest.mark.parametrize("jog", [UP_X, PAD_X], ids=["held", "steered"])
def test_it_ends_before_a_plane(ready, jog):
    plane = wall(gap_mm(BENT_DEG, wall(0.0)) * -1.0 + 40.0)
    accepted(ready.controller.cell.change(replace(BENCH, area=area_of(plane))))
    accepted(ready.controller.jogging.start(jog))
    drive(ready, jog, 6.0)
    assert ended(ready).reason == AREA_IN_THE_WAY
    assert 9.0 <= gap_mm(ready.firmware.joints_deg, plane) < 13.0
    refusal = ready.controller.cartesian.step(1, -40.0, TURNED)
    assert refusal.reason == AREA_IN_THE_WAY


def test_it_ends_at_the_lowest_height_though_its_z_points_down(ready):
    accepted(ready.controller.cell.change(replace(BENCH, frame="flipped")))
    limit = round(tip_mm(BENT_DEG)) - 15
    ready.controller.jog_floor.lowest_mm = limit
    accepted(ready.controller.jogging.start(ToolJog(2, 1, FLIPPED)))
    drive(ready, None, 4.0)
    assert ended(ready).reason == TOO_LOW
    assert limit <= tip_mm(ready.firmware.joints_deg) < limit + 2.0


@pytest.mark.parametrize("frame", [OTHER, UserFrame(""), replace(TURNED, pose=OTHER.pose)])
def test_a_frame_that_is_not_in_force_moves_nothing(ready, frame):
    arm = ready.controller
    for ask in (
        lambda: arm.cartesian.step(0, 5.0, frame),
        lambda: arm.jogging.start(ToolJog(0, 1, frame)),
        lambda: arm.jogging.start(replace(PAD_X, frame=frame)),
    ):
        assert ask().reason == FRAME_NOT_IN_FORCE
    ready.run(0.3)
    assert [each for each in ready.heard() if each.arbitration_id in MOTION] == []


def test_the_frame_stays_while_a_jog_is_held(ready):
    accepted(ready.controller.jogging.start(UP_X))
    hold(ready, 0.2)
    for cell in (
        replace(BENCH, frame="other"),
        replace(BENCH, frame=""),
        replace(BENCH, frames=(replace(TURNED, pose=OTHER.pose),)),
    ):
        assert ready.controller.cell.change(cell).reason == JOG_UNDER_WAY
    assert ready.controller.cell.choose("").reason == JOG_UNDER_WAY
    assert ready.controller.cartesian.frame == TURNED
    assert ready.controller.jogging.active


LOST = {
    "to be confirmed": lambda arm: arm.cell.forget_arm(),
    "another one": lambda arm: setattr(arm.cartesian, "frame", OTHER),
}


@pytest.mark.each_value(full="each way to end each jog")
@pytest.mark.parametrize("how", LOST)
@pytest.mark.parametrize("jog", [UP_X, PAD_X], ids=["held", "steered"])
def test_a_jog_ends_when_its_frame_is_in_force_no_more(ready, jog, how):
    accepted(ready.controller.jogging.start(jog))
    for number in range(20):
        if isinstance(jog, SteeredJog):
            ready.controller.jogging.steer(jog)
        if number == 10:
            LOST[how](ready.controller)
        hold(ready, 0.02)
    assert not ready.controller.jogging.active
    assert ended(ready).reason in {FRAME_NOT_IN_FORCE, CELL_NOT_CONFIRMED}
    hold(ready, 0.2)
    before = ready.firmware.joints_deg
    ready.run(0.5)
    assert ready.firmware.joints_deg == pytest.approx(before, abs=0.01)


def test_before_the_cell_is_confirmed_its_frame_is_not_in_force(ready):
    rig = ready
    rig.controller.disconnect_device()
    rig.controller.cell.store = Kept(any="bench")
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: None not in rig.controller.operating_state.enabled)
    rig.run(0.4)
    rig.heard()
    arm = rig.controller
    assert (arm.cartesian.frame, arm.cell.cell) == (None, BENCH)
    pose = arm.cartesian.tool_pose(arm.state)
    assert arm.cartesian.in_frame(pose) == pose
    assert arm.cartesian.step(0, 5.0, TURNED).reason == CELL_NOT_CONFIRMED
    assert arm.jogging.start(UP_X).reason == CELL_NOT_CONFIRMED
    rig.run(0.3)
    assert [each for each in rig.heard() if each.arbitration_id in MOTION] == []
    accepted(arm.cell.confirm())
    assert arm.cartesian.frame == TURNED
    accepted(arm.jogging.start(UP_X))
