"""What is compiled at every start is compiled once, and never wrongly."""

import builtins
import importlib.util
import sys

import pytest

from armui.system.compiled_once import compiled_once

SOURCE = "told = 6 * 7"
COMPILE = builtins.compile


@pytest.fixture(autouse=True)
def kept(tmp_path, monkeypatch):
    """The file, in a place of the test's own."""
    path = tmp_path / "module.pyc"
    monkeypatch.setattr(importlib.util, "cache_from_source", lambda _source: str(path))
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    return tmp_path / "module.pyc.kept"


@pytest.fixture
def compiled(monkeypatch):
    """What Python itself has compiled."""
    seen = []

    def compile_now(source, *arguments, **options):
        seen.append(source)
        return COMPILE(source, *arguments, **options)

    monkeypatch.setattr(builtins, "compile", compile_now)
    return seen


def told(source=SOURCE, filename="a.py", *more):
    with compiled_once():
        code = builtins.compile(source, filename, "exec", *more)
    space: dict[str, int] = {}
    exec(code, space)
    return space["told"]


def test_the_second_time_nothing_is_compiled(compiled):
    assert told() == told(SOURCE.encode()) == 42
    assert compiled == [SOURCE]


def test_another_source_of_the_same_name_is_compiled_and_the_old_one_forgotten(compiled, kept):
    told()
    size = kept.stat().st_size
    assert told("told = 5 * 7") == 35
    assert kept.stat().st_size == size
    assert told() == 42
    assert compiled == [SOURCE, "told = 5 * 7", SOURCE]


@pytest.mark.parametrize("content", [b"", b"nonsense", b"N", b"[\x01\x00"])
def test_what_cannot_be_read_is_compiled_and_kept_anew(compiled, kept, content):
    kept.write_bytes(content)
    assert told() == told() == 42
    assert compiled == [SOURCE]


def test_where_nothing_may_be_written_nothing_is(compiled, kept, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert told() == told() == 42
    assert len(compiled) == 2
    assert not kept.exists()


def test_a_place_that_takes_no_file_is_no_trouble(compiled, kept):
    kept.mkdir()
    assert told() == told() == 42
    assert len(compiled) == 2
    assert list(kept.parent.iterdir()) == [kept]


def test_what_is_asked_for_with_flags_is_left_to_python(compiled):
    assert told(SOURCE, "a.py", 0) == told(SOURCE, "a.py", 0) == 42
    assert len(compiled) == 2


def test_afterwards_python_compiles_as_before():
    with pytest.raises(ZeroDivisionError), compiled_once():
        raise ZeroDivisionError
    assert builtins.compile is COMPILE
