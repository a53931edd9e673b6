"""Functions that create buttons and drop-down boxes, and set the names of widgets."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, TypeVar

from PySide6.QtCore import QObject, QSize, Qt, QTimer
from PySide6.QtGui import QAction, QCursor, QKeySequence
from PySide6.QtWidgets import (
    QAbstractButton,
    QButtonGroup,
    QComboBox,
    QMenu,
    QPushButton,
    QSizePolicy,
    QSpinBox,
    QToolButton,
    QWidget,
    QWidgetAction,
)

from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.painting import repolish

Named = TypeVar("Named", bound=QObject)
MARK_ICON_PX: Final = 14
"""The size of the icon of a mark in the status bar."""
_REASON: Final = "reason"
"""The property that keeps the reason against what cannot be used."""


def enable_or_explain(
    target: QWidget | QAction, reason: str, use: str = "", *, key: str = ""
) -> None:
    """Enable a button, a field or an action, or disable it with the reason in its tooltip.

    Args:
        target: The button, the field or the action.
        reason: The reason why it cannot be used now; empty if it can.
        use: Its purpose, for the tooltip of what can be used.
        key: Its shortcut, shown after that.
    """
    target.setEnabled(not reason)
    target.setProperty(_REASON, reason)
    if key:
        shown = QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
        use = f"{use} ({shown})"
    if target.toolTip() != (reason or use):  # Qt sends an event even if the text is the same
        target.setToolTip(reason or use)


def reason_against(target: QWidget | QAction) -> str:
    """Return the reason set by :func:`enable_or_explain`; "" if the target can be used."""
    return str(target.property(_REASON) or "")


def named(name: str, thing: Named) -> Named:
    """Set the object name of a widget, and return the widget."""
    thing.setObjectName(name)
    return thing


def push_button(
    name: str = "", text: str = "", *, primary: bool = False, on_enter: bool | None = None
) -> QPushButton:
    """Return a button with a text.

    Args:
        name: Its object name.
        text: Its text, if it needs no translation.
        primary: True for the main button of a window.
        on_enter: True if Enter presses it anywhere in its dialog; None lets Qt decide.
    """
    button = named(name, QPushButton(text))
    if primary:
        button.setProperty("primary", True)
    if on_enter is not None:
        button.setAutoDefault(on_enter)
        button.setDefault(on_enter)
    return button


def give_menu(button: QAbstractButton, menu: QMenu) -> None:
    """Make a button open a menu, and clear its hover state when the pointer has left.

    A menu grabs the pointer without an event for the button below, and a choice in it may open a
    window before the pointer is back.
    """
    if isinstance(button, QPushButton | QToolButton):
        button.setMenu(menu)

    def clear_hover() -> None:
        if not button.rect().contains(button.mapFromGlobal(QCursor.pos())):
            button.setAttribute(Qt.WidgetAttribute.WA_UnderMouse, False)
            button.update()

    menu.aboutToHide.connect(lambda: QTimer.singleShot(0, button, clear_hover))


def fold_into(button: QToolButton, *widgets: QWidget) -> None:
    """Make a button open a panel of widgets below it, which stays open while they are used."""
    menu, room = QMenu(button), QWidget()
    in_column(*widgets, on=room, spacing=6, margins=10)
    panel = QWidgetAction(menu)
    panel.setDefaultWidget(room)
    menu.addAction(panel)
    give_menu(button, menu)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)


def show_primary(button: QAbstractButton, *, wanted: bool) -> None:
    """Highlight a button or not, depending on whether it has something to do."""
    if bool(button.property("primary")) != wanted:
        button.setProperty("primary", wanted)
        repolish(button)


def caption(
    button: QAbstractButton, text: str, *, tip: str = "", whose: str = "", key: str = ""
) -> None:
    """Set the text of a button, which is its name for a screen reader, too.

    Args:
        button: The button.
        text: The text.
        tip: The tooltip; unchanged if empty.
        whose: The name of what it belongs to, read before its text.
        key: Its shortcut, which a new text would remove.
    """
    button.setText(text)
    button.setAccessibleName(f"{whose}: {text}" if whose else text)
    if tip:
        button.setToolTip(tip)
    if key:
        button.setShortcut(QKeySequence(key))


def describe(widget: QWidget, name: str, tip: str = "") -> None:
    """Set a widget's name for a screen reader, and its tooltip, by default the same."""
    widget.setAccessibleName(name)
    widget.setToolTip(tip or name)


def bar_button(name: str, *, toggles: bool = False) -> QPushButton:
    """Return a button of a bar; Enter elsewhere does not press it.

    Args:
        name: Its object name.
        toggles: True if it stays down until it is pressed again.
    """
    button = push_button(name, on_enter=False)
    button.setCheckable(toggles)
    button.setProperty("toggle", toggles)
    return button


def drop_down(name: str) -> QComboBox:
    """Return a drop-down box that is as wide as its widest entry in every language.

    Args:
        name: Its object name.
    """
    box = named(name, QComboBox())
    box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
    return box


def spin_box(least: int, most: int, unit: str = "", *, step: int = 1) -> QSpinBox:
    """Return a box for a whole number, which is centred in it.

    Args:
        least: The smallest number allowed.
        most: The greatest number allowed.
        unit: What is shown after it, with its space.
        step: How far an arrow changes it.
    """
    box = QSpinBox(minimum=least, maximum=most, suffix=unit, singleStep=step)
    box.setAlignment(Qt.AlignmentFlag.AlignCenter)
    return box


def show_as_mark(button: QToolButton) -> None:
    """Show a button as a mark of the status bar, which keeps its height."""
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    button.setIconSize(QSize(MARK_ICON_PX, MARK_ICON_PX))
    button.setAutoRaise(True)
    button.setProperty("narrow", True)
    button.setFixedHeight(button.fontMetrics().height())


def choice_group(owner: QWidget, names: Iterable[str], first: int = 0) -> QButtonGroup:
    """Return buttons of which one is chosen, the first one at first; they share the room of a row.

    Args:
        owner: The widget that the group belongs to.
        names: Their object names.
        first: The number of the first one; the others follow it.
    """
    group = QButtonGroup(owner)
    for number, name in enumerate(names, first):
        button = choice_button(name)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        group.addButton(button, number)
    group.button(first).setChecked(True)
    return group


def choice_button(name: str, text: str = "") -> QToolButton:
    """Return a button that stays down when it is chosen.

    Args:
        name: Its object name.
        text: The text.
    """
    button = named(name, QToolButton())
    button.setText(text)
    button.setCheckable(True)
    button.setProperty("choice", True)
    return button
