"""By the Tab key alone every control of the program is reached, and each says what it is."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QHeaderView,
    QLineEdit,
    QScrollBar,
    QTabBar,
    QWidget,
)

from armui.ui.actions.window_actions import WindowActions
from tests.app_driver import PANELS

pytestmark = pytest.mark.styled

CONTROLS = (
    *(QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox),
    *(QLineEdit, QTabBar),
)
PARTS = (QScrollBar, QHeaderView)
"""Of a control that is reached itself."""
QTS_OWN = ("qt_spinbox_lineedit", "qt_toolbar_ext_button", "ScrollLeftButton", "ScrollRightButton")
MOST = 600


def controls(window):
    """What can be used in a window now."""
    return [
        each
        for kind in CONTROLS
        for each in window.findChildren(kind)
        if each.isVisible()
        and each.isEnabled()
        and each.window() is window
        and not isinstance(each, PARTS)
        and each.objectName() not in QTS_OWN
        and not isinstance(each.parent(), QComboBox | QAbstractSpinBox | QLineEdit)
        and not isinstance(each.parent(), QAbstractItemView)
    ]


def walk(app_driver, window):
    """Every widget that gets the keyboard by Tab, until the first one has it again."""
    window.activateWindow()
    app_driver.wait(window.isActiveWindow)
    reached: list[QWidget] = []
    for _ in range(MOST):
        focus = QApplication.focusWidget() or window
        QTest.keyClick(focus, Qt.Key.Key_Tab)
        now = QApplication.focusWidget()
        if now is None or (reached and now is reached[0]):
            break
        assert now not in reached, f"caught at {name(now)}"
        reached.append(now)
    else:
        raise AssertionError("no end")
    return reached


def missed(window, reached):
    """The controls that Tab did not reach; of a group of choices one is enough."""
    groups = {each.group() for each in reached if isinstance(each, QAbstractButton)} - {None}
    left = []
    for each in controls(window):
        in_group = isinstance(each, QAbstractButton) and each.group() in groups
        chosen_by_arrows = in_group and each.group().exclusive()
        if each not in reached and not chosen_by_arrows:
            left.append(each)
    return left


def name(widget):
    return f"{type(widget).__name__} {widget.objectName() or widget.accessibleName()}".strip()


def unnamed(window):
    """The controls for which a screen reader has no name: neither their own nor a label's."""
    return [name(each) for each in controls(window) if not read_out(each)]


def read_out(widget):
    interface = QAccessible.queryAccessibleInterface(widget)
    return interface.text(QAccessible.Text.Name).strip()


def inspect(app_driver, window):
    reached = walk(app_driver, window)
    assert [name(each) for each in missed(window, reached)] == []
    assert unnamed(window) == []


@pytest.fixture
def ready(app_driver):
    app_driver.connect()
    app_driver.enable_by_hand()
    return app_driver


def test_in_the_window_that_has_just_opened(app_driver):
    inspect(app_driver, app_driver.window)


@pytest.mark.parametrize("panel", PANELS)
def test_in_every_panel(ready, panel):
    ready.click(f"menu_{panel}")
    ready.run_until(lambda: not ready.controller.settings.busy)
    inspect(ready, ready.window)


@pytest.mark.parametrize(
    ("panel", "first"), [("motion", "target_field_1"), ("cartesian", "pose_field_X")]
)
def test_tab_goes_from_target_to_target(ready, panel, first):
    """The steps come after the last of them, and what sends the targets after the steps."""
    ready.click(f"menu_{panel}")
    walked = [each.objectName() for each in walk(ready, ready.window)]
    begin = walked.index(first)
    fields, steps = walked[begin : begin + 6], walked[begin + 6 : begin + 18]
    assert all(each.startswith(first[:-1]) for each in fields)
    assert all("_minus_" in each or "_plus_" in each for each in steps)


def test_panels_are_chosen_by_tab_and_space(ready):
    walked = walk(ready, ready.window)
    entry = next(each for each in walked if each.objectName() == "menu_gripper")
    entry.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.keyClick(entry, Qt.Key.Key_Space)
    assert ready.find("gripper_send_button").isVisible()
    assert not ready.find("menu_motion").isChecked()


def test_while_values_are_edited(ready):
    ready.click("menu_joint_settings")
    ready.run_until(lambda: ready.find("joint_settings_edit_button").isEnabled())
    ready.click("joint_settings_edit_button")
    inspect(ready, ready.window)


def test_in_the_library_beside_the_picture(ready):
    ready.click("library_button")
    inspect(ready, ready.window)


DIALOGS = {
    "connect": lambda driver: driver.window.pages.show("connect"),
    "settings": lambda driver: driver.window.pages.show("settings"),
    "backup": lambda driver: driver.window.pages.show("backup"),
    "palette": lambda driver: actions(driver).open_palette(),
    "shortcuts": lambda driver: actions(driver).open_shortcuts(),
}


DRAWER = ("plots", "events", "bus", "sessions", "joint_status", "guide")


def actions(driver):
    return driver.window.findChild(WindowActions)


@pytest.mark.parametrize("page", DRAWER)
def test_in_the_pages_of_the_drawer(ready, page):
    ready.click("events_button")
    ready.click(f"drawer_{page}")
    ready.run(0.1)
    inspect(ready, ready.window)


@pytest.mark.parametrize("dialog", DIALOGS)
def test_in_every_window(ready, dialog):
    DIALOGS[dialog](ready)
    ready.run(0.1)
    inspect(ready, ready.dialog(QDialog))
