"""The schema of the local interface, an OpenRPC document made from the operations' registry."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from armui import __version__
from armui.interface.messages import PROTOCOL, Json
from armui.interface.plain_forms import schema

if TYPE_CHECKING:
    from armui.control.operations.operation import BoundOperation

METHODS: Final[Mapping[str, str]] = {
    "hello": "Say who you are; the first call. Tells the arm, its limits and the rates.",
    "ping": "Nothing; any call keeps the lease, which ends after a second of silence.",
    "state.get": "The measured state, each value with its age.",
    "state.subscribe": "The same as notifications, at a rate up to 200 Hz.",
    "state.unsubscribe": "No more of them.",
    "events.subscribe": "The events of the program, as they come.",
    "events.unsubscribe": "No more of them.",
    "operations.list": "The operations, each with what speaks against it now.",
    "lease.request": "Ask the operator for the arm; answers once he has decided.",
    "lease.release": "Give the arm back; its motion ends.",
    "kinematics.fk": "The pose of the flange at six angles.",
    "kinematics.ik": "The angles of a pose, nearest to others first.",
    "stop": "The emergency stop. Needs no lease.",
    "halt": "End any motion with power on. Needs no lease.",
    "stream.target": "The newest target of a stream: six angles, at 10 to 100 Hz.",
    "stream.end": "End the stream.",
}
"""The methods beside the operations, with what each does."""


def openrpc(operations: Mapping[str, BoundOperation]) -> Json:
    """Return the interface as an OpenRPC document, made from the registry of operations."""
    return {
        "openrpc": "1.3.2",
        "info": {"title": "armui", "version": f"{__version__} (protocol {PROTOCOL})"},
        "methods": [
            *({"name": name, "summary": text, "params": []} for name, text in METHODS.items()),
            *schema(operations),
        ],
    }
