"""From an empty window to an enabled arm: what is lit is pressed, and the presses counted.

``python -m tests.operator.test_first_start`` says how many there are.
"""

import os
import sys
import tempfile
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import pytest
from PySide6.QtWidgets import QApplication, QDialog, QPushButton

from armui.protocol.generation import Generation
from tests.app_driver import AppDriver

PRESSES = 3
"""Connection…, Connect, Enable. No motion is recommended: the operator chooses what comes next."""


def lit(app_driver):
    """The one button that is lit, in the dialog in front or else in the window."""
    windows = QApplication.topLevelWidgets()
    dialogs = [each for each in windows if isinstance(each, QDialog) and each.isVisible()]
    place = dialogs[0] if dialogs else app_driver.window
    buttons = [
        button
        for button in place.findChildren(QPushButton)
        if button.property("primary") and button.isVisible() and button.isEnabled()
    ]
    assert len(buttons) <= 1, [button.objectName() or button.text() for button in buttons]
    return buttons[0] if buttons else None


def press_what_is_lit(app_driver):
    """Press until the arm may be moved; the names of what was pressed."""
    pressed: list[str] = []
    while app_driver.controller.operating_state.cannot_move is not None:
        assert len(pressed) < 20, pressed
        if app_driver.controller.operating_state.device is None:
            app_driver.wait(lambda: lit(app_driver) is not None)
        else:
            app_driver.run_until(lambda: lit(app_driver) is not None)
        button = lit(app_driver)
        pressed.append(button.objectName() or button.text())
        app_driver.click(button)
        app_driver.run(0.7)
    return pressed


def test_the_first_window_says_english_to_who_cannot_read_it(app_driver):
    app_driver.store.change(language="zh")
    app_driver.wait(lambda: app_driver.read("language_button") == "English")
    assert app_driver.find("language_button").isVisible()
    app_driver.click("language_button")
    app_driver.wait(lambda: app_driver.read("language_button") == "中文")
    assert app_driver.store.settings.language == "en"
    assert app_driver.find("settings_button").text() == "Settings"
    app_driver.connect()
    assert app_driver.find("language_button").isVisible()


def test_pressing_what_is_lit_enables_the_arm_and_lights_no_motion(app_driver):
    before = app_driver.firmware.joints_deg
    pressed = press_what_is_lit(app_driver)
    assert pressed == ["recovery_button", "connect_connect", "recovery_button"]
    assert len(pressed) == PRESSES
    app_driver.run(1.0)
    assert lit(app_driver) is None
    assert app_driver.firmware.joints_deg == pytest.approx(before, abs=0.1)


@pytest.mark.parametrize("generation", list(Generation))
def test_in_both_generations(qapp, request, tmp_path, generation):
    app_driver = AppDriver(qapp, request.node.nodeid, tmp_path / "settings.json", generation)
    try:
        assert len(press_what_is_lit(app_driver)) == PRESSES
    finally:
        app_driver.close()


def main():
    app = QApplication(sys.argv[:1])
    with tempfile.TemporaryDirectory() as folder:
        app_driver = AppDriver(app, "count", Path(folder) / "settings.json", Generation.TWO)
        pressed = press_what_is_lit(app_driver)
        app_driver.close()
    print(f"{len(pressed)} presses from the start to an enabled arm: {', '.join(pressed)}")


if __name__ == "__main__":
    main()
