"""The text of the guide in sections, each with a name. Pure."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.system import paths
from armui.system.files import read_file

FOLDER: Final = paths.RESOURCES / "guide"

_ANCHOR: Final = re.compile(r'^<a id="([a-z_]+)"></a>$', re.MULTILINE)
_HEADING: Final = re.compile(r"^(#+) (.+)$", re.MULTILINE)
_PICTURE: Final = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")
_NUMBERS: Final = re.compile(r"^<!-- ([MPB0-9 ]+) -->\n+", re.MULTILINE)
"""A comment with numbers of functions: in the manual (M), the protocol (P), this program (B)."""
_MARKUP: Final = re.compile(r"[*`_|#>\[\]()!-]")


@dataclass(frozen=True, slots=True)
class GuideSection:
    """A section of the guide, shown by itself.

    Attributes:
        anchor: Its name, the same in both languages.
        title: Its heading.
        level: 1 for the guide's first page, 2 for a chapter, 3 for a part of one.
        text: Its whole Markdown text with its heading.
        functions: The numbers of the functions it describes, for the tests.
    """

    anchor: str
    title: str
    level: int
    text: str
    functions: tuple[str, ...] = ()

    @property
    def pictures(self) -> tuple[str, ...]:
        """The files of the section's pictures, as named in its text."""
        return tuple(_PICTURE.findall(self.text))


def parse(text: str) -> list[GuideSection]:
    """Split the guide at its anchors; text before the first one is left out.

    Raises:
        ValueError: A section has no heading.
    """
    found = list(_ANCHOR.finditer(text))
    ends = [*(each.start() for each in found[1:]), len(text)]
    sections = []
    for anchor, end in zip(found, ends, strict=True):
        body = text[anchor.end() : end].strip() + "\n"
        heading = _HEADING.search(body)
        if heading is None:
            raise ValueError(f"section {anchor[1]} has no heading")
        numbers = tuple(_NUMBERS.findall(body))
        body = _NUMBERS.sub("", body)
        functions = tuple(" ".join(numbers).split())
        sections.append(
            GuideSection(anchor[1], heading[2].strip(), len(heading[1]), body, functions)
        )
    return sections


def read_guide(language: str) -> list[GuideSection]:
    """Return the sections of the guide in a language; not for the GUI thread.

    Raises:
        OSError: It cannot be read.
        ValueError: Its structure is wrong.
    """
    return parse(read_file(FOLDER / f"{language}.md").decode())


def search(sections: Sequence[GuideSection], query: str) -> list[GuideSection]:
    """Return the sections that contain every word of a query, those with title matches first."""
    words = query.lower().split()
    if not words:
        return list(sections)
    found = [
        section
        for section in sections
        if all(word in _MARKUP.sub("", section.text).lower() for word in words)
    ]
    return sorted(found, key=lambda section: not _in_title(section, words))


def _in_title(section: GuideSection, words: Sequence[str]) -> bool:
    return all(word in section.title.lower() for word in words)
