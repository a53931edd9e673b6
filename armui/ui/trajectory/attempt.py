"""Something done with the library, and in words why it was not."""

from __future__ import annotations

from collections.abc import Callable

from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library import LibraryError
from armui.ui import words


def attempt(action: Callable[[], object]) -> str:
    """Do it; why it was refused, in the operator's language, or "" if it was done."""
    try:
        action()
    except LibraryError as error:
        return words.refusal(error.refusal)
    except TrajectoryFileError as error:
        return words.file_error(error)
    return ""
