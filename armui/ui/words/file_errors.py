"""What is wrong with a file, as the operator reads it: file, line, column: reason."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.ui.words.refusals import refusal
from armui.ui.words.text import sentence

if TYPE_CHECKING:  # at run time it would bring numpy into the program's start
    from armui.trajectory.files import TrajectoryFileError

_PLACE = QT_TRANSLATE_NOOP("FilePlace", "{file}, line {line}, column {column}: {reason}")
_LINE = QT_TRANSLATE_NOOP("FilePlace", "{file}, line {line}: {reason}")
_FILE = QT_TRANSLATE_NOOP("FilePlace", "{file}: {reason}")
_PLACE_ONLY = QT_TRANSLATE_NOOP("FilePlace", "Line {line}, column {column}: {reason}")
_LINE_ONLY = QT_TRANSLATE_NOOP("FilePlace", "Line {line}: {reason}")


def file_error(error: TrajectoryFileError) -> str:
    """What is wrong with a file, in the operator's language.

    Args:
        error: What was found; a text without a file, as of the clipboard, has none to name.
    """
    reason = refusal(error.reason)
    if error.line:
        named, bare = (_PLACE, _PLACE_ONLY) if error.column else (_LINE, _LINE_ONLY)
        source = named if error.file else bare
    elif error.file:
        source = _FILE
    else:
        return reason
    figures = {"file": error.file, "line": error.line, "column": error.column, "reason": reason}
    return sentence("FilePlace", source, figures)
