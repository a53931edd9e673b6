"""The words: each finding has them, in both languages, with the same gaps."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path

import pytest

from armui.doctor.facts import Diagnosis, DiagnosisLevel, Section
from armui.doctor.report import Words, as_json, as_text, findings_of_json, language_of_system

DOCTOR = Path(__file__).parents[2] / "armui" / "doctor"
TEXTS = tomllib.loads(
    (DOCTOR.parents[1] / "resources" / "doctor" / "texts.toml").read_text("utf-8")
)
CODE = re.compile(r'(?:_finding\(|Diagnosis\(\s*Section\.\w+,)\s*"(\w+)"')
GAP = re.compile(r"\{(\w+)\}")
FINDING = Diagnosis(
    Section.CAN,
    "link_down",
    DiagnosisLevel.FAULT,
    {"channel": "can0"},
    ("sudo ip link set can0 up",),
)


def codes_in_source() -> set[str]:
    source = "".join(each.read_text("utf-8") for each in DOCTOR.glob("judge*.py"))
    problems = re.search(r"_PROBLEMS: Final = \((.*?)\)", source, re.DOTALL)
    return set(CODE.findall(source)) | set(re.findall(r'"(\w+)"', problems.group(1)))


def test_every_finding_has_words_and_every_word_a_finding():
    assert codes_in_source() == set(TEXTS["finding"])


@pytest.mark.parametrize("code", TEXTS["finding"])
def test_both_languages_mention_the_same(code):
    text = TEXTS["finding"][code]
    assert set(GAP.findall(text["en"])) == set(GAP.findall(text["zh"]))
    assert re.search("[\u4e00-\u9fff]", text["zh"])


def test_the_report_in_english():
    text = as_text([FINDING], Words("en"), arm_answers=False, asked=False)
    assert "nothing was sent" in text
    assert "CAN devices\n[FAIL] can0 is switched off." in text
    assert "\n       $ sudo ip link set can0 up\n" in text
    assert text.endswith("No arm answers.\n")


def test_the_report_in_chinese():
    text = as_text([FINDING], Words("zh"), arm_answers=True, asked=True)
    assert "[故障] can0 未启用" in text
    assert text.endswith("机械臂有应答。\n")


def test_json_and_back():
    text = as_json([FINDING], Words("en"), arm_answers=True, asked=False)
    content = json.loads(text)
    assert content["arm_answers"] is True
    assert content["findings"][0]["commands"] == ["sudo ip link set can0 up"]
    assert findings_of_json(text) == [FINDING]


@pytest.mark.parametrize(
    ("environment", "content", "expected"),
    [
        ({"LANG": "zh_CN.UTF-8"}, None, "zh"),
        ({"LANG": "en_US.UTF-8"}, None, "en"),
        ({"LC_ALL": "C", "LANG": "zh_CN.UTF-8"}, None, "en"),
        ({"LANG": "zh_CN.UTF-8"}, '{"language": "en"}', "en"),
        ({"LANG": "de_DE.UTF-8"}, '{"language": "zh"}', "zh"),
        ({"LANG": "zh_TW"}, "no json", "zh"),
        ({"LANG": "zh_TW"}, "[1]", "zh"),
    ],
)
def test_the_language_of_the_program_or_the_system(
    tmp_path, monkeypatch, environment, content, expected
):
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    path = tmp_path / "settings.json"
    if content is not None:
        path.write_text(content)
    assert language_of_system(path) == expected
