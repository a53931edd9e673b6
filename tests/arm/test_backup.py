"""The file of 参数备份: written, read, and everything that can be wrong with one."""

import json
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.arm.backup import (
    BACKUP_EMPTY,
    BACKUP_FIELD_BAD,
    BACKUP_FOREIGN,
    BACKUP_NO_JSON,
    Backup,
    ComparisonVerdict,
    compare,
    from_text,
    to_text,
)
from armui.arm.limits import JointLimits
from armui.arm.parameters import SETTING_OUT_OF_RANGE, Parameter, all_batches
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Reading
from armui.protocol.generation import PiperModel

BATCHES = list(all_batches(teaching=True, drag_assistance=True))
EVERY = [each for batch in BATCHES for each in batch.parameters()]
MAX_J1 = Parameter("max_angle_deg", 1)
MIN_J1 = Parameter("min_angle_deg", 1)
LINEAR = Parameter("max_linear_speed_m_s")

BACKUP = Backup(
    saved_at=datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC),
    program="armui 0.1.0",
    generation=2,
    firmware="S-V1.8-5",
    device="仿真机械臂",
    values={MAX_J1: 150.0, LINEAR: 0.5},
)

TEXT = """{
  "format": "armui-parameters",
  "version": 1,
  "saved_at": "2026-01-02T03:04:05+00:00",
  "program": "armui 0.1.0",
  "arm": {
    "generation": 2,
    "firmware": "S-V1.8-5",
    "device": "仿真机械臂"
  },
  "parameters": [
    {"name": "max_angle_deg", "joint": 1, "value": 150.0, "unit": "°"},
    {"name": "max_linear_speed_m_s", "value": 0.5, "unit": "m/s"}
  ]
}
"""


def test_the_file_is_for_people():
    assert to_text(BACKUP) == TEXT


def test_what_was_written_is_read():
    assert from_text(TEXT) == BACKUP


@given(
    values=st.dictionaries(
        st.sampled_from(EVERY),
        st.floats(-1e6, 1e6).map(lambda value: round(value, 6)),
        min_size=1,
    ),
    generation=st.sampled_from([1, 2]),
    firmware=st.none() | st.text(),
    device=st.text(),
    saved_at=st.datetimes(timezones=st.just(UTC)).map(lambda time: time.replace(microsecond=0)),
)
def test_every_backup_comes_back_as_it_was(values, generation, firmware, device, saved_at):
    backup = Backup(saved_at, "armui 9", generation, firmware, device, values)
    assert from_text(to_text(backup)) == backup


@given(st.data())
def test_a_truncated_file_is_never_taken(data):
    length = data.draw(st.integers(0, len(TEXT.rstrip()) - 1))
    assert isinstance(from_text(TEXT[:length]), Refusal)


@given(
    st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
        lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    )
)
def test_foreign_json_is_refused_in_words(value):
    assert from_text(json.dumps(value)).reason == BACKUP_FOREIGN


JSON_LIKE = (
    st.none() | st.booleans() | st.integers(-9, 9) | st.floats() | st.text() | st.lists(st.text())
)


@given(
    field=st.sampled_from(["version", "saved_at", "program", "arm", "parameters"]),
    value=JSON_LIKE,
)
def test_any_field_may_be_anything_and_nothing_breaks(field, value):
    result = from_text(json.dumps(json.loads(TEXT) | {field: value}))
    assert isinstance(result, Backup | Refusal)


@given(
    field=st.sampled_from(["name", "joint", "value", "unit"]),
    value=JSON_LIKE,
)
def test_any_figure_may_be_anything_and_nothing_breaks(field, value):
    entries = json.loads(TEXT)
    entries["parameters"][0][field] = value
    result = from_text(json.dumps(entries))
    if isinstance(result, Refusal):
        assert result.params["field"] == f"parameters[1].{field}"
    else:
        assert set(result.values) >= {LINEAR}


@pytest.mark.parametrize(
    ("old", "new", "code", "params"),
    [
        ('"version": 1,', '"version": 1', "backup_no_json", {"line": 4, "column": 3}),
        ("armui-parameters", "something", "backup_foreign", {}),
        ('"version": 1', '"version": 2', "backup_version", {"version": "2", "known": 1}),
        ('"version": 1', '"version": true', "backup_version", {"version": "True", "known": 1}),
        ('"program": "armui 0.1.0",', "", "backup_field_missing", {"field": "program"}),
        ('"generation": 2,', "", "backup_field_missing", {"field": "arm.generation"}),
        ('on": 2', 'on": 3', "backup_field_bad", {"field": "arm.generation", "value": "3"}),
        (
            "+00:00",
            "",
            "backup_field_bad",
            {"field": "saved_at", "value": "2026-01-02T03:04:05"},
        ),
        (
            '"joint": 1',
            '"joint": 7',
            "backup_field_bad",
            {"field": "parameters[1].joint", "value": "7"},
        ),
        (
            '"m/s"',
            '"mm/s"',
            "backup_field_bad",
            {"field": "parameters[2].unit", "value": "mm/s"},
        ),
        ("0.5", "NaN", "backup_field_bad", {"field": "parameters[2].value", "value": "nan"}),
        ("0.5", '"0.5"', "backup_field_bad", {"field": "parameters[2].value", "value": "0.5"}),
        ("0.5", "true", "backup_field_bad", {"field": "parameters[2].value", "value": "True"}),
        (
            "0.5",
            "1" + "0" * 400,
            "backup_field_bad",
            {"field": "parameters[2].value", "value": "10^308…"},
        ),
        (
            '"name": "max_linear_speed_m_s"',
            '"name": "warp"',
            "backup_field_bad",
            {"field": "parameters[2].name", "value": "warp"},
        ),
        (
            '{"name": "max_linear_speed_m_s", "value": 0.5, "unit": "m/s"}',
            '{"name": "max_angle_deg", "joint": 1, "value": 0.5, "unit": "°"}',
            "backup_twice",
            {"field": "parameters[2]", "parameter": "max_angle_deg"},
        ),
    ],
)
def test_what_is_wrong_is_named_with_its_place(old, new, code, params):
    assert TEXT.count(old) == 1
    refusal = from_text(TEXT.replace(old, new))
    assert (refusal.code, refusal.params) == (code, params)


def test_an_empty_list_and_a_pit_of_brackets():
    entries = json.loads(TEXT) | {"parameters": []}
    assert from_text(json.dumps(entries)).reason == BACKUP_EMPTY
    assert from_text("[" * 100_000).reason in {BACKUP_FOREIGN, BACKUP_NO_JSON}


# Comparison ---------------------------------------------------------------------------------------

STATE = ArmState()._replace(limits=(Reading(JointLimits(-150.0, 140.0, 170.0), 1.0), *(None,) * 5))


def verdicts(filed, known, same=lambda _parameter, value: value == -150.0):
    return {row.parameter: row.verdict for row in compare(filed, STATE, known, same)}


def test_every_way_in_which_file_and_arm_can_compare():
    speed = Parameter("max_speed_deg_s", 1)
    stroke = Parameter("stroke_limit_mm")
    filed = {MAX_J1: 150.0, MIN_J1: -150.0, LINEAR: 0.5, stroke: 70.0}
    assert verdicts(filed, [MAX_J1, MIN_J1, speed, LINEAR]) == {
        MAX_J1: ComparisonVerdict.DIFFERS,
        MIN_J1: ComparisonVerdict.SAME,
        speed: ComparisonVerdict.ONLY_IN_ARM,
        LINEAR: ComparisonVerdict.NOT_READ,
        stroke: ComparisonVerdict.ONLY_IN_FILE,
    }


def test_what_the_arm_could_not_be_sent_is_not_restorable():
    rows = compare({MAX_J1: 6553.5, LINEAR: 0.5}, STATE, [MAX_J1, LINEAR], lambda *_: False)
    assert [row.restorable for row in rows] == [False, True]
    assert rows[0].against.reason == SETTING_OUT_OF_RANGE


def test_the_model_stands_in_the_file_and_older_files_have_none():
    of_x = replace(BACKUP, model=PiperModel.PIPER_X)
    assert '"model": "piper_x"' in to_text(of_x)
    assert from_text(to_text(of_x)) == of_x
    assert from_text(TEXT).model is None
    refusal = from_text(to_text(of_x).replace("piper_x", "nero"))
    assert refusal.reason == BACKUP_FIELD_BAD
    assert refusal.params["field"] == "arm.model"
