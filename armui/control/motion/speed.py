"""Telling the arm another speed without changing anything else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.protocol import commands
from armui.protocol.codes import ControlMode, MoveMode

if TYPE_CHECKING:
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame


def speed_frames(codec: Codec, mode: tuple[ControlMode, MoveMode], percent: int) -> list[Frame]:
    """0x151 with another speed and the modes the arm is in.

    Args:
        codec: The arm's codec.
        mode: What the arm is in; see :meth:`armui.control.authority.Authority.mode_in_force`.
        percent: 0–100.
    """
    control_mode, move_mode = mode
    return commands.set_mode(
        codec, control_mode=control_mode, move_mode=move_mode, speed_percent=percent
    )
