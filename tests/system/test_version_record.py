"""Which version took over files of another one: noted once, told ever after."""

import os
from datetime import UTC, datetime

import pytest

from armui.system.version_record import FILE, TakenOver, note_version, taken_over

NOW = datetime(2026, 11, 23, 18, 0, tzinfo=UTC)
LATER = datetime(2027, 1, 1, tzinfo=UTC)


@pytest.fixture
def settings(tmp_path):
    return tmp_path / "config" / "settings.json"


@pytest.fixture
def places(tmp_path):
    return {"trajectories": tmp_path / "trajectories", "sessions": tmp_path / "sessions"}


def test_a_first_start_takes_nothing_over(settings, places):
    assert note_version("0.3.0", settings, places, NOW) is None
    assert taken_over(settings) is None
    # what is made by this version is none of another
    settings.write_text("{}")
    assert note_version("0.3.0", settings, places, LATER) is None


def test_files_of_a_version_that_noted_nothing(settings, places):
    settings.parent.mkdir()
    settings.write_text("{}")
    places["trajectories"].mkdir()
    for name in ("a.log", "b.log", ".unfinished"):
        (places["trajectories"] / name).touch()
    files = {"settings": 1, "trajectories": 2, "sessions": 0}
    expected = TakenOver("", "0.3.0", "2026-11-23T18:00:00+00:00", files)
    assert note_version("0.3.0", settings, places, NOW) == expected
    # told as it was then, at every later start of the same version
    assert note_version("0.3.0", settings, places, LATER) == expected
    assert taken_over(settings) == expected
    # the next one, also an older one again, takes over from this one
    assert note_version("0.2.9", settings, places, LATER).before == "0.3.0"


def test_trajectories_in_sub_folders_count_and_what_a_link_leads_to_does_not(
    settings, places, tmp_path
):
    for path in ("trajectories/a.log", "trajectories/cell/b.log", "trajectories/cell/c.npz",
                 "trajectories/.bin/d.log", "trajectories/cell/deeper/e.log",
                 "sessions/f.blf", "sessions/other/g.blf", "elsewhere/h.log"):  # fmt: skip
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).touch()
    if hasattr(os, "symlink"):
        link = places["trajectories"] / "link"
        link.symlink_to(tmp_path / "elsewhere", target_is_directory=True)
    found = note_version("0.3.0", settings, places, NOW, nested={"trajectories"})
    assert found.files == {"settings": 0, "trajectories": 3, "sessions": 1}


@pytest.mark.parametrize("text", ["", "no JSON", "[]", '{"version": 3}', "{" * 90_000])
def test_a_note_that_cannot_be_read_is_as_none(settings, places, text):
    settings.parent.mkdir()
    (settings.parent / FILE).write_text(text)
    assert taken_over(settings) is None
    note_version("0.3.0", settings, places, NOW)
    assert '"version": "0.3.0"' in (settings.parent / FILE).read_text()
