"""Point by point with the arm: jog controls and the table at once, a key that counts everywhere."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.ui.trajectory.editor.editor_page import EditorPage
from tests.operator.library.actions import CTRL
from tests.operator.workspace.actions import rect_in_window

pytestmark = pytest.mark.styled


@pytest.fixture
def making(pages):
    """An editor with the jog controls unfolded, the arm ready."""
    pages.driver.ready()
    editor = pages.open_editor()
    pages.driver.click(editor.findChild(QWidget, "editor_jog"))
    return pages


def points(pages):
    return pages.driver.page(EditorPage).document.points


@pytest.mark.parametrize("size", [(1280, 800), (1440, 900)])
def test_jog_controls_and_table_are_seen_at_once(making, size):
    making.driver.window.resize(*size)
    editor = making.driver.page(EditorPage)
    box, table = making.driver.find("jog_box"), editor.table
    assert making.driver.window.size().toTuple() == size
    assert not rect_in_window(box).intersects(rect_in_window(table))
    assert not rect_in_window(box).intersects(rect_in_window(making.view))
    row = table.verticalHeader().defaultSectionSize()
    assert table.viewport().height() >= 3 * row
    area = rect_in_window(making.driver.find("page_area"))
    for number in range(1, 7):
        for name in ("minus", "plus", "measured"):
            assert area.contains(rect_in_window(making.driver.find(f"box_{name}_{number}")))


def test_a_point_is_made_by_jogging_and_pressing(making):
    making.driver.click("box_plus_1")
    making.driver.run_until(lambda: abs(making.driver.firmware.joints_deg[0] - 1.0) < 0.01)
    making.driver.run(0.2)
    making.driver.click("box_insert")
    assert len(points(making)) == 3
    assert points(making)[1].target[0] == pytest.approx(1.0, abs=0.01)
    assert making.driver.read("box_measured_1") == "1.000°"


def test_the_key_counts_while_a_jog_button_has_the_focus(making):
    button = making.driver.find("box_minus_2")
    button.setFocus()
    QTest.keyClick(button, Qt.Key.Key_I, CTRL)
    assert len(points(making)) == 3


def test_the_key_counts_in_the_main_window_while_the_editor_is_taken_out(making):
    making.take_out()
    making.driver.window.activateWindow()
    plus = making.driver.find("jog_plus_1")
    making.driver.wait(making.driver.window.isActiveWindow)
    plus.setFocus()
    QTest.keyClick(plus, Qt.Key.Key_I, CTRL)
    assert len(points(making)) == 3


def test_the_key_does_nothing_where_no_editor_is_seen(making):
    editor = making.driver.page(EditorPage)
    making.driver.click("menu_motion")
    QTest.keyClick(making.driver.find("jog_plus_1"), Qt.Key.Key_I, CTRL)
    assert len(editor.document.points) == 2


def test_along_the_axes_of_the_base(making):
    making.driver.click("box_base")
    making.driver.run(0.2)
    before = making.driver.controller.cartesian.tool_pose(making.driver.controller.state)
    assert making.driver.read("box_measured_3") == f"{before[2]:.3f} mm"
    assert making.driver.read("box_measured_4") == f"{before[3]:.3f}°"


def test_a_held_button_moves_until_it_is_let_go(making):
    box = making.driver.find("box_step_deg")
    box.setCurrentIndex(box.count() - 1)
    plus = making.driver.find("box_plus_1")
    making.driver.press(plus)
    making.driver.run(0.5)
    moved = making.driver.firmware.joints_deg[0]
    assert moved > 0.5
    assert making.driver.controller.jogging.active
    QTest.mouseRelease(plus, Qt.MouseButton.LeftButton)
    assert not making.driver.controller.jogging.active


@pytest.mark.parametrize("way", ["menu_motion", "page_take_out", "editor_jog"])
def test_what_is_held_is_let_go_when_the_page_goes(making, way):
    box = making.driver.find("box_step_deg")
    box.setCurrentIndex(box.count() - 1)
    making.driver.press(making.driver.find("box_plus_1"))
    making.driver.run(0.2)
    assert making.driver.controller.jogging.active
    making.driver.find(way).click()
    assert not making.driver.controller.jogging.active


def test_motors_that_are_off_are_said_at_the_buttons(pages):
    pages.driver.connect()
    editor = pages.open_editor()
    pages.driver.click(editor.findChild(QWidget, "editor_jog"))
    plus = pages.driver.find("box_plus_1")
    assert not plus.isEnabled()
    assert plus.toolTip()


def test_an_empty_trajectory_says_what_to_do_first(pages):
    pages.driver.ready()
    pages.driver.click(pages.open_library().findChild(QWidget, "library_create"))
    QTest.keyClick(pages.driver.find("library_name"), Qt.Key.Key_Return)
    editor = pages.driver.page(EditorPage)
    hint = editor.findChild(QWidget, "editor_hint")
    assert hint.isVisible()
    assert pages.driver.find("jog_box").isVisible()
    for name in ("editor_go_to", "editor_find", "editor_check"):
        button = editor.findChild(QWidget, name)
        assert not button.isEnabled()
        assert "no points" in button.toolTip()
    pages.driver.click("box_insert")
    assert editor.findChild(QWidget, "editor_check").isEnabled()
    assert editor.findChild(QWidget, "editor_check").toolTip() == "Check (Ctrl+E)"
    assert len(editor.document.points) == 1
    assert not hint.isVisible()


def test_a_jog_and_a_step_from_the_editor_have_the_speed_of_the_top_bar(making):
    driver = making.driver
    assert driver.read("box_speed") == f"{driver.controller.motion.speed_percent} %"
    driver.controller.motion.set_speed_percent(100)
    driver.run(0.1)
    box = driver.find("box_step_deg")
    box.setCurrentIndex(box.count() - 1)
    plus = driver.find("box_plus_1")
    driver.press(plus)
    driver.run(0.6)
    before = abs(driver.firmware.mechanics.speeds_deg_s[0])
    for _ in range(8):
        QTest.keyClick(driver.window, Qt.Key.Key_F8)  # ten percent less each
    assert driver.controller.motion.speed_percent == 20
    driver.run(0.2)
    assert driver.read("box_speed") == "2.6°/s"
    assert driver.controller.jogging.active
    assert 0.0 < abs(driver.firmware.mechanics.speeds_deg_s[0]) <= 0.25 * before
    QTest.mouseRelease(plus, Qt.MouseButton.LeftButton)
    driver.run(0.5)
    driver.heard()
    box.setCurrentIndex(0)
    driver.click("box_plus_1")
    driver.run(0.1)
    told = [frame.data[2] for frame in driver.heard() if frame.arbitration_id == 0x151]
    assert told
    assert set(told) == {20}
