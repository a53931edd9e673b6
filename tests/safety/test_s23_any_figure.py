"""S23: a figure of any size that is typed is refused where it stands, and ends no motion."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from armui.ui.panels.cell.cell_panel import TABS
from tests.app_driver import PANELS

FIGURES = ("1e9", "-1e300", "9" * 320, "nan", "-inf")


def type_everywhere(app_driver):
    """Type into each field of the panel that is shown; return how many there were."""
    app_driver.run(0.3)
    shown = app_driver.find("operation_area").currentWidget()
    fields = [each for each in shown.findChildren(QLineEdit) if each.isVisible()]
    fields = [each for each in fields if each.isEnabled() and not each.isReadOnly()]
    for field in fields:
        for figure in FIGURES:
            field.setFocus()
            field.selectAll()
            QTest.keyClicks(field, figure)
            QTest.keyClick(field, Qt.Key.Key_Return)
    app_driver.run(0.1)
    return len(fields)


def test_in_every_field_of_every_panel(app_driver):
    """An exception that nobody caught, as in a slot, fails each test with a window."""
    app_driver.ready()
    found = {}
    for panel in PANELS:
        app_driver.click(f"menu_{panel}")
        found[panel] = type_everywhere(app_driver)
    for tab in TABS:
        app_driver.click("menu_cell")
        app_driver.click(f"cell_tab_{tab.key}")
        found[tab.key] = type_everywhere(app_driver)
    assert not app_driver.find("failure_line").isVisible()
    assert found["motion"] == found["cartesian"] == 6
    assert sum(found.values()) > 50, found


def test_a_motion_goes_on(app_driver):
    arm = app_driver
    arm.ready()
    arm.type_into("target_field_1", "60")
    arm.click("send_button")
    arm.run(0.5)
    arm.type_into("target_field_2", "1e9")
    before = arm.controller.state.joints_deg[0].value
    arm.run(1.0)
    assert arm.controller.state.joints_deg[0].value > before + 5
