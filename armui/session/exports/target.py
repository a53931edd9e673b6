"""A folder that has its name only when all its files are in it."""

from __future__ import annotations

import errno
import os
import shutil
from typing import TYPE_CHECKING

from armui.system.atomic import sync_folder, unfinished_name

if TYPE_CHECKING:
    from pathlib import Path
    from typing import Self


class WholeFolder:
    """Nothing but files of one ending, written elsewhere until `finish`; for a ``with`` statement.

    Left by an exception, or without `finish`, nothing remains of it.

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
        self.unfinished = unfinished_name(path)
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
            before = unfinished_name(self._path)
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
