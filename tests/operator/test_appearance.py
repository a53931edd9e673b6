"""Whatever is seen looks the same after another theme and another language, and back."""

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication, QDialog

from armui.ui.watch.events.event_page import EventPage

pytestmark = pytest.mark.styled


def settle():
    for _ in range(3):
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


def looks():
    """Every window that is seen, as pictures."""
    settle()
    windows = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    return {each.objectName() or type(each).__name__: each.grab().toImage() for each in windows}


def assert_same(before, after):
    assert before.keys() == after.keys()
    for name, image in before.items():
        if image != after[name]:
            pairs = [
                (x, y)
                for x in range(image.width())
                for y in range(image.height())
                if image.pixel(x, y) != after[name].pixel(x, y)
            ]
            columns, rows = zip(*pairs, strict=True)
            box = (min(columns), min(rows), max(columns), max(rows))
            pytest.fail(f"{name} differs in {box}: {len(pairs)} pixels")


def there_and_back(driver):
    driver.window.setFocus()
    for events in driver.window.findChildren(EventPage):
        events.refresh()  # as its timer does, which may come between two pictures
    before = looks()
    driver.store.change(theme="dark")
    settle()
    driver.store.change(theme="light")
    assert_same(before, looks())
    driver.store.change(language="zh")
    settle()
    driver.store.change(language="en")
    assert_same(before, looks())


PANELS = ("menu_motion", "menu_gripper", "events_button", "joint_status_button")
"""Each of another make; every theme takes a second."""

DIALOGS = {
    "connect": lambda driver: driver.window.pages.show("connect"),
}


def stop_after_a_change_of_theme(driver):
    for theme in ("dark", "light"):  # the corners of cards are painted otherwise from then on
        driver.store.change(theme=theme)
        settle()
    driver.controller.emergency_stop()
    driver.run(2.0)


def test_the_window_after_a_stop(app_driver):
    app_driver.ready()
    for button in PANELS:
        app_driver.click(button)
    stop_after_a_change_of_theme(app_driver)
    for button in PANELS:
        app_driver.click(button)
        there_and_back(app_driver)


@pytest.mark.parametrize("name", DIALOGS)
def test_dialogs_after_a_stop(app_driver, name):
    app_driver.ready()
    DIALOGS[name](app_driver)
    dialog = app_driver.dialog(QDialog)
    stop_after_a_change_of_theme(app_driver)
    dialog.setFocus()
    there_and_back(app_driver)
