"""The firmware of the recorded arm, as its answers to 0x4AF in the log tell it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.version import VERSION_ID, AnswerCollector, is_question
from armui.session.frames import NOT_OF_THE_ARM

if TYPE_CHECKING:
    from armui.session.frames import Channel, FrameBatch

_MIT_IDS = range(0x15A, 0x160)


class FirmwareFinder:
    """Looks for versions in one batch after the other.

    Attributes:
        versions: By the channel they were named on, in the order they were first heard.
        has_mit: Whether MIT frames have passed.
    """

    def __init__(self) -> None:
        self.versions: dict[Channel, FirmwareVersion] = {}
        self.has_mit = False
        self._collectors: dict[Channel, AnswerCollector] = {}

    def feed(self, batch: FrameBatch) -> None:
        """Take in the frames of a batch, in their order."""
        plain = (batch.flags & NOT_OF_THE_ARM) == 0
        self.has_mit |= bool(np.isin(batch.ids[plain], _MIT_IDS).any())
        for row in np.flatnonzero(plain & (batch.ids == VERSION_ID)).tolist():
            payload = batch.data(row)
            if is_question(payload):
                continue
            channel = batch.channel_names[int(batch.channels[row])]
            collector = self._collectors.setdefault(channel, AnswerCollector())
            identity = collector.take(payload, float(batch.times_s[row]))
            version = identity and FirmwareVersion.parse(identity.software)
            if version is not None:
                self.versions[channel] = version

    @property
    def first(self) -> FirmwareVersion | None:
        """The version of the arm that named one first, ``None`` while none has."""
        return next(iter(self.versions.values()), None)
