"""Where the columns of a log lie while it is shown; what killed programs left is removed."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import tempfile
import time
from pathlib import Path
from typing import Final

_PREFIX: Final = "armui-replay-"
_NAME: Final = re.compile(r"armui-replay-(?:(\d{1,10})-)?[a-z0-9_]+")
_OLD_S: Final = 600.0
"""What is younger may belong to a program that has just begun."""
_FORGOTTEN_S: Final = 7 * 86_400.0
"""A process number may be another's by now: nobody looks at one log for a week."""


def make_folder() -> Path:
    """A new folder whose name tells which process it belongs to.

    Raises:
        OSError: There is no room, or no right to make it.
    """
    return Path(tempfile.mkdtemp(prefix=f"{_PREFIX}{os.getpid()}-"))


def remove_leftovers() -> int:
    """Remove the folders of programs that live no more; how many.

    Only folders of this user, with the name that `make_folder` gives, are touched. Waits for a
    disk.
    """
    removed = 0
    with contextlib.suppress(OSError):
        for folder in Path(tempfile.gettempdir()).glob(f"{_PREFIX}*"):
            with contextlib.suppress(OSError):
                if _is_left(folder):
                    shutil.rmtree(folder)
                    removed += 1
    return removed


def _is_left(folder: Path) -> bool:
    named = _NAME.fullmatch(folder.name)
    if named is None or folder.is_symlink() or not folder.is_dir():
        return False
    about = folder.stat()
    if hasattr(os, "getuid") and about.st_uid != os.getuid():
        return False
    age_s = time.time() - about.st_mtime
    if named[1] is None or age_s > _FORGOTTEN_S:
        return age_s > _FORGOTTEN_S
    return age_s > _OLD_S and not _is_living(int(named[1]))


def _is_living(process: int) -> bool:
    """Whether there is a process of this number; where nobody can tell, there is."""
    if os.name != "posix":  # there, asking would end it; files in use cannot be removed
        return False
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    return True
