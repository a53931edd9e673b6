"""The data that the window shows of the local interface, with the questions of clients."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.refusal import Refusal
from armui.interface.lease import Ask, Client, Lease

if TYPE_CHECKING:
    from armui.trajectory.planning.findings import Finding


@dataclass(frozen=True, slots=True)
class Consented:
    """A call that waits for the operator's held press.

    Attributes:
        client: The client that calls.
        operation: The id of the operation.
        title: Its title in English.
        arguments: The arguments by name.
        since_s: The monotonic time of the call.
        findings: The findings of the check of a run, which the operator must accept.
    """

    client: Client
    operation: str
    title: str
    arguments: Mapping[str, object]
    since_s: float
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True, slots=True)
class InterfaceView:
    """What the window shows of the interface.

    Attributes:
        on: True while it is served.
        problem: The reason why it is not served although it is switched on.
        path: The socket.
        clients: The connected clients.
        asked: The request for the arm that waits for the operator.
        lease: The lease in force.
        doing: The id of the operation that its client carries out now, or ``stream.target``; "" for
            none.
        consent: The call for which the operator's consent is asked.
    """

    on: bool = False
    problem: Refusal | None = None
    path: str = ""
    clients: tuple[Client, ...] = ()
    asked: Ask | None = None
    lease: Lease | None = None
    doing: str = ""
    consent: Consented | None = None
