"""The reasons and notices of the local interface, for the operator and its clients."""

from __future__ import annotations

from armui.arm.refusal import Reason
from armui.control.events import Notice
from armui.telemetry.events import Asker, EventKind, Level

INTERFACE_NOT_HERE = Reason(
    "interface_not_here", "The local interface is offered on Linux only, for now."
)
INTERFACE_TAKEN = Reason(
    "interface_taken",
    "Another armui of yours serves {path} already. Switch its interface off, or close it.",
)
INTERFACE_NOT_OPENED = Reason(
    "interface_not_opened", "The local interface cannot be opened at {path}: {text}."
)
CONSENT_NOT_GIVEN = Reason(
    "consent_not_given", "The operator did not hold the button within {seconds} s."
)
RUN_CALLED_OFF = Reason("run_called_off", "The client has called the run off.")
CONSENT_BUSY = Reason(
    "consent_busy", "The operator is being asked about something else of yours. Wait for that."
)
LEASE_ASKED = Notice(
    "lease_asked",
    "“{client}” asks for the arm: {purpose}",
    kind=EventKind.COMMAND,
    asker=Asker.CLIENT,
)
LEASE_GRANTED = Notice(
    "lease_granted",
    "The operator has granted “{client}” the arm, at most at {percent} %.",
    Level.WARNING,
    EventKind.COMMAND,
)
LEASE_ENDED = Notice(
    "lease_ended",
    "“{client}” no longer moves the arm. {reason}",
    Level.WARNING,
    EventKind.COMMAND,
    Asker.CLIENT,
)
LEASE_REFUSED = Notice(
    "lease_refused",
    "“{client}” was not granted the arm. {reason}",
    kind=EventKind.COMMAND,
    asker=Asker.CLIENT,
)
CLIENT_ASKS = Notice(
    "client_asks", "“{client}” asks: {operation}", kind=EventKind.COMMAND, asker=Asker.CLIENT
)
CONSENT_GRANTED = Notice(
    "consent_granted", "The operator has let “{client}” do it: {operation}", kind=EventKind.COMMAND
)
