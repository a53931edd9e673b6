"""Buttons that open a menu."""

from pathlib import Path

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QMenu

import armui.ui
from armui.ui.widgets.buttons import give_menu, push_button


def test_a_button_is_not_lit_any_more_once_its_menu_is_put_away(qtbot):
    """The pointer is over the menu by then: nobody tells the button that it has left."""
    button = push_button("save")
    qtbot.addWidget(button)
    menu = QMenu(button)
    menu.addAction("CSV")
    give_menu(button, menu)
    button.move(300, 300)  # away from where the pointer is
    button.show()
    button.setAttribute(Qt.WidgetAttribute.WA_UnderMouse)
    menu.popup(button.mapToGlobal(QPoint(0, button.height())))
    assert button.underMouse()
    menu.hide()
    qtbot.waitUntil(lambda: not button.underMouse())
    assert QApplication.activePopupWidget() is None


def test_every_menu_is_given_to_its_button_that_way():
    sources = Path(armui.ui.__file__).parent.rglob("*.py")
    found = [each.name for each in sources if ".setMenu(" in each.read_text(encoding="utf-8")]
    assert found == ["buttons.py"]
