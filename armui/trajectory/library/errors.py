"""What the library refuses, and why."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.system.files import error_text


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
def on_disk(code: RefusalCode, name: str) -> Iterator[None]:
    """Says what the disk refused as a `LibraryError`."""
    try:
        yield
    except OSError as error:
        refusal = Refusal(code, {"name": name, "text": error_text(error)})
        raise LibraryError(refusal) from error
