"""A widget that moves to another layout leaves nothing behind that PySide takes for alive.

When a filled layout is added to another, PySide makes a Python object for each of its items. When
an item's widget moves, Qt deletes the item, which PySide does not notice: it takes the next Qt
object at the same address for the item, and the program crashes when that object ends.
"""

import gc

import pytest
import shiboken6
from PySide6.QtWidgets import QApplication, QLayout, QWidgetItem

from armui.ui.shell.pages import PAGES
from tests.app_driver import PANELS
from tests.operator.editor.actions import BACK, OUT, UP, Editor, to

pytestmark = pytest.mark.styled

HIGH_PX, LOW_PX = (1280, 900), (1024, 640)


def items_left_behind(window):
    """The widgets of which a layout has an item that Qt has deleted."""
    # findChildren would make Python objects of Qt's own layouts, too
    layouts = [
        each
        for each in shiboken6.getAllValidWrappers()
        if isinstance(each, QLayout) and window.isAncestorOf(each.parentWidget())
    ]
    known = [
        (layout, shiboken6.getCppPointer(item))
        for layout in layouts
        for item in gc.get_referents(layout)
        if type(item) is QWidgetItem
    ]
    alive = {
        shiboken6.getCppPointer(item)
        for layout in layouts
        for item in map(layout.itemAt, range(layout.count()))
        if item is not None
    }
    return [layout.parentWidget() for layout, address in known if address not in alive]


def test_none_is_left_behind_where_room_comes_and_goes(app_driver):
    app_driver.ready()
    window = app_driver.window
    Editor(app_driver, to(OUT), to(BACK), to(UP)).child("editor_jog").click()
    for language, size in (("zh", LOW_PX), ("en", HIGH_PX), ("zh", LOW_PX)):
        window.resize(*size)
        app_driver.store.change(language=language)
        QApplication.processEvents()
    for panel in PANELS:
        app_driver.click(f"menu_{panel}")
        for size in (LOW_PX, HIGH_PX):
            window.resize(*size)
            QApplication.processEvents()
    for page in PAGES:
        window.pages.show(page)
    window.resize(*LOW_PX)
    QApplication.processEvents()
    assert items_left_behind(window) == []
