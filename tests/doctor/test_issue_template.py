"""The form for a report asks for what the program can print, by the names it has."""

from __future__ import annotations

import re
from pathlib import Path

FORM = Path(__file__).parents[2] / ".github" / "ISSUE_TEMPLATE" / "bug.yml"
ROOT = FORM.parents[2]


def test_commands_and_buttons_that_the_form_names_exist():
    text = FORM.read_text("utf-8")
    commands = set(re.findall(r"`armui ([a-z]+)", text))
    assert {"doctor", "decode"} <= commands
    source = (ROOT / "armui" / "cli.py").read_text("utf-8")
    assert all(f'"{each}":' in source for each in commands)
    words = (ROOT / "resources" / "i18n" / "armui_zh.ts").read_text("utf-8")
    for label in ("设置", "诊断", "复制报告", "关于本机械臂", "复制为文本"):
        assert label in text
        assert f">{label}" in words


def test_the_report_is_required():
    fields = re.split(r"\n  - type: ", FORM.read_text("utf-8"))
    (doctor,) = [each for each in fields if "id: doctor" in each]
    assert "required: true" in doctor
