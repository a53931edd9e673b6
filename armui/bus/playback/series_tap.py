"""Between a replay and the series of its curves: frame by frame, or many frames at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from armui.arm.other_hosts import MOTION_IDS, OTHER_COMMAND_IDS
from armui.protocol.frame import FrameFlag
from armui.telemetry.tap import Tap

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.protocol.codec import Codec
    from armui.protocol.generation import Generation
    from armui.telemetry.columns import FrameColumns
    from armui.telemetry.store import Telemetry
    from armui.telemetry.tap import Taken

COMMAND_IDS = frozenset(MOTION_IDS | OTHER_COMMAND_IDS)
"""What an arm is told. Such a frame that the recording program has sent was its own command."""

_COMMAND_IDS = np.array(sorted(COMMAND_IDS), np.uint32)


def is_own_command(arbitration_id: int, flags: int) -> bool:
    """Whether the program that recorded a frame has sent it to the arm."""
    return arbitration_id in COMMAND_IDS and bool(flags & FrameFlag.TRANSMITTED)


class SeriesTap(Tap):
    """Stands for the telemetry among the taps of a replay.

    Args:
        telemetry: The series of the replay, its alone.

    Attributes:
        by_columns: The frames of now come by :meth:`take`; those told one by one are no more than
            some of them.
    """

    def __init__(self, telemetry: Telemetry) -> None:
        self.telemetry = telemetry
        self.by_columns = False

    def take(self, frames: FrameColumns) -> None:
        """Take in many frames at once."""
        own = ((frames.flags & FrameFlag.TRANSMITTED) != 0) & np.isin(frames.ids, _COMMAND_IDS)
        self.telemetry.on_columns(frames, own=own)

    def know_generation(self, generation: Generation | None) -> None:
        """See `armui.bus.tap.Tap`."""
        self.telemetry.know_generation(generation)

    def on_open(self, bitrate: int | None) -> None:
        """See `armui.bus.tap.Tap`."""
        self.telemetry.on_open(bitrate)

    def on_codec(self, codec: Codec) -> None:
        """See `armui.bus.tap.Tap`."""
        self.telemetry.on_codec(codec)

    def on_heard(self, batch: Sequence[Taken]) -> None:
        """See `armui.bus.tap.Tap`."""
        if not self.by_columns:
            self.telemetry.on_heard(batch)

    def on_sent(self, batch: Sequence[Taken]) -> None:
        """See `armui.bus.tap.Tap`."""
        if not self.by_columns:
            self.telemetry.on_sent(batch)

    def on_error_frame(self) -> None:
        """See `armui.bus.tap.Tap`."""
        if not self.by_columns:
            self.telemetry.on_error_frame()

    def on_look(self, now_s: float) -> None:
        """See `armui.bus.tap.Tap`."""
        if not self.by_columns:
            self.telemetry.on_look(now_s)
