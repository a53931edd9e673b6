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
        client: Whose it is.
        operation: The id of the operation.
        title: Its title in English.
        arguments: What it is called with.
        since_s: Monotonic time.
        findings: What the check of a run has found, which the operator has to accept.
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
        problem: Why it is not, though it is switched on.
        path: The socket.
        clients: Who is connected.
        asked: Who asks for the arm.
        lease: The lease.
        doing: What its holder does now, the id of an operation, or ``stream.target``; "" for
            nothing.
        consent: What the operator is asked to let a client do.
    """

    on: bool = False
    problem: Refusal | None = None
    path: str = ""
    clients: tuple[Client, ...] = ()
    asked: Ask | None = None
    lease: Lease | None = None
    doing: str = ""
    consent: Consented | None = None
