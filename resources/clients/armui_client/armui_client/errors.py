"""What is raised."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class ArmuiError(Exception):
    """Something was not done.

    Attributes:
        reason: The id of armui's reason, "" if it has none. Ids stay the same over versions.
        figures: The values that the reason names.
    """

    def __init__(
        self, text: str, *, reason: str = "", figures: Mapping[str, Any] | None = None
    ) -> None:
        super().__init__(text)
        self.reason = reason
        self.figures: Mapping[str, Any] = dict(figures or {})


class Refused(ArmuiError):
    """armui or its operator has refused; nothing was done."""


class Failed(ArmuiError):
    """What was begun did not come to its end.

    Attributes:
        state: "failed": the arm did not do it; "cut_off": something else has ended it.
    """

    def __init__(self, text: str, *, state: str, **more: Any) -> None:
        super().__init__(text, **more)
        self.state = state


class LeaseLost(ArmuiError):
    """The lease has ended, and the motion with it; the power stays on."""


class Invalid(ArmuiError, ValueError):
    """The call is unknown, or its arguments are."""


class Stale(ArmuiError):
    """A measured value is older than wanted, or was never heard."""


class Timeout(ArmuiError, TimeoutError):
    """Nothing came in time. A motion that was begun goes on as long as the lease is held."""


class Disconnected(ArmuiError, ConnectionError):
    """armui is not there, or its interface is off; a motion of ours is halted then."""
