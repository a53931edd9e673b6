import os
import re
import subprocess
import sys
from dataclasses import asdict
from itertools import product
from pathlib import Path

import pytest
from PySide6.QtGui import QColor, QFontDatabase, QFontMetricsF, QTextLayout
from PySide6.QtWidgets import QLineEdit, QMenu, QPushButton, QWidget

import armui.ui
from armui.ui import theme
from armui.ui.theme import DARK, LIGHT, Theme, apply_theme, colors_of, style_sheet, ui_font
from armui.ui.translation import Translator
from tests.each import check_each

QSS = Path(theme.__file__).with_name("theme.qss")


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


INKS = ("text", "muted", "accent", "ok", "warn", "stop_ink", "replay")
GROUNDS = ("surface", "window", "sunken", "accent_pale")
PAIRS = [
    *((ink, ground) for ink in INKS for ground in GROUNDS),
    *(("text", ground) for ground in ("warn_pale", "stop_pale", "replay_pale")),
    *(("muted", ground) for ground in ("warn_pale", "stop_pale", "replay_pale")),
    *(("warn", "warn_pale"), ("stop_ink", "stop_pale"), ("stop_ink", "warn_pale")),
    *(("on_accent", "accent"), ("on_accent", "accent_strong"), ("on_replay", "replay")),
    *(("on_stop", "stop"), ("on_stop", "stop_strong")),
]
"""What is written on what. What cannot be used now (`faint`) is exempt, as WCAG has it."""

SIGNS = [
    *((sign, ground) for sign in ("accent", "ok", "warn", "stop") for ground in GROUNDS[:2]),
    *(("accent", ground) for ground in GROUNDS),
]
"""Signs without words, and the frame of what has the keyboard."""


@pytest.mark.parametrize("colors", [LIGHT, DARK], ids=["light", "dark"])
def test_text_can_be_read(colors):
    """WCAG 2, level AA: 4.5 : 1 for text of any size."""

    def check_pair(pair):
        ink, ground = pair
        assert contrast(getattr(colors, ink), getattr(colors, ground)) >= 4.5

    check_each(PAIRS, check_pair)


@pytest.mark.parametrize("colors", [LIGHT, DARK], ids=["light", "dark"])
def test_signs_can_be_seen(colors):
    """WCAG 2, level AA: 3 : 1 for what is no text."""

    def check_pair(pair):
        sign, ground = pair
        assert contrast(getattr(colors, sign), getattr(colors, ground)) >= 3.0

    check_each(SIGNS, check_pair)


def rules():
    """Of each rule of the style sheet its selector, and the fields it takes ink and ground from."""
    text = re.sub(r"/\*.*?\*/", "", QSS.read_text(encoding="utf-8"), flags=re.DOTALL)
    for selector, body in re.findall(r"([^{}]+)\{([^{}]*)\}", text):
        ink = re.search(r"(?<![-\w])color:\s*\$(\w+)", body)
        ground = re.search(r"background(?:-color)?:\s*\$(\w+)", body)
        yield selector.strip(), ink and ink[1], ground and ground[1]


def test_the_style_sheet_writes_only_in_pairs_that_are_checked():
    known = set(PAIRS)
    for selector, ink, ground in rules():
        if ":disabled" not in selector and ink and ground:
            assert (ink, ground) in known, selector


def test_only_stop_colours_are_red():
    for colors in (LIGHT, DARK):
        for name in asdict(colors):
            color = QColor(getattr(colors, name))
            red = color.hslHue() in {*range(18), *range(342, 360)} and color.hslSaturationF() > 0.35
            assert red == (name.startswith("stop")), name


def test_the_style_sheet_knows_every_token():
    assert "$" not in style_sheet(LIGHT)
    assert LIGHT.accent_pale in style_sheet(LIGHT)


def test_theme_changes_while_running(qapp, qtbot):
    widget = QLineEdit("x")
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


@pytest.mark.parametrize("colors", [LIGHT, DARK], ids=["light", "dark"])
def test_what_a_menu_does_not_offer_is_grey(qapp, qtbot, colors):
    menu = QMenu()
    qtbot.addWidget(menu)
    menu.setStyleSheet(style_sheet(colors))
    action = menu.addAction("Delete")
    offered, menu_size = menu.grab().toImage(), menu.sizeHint()
    action.setEnabled(False)
    grey = menu.grab().toImage()
    assert menu.sizeHint() == menu_size
    ink = (colors.text, colors.faint)
    for color, picture in zip(ink, (offered, grey), strict=True):
        places = product(range(picture.width()), range(picture.height()))
        shown = {picture.pixelColor(*place).name() for place in places}
        assert [each for each in ink if QColor(each).name() in shown] == [color]


def test_a_button_without_a_background_of_its_own_knows_its_theme(qapp, qtbot):
    button = QPushButton("x")
    qtbot.addWidget(button)
    button.show()
    apply_theme(qapp, Theme.LIGHT)
    assert colors_of(button) is LIGHT
    apply_theme(qapp, Theme.DARK)
    assert colors_of(button) is DARK
    apply_theme(qapp, Theme.LIGHT)


def test_no_widget_keeps_a_colour_that_the_next_theme_takes_away():
    """Qt drops a palette that a widget was given as soon as another style sheet is set."""
    sources = Path(armui.ui.__file__).parent.rglob("*.py")
    setters = [each.name for each in sources if ".setPalette(" in each.read_text(encoding="utf-8")]
    assert setters == ["theme.py"]


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


@pytest.fixture
def translator(qapp):
    translator = Translator(qapp)
    yield translator
    translator.set_language("en")


def families_of(text):
    """The fonts that show a text."""
    layout = QTextLayout(text, ui_font())
    layout.beginLayout()
    layout.createLine()
    layout.endLayout()
    return {run.rawFont().familyName() for run in layout.glyphRuns()}


def is_chinese(family):
    return QFontDatabase.WritingSystem.SimplifiedChinese in QFontDatabase.writingSystems(family)


def test_each_language_has_its_own_font_also_for_quotation_marks(qapp, translator):
    """Those of a Chinese font are as wide as a character."""
    assert not any(map(is_chinese, families_of("The “Send” button")))
    assert any(map(is_chinese, families_of("发送")))
    translator.set_language("zh")
    assert all(map(is_chinese, families_of("“发送”按钮")))


APPLICATION = """
import sys
from PySide6 import QtWidgets
from armui.ui.theme import Theme, apply_theme, make_application
app = make_application(sys.argv[:1])
apply_theme(app, Theme.LIGHT, before_windows=True)
assert app.arguments() == sys.argv[:1], app.arguments()
print(app.style().name())
"""


def test_the_application_has_the_programs_style_whatever_the_system_wants():
    done = subprocess.run(
        [sys.executable, "-c", APPLICATION],
        env=os.environ | {"QT_STYLE_OVERRIDE": "windows", "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout.strip() == "fusion", done.stderr
