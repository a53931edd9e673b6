"""What the files of a recording are called: pure.

A recording NAME has ``NAME.blf``, ``NAME.002.blf`` and so on, its sidecar ``NAME.armui.jsonl`` and
its index ``NAME.armui.idx``.
"""

from __future__ import annotations

import re
from datetime import datetime
from pathlib import Path
from typing import Final

_PART: Final = re.compile(r"(?P<name>.+)\.(?P<number>\d{3,})$")
_FORBIDDEN: Final = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')
LONGEST_NAME: Final = 120


def file_name(name: str, number: int, suffix: str) -> str:
    """What the file with a number, from 1, is called."""
    return f"{name}{suffix}" if number == 1 else f"{name}.{number:03}{suffix}"


def names_of(path: Path) -> tuple[str, ...]:
    """What the recording may be called that a file belongs to, the likeliest first."""
    stem = path.stem
    found = _PART.fullmatch(stem)
    return (stem,) if found is None else (found["name"], stem)


def name_for(at: datetime) -> str:
    """A name for what is recorded from a moment on."""
    return f"session-{at:%Y%m%d-%H%M%S}"


def is_name(text: str) -> bool:
    """Whether a recording can be called so, on every system."""
    return (
        0 < len(text) <= LONGEST_NAME
        and text == text.strip()
        and not text.startswith(".")
        and not text.endswith(".")
        and _FORBIDDEN.search(text) is None
        and _PART.fullmatch(text) is None
    )
