"""Colours, fonts and the style sheet: everything about the program's appearance.

Red means stop and fault and nothing else. Widgets that paint themselves call :func:`colors_of` at
every paint, so that a change of theme takes effect at once.
"""

from __future__ import annotations

import enum
import string
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Final

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QPalette
from PySide6.QtWidgets import QApplication, QWidget

from armui.system.files import read_file
from armui.ui.translation import shown_language

_HERE: Final = Path(__file__).parent
LIGHT_CURVES: Final = (
    *("#1763d2", "#b35c00", "#18864a", "#8a3ffc", "#00808a", "#b0257f"),
    *("#6b6b00", "#5f6b7c", "#0b3d91", "#7a4b1e", "#3f7d20", "#5b2a86"),
)
_DARK_CURVES: Final = (
    *("#5a9cff", "#f0a050", "#45c47b", "#b98cff", "#35c8d6", "#f078c0"),
    *("#cfcf50", "#98a5b6", "#9cc4ff", "#d8a878", "#a0d878", "#d0b0ff"),
)
"""The curves' colours on a dark background, without red, which means stop or fault."""
_CJK_FAMILIES: Final = (
    "Microsoft YaHei UI",
    "PingFang SC",
    "Noto Sans CJK SC",
    "Source Han Sans SC",
    "WenQuanYi Micro Hei",
)
_LATIN_FAMILIES: Final = (
    "Segoe UI",
    "Helvetica Neue",
    "Noto Sans",
    "DejaVu Sans Condensed",
    "DejaVu Sans",
    "Liberation Sans",
)
_SMALLEST_FONT_PT: Final = 10.0
_STYLE: Final = "Fusion"
_IN_STYLE: Final = "in_style"
"""The application's property that marks it as created in the style."""
_FOLLOWER: Final = "scheme_follower"
"""The application's property with the object that follows the system's colours."""


class Theme(enum.StrEnum):
    """The themes from which the operator can choose."""

    LIGHT = "light"
    DARK = "dark"
    SYSTEM = "system"


@dataclass(frozen=True, slots=True)
class Colors:
    """The colours of one theme, as ``#rrggbb``.

    Attributes:
        window: The background.
        surface: Bars, panels, fields.
        sunken: Grooves and disabled fields.
        border: Lines of one pixel.
        text, muted, faint: Main text, secondary text, disabled text.
        accent, accent_strong, accent_pale: The blue accent; its pressed state; the chosen menu
            entry.
        on_accent: Text on the accent.
        ok, warn, stop: Good; attention; stop and fault. ``…_pale`` is a background for text.
        stop_ink: Text and signs of a fault.
        on_stop: Text on the stop colour.
        replay, replay_pale, on_replay: Marks a recording as opposed to the present.
    """

    window: str
    surface: str
    sunken: str
    border: str
    text: str
    muted: str
    faint: str
    accent: str
    accent_strong: str
    accent_pale: str
    on_accent: str
    ok: str
    warn: str
    warn_pale: str
    stop: str
    stop_strong: str
    stop_pale: str
    stop_ink: str
    on_stop: str
    replay: str
    replay_pale: str
    on_replay: str


LIGHT: Final = Colors(
    window="#f3f5f8",
    surface="#ffffff",
    sunken="#e8ecf1",
    border="#d5dce5",
    text="#1a2330",
    muted="#5f6b7c",
    faint="#a3adba",
    accent="#1763d2",
    accent_strong="#114fae",
    accent_pale="#e2edfd",
    on_accent="#ffffff",
    ok="#157a43",
    warn="#9a5b00",
    warn_pale="#fff3dc",
    stop="#d3291d",
    stop_strong="#ab1e14",
    stop_pale="#fdeceb",
    stop_ink="#cf2417",
    on_stop="#ffffff",
    replay="#6a35b5",
    replay_pale="#efe7fa",
    on_replay="#ffffff",
)

DARK: Final = Colors(
    window="#11151b",
    surface="#191f27",
    sunken="#252d38",
    border="#333d4a",
    text="#e5eaf1",
    muted="#98a5b6",
    faint="#5d6979",
    accent="#5a9cff",
    accent_strong="#7fb3ff",
    accent_pale="#1b3152",
    on_accent="#071325",
    ok="#45c47b",
    warn="#f0b252",
    warn_pale="#392c13",
    stop="#d8362a",
    stop_strong="#b92d22",
    stop_pale="#401d1b",
    stop_ink="#ff6b60",
    on_stop="#ffffff",
    replay="#b48cf2",
    replay_pale="#2c2140",
    on_replay="#160b28",
)


def colors_of(widget: QWidget) -> Colors:
    """Return the colours of a widget's theme.

    They are chosen by the application's palette: the style sheet can make a widget's own
    transparent.
    """
    window = QApplication.palette(widget).color(QPalette.ColorRole.Window)
    return DARK if window.lightness() < 128 else LIGHT


def curve_colors(widget: QWidget) -> tuple[str, ...]:
    """Return the colours of curves in a widget's theme, in their order."""
    return _DARK_CURVES if colors_of(widget) is DARK else LIGHT_CURVES


def ui_font() -> QFont:
    """Return the font of the present language; digits of equal width.

    For Chinese, fonts with Chinese glyphs come first. For English, a Latin font comes before them,
    for its quotation marks: the system's if it is Latin. A language chosen later gets its font at
    the next start: Qt has crashed when the application's font was changed while windows were open.
    """
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.GeneralFont)
    if shown_language() == "zh":
        font.setFamilies([*_CJK_FAMILIES, *font.families()])
    else:
        own = font.families()
        is_latin = QFontDatabase.hasFamily(own[0]) and not _is_chinese(own[0])
        font.setFamilies([*(own if is_latin else _LATIN_FAMILIES), *_CJK_FAMILIES])
    font.setPointSizeF(max(font.pointSizeF(), _SMALLEST_FONT_PT))
    font.setFeature(QFont.Tag.fromString("tnum"), 1)
    return font


def _is_chinese(family: str) -> bool:
    chinese = QFontDatabase.WritingSystem.SimplifiedChinese
    return chinese in QFontDatabase.writingSystems(family)


def scaled_font(widget: QWidget, scale: float, *, bold: bool = False) -> QFont:
    """Return the widget's font, larger or smaller."""
    font = QFont(widget.font())
    font.setPointSizeF(font.pointSizeF() * scale)
    font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    return font


def make_application(arguments: Sequence[str]) -> QApplication:
    """Return Qt's application in the program's style.

    Setting the style later would make PySide build the class of styles, with its 566 names, at the
    start.
    """
    app = QApplication([*arguments, "-style", _STYLE])
    app.setProperty(_IN_STYLE, True)
    return app


def apply_theme(app: QApplication, theme: Theme, *, before_windows: bool = False) -> None:
    """Show the whole program in a theme.

    Args:
        app: The application; open windows change at once.
        theme: ``SYSTEM`` follows the system's colour scheme from now on.
        before_windows: Leave the style sheet for the next call, when the windows are built: Qt
            evaluates it again for a widget and its children whenever the widget gets a parent.
    """
    # a property, because searching for a child makes PySide load every class there is
    follower = app.property(_FOLLOWER)
    if follower is None:
        if not app.property(_IN_STYLE):
            app.setStyle(_STYLE)
        app.setFont(ui_font())
        follower = _SchemeFollower(app)
        app.setProperty(_FOLLOWER, follower)
    follower.show(theme, with_sheet=not before_windows)


class _SchemeFollower(QObject):
    """Paints the program anew when the system turns dark or light; lives as long as the program."""

    def __init__(self, app: QApplication) -> None:
        super().__init__(app)
        self._app = app
        self._theme = Theme.SYSTEM
        self._shown: Colors | None = None
        self._sheet: Colors | None = None
        self._with_sheet = False
        app.styleHints().colorSchemeChanged.connect(self._on_scheme_changed)

    def show(self, theme: Theme, *, with_sheet: bool) -> None:
        """Set the theme, also for the system's window frames and dialogs."""
        self._theme = theme
        self._with_sheet = self._with_sheet or with_sheet
        scheme = {
            Theme.LIGHT: Qt.ColorScheme.Light,
            Theme.DARK: Qt.ColorScheme.Dark,
            Theme.SYSTEM: Qt.ColorScheme.Unknown,
        }
        self._app.styleHints().setColorScheme(scheme[theme])
        self._paint()

    def _on_scheme_changed(self) -> None:
        if self._theme is Theme.SYSTEM:
            self._paint()

    def _paint(self) -> None:
        dark = self._theme is Theme.DARK or (
            self._theme is Theme.SYSTEM
            and self._app.styleHints().colorScheme() is Qt.ColorScheme.Dark
        )
        colors = DARK if dark else LIGHT
        if colors is not self._shown:
            self._shown = colors
            self._app.setPalette(palette(colors))
        if self._with_sheet and colors is not self._sheet:
            self._sheet = colors
            self._app.setStyleSheet(style_sheet(colors))


def palette(colors: Colors) -> QPalette:
    """Return the colours as Qt's roles, for everything that the style sheet leaves to the style."""
    role = QPalette.ColorRole
    roles = {
        role.Window: colors.window,
        role.WindowText: colors.text,
        role.Base: colors.surface,
        role.AlternateBase: colors.window,
        role.Text: colors.text,
        role.Button: colors.surface,
        role.ButtonText: colors.text,
        role.BrightText: colors.on_accent,
        role.PlaceholderText: colors.muted,
        role.ToolTipBase: colors.surface,
        role.ToolTipText: colors.text,
        role.Highlight: colors.accent,
        role.HighlightedText: colors.on_accent,
        role.Accent: colors.accent,
        role.Link: colors.accent,
        role.Light: colors.surface,
        role.Midlight: colors.sunken,
        role.Mid: colors.border,
        role.Dark: colors.faint,
        role.Shadow: colors.border,
    }
    result = QPalette()
    for color_role, color in roles.items():
        result.setColor(color_role, QColor(color))
    for color_role in (role.WindowText, role.Text, role.ButtonText):
        result.setColor(QPalette.ColorGroup.Disabled, color_role, QColor(colors.faint))
    return result


def style_sheet(colors: Colors) -> str:
    """Return the style sheet ``theme.qss`` with the colours of a theme."""
    template = string.Template(read_file(_HERE / "theme.qss").decode())
    return template.substitute(asdict(colors), icons=(_HERE / "icons").as_posix())
