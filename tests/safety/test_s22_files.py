"""S22: whatever a file holds, the program starts, says what is wrong, and loses nothing."""

import contextlib
import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from armui.protocol.codes import MoveMode
from armui.setting_fields import Settings
from armui.settings import SettingsStore
from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.drafts import Drafts
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from armui.viewport.messages import SceneError
from tests.examples import examples
from tests.posix import make_pipe

POINTS = Trajectory("a", "", (Waypoint(MoveMode.MOVE_J, (0.0, 10.0, -20.0, 0.0, 0.0, 0.0)),))
SAMPLES = Recording("r", "", np.arange(24.0).reshape(3, 8))
SOUND = [
    *(files.to_bytes(POINTS, suffix) for suffix in (".log", ".csv", ".json")),
    *(files.to_bytes(SAMPLES, suffix) for suffix in (".log", ".csv", ".json", ".npz")),
]

HOSTILE = {
    "nested": b'{"tool": ' + b"[" * 100_000 + b"]" * 100_000 + b"}",
    "nested_open": b"[" * 100_000,
    "401_digits": b'{"jog_step_deg": 1' + b"0" * 400 + b"}",
    "5000_digits": b'{"jog_step_deg": 1' + b"0" * 5000 + b"}",
    "401_digit_tool": b'{"tool": [1' + b"0" * 400 + b", 0, 0, 0, 0, 0]}",
    "nested_value": b'{"language": ' + b"[" * 900 + b"]" * 900 + b"}",
    "huge": b'{"language": "' + b"x" * 5_000_000 + b'"}',
    "no_utf8": b'{"language": "\xff\xfe"}',
    "nul_in_path": b'{"urdf_path": "/a\\u0000b"}',
    "lone_surrogate": b'{"urdf_path": "/a\\ud800b"}',
    "long_path": b'{"urdf_path": "/' + b"a" * 100_000 + b'"}',
    "not_a_number": b'{"jog_step_deg": NaN, "tool": [NaN, Infinity, -Infinity, 0, 0, 0]}',
}


@pytest.mark.parametrize("content", HOSTILE.values(), ids=HOSTILE.keys())
def test_no_content_keeps_the_program_from_starting(tmp_path, content):
    path = tmp_path / "settings.json"
    path.write_bytes(content)
    store = SettingsStore(path)
    assert store.settings == Settings()
    assert store.problems
    assert all(len(str(problem.params)) < 600 for problem in store.problems)
    # nothing is lost: it is the file as it was, or it was put aside
    kept = [each.read_bytes() for each in tmp_path.iterdir()]
    assert content in kept


def test_a_pipe_is_not_waited_for(tmp_path):
    path = tmp_path / "settings.json"
    make_pipe(path)
    assert [problem.code for problem in SettingsStore(path).problems] == ["settings_unreadable"]


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=7) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=12,
)
_FIELDS = st.sampled_from(["language", "theme", "jog_step_deg", "urdf_path", "tool"])


@settings(max_examples=examples(200), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.dictionaries(_FIELDS, _JSON) | _JSON)
def test_any_json(tmp_path, value):
    path = tmp_path / "settings.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    store = SettingsStore(path)
    if store.settings.urdf_path is not None:
        os.fsencode(store.settings.urdf_path)
        assert "\0" not in store.settings.urdf_path
    assert store.change(theme="dark" if store.settings.theme != "dark" else "light") is None
    assert SettingsStore(path).settings == store.settings


@settings(max_examples=examples(200), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.binary(max_size=400))
def test_any_bytes(tmp_path, content):
    path = tmp_path / "settings.json"
    path.write_bytes(content)
    assert isinstance(SettingsStore(path).settings, Settings)


INDEXES = {
    "nested": b'{"version": 1, "files": ' + b"[" * 100_000 + b"]" * 100_000 + b"}",
    "list": b"[1]",
    "no_utf8": b"\xff",
    "401_digits": b'{"version": 1, "files": {"a.log": [1' + b"0" * 400 + b", 0, 0, {}]}}",
}
WRONG: dict[str, list[Any]] = {
    "name": [5, None, ["a"], "\ud800"],
    "kind": ["bogus", None, 7],
    "count": ["3", None, -1, 10**400, 1.5],
    "length_s": ["1", -1, [1]],
    "modified": ["yesterday", "2026-01-01T00:00:00", 5],
    "check": ["bogus", 1],
    "note": [1, None],
    "damage": [[], ["code", [], 1, 1, "a"], [1, {}, 1, 1, "a"]],
}


def _library_with_a_file(tmp_path):
    Library(tmp_path).save(POINTS)


@pytest.mark.parametrize("content", INDEXES.values(), ids=INDEXES.keys())
def test_no_index_hides_the_library(tmp_path, content):
    _library_with_a_file(tmp_path)
    (tmp_path / ".index.json").write_bytes(content)
    assert [entry.name for entry in Library(tmp_path).entries()] == ["a"]


@pytest.mark.parametrize(
    ("field", "value"), [(field, value) for field, values in WRONG.items() for value in values]
)
def test_an_index_with_one_wrong_field_is_made_anew(tmp_path, field, value):
    _library_with_a_file(tmp_path)
    list(Library(tmp_path).entries())
    index = tmp_path / ".index.json"
    data = json.loads(index.read_bytes())
    data["files"]["a.log"][3][field] = value
    index.write_text(json.dumps(data), encoding="utf-8")
    (entry,) = Library(tmp_path).entries()
    assert (entry.name, entry.kind, entry.count, entry.damage) == ("a", "points", 1, None)


@settings(max_examples=examples(300))
@given(st.binary(max_size=300))
def test_any_bytes_are_a_trajectory_or_a_reason(content):
    with contextlib.suppress(TrajectoryFileError):
        files.read_bytes(content, "a")


@settings(max_examples=examples(300))
@given(st.data())
def test_any_damage_to_a_sound_file_is_a_trajectory_or_a_reason(data):
    content = bytearray(data.draw(st.sampled_from(SOUND)))
    for _ in range(data.draw(st.integers(1, 6))):
        at = data.draw(st.integers(0, len(content)))
        content[at : at + data.draw(st.integers(0, 4))] = data.draw(st.binary(max_size=6))
    with contextlib.suppress(TrajectoryFileError):
        files.read_bytes(bytes(content), "a")


@settings(max_examples=examples(100), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.binary(max_size=300))
def test_any_draft(tmp_path, content):
    (tmp_path / "a.draft").write_bytes(content)
    drafts = Drafts(tmp_path)
    assert len(drafts.entries(())) == 1
    for name in drafts.names():
        with contextlib.suppress(TrajectoryFileError):
            drafts.load(name)


def test_a_pipe_among_the_trajectories_is_not_waited_for(tmp_path):
    make_pipe(tmp_path / "pipe.log")
    with pytest.raises(TrajectoryFileError):
        files.load(tmp_path / "pipe.log")


URDFS = {
    "nested": b"<robot>" + b"<a>" * 5000 + b"</a>" * 5000 + b"</robot>",
    "nested_geometry": b'<robot name="a"><link name="b">'
    + b"<a>" * 400
    + b"</a>" * 400
    + b"</link></robot>",
    "no_utf8": b"<robot>\xff</robot>",
    "big_number": b'<robot name="a"><link name="b"><visual><origin xyz="1'
    + b"0" * 400
    + b' 0 0"/><geometry><box size="1 1 1"/></geometry></visual></link></robot>',
    "cut": b"<robot><link",
}


def _load_robot(path):
    from armui.viewport.process.urdf_file import load_robot  # noqa: PLC0415 - a second of loading

    with pytest.raises(SceneError):
        load_robot(path)


@pytest.mark.parametrize("content", URDFS.values(), ids=URDFS.keys())
def test_no_robot_description_does_more_than_fail(tmp_path, content):
    path = tmp_path / "arm.urdf"
    path.write_bytes(content)
    _load_robot(path)


def test_a_pipe_is_no_robot_description(tmp_path):
    make_pipe(tmp_path / "arm.urdf")
    _load_robot(tmp_path / "arm.urdf")


@pytest.mark.parametrize("path", ["/a\0b", "/a" * 5000])
def test_no_name_of_a_robot_description_does_more_than_fail(path):
    _load_robot(Path(path))
