"""S21: programs of one user meet where no other user can be; where they can't, that is said."""

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from armui.control.events import Event
from armui.control.link.instance_registry import SETTINGS_SHARED, InstanceRegistry
from armui.settings import SettingsStore
from armui.system import paths
from armui.system.presence import Presence
from tests.posix import of_system
from tests.ui.fake_controller import FakeController

pytestmark = pytest.mark.skipif(not hasattr(os, "getuid"), reason="users in the manner of POSIX")


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A user without a folder of the system's for what runs."""
    monkeypatch.delenv("XDG_RUNTIME_DIR", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setattr(os, "getuid", lambda: 4_000_000)  # has no /run/user
    monkeypatch.setattr(Path, "lstat", _owned_by(4_000_000, tmp_path))
    return tmp_path


def _owned_by(uid, root):
    real = Path.lstat

    def lstat(path):
        found = real(path)
        if not path.is_relative_to(root):
            return found
        return os.stat_result([*found[:4], uid, *found[5:]])

    return lstat


def test_it_is_a_private_folder_of_the_user_and_not_a_guessable_one(home):
    folder = paths.runtime()
    assert folder.is_relative_to(home / "state")
    paths.make_private(folder)
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


def test_the_folder_of_the_system_is_taken_only_if_it_is_the_users(tmp_path, monkeypatch):
    run = tmp_path / "run"
    run.mkdir(mode=0o700)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(run))
    assert paths.runtime() == run / "armui"
    run.chmod(0o777)
    assert paths.runtime() != run / "armui"
    run.chmod(0o700)
    monkeypatch.setattr(os, "getuid", lambda: 4_000_000)
    assert paths.runtime() != run / "armui"


def test_with_and_without_the_variable_is_the_same_place(monkeypatch):
    run = Path(f"/run/user/{of_system('getuid')()}")
    if not paths.is_private(run):
        pytest.skip("this system has no such folder")
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(run))
    named = paths.runtime()
    monkeypatch.delenv("XDG_RUNTIME_DIR")
    assert paths.runtime() == named


def test_another_users_folder_is_not_used(tmp_path, monkeypatch):
    (tmp_path / "run").mkdir(mode=0o777)
    monkeypatch.setattr(Path, "lstat", _owned_by(4_000_000, tmp_path))
    with pytest.raises(PermissionError, match="another user"):
        paths.make_private(tmp_path / "run")
    with pytest.raises(PermissionError, match="another user"):
        Presence(tmp_path / "run" / "place").enter()


def test_a_link_is_not_followed(tmp_path):
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "run").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(PermissionError):
        paths.make_private(tmp_path / "run")


def test_a_folder_that_is_too_open_is_closed(tmp_path):
    (tmp_path / "run").mkdir()
    (tmp_path / "run").chmod(0o777)
    paths.make_private(tmp_path / "run")
    assert stat.S_IMODE((tmp_path / "run").stat().st_mode) == 0o700


@pytest.mark.parametrize("reason", ["foreign", "a file", "no locks"])
def test_settings_are_saved_all_the_same(tmp_path, monkeypatch, reason):
    place = tmp_path / "run"
    monkeypatch.setattr(paths, "runtime", lambda: place)
    if reason == "foreign":
        place.mkdir()
        monkeypatch.setattr(Path, "lstat", _owned_by(4_000_000, tmp_path))
    elif reason == "a file":
        place.write_text("")
    else:

        def no_locks(_lock, *_arguments, **_options):
            raise NotImplementedError("FileSystem does not appear to support flock")

        monkeypatch.setattr("filelock.FileLock.acquire", no_locks)
    store = SettingsStore(tmp_path / "settings.json")
    assert store.change(theme="dark") is None
    assert SettingsStore(store.path).settings.theme == "dark"


@pytest.mark.parametrize("reason", ["a file", "no locks"])
def test_that_nobody_can_be_met_is_said_once(qapp, qtbot, tmp_path, monkeypatch, reason):
    place = tmp_path / "run"
    if reason == "a file":
        place.write_text("")
    else:

        def no_locks(_lock, *_arguments, **_options):
            raise NotImplementedError("FileSystem does not appear to support flock")

        monkeypatch.setattr("filelock.FileLock.acquire", no_locks)
    controller = FakeController()
    told: list[Event] = []
    controller.noticed.connect(told.append)
    registry = InstanceRegistry(controller.as_real, tmp_path / "s.json", place, 0.01)
    qtbot.waitUntil(lambda: bool(told))
    again = registry._watch(SETTINGS_SHARED, "another", "another")
    again._thread.join(10.0)
    qapp.processEvents()
    assert [each.code for each in told] == ["nobody_met"]
    assert told[0].params["path"] == str(place)
    again.close()
    registry.close()


def test_two_programs_without_the_variable_meet(tmp_path):
    code = (
        "import sys; from pathlib import Path; from armui.system import paths\n"
        "from armui.system.presence import Presence\n"
        "here = Presence(paths.runtime() / 'place'); here.enter()\n"
        "print(here.others(), flush=True); sys.stdin.read(); here.leave()"
    )
    environment = {**os.environ, "XDG_STATE_HOME": str(tmp_path)}
    environment.pop("XDG_RUNTIME_DIR", None)

    def program():
        return subprocess.Popen(
            [sys.executable, "-c", code],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=environment,
        )

    first = program()
    assert first.stdout.readline() == b"0\n"
    second = program()
    assert second.stdout.readline() == b"1\n"
    for each in (first, second):
        each.communicate(timeout=30)
