"""Has any function of the program raise, also one that Qt or a signal holds already."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cached_property
from types import CodeType, FunctionType
from typing import Any

ERROR = "made to fail"


def _code_that_fails(enclosed: int) -> CodeType:
    """Return code that raises at once, for a function that uses so many variables around it."""
    names = ", ".join(f"v{number}" for number in range(enclosed))
    source = (
        f"def outer({names}):\n def fails(*_arguments, **_more):\n"
        f"  ({names}{',' if enclosed else ''})\n  raise ArithmeticError({ERROR!r})\n return fails"
    )
    namespace: dict[str, Any] = {}
    exec(source, namespace)
    code: CodeType = namespace["outer"](*range(enclosed)).__code__
    return code


@contextmanager
def failing(*functions: Callable[..., Any]) -> Iterator[None]:
    """Have functions raise `ArithmeticError` whenever they are called, as their first act.

    What they are made of is exchanged: the traceback names their own module.
    """
    own = [each for each in map(inspect.unwrap, functions) if isinstance(each, FunctionType)]
    assert len(own) == len(functions)
    codes = [function.__code__ for function in own]
    for function, code in zip(own, codes, strict=True):
        function.__code__ = _code_that_fails(len(code.co_freevars)).replace(
            co_filename=code.co_filename,
            co_firstlineno=code.co_firstlineno,
            co_name=code.co_name,
            co_qualname=code.co_qualname,
        )
    try:
        yield
    finally:
        for function, code in zip(own, codes, strict=True):
            function.__code__ = code


def getter(kind: type, name: str) -> FunctionType:
    """Return the function behind a property of a class."""
    found = vars(kind)[name].fget
    assert isinstance(found, FunctionType)
    return found


def functions_of(kind: type) -> list[FunctionType]:
    """The functions that a class defines: methods, questions, and what is asked for as a value."""
    found = []
    for each in vars(kind).values():
        function = each
        if isinstance(each, property):
            function = each.fget
        elif isinstance(each, cached_property):
            function = each.func
        elif isinstance(each, staticmethod | classmethod):
            function = each.__func__
        if isinstance(function, FunctionType) and not inspect.isgeneratorfunction(function):
            found.append(inspect.unwrap(function))
    return [each for each in found if each.__name__ != "__init__"]
