"""A tool is a capsule: in the check against the arm itself, and for the lowest height."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.arm.tool_capsule import ToolCapsule
from armui.kinematics.forward import flange_transforms
from armui.trajectory.planning.check import BELOW_FLOOR, LINKS_COLLIDE, CheckRequest, check
from tests.trajectory.arms import ARM, HERE, collisions, joint, run

PEN = ToolCapsule((0.0, 0.0, 200.0), 20.0)


def places(tool, joints_deg):
    """The tip and the axis of the capsule in the base, by the transforms of the flange."""
    flange = flange_transforms(ARM.kinematics.geometry, np.array(joints_deg))
    share = min(0.5, tool.radius_mm / math.hypot(*tool.tip_mm))
    ends = [np.array(tool.tip_mm) * each for each in (0.0, share, 1.0 - share, 1.0)]
    return [flange[:3, :3] @ end + flange[:3, 3] for end in ends]


@given(
    st.lists(st.floats(-400.0, 400.0), min_size=3, max_size=3).filter(any),
    st.floats(0.0, 200.0),
    st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6),
)
def test_the_lowest_point_is_that_of_the_whole_rod(tip, radius, shares):
    tool = ToolCapsule(tuple(tip), radius)
    joints = [90.0 * share for share in shares]
    flange, begin, end, there = places(tool, joints)
    between = [(1 - part) * begin + part * end for part in np.linspace(0.0, 1.0, 11)]
    lowest = min(flange[2], there[2], *(place[2] - radius for place in between))
    assert float(tool.lowest(flange[2], there[2])) == pytest.approx(lowest, abs=1e-6)


def test_the_check_watches_the_tip_wherever_it_is():
    tool = ToolCapsule((60.0, -30.0, 150.0))
    path = check(CheckRequest(run(joint(*HERE)), replace(ARM, tool=tool), HERE)).path
    assert path.places_mm[-1] == pytest.approx(places(tool, HERE)[-1])


def test_a_tool_below_the_floor_is_said_by_its_lowest_point():
    low = (0.0, 90.0, -30.0, 0.0, 40.0, 0.0)
    tool = ToolCapsule((0.0, 0.0, 300.0), 30.0)
    outcome = check(CheckRequest(run(joint(*low)), replace(ARM, tool=tool), HERE))
    found = [each for each in outcome.findings if each.kind == BELOW_FLOOR]
    flange, begin, end, tip = places(tool, low)
    depth = -min(flange[2], tip[2], begin[2] - 30.0, end[2] - 30.0)
    assert [each.params["value"] for each in found] == [pytest.approx(depth, abs=0.051)]


def test_a_tool_that_hits_the_arm_is_found_and_named():
    """Bent back along the forearm, the tool reaches to the elbow."""
    tool = ToolCapsule((0.0, -260.0, -180.0), 25.0)
    hits = collisions(ARM.kinematics.geometry, np.array([HERE]), ARM.tool_mm, tool=tool)
    near = ToolCapsule((0.0, -20.0, 120.0), 10.0)
    assert collisions(ARM.kinematics.geometry, np.array([HERE]), ARM.tool_mm, tool=near) == {}
    outcome = check(CheckRequest(run(joint(*HERE)), replace(ARM, tool=tool), HERE))
    named = [each.params for each in outcome.findings if each.kind == LINKS_COLLIDE]
    assert bool(hits) == bool(named)


def test_a_tool_without_a_radius_changes_nothing_of_the_collisions():
    rng = np.random.default_rng(7)
    joints = rng.uniform((-150, 0, -170, -100, -70, -120), (150, 180, 0, 100, 70, 120), (2000, 6))
    geometry = ARM.kinematics.geometry
    before = collisions(geometry, joints, ARM.tool_mm)
    assert before
    assert collisions(geometry, joints, ARM.tool_mm, tool=ToolCapsule((0.0, 0.0, 90.0))) == before
    assert before.keys() <= collisions(geometry, joints, ARM.tool_mm, tool=PEN).keys()
