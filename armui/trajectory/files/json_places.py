"""Where in a JSON text a value stands; only asked when there is something to complain about."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from armui.arm.json_fields import Path

_Scan = Callable[[str, int], tuple[Any, int]]


def place_of(text: str, path: Path) -> tuple[int, int]:
    """Line and column, from 1, of the value a path leads to, or of the last one found on the way.

    Args:
        text: Sound JSON.
        path: Keys and indices.
    """
    scan = json.JSONDecoder().raw_decode
    position = _skip(text, 0)
    for step in path:
        found = _enter(text, position, step, scan)
        if found is None:
            break
        position = found
    line = text.count("\n", 0, position) + 1
    return line, position - text.rfind("\n", 0, position)


def _enter(text: str, position: int, step: str | int, scan: _Scan) -> int | None:
    """Where the member of an object or list begins; of two with one name the last."""
    is_object = isinstance(step, str)
    if text[position : position + 1] != ("{" if is_object else "["):
        return None
    position = _skip(text, position + 1)
    index, found = 0, None
    while position < len(text) and text[position] not in "]}":
        key: object = index
        if is_object:
            key, position = scan(text, position)
            position = _skip(text, _skip(text, position) + 1)
        if key == step:
            found = position
            if not is_object:
                return found
        _, position = scan(text, position)
        position = _skip(text, position)
        if text[position : position + 1] == ",":
            position = _skip(text, position + 1)
        index += 1
    return found


def _skip(text: str, position: int) -> int:
    """Past white space."""
    while position < len(text) and text[position] in " \t\r\n":
        position += 1
    return position
