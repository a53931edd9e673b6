"""Pages that share one scroll area: each is seen from its top."""

from PySide6.QtWidgets import QWidget

from armui.ui.widgets.page import Page, PageStack


def tall(key):
    page, part = Page(key), QWidget()
    part.setMinimumHeight(900)
    page.body.addWidget(part)
    return page


def test_another_page_is_seen_from_its_top(qtbot):
    pages = PageStack()
    qtbot.addWidget(pages)
    pages.resize(300, 200)
    pages.show()
    first, second = tall("first"), tall("second")
    pages.show_page(first)
    pages.show_page(second)
    bar = pages.verticalScrollBar()
    qtbot.waitUntil(lambda: bar.maximum() > 600)
    bar.setValue(500)
    pages.show_page(second)
    assert bar.value() == 500
    pages.show_page(first)
    assert bar.value() == 0
