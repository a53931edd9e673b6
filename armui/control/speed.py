"""Telling the arm another speed without changing anything else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.state import ArmState
from armui.protocol import commands
from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.protocol.codec import Codec


def speed_frames(codec: Codec, state: ArmState, percent: int) -> list[Frame]:
    """0x151 with another speed and the modes the arm is in; nothing if someone else commands it."""
    status = state.status
    if status is None:
        return []
    mode = status.value.control_mode
    if mode not in {ControlMode.STANDBY, ControlMode.CAN_CONTROL}:
        return []
    return commands.set_mode(
        codec,
        control_mode=ControlMode(mode),
        move_mode=_known_move_mode(status.value.move_mode),
        speed_percent=percent,
    )


def _known_move_mode(code: int) -> MoveMode:
    try:
        return MoveMode(code)
    except ValueError:
        return MoveMode.MOVE_J
