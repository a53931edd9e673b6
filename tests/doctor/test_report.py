"""The report in both languages, as text and as JSON."""

from __future__ import annotations

import json

import pytest

from armui.doctor.judge import LINK_DOWN
from armui.doctor.report import Words, as_json, as_text, findings_of_json
from armui.system.plain_words import language_of_system, translation

FINDING = LINK_DOWN("sudo ip link set can0 up", channel="can0")
EN, ZH = Words(translation("en")), Words(translation("zh"))


def test_the_report_in_english():
    text = as_text([FINDING], EN, arm_answers=False, asked=False)
    assert "nothing was sent" in text
    assert "CAN devices\n[FAIL] can0 is switched off." in text
    assert "\n       $ sudo ip link set can0 up\n" in text
    assert text.endswith("No arm answers.\n")


def test_the_report_in_chinese():
    text = as_text([FINDING], ZH, arm_answers=True, asked=True)
    assert "[故障] can0 未启用" in text
    assert text.endswith("机械臂有应答。\n")


def test_json_and_back():
    text = as_json([FINDING], EN, arm_answers=True, asked=False)
    content = json.loads(text)
    assert content["arm_answers"] is True
    assert content["findings"][0]["commands"] == ["sudo ip link set can0 up"]
    assert findings_of_json(text) == [FINDING]


@pytest.mark.parametrize(
    ("environment", "content", "expected"),
    [
        ({"LANG": "zh_CN.UTF-8"}, None, "zh"),
        ({"LANG": "en_US.UTF-8"}, None, "en"),
        ({"LC_ALL": "C", "LANG": "en_US.UTF-8"}, None, "zh"),
        ({"LC_ALL": "C.UTF-8"}, None, "zh"),
        ({"LANG": "POSIX"}, None, "zh"),
        ({"LANG": "fr_FR.UTF-8"}, None, "en"),
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


@pytest.mark.parametrize(
    ("interface", "expected"),
    [
        (["zh-Hans-CN", "zh"], "zh"),
        (["en-Latn-US", "en"], "en"),
        (["de-DE", "zh-CN"], "en"),
        (["C"], "zh"),
    ],
)
def test_where_the_environment_is_silent_the_system_is_asked(monkeypatch, interface, expected):
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    assert language_of_system(interface=interface) == expected
