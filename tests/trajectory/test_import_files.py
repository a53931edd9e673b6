"""Several files imported at once."""

from armui.trajectory import files
from tests.trajectory.library.contents import recording, trajectory


def test_good_files_are_taken_and_bad_ones_told(tmp_path):
    good = files.to_bytes(trajectory(), ".csv")
    (tmp_path / "1.csv").write_bytes(good)
    (tmp_path / "2.log").write_text("armui trajectory 1\n\nJ 0 0 o 0 0 0\n")
    (tmp_path / "3.json").write_bytes(files.to_bytes(recording(), ".json"))

    contents, errors = files.import_files(
        [tmp_path / name for name in ("1.csv", "2.log", "3.json", "4.log")]
    )

    assert contents == [trajectory(), recording()]
    assert [error.file for error in errors] == ["2.log", "4.log"]
    assert (errors[0].line, errors[0].column) == (3, 7)
    assert str(errors[1]).startswith("4.log: cannot be read")
