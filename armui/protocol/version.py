"""The firmware version in the answer to 0x4AF: eleven frames of text, joined (generation 2)."""

from __future__ import annotations

import re
from typing import Final

VERSION_ID: Final = 0x4AF

LONGEST: Final = 16
"""More bytes than any version text has; what lies further back cannot be its beginning."""

_TEXT: Final = re.compile(rb"S-V\d{1,3}\.\d{1,3}-\d")
"""One digit of patch: without padding the date follows at once (S-V1.9-0260716)."""

_QUESTION: Final = b"\x01"


def is_question(payload: bytes) -> bool:
    """Whether a 0x4AF frame is a host's question: 01, alone or padded with zeros."""
    return payload.rstrip(b"\0") == _QUESTION


def find_version(text: bytes) -> str | None:
    """The version in the joined payloads of an answer, as ``S-V1.8-5``; ``None`` if it is cut."""
    found = _TEXT.search(text)
    return None if found is None else found.group().decode("ascii")
