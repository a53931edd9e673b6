"""A file that has its name only when it is whole."""

from __future__ import annotations

import contextlib
import os
import secrets
from typing import TYPE_CHECKING, BinaryIO

from armui.system.atomic import UNFINISHED, remove_abandoned, sync_folder

if TYPE_CHECKING:
    from pathlib import Path
    from types import TracebackType
    from typing import Self


class WholeFile:
    """Written under another name in the same folder; use it in a ``with`` statement.

    Left by an exception, or without `finish`, nothing remains of it.

    Args:
        path: The name it shall have; its folder must exist.
        replace: Whether a file of this name may be replaced.

    Attributes:
        unfinished: What it is called until then.
        stream: Where its bytes go.

    Raises:
        FileExistsError: There is one, and it may not be replaced.
        OSError: The folder does not allow it.
    """

    def __init__(self, path: Path, *, replace: bool) -> None:
        self._path = path
        self._replace = replace
        if path.is_dir() or (path.exists() and not replace):
            raise FileExistsError(str(path))
        remove_abandoned(path.parent)
        self.unfinished = path.with_name(f".{secrets.token_hex(8)}{UNFINISHED}")
        self.stream: BinaryIO = self.unfinished.open("xb")

    def finish(self) -> None:
        """Everything is written: to the disk with it, and under its name.

        Raises:
            FileExistsError: A file of this name has come meanwhile.
            OSError: The disk does not take it.
        """
        if not self.stream.closed:
            self.stream.flush()
            os.fsync(self.stream.fileno())
            self.stream.close()
        if not self._replace and self._path.exists():
            raise FileExistsError(str(self._path))
        self.unfinished.replace(self._path)
        sync_folder(self._path.parent)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        with contextlib.suppress(OSError):
            self.stream.close()
        with contextlib.suppress(OSError):
            self.unfinished.unlink(missing_ok=True)
