"""An operator places the base in the room: by typing, judged by what holds, is shown and said."""

import pytest

from armui.cell.cell import Cell, placed
from armui.cell.cell_file import read_cell
from armui.cell.placement import Placement
from armui.cell.user_frames import UserFrame
from armui.protocol.generation import Generation
from armui.viewport.robot_shape import pose_rows
from tests.accepted import accepted

HANGING = Placement((0.0, 0.0, 900.0, 180.0, 0.0, 0.0))


@pytest.fixture
def panel(app_driver):
    app_driver.ready()
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench")
    app_driver.click("cell_tab_base")
    return app_driver


def hang(driver):
    driver.type_into("cell_base_Z", "900")
    driver.type_into("cell_base_RX", "180")
    driver.click("cell_base_apply")


def test_it_is_typed_applied_and_taken_back_by_presses(panel):
    assert "stands upright on the floor" in panel.read("cell_base_next")
    assert not panel.find("cell_base_apply").isEnabled()
    panel.type_into("cell_base_Z", "900")
    panel.type_into("cell_base_RX", "180")
    assert "Press Apply" in panel.read("cell_base_next")
    assert panel.controller.cell.rising == (0.0, 0.0, 1.0, 0.0)
    panel.click("cell_base_apply")
    assert panel.controller.cell.cell.placement == HANGING
    assert panel.window._view._state.camera.placement == pose_rows(HANGING.pose)
    assert read_cell(panel.library_folder / "bench.armui-cell").placement == HANGING
    assert "The frame “WORLD”" in panel.read("cell_base_next")
    panel.type_into("cell_base_Z", "0")
    panel.type_into("cell_base_RX", "0")
    panel.click("cell_base_apply")
    assert panel.controller.cell.cell == Cell("bench")
    assert panel.window._view._state.camera.placement == pose_rows((0.0,) * 6)


def test_what_is_not_possible_is_refused_with_its_figures(panel):
    panel.type_into("cell_base_Z", "9000")
    panel.click("cell_base_apply")
    assert "z_mm: 9000" in panel.read("cell_message")
    assert "5000" in panel.read("cell_message")
    assert panel.controller.cell.cell == Cell("bench")


def test_a_tilt_that_the_arm_was_not_told_is_said_where_either_is_set(panel):
    panel.type_into("cell_base_Z", "900")
    assert panel.read("cell_base_mounting") == ""
    panel.type_into("cell_base_RX", "180")
    assert "“Upside down”, which the arm was not told" in panel.read("cell_base_mounting")
    panel.click("cell_base_apply")
    panel.click("menu_end_load")
    assert "“Upside down”, which the arm was not told" in panel.read("mounting_told")
    panel.store.change(mountings={panel.device.arm_key("8"): "level"})
    panel.store.change(mountings=dict.fromkeys(_keys(panel), "level"))
    panel.click("menu_cell")
    panel.click("cell_tab_base")
    assert "told the mounting “Level”, but the cell places" in panel.read("cell_base_mounting")
    panel.type_into("cell_base_RX", "45")
    assert "no mounting fits" in panel.read("cell_base_mounting")
    panel.type_into("cell_base_RX", "0")
    assert panel.read("cell_base_mounting") == ""


def _keys(driver):
    identity = driver.controller.state.identity
    return {driver.device.arm_key("" if identity is None else identity.node_number)}


def test_poses_are_shown_in_the_room_and_its_frame_is_not_edited(panel):
    hang(panel)
    panel.click("cell_tab_frames")
    box = panel.find("cell_frame")
    box.setCurrentIndex(box.findData("WORLD"))
    box.activated.emit(box.currentIndex())
    assert panel.controller.cartesian.frame.name == "WORLD"
    panel.run(0.1)
    in_base = panel.controller.cartesian.tool_pose(panel.controller.state)
    shown = panel.controller.cartesian.in_frame(in_base)
    assert shown[2] == pytest.approx(900.0 - in_base[2])
    assert "moves with the figures under Base" in panel.read("cell_frame_next")
    assert not panel.find("cell_frame_delete").isEnabled()
    panel.type_into("cell_frame_X", "5")
    assert not panel.find("cell_frame_apply").isEnabled()
    panel.click("cell_tab_base")
    for name in ("cell_base_Z", "cell_base_RX"):
        panel.type_into(name, "0")
    panel.click("cell_base_apply")
    assert panel.controller.cartesian.frame is None


def test_the_name_of_the_room_is_refused_for_a_frame(panel):
    hang(panel)
    cell = panel.controller.cell.cell
    frame = UserFrame("World", (1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    refusal = panel.controller.cell.change(placed(Cell("bench", frames=(frame,)), cell.placement))
    assert refusal.params == {"value": "WORLD"}


def test_what_is_not_confirmed_is_drawn_pale_and_said(make_driver):
    first = make_driver(Generation.TWO)
    try:
        first.ready()
        first.click("menu_cell")
        first.type_into("cell_name", "bench")
        first.click("cell_tab_area")
        first.type_into("cell_area_name", "table")
        first.click("cell_area_plane")
        assert [shape.pale for shape in first.window._view._state.area] == [False]
    finally:
        first.close()
    later = make_driver(Generation.TWO)
    try:
        later.connect()
        later.run(0.5)
        later.click("menu_cell")
        later.click("cell_tab_area")
        assert [shape.pale for shape in later.window._view._state.area] == [True]
        assert "Not in force until the cell is confirmed" in later.read("cell_area_next")
        accepted(later.controller.cell.confirm())
        later.run(0.1)
        assert [shape.pale for shape in later.window._view._state.area] == [False]
    finally:
        later.close()
