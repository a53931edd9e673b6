"""The menu: panels under headings, of which that of the arm's settings folds."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.protocol.generation import Generation
from armui.ui.actions.palette import CommandPalette
from tests.app_driver import AppDriver

pytestmark = pytest.mark.styled  # what fits is a matter of the real sizes

SETTINGS = (
    "light",
    "linkage",
    "joint_settings",
    "end_limits",
    "collision",
    "motor",
    "gripper_settings",
    "end_load",
)
"""The panels of the group that folds, in the manual's order."""


def is_folded(app_driver):
    shown = {app_driver.find(f"menu_{key}").isVisible() for key in SETTINGS}
    assert len(shown) == 1
    return not shown.pop()


def lower(app_driver):
    """Make the window so low that the group does not fit."""
    app_driver.window.resize(1280, 720)
    app_driver.run(0.1)


@pytest.mark.parametrize(("size", "folded"), [((1280, 720), True), ((1280, 800), False)])
@pytest.mark.parametrize("language", ["zh", "en"])
def test_the_settings_are_folded_where_they_would_not_fit(app_driver, size, folded, language):
    app_driver.store.change(language=language)
    app_driver.window.resize(*size)
    app_driver.run(0.1)
    assert is_folded(app_driver) is folded
    area = app_driver.find("side_menu_entries")
    assert area.verticalScrollBar().maximum() == 0


def test_a_low_window_keeps_the_joint_status(app_driver):
    app_driver.window.resize(1024, 720)
    app_driver.click("menu_light")
    app_driver.wait(lambda: app_driver.find("side_menu_entries").verticalScrollBar().maximum() > 0)
    status = app_driver.find("joint_status_button")
    menu = app_driver.find("side_menu")
    assert status.isVisible()
    assert menu.rect().contains(status.mapTo(menu, status.rect().bottomRight()))


def test_as_the_operator_leaves_it_so_it_stays(qapp, request, tmp_path):
    settings = tmp_path / "settings.json"
    for start in ("first", "second"):
        name = f"{request.node.nodeid}-{start}"
        app_driver = AppDriver(qapp, name, settings, Generation.TWO)
        try:
            if start == "first":
                lower(app_driver)
                assert is_folded(app_driver)
                app_driver.click("menu_fold")
            assert not is_folded(app_driver)
            app_driver.window.resize(1100, 700)
            app_driver.run(0.1)
            assert not is_folded(app_driver)
        finally:
            app_driver.window.close()
            app_driver.close()


def test_what_is_folded_is_found_and_then_shown(app_driver):
    lower(app_driver)
    assert is_folded(app_driver)
    app_driver.click("commands_button")
    palette = app_driver.dialog(CommandPalette)
    palette.search.setText("collision level")
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    app_driver.wait(lambda: app_driver.find("menu_collision").isChecked())
    assert not is_folded(app_driver)


def test_the_number_of_what_is_folded_is_said(app_driver):
    lower(app_driver)
    fold = app_driver.find("menu_fold")
    assert str(len(SETTINGS)) in fold.accessibleName()
    app_driver.click("menu_fold")
    assert str(len(SETTINGS)) not in fold.accessibleName()
