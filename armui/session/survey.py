"""Finds the arms in a log, before it is replayed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.addressing import OFFSETS
from armui.protocol.codec import Codec
from armui.protocol.detect import GenerationDetector
from armui.protocol.firmware_version import VERSION_ID, AnswerCollector, is_question
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.session.frames import NOT_OF_THE_ARM
from armui.session.log_model import model_of_log, zeros_of_log
from armui.session.session import HasDataRows

if TYPE_CHECKING:
    from armui.session.frames import Channel, FrameBatch
    from armui.session.session import Session

_STATUS_ID: Final = 0x2A1
_LOOKED_BACK_S: Final = 3.0
_FRAMES: Final = 6_000
"""The frames, two seconds of an arm, that show the generation as well as all of them."""
_ARMS: Final = 16
"""The most channels in which an arm is searched: each costs a pass over the whole log."""
_ANSWER_FRAMES: Final = 2_000
"""The most frames with the version that are examined: an answer has eleven."""
_ARM: Final = range(0x251, 0x2D0)
"""The identifiers of the cyclic feedback under every offset."""


@dataclass(frozen=True, slots=True)
class ChannelSurvey:
    """One channel of a log.

    Attributes:
        channel: As the log names it.
        arm_ids: The number of identifiers of an arm's cyclic feedback.
        generation: The protocol it speaks, as far as can be told.
        reason: The reason, as the end of a sentence that begins "generation N, because".
        is_certain: True if there is evidence; if not, the operator should choose.
        feedback_offset: Added to the identifiers of its feedback (0x470).
        firmware: The version it names anywhere in the log, as ``S-V1.8-5``; "" if none was found.
        model: The model of the family; ``None`` if not known.
        older_zeros: True if its poses show that joints 2 and 3 count from the zeros before
            S-V1.6-3; ``None`` if they do not show it either way.
    """

    channel: Channel
    arm_ids: int
    generation: Generation
    reason: str
    is_certain: bool
    feedback_offset: int
    firmware: str = ""
    model: PiperModel | None = None
    older_zeros: bool | None = None


def survey(session: Session) -> tuple[ChannelSurvey, ...]:
    """Return the facts on each channel, from the log's end and a few seconds of each arm.

    Returns:
        The channels, the one with most of an arm first.
    """
    last = session.snapshot_at(math.inf)
    ordinary = (last.flags & NOT_OF_THE_ARM) == 0
    rows_of: dict[Channel, list[int]] = {}
    arm_rows: dict[Channel, list[int]] = {}
    for channel in session.channels:
        own = last.channels == last.channel_names.index(channel)
        rows = rows_of[channel] = np.flatnonzero(own & ordinary).tolist()
        ids = [(int(last.ids[row]), row) for row in rows]
        arm_rows[channel] = [row for each, row in ids if each in _ARM and _is_feedback(each)]
    most_first = sorted(session.channels, key=lambda each: -len(arm_rows[each]))
    return tuple(
        _channel(session, last, each, rows_of[each], arm_rows[each], in_full=place < _ARMS)
        for place, each in enumerate(most_first)
    )


def _channel(
    session: Session,
    last: FrameBatch,
    channel: Channel,
    rows: list[int],
    known: list[int],
    *,
    in_full: bool,
) -> ChannelSurvey:
    detector = GenerationDetector()
    for row in rows:
        detector.feed(Frame(int(last.ids[row]), last.data(row)), float(last.times_s[row]))
    if in_full:
        newest_s = max((float(last.times_s[row]) for row in known), default=session.start_s)
        _look_at(session, channel, newest_s, detector)
    verdict = detector.verdict()
    offset = _offset(last, rows)
    spoken = channel, verdict.generation, offset
    return ChannelSurvey(
        channel=channel,
        arm_ids=len({int(last.ids[row]) for row in known}),
        generation=verdict.generation,
        reason=verdict.reason,
        is_certain=detector.has_evidence,
        firmware=_firmware(session, channel) if in_full else "",
        feedback_offset=offset,
        model=model_of_log(session, *spoken) if known and in_full else None,
        older_zeros=zeros_of_log(session, *spoken) if known and in_full else None,
    )


def _firmware(session: Session, channel: Channel) -> str:
    if not isinstance(session, HasDataRows):
        return ""
    found = session.data_rows(channel, VERSION_ID)
    if found is None:
        return ""
    collector = AnswerCollector()
    last = slice(-_ANSWER_FRAMES, None)
    rows = zip(found.times_s[last], found.lengths[last], found.payloads[last], strict=True)
    for at_s, length, payload in rows:
        data = bytes(payload[:length])
        if not is_question(data):
            collector.take(data, float(at_s))
    return "" if collector.identity is None else collector.identity.software


def _is_feedback(arbitration_id: int) -> bool:
    codec = Codec(Generation.TWO)
    bases = {arbitration_id, *(arbitration_id - offset for offset in OFFSETS)}
    return any(codec.layout(base) is not None for base in bases)


def _look_at(
    session: Session, channel: Channel, newest_s: float, detector: GenerationDetector
) -> None:
    count = 0
    for batch in session.frames_between(newest_s - _LOOKED_BACK_S, math.inf):
        if channel not in batch.channel_names:
            continue
        own = batch.channels == batch.channel_names.index(channel)
        for row in np.flatnonzero(own & ((batch.flags & NOT_OF_THE_ARM) == 0)).tolist():
            detector.feed(Frame(int(batch.ids[row]), batch.data(row)), float(batch.times_s[row]))
            count += 1
            if detector.certain or count >= _FRAMES:
                return


def _offset(last: FrameBatch, rows: list[int]) -> int:
    """Return the offset under which 0x2A1 came last."""
    found = [
        (float(last.times_s[row]), int(last.ids[row]) - _STATUS_ID)
        for row in rows
        if int(last.ids[row]) - _STATUS_ID in OFFSETS
    ]
    return max(found)[1] if found else 0
