"""Sentences and figures of the windows of 轨迹库."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.trajectory.files.errors import TrajectoryFileError
from armui.ui import format as fmt
from armui.ui import words

_HOUR_S: Final = 3600
_MINUTE_S: Final = 60


def file_error(error: TrajectoryFileError) -> str:
    """What is wrong with a file or a text, with its place: file, line, column."""
    places = [error.file] if error.file else []
    for source, number in (
        (QT_TRANSLATE_NOOP("FileError", "line {number}"), error.line),
        (QT_TRANSLATE_NOOP("FileError", "column {number}"), error.column),
    ):
        if number:
            text = QCoreApplication.translate("FileError", str(source))
            places.append(text.format(number=number))
    reason = words.refusal(error.reason)
    return f"{', '.join(places)}: {reason}" if places else reason


def duration(seconds: float | None) -> str:
    """A length of time as ``7.5 s``, ``12:30`` or ``1:05:00``."""
    if seconds is None:
        return fmt.NOTHING
    if seconds < _MINUTE_S:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    hours, rest = divmod(whole, _HOUR_S)
    minutes, left = divmod(rest, _MINUTE_S)
    return f"{hours}:{minutes:02}:{left:02}" if hours else f"{minutes}:{left:02}"
