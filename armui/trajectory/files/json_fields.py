"""The fields of a JSON object, each asked for with the type it must have."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode

Path = tuple[str | int, ...]
"""Keys and indices that lead from the whole file to a value."""


class FieldError(Exception):
    """A field that is missing or wrong.

    Attributes:
        reason: Why, as `TrajectoryFileError` wants it.
        path: To the field, or to the object it is missing in.
    """

    def __init__(self, reason: Refusal, path: Path) -> None:
        super().__init__(reason, path)
        self.reason = reason
        self.path = path


class Fields:
    """One JSON object; it knows which of its fields nobody has asked for."""

    def __init__(self, value: object, path: Path) -> None:
        self.path = path
        if not isinstance(value, dict):
            name = str(path[-1]) if path else "{}"
            raise FieldError(
                Refusal(RefusalCode.JSON_FIELD_BAD, {"field": name, "expected": "{…}"}), path
            )
        self._values: dict[str, Any] = value
        self._asked: set[str] = set()

    def __contains__(self, name: str) -> bool:
        return name in self._values

    def bad(self, name: str, expected: str) -> FieldError:
        """The error that says what should have been there."""
        reason = Refusal(RefusalCode.JSON_FIELD_BAD, {"field": name, "expected": expected})
        return FieldError(reason, (*self.path, name))

    def text(self, name: str, default: str | None = None) -> str:
        """A text."""
        value = self._value(name, default)
        if not isinstance(value, str):
            raise self.bad(name, "“…”")
        return value

    def number(self, name: str, default: float | None = None) -> float:
        """A finite number."""
        value = _number(self._value(name, default))
        if value is None:
            raise self.bad(name, "0.0")
        return value

    def whole(self, name: str, default: int | None = None) -> int:
        """A whole number."""
        value = self._value(name, default)
        if not isinstance(value, int) or isinstance(value, bool):
            raise self.bad(name, "0")
        return value

    def numbers(self, name: str, counts: tuple[int, ...]) -> tuple[float, ...]:
        """A list of numbers, as many as one of the counts says."""
        values = _numbers(self._value(name, None), counts)
        if values is None:
            raise self.bad(name, f"[{' / '.join(map(str, counts))} × 0.0]")
        return values

    def number_lists(self, name: str, counts: tuple[int, ...]) -> Iterator[tuple[float, ...]]:
        """Each of a list of such lists."""
        for index, value in enumerate(self._list(name)):
            values = _numbers(value, counts)
            if values is None:
                expected = f"[{' / '.join(map(str, counts))} × 0.0]"
                reason = Refusal(RefusalCode.JSON_FIELD_BAD, {"field": name, "expected": expected})
                raise FieldError(reason, (*self.path, name, index))
            yield values

    def texts(self, name: str) -> tuple[str, ...]:
        """A list of texts; none where it is missing."""
        values = self._list(name, [])
        if not all(isinstance(value, str) for value in values):
            raise self.bad(name, "[“…”, …]")
        return tuple(values)

    def object(self, name: str) -> Fields | None:
        """An object within, or ``None`` where there is none, or null."""
        value = self._value(name, _NONE)
        return None if value is None or value is _NONE else Fields(value, (*self.path, name))

    def objects(self, name: str) -> Iterator[Fields]:
        """Each of a list of objects."""
        for index, value in enumerate(self._list(name)):
            yield Fields(value, (*self.path, name, index))

    def nothing_else(self) -> None:
        """Makes sure that every field has been asked for: a misspelt one is no default.

        Raises:
            FieldError: One has not.
        """
        left = self._values.keys() - self._asked
        if left:
            name = min(left)
            reason = Refusal(RefusalCode.JSON_FIELD_UNKNOWN, {"value": name[:60]})
            raise FieldError(reason, (*self.path, name))

    def _list(self, name: str, default: list[Any] | None = None) -> list[Any]:
        value = self._value(name, default)
        if not isinstance(value, list):
            raise self.bad(name, "[…]")
        return value

    def _value(self, name: str, default: Any) -> Any:
        self._asked.add(name)
        value = self._values.get(name, default)
        if value is None and name not in self._values:
            raise FieldError(Refusal(RefusalCode.JSON_FIELD_MISSING, {"field": name}), self.path)
        return value


_NONE = object()


def _number(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        result = float(value)
    except OverflowError:
        return None
    return result if result - result == 0.0 else None


def _numbers(values: object, counts: tuple[int, ...]) -> tuple[float, ...] | None:
    if not isinstance(values, list) or len(values) not in counts:
        return None
    numbers = tuple([_number(value) for value in values])
    return None if None in numbers else numbers  # type: ignore[return-value]  # no None is left
