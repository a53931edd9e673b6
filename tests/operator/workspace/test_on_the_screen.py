"""Every window opens wholly on the screen that it opens on."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog

from armui.ui.actions.window_actions import WindowActions

pytestmark = pytest.mark.styled

WINDOWS = {
    "replay": lambda driver: driver.window.pages.show("replay"),
    "export": lambda driver: driver.window.pages.open_export(),
    "backup": lambda driver: driver.window.pages.show("backup"),
    "connect": lambda driver: driver.window.pages.show("connect"),
    "settings": lambda driver: driver.window.pages.show("settings"),
    "shortcuts": lambda driver: driver.window.findChild(WindowActions).open_shortcuts(),
}


@pytest.mark.parametrize("name", WINDOWS)
def test_every_window(pages, name):
    pages.driver.window.resize(780, 700)
    pages.driver.window.move(10, 200)
    WINDOWS[name](pages.driver)
    dialog = pages.driver.dialog(QDialog)
    reach = dialog.screen().availableGeometry().united(pages.driver.window.geometry())
    stands, least = dialog.geometry(), dialog.minimumSizeHint()
    assert reach.contains(stands.topLeft())
    reach.adjust(0, 0, 4, 4)  # the rig's windows have a frame of two pixels
    # and its screen is smaller than any that is sold
    assert stands.bottom() <= max(reach.bottom(), stands.top() + least.height())
    assert stands.right() <= max(reach.right(), stands.left() + least.width())


def test_f11_takes_the_whole_screen_and_gives_it_back(pages):
    window = pages.driver.window
    QTest.keyClick(window, Qt.Key.Key_F11)
    assert window.isFullScreen()
    QTest.keyClick(window, Qt.Key.Key_F11)
    assert not window.isFullScreen()
