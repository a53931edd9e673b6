"""The state of an arm's reference in the operator's language."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import QCoreApplication

from armui.arm.reference_record import ReferenceRecord
from armui.ui import format as fmt


def reference_text(record: ReferenceRecord) -> str:
    """Return the state of an arm's reference and its last check, for a line of text."""
    parts = []
    if record.doubtful:
        joints = ", ".join(map(str, record.doubtful))
        text = QCoreApplication.translate("Reference", "joint {joints} in doubt since {time}")
        parts.append(text.format(joints=joints, time=_time(record.doubted_at)))
    if record.checked_at:
        off = ", ".join(f"J{j} {fmt.angle(deg)}" for j, deg in record.off_deg.items())
        if off:
            text = QCoreApplication.translate("Reference", "last checked {time}: {off} off")
        else:
            text = QCoreApplication.translate("Reference", "last checked {time}: all joints fit")
        parts.append(text.format(time=_time(record.checked_at), off=off))
    else:
        parts.append(QCoreApplication.translate("Reference", "never checked"))
    text = QCoreApplication.translate("Reference", "; ").join(parts)
    return text[:1].upper() + text[1:]


def _time(stamp: str) -> str:
    try:
        return f"{datetime.fromisoformat(stamp):%Y-%m-%d %H:%M}"
    except ValueError:
        return stamp or fmt.NOTHING
