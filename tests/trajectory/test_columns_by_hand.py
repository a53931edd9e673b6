"""Tables of an unknown dialect as the operator says they are: encoding, delimiter, first line."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.trajectory import columns
from armui.trajectory.columns import Dialect, Encoding
from armui.trajectory.columns.model import DECIMALS, DELIMITERS
from armui.trajectory.columns.source import decode_as, guess_encoding
from armui.trajectory.files import TrajectoryFileError
from tests.examples import examples
from tests.trajectory.strategies import outcome

ROW = "1,5;2;3\n"


def built(text, **said):
    sheet = columns.sniff(text, Dialect(**said))
    return sheet.delimiter, sheet.decimal, sheet.first_line, sheet.width


def test_what_is_not_said_is_guessed():
    assert built(ROW * 3) == (";", ",", 1, 3)
    assert built(ROW * 3, decimal=",") == (";", ",", 1, 3)
    assert built(ROW * 3, delimiter=";") == (";", ",", 1, 3)


def test_what_is_said_counts_also_where_it_makes_little_sense():
    assert built(ROW * 3, delimiter=",") == (",", ".", 1, 2)
    assert built(ROW * 3, delimiter="\t")[3] == 1
    assert built(ROW * 3, delimiter=";", decimal=".") == (";", ".", 1, 3)
    sheet = columns.sniff("some prose\nand more\n", Dialect(delimiter=";"))
    assert (sheet.width, sheet.preview) == (1, (("some prose",), ("and more",)))
    assert [guess.column for guess in sheet.guesses] == [None]


def test_the_line_of_the_first_figures_is_said():
    text = "# by hand\n7;8;9\nt;j1;j2\n0;1;2\n1;1;2\n"
    sheet = columns.sniff(text)
    assert (sheet.first_line, sheet.header, sheet.count) == (2, (), 4)
    sheet = columns.sniff(text, Dialect(first_line=4))
    assert (sheet.first_line, sheet.header, sheet.count) == (4, ("t", "j1", "j2"), 2)
    assert [guess.column and str(guess.column.quantity) for guess in sheet.guesses] == [
        *("time", "J1", "J2")
    ]
    assert sheet.preview[0] == ("0", "1", "2")
    assert columns.sniff(text, Dialect(first_line=999)).first_line == 5


def test_what_stands_above_the_first_line_is_no_measure_of_the_table():
    text = "a;b;c;d;e\n" * 30 + "1;2\n3;4\n"
    assert built(text, first_line=31) == (";", ".", 31, 2)


def test_rows_are_counted_without_comments_and_empty_ones():
    sheet = columns.sniff("t,x\n1,2\n\n# no\n3,4\n  \n")
    assert (sheet.count, sheet.lines) == (2, 6)


def test_a_table_broken_further_down_is_shown_up_to_there_and_told_where(tmp_path):
    row = "1,2,3,4,5,6,7\n"
    text = row * 3 + f'"{"x" * (1 << 21)}",2,3,4,5,6,7\n' + row
    sheet = columns.sniff(text)
    assert len(sheet.preview) == 3
    mapping = columns.ColumnMapping(tuple(guess.column for guess in sheet.guesses))
    with pytest.raises(TrajectoryFileError, match="line 4"):
        columns.apply(text, sheet, mapping, "x")


def test_thousands_of_columns_are_imported():
    titles = ["other"] * 3000
    titles[2000:2007] = "t_s", *(f"j{joint}_deg" for joint in range(1, 7))
    text = ",".join(titles) + "\n" + (",".join(["1.5"] * 3000) + "\n") * 100
    sheet = columns.sniff(text)
    assert sheet.width == 3000
    assert [place for place, guess in enumerate(sheet.guesses) if guess.column] == [
        *range(2000, 2007)
    ]


# Encodings ----------------------------------------------------------------------------------------

TITLES = "时间(秒);关节1\n1;2\n"


@pytest.mark.parametrize(
    ("data", "encoding"),
    [
        (TITLES.encode("utf-8"), Encoding.UTF_8),
        (TITLES.encode("utf-8-sig"), Encoding.UTF_8),
        (TITLES.encode("gbk"), Encoding.GBK),
        (TITLES.encode("utf-16"), Encoding.UTF_16_LE),
        (b"\xfe\xff" + TITLES.encode("utf-16-be"), Encoding.UTF_16_BE),
        (TITLES.encode("utf-16-le"), Encoding.UTF_16_LE),
        (TITLES.encode("utf-16-be"), Encoding.UTF_16_BE),
    ],
)
def test_the_encoding_is_found(data, encoding):
    assert guess_encoding(data) is encoding
    assert decode_as(data, encoding) == TITLES


def test_western_files_are_read_that_are_neither_utf_8_nor_gbk(tmp_path):
    path = tmp_path / "winkel.txt"
    path.write_bytes("J1 (°);größe\n1,5;2\n".encode("cp1252"))
    table = columns.open_table(path)
    assert table.encoding is Encoding.WESTERN
    assert table.sheet.header == ("J1 (°)", "größe")


def test_a_file_is_read_anew_as_the_operator_says(tmp_path):
    path = tmp_path / "表.txt"
    path.write_bytes("éa;b\n1;2\n".encode("cp1252"))  # also valid in GBK, as another character
    table = columns.open_table(path)
    assert table.encoding is Encoding.GBK
    assert table.read_anew(Encoding.WESTERN, Dialect()).sheet.header == ("éa", "b")
    with pytest.raises(TrajectoryFileError) as caught:
        table.read_anew(Encoding.UTF_8, Dialect())
    error = caught.value
    assert (error.file, error.line, error.column) == ("表.txt", 1, 1)
    assert (error.refusal.code, error.refusal.params) == ("file_not_encoding", {"value": "UTF-8"})


def test_the_odd_character_is_found():
    with pytest.raises(TrajectoryFileError) as caught:
        decode_as(b"t;j1\r\n1;\xff2\r\n", Encoding.UTF_8)
    assert (caught.value.line, caught.value.column) == (2, 3)
    with pytest.raises(TrajectoryFileError) as caught:
        decode_as(b"1;2\n\0;3\n", Encoding.WESTERN)
    assert (caught.value.line, caught.value.column) == (2, 1)


def test_a_file_that_is_gone_is_told(tmp_path):
    with pytest.raises(TrajectoryFileError, match=r"gone\.txt: The file cannot be read"):
        columns.open_table(tmp_path / "gone.txt")


@settings(max_examples=examples(100))
@given(
    st.binary(max_size=120) | st.text("0123456789.,;\t| -#é时\n", max_size=120).map(str.encode),
    st.none() | st.sampled_from(list(Encoding)),
    st.builds(
        Dialect,
        st.none() | st.sampled_from(DELIMITERS),
        st.none() | st.sampled_from(DECIMALS),
        st.none() | st.integers(1, 9),
    ),
)
def test_any_bytes_in_any_dialect_are_read_or_refused(data, encoding, dialect):
    table = columns.TableFile("x", data, Encoding.UTF_8, "", columns.sniff("1,2"))
    table = outcome(table.read_anew, encoding, dialect)
    if isinstance(table, TrajectoryFileError):
        assert table.refusal.reason.source
        return
    sheet = table.sheet
    assert len(sheet.guesses) == sheet.width >= 1
    assert 1 <= sheet.first_line <= max(1, sheet.lines)
    for said, shown in (
        (dialect.delimiter, sheet.delimiter),
        (dialect.decimal, sheet.decimal),
    ):
        assert said in (None, shown)
    assert encoding in (None, table.encoding)
