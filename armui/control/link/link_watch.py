"""Tells the operator when the arm comes and goes, and what it answered when it came."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.control.events import EventCode
from armui.control.operating_state import LinkState
from armui.control.requests import reports

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.link.connection import Connection
    from armui.control.operations.started import Tell


class LinkWatch:
    """Reports events of the connection; it is told when another begins.

    Args:
        connection: The way to the arm.
        tell: Takes the notices.
    """

    def __init__(self, connection: Connection, tell: Tell) -> None:
        self._connection = connection
        self._tell = tell
        self._was_online = False
        self._answers_told = False

    def follow_online(self) -> None:
        """Tell whether the arm has come or gone."""
        link = self._connection.link
        online = link is LinkState.ONLINE
        if online is self._was_online:
            return
        self._was_online = online
        if online:
            self._answers_told = False
        if link in {LinkState.ONLINE, LinkState.OFFLINE}:
            self._tell(EventCode.ONLINE if online else EventCode.OFFLINE)

    def follow_handshake(self, state: ArmState) -> None:
        """Tell what the arm has answered, once it has answered everything."""
        handshake = self._connection.handshake
        if handshake is None or not handshake.done or self._answers_told:
            return
        self._answers_told = True
        for code, figures in reports.on_handshake(state, handshake.generation):
            self._tell(code, **figures)

    def arm_came(self) -> None:
        """The arm that answers may be another one: it is asked anew."""
        self._answers_told = False

    def reset(self) -> None:
        """Another connection begins."""
        self._was_online = False
