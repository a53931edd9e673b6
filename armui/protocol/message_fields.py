"""Records whose fields name the signals they hold: ``friction: Annotated[float, "Friction"]``.

Such records are read from decoded frames, and encoded, without code of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, TypeVar, get_type_hints

T = TypeVar("T")


@cache
def signal_names(record: type) -> Mapping[str, str]:
    """Return the signal of every field of a record's class, by the field's name.

    Raises:
        TypeError: A field names no signal.
    """
    names: dict[str, str] = {}
    for field, hint in get_type_hints(record, include_extras=True).items():
        signal = getattr(hint, "__metadata__", (None,))[0]
        if not isinstance(signal, str):
            raise TypeError(f"{record.__name__}.{field} names no signal; annotate it with one")
        names[field] = signal
    return names


def record_reader(record: type[T]) -> Callable[[Mapping[str, float]], T]:
    """Return a function that fills a record from the signals of its message, in their units.

    The function raises `KeyError` for a message without one of the signals.
    """
    kind: type = record
    names = tuple(signal_names(kind).items())

    def read(signals: Mapping[str, float]) -> T:
        values: dict[str, Any] = {field: signals[name] for field, name in names}
        return record(**values)

    return read
