"""The state of an arm's reference in the operator's language."""

from __future__ import annotations

from datetime import datetime
from typing import Final

from PySide6.QtCore import QCoreApplication

from armui.arm.inspection_record import findings
from armui.arm.limits import JOINTS
from armui.arm.reference_record import ReferenceRecord
from armui.ui import format as fmt

_LINES: Final = 3
"""The most resumes with slipped joints that are listed, the newest first."""


def reference_text(record: ReferenceRecord) -> str:
    """Return the state of an arm's reference and its last check, for a line of text."""
    parts = []
    if record.doubtful:
        joints = fmt.listed(map(str, record.doubtful))
        text = QCoreApplication.translate("Reference", "joint {joints} in doubt since {time}")
        parts.append(text.format(joints=joints, time=stamp_text(record.doubted_at)))
    if record.checked_at:
        off = fmt.listed(f"J{j} {fmt.angle(deg)}" for j, deg in record.off_deg.items())
        if off:
            text = QCoreApplication.translate("Reference", "last checked {time}: {off} off")
        else:
            text = QCoreApplication.translate("Reference", "last checked {time}: all joints fit")
        parts.append(text.format(time=stamp_text(record.checked_at), off=off))
    else:
        parts.append(QCoreApplication.translate("Reference", "never checked"))
    text = QCoreApplication.translate("Reference", "; ").join(parts)
    return text[:1].upper() + text[1:]


def resume_text(record: ReferenceRecord) -> str:
    """Return which joints slipped at the last resumes, or that none did, for a line of text."""
    if not record.resumes:
        return QCoreApplication.translate("Reference", "No resume (0x150) was seen")
    slipped = (each for each in reversed(record.resumes) if each.text)
    lines = [f"{stamp_text(each.at)}: {each.text}" for each in slipped]
    if not lines:
        text = QCoreApplication.translate("Reference", "None; last resume {time}")
        if None in record.resumes[-1].slips_deg:
            text = QCoreApplication.translate("Reference", "Not heard enough at {time} to tell")
        return text.format(time=stamp_text(record.resumes[-1].at))
    return "\n".join(lines[:_LINES])


def inspection_text(record: ReferenceRecord) -> str:
    """Return the time and the findings of the last inspection, for a line of text."""
    if not record.inspections:
        return QCoreApplication.translate("Reference", "Never inspected")
    *earlier, last = record.inspections
    joints = sorted({each.joint for each in findings(last, earlier)})
    if joints:
        text = QCoreApplication.translate("Reference", "{time}: joint {joints} stands out")
    else:
        text = QCoreApplication.translate("Reference", "{time}: nothing stands out")
    text = text.format(time=stamp_text(last.at), joints=fmt.listed(map(str, joints)))
    if None in last.joints:
        left = [str(joint) for joint, each in zip(JOINTS, last.joints, strict=True) if each is None]
        more = QCoreApplication.translate("Reference", "; joint {joints} was not measured")
        text += more.format(joints=fmt.listed(left))
    return text


def stamp_text(stamp: str) -> str:
    """Return a stored time (ISO 8601) as date and minutes."""
    try:
        return f"{datetime.fromisoformat(stamp):%Y-%m-%d %H:%M}"
    except ValueError:
        return stamp or fmt.NOTHING
