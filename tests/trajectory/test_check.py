"""What a check finds, where, and what it does not hold against an arm."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt
import pytest

from armui.arm.state import EndLimits
from armui.kinematics.forward import links
from armui.trajectory.planning.check import CheckOutcome, CheckRequest, check
from armui.trajectory.planning.findings import Severity
from armui.trajectory.planning.timing import plan_path
from armui.trajectory.points.program import GripperOpening, Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from armui.ui.words.findings import finding_line
from armui.ways.own_body import OwnBody
from tests.trajectory.arms import (
    ARM,
    HERE,
    KINEMATICS,
    collisions,
    joint,
    line,
    pose,
    pose_near,
    run,
)
from tests.ways.segments import segment_distances


def found(report: CheckOutcome) -> list[tuple[str, int | None]]:
    return [(finding.code, finding.row) for finding in report.findings]


def checked(*points: Waypoint, start: Sequence[float] = HERE) -> CheckOutcome:
    return check(CheckRequest(run(*points), ARM, start))


def recording(times_s: npt.ArrayLike, joints_deg: npt.ArrayLike) -> Recording:
    times, joints = np.array([times_s]).T, np.array(joints_deg)
    grip = np.full((len(times), 1), math.nan)
    return Recording("r", samples=np.hstack((times, joints, grip)))


ACROSS = pose_near(HERE, (60, -150, 40), 8.0)


def test_nothing_is_found_in_a_sound_trajectory() -> None:
    report = checked(joint(*HERE, speed=30), line(ACROSS), pose(pose_near(HERE), speed=30))

    assert found(report) == []
    assert report.path.duration_s > 1.0


def test_a_target_beyond_a_limit_names_joint_value_and_limits() -> None:
    report = checked(joint(10, 70, -60, 101.5, 25, -20, speed=30))

    (finding,) = [each for each in report.findings if each.code == "target_beyond_limit"]
    assert finding.row == 0
    assert finding.severity is Severity.ERROR
    assert finding.params == {"joint": 4, "value": 101.5, "minimum": -100.0, "maximum": 100.0}
    assert finding.joints_deg == (10, 70, -60, 101.5, 25, -20)


def test_a_row_beyond_the_limits_is_told_as_that_first() -> None:
    report = checked(joint(*HERE), joint(0, -30, 10, 0, 60, 0), joint(*HERE))

    assert [code for code, row in found(report) if row == 1][:2] == [
        "target_beyond_limit",
        "links_collide",
    ]


def test_each_row_beyond_the_limits_is_told_also_behind_one_that_is_further_beyond() -> None:
    report = checked(joint(0, -40, -60, 0, 0, 0), joint(0, -30, -60, 0, 0, 0), joint(*HERE))

    beyond = [one for one in report.findings if one.code == "target_beyond_limit"]
    assert [(one.row, one.params["value"]) for one in beyond] == [(0, -40.0), (1, -30.0)]


def test_the_limits_are_those_read_from_the_arm() -> None:
    limits = list(ARM.limits)
    limits[1] = limits[1]._replace(max_deg=60.0)

    report = check(CheckRequest(run(joint(*HERE)), replace(ARM, limits=tuple(limits)), HERE))

    assert ("target_beyond_limit", 0) in found(report)


def test_an_arm_beyond_a_limit_may_come_back() -> None:
    sagged = (10.0, -0.6, -60.0, 10.0, 25.0, -20.0)

    report = checked(joint(10, 20, -60, 10, 25, -20, speed=20), start=sagged)

    assert found(report) == []


def test_a_line_that_leaves_the_limits_between_its_ends_is_found() -> None:
    # the chord comes nearer to the axis than its ends: the elbow bends on the way
    chord = line(pose_near(HERE, (0, -200, -60)))
    path = plan_path(run(chord), ARM, HERE).joints_deg[:, 2]
    ends_deg = max(path[0], path[-1])
    assert path.max() > ends_deg + 3.0
    limits = list(ARM.limits)
    limits[2] = limits[2]._replace(max_deg=float(ends_deg) + 1.0)

    report = check(CheckRequest(run(chord), replace(ARM, limits=tuple(limits)), HERE))

    (finding,) = report.errors
    assert (finding.code, finding.row) == ("path_beyond_limit", 0)
    assert finding.params["joint"] == 3
    assert finding.params["value"] == pytest.approx(path.max())


def test_what_cannot_be_planned_is_an_error() -> None:
    report = checked(pose((900.0, 0.0, 300.0, 0.0, 90.0, 0.0)))

    assert ("out_of_reach", 0) in found(report)
    assert report.errors
    assert report.errors[0].place_mm is not None


def test_a_line_past_a_singular_pose_is_a_warning() -> None:
    begin, end = (0, 80, -80, 0, 25, 0), (0, 80, -80, 0, -25, 0)

    report = checked(joint(*begin), line(KINEMATICS.forward(end)), start=begin)

    assert found(report) == [("near_singular", 1)]
    assert report.errors == ()
    joints = report.findings[0].joints_deg
    assert joints is not None
    assert abs(joints[4]) < 3.0


def test_joints_may_pass_a_singular_pose() -> None:
    assert found(checked(joint(0, 80, -80, 0, -14, 0), start=(0, 80, -80, 0, 14, 0))) == []


def test_a_first_point_far_away_is_a_warning() -> None:
    report = checked(joint(50, 70, -60, 10, 25, -20, speed=20))

    assert found(report) == [("far_from_start", 0)]
    assert report.findings[0].params == {"joint": 1, "value": 40.0}


def test_another_way_to_hold_a_pose_is_a_warning() -> None:
    near, other = (10, 70, -60, -60, 25, 20), (10, 70, -60, 60, 25, -80)

    report = checked(joint(*near), pose(KINEMATICS.forward(other), speed=20), start=near)

    assert ("large_turn", 1) in found(report)


def test_a_tool_faster_than_its_limit_is_a_warning_on_motions_of_joints() -> None:
    start, end = (-60, 100, -60, 0, 0, 0), (60, 100, -60, 0, 0, 0)

    fast, slow = (
        found(checked(joint(*start), joint(*end, speed=speed), start=start)) for speed in (100, 30)
    )

    assert fast == [("tool_too_fast", 1)]
    assert slow == []


def test_the_tip_below_the_floor_is_a_warning_with_the_deepest_place() -> None:
    low = (0.0, 120.0, -60.0, 0.0, 60.0, 0.0)

    report = checked(joint(*low, speed=20), start=low)

    finding = report.findings[0]
    assert (finding.code, finding.row) == ("below_floor", 0)
    matrix = KINEMATICS.matrix(low)
    tip_mm = matrix[2, 3] + 140.0 * matrix[2, 2]
    assert tip_mm < -10.0
    assert finding.params["value"] == pytest.approx(-tip_mm, abs=0.06)
    assert finding.place_mm is not None
    assert finding.place_mm[2] == pytest.approx(tip_mm)
    without = replace(ARM, tool_mm=0.0)
    assert (matrix[2, 3] < 0.0) == bool(
        check(CheckRequest(run(joint(*low)), without, low)).findings
    )


def test_a_gripper_beyond_its_stroke_is_an_error() -> None:
    wide = replace(joint(*HERE), gripper=GripperOpening(70.5))

    assert found(checked(wide)) == [("gripper_beyond_stroke", 0)]
    assert found(check(CheckRequest(run(wide), replace(ARM, stroke_mm=None), HERE))) == []


def test_an_empty_trajectory_is_an_error() -> None:
    assert found(checked()) == [("empty", None)]
    assert found(check(CheckRequest(Recording("r"), ARM, HERE))) == [("empty", None)]


# The arm against itself ---------------------------------------------------------------------------


def test_the_hand_in_the_base_is_an_error() -> None:
    draw = np.random.default_rng(2)
    low, high = (-150, 0, -170, -100, -70, -120), (150, 180, 0, 100, 70, 120)
    joints = draw.uniform(low, high, (60_000, 6))

    hits = collisions(KINEMATICS.geometry, joints, 140.0)

    assert len(hits) < 3000
    bones = links(KINEMATICS.geometry, joints)
    tips = bones.flange + 140.0 * bones.hand
    inside = (np.hypot(tips[:, 0], tips[:, 1]) < 30) & (tips[:, 2] > 10) & (tips[:, 2] < 120)
    assert inside.any()
    assert set(np.flatnonzero(inside).tolist()) <= set(hits)
    hit = joints[min(hits)]
    report = checked(joint(*hit), start=hit)
    finding = next(each for each in report.findings if each.code == "links_collide")
    assert finding.severity is Severity.ERROR
    body = OwnBody(KINEMATICS.geometry, 140.0)
    touching = dict(zip(body.pairs, body.gaps([hit])[0] < 0.0, strict=True))
    assert touching[f"{finding.params['one']}/{finding.params['other']}"]


def test_the_arm_at_rest_and_at_work_touches_nothing() -> None:
    poses = np.array([(0,) * 6, (0, 90, -90, 0, 0, 0), HERE, (90, 60, -80, -20, 40, 60)], float)

    assert collisions(KINEMATICS.geometry, poses, 140.0) == {}
    assert collisions(KINEMATICS.geometry, poses, 0.0) == {}


def test_a_collision_on_the_way_is_found_though_both_ends_are_free() -> None:
    start, end = (-16, 81, -2, 51, 31, 59), (9, 93, -7, -63, 70, 117)
    assert collisions(KINEMATICS.geometry, np.array([start, end], dtype=float), 140.0) == {}

    report = checked(joint(*start), joint(*end), start=start)

    assert ("links_collide", 1) in found(report)


FREE = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)


def hits_of(report: CheckOutcome) -> list[tuple[int | None, bool]]:
    return [(one.row, one.approach) for one in report.findings if one.code == "links_collide"]


def self_hit() -> tuple[float, ...]:
    """A pose within the limits in which the arm touches its base."""
    draw = np.random.default_rng(4)
    low, high = (-150, 0, -170, -100, -70, -120), (150, 180, 0, 100, 70, 120)
    joints = draw.uniform(low, high, (60_000, 6))
    (first, *_) = sorted(collisions(KINEMATICS.geometry, joints, 140.0))
    return tuple(joints[first].tolist())


def test_an_arm_that_has_sunk_into_itself_is_told_of_where_it_stands() -> None:
    hit = self_hit()
    assert hits_of(checked(joint(*FREE), joint(*HERE), start=hit)) == [(0, True)]
    # the point itself is another matter
    assert (0, False) in hits_of(checked(joint(*hit), start=hit))
    assert hits_of(checked(joint(*FREE), joint(*hit), start=FREE)) == [(1, False)]


def test_a_collision_on_the_way_to_the_first_point_is_not_the_points() -> None:
    start, end = (-16, 81, -2, 51, 31, 59), (9, 93, -7, -63, 70, 117)
    assert hits_of(checked(joint(*end), start=start)) == [(0, True)]
    assert hits_of(checked(joint(*start), joint(*end), start=start)) == [(1, False)]


def test_the_distance_of_two_segments_is_the_least_of_all_their_points() -> None:
    draw = np.random.default_rng(6)
    a, b, c, d = draw.uniform(-100, 100, (4, 40, 3))
    b[0], d[0] = a[0] + (50, 0, 0), c[0] + (30, 0, 0)  # parallel
    d[1] = c[1]  # a point
    shares = np.linspace(0.0, 1.0, 201)[:, None, None]
    one, other = a + shares * (b - a), c + shares * (d - c)

    for index, gap in enumerate(segment_distances(a, b, c, d)):
        apart = np.linalg.norm(one[:, None, index] - other[None, :, index], axis=2).min()
        assert gap <= apart + 1e-9
        assert gap == pytest.approx(apart, abs=1.5)


# Recordings ---------------------------------------------------------------------------------------


def test_a_sound_recording_has_no_findings() -> None:
    ways = np.linspace(HERE, np.add(HERE, 20.0), 101)

    assert found(check(CheckRequest(recording(np.linspace(0, 5, 101), ways), ARM, HERE))) == []


def test_a_recording_too_fast_for_the_arm_tells_the_speed_that_would_do() -> None:
    ways = np.linspace(HERE, np.add(HERE, (40.0, 0, 0, 0, 0, 0)), 41)
    report = check(CheckRequest(recording(np.linspace(0, 0.16, 41), ways), ARM, HERE))

    finding = next(each for each in report.findings if each.code == "joint_too_fast")
    assert finding.params["joint"] == 1
    assert finding.params["value"] == pytest.approx(250.0, abs=1.0)
    assert finding.params["percent"] == 68
    assert finding.severity is Severity.WARNING, "it caps the speed of the replay"


def test_a_jump_and_a_limit_in_a_recording_are_named_once() -> None:
    ways = np.tile(HERE, (100, 1)).astype(float)
    ways[40:, 0] += 8.0
    ways[60:80, 4] = np.concatenate((np.linspace(26, 70.5, 10), np.linspace(70.5, 26, 10)))

    report = check(CheckRequest(recording(np.linspace(0, 10, 100), ways), ARM, HERE))

    assert ("sample_jump", 40) in found(report)
    assert found(report).count(("target_beyond_limit", 69)) == 1
    assert sum(code == "target_beyond_limit" for code, _ in found(report)) == 1
    line = finding_line(next(each for each in report.findings if each.severity is Severity.ERROR))
    assert re.match(r"✕ Error · Sample \d+, at \d+\.\d+ s: Joint ", line)
    assert line.endswith("°. Trim the recording there, or save it as points and change those.")


def test_a_recording_that_begins_outside_is_replayed_from_its_first_sample_inside() -> None:
    rest = (0.0, -2.0, 2.0, 0.0, 20.0, 0.0)
    ways = np.linspace(rest, (0.0, 30.0, -30.0, 0.0, 20.0, 0.0), 161)
    content = recording(np.linspace(0, 16, 161), ways)
    report = check(CheckRequest(content, ARM, HERE))
    (begins,) = [each for each in report.findings if each.code == "begins_outside"]
    assert (begins.row, begins.params["seconds"], begins.severity) == (10, 1.0, Severity.WARNING)
    assert not report.errors
    assert isinstance(report.as_checked, Recording)
    assert report.as_checked.joints_deg[0] == pytest.approx(ways[10])
    assert report.path.rows.min() == 10
    wholly = recording(np.linspace(0, 16, 161), np.tile(rest, (161, 1)))
    assert "target_beyond_limit" in {
        code for code, _ in found(check(CheckRequest(wholly, ARM, HERE)))
    }


def test_errors_come_before_warnings_of_the_same_row() -> None:
    report = checked(joint(100, 70, -60, 101.5, 25, -20))

    severities = [finding.severity for finding in report.findings if finding.row == 0]
    assert len(severities) > 1
    assert severities == sorted(severities, key=lambda each: each is Severity.WARNING)


def held(*poses: Sequence[float]) -> Recording:
    """A recording that goes slowly from pose to pose."""
    ways = np.vstack([np.linspace(a, b, 201) for a, b in pairwise(poses)])
    return recording(np.linspace(0, 20.0 * (len(poses) - 1), len(ways)), ways)


def test_a_recording_is_not_blamed_for_where_the_arm_stands_or_the_way_to_it() -> None:
    hit, near = self_hit(), tuple(angle + 5.0 for angle in FREE)
    free = held(FREE, near)
    assert hits_of(check(CheckRequest(free, ARM, FREE))) == []
    assert hits_of(check(CheckRequest(free, ARM, hit))) == [(0, True)]
    assert hits_of(check(CheckRequest(held(hit, FREE), ARM, hit)))[0] == (0, False)
    ((row, approach),) = hits_of(check(CheckRequest(held(FREE, hit), ARM, FREE)))
    assert (row is not None and row > 0, approach) == (True, False)
    start, end = (-16, 81, -2, 51, 31, 59), (9, 93, -7, -63, 70, 117)
    assert hits_of(check(CheckRequest(held(end, end), ARM, start))) == [(0, True)]


def test_the_way_to_a_recording_may_be_low_or_fast_without_its_fault() -> None:
    low = (0.0, 170.0, -20.0, 0.0, 0.0, 0.0)
    (found_low,) = [
        each
        for each in check(CheckRequest(held(FREE, HERE), ARM, low)).findings
        if each.code == "below_floor"
    ]
    assert (found_low.row, found_low.approach) == (0, True)
    (of_it,) = [
        each
        for each in check(CheckRequest(held(low, low), ARM, FREE)).findings
        if each.code == "below_floor"
    ]
    assert not of_it.approach
    slow = replace(ARM, end_limits=EndLimits(0.02, 1.0, 1.0, 1.0))
    swing = (FREE[0] + 60.0, *FREE[1:])
    fast = [
        each
        for each in check(CheckRequest(held(FREE, FREE), slow, swing)).findings
        if each.code == "tool_too_fast"
    ]
    assert [(each.row, each.approach) for each in fast] == [(0, True)]


REST = (0.0, -1.9, 1.8, -1.4, 22.0, -2.6)
OUT = (0.0, 30.0, -30.0, 0.0, 20.0, 0.0)


def test_a_recording_that_ends_as_an_arm_lies_at_rest_is_replayed_up_to_there() -> None:
    ways = np.vstack((np.linspace(OUT, REST, 81), np.linspace(REST, REST, 20)))
    report = check(CheckRequest(recording(np.linspace(0, 10, 101), ways), ARM, HERE))
    assert not report.errors
    (ends,) = [each for each in report.findings if each.code == "ends_outside"]
    assert isinstance(report.as_checked, Recording)
    count = len(report.as_checked.samples)
    assert 70 < count < 77  # the limits, and a little before, where the hand comes to its base
    assert report.as_checked.joints_deg == pytest.approx(ways[:count])
    assert (ends.row, ends.params["seconds"]) == (count - 1, round(0.1 * (101 - count), 1))
    further = np.linspace(OUT, (0.0, -6.0, 5.0, 0.0, 20.0, 0.0), 101)
    report = check(CheckRequest(recording(np.linspace(0, 10, 101), further), ARM, HERE))
    assert {each.code for each in report.errors} >= {"target_beyond_limit"}


def test_a_recording_that_trembles_about_its_limits_at_rest_can_be_run() -> None:
    trembling = [
        (0, 0.1 * (-1) ** k, -0.1 * (-1) ** (k // 2), -1.4, 22, -2.6) for k in range(10, 41)
    ]
    ways = np.vstack((trembling[1:], np.linspace(trembling[1], OUT, 80)))
    report = check(CheckRequest(recording(np.linspace(0, 11, 110), ways), ARM, REST))
    assert not report.errors
    assert report.path.joints_deg[-1] == pytest.approx(OUT)
    assert report.path.rows.min() >= 29


def test_points_that_lie_outside_as_at_rest_are_led_inside_and_others_are_not() -> None:
    report = checked(joint(*REST), joint(*OUT), joint(*REST))
    assert not report.errors
    assert found(report)[-2:] == [("lies_outside", 0), ("lies_outside", 2)]
    assert isinstance(report.as_checked, Trajectory)
    led = pytest.approx((0.0, 0.5, -0.5, -1.4, 15.0, -2.6))
    assert [point.target for point in report.as_checked.points] == [led, OUT, led]
    for further in ((0, -4.0, 0, 0, 10, 0), (0, 30, 5.0, 0, 20, 0), (151.0, *REST[1:])):
        report = checked(joint(*OUT), joint(*further))
        assert "target_beyond_limit" in {each.code for each in report.errors}
        assert report.as_checked is None
