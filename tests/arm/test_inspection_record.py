"""What stands out of a joint's figures, and what of them is kept: pure."""

import json
from dataclasses import replace

import pytest

from armui.arm.inspection_record import (
    KEPT,
    InspectionEntry,
    JointFigures,
    JointSign,
    ResumeEntry,
    findings,
)
from armui.arm.reference_record import ReferenceRecord, merged_entry, read_record

HEALTHY = (
    JointFigures(0.40, 0.01, 0.11, 32.0, 33.0),
    JointFigures(0.42, -2.60, 0.13, 36.0, 35.0),
    JointFigures(0.41, 1.70, 0.10, 33.0, 33.0),
    JointFigures(0.35, 0.05, 0.38, 31.0, 32.0),
    JointFigures(0.36, -0.40, 0.42, 32.0, 32.0),
    JointFigures(0.37, 0.00, 0.35, 31.0, 31.0),
)
AT = "2026-11-27T10:00:00"


def entry(speed_deg_s=10.0, **changes):
    """Healthy joints but for some figures: `j3=dict(current_a=1.0)`."""
    joints: list[JointFigures | None] = list(HEALTHY)
    for name, figures in changes.items():
        place = int(name[1]) - 1
        joints[place] = None if figures is None else replace(HEALTHY[place], **figures)
    return InspectionEntry(AT, speed_deg_s, tuple(joints))


def said(now, *earlier):
    return [(each.joint, each.sign, each.earlier) for each in findings(now, earlier)]


def test_of_healthy_joints_nothing_stands_out_however_much_they_bear():
    assert said(entry(), entry(), entry()) == []
    assert said(entry(j2={"bears_a": 9.0})) == []


def test_large_and_small_motors_are_no_peers():
    """A small one takes three times the current of a large one to turn: that is no finding."""
    large, small = (HEALTHY[place].current_a or 0.0 for place in (0, 3))
    assert small > 3 * large
    assert said(entry(j2={"current_a": 0.45})) == [(2, JointSign.CURRENT, False)]


@pytest.mark.parametrize(
    ("figures", "sign"),
    [
        ({"behind_deg": 0.9}, JointSign.BEHIND),
        ({"current_a": 1.2}, JointSign.CURRENT),
        ({"motor_c": 58.0}, JointSign.MOTOR),
        ({"driver_c": 58.0}, JointSign.DRIVER),
    ],
)
def test_what_is_unlike_its_peers_stands_out(figures, sign):
    (found,) = findings(entry(j5=figures), ())
    assert (found.joint, found.sign, found.earlier) == (5, sign, False)
    assert found.value == next(iter(figures.values()))
    assert found.usual == pytest.approx(getattr(HEALTHY[3], sign), rel=0.2)


def test_what_has_grown_stands_out_before_it_is_unlike_its_peers():
    worn = entry(j1={"current_a": 0.29})
    assert said(worn) == []
    assert said(worn, entry(), entry()) == [(1, JointSign.CURRENT, True)]
    assert said(entry(j4={"behind_deg": 0.6}), entry()) == [(4, JointSign.BEHIND, True)]


def test_one_odd_earlier_time_is_outvoted():
    worn = entry(j1={"current_a": 0.29})
    assert said(worn, worn, entry(), entry()) == [(1, JointSign.CURRENT, True)]


def test_another_speed_is_not_compared():
    assert said(entry(j1={"current_a": 0.29}), entry(speed_deg_s=5.0)) == []


def test_joints_that_were_not_measured_are_left_out():
    assert said(entry(j1=None, j2=None, j3={"current_a": 2.0})) == []  # no peers
    assert said(entry(j6=None, j5={"behind_deg": 0.9})) == [(5, JointSign.BEHIND, False)]


def test_a_current_without_a_sign_is_not_judged():
    now = entry(**{f"j{joint}": {"current_a": None} for joint in range(1, 7)})
    assert said(now, entry()) == []


# What is kept -------------------------------------------------------------------------------------

RESUME = ResumeEntry(AT, (0.0, 5.0, None, 0.1, -0.2, 0.0))


def test_it_is_read_as_it_was_kept():
    record = ReferenceRecord(inspections=(entry(j6=None), entry()), resumes=(RESUME,))
    assert read_record(json.loads(json.dumps(record.as_entry()))) == record


@pytest.mark.parametrize(
    "strange",
    [
        None,
        "x",
        [None, 5, "x", {}],
        [{"at": 5, "speed_deg_s": 10.0, "joints": [None] * 6, "slips_deg": [0.0] * 6}],
        [{"at": AT, "speed_deg_s": "fast", "joints": [None] * 6, "slips_deg": [0.0] * 5}],
        [{"at": "x" * 5000, "speed_deg_s": 10.0, "joints": [None] * 6, "slips_deg": [0.0] * 6}],
        [{"at": AT, "speed_deg_s": 10.0, "joints": [None] * 7, "slips_deg": "000000"}],
    ],
)
def test_what_is_not_understood_costs_neither_the_program_nor_the_doubt(strange):
    kept = ReferenceRecord((2,)).as_entry() | {"inspections": strange, "resumes": strange}
    record = read_record(kept)
    assert record.doubtful == (2,)
    assert (record.inspections, record.resumes) == ((), ())


def test_two_programs_keep_what_each_has_seen():
    mine = ReferenceRecord(resumes=(RESUME,))
    theirs = replace(RESUME, at="2026-11-27T11:00:00")
    found = ReferenceRecord(resumes=(theirs,)).as_entry()
    merged = read_record(merged_entry(ReferenceRecord(), mine, json.loads(json.dumps(found))))
    assert merged.resumes == (theirs, RESUME)


def test_no_more_than_ten_are_kept():
    found = ReferenceRecord(inspections=(entry(),) * 30).as_entry()
    assert len(read_record(found).inspections) == KEPT
