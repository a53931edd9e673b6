"""An operator who corrects what was guessed of an unknown table; large and odd ones."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from tests.operator.library.tables import ANGLES, RADIANS, TITLED, is_open

JOINTS = [f"J{joint} °" for joint in range(1, 7)]


def test_the_guess_is_where_it_begins(operator):
    operator.open(line=RADIANS.replace(".", ","))
    assert operator.built() == ("UTF-8", "semicolon ;", "comma ,", 1)
    assert operator.preview()[0][:2] == ["0,02", "0,1"]


def test_the_delimiter_is_chosen_and_the_preview_follows(operator):
    row = "1.5;20;-30;40;50;60.7\n"
    operator.open(line=row * 3)
    assert operator.built()[1] == "semicolon ;"
    operator.choose(operator.dialect_field("delimiter"), "comma ,")
    assert operator.preview()[0] == ["1.5;20;-30;40;50;60.7"]
    assert operator.message().startswith("Still missing")
    operator.choose(operator.dialect_field("delimiter"), "semicolon ;")
    operator.choose(operator.dialect_field("decimal"), "comma ,")
    assert operator.built()[1:3] == ("semicolon ;", "comma ,")
    assert operator.preview()[0] == ["1.5", "20", "-30", "40", "50", "60.7"]
    assert operator.message().startswith("Still missing")
    operator.choose(operator.dialect_field("decimal"), "point .")
    assert operator.columns() == JOINTS


def test_the_line_of_the_first_figures_is_typed(operator):
    text = "7 7 7 7 7 7\nj1 j2 j3 j4 j5 j6\n" + ANGLES
    operator.open(line=text)
    assert operator.built()[3] == 1
    operator.first_line(3)
    assert operator.preview() == [row.split() for row in ANGLES.splitlines()]
    assert operator.columns() == JOINTS
    assert "2 rows" in operator.child("source").text()
    operator.take()
    assert [point.target[0] for point in operator.library.load("line").points] == [10.0, 20.0]


def test_the_encoding_is_chosen(operator):
    operator.open(line=TITLED.replace("temperature", "温度").encode("gbk"))
    assert operator.built()[0] == "GBK"
    operator.choose(operator.dialect_field("encoding"), "UTF-8")
    assert operator.message() == (
        "line.csv, line 1, column 75: This is not text in UTF-8. Choose another encoding."
    )
    assert not operator.child("import").isEnabled()
    operator.choose(operator.dialect_field("encoding"), "GBK")
    assert operator.message() == ""
    operator.take()
    assert not is_open()


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig", "gb18030"])
def test_files_of_windows_are_read(operator, encoding):
    operator.open(line=TITLED.replace("temperature", "温度").encode(encoding))
    assert operator.columns() == ["Time ms", *JOINTS, "-"]
    operator.take()
    assert operator.library.load("line").samples.shape == (2, 8)


def test_what_was_said_of_the_columns_stays_while_they_are_the_same(operator):
    operator.open(line=ANGLES)
    operator.choose(operator.box("unit", 1), "rad")
    operator.call(6, "Ignored")
    operator.first_line(2)
    assert operator.columns() == ["J1 rad", *JOINTS[1:5], "-"]
    origins = [operator.page.findChild(QWidget, f"column_origin_{n}").text() for n in (1, 2)]
    assert origins == ["", "Guess: check it"]
    operator.choose(operator.dialect_field("delimiter"), "tab")
    assert len(operator.columns()) == 1
    operator.choose(operator.dialect_field("delimiter"), "spaces")
    assert operator.columns() == JOINTS


def test_comments_ragged_and_empty_rows(operator):
    text = TITLED + "\n# a pause\n% another\n// and one\n1040,12,22,-32,42,52,62\n"
    operator.open(line=text)
    assert "3 rows" in operator.child("source").text()
    operator.take()
    assert operator.message() == ("Not imported. Line 8: 7 cells where there are 8 columns.")


def test_of_thousands_of_columns_those_are_shown_that_say_something(operator):
    titles = [f"spare {number}" for number in range(2000)]
    titles[1500:1507] = TITLED.splitlines()[0].split(",")[:7]
    row = ["7"] * 2000
    row[1500:1507] = "0", "10", "20", "-30", "40", "50", "60"
    operator.open(line="\n".join([",".join(titles)] + [",".join(row)] * 2))
    assert "2000 columns" in operator.child("source").text()
    assert "1,933 further columns are left out" in operator.child("source").text()
    assert len(operator.preview()[0]) == 67
    assert operator.box("quantity", 1501).currentText() == "Time"
    operator.take()
    assert operator.library.load("line").joints_deg[1].tolist() == [10, 20, -30, 40, 50, 60]


def test_a_large_table_shows_its_beginning_and_how_large_it_is(operator):
    row = "0.01,0.1,0.5,-0.5,0.1,0.2,0.3,0.05,1\n"
    operator.open(line=row * 20_000)
    assert "20,000 rows; the first rows are shown" in operator.child("source").text()
    assert len(operator.preview()) == 10
    operator.app_driver.click(operator.child("radians"))
    operator.take()
    assert operator.library.entries()[0].count == 20_000


def test_the_window_answers_while_a_large_table_is_imported_and_the_import_is_given_up(operator):
    row = "10 40 -40 10 20 15\n"
    dialog = operator.open(line=row * 20_000)
    operator.app_driver.click(operator.child("import"))
    assert dialog.busy
    assert operator.message() == "Importing 20,000 rows…"
    assert not operator.child("import").isEnabled()
    assert operator.app_driver.find("stop_button").isEnabled()
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert operator.message() == "Cancelling the import…"
    operator.app_driver.wait(lambda: not dialog.busy)
    assert not is_open()
    assert operator.library.entries() == []
