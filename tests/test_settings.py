"""The settings: kept between runs, checked field by field, never lost in a half-written file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from armui.setting_checks import JOG_STEP_NOT_A_NUMBER, JOG_STEP_OUT_OF_RANGE, TOOL_NOT_POSSIBLE
from armui.setting_fields import DECLARED, Settings, check
from armui.settings import SETTINGS_NOT_SAVED, SettingsStore, default_path


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "deep" / "settings.json"


def written(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True)
    path.write_text(text, encoding="utf-8")
    return path


def test_a_first_language_holds_until_the_file_has_one(tmp_path):
    path = tmp_path / "settings.json"
    assert SettingsStore(path, first={"language": "en"}).settings.language == "en"
    path.write_text('{"language": "zh"}')
    assert SettingsStore(path, first={"language": "en"}).settings.language == "zh"


def test_a_first_language_that_nobody_chose_is_not_saved(tmp_path):
    path = tmp_path / "settings.json"
    assert SettingsStore(path, first={"language": "en"}).change(theme="dark") is None
    assert SettingsStore(path, first={"language": "zh"}).settings.language == "zh"
    assert SettingsStore(path, first={"language": "zh"}).change(language="en") is None
    assert SettingsStore(path, first={"language": "zh"}).settings.language == "en"


def test_first_run_has_the_first_settings_and_no_file(path: Path) -> None:
    store = SettingsStore(path)

    assert store.settings == Settings(language="zh", theme="light", jog_step_deg=1.0)
    assert store.problems == ()
    assert not path.exists()


def test_a_change_is_there_in_the_next_run(path: Path) -> None:
    assert SettingsStore(path).change(language="en", jog_step_deg=0.25) is None

    assert SettingsStore(path).settings == Settings(language="en", theme="light", jog_step_deg=0.25)
    assert json.loads(path.read_text(encoding="utf-8")) == {
        "language": "en",
        "theme": "light",
        "jog_step_deg": 0.25,
        "urdf_path": None,
        "tool": [0.0] * 6,
        "stop_again": False,
        "jog_floor_mm": None,
        "session_folder": None,
        "session_format": ".blf",
        "session_rotate_mb": 100,
        "session_save_at_faults": False,
        "mountings": {},
        "home_poses": {},
        "picture_direction": "iso",
        "picture_orthographic": False,
        "picture_tool_frame": True,
        "picture_trail_s": 15,
        "gamepad": False,
        "gamepad_mode": "joint",
        "gamepad_one_axis": True,
        "gamepad_buttons": {},
        "interface": False,
        "live": False,
        "live_for_others": False,
        "live_port": 8766,
        "models": {},
        "references": {},
        "cells": {},
    }


def test_nothing_but_the_file_itself_is_left_in_the_folder(path: Path) -> None:
    store = SettingsStore(path)
    store.change(theme="dark")
    store.change(theme="system")

    assert [entry.name for entry in path.parent.iterdir()] == ["settings.json"]


def test_subscribers_hear_each_change_once_until_they_leave(path: Path) -> None:
    store = SettingsStore(path)
    heard: list[Settings] = []
    leave = store.subscribe(heard.append)

    store.change(theme="dark")
    store.change(theme="dark")
    leave()
    leave()
    store.change(theme="light")

    assert [settings.theme for settings in heard] == ["dark"]


def test_what_holds_for_one_run_only_is_not_saved(path: Path) -> None:
    store = SettingsStore(path, {"language": "en"})
    store.change(theme="dark")

    assert store.settings == Settings(language="en", theme="dark")
    assert SettingsStore(path).settings == Settings(language="zh", theme="dark")


def test_the_operators_choice_goes_before_that_of_the_run(path: Path) -> None:
    store = SettingsStore(path, {"language": "en"})
    heard: list[Settings] = []
    store.subscribe(heard.append)

    store.change(language="zh")

    assert [settings.language for settings in heard] == ["zh"]


@pytest.mark.parametrize("text", ["{", '"light"', "[1]", ""])
def test_a_broken_file_is_put_aside_and_said(path: Path, text: str) -> None:
    store = SettingsStore(written(path, text))

    assert store.settings == Settings()
    assert [problem.code for problem in store.problems] == ["settings_broken"]
    kept = path.with_name("settings.json.broken")
    assert kept.read_text(encoding="utf-8") == text
    assert store.problems[0].params == {"kept": str(kept)}
    assert not path.exists()


def test_a_file_that_is_no_text_is_put_aside(path: Path) -> None:
    path.parent.mkdir(parents=True)
    path.write_bytes(b"\xff\xfe\x00")

    assert [problem.code for problem in SettingsStore(path).problems] == ["settings_broken"]


def test_a_path_that_cannot_be_read_is_said(path: Path) -> None:
    path.mkdir(parents=True)

    store = SettingsStore(path)

    assert store.settings == Settings()
    assert [problem.code for problem in store.problems] == ["settings_unreadable"]
    assert store.problems[0].params["path"] == str(path)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("language", "fr"),
        ("language", None),
        ("theme", "pink"),
        ("theme", ["dark"]),
        ("jog_step_deg", 0.0),
        ("jog_step_deg", 30.001),
        ("jog_step_deg", "1"),
        ("jog_step_deg", True),
        ("urdf_path", 7),
        ("urdf_path", ""),
        ("session_format", ".mf4"),  # chosen in an earlier version
    ],
)
def test_a_value_that_is_not_possible_falls_back_alone(
    path: Path, field: str, value: object
) -> None:
    good: dict[str, object] = {
        "language": "en",
        "theme": "dark",
        "jog_step_deg": 2.5,
        "urdf_path": "/arm.urdf",
        "session_format": ".asc",
    }
    held = good | {field: value, "unknown": 1}
    store = SettingsStore(written(path, json.dumps(held)))

    expected = good | {field: getattr(Settings(), field)}
    assert {name: getattr(store.settings, name) for name in good} == expected
    assert [(problem.code, problem.params) for problem in store.problems] == [
        ("setting_bad", {"field": field, "value": str(value)})
    ]
    # another choice leaves it in the file
    store.change(jog_floor_mm=20)
    assert json.loads(path.read_text(encoding="utf-8")) == held | {"jog_floor_mm": 20}


@pytest.mark.parametrize("step_deg", [0.001, 0.5, 30.0, 5])
def test_jog_steps_that_are_possible(step_deg: float) -> None:
    assert check("jog_step_deg", step_deg) is None


@pytest.mark.parametrize("step_deg", [0.0009, 0, -1.0, 30.0001])
def test_a_jog_step_out_of_range_names_value_and_limits(step_deg: float) -> None:
    refusal = check("jog_step_deg", step_deg)

    assert refusal is not None
    assert refusal.reason == JOG_STEP_OUT_OF_RANGE
    assert refusal.params == {"value": step_deg, "minimum": 0.001, "maximum": 30.0}


@pytest.mark.parametrize("step_deg", [float("nan"), float("inf"), "1", None, True])
def test_a_jog_step_that_is_no_number(step_deg: object) -> None:
    refusal = check("jog_step_deg", step_deg)

    assert refusal is not None
    assert refusal.reason == JOG_STEP_NOT_A_NUMBER


def test_a_refused_change_changes_nothing(path: Path) -> None:
    store = SettingsStore(path)
    heard: list[Settings] = []
    store.subscribe(heard.append)

    refusal = store.change(theme="dark", jog_step_deg=99.0)

    assert refusal is not None
    assert refusal.reason == JOG_STEP_OUT_OF_RANGE
    assert store.settings == Settings()
    assert heard == []
    assert not path.exists()


def test_settings_that_cannot_be_saved_hold_for_this_run(tmp_path: Path) -> None:
    in_the_way = tmp_path / "file"
    in_the_way.touch()
    store = SettingsStore(in_the_way / "settings.json")
    heard: list[Settings] = []
    store.subscribe(heard.append)

    problem = store.change(theme="dark")

    assert problem is not None
    assert problem.reason == SETTINGS_NOT_SAVED
    assert problem.params["path"] == str(in_the_way / "settings.json")
    assert store.settings.theme == "dark"
    assert heard == [store.settings]


def test_a_failed_write_leaves_the_old_file_whole(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    SettingsStore(path).change(theme="dark")
    before = path.read_bytes()

    def disk_full(_descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("armui.system.atomic.os.fsync", disk_full)
    problem = SettingsStore(path).change(theme="system")

    assert problem is not None
    assert problem.params["text"] == "No space left on device"
    assert path.read_bytes() == before
    assert [entry.name for entry in path.parent.iterdir()] == ["settings.json"]


@pytest.mark.parametrize("name", DECLARED)
def test_every_setting_may_be_what_it_is_at_first(name: str) -> None:
    assert check(name, getattr(Settings(), name)) is None
    assert DECLARED[name].label


def test_only_those_declared_can_be_changed(path: Path) -> None:
    store = SettingsStore(path)

    refusal = store.change(colour="red")  # type: ignore[call-arg] # mypy knows it, too

    assert refusal is not None
    assert refusal.params == {"field": "colour", "value": "red"}
    assert not path.exists()


def test_the_file_is_in_the_users_own_folder() -> None:
    assert default_path().name == "settings.json"
    assert default_path().parent.name == "armui"


def test_a_tool_is_kept_and_read_back(path: Path) -> None:
    tool = (1.0, -2.5, 80.0, 0.0, 90.0, -180.0)
    assert SettingsStore(path).change(tool=tool) is None
    assert SettingsStore(path).settings.tool == tool


@pytest.mark.parametrize(
    ("tool", "named"),
    [
        ((501.0, 0.0, 0.0, 0.0, 0.0, 0.0), "501.0"),
        ((0.0, 0.0, 0.0, 0.0, 0.0, 181.0), "181.0"),
        ((0.0, "x", 0.0, 0.0, 0.0, 0.0), "x"),
        ((0.0, float("nan"), 0.0, 0.0, 0.0, 0.0), "nan"),
        ((0.0, True, 0.0, 0.0, 0.0, 0.0), "True"),
        ((0.0,), "(0.0,)"),
        ("tool", "tool"),
    ],
)
def test_a_tool_that_cannot_be_is_refused(path: Path, tool: Any, named: str) -> None:
    store = SettingsStore(path)

    refusal = store.change(tool=tool)

    assert refusal is not None
    assert refusal.reason == TOOL_NOT_POSSIBLE
    assert refusal.params["value"] == named
    assert store.settings.tool == (0.0,) * 6
