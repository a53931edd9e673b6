"""Buttons as the program uses them, and any widget with its name."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtGui import QCursor, QKeySequence
from PySide6.QtWidgets import QAbstractButton, QMenu, QPushButton, QToolButton, QWidget

from armui.ui.widgets.painting import repolish

Named = TypeVar("Named", bound=QObject)


def enable_or_explain(
    button: QAbstractButton, reason: str, use: str = "", *, key: str = ""
) -> None:
    """Let a button be pressed, or switch it off with the reason in its tooltip.

    Args:
        button: What is offered.
        reason: Why it cannot be used now; empty: it can.
        use: What it does, for the tooltip of a button that can be pressed.
        key: Its shortcut, said after that.
    """
    button.setEnabled(not reason)
    if key:
        shown = QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
        use = f"{use} ({shown})"
    button.setToolTip(reason or use)


def named(name: str, thing: Named) -> Named:
    """Give a widget its object name."""
    thing.setObjectName(name)
    return thing


def push_button(
    name: str = "", text: str = "", *, primary: bool = False, on_enter: bool | None = None
) -> QPushButton:
    """Return a button with words.

    Args:
        name: Its object name.
        text: Its words, if they are in no language.
        primary: Whether it does what the window is for.
        on_enter: Whether Enter presses it wherever in its dialog; None: as Qt decides.
    """
    button = named(name, QPushButton(text))
    if primary:
        button.setProperty("primary", True)
    if on_enter is not None:
        button.setAutoDefault(on_enter)
        button.setDefault(on_enter)
    return button


def give_menu(button: QPushButton | QToolButton, menu: QMenu) -> None:
    """Have a button open a menu, and be lit no longer than the pointer is over it.

    A menu takes the pointer away without a word to the button below, and what is chosen in it may
    open a window before the pointer is back.
    """
    button.setMenu(menu)

    def look() -> None:
        if not button.rect().contains(button.mapFromGlobal(QCursor.pos())):
            button.setAttribute(Qt.WidgetAttribute.WA_UnderMouse, False)
            button.update()

    menu.aboutToHide.connect(lambda: QTimer.singleShot(0, button, look))


def show_primary(button: QPushButton, *, wanted: bool) -> None:
    """Light a button, or let it stand back: it has something to do, or not just now."""
    if bool(button.property("primary")) != wanted:
        button.setProperty("primary", wanted)
        repolish(button)


def caption(
    button: QAbstractButton, text: str, *, tip: str = "", whose: str = "", key: str = ""
) -> None:
    """Put words on a button, which are its name for a screen reader, too.

    Args:
        button: Any.
        text: What stands on it.
        tip: What it does; left as it is where this is empty.
        whose: What the button belongs to, said before its words.
        key: Its shortcut, which other words would take from it.
    """
    button.setText(text)
    button.setAccessibleName(f"{whose}: {text}" if whose else text)
    if tip:
        button.setToolTip(tip)
    if key:
        button.setShortcut(QKeySequence(key))


def describe(widget: QWidget, name: str, tip: str = "") -> None:
    """Name a widget for a screen reader and in its tooltip, by other words if there are any."""
    widget.setAccessibleName(name)
    widget.setToolTip(tip or name)


def bar_button(name: str, *, toggles: bool = False) -> QPushButton:
    """Return a button of a bar above what a window shows; Enter elsewhere is not for it.

    Args:
        name: Its object name.
        toggles: Whether it stays down until it is pressed again.
    """
    button = push_button(name, on_enter=False)
    button.setCheckable(toggles)
    button.setProperty("toggle", toggles)
    return button


def choice_button(name: str, text: str = "") -> QToolButton:
    """Return a button that stays down when it is chosen.

    Args:
        name: Its object name.
        text: What stands on it.
    """
    button = named(name, QToolButton())
    button.setText(text)
    button.setCheckable(True)
    button.setProperty("choice", True)
    return button
