"""Checks that commands of several kinds share."""

from __future__ import annotations

from collections.abc import Sequence

from armui.protocol.errors import EncodeError


def exactly(
    message: str, values: Sequence[float], count: int, what: str, unit: str
) -> tuple[float, ...]:
    """The values, if there are as many as the message wants.

    Raises:
        EncodeError: There are more or fewer.
    """
    if len(values) != count:
        text = f"{message} wants {count} {what}, not {len(values)}"
        raise EncodeError(text, message=message, value=list(values), unit=unit)
    return tuple(values)
