"""Which frames set a joint or the gripper in motion, or let them go on (safety S7)."""

from __future__ import annotations

from typing import Final

from armui.protocol.addressing import OFFSETS
from armui.protocol.codes import CpvAction, TeachingState, TrajectoryCommand
from armui.protocol.frame import Frame

_MOTION_COMMAND: Final = 0x150
_TARGETS: Final = range(0x151, 0x160)
_CPV: Final = range(0x181, 0x188)
_NO_MOTION: Final = frozenset(
    {
        0,
        TrajectoryCommand.PAUSE,
        TrajectoryCommand.CLEAR_CURRENT,
        TrajectoryCommand.CLEAR_ALL,
        TrajectoryCommand.ABORT,
        TrajectoryCommand.GET_CURRENT,
    }
)
_STARTS_TEACHING: Final = frozenset(
    {TeachingState.RUN_RECORDING, TeachingState.CONTINUE, TeachingState.MOVE_TO_START}
)


def command_id(arbitration_id: int) -> int | None:
    """Return the identifier 0x150–0x15F without its offset (0x470); ``None`` for any other."""
    for offset in OFFSETS:
        if 0x150 <= arbitration_id - offset <= 0x15F:
            return arbitration_id - offset
    return None


def is_motion_frame(frame: Frame) -> bool:
    """Return whether a frame starts, changes or continues a motion.

    These are the mode word and the targets (0x151–0x15F), the motor commands 0x181–0x187 but for
    questions, and of 0x150 what starts or continues: stop, pause and every end are none.
    """
    base = command_id(frame.arbitration_id)
    if base == _MOTION_COMMAND:
        data = frame.data.ljust(3, b"\0")
        return not data[0] and (data[1] not in _NO_MOTION or data[2] in _STARTS_TEACHING)
    if base is not None:
        return base in _TARGETS
    return frame.arbitration_id in _CPV and frame.data[:1] != bytes([CpvAction.READ])
