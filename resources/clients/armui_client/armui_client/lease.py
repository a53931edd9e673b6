"""The lease of the arm, granted by its operator."""

from __future__ import annotations

import contextlib
from types import TracebackType
from typing import TYPE_CHECKING, Final

from armui_client.connection import ANSWER_S
from armui_client.errors import ArmuiError, Invalid, Refused

if TYPE_CHECKING:
    from armui_client.connection import Connection

OPERATOR_S: Final = 35.0
"""The operator is asked for 30 s; then comes a refusal."""


class Lease:
    """The right to move the arm; use it in a ``with``.

    Leaving the ``with`` gives it back, which halts what still moves, with power on. An interrupt
    (Ctrl-C) halts first.

    Attributes:
        number: Of the lease, ``None`` before it is granted.
        max_speed_percent: The speed that the operator has granted.
    """

    def __init__(
        self,
        connection: Connection,
        purpose: str,
        max_speed_percent: int,
        *,
        moves: bool,
        timeout_s: float,
    ) -> None:
        self._connection = connection
        self._purpose = purpose
        self._moves = moves
        self._timeout_s = timeout_s
        self.number: int | None = None
        self.max_speed_percent = max_speed_percent

    @property
    def held(self) -> bool:
        """True while it is held."""
        with self._connection.news:
            return self.number is not None and self.number == self._connection.heard.lease

    def take(self) -> Lease:
        """Ask the operator for the arm, and wait; :meth:`release` gives it back.

        Raises:
            Refused: He has declined, nobody was there for 30 s, or another client has the arm.
            Timeout: No answer came.
        """
        wanted = {
            "purpose": self._purpose,
            "moves": self._moves,
            "max_speed_percent": self.max_speed_percent,
        }
        try:
            granted = self._connection.ask("lease.request", wanted, self._timeout_s)
            self.number, self.max_speed_percent = granted["lease"], granted["max_speed_percent"]
        except (Refused, Invalid):
            raise
        except BaseException:
            # interrupted in the moment of the grant, nobody would have it, and no one else get it
            self._connection.give_back()
            raise
        return self

    def release(self) -> None:
        """Give the arm back; what still moves is halted, with power on."""
        if self.held:
            with contextlib.suppress(ArmuiError):  # it ends meanwhile
                self._connection.ask("lease.release", {}, ANSWER_S, lease=self.number)

    def __enter__(self) -> Lease:
        return self.take()

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            if isinstance(error, KeyboardInterrupt) and self.held:
                with contextlib.suppress(ArmuiError):
                    self._connection.ask("halt", {}, ANSWER_S)
        finally:
            self.release()
