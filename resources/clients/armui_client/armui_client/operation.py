"""An operation that has begun, and its end."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from armui_client.errors import Failed, Refused

if TYPE_CHECKING:
    from armui_client.connection import Connection

MOTION_S: Final = 60.0
"""A motion is waited for so long, by default."""
_GOOD: Final = frozenset({"sent", "answered", "done"})
_BAD: Final = frozenset({"refused", "failed", "cut_off"})
_ALSO_ENDED_S: Final = 0.25


class Operation:
    """An operation that has begun.

    Attributes:
        id: Its id.
        number: Its number in armui's record, ``None`` if there was nothing to do.
        state: "under_way", or how it ended: "sent", "answered" or "done"; "refused", "failed" or
            "cut_off".
        reason: The id of its outcome, "" while there is none.
        text: The same in English.
        figures: The values that it names.
    """

    def __init__(
        self, connection: Connection, id_: str, number: int | None, lease: int | None
    ) -> None:
        self._connection = connection
        self._lease = lease
        self.id = id_
        self.number = number
        self.state = "done" if number is None else "under_way"
        self.reason = ""
        self.text = ""
        self.figures: Mapping[str, Any] = {}

    @property
    def ended(self) -> bool:
        """True once it has ended, well or not."""
        with self._connection.news:
            told = self._connection.heard.operations.get(self.number or 0)
        if told is not None and self.state == "under_way":
            result = told.get("result") or {}
            self.reason, self.text = result.get("id", ""), result.get("text", "")
            self.figures = result.get("figures", {})
            self.state = told["state"]
        return self.state in _GOOD | _BAD

    def wait(self, timeout_s: float | None = MOTION_S) -> Operation:
        """Wait for its end, and return it.

        Args:
            timeout_s: For the end; ``None``: however long it takes.

        Raises:
            Refused: armui has refused it after all, for example after a long check of the way.
            Failed: The arm did not do it, or something else has ended it.
            LeaseLost: The lease has ended.
            Timeout: It still goes on.
            Disconnected: armui is gone.
        """
        connection, lease = self._connection, self._lease
        with connection.news:
            connection.wait_for(
                lambda: self.ended or lease in connection.heard.ended,
                timeout_s,
                f"{self.id} has not ended",
            )
            if self.state in _GOOD:
                return self
            # that the lease has ended, too, may be told right after
            connection.news.wait_for(lambda: lease in connection.heard.ended, _ALSO_ENDED_S)
            lost = connection.why_lost(lease)
        if lost is not None:
            raise lost
        text = self.text or f"{self.id}: {self.state.replace('_', ' ')}"
        if self.state == "refused":
            raise Refused(text, reason=self.reason, figures=self.figures)
        raise Failed(text, state=self.state, reason=self.reason, figures=self.figures)
