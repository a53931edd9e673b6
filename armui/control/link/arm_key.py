"""The key by which an arm is remembered in the settings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.protocol.generation import Generation

if TYPE_CHECKING:
    from armui.arm.device import Device
    from armui.protocol.firmware_version import ArmIdentity

NO_NUMBER: Final = "?"
"""Stands for the node number of an arm of generation 2 that reports none."""


def arm_key(
    device: Device | None, generation: Generation | None, identity: ArmIdentity | None
) -> str | None:
    """Return the key under which an arm is remembered; ``None`` before it has named itself.

    Args:
        device: The open device, if any.
        generation: The protocol the arm speaks; arms of generation 1 are known by their adapter.
        identity: What the arm has reported of itself.
    """
    first = generation is Generation.ONE
    if device is None or (identity is None and not first):
        return None
    node = "" if identity is None else identity.node_number
    return device.arm_key(node or ("" if first else NO_NUMBER))
