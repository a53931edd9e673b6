"""Lets a connected arm have named another firmware than the simulated one has."""

from __future__ import annotations

from dataclasses import replace

from armui.control.arm_controller import ArmController
from armui.protocol.firmware_version import ArmIdentity
from armui.sim.firmware import Firmware


def name_version(
    controller: ArmController, version: str | None, firmware: Firmware | None = None
) -> None:
    """From now on the arm has named this version, or none; what it does stays the same.

    Args:
        controller: Which hears the arm.
        version: As ``S-V1.8-9``.
        firmware: The arm, where it is to name the version when it is asked again, too.
    """
    if firmware is not None and version is not None:
        firmware.type = replace(firmware.type, version=version)
    connection = controller._connection
    tracker = connection._worker._processor._tracker
    tracker._answer.identity = None if version is None else ArmIdentity(version)
    tracker._sequence += 1
    connection.handshake.firmware = version
    connection.handshake.identity = tracker._answer.identity
