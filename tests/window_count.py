"""Count what the window shows at once: ``python -m tests.window_count``.

A window that asks for less attention shows fewer controls, figures and words. The measure is taken
on the real window with the simulated arm: connected and enabled, the motion panel, 1440×900, in
Chinese. The message of the moment is left out.
"""

from __future__ import annotations

import os
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Final

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QScrollBar,
    QToolButton,
    QWidget,
)

from armui.protocol.generation import Generation
from armui.ui.shell.recovery_line import RecoveryLine
from armui.ui.theme import make_application
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import ValueLabel
from armui.viewport.view import ArmView
from tests.app_driver import AppDriver

SIZE: Final = (1440, 900)
_CONTROLS: Final = (QAbstractButton, QAbstractSlider, QAbstractSpinBox, QComboBox, QLineEdit)
_COMPOUND: Final = (QAbstractSpinBox, QComboBox)
"""Each counts once, its inner field and arrows do not."""
_MOMENT: Final = (RecoveryLine, MessageLine)
"""What is said in them changes from moment to moment."""
_FIGURE: Final = re.compile(r"[≥≤]?\s*[-−+]?\d+(\.\d+)?\s*((°|mm)(/s)?|%)?")
_PAINTED_FIGURES: Final = 12
"""Pose and joint angles over the picture, each with its name."""


@dataclass(frozen=True, slots=True)
class WindowCount:
    """What a window shows.

    Attributes:
        controls: Buttons, sliders, boxes and fields, enabled or not.
        figures: Values with or without unit, those over the picture included.
        words: Texts that are no figures.
    """

    controls: tuple[str, ...]
    figures: tuple[str, ...]
    words: tuple[str, ...]

    def __str__(self) -> str:
        """Return the three numbers."""
        return (
            f"{len(self.controls)} controls, {len(self.figures)} figures, {len(self.words)} words"
        )


def count(window: QWidget) -> WindowCount:
    """Count what is visible in a window."""
    controls: list[str] = []
    figures: list[str] = []
    words: list[str] = []
    for widget in window.findChildren(QWidget):
        if not widget.isVisible() or _is_part(widget) or isinstance(widget, QScrollBar):
            continue
        if isinstance(widget, _CONTROLS):
            controls.append(widget.objectName() or type(widget).__name__)
        if isinstance(widget, ArmView):
            figures += [f"{number} over the picture" for number in range(_PAINTED_FIGURES)]
            words += ("X", "Y", "Z", "RX", "RY", "RZ", "J1", "J2", "J3", "J4", "J5", "J6")
        text = _text(widget)
        if text:
            (figures if _FIGURE.fullmatch(text) else words).append(text)
    return WindowCount(tuple(controls), tuple(figures), tuple(words))


def _is_part(widget: QWidget) -> bool:
    """Return whether a widget belongs to a box or to the message of the moment."""
    parent = widget.parentWidget()
    while parent is not None and not parent.isWindow():
        if isinstance(parent, (*_COMPOUND, *_MOMENT)):
            return True
        parent = parent.parentWidget()
    return isinstance(widget, _MOMENT) or widget.objectName() == "notice_label"


def _text(widget: QWidget) -> str:
    if isinstance(widget, QComboBox):
        return widget.currentText().strip()
    if isinstance(widget, (QLabel, ValueLabel, QLineEdit, QAbstractButton, QAbstractSpinBox)):
        text = widget.text().strip()
        return "" if _is_icon(widget) or (len(text) == 1 and not text.isalnum()) else text
    return ""


def _is_icon(widget: QWidget) -> bool:
    icon_only = Qt.ToolButtonStyle.ToolButtonIconOnly
    return isinstance(widget, QToolButton) and (
        widget.toolButtonStyle() is icon_only and not widget.icon().isNull()
    )


def motion_panel(app: QApplication, settings: Path) -> dict[str, WindowCount]:
    """Open the program, connect and enable the simulated arm, and count.

    Args:
        app: Qt's application.
        settings: The file of the operator's settings.

    Returns:
        The counts with the group of the arm's settings open, and folded.
    """
    driver = AppDriver(app, "window-count", settings, Generation.TWO, draws=True)
    try:
        driver.store.change(language="zh", theme="light")
        driver.window.resize(*SIZE)
        driver.connect()
        driver.enable_by_hand()
        driver.run(0.5)
        counts = {"open": count(driver.window)}
        driver.click("menu_fold")
        return {**counts, "folded": count(driver.window)}
    finally:
        driver.close()


def main() -> None:
    """Print the numbers, and what was counted."""
    app = make_application([])
    with tempfile.TemporaryDirectory() as folder:
        for name, found in motion_panel(app, Path(folder) / "settings.json").items():
            print(f"{name}: {found}")
            for part in ("controls", "figures", "words"):
                print(f"  {part}: {', '.join(getattr(found, part))}")


if __name__ == "__main__":
    main()
