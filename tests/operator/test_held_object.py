"""An operator at the tab of what the hand holds: by clicks, judged by what counts and is sent."""

from dataclasses import replace

import pytest

from armui.cell.cell import Cell
from armui.cell.cell_file import read_cell
from armui.cell.held_objects import HeldObject
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import AreaPlane
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.accepted import accepted
from tests.cell.areas import put
from tests.faulty_arm import HardOfHearing
from tests.operator.workspace.actions import rect_in_window

BESIDE = ("hold", "held_kind", "held_touch")
CUBE = HeldObject("cube", (0.0, 0.0, 150.0, 0.0, 0.0, 0.0), (60.0, 40.0, 40.0), mass_kg=0.6)


@pytest.fixture
def panel(app_driver):
    app_driver.ready()
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench")
    app_driver.click("cell_tab_held")
    return app_driver


def add_cube(driver):
    driver.type_into("cell_held_name", "cube")
    driver.type_into("cell_held_Z", "150")
    driver.type_into("cell_held_size_X", "60")
    driver.type_into("cell_held_mass", "0.6")
    driver.click("cell_held_add")


@pytest.mark.styled
def test_what_stands_beside_its_fields_stands_in_a_column(panel):
    def edges():
        rects = [rect_in_window(panel.find(f"cell_{each}")) for each in BESIDE]
        return {(each.left(), each.right()) for each in rects}

    panel.wait(lambda: len(edges()) == 1)


def test_it_is_added_held_and_let_go_of_by_presses(panel):
    assert "Type a name" in panel.read("cell_held_next")
    add_cube(panel)
    cells = panel.controller.cell
    assert (cells.cell.held_objects, cells.held_shape) == ((CUBE,), None)
    assert panel.find("cell_hold").text() == "It is held"
    panel.click("cell_hold")
    assert cells.cell.held == "cube"
    assert cells.held_shape is not None
    assert "counts in every check" in panel.read("cell_held_next")
    file = panel.library_folder / "bench.armui-cell"
    assert read_cell(file).held == "cube"
    assert panel.codes()[-1] == "held_now"
    panel.click("cell_held_delete")
    assert "“cube” is marked as held" in panel.read("cell_message")
    assert cells.cell.held_object == CUBE
    assert panel.find("cell_hold").text() == "Put down"
    panel.click("cell_hold")
    assert (cells.cell.held, cells.held_shape) == ("", None)


def test_it_is_held_with_the_figures_that_are_in_force(panel):
    add_cube(panel)
    panel.type_into("cell_held_mass", "0.9")
    assert "Press Apply" in panel.read("cell_held_next")
    assert not panel.find("cell_hold").isEnabled()
    assert "Press Apply first" in panel.find("cell_hold").toolTip()
    panel.click("cell_held_apply")
    panel.click("cell_hold")
    assert panel.controller.cell.cell.held_object.mass_kg == 0.9


def test_what_is_held_is_shown_first(app_driver):
    app_driver.ready()
    bench = Cell("bench", held_objects=(HeldObject("rod"), CUBE), held="cube")
    accepted(app_driver.controller.cell.take(bench))
    app_driver.click("menu_cell")
    app_driver.click("cell_tab_held")
    assert app_driver.find("cell_held_object").currentText() == "cube (held)"
    assert app_driver.find("cell_held_mass").value == 0.6


def test_its_figures_are_applied_by_a_press_also_while_it_is_held(panel):
    add_cube(panel)
    panel.click("cell_hold")
    panel.type_into("cell_held_size_Y", "wide")
    panel.click("cell_held_apply")
    assert "“cube”, size_y_mm: wide is not possible" in panel.read("cell_message")
    panel.type_into("cell_held_size_Y", "55")
    panel.type_into("cell_held_name", "brick")
    panel.click("cell_held_apply")
    held = panel.controller.cell.cell.held_object
    assert (held.name, held.size_mm) == ("brick", (60.0, 55.0, 40.0))


def test_what_it_may_touch_is_chosen_in_a_list(panel):
    put(panel.controller, AreaPlane("table", (0.0, 0.0, -200.0, 0.0, 0.0, 0.0)))
    add_cube(panel)
    (table,) = panel.find("cell_held_touch").menu().actions()
    table.trigger()
    panel.click("cell_held_apply")
    assert panel.controller.cell.cell.held_objects[0].may_touch == ("table",)


def test_the_load_is_proposed_and_told_by_a_press_alone(panel):
    panel.ear = HardOfHearing(panel.firmware)
    add_cube(panel)
    panel.click("cell_hold")
    panel.run(0.3)
    assert loads(panel) == []
    assert panel.find("cell_held_load").text() == "Tell: Half load"
    panel.click("cell_held_load")
    panel.run(0.3)
    assert loads(panel) == [Frame(0x477, bytes.fromhex("00 00 00 AE 01 00 00 00"))]
    assert "The arm has answered the end load" in panel.read("cell_message")


def loads(driver):
    """What told a load (0xAE in byte 3), as opposed to queries."""
    heard = [frame for frame in driver.ear.heard if frame.arbitration_id == 0x477]
    return [frame for frame in heard if frame.data[3] == 0xAE]


def test_after_a_restart_it_is_asked_for_with_the_cell(make_driver):
    first = make_driver(Generation.TWO)
    try:
        first.ready()
        first.click("menu_cell")
        first.type_into("cell_name", "bench")
        first.click("cell_tab_held")
        add_cube(first)
        first.click("cell_hold")
    finally:
        first.close()
    later = make_driver(Generation.TWO)
    try:
        later.connect()
        later.run(0.5)
        assert "holding “cube”" in later.read("recovery_text")
        assert later.controller.operating_state.cannot_move is not None
        assert later.controller.cell.held_shape is not None
        later.click("menu_cell")
        later.click("cell_tab_held")
        later.click("cell_hold")
        later.run(0.1)
        assert "holding" not in later.read("recovery_text")
        assert later.controller.operating_state.cannot_move is not None
        later.click("recovery_button")
        assert (later.controller.cell.confirmed, later.controller.cell.cell.held) == (True, "")
    finally:
        later.close()


def test_a_plane_is_taken_from_a_user_frame(panel):
    cells = panel.controller.cell
    pose = (100.0, -50.0, 20.0, 0.0, 0.0, 45.0)
    accepted(cells.change(replace(cells.cell, frames=(UserFrame("fixture", pose),))))
    panel.click("cell_tab_area")
    (fixture,) = panel.find("cell_area_frame").menu().actions()
    fixture.trigger()
    assert cells.cell.area.planes == ()
    panel.type_into("cell_area_name", "top")
    panel.click("cell_area_plane")
    assert cells.cell.area.planes == (AreaPlane("top", pose),)
