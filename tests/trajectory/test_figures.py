"""The fast way through a long table and the slow one say the same."""

from __future__ import annotations

import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.trajectory.columns import ColumnMapping, ColumnQuantity, TableColumn, apply, sniff
from armui.trajectory.files import TrajectoryFileError, log_file
from armui.trajectory.files.text import read_figures

HEAD = ["armui recording 1", ""]
LINES = st.lists(
    st.sampled_from(["0 1 2 3 4 5 6", "1 1 2 3 4 5 6 35", "", "# 1", "  ", "\t# 2"])
    | st.text("0123456789 .-e#\r", max_size=20),
    max_size=8,
)
apply_module = sys.modules[apply.__module__]  # the package calls the function so, too


def outcome(call, *arguments):
    """What a call returns, or what its error says."""
    try:
        return call(*arguments)
    except TrajectoryFileError as error:
        return str(error)


@given(LINES)
def test_a_recording_reads_the_same_fast_or_slow(lines):
    fields = {"name": "x"}
    fast = outcome(log_file.read_samples, HEAD + lines, 2, fields)
    slow = outcome(log_file._read_one_by_one, HEAD + lines, 2, fields)
    assert fast == slow


@pytest.mark.parametrize(
    ("lines", "shape"), [(["1 2", "3 4"], (2, 2)), (["1"], (1, 1)), (["1e3 -2.5"], (1, 2))]
)
def test_plain_numbers_are_read(lines, shape):
    assert read_figures(lines, None).shape == shape


NOT_PLAIN = [[], ["1 2", "3"], ["1 x"], ["1 nan"], ["inf 1"], ["1\r2"], ["1_0"], ["1 2 #"]]


@pytest.mark.parametrize("lines", NOT_PLAIN)
def test_anything_else_is_left_to_the_slow_way(lines):
    assert read_figures(lines, None) is None


ROW = "0;1;2;3;4;5;6"
ODD_ROWS = ("", " 1 ;1;2;3;4;5;6", "1;1;2;3;4;5;6;", "1;1;2;3;4;5", "# no", "1;;;;;;")
ROWS = st.lists(
    st.sampled_from([ROW, *ODD_ROWS]) | st.text("0123456789;.-e#", max_size=20), max_size=8
)
MAPPING = ColumnMapping(
    (
        TableColumn(ColumnQuantity.TIME, "s"),
        *(TableColumn(ColumnQuantity(f"J{joint}"), "°") for joint in range(1, 7)),
    )
)


@given(ROWS)
def test_a_table_reads_the_same_fast_or_slow(rows):
    sheet = sniff(f"{ROW}\n{ROW}\n")
    text = "\n".join([ROW, *rows])
    with pytest.MonkeyPatch.context() as patch:
        fast = outcome(apply, text, sheet, MAPPING, "x")
        patch.setattr(apply_module, "read_figures", lambda *_: None)
        slow = outcome(apply, text, sheet, MAPPING, "x")
    assert fast == slow
