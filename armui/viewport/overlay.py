"""What stands over the picture where it is old, or not there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QPoint, QPointF, QRect, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QImage, QPainter
from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from armui.arm.refusal_codes import RefusalCode

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.viewport.news import Lost
    from armui.viewport.palette import ScenePalette

FADED_OPACITY: Final = 0.35
"""Of a picture that is not what it should be."""

_MARGIN_PX: Final = 24
_PADDING_PX: Final = 10
_PLATE_OPACITY: Final = 0.85


def lost_text(lost: Lost) -> str:
    """Why there is no picture, and what comes next."""
    if lost.reason.code == RefusalCode.NO_OPENGL:
        return QCoreApplication.translate(
            "ArmView",
            "The 3D view is not available: this computer offers no OpenGL. Install a graphics "
            "driver or Mesa (on Debian the packages libegl1 and libgl1-mesa-dri) and start the "
            "3D view again.",
        )
    if lost.reason.code == RefusalCode.PICTURE_PROCESS_HUNG:
        text = QCoreApplication.translate("ArmView", "The 3D view did not answer any more.")
    else:
        text = QCoreApplication.translate("ArmView", "The 3D view has ended ({text}).")
        text = text.format_map(lost.reason.params)
    if lost.comes_back:
        outlook = QCoreApplication.translate(
            "ArmView", "It is being started again; the arm is not affected."
        )
    else:
        outlook = QCoreApplication.translate(
            "ArmView", "It ended three times in a minute; the arm is not affected."
        )
    return f"{text}\n{outlook}"


def add_again_button(view: QWidget, start_again: Callable[[], object]) -> QPushButton:
    """A button over the picture's place, for when it does not come back by itself; hidden."""
    button = QPushButton(view)
    button.setObjectName("picture_again_button")
    button.setAutoDefault(False)
    button.clicked.connect(start_again)
    button.hide()
    layout = QVBoxLayout(view)
    layout.addStretch(3)
    layout.addWidget(button, 0, Qt.AlignmentFlag.AlignHCenter)
    layout.addStretch(1)
    return button


def paint_plate(painter: QPainter, place: QRect, text: str, palette: ScenePalette) -> None:
    """Write a text into the middle, on a plate that sets it off from the picture."""
    flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    room = place.adjusted(_MARGIN_PX, _MARGIN_PX, -_MARGIN_PX, -_MARGIN_PX)
    box = QFontMetrics(painter.font()).boundingRect(room, flags, text)
    plate = QColor(palette.background)
    plate.setAlphaF(_PLATE_OPACITY)
    painter.setPen(QColor(palette.grid))
    painter.setBrush(plate)
    grown = box.adjusted(-_PADDING_PX, -_PADDING_PX, _PADDING_PX, _PADDING_PX)
    painter.drawRoundedRect(grown, 6.0, 6.0)
    painter.setPen(QColor(palette.text))
    painter.drawText(room, flags, text)


def paint_image(
    painter: QPainter, size: QSize, image: QImage | None, palette: ScenePalette, *, faded: bool
) -> None:
    """Paint the last picture; until one of a new size is there, the old one stays in the middle.

    Args:
        painter: Of the widget.
        size: Of the widget.
        image: The picture, or ``None`` while there is none.
        palette: The ground, where the picture does not cover it or is faded.
        faded: The picture is not what it should be.
    """
    covered = None if image is None else image.deviceIndependentSize().boundedTo(size)
    if faded or covered != size:
        painter.setBackground(QColor(palette.background))
        painter.eraseRect(QRect(QPoint(0, 0), size))
    if image is not None:
        whole = image.deviceIndependentSize()
        left, top = (size.width() - whole.width()) / 2.0, (size.height() - whole.height()) / 2.0
        painter.setOpacity(FADED_OPACITY if faded else 1.0)
        painter.drawImage(QPointF(left, top), image)
        painter.setOpacity(1.0)
