"""Parts of the program that fail: an exception in any function that runs during a motion."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import CodeType, FrameType
from typing import Any, Final

_SPARED: Final = frozenset({"__del__", "__repr__", "__hash__", "__eq__"})


class InjectedError(Exception):
    """Raised in the place of what a function does."""


class Breakage:
    """Has one function fail.

    Which functions run is noted first; one of them is chosen by a share, so that the same seed
    breaks the same one, and then fails at its next calls. The exception comes from the function
    itself, as one that nobody expected would: its traceback ends there.

    Attributes:
        chosen: The function, as ``module:name``; empty before one was chosen.
        left: How often it will still fail.
    """

    def __init__(self, share: float, times: int) -> None:
        self._share = share
        self._seen: dict[CodeType, str] = {}
        self._code: CodeType | None = None
        self.left = times
        self.chosen = ""

    def during(self, act: Callable[[], Any]) -> None:
        """Have something done, and note what runs, or have what was chosen fail."""
        sys.setprofile(self._note if self._code is None else self._fail)
        try:
            act()
        finally:
            sys.setprofile(None)

    def choose(self) -> None:
        """Choose among what has run."""
        found = sorted((code for code in self._seen if _counts(code)), key=self._seen.__getitem__)
        if found:
            self._code = found[int(self._share * len(found))]
            self.chosen = self._seen[self._code]

    def _note(self, frame: FrameType, event: str, _argument: Any) -> None:
        if event == "call":
            module = frame.f_globals.get("__name__", "")
            if module.startswith("armui.") and not module.startswith("armui.sim."):
                code = frame.f_code
                self._seen[code] = f"{module}:{code.co_qualname}:{code.co_firstlineno}"

    def _fail(self, frame: FrameType, event: str, _argument: Any) -> None:
        if event == "call" and frame.f_code is self._code and self.left > 0:
            self.left -= 1
            raise InjectedError(self.chosen)


def _counts(code: CodeType) -> bool:
    return code.co_name not in _SPARED and not code.co_name.startswith("<")
