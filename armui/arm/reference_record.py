"""The record of an arm: which joints are in doubt, and what checks and inspections have found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from armui.arm.inspection_record import (
    KEPT,
    InspectionEntry,
    ResumeEntry,
    read_inspections,
    read_resumes,
)
from armui.arm.json_fields import finite
from armui.arm.limits import JOINTS

_TURN_DEG = 360.0
_LONGEST_TEXT = 4096


@dataclass(frozen=True, slots=True)
class ReferenceRecord:
    """The facts kept of one arm's reference, beyond the program's end and the arm's power.

    Attributes:
        doubtful: The joints (1–6) in doubt: each left its place uncommanded while enabled, or was
            found off, and no check has cleared it since.
        doubted_at: The local time of the last doubt, ISO 8601; "" if there never was one.
        checked_at: The local time of the last finished check, likewise.
        off_deg: What that check found: the joints that were off, each with its degrees.
        pose_deg: The pose taught as reference for joints without a mark, six angles; empty: none.
        photo: The file with a photo of the arm in that pose; "" if there is none.
        inspections, resumes: The results of the last ones of each, the newest last.
    """

    doubtful: tuple[int, ...] = ()
    doubted_at: str = ""
    checked_at: str = ""
    off_deg: Mapping[int, float] = field(default_factory=dict)
    pose_deg: tuple[float, ...] = ()
    photo: str = ""
    inspections: tuple[InspectionEntry, ...] = ()
    resumes: tuple[ResumeEntry, ...] = ()

    def as_entry(self) -> dict[str, Any]:
        """Return the record as JSON has it."""
        off_deg = {str(joint): off for joint, off in self.off_deg.items()}
        return asdict(self) | {"off_deg": off_deg}


def read_record(entry: object) -> ReferenceRecord | None:
    """Return the record in a JSON entry, or ``None`` if it is none."""
    if not isinstance(entry, Mapping):
        return None
    doubtful, pose_deg = entry.get("doubtful", ()), entry.get("pose_deg", ())
    off_deg = entry.get("off_deg", {})
    texts = [entry.get(name, "") for name in ("doubted_at", "checked_at", "photo")]
    if not isinstance(doubtful, list | tuple) or not all(_is_joint(each) for each in doubtful):
        return None
    if not isinstance(pose_deg, list | tuple) or len(pose_deg) not in (0, len(JOINTS)):
        return None
    if not isinstance(off_deg, Mapping) or not all(isinstance(each, str) for each in off_deg):
        return None
    if not all(isinstance(text, str) and len(text) <= _LONGEST_TEXT for text in texts):
        return None
    joints = [int(key) if key.isdecimal() else 0 for key in off_deg]
    angles = [finite(each) for each in (*pose_deg, *off_deg.values())]
    if not all(map(_is_joint, joints)) or any(each is None for each in angles):
        return None
    figures = [each for each in angles if each is not None and abs(each) <= _TURN_DEG]
    if len(figures) != len(angles):
        return None
    return ReferenceRecord(
        tuple(sorted(set(doubtful))),
        texts[0],
        texts[1],
        dict(zip(joints, figures[len(pose_deg) :], strict=True)),
        tuple(figures[: len(pose_deg)]),
        texts[2],
        read_inspections(entry.get("inspections")),
        read_resumes(entry.get("resumes")),
    )


def record_in(entry: object) -> ReferenceRecord | None:
    """Return the record in a JSON entry; ``None`` if there is none.

    Of an arm whose entry is not understood every joint is in doubt: it may tell of one.
    """
    if entry is None:
        return None
    return read_record(entry) or ReferenceRecord(doubtful=tuple(JOINTS))


def merged_entry(before: ReferenceRecord, now: ReferenceRecord, found: object) -> dict[str, Any]:
    """Return the entry to keep of a record that was changed, where another program may have been.

    What was changed counts, the rest is as it was found. A doubt goes only with what cleared it:
    one that another program has noted meanwhile stays.

    Args:
        before: The record as it was before the change.
        now: The record after it.
        found: The entry in whose place it comes.
    """
    entry = now.as_entry()
    theirs = read_record(found)
    if theirs is None or not isinstance(found, Mapping):
        return entry
    known = before.as_entry()
    changed = {name: value for name, value in entry.items() if value != known[name]}
    noted, cleared = ({*now.doubtful} - {*before.doubtful}, {*before.doubtful} - {*now.doubtful})
    doubtful = ({*theirs.doubtful} | noted) - cleared
    merged = {**theirs.as_entry(), **found, **changed, "doubtful": tuple(sorted(doubtful))}
    for name in ("inspections", "resumes"):
        added = [each for each in entry[name] if each not in known[name]]
        merged[name] = [*theirs.as_entry()[name], *added][-KEPT:]
    return merged


def _is_joint(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value in JOINTS
