"""Checks that commands of several kinds share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from armui.protocol.errors import EncodeError

T = TypeVar("T")


def exactly(message: str, values: Sequence[T], count: int, what: str, unit: str) -> tuple[T, ...]:
    """The values, if there are as many as the message wants.

    Raises:
        EncodeError: There are more or fewer.
    """
    if len(values) != count:
        text = f"{message} wants {count} {what}, not {len(values)}"
        raise EncodeError(text, message=message, value=list(values), unit=unit)
    return tuple(values)
