"""No page makes the window wider than the smallest screen: the emergency stop stays on it."""

import pytest
from PySide6.QtWidgets import QApplication

from armui.ui.shell.pages import PAGES

pytestmark = pytest.mark.styled

SMALLEST_PX = (1280, 800)


@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_page_is_wider_than_the_smallest_screen(app_driver, language):
    driver = app_driver
    driver.ready()
    driver.store.change(language=language)
    driver.window.resize(*SMALLEST_PX)
    wider = {}
    for name in PAGES:
        driver.window.pages.show(name)
        QApplication.processEvents()
        least = driver.window.minimumSizeHint()
        if least.width() > SMALLEST_PX[0] or least.height() > SMALLEST_PX[1]:
            wider[name] = (least.width(), least.height())
    assert not wider
