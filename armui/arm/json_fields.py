"""Reads the fields of a JSON object, each with the type it must have."""

from __future__ import annotations

import enum
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Any

from armui.arm.refusal import Refusal

Path = tuple[str | int, ...]
"""Keys and indices that lead from the whole file to a value."""


class FieldProblem(enum.Enum):
    """The ways in which a field can be wrong."""

    MISSING = "is missing"
    BAD = "is not what it should be"
    UNKNOWN = "is unknown"


@dataclass(eq=False, repr=False)
class FieldError(Exception):
    """A field that is missing or wrong.

    Attributes:
        problem: The kind of error.
        path: The keys and indices that lead to the field.
        value: The field's value; ``None`` if it is missing.
        expected: An example of a right value.
        refusal: The reason, if something other than the type is wrong.
    """

    problem: FieldProblem
    path: Path
    value: object = None
    expected: str = ""
    refusal: Refusal | None = None

    @property
    def name(self) -> str:
        """The field's name, or that of the list it is in."""
        return next((step for step in reversed(self.path) if isinstance(step, str)), "{}")

    @property
    def place(self) -> str:
        """The path to the field, as ``arm.parameters[1].value``."""
        steps = (f".{step}" if isinstance(step, str) else f"[{step + 1}]" for step in self.path)
        return "".join(steps).removeprefix(".")

    def __str__(self) -> str:
        if self.problem is not FieldProblem.BAD:
            return f"{self.place} {self.problem.value}"
        return f"{self.place} holds {self.value!r} where {self.expected} belongs"


class Fields:
    """The fields of one JSON object; it knows which of them have not been read.

    All methods that read a field raise `FieldError`.
    """

    def __init__(self, value: object, path: Path = ()) -> None:
        self.path = path
        if not isinstance(value, dict):
            raise FieldError(FieldProblem.BAD, path, value, "{…}")
        self._values: dict[str, Any] = value
        self._asked: set[str] = set()

    def __contains__(self, name: str) -> bool:
        return name in self._values

    def bad(self, name: str, expected: str) -> FieldError:
        """Return the error for a field of the wrong type, with an example of a right value."""
        return FieldError(FieldProblem.BAD, (*self.path, name), self._values.get(name), expected)

    def wrong(self, name: str, reason: Refusal) -> FieldError:
        """Return the error for a field that has a reason of its own."""
        path = (*self.path, name)
        return FieldError(FieldProblem.BAD, path, self._values.get(name), refusal=reason)

    def text(self, name: str, default: str | None = None) -> str:
        """Return the text in a field, or the default, if there is one, where it is missing."""
        value = self._value(name, default)
        if not isinstance(value, str):
            raise self.bad(name, "“…”")
        return value

    def maybe_text(self, name: str) -> str | None:
        """Return the text in a field, or ``None`` if it is missing or null."""
        self._asked.add(name)
        return None if self._values.get(name) is None else self.text(name)

    def given(self, name: str) -> bool:
        """Return whether a field exists and is not null; a null counts as read."""
        self._asked.add(name)
        return self._values.get(name) is not None

    def flag(self, name: str) -> bool:
        """Return the truth value in a field."""
        value = self._value(name, None)
        if not isinstance(value, bool):
            raise self.bad(name, "true / false")
        return value

    def number(self, name: str, default: float | None = None) -> float:
        """Return the number in a field; NaN and infinities are refused like texts."""
        value = finite(self._value(name, default))
        if value is None:
            raise self.bad(name, "0.0")
        return value

    def whole(
        self, name: str, default: int | None = None, allowed: Collection[int] | None = None
    ) -> int:
        """Return the whole number in a field, one of the allowed ones if they are given."""
        value = self._value(name, default)
        if not _is_whole(value, allowed):
            raise self.bad(name, _example(allowed))
        return int(value)

    def wholes(self, name: str, count: int, allowed: Collection[int]) -> tuple[int, ...]:
        """Return a list of `count` whole numbers."""
        values = self._list(name, count)
        for index, value in enumerate(values):
            if not _is_whole(value, allowed):
                path = (*self.path, name, index)
                raise FieldError(FieldProblem.BAD, path, value, _example(allowed))
        return tuple(values)

    def numbers(self, name: str, counts: tuple[int, ...]) -> tuple[float, ...]:
        """Return a list of numbers whose length is one of the counts."""
        values = _numbers(self._value(name, None), counts)
        if values is None:
            raise self.bad(name, f"[{' / '.join(map(str, counts))} × 0.0]")
        return values

    def number_lists(self, name: str, counts: tuple[int, ...]) -> Iterator[tuple[float, ...]]:
        """Yield the lists of numbers in a list; the length of each is one of the counts."""
        for index, value in enumerate(self._list(name)):
            values = _numbers(value, counts)
            if values is None:
                expected = f"[{' / '.join(map(str, counts))} × 0.0]"
                path = (*self.path, name, index)
                raise FieldError(FieldProblem.BAD, path, value, expected)
            yield values

    def texts(self, name: str) -> tuple[str, ...]:
        """Return a list of texts; an empty one if the field is missing."""
        values = self._list(name) if name in self._values else []
        if not all(isinstance(value, str) for value in values):
            raise self.bad(name, "[“…”, …]")
        return tuple(values)

    def object(self, name: str) -> Fields:
        """Return the fields of the JSON object in a field; its errors name the whole path."""
        return Fields(self._value(name, None), (*self.path, name))

    def maybe_object(self, name: str) -> Fields | None:
        """Return the object in a field, or ``None`` if it is missing or null."""
        self._asked.add(name)
        return None if self._values.get(name) is None else self.object(name)

    def objects(self, name: str, count: int | None = None) -> Iterator[Fields]:
        """Yield the objects in a list, which must have `count` entries if that is given."""
        for index, value in enumerate(self._list(name, count)):
            yield Fields(value, (*self.path, name, index))

    def nothing_else(self) -> None:
        """Raise a `FieldError` if a field was not read, so that a misspelt name is noticed."""
        left = self._values.keys() - self._asked
        if left:
            raise FieldError(FieldProblem.UNKNOWN, (*self.path, min(left)))

    def _list(self, name: str, count: int | None = None) -> list[Any]:
        value = self._value(name, None)
        if not isinstance(value, list) or count not in (None, len(value)):
            raise self.bad(name, "[…]" if count is None else f"a list of {count}")
        return value

    def _value(self, name: str, default: Any) -> Any:
        self._asked.add(name)
        value = self._values.get(name, default)
        if value is None and name not in self._values:
            raise FieldError(FieldProblem.MISSING, (*self.path, name))
        return value


def finite(value: object) -> float | None:
    """Return a value as a finite number, or ``None`` if it is none: a truth value, a text."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        result = float(value)
    except OverflowError:
        return None
    return result if result - result == 0.0 else None


def _is_whole(value: object, allowed: Collection[int] | None) -> bool:
    if isinstance(value, bool) or not isinstance(value, int):
        return False
    return allowed is None or value in allowed


def _example(allowed: Collection[int] | None) -> str:
    return "0" if allowed is None else f"one of {', '.join(map(str, allowed))}"


def _numbers(values: object, counts: tuple[int, ...]) -> tuple[float, ...] | None:
    if not isinstance(values, list) or len(values) not in counts:
        return None
    numbers = tuple([finite(value) for value in values])
    return None if None in numbers else numbers  # type: ignore[return-value]  # None is excluded
