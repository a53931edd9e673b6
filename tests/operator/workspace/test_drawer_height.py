"""The drawer has its height in every panel, whichever was seen before."""

import pytest

from armui.ui.shell.drawer import DRAWER_PX
from tests.app_driver import PANELS

pytestmark = pytest.mark.styled


def test_no_panel_takes_the_room_of_the_drawer_in_itself_or_in_another(pages):
    pages.driver.window.resize(1440, 900)
    pages.driver.click("events_button")
    for panel in (*PANELS, *PANELS):
        pages.driver.click(f"menu_{panel}")
        pages.driver.wait(lambda: True)
        assert pages.driver.find("drawer").height() == DRAWER_PX, panel


def test_a_window_may_be_low_after_every_panel_was_seen(pages):
    for panel in PANELS:
        pages.driver.click(f"menu_{panel}")
    pages.driver.window.resize(1024, 640)
    assert pages.driver.window.height() == 640
    assert pages.driver.find("status_bar").geometry().bottom() < 640
