"""The report of a joint inspection: one page of text, figures and curves, to read and to print."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QBuffer, QByteArray, QMarginsF, QPointF, QRectF, QUrl
from PySide6.QtGui import (
    QColor,
    QFont,
    QImage,
    QPageSize,
    QPainter,
    QPdfWriter,
    QPen,
    QPolygonF,
    QTextDocument,
)

from armui.arm.inspection_record import JointFigures, JointFinding, JointSign
from armui.arm.limits import JOINTS
from armui.system.atomic import write_whole
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.theme import LIGHT, Colors
from armui.ui.words.reference import stamp_text
from armui.ui.words.text import Texts

if TYPE_CHECKING:
    from pathlib import Path

    from armui.control.run.inspection import InspectionReport
    from armui.telemetry.swing_figures import Curve

CURVES: Final = QUrl("curves")
_WIDE_PX, _HIGH_PX, _HEAD_PX, _EDGE_PX = 520, 96, 16, 4
_FINER: Final = 3
"""How many times finer than on the screen the curves are drawn, for printing."""
_POINTS: Final = 240
_PAGE_MM: Final = 15.0
_TEXT_PX: Final = 12

_SAID: Final = Texts("InspectionFinding") | {
    (
        JointSign.BEHIND,
        False,
    ): "{joint} stays {value} behind its setpoint, the other joints {usual}.",
    (JointSign.BEHIND, True): "{joint} stays {value} behind its setpoint, earlier {usual}.",
    (JointSign.CURRENT, False): "{joint} needs {value} to turn, the joints of its kind {usual}.",
    (JointSign.CURRENT, True): "{joint} needs {value} to turn, earlier {usual}.",
    (JointSign.MOTOR, False): "The motor of {joint} is at {value}, the others at {usual}.",
    (JointSign.DRIVER, False): "The driver of {joint} is at {value}, the others at {usual}.",
}
_HELPS: Final = Texts("InspectionFinding") | {
    JointSign.BEHIND: "See whether something holds the joint: a cable, a cover, the load. Compare "
    "its speed and acceleration under Joint settings. If it needs more current as well, it is "
    "stiff.",
    JointSign.CURRENT: "Hold the arm, switch the motor of this joint off and turn it by hand: does "
    "it grind or catch? Free cables and hoses, clean it. If it stays so, or grows from one "
    "inspection to the next, have its gear looked at.",
    JointSign.MOTOR: "Let the arm cool and inspect it again. See what the joint carries where it "
    "mostly works, and whether it presses against something; give it pauses.",
}
_WORDS: Final = Texts("InspectionReport") | {
    "how": "Each joint swings to and fro at the same angles. What turns round with it is "
    "friction and lag, and is compared; what stays is gravity, which each joint bears "
    "differently.",
    "axes": "Above: setpoint less angle, in degrees. Below: motor current, in A. Over time.",
    "title": "Joint inspection",
    "found": "What stands out",
    "nothing": "Nothing stands out.",
    "unmeasured": "Not measured",
    "shortened": "Swung less far",
    "swings": "Swings of ±{amplitude} at {speed}; compared with {count} earlier inspections",
    "ended": "It ended early. {reason}",
    "unsigned": "Current to turn: arms of generation 1 tell no sign of their currents.",
    "behind_deg": "Stays behind",
    "current_a": "Current to turn it",
    "bears_a": "Current for what it bears",
    "motor_c": "Motor",
    "driver_c": "Driver",
}
_UNITS: Final = {JointSign.BEHIND: ("°", 2), JointSign.CURRENT: ("A", 2)}


def finding_text(finding: JointFinding) -> str:
    """Return a sentence on an unusual figure of a joint."""
    unit, decimals = _UNITS.get(finding.sign, ("°C", 0))
    return _SAID.text(
        (finding.sign, finding.earlier),
        {
            "joint": f"J{finding.joint}",
            "value": fmt.with_unit(finding.value, unit, decimals),
            "usual": fmt.with_unit(finding.usual, unit, decimals),
        },
    )


def report_html(report: InspectionReport, arm: Sequence[str], colors: Colors) -> str:
    """Return a report as rich text; its curves are the image :data:`CURVES`.

    Args:
        report: What was found.
        arm: What is known of the arm.
        colors: Those of the theme.
    """
    told = [*arm, stamp_text(report.entry.at), _swings(report)]
    parts = [
        f'<h2 style="margin:0">{escape(_WORDS.text("title"))}</h2>',
        f'<p style="margin:2px 0; color:{colors.muted}">{"<br>".join(map(escape, told))}</p>',
        _list(_WORDS.text("found"), _found(report) or [_WORDS.text("nothing")]),
        _list(_WORDS.text("unmeasured"), _unmeasured(report)),
        _list(_WORDS.text("shortened"), _shortened(report)),
        _figures(report, colors),
        f'<p style="margin:8px 0 2px 0">{escape(_WORDS.text("axes"))}</p>',
        f'<img src="{CURVES.toString()}" width="{_WIDE_PX}" height="{2 * _HIGH_PX + _HEAD_PX}">',
        f'<p style="margin:2px 0; color:{colors.muted}">{escape(_WORDS.text("how"))}</p>',
    ]
    return f'<div style="font-size:{_TEXT_PX}px; color:{colors.text}">{"".join(parts)}</div>'


def document(
    report: InspectionReport, arm: Sequence[str], colors: Colors, font: QFont
) -> QTextDocument:
    """Return a report as a document with its curves."""
    made = QTextDocument()
    made.setDefaultFont(font)
    made.addResource(
        QTextDocument.ResourceType.ImageResource.value, CURVES, curves_image(report, colors, font)
    )
    made.setHtml(report_html(report, arm, colors))
    made.setTextWidth(_WIDE_PX + 4 * _EDGE_PX)
    return made


def write_pdf(report: InspectionReport, arm: Sequence[str], font: QFont, path: Path) -> None:
    """Write a report as one page of A4; it waits for a disk.

    Raises:
        OSError: The file cannot be written.
    """
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setPageSize(QPageSize(QPageSize.PageSizeId.A4))
    writer.setPageMargins(QMarginsF(_PAGE_MM, _PAGE_MM, _PAGE_MM, _PAGE_MM))
    writer.setTitle(_WORDS.text("title"))
    page = document(report, arm, LIGHT, font)
    size, painter = page.size(), QPainter(writer)
    share = min(writer.width() / size.width(), writer.height() / size.height())
    painter.scale(share, share)
    page.drawContents(painter)
    painter.end()
    buffer.close()
    write_whole(path, bytes(data.data()))


# Its parts ----------------------------------------------------------------------------------------


def _list(title: str, lines: Sequence[str]) -> str:
    if not lines:
        return ""
    items = "".join(f"<li>{line}</li>" for line in lines)
    head = f'<p style="margin:8px 0 0 0"><b>{escape(title)}</b></p>'
    return f'{head}<ul style="margin:2px 0">{items}</ul>'


def _swings(report: InspectionReport) -> str:
    figures = {
        "amplitude": fmt.with_unit(report.plan.amplitude_deg, "°", 0),
        "speed": f"{report.entry.speed_deg_s:.1f}°/s",
        "count": len(report.earlier),
    }
    return _WORDS.text("swings", figures)


def _found(report: InspectionReport) -> list[str]:
    """Return the findings as HTML lines, with the remedy after the last one of each kind."""
    lines: list[str] = []
    for signs in ((JointSign.BEHIND,), (JointSign.CURRENT,), (JointSign.MOTOR, JointSign.DRIVER)):
        said = [escape(finding_text(each)) for each in report.findings if each.sign in signs]
        if said:
            helps = f"<i>{escape(_HELPS.text(signs[0]))}</i>"
            lines += [*said[:-1], f"{said[-1]}<br>{helps}"]
    return lines


def _unmeasured(report: InspectionReport) -> list[str]:
    lines = [escape(f"J{joint}: {words.refusal(why)}") for joint, why in report.unmeasured.items()]
    if report.ended is not None:
        lines.insert(0, escape(_WORDS.text("ended", {"reason": report.ended})))
    if any(each is not None and each.current_a is None for each in report.entry.joints):
        lines.append(escape(_WORDS.text("unsigned")))
    return lines


def _shortened(report: InspectionReport) -> list[str]:
    return [
        escape(f"J{each.joint} −{each.below_deg:g}° +{each.above_deg:g}°: ")
        + escape(words.refusal(each.shortened))
        for each in report.plan.swings
        if each.possible and each.shortened is not None
    ]


def _figures(report: InspectionReport, colors: Colors) -> str:
    rows = (
        *(("behind_deg", "°", 2), ("current_a", "A", 2), ("bears_a", "A", 2)),
        *(("motor_c", "°C", 0), ("driver_c", "°C", 0)),
    )
    stands_out = {(each.joint, each.sign.value) for each in report.findings}

    def cell(joint: int, figures: JointFigures | None, name: str, unit: str, digits: int) -> str:
        value = None if figures is None else getattr(figures, name)
        text = escape(fmt.with_unit(value, unit, digits))
        if (joint, name) in stands_out:
            text = f'<b style="color:{colors.stop_ink}">▲ {text}</b>'
        return f'<td align="right">{text}</td>'

    head = "".join(f'<th align="right">J{joint}</th>' for joint in JOINTS)
    lines = [f"<tr><th></th>{head}</tr>"]
    for name, unit, digits in rows:
        cells = "".join(
            cell(joint, figures, name, unit, digits)
            for joint, figures in zip(JOINTS, report.entry.joints, strict=True)
        )
        lines.append(f"<tr><td>{escape(_WORDS.text(name))}</td>{cells}</tr>")
    return f'<table width="100%" cellpadding="2" style="margin-top:8px">{"".join(lines)}</table>'


def curves_image(report: InspectionReport, colors: Colors, font: QFont) -> QImage:
    """Return the curves of all joints in two rows: how far each is behind, and its current."""
    size = (_WIDE_PX * _FINER, (2 * _HIGH_PX + _HEAD_PX) * _FINER)
    image = QImage(*size, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(QColor(colors.surface))
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.scale(_FINER, _FINER)
    small = QFont(font)
    small.setPixelSize(_TEXT_PX - 2)
    painter.setFont(small)
    lines = {joint: _lines(curves) for joint, curves in report.curves.items()}
    for row in (0, 1):
        ends = [(c[row][1].min(), c[row][1].max()) for c in lines.values() if len(c[row][1])]
        low, high = _round_ends([*(a for a, _ in ends), *(b for _, b in ends)])
        for place, joint in enumerate(JOINTS):
            wide = _WIDE_PX / len(JOINTS)
            box = QRectF(place * wide, _HEAD_PX + row * _HIGH_PX, wide, _HIGH_PX)
            box.adjust(_EDGE_PX, _EDGE_PX, -_EDGE_PX, -_EDGE_PX)
            if row == 0:
                painter.setPen(QColor(colors.text))
                painter.drawText(QPointF(box.left(), _HEAD_PX - 3.0), f"J{joint}")
            _draw(painter, colors, box, lines.get(joint, _NOTHING)[row], (low, high))
    painter.end()
    return image


_NOTHING: Final = ((np.empty(0), np.empty(0)),) * 2


def _lines(curves: Mapping[str, Curve]) -> tuple[Curve, Curve]:
    """Return how far a joint was behind over time, and its current."""
    heard_s, angles_deg = curves["angle"]
    if not len(heard_s) or not len(curves["target"][0]):
        return _NOTHING
    behind = np.interp(heard_s, *curves["target"]) - angles_deg
    return (heard_s, behind), curves["current"]


def _round_ends(values: Sequence[float]) -> tuple[float, float]:
    """Return a range around values and 0, in steps of 0.1."""
    low, high = min([-0.1, *values]), max([0.1, *values])
    return float(np.floor(low * 10.0) / 10.0), float(np.ceil(high * 10.0) / 10.0)


def _draw(
    painter: QPainter, colors: Colors, box: QRectF, curve: Curve, ends: tuple[float, float]
) -> None:
    low, high = ends
    times_s, values = curve
    painter.setPen(QPen(QColor(colors.border), 1.0))
    painter.drawRect(box)
    zero = box.bottom() + low / (high - low) * box.height()
    painter.drawLine(QPointF(box.left(), zero), QPointF(box.right(), zero))
    painter.setPen(QColor(colors.muted))
    painter.drawText(box.topLeft() + QPointF(2.0, 10.0), f"{high:+.1f}")
    painter.drawText(box.bottomLeft() + QPointF(2.0, -3.0), f"{low:+.1f}")
    if len(times_s) < 2:
        return
    every = max(1, len(times_s) // _POINTS)
    times_s, values = times_s[::every], values[::every]
    across = (times_s - times_s[0]) / max(times_s[-1] - times_s[0], 1e-6) * box.width()
    down = (high - values) / (high - low) * box.height()
    painter.setPen(QPen(QColor(colors.accent), 1.0))
    points = zip(across.tolist(), down.tolist(), strict=True)
    painter.drawPolyline(QPolygonF([QPointF(box.left() + x, box.top() + y) for x, y in points]))
