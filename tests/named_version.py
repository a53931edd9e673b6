"""Lets a connected arm have named another firmware than the simulated one has."""

from __future__ import annotations

from armui.control.arm_controller import ArmController
from armui.protocol.version import ArmIdentity


def name_version(controller: ArmController, version: str | None) -> None:
    """From now on the arm has named this version, or none; what it does stays the same."""
    connection = controller._connection
    tracker = connection._worker._intake._tracker
    tracker._answer.identity = None if version is None else ArmIdentity(version)
    tracker._sequence += 1
    connection.handshake.firmware = version
