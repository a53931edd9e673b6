"""Why a recording cannot be written, as data for people: pure."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.system.error_text import error_text

_CODES: Final = {
    errno.ENOSPC: RefusalCode.SESSION_DISK_FULL,
    errno.EDQUOT: RefusalCode.SESSION_DISK_FULL,
    errno.EFBIG: RefusalCode.SESSION_DISK_FULL,
    errno.EACCES: RefusalCode.SESSION_READ_ONLY,
    errno.EPERM: RefusalCode.SESSION_READ_ONLY,
    errno.EROFS: RefusalCode.SESSION_READ_ONLY,
    errno.ENOENT: RefusalCode.SESSION_FOLDER_GONE,
    errno.ENODEV: RefusalCode.SESSION_FOLDER_GONE,
    errno.ENXIO: RefusalCode.SESSION_FOLDER_GONE,
    errno.EIO: RefusalCode.SESSION_FOLDER_GONE,
    errno.ESTALE: RefusalCode.SESSION_FOLDER_GONE,
}


def why_not_written(error: BaseException, folder: Path) -> Refusal:
    """What is wrong with a folder, from what writing into it raised."""
    code = error.errno if isinstance(error, OSError) else None
    known = _CODES.get(code or 0)
    if known is not None:
        return Refusal(known, {"folder": str(folder)})
    return Refusal(RefusalCode.SESSION_FAILED, {"folder": str(folder), "text": error_text(error)})
