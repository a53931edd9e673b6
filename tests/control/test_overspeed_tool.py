"""When the tool is measured to be faster along a line or an arc than the speed shown."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any, cast

import pytest

from armui.control.safety.overspeed import (
    TOO_FAST,
    TOOL_TOO_FAST,
    TOOL_TURNS_TOO_FAST,
    ToolPace,
    tool_pace,
)
from tests.control.test_overspeed import PERCENT, STEP_S, Motion

MM_PER_DEG, DEG_PER_DEG = 4.0, 2.0
"""So that the tool is too fast long before a joint."""
PER_DEG = {1: MM_PER_DEG, 6: DEG_PER_DEG}


class Slide:
    """An arm whose first joint moves the flange along X, and whose sixth turns it."""

    def forward(self, joints_deg):
        return (MM_PER_DEG * joints_deg[0], 0.0, 0.0, 0.0, 0.0, DEG_PER_DEG * joints_deg[5])


SLIDE = cast("Any", Slide())
PACE = ToolPace(SLIDE, linear_mm_s=60.0, angular_deg_s=40.0, ramp_s=2.0)
"""20 % of 60 mm/s is 12: half again and 3 of slack make 21; of 40 °/s 8, and with 2 of slack 14."""


class ToolMotion(Motion):
    """A flange that moves and turns at a speed, and the watch."""

    def __init__(self) -> None:
        super().__init__()
        self.pace = PACE

    def turn(self, speed, steps, joint=1, percent=PERCENT):
        """As for a joint, with the speed of the tool in mm/s (joint 1) or °/s (joint 6)."""
        for _ in range(steps):
            self.refusal = self.watch.observe(
                self.state(), percent, self.factory, self.brakes, self.pace
            )
            self.now_s += STEP_S
            self.angles_deg[joint - 1] += speed / PER_DEG[joint] * STEP_S
        return self.refusal


@pytest.fixture
def motion():
    return ToolMotion()


@pytest.mark.parametrize(
    ("joint", "speed", "code", "figures"),
    [
        (1, 24.25, TOOL_TOO_FAST, {"value": 24.2, "maximum": 12.0, "limit": 21.0}),
        (1, -24.25, TOOL_TOO_FAST, {"value": 24.2, "maximum": 12.0, "limit": 21.0}),
        (6, 16.5, TOOL_TURNS_TOO_FAST, {"value": 16.5, "maximum": 8.0, "limit": 14.0}),
        (6, -16.5, TOOL_TURNS_TOO_FAST, {"value": 16.5, "maximum": 8.0, "limit": 14.0}),
    ],
)
def test_what_is_too_fast_and_the_speed_shown_are_named(motion, joint, speed, code, figures):
    refusal = motion.turn(speed, 9, joint)
    assert refusal.reason == code
    assert refusal.params == {"percent": PERCENT, **figures}


@pytest.mark.parametrize(
    ("joint", "speed", "too_fast"),
    [(1, 20.5, False), (1, 21.5, True), (6, 13.5, False), (6, 14.5, True)],
)
def test_half_again_and_a_slack_are_allowed(motion, joint, speed, too_fast):
    assert (motion.turn(speed, 20, joint) is not None) is too_fast


@pytest.mark.parametrize(
    ("joint", "speed", "too_fast"),
    [(1, 2.5, False), (1, 3.5, True), (6, 1.5, False), (6, 2.5, True)],
)
def test_at_zero_percent_only_the_slack_is_allowed(motion, joint, speed, too_fast):
    assert (motion.turn(speed, 20, joint, percent=0) is not None) is too_fast


def test_another_percentage_is_of_the_tools_highest_speed(motion):
    assert motion.turn(60.0, 9, percent=70) is None  # 63 mm/s and 3 of slack
    assert motion.turn(60.0, 9, percent=60).params["maximum"] == 36.0


@pytest.mark.parametrize(("joint", "fast"), [(1, 30.0), (6, 20.0)])
def test_a_tool_that_brakes_is_on_its_way_to_the_speed_it_was_told(motion, joint, fast):
    motion.turn(fast, 4, joint)
    assert motion.turn(0.97 * fast, 5, joint) is not None
    motion = ToolMotion()
    motion.turn(fast, 4, joint)
    assert motion.turn(0.9 * fast, 5, joint) is None


def test_a_joint_that_is_too_fast_is_named_before_the_tool(motion):
    assert motion.turn(4 * 40.25, 9).reason == TOO_FAST


def test_without_a_line_or_an_arc_only_the_joints_are_compared(motion):
    motion.pace = None
    assert motion.turn(24.25, 20) is None


def test_before_the_limits_of_the_tool_are_heard_only_the_joints_are_compared(motion):
    arm = cast("Any", SimpleNamespace(kinematics=SLIDE, end_limits=None))
    motion.pace = tool_pace((), None, arm)
    assert motion.turn(60.0, 20) is None
    assert motion.turn(60.0, 20, joint=6) is None


def test_of_a_path_whose_beginning_is_unknown_the_limits_of_the_tool_are_the_pace():
    limits = SimpleNamespace(max_linear_speed_m_s=0.5, max_angular_speed_rad_s=math.pi)
    pace = tool_pace((), None, cast("Any", SimpleNamespace(kinematics=SLIDE, end_limits=limits)))
    assert (pace.linear_mm_s, pace.ramp_s) == (500.0, 1.0)
    assert pace.angular_deg_s == pytest.approx(180.0)


@pytest.mark.parametrize(("percent", "within_s"), [(100.0, 2.2), (30.0, 0.8), (0.0, 0.2)])
def test_it_becomes_slower_by_its_ramp_once_the_change_is_taken_up(percent, within_s):
    assert PACE.slowed_within_s(percent) == pytest.approx(within_s)
