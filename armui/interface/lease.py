"""The lease of the arm: the request, its client, and the reasons that end it (S29): pure.

One client at a time asks or holds. Each lease has a new number, which every command names: a
command that was queued under an ended lease is dropped.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import count
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import Status
from armui.protocol.codes import ArmStatusCode

LEASE_TAKEN = Reason(
    "lease_taken",
    "“{client}” asks for the arm, or holds it. Wait until it is free, or have the operator take it "
    "back.",
)
LEASE_NOT_HELD = Reason(
    "lease_not_held",
    "This needs the lease of the arm. Ask for it with lease.request, and name its number.",
)
LEASE_NOT_GRANTED = Reason(
    "lease_not_granted",
    "The operator did not grant the arm within {seconds} s. Ask again when somebody is there.",
)
LEASE_DECLINED = Reason("lease_declined", "The operator has declined.")
LEASE_RELEASED = Reason("lease_released", "The client has released the arm.")
LEASE_TAKEN_BACK = Reason("lease_taken_back", "The operator has taken the arm back.")
LEASE_OPERATOR_MOVED = Reason(
    "lease_operator_moved", "The operator has moved the arm himself ({operation})."
)
LEASE_STOPPED = Reason("lease_stopped", "The arm was stopped or halted.")
LEASE_SILENT = Reason(
    "lease_silent", "Nothing was heard from the client for {seconds} s. It must say so more often."
)
LEASE_CLIENT_GONE = Reason("lease_client_gone", "The client has closed its connection.")
LEASE_ARM_CHANGED = Reason(
    "lease_arm_changed", "The arm is not heard, or another arm or connection has come."
)
LEASE_OTHER_HOST = Reason("lease_other_host", "Somebody else moves the arm.")
LEASE_FAULT = Reason("lease_fault", "The arm reports a fault.")
LEASE_PROGRAM_ENDS = Reason("lease_program_ends", "The interface or the program ends.")
LEASE_MOVES_NOTHING = Reason(
    "lease_moves_nothing", "This lease was asked for without motions. Ask for one with “moves”."
)
LEASE_TOO_FAST = Reason(
    "lease_too_fast", "{value} % is more than the {maximum} % that the operator allows now."
)

GRANT_WITHIN_S: Final = 30.0
"""A question that the operator has not answered by this time counts as refused."""
SILENT_S: Final = 1.0
"""A client that has said nothing for this time loses the lease."""
_FAULTS: Final = frozenset(
    {
        ArmStatusCode.JOINT_COMMUNICATION_FAULT,
        ArmStatusCode.JOINT_BRAKE_CLOSED,
        ArmStatusCode.COLLISION,
        ArmStatusCode.OVERSPEED_WHILE_TEACHING,
        ArmStatusCode.JOINT_STATUS_ABNORMAL,
        ArmStatusCode.OTHER_FAULT,
        ArmStatusCode.MAIN_CONTROLLER_TOO_HOT,
        ArmStatusCode.BRAKE_RESISTOR_TOO_HOT,
    }
)
_NUMBERS: Final = count(1)


@dataclass(frozen=True, slots=True)
class Client:
    """A program at the other end of the socket.

    Attributes:
        number: Its connection's number.
        name: As it calls itself.
        process: The number of its process, from the socket.
        program: The name of that process, from the system.
    """

    number: int
    name: str
    process: int
    program: str = ""

    def __str__(self) -> str:
        return f"{self.name} ({self.program or 'process'} {self.process})"


@dataclass(frozen=True, slots=True)
class Ask:
    """A client's request for the arm.

    Attributes:
        client: The client.
        purpose: The purpose in the client's words.
        moves: True if it wants to move the arm, and not only to set something.
        max_speed_percent: The highest speed it asks for.
        since_s: The monotonic time of the request.
    """

    client: Client
    purpose: str
    moves: bool
    max_speed_percent: int
    since_s: float


@dataclass(frozen=True, slots=True)
class Lease:
    """A lease that the operator has granted.

    Attributes:
        ask: The request.
        max_speed_percent: The highest speed that the operator has granted.
        since_s: The monotonic time of the grant.
        number: The number by which each command of the client names the lease.
    """

    ask: Ask
    max_speed_percent: int
    since_s: float
    number: int = field(default_factory=_NUMBERS.__next__)


class Lessor:
    """Gives the arm to one client at a time.

    Attributes:
        asked: The request that waits for the operator, or ``None``.
        held: The lease, or ``None``.
    """

    def __init__(self) -> None:
        self.asked: Ask | None = None
        self.held: Lease | None = None
        self._heard_s = 0.0
        self._for_session: dict[int, tuple[bool, int]] = {}

    def ask(self, ask: Ask) -> Refusal | None:
        """Accept a client's request; return why not, or ``None``: it waits or is granted."""
        other = self.asked or (None if self.held is None else self.held.ask)
        if other is not None:
            return LEASE_TAKEN(client=str(other.client))
        self.asked = ask
        moves, percent = self._for_session.get(ask.client.number, (False, 0))
        if ask.max_speed_percent <= percent and moves >= ask.moves:
            self.grant(ask.max_speed_percent, ask.since_s, for_session=True)
        return None

    def grant(self, max_speed_percent: int, now_s: float, *, for_session: bool) -> Lease | None:
        """Grant the present request, with a limit of the speed.

        Args:
            max_speed_percent: The operator's limit.
            now_s: Monotonic time.
            for_session: True to grant later requests of this client, too, up to this speed, and
                motions only if this request includes them.
        """
        ask, self.asked = self.asked, None
        if ask is None:
            return None
        percent = min(max_speed_percent, ask.max_speed_percent)
        if for_session:
            self._for_session[ask.client.number] = ask.moves, percent
        self._heard_s = now_s
        self.held = Lease(ask, percent, now_s)
        return self.held

    def decline(self) -> Ask | None:
        """Drop the present request, and return it."""
        ask, self.asked = self.asked, None
        return ask

    def note_activity(self, client: Client, now_s: float) -> None:
        """Note when data last came from the client that holds the lease; others are ignored."""
        if self.held is not None and self.held.ask.client.number == client.number:
            self._heard_s = max(self._heard_s, now_s)

    def end(self) -> Lease | None:
        """End the lease, and return it."""
        lease, self.held = self.held, None
        return lease

    def take_back(self, client: Client) -> None:
        """Forget a grant for a client's whole session."""
        self._for_session.pop(client.number, None)

    def why_over(self, now_s: float) -> Refusal | None:
        """Return why the lease or the request has ended by a time limit, or ``None``."""
        if self.asked is not None and now_s - self.asked.since_s > GRANT_WITHIN_S:
            return LEASE_NOT_GRANTED(seconds=round(GRANT_WITHIN_S))
        if self.held is not None and now_s - self._heard_s > SILENT_S:
            return LEASE_SILENT(seconds=SILENT_S)
        return None

    def lease_of(self, client: Client, number: object) -> Lease | Refusal:
        """Return the lease that a command names, if it is held by its client."""
        held = self.held
        if held is None or held.number != number or held.ask.client.number != client.number:
            return LEASE_NOT_HELD()
        return held


def fault_of(status: Status | None) -> int | None:
    """Return the code of a fault that the arm reports, which ends a lease, or ``None``."""
    code = None if status is None else status.arm_status
    return code if code in _FAULTS else None
