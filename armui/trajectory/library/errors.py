"""What the library refuses, and why."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import Final

from armui.arm.refusal import Refusal

REFUSALS: Final = frozenset(
    {
        "name_taken",  # name
        "changed_since",  # name
        "deleted_gone",  # name
        "library_damaged",  # name
        "library_not_saved",  # name, text
        "library_not_deleted",  # name, text
        "library_not_restored",  # name, text
        "library_unreadable",  # name, text
    }
)
"""The reasons of a `LibraryError`, beside those against a trajectory itself."""


class LibraryError(Exception):
    """Something the library did not do; everything is as it was.

    Attributes:
        refusal: Why.
        row: The point or sample to blame, from 1; 0 where none is.
    """

    def __init__(self, refusal: Refusal, row: int = 0) -> None:
        super().__init__(refusal, row)
        self.refusal = refusal
        self.row = row

    def __str__(self) -> str:
        return f"row {self.row}: {self.refusal}" if self.row else str(self.refusal)


@contextlib.contextmanager
def on_disk(code: str, name: str) -> Iterator[None]:
    """Says what the disk refused as a `LibraryError`."""
    try:
        yield
    except OSError as error:
        text = error.strerror or str(error)
        raise LibraryError(Refusal(code, {"name": name, "text": text})) from error
