"""Reads plain YAML, which PyYAML parses: lists, mappings and scalars, without aliases and tags.

The values are made of PyYAML's events: its loaders take 80 bytes of memory for each of a
file, and figures by YAML 1.1, where ``1e-3`` is a text and ``12:30`` a number.
Imported only where YAML is read, as PyYAML takes 30 ms.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Final

import yaml

_LOADER: Final = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
"""PyYAML may have been built without libyaml."""
_SIGNS: Final = {".nan": math.nan, ".inf": math.inf, "+.inf": math.inf, "-.inf": -math.inf}
_WORDS: Final = {"null": None, "~": None, "": None, "true": True, "false": False} | _SIGNS


def read_yaml(text: str) -> list[Any] | None:
    """Return the documents of a text in plain YAML, or ``None`` if it is no such text.

    Raises:
        RecursionError: Its lists and mappings are nested some hundred times.
    """
    events = yaml.parse(text, Loader=_LOADER)
    try:
        documents = [
            _value(next(events), events)
            for event in events
            if isinstance(event, yaml.DocumentStartEvent)
        ]
    except yaml.YAMLError:
        return None
    return [each for each in documents if each is not None]


def _value(event: Any, events: Iterator[yaml.Event]) -> Any:
    """Return the value that begins with an event, and take the others of it.

    Raises:
        YAMLError: It is no YAML, or has tags or aliases; a few aliases can expand to millions.
    """
    if isinstance(event, yaml.AliasEvent) or event.tag is not None:
        raise yaml.YAMLError
    if isinstance(event, yaml.ScalarEvent):
        return event.value if event.style else _scalar(event.value)
    items: list[Any] = []
    for each in events:
        if isinstance(each, yaml.CollectionEndEvent):
            break
        items.append(_value(each, events))
    if isinstance(event, yaml.SequenceStartEvent):
        return items
    return dict(zip(map(str, items[::2]), items[1::2], strict=True))


def _scalar(text: str) -> Any:
    """Return the value of a scalar without quotation marks: a number, a word or a text."""
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text)
    except ValueError:
        return _WORDS.get(text.lower(), text)
