"""What `armui export` says in the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.session.exports.request import ExportProblem

if TYPE_CHECKING:
    from armui.session.exports.request import ExportReport, ExportRequest


def problem_text(problem: ExportProblem, detail: str, request: ExportRequest) -> str:
    """Why nothing was written, and what helps."""
    target = request.target
    texts = {
        ExportProblem.NO_LOG: detail,
        ExportProblem.NO_CHANNEL: (
            f"no frame of the channel {request.wishes.channel!r} near its beginning; "
            f"there are: {detail}"
        ),
        ExportProblem.NO_FRAMES: "nothing to export: it has no frames; no file was written",
        ExportProblem.NO_ARM: (
            "nothing to export: no frame in it is an arm's; no file was written "
            "(armui decode shows what is in it)"
        ),
        ExportProblem.NO_ANGLES: (
            "nothing to export: a table has a row for each set of joint angles (0x2A5-0x2A7), and "
            "none was heard; no file was written (--to mcap wants none)"
        ),
        ExportProblem.NOTHING_THEN: (
            "nothing to export: nothing was heard between --from and --to-time; no file was written"
        ),
        ExportProblem.EXISTS: (
            f"{target} is there already; give another name with -o, or --force to replace it"
        ),
        ExportProblem.SAME_FILE: "the target is the log itself; give another name with -o",
        ExportProblem.CANNOT_WRITE: f"cannot write {target}: {detail}",
        ExportProblem.NO_PYARROW: (
            "Parquet needs the package pyarrow: pip install 'armui[parquet]' "
            "(CSV has the same table without it)"
        ),
    }
    return texts[problem]


def report_lines(report: ExportReport) -> list[str]:
    """What was noticed on the way."""
    lines = [f"read as generation {report.generation}: {report.why_generation}"]
    lines.append(f"taken for a {report.model}: {report.why_model}")
    if report.offset:
        lines.append(f"the arm's feedback has the identifier offset 0x{report.offset:02X} (0x470)")
    if report.of_other_channels:
        others = ", ".join(report.other_channels)
        lines.append(
            f"only the channel {report.channel} was exported; {report.of_other_channels:,} frames "
            f"of {others} were left out (--channel chooses)"
        )
    if report.not_understood:
        lines.append(
            f"{report.not_understood:,} frames are none of the arm's and were left out "
            "(armui decode shows them)"
        )
    if report.without_stamp:
        lines.append(
            f"{report.without_stamp:,} frames have a time that no ROS time stamp can tell and were "
            "left out"
        )
    for damage in report.damages:
        words = "contradicts itself" if damage.frame_given else "cannot be read"
        lines.append(f"{damage.place} {words}: {damage.reason}")
    if further := report.damage_count - len(report.damages):
        lines.append(f"{further} further places cannot be read")
    return lines
