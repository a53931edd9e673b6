"""S21, S22: what is in a file is known from what was written there, not from what was to be."""

import errno
import json
from dataclasses import replace
from functools import partial

import pytest

from armui.cell.cell import Cell
from armui.cell.cell_file import CELL_NOT_WRITTEN, read_cell, to_text, write_cell
from armui.cell.cell_folder import CELL_CHANGED_ELSEWHERE, CellFolder
from armui.cell.tools import Tool
from armui.protocol.codes import MoveMode
from armui.settings import SettingsStore
from armui.system import atomic
from armui.system.files import open_file
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import Trajectory, Waypoint
from tests.safety.test_s22_full_disk_and_kill import fill_up, small_disk

__all__ = ["small_disk"]

ROOM = 200_000
BARE = Cell("bench")
PEN = replace(BARE, tools=(Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0)),), tool="pen")
HOOK = replace(BARE, tools=(Tool("hook", (0.0, 0.0, 80.0, 0.0, 0.0, 0.0)),), tool="hook")


def full(*_arguments, **_more):
    raise OSError(errno.ENOSPC, "No space left on device")


class Sick:
    """A stream whose disk is full once some bytes are written."""

    def __init__(self, stream):
        self._stream = stream

    def write(self, data):
        self._stream.write(data[: len(data) // 2])
        full()

    def __getattr__(self, name):
        return getattr(self._stream, name)


def half_written(really, *arguments):
    return Sick(really(*arguments))


def lost_answer(really, source, target):
    really(source, target)
    raise OSError(errno.EIO, "Input/output error")


PHASES = {
    "no file can be made": ("open_file", full),
    "the bytes find no room": ("open_file", partial(half_written, open_file)),
    "they do not get to the disk": ("os.fsync", full),
    "the file does not get its name": ("replace_file", full),
}


@pytest.fixture(params=PHASES)
def failing(request, monkeypatch):
    """Have every file fail in one phase of being written, as long as a block lasts."""
    name, how = PHASES[request.param]

    def begin():
        context = monkeypatch.context()
        context.__enter__().setattr(f"armui.system.atomic.{name}", how)
        return context

    return begin


def failed(begin, work):
    context = begin()
    try:
        return work()
    finally:
        context.__exit__(None, None, None)


def cell_in(folder, name="bench"):
    return read_cell(folder.path / f"{name}.armui-cell")


# Cells --------------------------------------------------------------------------------------------


def test_a_cell_is_written_again_once_there_is_room(tmp_path, failing):
    cells = CellFolder(tmp_path)
    assert cells.save(PEN) is None
    for _ in range(2):
        told = failed(failing, lambda: cells.save(HOOK))
        assert told.reason == CELL_NOT_WRITTEN
        assert cell_in(cells) == PEN
    assert cells.save(HOOK) is None
    assert cell_in(cells) == HOOK
    assert [each.name for each in tmp_path.iterdir()] == ["bench.armui-cell"]


def test_a_first_cell_that_was_not_written_is_not_another_program_s(tmp_path, failing):
    cells = CellFolder(tmp_path)
    assert failed(failing, lambda: cells.save(PEN)).reason == CELL_NOT_WRITTEN
    assert cells.save(HOOK) is None
    assert cell_in(cells) == HOOK


def test_another_program_s_cell_is_told_after_a_failure_too(tmp_path, failing):
    cells = CellFolder(tmp_path)
    cells.save(PEN)
    failed(failing, lambda: cells.save(HOOK))
    write_cell(tmp_path / "bench.armui-cell", BARE)
    assert cells.save(HOOK).reason == CELL_CHANGED_ELSEWHERE
    assert cell_in(cells) == BARE


def test_a_cell_that_was_not_renamed_is_known_by_its_name(tmp_path, failing):
    cells = CellFolder(tmp_path)
    cells.save(PEN)
    renamed = replace(PEN, name="stand")
    assert failed(failing, lambda: cells.rename("bench", renamed)).reason == CELL_NOT_WRITTEN
    assert [each.name for each in tmp_path.iterdir()] == ["bench.armui-cell"]
    assert cells.save(HOOK) is None
    assert cells.rename("bench", replace(HOOK, name="stand")) is None
    assert cell_in(cells, "stand").tool == "hook"


@pytest.fixture
def undeletable(monkeypatch):
    """Have no file deleted whose name is that of a cell."""

    def refuse(path):
        return CELL_NOT_WRITTEN(path=str(path), text="it is read-only")

    with monkeypatch.context() as context:
        context.setattr("armui.cell.cell_folder.delete_cell", refuse)
        yield context


def test_a_cell_that_was_not_deleted_is_known(tmp_path, undeletable):
    cells = CellFolder(tmp_path)
    cells.save(PEN)
    assert cells.delete("bench").params["text"] == "it is read-only"
    assert cells.save(HOOK) is None
    undeletable.undo()
    assert cells.delete("bench") is None
    assert cells.save(PEN) is None


def test_a_cell_whose_old_file_stays_keeps_its_name(tmp_path, undeletable):
    cells = CellFolder(tmp_path)
    cells.save(PEN)
    assert cells.rename("bench", replace(PEN, name="stand")) is not None
    assert cell_in(cells) == PEN
    undeletable.undo()
    assert cells.save(HOOK) is None


def test_a_file_whose_share_has_lost_its_answer_only_is_written(tmp_path, monkeypatch):
    cells, library = CellFolder(tmp_path), Library(tmp_path)
    cells.save(PEN)
    library.save(row(10))
    library.load("row", to_edit=True)
    with monkeypatch.context() as share:
        share.setattr("armui.system.atomic.replace_file", partial(lost_answer, atomic.replace_file))
        assert cells.save(HOOK) is None
        assert library.save(row(11), replacing="row") is False
    assert cells.save(PEN) is None
    assert library.save(row(12), replacing="row") is False
    assert library.recently_deleted() == []


def test_a_cell_on_a_disk_that_is_really_full(app_driver, small_disk):
    app_driver.library_folder.parent.mkdir(exist_ok=True)
    app_driver.library_folder.symlink_to(small_disk)
    app_driver.ready()
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench")
    file = small_disk / "bench.armui-cell"
    before = read_cell(file)
    fill_up(small_disk)
    cells = app_driver.controller.cell
    assert cells.change(PEN).ending is not None
    told = [each for each in app_driver.events if each.code == "cell_problem"]
    assert [each.params["reason"].reason for each in told] == [CELL_NOT_WRITTEN]
    assert cells.cell == PEN  # it holds
    assert read_cell(file) == before
    (small_disk / "filler").unlink()
    assert cells.change(HOOK).ending is not None
    assert read_cell(file) == HOOK
    assert [each.code for each in app_driver.events].count("cell_problem") == 1


# The library, drafts, settings --------------------------------------------------------------------


def row(deg):
    return Trajectory("row", points=(Waypoint(MoveMode.MOVE_J, (float(deg),) * 6),))


def test_a_trajectory_is_not_another_program_s_after_a_failure(tmp_path, failing):
    library = Library(tmp_path)
    library.save(row(1))
    library.load("row", to_edit=True)
    for deg in (2, 3):
        with pytest.raises(LibraryError):
            failed(failing, lambda deg=deg: library.save(row(deg), replacing="row"))
        assert Library(tmp_path).load("row").points == row(1).points
    assert library.save(row(4), replacing="row") is False
    assert library.recently_deleted() == []
    # and what another one has saved is told
    Library(tmp_path).save(row(5), replacing="row")
    with pytest.raises(LibraryError):
        failed(failing, lambda: library.save(row(6), replacing="row"))
    assert library.save(row(6), replacing="row") is True


def test_a_draft_of_before_a_failure_is_not_put_aside(tmp_path, failing):
    library = Library(tmp_path)
    library.save(row(1))
    library.load("row", to_edit=True)
    library.save_draft("row", row(2))
    with pytest.raises(LibraryError):
        failed(failing, lambda: library.save(row(3), replacing="row"))
    with pytest.raises(LibraryError):
        failed(failing, lambda: library.save_draft("row", row(4)))
    again = Library(tmp_path)
    shown = again.load("row", to_edit=True)
    assert isinstance(shown, Trajectory)
    assert again.set_aside_draft(shown) is False
    assert again.draft("row").points == row(2).points


def test_settings_that_were_not_saved_are_with_the_next_change(tmp_path, failing):
    path = tmp_path / "settings.json"
    store, other = SettingsStore(path), SettingsStore(path)
    store.keep("cells", {"a": "bench"})
    for name in ("crate", "shelf"):
        told = failed(failing, lambda name=name: store.keep("cells", {"a": name}))
        assert told.code == "settings_not_saved"
    told = failed(failing, lambda: store.change(theme="dark"))
    assert told.code == "settings_not_saved"
    other.keep("cells", {"b": "crate"})
    assert store.keep("models", {"a": "piper"}) is None
    kept = json.loads(path.read_text(encoding="utf-8"))
    assert (kept["cells"], kept["theme"]) == ({"a": "shelf", "b": "crate"}, "dark")


# A broken cell, a backup of it --------------------------------------------------------------------


def test_a_backup_takes_the_place_of_a_cell_that_cannot_be_read_which_is_kept(tmp_path):
    torn = tmp_path / "bench.armui-cell"
    newer = to_text(PEN).replace('"version": 1', '"version": 9')
    for number, text in enumerate(("{", newer), start=1):
        torn.write_text(text, encoding="utf-8")
        cells = CellFolder(tmp_path)
        cells.read()
        assert cells.save(PEN) is None
        assert cell_in(cells) == PEN
        aside = tmp_path / f"bench.armui-cell.broken{number if number > 1 else ''}"
        assert aside.read_text(encoding="utf-8") == text


def test_a_cell_that_cannot_be_read_is_put_aside_where_it_is_deleted(tmp_path):
    torn = tmp_path / "bench.armui-cell"
    torn.write_text("{", encoding="utf-8")
    cells = CellFolder(tmp_path)
    cells.read()
    assert cells.delete("bench") is None
    assert [each.name for each in tmp_path.iterdir()] == ["bench.armui-cell.broken"]
