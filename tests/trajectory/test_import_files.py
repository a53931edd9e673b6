"""Files by their names: what they hold, or what is wrong with them and where."""

from pathlib import Path

import pytest

from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from tests.trajectory.library.contents import recording, trajectory


def test_good_files_are_read_and_bad_ones_named(tmp_path: Path) -> None:
    (tmp_path / "1.csv").write_bytes(files.to_bytes(trajectory(), ".csv"))
    (tmp_path / "2.log").write_text("armui trajectory 1\n\nJ 0 0 o 0 0 0\n")
    (tmp_path / "3.json").write_bytes(files.to_bytes(recording(), ".json"))

    assert files.load(tmp_path / "1.csv") == trajectory()
    assert files.load(tmp_path / "3.json") == recording()
    with pytest.raises(TrajectoryFileError) as bad:
        files.load(tmp_path / "2.log")
    with pytest.raises(TrajectoryFileError, match=r"4\.log: cannot be read"):
        files.load(tmp_path / "4.log")

    assert bad.value.file == "2.log"
    assert (bad.value.line, bad.value.column) == (3, 7)
