"""The figures over the picture."""

import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter

from armui.viewport.hud import Hud, HudValues, figures, hud_font
from armui.viewport.palette import DARK, LIGHT


def test_three_decimals_always():
    assert figures((1.0, -2.5, 0.0004, -0.0004, 213.2664, 85.0)) == [
        "1.000",
        "-2.500",
        "0.000",
        "0.000",
        "213.266",
        "85.000",
    ]


def test_a_dash_for_what_was_never_heard():
    assert figures(None) == ["—"] * 6


def test_all_digits_are_equally_wide(qapp):
    metrics = QFontMetricsF(hud_font(QFont()))
    assert metrics.horizontalAdvance("111.111") == metrics.horizontalAdvance("888.888")


def paint(values: HudValues, palette=LIGHT) -> QImage:
    image = QImage(400, 250, QImage.Format.Format_RGB32)
    image.fill(QColor(palette.background))
    painter = QPainter(image)
    Hud().paint(painter, values, palette, QFont())
    painter.end()
    return image


def darkest(image: QImage) -> int:
    return min(
        QColor(image.pixel(x, y)).lightness()
        for x in range(image.width())
        for y in range(image.height())
    )


def test_stale_and_missing_figures_are_muted(qapp):
    values = (1.0,) * 6
    fresh = darkest(paint(HudValues(values, values)))
    stale = darkest(paint(HudValues(values, values, pose_stale=True, angles_stale=True)))
    missing = darkest(paint(HudValues()))
    assert fresh < stale - 30
    assert fresh < missing - 30


@pytest.mark.parametrize("palette", [LIGHT, DARK])
def test_the_figures_stay_inside_their_frame(qapp, palette):
    image = QImage(400, 250, QImage.Format.Format_RGB32)
    image.fill(QColor(palette.background))
    painter = QPainter(image)
    wide = (-1000.123,) * 6
    hud = Hud()
    hud.paint(painter, HudValues(wide, wide), palette, QFont())
    frame = hud.frame(QFont()).toAlignedRect()
    painter.end()
    background = QColor(palette.background).rgb()
    outside = [
        (x, y)
        for x in range(image.width())
        for y in range(image.height())
        if not frame.contains(x, y) and image.pixel(x, y) != background
    ]
    assert not outside


def test_what_is_kept_follows_figures_colours_and_font(qapp):
    image = QImage(400, 250, QImage.Format.Format_RGB32)
    hud, large = Hud(), QFont()
    large.setPointSizeF(2.0 * QFont().pointSizeF())
    values = HudValues((1.0,) * 6, (2.0,) * 6)
    for shown, palette, font in (
        (values, LIGHT, QFont()),
        (HudValues(), LIGHT, QFont()),
        (HudValues(), DARK, QFont()),
        (values, DARK, large),
    ):
        anew = image.copy()
        for picture, painted_by in ((image, hud), (anew, Hud())):
            picture.fill(QColor(palette.background))
            painter = QPainter(picture)
            painted_by.paint(painter, shown, palette, font)
            painter.end()
        assert image == anew


def test_figures_of_any_width_end_in_one_line(qapp):
    metrics = QFontMetricsF(hud_font(QFont()))
    hud = Hud()
    hud.frame(QFont())
    for figure in ("1.000", "-170.123", "-0000.000"):
        assert hud._width_px(figure) == pytest.approx(metrics.horizontalAdvance(figure), abs=0.5)


def test_digits_of_any_font_stand_in_cells_of_one_width(qapp, monkeypatch):
    """A font without tabular figures: «1» is narrower than «8», and no figure moves for it."""
    hud = Hud()
    hud.frame(QFont())
    assert hud._is_tabular

    class Narrow:
        def __init__(self, metrics):
            self.metrics = metrics

        def __getattr__(self, name):
            return getattr(self.metrics, name)

        def horizontalAdvance(self, text):  # noqa: N802 - Qt's name
            return self.metrics.horizontalAdvance(text) - 4.0 * text.count("1")

    monkeypatch.setattr(
        "armui.viewport.hud.QFontMetricsF", lambda font: Narrow(QFontMetricsF(font))
    )
    proportional = Hud()
    proportional.frame(QFont())
    assert not proportional._is_tabular
    assert proportional._width_px("111.111") == proportional._width_px("888.888")
    drawn: dict[str, list[QPointF]] = {}
    for text in ("-111.111", "-888.888"):
        places = drawn[text] = []
        painter = type("P", (), {"drawText": lambda _self, at, _text, into=places: into.append(at)})
        proportional._draw_in_cells(painter(), QPointF(), text)
    ends = [(places[0].x(), places[4].x()) for places in drawn.values()]
    assert ends[0] == ends[1]  # sign and decimal point


def test_a_height_below_the_base_plane_is_amber(qapp):
    values = (1.0,) * 6

    def colors(image: QImage) -> set[str]:
        places = ((x, y) for x in range(image.width()) for y in range(image.height()))
        return {QColor(image.pixel(x, y)).name() for x, y in places}

    assert LIGHT.warning not in colors(paint(HudValues(values, values)))
    assert LIGHT.warning in colors(paint(HudValues(values, values, too_low=True)))
