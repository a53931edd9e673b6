"""The figures over the picture (end pose, joint angles), and the notice of an old or lost one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QFontMetricsF, QImage, QPainter, QPixmap
from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from armui.viewport.messages import NO_OPENGL
from armui.viewport.palette import ScenePalette

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.viewport.process_link import Lost


_NOT_HEARD = "—"
_HEIGHT = 2
_POSE = (("X", "mm"), ("Y", "mm"), ("Z", "mm"), ("RX", "°"), ("RY", "°"), ("RZ", "°"))
_JOINTS = tuple((f"J{number}", "°") for number in range(1, 7))
_WIDEST_NAME, _WIDEST_FIGURE, _WIDEST_UNIT = "RX ", "-0000.000", " mm"
_DIGITS = "0123456789"
_SAME_PX = 0.01
_LINE_SPACING = 1.15
_MARGIN_PX = 12.0
_PADDING_PX = 10.0
_GAP_PX = 18.0
_BACKDROP_OPACITY = 0.88
FADED_OPACITY: Final = 0.35
"""The opacity of a picture that is not current."""
_PLATE_MARGIN_PX: Final = 24
_PLATE_PADDING_PX: Final = 10
_PLATE_OPACITY: Final = 0.85


@dataclass(frozen=True, slots=True)
class HudValues:
    """The values of the figures; None: never heard from the arm.

    Attributes:
        pose: X, Y, Z in mm, RX, RY, RZ in degrees.
        angles_deg: six joint angles.
        pose_stale: the pose is no longer fresh.
        angles_stale: the angles are no longer fresh.
        too_low: flange or fingertip is below the plane on which the arm stands; the height turns
            amber, in a user frame the place.
        of_tool: the pose is that of the tool centre point, not of the flange.
        frame: the name of the user frame that the pose is in; empty for the base.
    """

    pose: tuple[float, ...] | None = None
    angles_deg: tuple[float, ...] | None = None
    pose_stale: bool = False
    angles_stale: bool = False
    too_low: bool = False
    of_tool: bool = False
    frame: str = ""

    @property
    def point(self) -> str:
        """The name of the point that the pose describes, and of the user frame that it is in."""
        point = QCoreApplication.translate("ArmView", "Flange")
        if self.of_tool:
            point = QCoreApplication.translate("ArmView", "Tool centre point")
        text = QCoreApplication.translate("ArmView", "{point} in “{frame}”")
        return text.format(point=point, frame=self.frame) if self.frame else point


def hud_font(base: QFont) -> QFont:
    """Return the figures' font: all digits equally wide, so that they do not jitter at 60 Hz."""
    font = QFont(base)
    font.setFeature(QFont.Tag("tnum"), 1)
    return font


def figures(values: Sequence[float] | None) -> list[str]:
    """Return six figures with three decimals, or six dashes."""
    if values is None:
        return [_NOT_HEARD] * 6
    # Adding zero turns the "-0.000" of tiny negative values into "0.000".
    return [f"{round(value, 3) + 0.0:.3f}" for value in values]


class Hud:
    """Paints the figures, caching the parts that do not change from picture to picture.

    Measuring a font and laying out text take most of the time: the frame with names and units is
    one image, and each character is measured once.
    """

    def __init__(self) -> None:
        self._base_font: QFont | None = None
        self._still_of: tuple[ScenePalette, float, str] | None = None
        self._still = QPixmap()
        self._font = QFont()
        self._metrics = QFontMetricsF(self._font)
        self._widths_px: dict[str, float] = {}
        self._is_tabular = True
        self._figures_end_px = self._column_px = 0.0

    def frame(self, base_font: QFont) -> QRectF:
        """Return the rectangle of the figures, at the top left."""
        if self._base_font != base_font:
            self._measure(base_font)
        metrics = self._metrics
        return QRectF(
            _MARGIN_PX,
            _MARGIN_PX,
            2.0 * (_PADDING_PX + self._column_px) + _GAP_PX,
            2.0 * _PADDING_PX + (1 + len(_POSE)) * metrics.height() * _LINE_SPACING,
        )

    def paint(
        self, painter: QPainter, values: HudValues, palette: ScenePalette, base_font: QFont
    ) -> None:
        """Draw both columns into their frame."""
        frame = self.frame(base_font)
        ratio = painter.device().devicePixelRatio()
        still_of = (palette, ratio, values.point)
        if self._still_of != still_of:
            self._still_of = still_of
            self._draw_still(frame, *still_of)
        painter.save()
        painter.drawPixmap(frame.topLeft(), self._still)
        painter.setFont(self._font)
        line_px = self._metrics.height() * _LINE_SPACING
        right = frame.left() + _PADDING_PX + self._figures_end_px
        top = frame.top() + _PADDING_PX + self._metrics.ascent() + line_px
        for numbers, stale in (
            (values.pose, values.pose_stale),
            (values.angles_deg, values.angles_stale),
        ):
            calm = QColor(palette.muted if stale or numbers is None else palette.text)
            for line, figure in enumerate(figures(numbers)):
                height = line <= _HEIGHT if values.frame else line == _HEIGHT
                low = values.too_low and numbers is values.pose and height
                painter.setPen(QColor(palette.warning) if low else calm)
                place = QPointF(right - self._width_px(figure), top + line * line_px)
                if self._is_tabular:
                    painter.drawText(place, figure)
                else:
                    self._draw_in_cells(painter, place, figure)
            right += self._column_px + _GAP_PX
        painter.restore()

    def quantity_at(self, place: QPointF, base_font: QFont, *, of_tool: bool) -> str | None:
        """Return the key of the figure at a place, or ``None`` if there is none.

        Args:
            place: The place in the widget.
            base_font: The font of the widget.
            of_tool: The pose shown is that of the tool centre point, not of the flange.
        """
        frame = self.frame(base_font)
        if not frame.contains(place):
            return None
        line = int(
            (place.y() - frame.top() - _PADDING_PX) / (self._metrics.height() * _LINE_SPACING)
        )
        if line == 0:
            return None  # the first line is the name of the point
        line = min(line - 1, 5)
        if place.x() < frame.center().x():
            return f"arm.{'tool' if of_tool else 'pose'}_{_POSE[line][0].lower()}"
        return f"arm.joint_angle.{line + 1}"

    def _measure(self, base_font: QFont) -> None:
        self._still_of = None
        self._font = hud_font(base_font)
        self._metrics = metrics = QFontMetricsF(self._font)
        self._base_font = QFont(base_font)
        digits_px = [metrics.horizontalAdvance(digit) for digit in _DIGITS]
        self._is_tabular = max(digits_px) - min(digits_px) < _SAME_PX
        self._widths_px = dict.fromkeys(_DIGITS, max(digits_px))
        self._figures_end_px = sum(map(metrics.horizontalAdvance, (_WIDEST_NAME, _WIDEST_FIGURE)))
        self._column_px = self._figures_end_px + metrics.horizontalAdvance(_WIDEST_UNIT)

    def _draw_in_cells(self, painter: QPainter, place: QPointF, figure: str) -> None:
        """Draw a figure; each digit gets a cell as wide as the widest, as their widths differ."""
        for character in figure:
            own_px = self._metrics.horizontalAdvance(character)
            cell_px = self._width_px(character)
            painter.drawText(place + QPointF((cell_px - own_px) / 2.0, 0.0), character)
            place += QPointF(cell_px, 0.0)

    def _width_px(self, figure: str) -> float:
        """Return the width of a figure in pixels, as `_draw_in_cells` draws it: without kerning."""
        widths_px = self._widths_px
        for character in figure:
            if character not in widths_px:
                widths_px[character] = self._metrics.horizontalAdvance(character)
        return sum(widths_px[character] for character in figure)

    def _draw_still(self, frame: QRectF, palette: ScenePalette, ratio: float, point: str) -> None:
        """Draw the frame with the names and the units."""
        self._still = QPixmap(round(frame.width() * ratio) + 1, round(frame.height() * ratio) + 1)
        self._still.setDevicePixelRatio(ratio)
        self._still.fill(Qt.GlobalColor.transparent)
        painter = QPainter(self._still)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self._font)
        backdrop = QColor(palette.background)
        backdrop.setAlphaF(_BACKDROP_OPACITY)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(backdrop)
        painter.drawRoundedRect(QRectF(QPointF(), frame.size()), 6.0, 6.0)
        painter.setPen(QColor(palette.muted))
        left = _PADDING_PX
        line_px = self._metrics.height() * _LINE_SPACING
        room_px = frame.width() - 2.0 * _PADDING_PX
        point = self._metrics.elidedText(point, Qt.TextElideMode.ElideRight, room_px)
        painter.drawText(QPointF(left, _PADDING_PX + self._metrics.ascent()), point)
        for rows in (_POSE, _JOINTS):
            baseline = _PADDING_PX + self._metrics.ascent() + line_px
            for name, unit in rows:
                painter.drawText(QPointF(left, baseline), name)
                unit_text = unit if unit == "°" else f" {unit}"
                painter.drawText(QPointF(left + self._figures_end_px, baseline), unit_text)
                baseline += line_px
            left += self._column_px + _GAP_PX
        painter.end()


def lost_text(lost: Lost) -> str:
    """Return the reason why there is no picture, and the next step."""
    reason = lost.refusal.reason
    text = QCoreApplication.translate("Refusal", reason.source).format_map(lost.refusal.params)
    if reason == NO_OPENGL:
        return text
    if lost.comes_back:
        outlook = QCoreApplication.translate("ArmView", "Restarting; the arm is not affected.")
    else:
        outlook = QCoreApplication.translate(
            "ArmView", "It ended three times within a minute; the arm is not affected."
        )
    return f"{text}\n{outlook}"


def add_again_button(view: QWidget, start_again: Callable[[], object]) -> QPushButton:
    """Add a hidden button in place of the picture, shown when it does not come back by itself."""
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
    """Paint a text in the middle, on a plate that sets it off from the picture."""
    flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    room = place.adjusted(_PLATE_MARGIN_PX, _PLATE_MARGIN_PX, -_PLATE_MARGIN_PX, -_PLATE_MARGIN_PX)
    box = QFontMetrics(painter.font()).boundingRect(room, flags, text)
    plate = QColor(palette.background)
    plate.setAlphaF(_PLATE_OPACITY)
    painter.setPen(QColor(palette.grid))
    painter.setBrush(plate)
    grown = box.adjusted(
        -_PLATE_PADDING_PX, -_PLATE_PADDING_PX, _PLATE_PADDING_PX, _PLATE_PADDING_PX
    )
    painter.drawRoundedRect(grown, 6.0, 6.0)
    painter.setPen(QColor(palette.text))
    painter.drawText(room, flags, text)


def paint_image(
    painter: QPainter, size: QSize, image: QImage | None, palette: ScenePalette, *, faded: bool
) -> None:
    """Paint the last picture, centred and in its old size until one of the new size has come.

    Args:
        painter: The painter of the widget.
        size: The size of the widget.
        image: The picture, or ``None`` while there is none.
        palette: The colours; the background shows where the picture is missing or faded.
        faded: True if the picture is not current.
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
