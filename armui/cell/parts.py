"""The common ground of the parts of a cell: lists by name, and the objects of its file."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import fields as fields_of
from typing import Any, Final, Protocol, TypeVar, get_args, get_type_hints

from armui.arm.json_fields import Fields
from armui.cell.checks import FIGURES, SIZES

_FIGURES: Final = {"pose": FIGURES, "size_mm": SIZES}
"""The attributes that become several fields of a file."""

Part = TypeVar("Part")


class _Named(Protocol):
    @property
    def name(self) -> str: ...


NamedPart = TypeVar("NamedPart", bound=_Named)


def part_named(parts: Iterable[NamedPart], name: str) -> NamedPart | None:
    """Return a part by its name, or ``None``."""
    return next((part for part in parts if part.name == name), None)


def put(parts: Iterable[NamedPart], part: NamedPart, instead_of: str) -> tuple[NamedPart, ...]:
    """Return a list with a part in the place of the one of a name, or at its end for ""."""
    if not instead_of:
        return (*parts, part)
    return tuple(part if each.name == instead_of else each for each in parts)


def without(parts: Iterable[NamedPart], name: str) -> tuple[NamedPart, ...]:
    """Return a list without the part of a name."""
    return tuple(each for each in parts if each.name != name)


def to_entry(part: Any) -> dict[str, object]:
    """Return a part, a frozen dataclass, as an object of a cell's file."""
    entry: dict[str, object] = {}
    for name in (each.name for each in fields_of(part)):
        value = getattr(part, name)
        if name in _FIGURES:
            entry.update(zip(_FIGURES[name], value, strict=True))
        elif isinstance(value, tuple):
            entry[name] = [each if isinstance(each, str) else to_entry(each) for each in value]
        else:
            entry[name] = value
    return entry


def from_entry(kind: type[Part], fields: Fields) -> Part:
    """Return the part of a kind in an object of a cell's file.

    Raises:
        FieldError: A field is missing, unknown or of another type.
    """
    kinds = get_type_hints(kind)
    part = kind(**{name: _value(each, name, fields) for name, each in kinds.items()})
    fields.nothing_else()
    return part


def _value(kind: Any, name: str, fields: Fields) -> object:
    if name in _FIGURES:
        return tuple(map(fields.number, _FIGURES[name]))
    if kind == tuple[str, ...]:
        return fields.texts(name)
    if parts := get_args(kind):
        return tuple(from_entry(parts[0], each) for each in fields.objects(name))
    readers: dict[Any, Callable[[str], object]] = {
        str: fields.text,
        float: fields.number,
        bool: fields.flag,
    }
    return readers[kind](name)
