"""A log that is indexed in the test's own process."""

from __future__ import annotations

import shutil
import tempfile
from functools import partial
from pathlib import Path

from armui.session.foreign.indexed import MOST_FRAMES, IndexedLog
from armui.session.foreign.indexing import index_log


def open_indexed(path: Path, most_frames: int = MOST_FRAMES) -> IndexedLog:
    folder = Path(tempfile.mkdtemp(prefix="columns-", dir=path.parent))
    index = index_log(path, folder, most_frames)
    return IndexedLog(index, folder, partial(shutil.rmtree, folder, ignore_errors=True))
