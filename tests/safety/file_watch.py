"""Notes every file the GUI thread touches: an audit hook, and the questions that have none."""

from __future__ import annotations

import os
import sys
import threading
import traceback
from contextlib import contextmanager

EVENTS = frozenset(
    {
        *("open", "os.listdir", "os.scandir", "os.rename", "os.remove", "os.mkdir", "os.rmdir"),
        *("os.link", "os.symlink", "os.truncate", "os.utime", "os.chmod", "os.chown"),
        *("shutil.copyfile", "shutil.move", "shutil.rmtree", "tempfile.mkdtemp"),
        *("tempfile.mkstemp", "subprocess.Popen", "os.posix_spawn", "os.fork", "mmap.__new__"),
    }
)
ASKED = ("stat", "lstat", "access", "fsync")
"""Functions of `os` that wait for a disk and that no audit event tells of."""


class _Watch:
    """What the hook, which can never be taken away again, writes to."""

    def __init__(self):
        self.thread = None
        self.seen = []
        self.installed = False

    def note(self, event, subject):
        if threading.get_ident() != self.thread:
            return
        self.thread = None  # what notes it may touch files itself
        frames = [
            f"{frame.filename}:{frame.lineno} {frame.name}"
            for frame in traceback.extract_stack()[:-2]
            if "armui" in frame.filename and "/tests/" not in frame.filename
        ]
        # a module that is imported is none of the program's files
        if not any("importlib" in frame.filename for frame in traceback.extract_stack()):
            self.seen.append((event, str(subject), frames))
        self.thread = threading.get_ident()


_WATCH = _Watch()


def _hook(event, args):
    if _WATCH.thread is not None and event in EVENTS:
        _WATCH.note(event, args[0] if args else "")


@contextmanager
def watched(monkeypatch):
    """Note what this thread does to files from now on; the list is the context's value."""
    if not _WATCH.installed:
        sys.addaudithook(_hook)
        _WATCH.installed = True
    for name in ASKED:
        monkeypatch.setattr(os, name, _noting(name, getattr(os, name)))
    _WATCH.seen = []
    _WATCH.thread = threading.get_ident()
    try:
        yield _WATCH.seen
    finally:
        _WATCH.thread = None


def _noting(name, function):
    def noted(*args, **kwargs):
        if _WATCH.thread is not None:
            _WATCH.note(f"os.{name}", args[0] if args else "")
        return function(*args, **kwargs)

    return noted
