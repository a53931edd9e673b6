"""Finds the model of the arm in a log, by its sidecar or by the poses in it, and its cell."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, TypeVar

import numpy as np

from armui.arm.model_check import FittingArm, fitting_arms
from armui.cell.cell_in_force import CellInForce, all_through, from_entry
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec, Message
from armui.protocol.detect import GenerationDetector
from armui.protocol.frame import Frame
from armui.protocol.generation import PiperModel
from armui.session.frames import NOT_OF_THE_ARM

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping
    from typing import Any

    from armui.protocol.detect import GenerationVerdict
    from armui.protocol.generation import Generation
    from armui.session.frames import Channel, FrameBatch
    from armui.session.session import Session

_PLACES: Final = (1.0, 0.0, 0.5, 0.25, 0.75)
"""The parts of the log that are examined: its ends first, where an arm often stands still."""
END_POSE: Final = (
    ("EndPose1", "X"), ("EndPose1", "Y"), ("EndPose2", "Z"),
    ("EndPose2", "RX"), ("EndPose3", "RY"), ("EndPose3", "RZ"),
)  # fmt: skip
"""The messages and signals of the end pose."""
_Answer = TypeVar("_Answer")

_FRAMES_LOOKED_AT: Final = 6_000
"""The frames, two seconds of an arm, that show the generation as well as all of them."""
_MOST_FRAMES_LOOKED_AT: Final = 200_000
"""The most frames searched for the arm's among foreign ones."""


def joint_signals(message: str) -> tuple[tuple[str, str], ...]:
    """Return the messages and signals of six joint angles, measured or commanded."""
    return tuple((f"{message}{pair}", f"J{joint}") for pair in ("12", "34", "56") for joint in pair)


ANGLES: Final = joint_signals("JointFeedback")


def model_of_log(
    session: Session, channel: Channel, generation: Generation, feedback_offset: int
) -> PiperModel | None:
    """Return the model of the arm on a channel of a log, or ``None`` if it cannot be found.

    The operator's choice in the recording's sidecar comes first: if the arm's own pose contradicts
    it, the replay shows that as the live program did.
    """
    told = told_model(getattr(session, "lines", ()))
    if told is not None:
        return told
    return _agreed(session, channel, generation, feedback_offset, lambda arm: arm.model)


def zeros_of_log(
    session: Session, channel: Channel, generation: Generation, feedback_offset: int
) -> bool | None:
    """Return whether poses in a log have the zeros before S-V1.6-3, or ``None`` if unknown."""
    return _agreed(session, channel, generation, feedback_offset, lambda arm: arm.older_zeros)


def _agreed(
    session: Session,
    channel: Channel,
    generation: Generation,
    feedback_offset: int,
    answer: Callable[[FittingArm], _Answer],
) -> _Answer | None:
    """Return what all fitting arms have in common, at the first place where they agree."""
    codec = Codec(generation, Addressing(feedback_offset))
    for place in _PLACES:
        at_s = session.start_s + place * (session.end_s - session.start_s)
        answers = set(map(answer, _fitting(session, channel, codec, at_s)))
        if len(answers) == 1:
            return answers.pop()
    return None


def told_model(lines: Iterable[Mapping[str, Any]]) -> PiperModel | None:
    """Return the last model named in the lines of a sidecar, or ``None``."""
    told = [line.get("model") for line in lines if line.get("kind") == "arm"]
    known = [PiperModel(each) for each in told if each in list(PiperModel)]
    return known[-1] if known else None


def told_cell(lines: Iterable[Mapping[str, Any]]) -> CellInForce:
    """Return the parts of a cell that applied throughout a recording.

    The lines do not give the time of a change of tool, object, area or frame: what was changed
    during the recording is not shown, and the events name the change.
    """
    return all_through([from_entry(line) for line in lines if line.get("kind") == "cell"])


def told_firmware(lines: Iterable[Mapping[str, Any]]) -> str:
    """Return the last version named in the lines of a sidecar, or ""."""
    told = [line.get("firmware") for line in lines if line.get("kind") == "arm"]
    known = [each for each in told if isinstance(each, str) and each]
    return known[-1] if known else ""


def _fitting(
    session: Session, channel: Channel, codec: Codec, at_s: float
) -> frozenset[FittingArm]:
    """Return the arms that fit the angles and the pose heard last at a moment."""
    last = session.snapshot_at(at_s)
    if channel not in last.channel_names:
        return frozenset()
    heard: dict[str, Mapping[str, float]] = {}
    own = last.channel_names.index(channel)
    for row in range(len(last)):
        if int(last.channels[row]) == own:
            message = codec.decode(Frame(int(last.ids[row]), last.data(row)))
            if isinstance(message, Message):
                heard[message.name] = message.signals
    if any(name not in heard for name, _signal in (*ANGLES, *END_POSE)):
        return frozenset()
    angles, pose = ([heard[name][signal] for name, signal in each] for each in (ANGLES, END_POSE))
    return fitting_arms(angles, pose, None)


# Detects the generation of the arm in a log from the log's beginning.


def detect_generation(batches: Iterator[FrameBatch]) -> tuple[list[FrameBatch], GenerationVerdict]:
    """Read a log's beginning until its generation is certain.

    Returns:
        The batches read, and the verdict.
    """
    detector = GenerationDetector()
    looked_at: list[FrameBatch] = []
    count = 0
    for batch in batches:
        looked_at.append(batch)
        count += feed(detector, batch, count)
        enough = _FRAMES_LOOKED_AT if detector.has_evidence else _MOST_FRAMES_LOOKED_AT
        if detector.certain or count >= enough:
            break
    return looked_at, detector.verdict()


def feed(detector: GenerationDetector, batch: FrameBatch, before: int = 0) -> int:
    """Show a detector the frames of a batch until it is certain, or has seen enough.

    Args:
        detector: The detector.
        batch: The frames.
        before: The frames it has seen.

    Returns:
        The frames it was shown.
    """
    count = 0
    for row in np.flatnonzero((batch.flags & NOT_OF_THE_ARM) == 0).tolist():
        detector.feed(Frame(int(batch.ids[row]), batch.data(row)), float(batch.times_s[row]))
        count += 1
        if detector.certain or (before + count >= _FRAMES_LOOKED_AT and detector.has_evidence):
            break
    return count
