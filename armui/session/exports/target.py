"""A file that has its name only when it is whole."""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import shutil
from typing import TYPE_CHECKING, BinaryIO

from armui.system.atomic import UNFINISHED, remove_abandoned, sync_folder, unfinished_name

if TYPE_CHECKING:
    from pathlib import Path
    from typing import Self


class WholeFile:
    """Written under another name in the same folder; use it in a ``with`` statement.

    Left by an exception, or without `finish`, nothing remains of it.

    Args:
        path: The name it shall have; its folder must exist.
        replace: Whether a file of this name may be replaced.
        unfinished: Its name meanwhile, for whoever may have to remove it after a kill.

    Attributes:
        unfinished: What it is called until then.
        stream: Where its bytes go.

    Raises:
        FileExistsError: There is one, and it may not be replaced.
        OSError: The folder does not allow it.
    """

    def __init__(self, path: Path, *, replace: bool, unfinished: str | None = None) -> None:
        self._path = path
        self._replace = replace
        if path.is_dir() or (path.exists() and not replace):
            raise FileExistsError(str(path))
        remove_abandoned(path.parent)
        self.unfinished = path.with_name(unfinished or unfinished_name())
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

    def __exit__(self, *_error: object) -> None:
        with contextlib.suppress(OSError):
            self.stream.close()
        with contextlib.suppress(OSError):
            self.unfinished.unlink(missing_ok=True)


class WholeFolder:
    """The same for a folder with nothing but files of one ending.

    Args:
        path: The name it shall have; the folder around it must exist.
        ending: Of its files.
        replace: Whether a folder of this name may be replaced, if it holds no other files.

    Attributes:
        unfinished: The folder until then.

    Raises:
        FileExistsError: There is one, and it may not be replaced.
        OSError: There is one with other files in it; or no folder can be made there.
    """

    def __init__(self, path: Path, ending: str, *, replace: bool) -> None:
        self._path = path
        self._ending = ending
        self._replace = replace
        self._check()
        remove_abandoned(path.parent)
        self.unfinished = path.with_name(f".{secrets.token_hex(8)}{UNFINISHED}")
        self.unfinished.mkdir()

    def _check(self) -> None:
        if not os.path.lexists(self._path):
            return
        if not self._replace:
            raise FileExistsError(str(self._path))
        others = [each.name for each in self._path.iterdir() if each.suffix != self._ending]
        if others:
            raise OSError(errno.ENOTEMPTY, f"it holds other files: {others[0]}")

    def finish(self) -> None:
        """Everything is written: give it its name.

        Raises:
            FileExistsError: A folder of this name has come meanwhile.
            OSError: The disk does not allow it.
        """
        self._check()
        sync_folder(self.unfinished)
        if self._path.is_dir():
            before = self._path.with_name(f".{secrets.token_hex(8)}{UNFINISHED}")
            self._path.replace(before)
            try:
                self.unfinished.replace(self._path)
            except OSError:
                before.replace(self._path)
                raise
            shutil.rmtree(before, ignore_errors=True)
        else:
            self.unfinished.replace(self._path)
        sync_folder(self._path.parent)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        shutil.rmtree(self.unfinished, ignore_errors=True)
