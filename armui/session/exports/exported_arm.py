"""Finds out from the beginning of a log which arm it holds, unless that is given."""

from __future__ import annotations

from collections import Counter
from itertools import chain
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.arm.models import ModelData, all_models
from armui.kinematics.forward import flange_transforms
from armui.kinematics.geometry import Geometry
from armui.kinematics.poses import pose_to_matrix
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codec import Codec
from armui.protocol.firmware_version import VERSION_ID, FirmwareVersion, find_version
from armui.session.exports.export_columns import table_rows
from armui.session.exports.history import ArmFrameReader, History, TimeSpan
from armui.session.exports.ros.streams import signals_at
from armui.session.frames import NOT_OF_THE_ARM
from armui.session.log_model import ANGLES, END_POSE, detect_generation, told_firmware, told_model
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence
    from typing import Any

    from numpy.typing import NDArray

    from armui.protocol.generation import PiperModel
    from armui.session.exports.history import ArmFrames
    from armui.session.exports.request import ArmOptions
    from armui.session.frames import Channel, FrameBatch

_FEEDBACK: Final = range(0x2A1, 0x2A9)
_DRIVERS: Final = (*range(0x251, 0x257), *range(0x261, 0x267))
_FRAMES_LOOKED_AT: Final = 6_000
_LEVER_MM: Final = 200.0
"""The weight in mm of a difference of two rotations (Frobenius norm) against a shift of the flange.
"""


class NoSuchChannelError(Exception):
    """The log's beginning lacks the requested channel; the text names the channels it has."""


class ExportedArm(NamedTuple):
    """The arm in a log, as found out or given.

    Attributes:
        codec: A codec of its generation, with its identifier offset.
        why_generation: The reason for the generation, in words.
        channel: The channel with its frames.
        firmware: The version in the log or the one given; "" if neither.
        model: The model of the family.
        why_model: The reason for the model, in words.
        pose_fits: Another model that the end pose in the log fits better; "" if there is none.
        geometry: The geometry with the zeros of its firmware.
        start_s: The time of the log's first frame.
    """

    codec: Codec
    why_generation: str
    channel: Channel
    firmware: str
    model: ModelData
    why_model: str
    pose_fits: str
    geometry: Geometry
    start_s: float


def look_at(
    batches: Iterator[FrameBatch], wishes: ArmOptions, lines: Sequence[Mapping[str, Any]] = ()
) -> tuple[ExportedArm | None, Iterator[FrameBatch]]:
    """Find out which arm a log holds, from its beginning.

    Args:
        batches: The log, of which the beginning is read.
        wishes: The given facts.
        lines: The lines of the recording's sidecar.

    Returns:
        The arm, or `None` for a log without frames; and the whole log again.

    Raises:
        NoSuchChannelError: The requested channel has no frame there.
    """
    if wishes.generation is None:
        looked_at, verdict = detect_generation(batches)
        generation, why = verdict
    else:
        generation, why, looked_at = wishes.generation, Told("as asked for"), []
    count = sum(map(len, looked_at))
    while count < _FRAMES_LOOKED_AT and (batch := next(batches, None)) is not None:
        looked_at.append(batch)
        count += len(batch)
    if not count:
        return None, batches
    channel = _channel(looked_at, wishes.channel)
    pieces = list(ArmFrameReader(channel).pieces(looked_at))
    addressing = _addressing(pieces)
    firmware = wishes.firmware or _firmware(pieces) or told_firmware(lines)
    codec = Codec(generation, addressing, FirmwareVersion.parse(firmware))
    found = _model(pieces, codec, firmware, wishes.model, told_model(lines))
    start_s = float(looked_at[0].times_s[0])
    arm = ExportedArm(codec, why, channel, firmware, *found, start_s)
    return arm, chain(looked_at, batches)


def _channel(batches: Iterable[FrameBatch], wish: str | None) -> Channel:
    """Return the channel asked for, or the one with the most feedback of an arm."""
    counts: Counter[Channel] = Counter()
    names: dict[Channel, None] = {}
    for batch in batches:
        feedback = np.isin(batch.ids, (*_shifted_feedback(), *_DRIVERS))
        feedback &= (batch.flags & NOT_OF_THE_ARM) == 0
        found = np.bincount(batch.channels[feedback], minlength=len(batch.channel_names))
        for name, count in zip(batch.channel_names, found.tolist(), strict=False):
            names[name] = None
            counts[name] += count
    if wish is None:
        return max(names, key=lambda name: counts[name])
    for name in names:
        if str(name) == wish:
            return name
    raise NoSuchChannelError(", ".join(str(name) for name in names))


def _shifted_feedback() -> list[int]:
    return [base + offset for offset in OFFSETS for base in _FEEDBACK]


def _addressing(pieces: Iterable[ArmFrames]) -> Addressing:
    """Return the offset under which most feedback is heard, 0x00 where there is none.

    The offset of the commands cannot be heard; an arm is given both with one command (0x470), and
    whoever gives it one commonly gives it both.
    """
    counts: Counter[int] = Counter()
    for frames in pieces:
        for offset in OFFSETS:
            wanted = [base + offset for base in _FEEDBACK]
            counts[offset] += int(np.count_nonzero(np.isin(frames.ids, wanted)))
    offset = max(OFFSETS, key=lambda each: counts[each])
    return Addressing(feedback_offset=offset, control_offset=offset)


def _firmware(pieces: Iterable[ArmFrames]) -> str:
    """Return what the arm answered to 0x4AF within the frames looked at, "" if it was not asked."""
    text = b""
    for frames in pieces:
        found = frames.ids == VERSION_ID
        text += b"".join(
            word.to_bytes(8, "big")[:length]
            for word, length in zip(
                frames.words[found].tolist(), frames.lengths[found].tolist(), strict=True
            )
        )
    return find_version(text) or ""


def _model(
    pieces: Iterable[ArmFrames],
    codec: Codec,
    firmware: str,
    wish: PiperModel | None,
    told: PiperModel | None,
) -> tuple[ModelData, str, str, Geometry]:
    """Return the model, why, which other the pose fits, and the geometry.

    It is what is asked for, else what the recording says, else the one whose flange is nearest to
    where the arm itself says it is. Older firmware counts joints 2 and 3 from other zeros, and
    generation 1 tells no version. Where nothing tells, it is a PiPER of today.
    """
    candidates = [
        (model, geometry)
        for model in all_models().values()
        for geometry in ([model.geometry_of(firmware)] if firmware else model.geometries)
    ]
    off_mm = np.zeros(len(candidates))
    rows = 0
    history = History(codec)
    for frames in pieces:
        history.add_frames(frames)
        at = table_rows(history, TimeSpan(-np.inf, np.inf))
        if at is None:
            continue
        angles, poses = signals_at(history, at, ANGLES), signals_at(history, at, END_POSE)
        known = ~(np.isnan(angles).any(axis=1) | np.isnan(poses).any(axis=1))
        rows += int(known.sum())
        reported = pose_to_matrix(poses[known])
        for place, (_, geometry) in enumerate(candidates):
            off_mm[place] += _off_mm(flange_transforms(geometry, angles[known]), reported)
    nearest = min(range(len(candidates)), key=lambda place: off_mm[place])
    said = wish or told
    if said is None:
        model, geometry = candidates[nearest]
        why = Told("its end pose fits") if rows else Told("nothing in the log tells")
        return model, why, "", geometry
    own = [place for place, (model, _) in enumerate(candidates) if model.model is said]
    model, geometry = candidates[min(own, key=lambda place: off_mm[place])]
    why = Told("as asked for") if wish is not None else Told("as the log says")
    fits = candidates[nearest][0].name
    if rows and fits != model.name:
        why = Told("{why}; but its end pose fits a {fits}", why=why, fits=fits)
        return model, why, fits, geometry
    return model, why, "", geometry


def _off_mm(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Return how far transforms (n, 4, 4) are apart, all in all."""
    apart = np.linalg.norm(one[:, :3, 3] - other[:, :3, 3], axis=1)
    turned = np.linalg.norm(one[:, :3, :3] - other[:, :3, :3], axis=(1, 2))
    return float((apart + _LEVER_MM * turned).sum())
