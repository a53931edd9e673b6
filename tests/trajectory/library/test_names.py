"""Names of trajectories, and of the files that hold them."""

from pathlib import Path

import pytest
from hypothesis import given, settings

from armui.trajectory.library.file_names import file_stem, folded, free_stem
from armui.trajectory.points.program import LONGEST_NAME, check_name
from tests.examples import examples
from tests.trajectory.library.contents import names, opened, shown, trajectory
from tests.trajectory.strategies import NAME, TEXT

ODD_NAMES = [
    *("取料/放料: 第1步?", "a<b>|c\"d*e\\f", "CON", "nul.log", "com1", ".hidden", "..", "~x", "x."),
    *("ends in a space ", "🦾" * LONGEST_NAME, "Run", "run", "RUN", "é", "e\u0301", "ß", "ss"),
    *("a\u200bb", "a_b", "a/b", "a:b", "a\tb", "a.draft", "a.npz", "-rf", "ﬁ", "fi", "\u202eb"),
]  # fmt: skip


def test_every_name_finds_its_file_even_where_case_counts_nothing(library, folder):
    for count, name in enumerate(ODD_NAMES):
        library.save(trajectory(name, count))
    assert names(library) == sorted(ODD_NAMES)
    again = opened(folder)
    for count, name in enumerate(ODD_NAMES):
        assert len(again.load(name).points) == count
    stems = {folded(Path(file).stem) for file in shown(folder)}
    assert len(stems) == len(ODD_NAMES)


@settings(max_examples=examples(100))
@given(TEXT | NAME)
def test_a_file_name_is_one_everywhere(name):
    stem = file_stem(name)
    assert stem
    assert len(stem.encode()) <= 125
    assert not set('<>:"/\\|?*') & set(stem)
    assert stem.isprintable()
    assert not stem.startswith((".", " ", "~"))
    assert not stem.endswith((".", " "))
    assert file_stem(stem) == stem


@pytest.mark.parametrize("device", ["con", "NUL", "lpt9", "Com1.tar"])
def test_no_file_is_called_like_a_device(device):
    assert file_stem(device) == f"_{device}"


def test_a_stem_is_numbered_until_it_is_free():
    assert free_stem("Run", {"run", "run 2"}) == "Run 3"


def test_a_free_name(library):
    assert library.free_name("pick") == "pick"
    library.save(trajectory())
    library.save_draft("pick 2", trajectory())
    assert library.free_name("pick") == "pick 3"
    for wanted in ("", "\n", "a\nb", "\ud800x\0", "x" * 1000):
        assert check_name(library.free_name(wanted)) is None
    assert library.free_name("a\nb") == "a b"
