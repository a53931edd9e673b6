"""The folder of cells: what is in it, and what another program has changed there."""

from dataclasses import replace

from armui.cell.cell import Cell
from armui.cell.cell_file import CELL_NO_JSON, CELL_UNREADABLE, read_cell, to_text, write_cell
from armui.cell.cell_folder import CELL_CHANGED_ELSEWHERE, CellFolder
from armui.cell.tools import Tool

BENCH = Cell("bench", (Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0)),), "pen")
BARE = Cell("bench")


def file_of(folder, name="bench"):
    return folder.path / f"{name}.armui-cell"


def test_a_folder_is_read_with_what_is_broken_in_it(tmp_path):
    write_cell(tmp_path / "bench.armui-cell", BENCH)
    (tmp_path / "torn.armui-cell").write_text("{", encoding="utf-8")
    (tmp_path / "one.json").write_text("{}", encoding="utf-8")
    (tmp_path / "folder.armui-cell").mkdir()
    read = CellFolder(tmp_path).read()
    assert read["bench"] == BENCH
    assert read["torn"].reason == CELL_NO_JSON
    assert read["folder"].reason == CELL_UNREADABLE
    assert set(read) == {"bench", "torn", "folder"}
    assert CellFolder(tmp_path / "nowhere").read() == {}


def test_what_another_program_wrote_is_left_alone(tmp_path):
    ours = CellFolder(tmp_path)
    assert ours.save(BENCH) is None
    assert ours.save(BARE) is None
    theirs = CellFolder(tmp_path)
    theirs.read()
    assert theirs.save(BENCH) is None
    for told in (
        ours.save(replace(BARE, tools=BENCH.tools)),
        ours.delete("bench"),
        ours.rename("bench", replace(BARE, name="stand")),
    ):
        assert told.reason == CELL_CHANGED_ELSEWHERE
    assert read_cell(file_of(ours)) == BENCH
    assert not file_of(ours, "stand").exists()


def test_one_that_was_made_elsewhere_under_the_same_name_stays(tmp_path):
    ours = CellFolder(tmp_path)
    assert ours.read() == {}
    write_cell(file_of(ours), BENCH)
    assert ours.save(BARE).reason == CELL_CHANGED_ELSEWHERE
    write_cell(file_of(ours, "stand"), replace(BENCH, name="stand"))
    ours.save(Cell("shelf"))
    assert ours.rename("shelf", Cell("stand")).reason == CELL_CHANGED_ELSEWHERE
    assert read_cell(file_of(ours, "shelf")) == Cell("shelf")
    assert read_cell(file_of(ours, "stand")).tools == BENCH.tools


def test_a_broken_one_may_be_deleted_as_it_was_found(tmp_path):
    torn = tmp_path / "bench.armui-cell"
    torn.write_text(to_text(BENCH)[:50], encoding="utf-8")
    ours = CellFolder(tmp_path)
    ours.read()
    assert ours.delete("bench") is None
    assert not torn.exists()  # it is put aside
    assert ours.save(BENCH) is None


def test_one_that_is_renamed_is_known_by_its_new_name(tmp_path):
    ours = CellFolder(tmp_path)
    ours.save(BENCH)
    assert ours.rename("bench", replace(BENCH, name="stand")) is None
    assert not file_of(ours).exists()
    assert ours.save(Cell("stand")) is None
    assert ours.save(BARE) is None  # its old name is free
