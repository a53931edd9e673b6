"""What the window 导出 says: of the formats, of what was written, and why nothing was."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication

from armui.export.process import ExportDone
from armui.session.exports.request import ExportFormat, ExportProblem


def about(export_format: ExportFormat) -> str:
    """What a format holds, and who opens it."""
    if export_format is ExportFormat.MCAP:
        return QCoreApplication.translate(
            "ExportDialog",
            "ROS 2 messages: joint states, targets, end pose, transforms of the links, "
            "diagnostics. For Foxglove, PlotJuggler, rerun and ROS 2 itself.",
        )
    if export_format is ExportFormat.CSV:
        return QCoreApplication.translate(
            "ExportDialog",
            "A table as text: a row for each set of joint angles, all else as last heard then. "
            "For spreadsheets and scripts.",
        )
    if export_format is ExportFormat.CSV_MESSAGES:
        return QCoreApplication.translate(
            "ExportDialog",
            "A folder with a file for each message: every frame with its time, decoded into "
            "signals with their units.",
        )
    return QCoreApplication.translate(
        "ExportDialog",
        "The same table with types and units, small and quick to open. For pandas and the like; "
        "needs the package pyarrow.",
    )


def problem(done: ExportDone, target: Path) -> str:
    """Why nothing was written, and what helps."""
    translate = QCoreApplication.translate
    texts = {
        ExportProblem.NO_LOG: translate("ExportDialog", "The log cannot be read: {detail}"),
        ExportProblem.NO_CHANNEL: translate(
            "ExportDialog", "The log has no such channel. It has: {detail}"
        ),
        ExportProblem.NO_FRAMES: translate(
            "ExportDialog", "The log has no frames. No file was written."
        ),
        ExportProblem.NO_ARM: translate(
            "ExportDialog",
            "No frame of the log is an arm's. No file was written. Another channel?",
        ),
        ExportProblem.NO_ANGLES: translate(
            "ExportDialog",
            "A table has a row for each set of joint angles, and none was heard. No file was "
            "written. MCAP holds what else there is.",
        ),
        ExportProblem.NOTHING_THEN: translate(
            "ExportDialog", "Nothing was heard in this time. No file was written."
        ),
        ExportProblem.EXISTS: translate("ExportDialog", "{target} is there already."),
        ExportProblem.SAME_FILE: translate(
            "ExportDialog", "The target is the log itself. Choose another name."
        ),
        ExportProblem.CANNOT_WRITE: translate(
            "ExportDialog", "{target} cannot be written: {detail}"
        ),
        ExportProblem.NO_PYARROW: translate(
            "ExportDialog",
            "Parquet needs the package pyarrow: pip install 'armui[parquet]'. CSV has the same "
            "table without it.",
        ),
    }
    if done.problem is None:
        text = translate("ExportDialog", "The export failed: {detail}")
    else:
        text = texts[done.problem]
    return text.format(detail=done.detail, target=target)


def finished(report: dict[str, Any], export_format: ExportFormat, target: Path) -> str:
    """What was written."""
    text = QCoreApplication.translate("ExportDialog", "Saved: {target} ({items:,} rows)")
    if export_format is ExportFormat.MCAP:
        text = QCoreApplication.translate("ExportDialog", "Saved: {target} ({items:,} messages)")
    return text.format(target=target, items=report["items"])


def remarks(report: dict[str, Any]) -> list[str]:
    """What was noticed on the way, a line each; the damaged places first."""
    translate = QCoreApplication.translate
    lines = []
    if report["damage_count"]:
        first = report["damages"][0]
        text = translate(
            "ExportDialog",
            "Unreadable places in the log: {count}; the first: {place} ({reason}). "
            "Everything else was exported.",
        )
        lines.append(text.format(count=report["damage_count"], place=first[0], reason=first[1]))
    if report["of_other_channels"]:
        text = translate(
            "ExportDialog",
            "Only channel {channel} was exported; {count:,} frames of {others} were left out.",
        )
        others = ", ".join(report["other_channels"])
        lines.append(
            text.format(channel=report["channel"], count=report["of_other_channels"], others=others)
        )
    if report["pose_fits"]:
        text = translate(
            "ExportDialog", "Exported as a {model}, but the end pose in the log fits a {fits}."
        )
        lines.append(text.format(model=report["model"], fits=report["pose_fits"]))
    text = translate("ExportDialog", "{frames:,} frames read as generation {generation}, {model}.")
    line = text.format(
        frames=report["frames"], generation=report["generation"], model=report["model"]
    )
    if report["not_understood"]:
        text = translate("ExportDialog", "{count:,} of them do not belong to the arm.")
        line += " " + text.format(count=report["not_understood"])
    lines.append(line)
    return lines
