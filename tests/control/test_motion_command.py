"""The command under way: how fast it moves the tool, and what keeps it from going on."""

import math
from typing import Any, cast

import pytest

from armui.control.motion.motion_command import (
    HELD_AT_ZERO,
    PLAN_PAUSED,
    CommandKind,
    Hold,
    MotionCommand,
    why_held,
)
from armui.control.safety.overspeed import ToolPace

LINE = ToolPace(cast("Any", None), linear_mm_s=60.0, angular_deg_s=40.0, ramp_s=2.0)


def test_the_tools_speed_is_the_lines_at_the_percentage_sent():
    slow = MotionCommand(1, CommandKind.POSE, 0.0, 33, pace=LINE)
    assert slow.tool_mm_s == pytest.approx(19.8)
    assert not slow.leads_away, "until that is measured"
    assert slow.most_percent == 100


def test_a_motion_that_is_no_line_has_no_speed_of_the_tool():
    assert MotionCommand(1, CommandKind.JOINTS, 0.0, 25).tool_mm_s == math.inf


def test_a_pause_is_the_graver_cause_that_holds_back():
    assert why_held(()) is None
    assert why_held({Hold.SPEED_ZERO}) == HELD_AT_ZERO()
    assert why_held({Hold.SPEED_ZERO, Hold.PAUSE}) == PLAN_PAUSED()
