"""From an empty window to an enabled arm, and to a run of an imported table: presses are counted.

``python -m tests.operator.test_first_start`` says how many there are.
"""

import os
import sys
import tempfile
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import pytest
from PySide6.QtWidgets import QApplication, QDialog, QPushButton

from armui.control.link.link_state import LinkState
from armui.protocol.generation import Generation
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.table_import.columns_page import ColumnsPage
from tests.app_driver import AppDriver

PRESSES = 3
"""Connect…, Connect, Enable. No motion is recommended: the operator chooses what comes next."""

MOST_PRESSES_TO_RUN = 9
"""From the first start to a run of an imported table; the file's choice is not counted."""
JOINTS = ",".join(f"joint{joint}_deg" for joint in range(1, 7))
POINTS = f"{JOINTS}\n" + "20,40,-40,10,20,15\n-15,30,-30,-10,30,-20\n"
RECORDING = f"time_ms,{JOINTS}\n" + "".join(
    f"{20 * step},{step / 5},{40 + step / 5},{-40 - step / 5},10,20,15\n" for step in range(50)
)


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


def press_to_a_run(app_driver, folder, table):
    """Run a table of another program on an arm that was never connected; what was pressed."""
    pressed = press_what_is_lit(app_driver)

    def press(button):
        pressed.append(button.objectName())
        app_driver.click(button)
        app_driver.run(0.2)

    press(app_driver.find("library_button"))
    press(app_driver.find("library_import"))
    path = folder / "line.csv"
    path.write_text(table)
    chooser = app_driver.dialog(FileDialog)
    chooser.filesSelected.emit([str(path)])
    chooser.close()
    columns = app_driver.page(ColumnsPage)
    press(columns.import_button)
    app_driver.wait(lambda: not columns.busy)
    press(app_driver.find("run_send"))
    controller = app_driver.controller
    while not (controller.player.running or controller.replayer.running):
        assert len(pressed) < 20, pressed
        press(lit(app_driver))
    return pressed


@pytest.mark.parametrize("table", [POINTS, RECORDING])
def test_a_table_of_another_program_runs_after_few_presses(app_driver, tmp_path, table):
    controller = app_driver.controller
    pressed = press_to_a_run(app_driver, tmp_path, table)
    assert pressed[:3] == ["recovery_button", "connect_connect", "recovery_button"]
    assert pressed[3:] == [
        *("library_button", "library_import", "columns_import", "run_send"),
        "accept_warnings",  # its first point is far from where the arm is
    ]
    assert len(pressed) <= MOST_PRESSES_TO_RUN
    app_driver.run_until(lambda: not (controller.player.running or controller.replayer.running), 60)
    last = [float(each) for each in table.split()[-1].split(",")][-6:]
    assert app_driver.firmware.joints_deg == pytest.approx(last, abs=1.0)


def test_a_device_that_is_about_to_be_connected_is_not_called_missing(app_driver):
    assert "No arm is connected" in app_driver.read("recovery_text")
    app_driver.controller.expect_device()
    assert app_driver.read("recovery_text") == "The device is being opened."
    assert "Connecting…" in app_driver.find("communication_button").text()
    assert not app_driver.find("recovery_button").isVisible()
    app_driver.connect()
    assert app_driver.controller.operating_state.link is LinkState.ONLINE
    app_driver.controller.disconnect_device()
    app_driver.run(0.1)
    assert "No arm is connected" in app_driver.read("recovery_text")


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
        pressed = press_to_a_run(app_driver, Path(folder), POINTS)
        app_driver.close()
    print(f"{PRESSES} presses from the start to an enabled arm: {', '.join(pressed[:PRESSES])}")
    print(f"{len(pressed)} to a run of an imported table: {', '.join(pressed)}")


if __name__ == "__main__":
    main()
