"""Has any function of the program raise, also one that Qt or a signal holds already."""

from __future__ import annotations

import dis
import inspect
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from types import FunctionType
from typing import NoReturn

ERROR = "made to fail"


def _fails() -> NoReturn:
    raise ArithmeticError("made to fail")


@contextmanager
def failing(*functions: FunctionType) -> Iterator[None]:
    """Have functions raise `ArithmeticError` whenever they are called, as their first act.

    What they are made of is exchanged: the traceback names their own module.
    """
    codes = [function.__code__ for function in functions]
    with_error = _fails.__code__
    for function, code in zip(functions, codes, strict=True):
        enclosed = len(code.co_freevars)
        prologue = bytes([dis.opmap["COPY_FREE_VARS"], enclosed]) if enclosed else b""
        function.__code__ = code.replace(
            co_code=prologue + with_error.co_code,
            co_cellvars=(),
            co_consts=with_error.co_consts,
            co_names=with_error.co_names,
            co_stacksize=with_error.co_stacksize,
            co_exceptiontable=with_error.co_exceptiontable,
            # its one instruction more has no place in a line
            co_linetable=(b"\xf8" if enclosed else b"") + with_error.co_linetable,
        )
    try:
        yield
    finally:
        for function, code in zip(functions, codes, strict=True):
            function.__code__ = code


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
            found.append(function)
    return [each for each in found if each.__name__ != "__init__"]
