"""From a trajectory's name, in any script and with any sign, to one every file system takes."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Container
from typing import Final

_FORBIDDEN: Final = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')
"""By Windows; macOS and Linux forbid only some of them."""
_RESERVED: Final = re.compile(r"(?:con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(?:\.|$)", re.IGNORECASE)
"""Names of devices on Windows, whatever follows the dot."""
_LONGEST_BYTES: Final = 120
"""Of 255 that file systems take: leaves room for a number, an ending and encrypted folders."""


def file_stem(name: str) -> str:
    """Return what a file may be called, close to what the operator called its content.

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
    """Return what two names share that are one to a file system blind to case or composition."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", stem).casefold())


def free_stem(name: str, taken: Container[str]) -> str:
    """A stem no other file has.

    Args:
        name: What the content is called.
        taken: Stems there are, `folded`.
    """
    stem = file_stem(name)
    result, number = stem, 1
    while folded(result) in taken:
        number += 1
        result = f"{stem} {number}"
    return result
