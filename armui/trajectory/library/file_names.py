"""Turns a trajectory's name, in any script and with any sign, into a valid file name."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Container
from typing import Final

_FORBIDDEN: Final = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')
"""Characters forbidden by Windows; macOS and Linux forbid only some of them."""
_RESERVED: Final = re.compile(r"(?:con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(?:\.|$)", re.IGNORECASE)
"""Names of devices on Windows, with any suffix."""
_LONGEST_BYTES: Final = 120
"""File systems take 255: this leaves room for a number, a suffix and encrypted folders."""


def file_stem(name: str) -> str:
    """Return a file name without suffix, as close as possible to a content's name.

    Args:
        name: Any text.
    """
    text = unicodedata.normalize("NFC", name)
    text = _FORBIDDEN.sub("_", text)
    text = "".join(character if character.isprintable() else "_" for character in text)
    text = text.encode()[:_LONGEST_BYTES].decode(errors="ignore")
    text = text.lstrip(" ").rstrip(" .")
    if text.startswith((".", "~")) or _RESERVED.match(text):
        text = f"_{text}"
    return text or "_"


def folded(stem: str) -> str:
    """Return a key that is equal for names which differ only in case or Unicode composition."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", stem).casefold())


def free_stem(name: str, taken: Container[str]) -> str:
    """Return a stem that no other file has.

    Args:
        name: The name of the content.
        taken: The stems in use, `folded`.
    """
    stem = file_stem(name)
    result, number = stem, 1
    while folded(result) in taken:
        number += 1
        result = f"{stem} {number}"
    return result
