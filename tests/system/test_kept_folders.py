"""Folders in which nothing can be kept are found, and said by the doctor and the window, once."""

import json

import pytest

from armui.doctor.facts import ProgramFacts
from armui.doctor.judge import judge_program
from armui.doctor.probes.program import probe_program
from armui.system import kept_folders, paths
from armui.system.kept_folders import ClosedFolder, closed_folders


@pytest.fixture
def places(tmp_path, monkeypatch):
    """The user's folders, none of them made yet."""
    monkeypatch.setattr(paths, "settings_file", lambda: tmp_path / "config/settings.json")
    for name in ("trajectories", "sessions", "logs"):
        monkeypatch.setattr(paths, name, lambda name=name: tmp_path / "data" / name)
    return tmp_path


def test_folders_that_can_be_made_are_open_and_nothing_is_left(places):
    assert closed_folders() == ()
    assert list(places.iterdir()) == []


def test_a_folder_under_a_file_is_closed(places):
    """What root may not do either."""
    (places / "data").write_text("no folder")
    closed = closed_folders()
    names = ["trajectories", "sessions", "logs"]
    assert [each.folder for each in closed] == [str(places / "data" / name) for name in names]
    assert {(each.place, each.denied) for each in closed} == {(str(places / "data"), False)}
    assert str(closed[0]).endswith("trajectories (Not a directory)")


def test_the_folder_of_recordings_is_the_chosen_one(places):
    (places / "file").write_text("no folder")
    settings = places / "config/settings.json"
    settings.parent.mkdir()
    settings.write_text(json.dumps({"session_folder": str(places / "file/far")}))
    assert [each.folder for each in closed_folders()] == [str(places / "file/far")]
    settings.write_text("[]")
    assert closed_folders() == ()


def test_the_doctor_names_them_once_with_the_command(places, monkeypatch):
    def refused(_path, _mode):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(kept_folders, "open_file", refused)
    facts = probe_program()
    assert len(facts.closed) == 4
    (found,) = [each for each in judge_program(facts) if each.code == "folders_closed"]
    for folder in ("config", "data/trajectories", "data/sessions", "data/logs"):
        assert f"{places / folder} (Permission denied)" in found.params["folders"]
    assert found.commands == (f'sudo chown -R "$USER" "{places}"',)


def test_chown_is_offered_only_where_it_helps():
    full = ClosedFolder("/a/b", "/a", "Read-only file system", denied=False)
    denied = ClosedFolder("C:\\a", "C:\\a", "Access is denied", denied=True)
    for closed, system in ((full, "Linux 6"), (denied, "Windows 10")):
        facts = ProgramFacts("1", "3", True, "python", system, closed=(closed,))
        assert judge_program(facts)[-1].commands == ()


def test_the_window_says_it_once(app_driver, places, qtbot):
    (places / "data").write_text("no folder")
    app_driver.program.check_folders()
    qtbot.waitUntil(lambda: "folders_closed" in app_driver.codes())
    (told,) = [each for each in app_driver.events if each.code == "folders_closed"]
    assert told.params["folders"].startswith(str(places / "data/trajectories"))
    said = app_driver.read("notice_label")
    assert str(places / "data/logs") in said
    assert "Let this user write there" in said


def test_the_window_says_nothing_of_folders_that_are_open(app_driver, places):
    app_driver.program.check_folders()
    app_driver.run(0.3)
    assert "folders_closed" not in app_driver.codes()
