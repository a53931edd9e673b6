import pytest
from PySide6.QtGui import QColor, QFontMetricsF
from PySide6.QtWidgets import QPushButton, QWidget

from armui.ui.theme import DARK, LIGHT, Theme, apply_theme, colors_of, style_sheet, ui_font


def luminance(color: str) -> float:
    def linear(part: float) -> float:
        return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4

    rgb = QColor(color)
    return (
        0.2126 * linear(rgb.redF()) + 0.7152 * linear(rgb.greenF()) + 0.0722 * linear(rgb.blueF())
    )


def contrast(one: str, other: str) -> float:
    bright, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (bright + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("colors", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize(
    ("ink", "ground"),
    [
        ("text", "surface"),
        ("text", "window"),
        ("muted", "surface"),
        ("muted", "window"),
        ("accent", "accent_pale"),
        ("on_accent", "accent"),
        ("text", "warn_pale"),
        ("text", "stop_pale"),
        ("warn", "warn_pale"),
        ("on_stop", "stop"),
        ("on_replay", "replay"),
        ("text", "replay_pale"),
        ("replay", "window"),
    ],
)
def test_text_can_be_read(colors, ink, ground):
    # 4.5 : 1 is what WCAG 2 asks of text of ordinary size; the stop's word is large: 3 : 1
    least = 3.0 if ink == "on_stop" else 4.5
    assert contrast(getattr(colors, ink), getattr(colors, ground)) >= least


def test_only_stop_colours_are_red():
    for colors in (LIGHT, DARK):
        for name in colors._fields:
            color = QColor(getattr(colors, name))
            red = color.hslHue() in {*range(18), *range(342, 360)} and color.hslSaturationF() > 0.35
            assert red == (name.startswith("stop")), name


def test_the_style_sheet_knows_every_token():
    assert "$" not in style_sheet(LIGHT)
    assert LIGHT.accent_pale in style_sheet(LIGHT)


def test_theme_changes_while_running(qapp, qtbot):
    widget = QPushButton("x")
    qtbot.addWidget(widget)
    widget.show()
    apply_theme(qapp, Theme.LIGHT)
    assert colors_of(widget) is LIGHT
    light = widget.grab().toImage().pixelColor(8, 8)
    apply_theme(qapp, Theme.DARK)
    assert colors_of(widget) is DARK
    dark = widget.grab().toImage().pixelColor(8, 8)
    assert light.lightness() > 200 > 100 > dark.lightness()
    apply_theme(qapp, Theme.LIGHT)


def test_system_theme_follows_the_system(qapp, qtbot):
    widget = QWidget()
    qtbot.addWidget(widget)
    widget.show()
    apply_theme(qapp, Theme.DARK)
    apply_theme(qapp, Theme.SYSTEM)
    # the off-screen platform has no scheme of its own: that is light
    assert colors_of(widget) is LIGHT


def test_figures_are_of_one_width(qapp):
    metrics = QFontMetricsF(ui_font())
    assert len({metrics.horizontalAdvance(digit * 10) for digit in "0123456789"}) == 1
