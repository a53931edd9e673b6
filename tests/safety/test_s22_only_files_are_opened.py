"""S1, S2, S22: a pipe, device, socket or folder where a file is expected holds nobody up."""

import errno
import logging
import os
import socket
import stat
from collections.abc import Callable
from pathlib import Path

import pytest

from armui.arm.models import ModelFileError, read_model
from armui.arm.refusal import Refusal
from armui.control.event_log import keeper
from armui.control.parameters.backup_files import read_backup
from armui.session.foreign.indexing import index_or_reason
from armui.session.frames import NotALogError
from armui.session.reader import LogFile
from armui.session.recording import sidecar
from armui.session.recording.counted import Counts, keep
from armui.session.recording.folder import files_of, list_recordings
from armui.session.recording.recorded_session import RecordedSession
from armui.settings import SettingsStore
from armui.sim.parameters.flash import FileFlash
from armui.system.atomic import write_whole
from armui.system.files import NotAFileError, open_file, open_stream, read_file
from armui.system.log_file import NAME, log_to
from armui.telemetry import event_json
from armui.trajectory import files
from armui.trajectory.columns import open_table
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.index import Index, Stamp
from armui.trajectory.library.store import Library
from armui.ui.dialogs.backup import BackupDialog
from armui.ui.shell.workspace_layout import from_text
from armui.ui.watch import layout_file
from armui.viewport.messages import SceneError
from tests.posix import make_pipe, of_system

pytestmark = [
    pytest.mark.timeout(30),  # what is held up here is held up for good
    pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here"),
]
KINDS = ("pipe", "folder", "socket", "device", "link to a pipe")


def put(kind: str, path: Path) -> Path:
    """Put something there that is no file."""
    if kind == "pipe":
        make_pipe(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "socket":
        with socket.socket(of_system("AF_UNIX", socket)) as made:
            made.bind(str(path))
    elif kind == "device":
        path.symlink_to("/dev/zero")
    else:
        make_pipe(path.with_name("elsewhere"))
        path.symlink_to(path.with_name("elsewhere"))
    return path


@pytest.fixture(params=KINDS)
def no_file(request, tmp_path, monkeypatch):
    """Puts it at a name of a folder of its own."""
    monkeypatch.chdir(tmp_path)  # the name of a socket is short
    return lambda name: put(request.param, Path(name))


@pytest.mark.parametrize("mode", ["rb", "r+b", "wb", "xb", "ab", "a+b"])
def test_nothing_but_a_file_is_opened(no_file, mode):
    with pytest.raises(OSError, match=r"not a file|exists") as caught:
        open_file(no_file("a"), mode)
    assert isinstance(caught.value, NotAFileError) or mode == "xb"
    assert not stat.S_ISREG(Path("a").stat().st_mode)


def test_a_pipe_that_comes_in_between_is_not_waited_for(tmp_path, monkeypatch):
    monkeypatch.setattr("armui.system.files.check_file", lambda path: None)
    make_pipe(tmp_path / "a")
    with pytest.raises(NotAFileError):
        open_file(tmp_path / "a")
    with pytest.raises(OSError, match=r"[Dd]evice") as nobody_reads_it:
        open_file(tmp_path / "a", "ab")
    assert nobody_reads_it.value.errno == errno.ENXIO


def test_nothing_but_a_file_is_replaced(no_file):
    path = no_file("a")
    before = path.lstat()
    with pytest.raises(OSError, match=r"not a file|exists"):
        write_whole(path, b"new")
    assert path.lstat() == before


def test_a_file_is_read_up_to_a_limit(tmp_path):
    (tmp_path / "a").write_bytes(b"12345")
    assert read_file(tmp_path / "a", 5) == b"12345"
    with pytest.raises(OSError, match="large"):
        read_file(tmp_path / "a", 4)


READERS = {
    "backup": lambda path: isinstance(read_backup(path), Refusal),
    "settings": lambda path: SettingsStore(path).problems[0].code == "settings_unreadable",
    "layout": lambda path: layout_file.read_text(path) == "" and from_text(""),
    "index": lambda path: Index(path).entry("a", Stamp(0, 0, 0)) is None,
    "flash": lambda path: FileFlash(path).load() and True,
    "log as a replay": lambda path: isinstance(index_or_reason(path, path.parent), Refusal),
}
RAISING: dict[str, tuple[Callable[[Path], object], type[Exception]]] = {
    "trajectory": (files.load, TrajectoryFileError),
    "name": (files.name_in, OSError),
    "table": (open_table, TrajectoryFileError),
    "log": (LogFile, NotALogError),
    "recorded": (RecordedSession, NotALogError),
    "model": (lambda path: read_model(path.parent), ModelFileError),
}


@pytest.mark.parametrize("name", READERS)
def test_reading_goes_on_without_it(no_file, name):
    assert READERS[name](no_file("a.log").absolute())


@pytest.mark.parametrize("name", RAISING)
def test_reading_says_what_is_wrong(no_file, name):
    function, error = RAISING[name]
    path = no_file("model.json" if name == "model" else "a.log").absolute()
    with pytest.raises(error):
        function(path)


def test_what_lies_beside_a_recording(no_file):
    folder = Path.cwd()
    no_file(f"a{sidecar.SUFFIX}")
    assert [bool(each.damage) for each in list_recordings(folder)] == [True]
    with pytest.raises((OSError, ValueError)):
        files_of(folder, "a")
    keep(folder, "a", Counts(1, 1))
    with pytest.raises(NotALogError):
        RecordedSession(folder / "a.blf")


def test_the_program_log(no_file, caplog):
    no_file(NAME)
    with log_to(Path.cwd()) as path:
        logging.getLogger("armui").warning("still there")
    assert path is None


def test_the_lock_of_the_program_log(tmp_path):
    make_pipe(tmp_path / f".{NAME}.lock")
    with log_to(tmp_path):
        logging.getLogger("armui").warning("nobody waits")


def test_the_program_log_that_is_exchanged_while_it_runs(tmp_path):
    with log_to(tmp_path) as path:
        assert path is not None
        path.unlink()
        make_pipe(path)
        logging.getLogger("armui").warning("still there")
    assert stat.S_ISFIFO(path.stat().st_mode)


def test_the_events(no_file):
    no_file(event_json.NAME)
    with pytest.raises(OSError, match=r"not a file|exists"):
        keeper.write(Path.cwd(), "run", [])


def test_the_library(no_file):
    library = Library(Path.cwd())
    for name in ("a.log", "b.npz", "c.draft", ".index.json", ".program-1-a.lock"):
        if not Path("elsewhere").exists():
            no_file(name)
    assert library.entries() == []
    assert library.drafts() == []
    library.tidy()


def test_a_robot_description_and_its_meshes(tmp_path):
    from armui.viewport.process.urdf_file import _content, _mesh  # noqa: PLC0415 - brings VTK

    make_pipe(tmp_path / "a.urdf")
    with pytest.raises(SceneError):
        _content(tmp_path / "a.urdf")
    make_pipe(tmp_path / "a.stl")
    with pytest.raises(SceneError):
        _mesh(tmp_path / "a.stl")
    (tmp_path / "b.obj").write_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    make_pipe(tmp_path / "a.mtl")  # a mesh brings others along
    assert len(_mesh(tmp_path / "b.obj").faces) == 1


def test_a_command_still_reads_a_pipe_that_is_fed(tmp_path):
    (tmp_path / "a").write_bytes(b"1")
    with open_stream(tmp_path / "a") as file:
        assert file.read() == b"1"


def test_a_backup_in_the_window(app_driver, tmp_path):
    app_driver.ready()
    app_driver.window.pages.show("backup")
    app_driver.box = app_driver.dialog(BackupDialog)
    app_driver.run(1.0)
    make_pipe(tmp_path / "pipe.json")
    app_driver.box.open_file(tmp_path / "pipe.json")
    assert "it is a pipe, not a file" in app_driver.box._message.text()
    app_driver.box._write(tmp_path / "pipe.json", app_driver.box._now())
    assert "it is a pipe, not a file" in app_driver.box._message.text()
    assert stat.S_ISFIFO((tmp_path / "pipe.json").stat().st_mode)
