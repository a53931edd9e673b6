"""In the smallest window no page scrolls sideways: its controls go on in another line."""

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QScrollArea

from armui.ui.translation import Translator

pytestmark = pytest.mark.styled


def sideways(pages):
    """How far each area scrolls to the side."""
    for _ in range(5):
        QCoreApplication.processEvents()
    areas = pages.driver.window.findChildren(QScrollArea)
    return [each.horizontalScrollBar().maximum() for each in areas if each.isVisible()]


@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_page_scrolls_sideways(qapp, pages, language):
    translator = Translator(qapp)
    translator.set_language(language)
    try:
        pages.driver.window.resize(1024, 720)
        pages.open_library()
        assert not any(sideways(pages))
        editor = pages.open_editor()
        assert not any(sideways(pages))
        editor._actions["jog"].trigger()
        editor._find_bar.open()
        assert pages.driver.window.size().toTuple() == (1024, 720)
        assert not any(sideways(pages))
    finally:
        translator.set_language("en")
