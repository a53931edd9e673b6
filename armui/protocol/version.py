"""What an arm says of itself in the answer to 0x4AF: eleven frames of text, joined (generation 2).

The frames have no number: one that is lost, or another answer in between, shifts the text, so
nothing is looked for by its place alone.
"""

from __future__ import annotations

import re
from typing import Final, NamedTuple

VERSION_ID: Final = 0x4AF

ANSWER_BYTES: Final = 88
"""Eleven frames of 8 bytes."""
ANSWER_S: Final = 0.5
"""A pause this long ends an answer; what comes after it belongs to another one."""
LONGEST: Final = 16
"""More bytes than any version text has; what lies further back cannot be its beginning."""

_TEXT: Final = re.compile(rb"S-V\d{1,3}\.\d{1,3}-\d")
"""One digit of patch: without padding the date follows at once (S-V1.9-0260716)."""
_HARDWARE: Final = re.compile(rb"H-V\d{1,3}\.\d{1,3}-\d")
_DATE: Final = re.compile(rb"[\0 ]*(\d{6})(?!\d)")
_NODE_NUMBER: Final = re.compile(rb"[\0 ]*(\d{1,3})(?!\d)")
_TOKEN: Final = re.compile(rb"[\x21-\x7e]+")
_LETTER: Final = re.compile(rb"[A-Za-z]")

_QUESTION: Final = b"\x01"


class ArmIdentity(NamedTuple):
    """What an arm answered; "" for what could not be read.

    Attributes:
        software: As ``S-V1.8-5``.
        hardware: As ``H-V1.2-1``; the letters stand for the hardware's version, not for PiPER H.
        node_type: As ``ARM_MC``.
        batch: The motors' ratio or batch, two figures.
        date: Of the software, as six figures: year, month, day.
        node_number: As ``15``.
    """

    software: str
    hardware: str = ""
    node_type: str = ""
    batch: str = ""
    date: str = ""
    node_number: str = ""

    def contradicts(self, other: ArmIdentity) -> bool:
        """Tell whether it cannot be the same arm with the same firmware: a text both have differs.

        Node type and batch do not count: a lost frame of an answer shortens them unnoticed.
        """
        ours = self.software, self.hardware, self.date, self.node_number
        theirs = other.software, other.hardware, other.date, other.node_number
        return any(one and two and one != two for one, two in zip(ours, theirs, strict=True))

    @property
    def iso_date(self) -> str:
        """The date as 2025-09-25; as it was told where it is no date, "" where none was."""
        year, month, day = self.date[:2], self.date[2:4], self.date[4:]
        if "01" <= month <= "12" and "01" <= day <= "31":
            return f"20{year}-{month}-{day}"
        return self.date


def is_question(payload: bytes) -> bool:
    """Whether a 0x4AF frame is a host's question: 01, alone or padded with zeros."""
    return payload.rstrip(b"\0") == _QUESTION


def find_version(text: bytes) -> str | None:
    """The version in the joined payloads of an answer, as ``S-V1.8-5``; ``None`` if it is cut."""
    found = _TEXT.search(text)
    return None if found is None else found.group().decode("ascii")


def find_identity(text: bytes) -> ArmIdentity | None:
    """What the joined payloads of answers say; ``None`` while no whole version is among them.

    Of several answers the last whole version counts, with what stands before and behind it.
    """
    wholes = list(_TEXT.finditer(text))
    if not wholes:
        return None
    software = wholes[-1]
    before = text[max(0, software.start() - ANSWER_BYTES) : software.start()]
    hardware = next(reversed(list(_HARDWARE.finditer(before))), None)
    tokens = _TOKEN.findall(before[hardware.end() :] if hardware else before)
    named = [token for token in tokens if _LETTER.search(token)]
    batches = [token for token in tokens if token.isdigit()]
    date = _DATE.match(text, software.end())
    number = _NODE_NUMBER.match(text, date.end()) if date else None
    return ArmIdentity(
        software=_text(software.group()),
        hardware=_text(hardware.group()) if hardware else "",
        node_type=_text(named[-1]) if named and hardware else "",
        batch=_text(batches[0]) if batches and hardware else "",
        date=_text(date.group(1)) if date else "",
        node_number=_text(number.group(1)) if number else "",
    )


def _text(found: bytes) -> str:
    return found.decode("ascii")


class NamedVersion(NamedTuple):
    """A version in an arm's answer.

    Attributes:
        software: As ``S-V1.8-5``.
        date: The six figures behind it; "" if other text is there, or nothing yet.
        began_s: When the frame in which its text begins was heard.
    """

    software: str
    date: str
    began_s: float


class AnswerCollector:
    """Joins the frames of 0x4AF as they come, and reads what they say so far.

    Attributes:
        identity: What is known of the arm by its answers.
        named: The versions in the last answers, each with its time, the oldest first.
    """

    def __init__(self) -> None:
        self._text = bytearray()
        self._times_s: list[float] = []
        self.identity: ArmIdentity | None = None
        self.named: tuple[NamedVersion, ...] = ()

    def take(self, payload: bytes, at_s: float) -> ArmIdentity | None:
        """Take in one frame of an answer; what is known of the arm by then.

        Args:
            payload: Eight bytes; a host's question is none of them.
            at_s: When it was heard.
        """
        if self._times_s and not 0.0 <= at_s - self._times_s[-1] <= ANSWER_S:
            self._text.clear()
            self._times_s.clear()
        self._text += payload
        self._times_s += [at_s] * len(payload)
        whole = len(self._text) % ANSWER_BYTES == 0
        del self._text[: -2 * ANSWER_BYTES], self._times_s[: -2 * ANSWER_BYTES]
        self.named = tuple(
            NamedVersion(
                _text(found.group()),
                _text(date.group(1)) if (date := _DATE.match(self._text, found.end())) else "",
                self._times_s[found.start()],
            )
            for found in _TEXT.finditer(self._text)
        )
        found = find_identity(bytes(self._text))
        if found is not None and not _less(found, self.identity, whole=whole):
            self.identity = found
        return self.identity


def _less(found: ArmIdentity, known: ArmIdentity | None, *, whole: bool) -> bool:
    """Tell whether it says less than what is known of the same version: an answer is under way.

    Other words for the same version count once the answer is whole: a lost frame shifts them.
    """
    if known is None or found.software != known.software:
        return False
    if sum(map(bool, found)) < sum(map(bool, known)):
        return True
    return found.contradicts(known) and not whole
