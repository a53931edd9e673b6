"""Keeps what PySide compiles: a dozen modules, from sources in its library, at every start.

Python does so for what it imports from files. It is kept beside what Python keeps of this module,
and what belongs to another source, another Python, or can't be read is compiled as if none of this
were here.
"""

from __future__ import annotations

import builtins
import importlib.util
import marshal
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import CodeType
from typing import Any

from armui.system.files import open_file, read_file

_Key = tuple[bytes, str, str]


@contextmanager
def compiled_once() -> Iterator[None]:
    """What is compiled within is looked up first; what is new is kept at the end."""
    compile_now = builtins.compile
    path = f"{importlib.util.cache_from_source(__file__)}.kept"
    kept = _read(path)
    used: dict[_Key, CodeType] = {}

    def look_up(source: Any, filename: Any, mode: str, *more: Any, **options: Any) -> Any:
        if more or options or not isinstance(source, bytes | str):
            return compile_now(source, filename, mode, *more, **options)
        text = source if isinstance(source, bytes) else source.encode()
        key = (importlib.util.source_hash(text), str(filename), mode)
        code = kept.get(key)
        used[key] = compile_now(source, filename, mode) if code is None else code
        return used[key]

    setattr(builtins, "compile", look_up)  # noqa: B010 - the types forbid it
    try:
        yield
    finally:
        setattr(builtins, "compile", compile_now)  # noqa: B010 - as above
    if not used.keys() <= kept.keys() and not sys.dont_write_bytecode:
        _write(path, used)


def _read(path: str) -> dict[_Key, CodeType]:
    with suppress(OSError, EOFError, ValueError, TypeError):
        kept = marshal.loads(read_file(path))  # noqa: S302 - written by us, beside Python's own
        if isinstance(kept, dict):
            return kept
    return {}


def _write(path: str, kept: dict[_Key, CodeType]) -> None:
    """Whole or not at all; where nothing may be written, nothing is."""
    own = f"{path}.{os.getpid()}"
    try:
        with open_file(own, "wb") as file:
            file.write(marshal.dumps(kept))
        os.replace(own, path)  # noqa: PTH105 - as above
    except OSError:
        with suppress(OSError):
            os.unlink(own)  # noqa: PTH108 - as above
