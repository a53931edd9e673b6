"""Keeps exceptions within the functions that Qt calls: its events, and what it asks of a widget.

PySide keeps an exception of such a function until the call from Python returns in which Qt called
it. Until then PySide skips each further function of ours that Qt calls, PySide 6.11.3 releases a
reference to it that is still in use, so that it is freed sooner or later, and the exception may be
lost. None of this happens if the function reports its exception itself.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import suppress
from functools import wraps
from types import FunctionType
from typing import Any, Final

from PySide6.QtCore import QObject

_FILTERS: Final = frozenset({"event", "eventFilter"})
_QUESTIONS: Final = frozenset(
    {
        *("sizeHint", "minimumSizeHint", "minimumSize", "heightForWidth", "hasHeightForWidth"),
        *("data", "headerData", "flags", "rowCount", "columnCount"),
        *("filterAcceptsRow", "lessThan", "paint", "drawRow"),
    }
)
"""Functions that Qt asks while it lays out and draws: Qt's own answer replaces an exception."""


def is_guarded(kind: type, name: str) -> bool:
    """Return whether Qt calls a function of this name in such a class, so that it is guarded."""
    if name not in _FILTERS | _QUESTIONS and not name.endswith("Event"):
        return False
    return any(name in vars(base) for base in kind.__mro__ if base.__module__.startswith("PySide6"))


def guarded(function: Callable[..., Any], kind: type | None = None) -> Callable[..., Any]:
    """Return a function that reports its exceptions itself, instead of passing them to PySide.

    Args:
        function: The function; after an exception an event counts as not handled.
        kind: The class, whose Qt base then answers a question.
    """
    name = function.__name__

    @wraps(function)
    def call(self: Any, *arguments: Any, **named: Any) -> Any:
        try:
            return function(self, *arguments, **named)
        except Exception as error:  # noqa: BLE001 - no exception may reach Qt
            # the trace begins at the function that failed, as PySide would report it, not in this
            # wrapper
            trace = error.__traceback__ and error.__traceback__.tb_next
            sys.excepthook(type(error), error.with_traceback(trace), trace)
        if kind is None or name not in _QUESTIONS:
            return False
        with suppress(Exception):  # pure virtual functions have no implementation in Qt
            return getattr(super(kind, self), name)(*arguments, **named)
        return 0 if name.endswith("Count") else None

    return call


def guard_overrides() -> None:
    """Guard the functions that Qt calls in each class of a `QObject` that is defined from now on.

    A class of another kind that is mixed in has its own guarded by `guarded`.
    """
    QObject.__init_subclass__ = classmethod(_guard)  # type: ignore[assignment,method-assign]


def _guard(kind: type[QObject], /, **more: Any) -> None:
    super(QObject, kind).__init_subclass__(**more)
    for name, function in tuple(vars(kind).items()):
        if isinstance(function, FunctionType) and is_guarded(kind, name):
            setattr(kind, name, guarded(function, kind))
