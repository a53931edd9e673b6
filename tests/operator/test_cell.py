"""An operator at the panel 单元: cells and tools by clicking, judged by what then holds."""

import json
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.cell.cell import Cell
from armui.cell.cell_file import read_cell, to_text
from armui.cell.held_objects import HeldObject
from armui.cell.tools import Tool
from armui.cell.work_area import Area, AreaBox
from armui.kinematics.axes import AXES
from armui.protocol.generation import Generation
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.panels.cell.cell_panel import CellPanel
from armui.ui.widgets.figure_field import FigureField
from tests.accepted import accepted
from tests.app_driver import Slow

PEN = Tool("pen", (0.0, 0.0, 120.0, 0.0, 0.0, 0.0), 15.0)

NO_CELL = "No cell is chosen. Choose one in the list, or enter a name and press New."


@pytest.fixture
def panel(app_driver):
    app_driver.ready()
    app_driver.click("menu_cell")
    return app_driver


def file_of(driver, name):
    return driver.library_folder / f"{name}.armui-cell"


def add_pen(driver):
    driver.type_into("cell_tool_name", "pen")
    driver.type_into("cell_tool_Z", "120")
    driver.type_into("cell_tool_radius", "15")
    driver.click("cell_tool_add")
    choose(driver, "cell_tool", 1)


def test_a_cell_and_a_tool_are_made_and_hold_at_once(panel):
    assert panel.read("cell_tool_next") == NO_CELL
    panel.type_into("cell_name", "bench")
    assert "Type a name for the tool" in panel.read("cell_tool_next")
    add_pen(panel)
    assert panel.controller.cartesian.tool == PEN.pose
    assert "This tool is in force" in panel.read("cell_tool_next")
    assert read_cell(file_of(panel, "bench")) == Cell("bench", (PEN,), "pen")
    assert panel.store.settings.cells == {panel.device.arm_key(): "bench"}
    panel.click("menu_cartesian")
    assert panel.read("point_label") == "Tool centre point: pen"


def test_a_tool_that_is_added_is_in_force_once_it_is_chosen(panel):
    panel.type_into("cell_name", "bench")
    panel.type_into("cell_tool_name", "pen")
    assert "in force once it is chosen" in panel.read("cell_tool_next")
    panel.type_into("cell_tool_Z", "120")
    panel.click("cell_tool_add")
    assert panel.controller.cell.cell.tool == ""
    assert panel.controller.cartesian.tool == (0.0,) * 6
    assert "“pen” is added" in panel.read("cell_tool_next")
    choose(panel, "cell_tool", 1)
    assert panel.controller.cartesian.tool == PEN.pose


def test_the_figures_are_applied_by_a_press_and_no_sooner(panel):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    panel.type_into("cell_tool_X", "12.5")
    assert panel.controller.cartesian.tool == PEN.pose
    assert "Press Apply" in panel.read("cell_tool_next")
    panel.click("cell_tool_apply")
    assert panel.controller.cartesian.tool == (12.5, 0.0, 120.0, 0.0, 0.0, 0.0)
    panel.type_into("cell_tool_X", "far")
    panel.click("cell_tool_apply")
    assert "“pen”, x_mm: far is not possible" in panel.read("cell_message")
    assert panel.controller.cartesian.tool == (12.5, 0.0, 120.0, 0.0, 0.0, 0.0)


def test_the_bare_flange_and_another_tool_are_chosen_in_the_list(panel):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    choose(panel, "cell_tool", 0)
    assert panel.controller.cartesian.tool == (0.0,) * 6
    choose(panel, "cell_tool", 1)
    assert panel.controller.cartesian.tool == PEN.pose
    before = panel.controller.cell.cell
    panel.click("cell_tool_delete")
    assert panel.controller.cell.cell == Cell("bench")
    assert not panel.find("cell_tool_delete").isVisible()
    panel.click("cell_tool_restore")
    assert panel.controller.cell.cell == before  # and in force, as it was
    panel.click("cell_tool_delete")
    add_pen(panel)
    assert not panel.find("cell_tool_restore").isVisible()


def test_what_is_switched_off_in_the_work_area_is_not_called_in_force(panel):
    panel.type_into("cell_name", "bench")
    panel.click("cell_tab_area")
    panel.type_into("cell_area_name", "crate")
    panel.type_into("cell_area_X", "900")
    panel.click("cell_area_box")
    assert "It is in force" in panel.read("cell_area_next")
    panel.click("cell_area_switch")
    off = "It is off and counts for nothing. Switch it on to put it in force."
    assert panel.read("cell_area_next") == off
    panel.type_into("cell_area_X", "950")
    assert panel.read("cell_area_next") == off
    panel.click("cell_area_switch")
    assert "It is off" not in panel.read("cell_area_next")


def choose(driver, name, place):
    """Choose an entry of a list as a click does."""
    box = driver.find(name)
    box.setCurrentIndex(place)
    box.activated.emit(place)


def test_the_tool_typed_before_becomes_the_first_of_a_new_cell(panel):
    panel.store.change(tool=(0.0, 0.0, 90.0, 0.0, 0.0, 0.0))
    panel.type_into("cell_name", "bench")
    assert panel.controller.cell.cell.tools == (Tool("Tool", (0.0, 0.0, 90.0, 0.0, 0.0, 0.0)),)
    choose(panel, "cell_box", 0)
    assert panel.read("cell_tool_next") == NO_CELL
    assert panel.controller.cartesian.tool == (0.0, 0.0, 90.0, 0.0, 0.0, 0.0)


def test_a_kept_cell_is_confirmed_in_the_line_of_the_next_step(make_driver):
    first = make_driver(Generation.TWO)
    try:
        first.ready()
        first.click("menu_cell")
        first.type_into("cell_name", "bench")
        add_pen(first)
    finally:
        first.close()
    later = make_driver(Generation.TWO)
    try:
        later.connect()
        later.run(0.5)
        assert later.controller.cartesian.tool == (0.0,) * 6
        assert "“bench”" in later.read("recovery_text")
        later.click("recovery_button")
        assert later.controller.cartesian.tool == PEN.pose
    finally:
        later.close()


def test_a_broken_file_is_told_and_its_cell_is_not_used(make_driver, tmp_path):
    folder = tmp_path / "trajectories"
    folder.mkdir()
    (folder / "torn.armui-cell").write_text("{", encoding="utf-8")
    driver = make_driver(Generation.TWO)
    try:
        assert "cell_problem" in driver.codes()
        driver.ready()
        driver.click("menu_cell")
        choose(driver, "cell_box", 1)
        assert "broken or cut short" in driver.read("cell_message")
        assert driver.controller.cell.cell is None
        assert (folder / "torn.armui-cell").read_text(encoding="utf-8") == "{"
    finally:
        driver.close()


def test_an_import_says_what_is_different_before_it_takes_over(panel, tmp_path):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    entries = json.loads(to_text(panel.controller.cell.cell))
    entries["tools"][0]["z_mm"] = 121.5
    theirs = tmp_path / "bench.armui-cell"
    theirs.write_text(json.dumps(entries), encoding="utf-8")
    imported = panel.window.findChild(CellPanel)._on_read
    panel.controller.cell.store.read(theirs, imported)
    question = panel.dialog(ConfirmDialog)
    assert "tools.pen.z_mm: 120 → 121.5" in question._text.text()
    assert panel.controller.cartesian.tool == PEN.pose
    panel.confirm()
    assert panel.controller.cartesian.tool[2] == 121.5


def test_a_broken_import_is_refused_and_what_was_stays(panel, tmp_path):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    theirs = tmp_path / "bench.armui-cell"
    theirs.write_text(to_text(Cell("bench", (PEN,), "pen"))[:90], encoding="utf-8")
    panel.controller.cell.store.read(theirs, panel.window.findChild(CellPanel)._on_read)
    assert "broken or cut short" in panel.read("cell_message")
    assert panel.controller.cell.cell == Cell("bench", (PEN,), "pen")


def test_a_cell_is_deleted_once_the_question_is_answered(panel):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    panel.click("cell_manage_button")
    panel.click("cell_delete_button")
    assert file_of(panel, "bench").exists()
    panel.confirm()
    assert not file_of(panel, "bench").exists()
    assert panel.controller.cell.cell is None


def test_a_slow_disk_holds_nobody_and_a_failure_is_told(make_driver):
    driver = make_driver(Generation.TWO, files=Slow())
    try:
        driver.ready()
        driver.click("menu_cell")
        driver.type_into("cell_name", "bench")
        assert driver.controller.cell.cell == Cell("bench")
        driver.library_folder.write_text("in the way", encoding="utf-8")
        driver.program._files.work()
        assert "cell_problem" in driver.codes()
    finally:
        driver.close()


def test_a_cell_is_renamed_with_its_file_and_for_its_arm(panel):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    panel.click("cell_manage_button")
    panel.find("cell_name").setText("stand")
    panel.find("cell_name").textEdited.emit("stand")
    panel.click("cell_rename_button")
    assert panel.controller.cell.cell == Cell("stand", (PEN,), "pen")
    assert not file_of(panel, "bench").exists()
    assert read_cell(file_of(panel, "stand")) == Cell("stand", (PEN,), "pen")
    assert panel.store.settings.cells == {panel.device.arm_key(): "stand"}
    assert panel.controller.cartesian.tool == PEN.pose
    panel.type_into("cell_tool_X", "3")
    panel.click("cell_tool_apply")
    assert read_cell(file_of(panel, "stand")).chosen_tool.pose[0] == 3.0


def test_no_file_is_overwritten_by_a_new_name(panel):
    panel.type_into("cell_name", "bench")
    theirs = to_text(Cell("stand", (PEN,), "pen"))
    file_of(panel, "stand").write_text(theirs, encoding="utf-8")
    panel.click("cell_manage_button")
    panel.find("cell_name").setText("stand")
    panel.find("cell_name").textEdited.emit("stand")
    panel.click("cell_rename_button")
    assert "was not overwritten" in panel.read("cell_message")
    assert file_of(panel, "stand").read_text(encoding="utf-8") == theirs
    assert read_cell(file_of(panel, "bench")) == panel.controller.cell.cell == Cell("bench")
    assert panel.store.settings.cells == {panel.device.arm_key(): "bench"}
    panel.type_into("cell_name", "other")
    panel.find("cell_name").setText("BENCH")
    panel.find("cell_name").textEdited.emit("BENCH")
    panel.click("cell_rename_button")
    assert "exists already" in panel.read("cell_message")


def test_it_is_compared_with_another_of_the_list(panel):
    panel.type_into("cell_name", "other")
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    panel.click("cell_manage_button")
    menu = panel.find("cell_compare_button").menu()
    menu.aboutToShow.emit()
    (other,) = menu.actions()
    other.trigger()
    question = panel.dialog(ConfirmDialog)
    assert "tools.pen.z_mm: 120 → —" in question._text.text()
    panel.confirm()
    assert panel.controller.cell.cell == Cell("other")


def test_add_and_apply_say_why_they_have_no_use(panel):
    panel.type_into("cell_name", "bench")
    assert panel.find("cell_tool_add").toolTip() == "Type a name first."
    add_pen(panel)
    add, apply = panel.find("cell_tool_add"), panel.find("cell_tool_apply")
    assert "exists already" in add.toolTip()
    assert (add.isEnabled(), apply.isEnabled()) == (False, False)
    assert apply.toolTip() == "Nothing is changed."
    panel.type_into("cell_tool_name", "pencil")
    assert (add.isEnabled(), apply.isEnabled()) == (True, True)


def test_what_went_well_is_told_in_the_status_bar_alone(panel):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    assert panel.codes()[-1] == "cell_changed"
    assert panel.read("cell_message") == ""


def test_the_cell_is_confirmed_where_enable_stands_and_a_double_click_does_not_do_both(make_driver):
    first = make_driver(Generation.TWO)
    try:
        first.ready()
        first.click("menu_cell")
        first.type_into("cell_name", "bench")
        add_pen(first)
    finally:
        first.close()
    later = make_driver(Generation.TWO)
    try:
        later.connect()
        later.run(0.5)
        button = later.find("recovery_button")
        assert button.text() == "Confirm cell"
        before = button.geometry()
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)
        QTest.mouseDClick(button, Qt.MouseButton.LeftButton)
        later.run(0.5)
        assert button.text() == "Enable"
        assert button.geometry().right() == before.right()
        assert later.controller.cell.unconfirmed is None
        assert later.controller.motors.busy is None
    finally:
        later.close()


def test_what_is_done_with_cells_is_folded_away_while_there_is_one(panel):
    assert panel.find("cell_name").isVisible()
    panel.type_into("cell_name", "bench")
    assert not panel.find("cell_name").isVisible()
    panel.click("cell_manage_button")
    assert panel.find("cell_rename_button").isVisible()
    panel.click("cell_manage_button")
    assert not panel.find("cell_delete_button").isVisible()


def test_the_palette_unfolds_what_is_folded_away(panel):
    panel.type_into("cell_name", "bench")
    items = panel.window.window_actions.palette_items()
    (delete,) = [each for each in items.now() if each.command.name == "cell.delete"]
    assert (delete.seen, delete.reason) == (True, "")
    items.carry_out(delete, was_seen=True)
    assert panel.find("cell_delete_button").isVisible()
    assert panel.controller.cell.cell == Cell("bench")


def test_the_arm_is_jogged_beside_the_search_for_a_tip(panel):
    panel.type_into("cell_name", "bench")
    panel.click("cell_tool_by_points")
    panel.click("cell_jog_button")
    before = panel.firmware.joints_deg[0]
    panel.click("box_plus_1")
    panel.run(1.5)
    assert panel.firmware.joints_deg[0] - before == pytest.approx(1.0, abs=0.1)
    panel.click("tip_take")
    assert "Pose 1 of at least 4 is taken" in panel.read("tip_next")
    panel.click("cell_jog_button")
    assert not panel.find("box_plus_1").isVisible()


@pytest.mark.parametrize(
    ("tab", "way", "take"),
    [
        ("tools", "cell_tool_by_points", "tip_take"),
        ("frames", "cell_frame_by_points", "frame_take_1"),
    ],
)
def test_without_a_cell_no_pose_is_taken(panel, tab, way, take):
    panel.click(f"cell_tab_{tab}")
    panel.click(way)
    button = panel.find(take)
    assert (button.isEnabled(), button.toolTip()) == (False, NO_CELL)
    assert not button.property("primary")
    panel.type_into("cell_name", "bench")
    panel.run_until(button.isEnabled)
    assert button.property("primary")


def figures_of(panel):
    return [panel.read(f"cell_area_{axis}") for axis in AXES]


@pytest.mark.parametrize("tab", ["tools", "frames", "area", "held", "base"])
def test_the_figures_of_a_pose_have_units(panel, tab):
    panel.click(f"cell_tab_{tab}")
    part = tab.rstrip("s")
    units = [panel.find(f"cell_{part}_{axis}").unit for axis in AXES]
    assert units == ["mm"] * 3 + ["°"] * 3


def test_what_halts_is_not_called_a_stop(panel):
    panel.click("cell_tab_area")
    halts = panel.find("cell_area_stops")
    assert halts.text() == "Halt when a hand or another program enters"
    assert "stop" not in halts.toolTip().lower()


def test_a_box_of_which_no_place_is_typed_stands_in_front_of_the_arm(panel):
    panel.type_into("cell_name", "bench")
    panel.click("cell_tab_area")
    assert figures_of(panel) == ["450.000", "0.000", "50.000", "0.000", "0.000", "0.000"]
    panel.type_into("cell_area_name", "crate")
    panel.click("cell_area_box")
    (crate,) = panel.controller.cell.cell.area.boxes
    assert crate.pose == (450.0, 0.0, 50.0, 0.0, 0.0, 0.0)
    assert panel.find("cell_area_X").value == 450.0


@pytest.mark.parametrize(
    ("turned", "side"),
    [
        ({}, "below it"),
        ({"RX": "180"}, "above it"),
        ({"RY": "90"}, "beyond it, towards −X of the base"),
        ({"RX": "90"}, "beyond it, towards +Y of the base"),
    ],
)
def test_a_plane_says_which_side_is_forbidden(panel, turned, side):
    panel.type_into("cell_name", "bench")
    panel.click("cell_tab_area")
    panel.type_into("cell_area_name", "wall")
    for axis, angle in turned.items():
        panel.type_into(f"cell_area_{axis}", angle)
    assert panel.read("cell_area_side") == f"Forbidden side of the plane: {side}"


@pytest.mark.each_value(full="each tab in both languages")
@pytest.mark.styled
@pytest.mark.parametrize("language", ["zh", "en"])
@pytest.mark.parametrize("tab", ["tools", "frames", "area", "held", "base"])
def test_no_figure_is_cut_in_a_small_window(app_driver, tab, language):
    """«10.0» read as «0.0»: a field must show five digits of what it may hold."""
    app_driver.ready()
    accepted(app_driver.controller.cell.take(Cell("bench", area=Area(boxes=(AreaBox("crate"),)))))
    app_driver.store.change(language=language)
    app_driver.window.resize(1280, 800)
    app_driver.click("menu_cell")
    app_driver.click(f"cell_tab_{tab}")
    app_driver.run(0.1)
    fields = [each for each in app_driver.window.findChildren(FigureField) if each.isVisible()]
    assert len(fields) >= 6
    for field in fields:
        digits = field.fontMetrics().horizontalAdvance("1000.0")
        assert field.contentsRect().width() - field._unit_px() - digits >= 8, field.objectName()


# A backup of a cell is taken whole or not at all --------------------------------------------------


def backup(panel, tmp_path, cell):
    theirs = tmp_path / f"{cell.name}.armui-cell"
    theirs.write_text(to_text(cell), encoding="utf-8")
    panel.controller.cell.store.read(theirs, panel.window.findChild(CellPanel)._on_read)


def test_a_backup_that_is_refused_leaves_the_cell_in_force(panel, tmp_path):
    """That of its name, for which the hand holds something, was put in force before the refusal."""
    cells = panel.controller.cell
    holding = Cell("bench", (PEN,), "pen", held_objects=(HeldObject("cube"),), held="cube")
    panel.type_into("cell_name", "stand")
    accepted(cells.take(Cell("other")))
    accepted(cells.choose("stand"))
    cells.take_loaded({"bench": holding})
    backup(panel, tmp_path, Cell("bench", (PEN,)))
    panel.confirm()
    assert "“cube” is marked as held" in panel.read("cell_message")
    assert (cells.cell, cells.cells["bench"]) == (Cell("stand"), holding)
    assert panel.store.settings.cells == {panel.device.arm_key(): "stand"}


def test_a_backup_of_the_cell_in_force_drops_no_mark_of_what_is_held(panel, tmp_path):
    cells = panel.controller.cell
    accepted(cells.take(Cell("bench", held_objects=(HeldObject("cube"),))))
    accepted(cells.hold("cube"))
    backup(panel, tmp_path, Cell("bench", (PEN,), "pen"))
    panel.confirm()
    assert "“cube” is marked as held" in panel.read("cell_message")
    accepted(cells.hold(""))
    backup(panel, tmp_path, Cell("bench", (PEN,), "pen"))
    panel.confirm()
    assert cells.cell == read_cell(file_of(panel, "bench")) == Cell("bench", (PEN,), "pen")


@pytest.mark.parametrize("broken", ["{", to_text(Cell("bench")).replace("1", "9")])
def test_a_backup_of_a_cell_that_cannot_be_read_takes_its_place(make_driver, tmp_path, broken):
    driver = make_driver(Generation.TWO)
    try:
        file = driver.library_folder / "bench.armui-cell"
        driver.library_folder.mkdir(exist_ok=True)
        file.write_text(broken, encoding="utf-8")
        driver.store.keep("cells", {driver.device.arm_key(): "bench"})
        driver.program._cell_keeper._do(
            driver.program._cell_keeper._on_read, driver.program._cell_keeper._folder.read
        )
        driver.connect()
        driver.click("menu_cell")
        theirs = tmp_path / "backup" / "bench.armui-cell"
        theirs.parent.mkdir()
        theirs.write_text(to_text(Cell("bench", (PEN,), "pen")), encoding="utf-8")
        driver.controller.cell.store.read(theirs, driver.window.findChild(CellPanel)._on_read)
        question = driver.dialog(ConfirmDialog)
        assert "that could not be read, which is put aside" in question._text.text()
        driver.confirm()
        assert read_cell(file) == driver.controller.cell.in_force == Cell("bench", (PEN,), "pen")
        aside = file.with_name("bench.armui-cell.broken")
        assert aside.read_text(encoding="utf-8") == broken
        assert driver.controller.cell.broken == {}
    finally:
        driver.close()


@pytest.mark.parametrize("fault", ["newer", "cut short", "a figure too large", "more than known"])
def test_a_backup_that_is_not_understood_changes_nothing(panel, tmp_path, fault):
    panel.type_into("cell_name", "bench")
    add_pen(panel)
    before = panel.controller.cell.cell
    text = to_text(replace(before, tool=""))
    wrong = {
        "newer": text.replace('"version": 1', '"version": 3'),
        "cut short": text[: len(text) // 2],
        "a figure too large": text.replace("120.0", "1e9"),
        "more than known": text.replace('"tool": ""', '"tool": "", "conveyor": 2'),
    }[fault]
    assert wrong != text
    theirs = tmp_path / "bench.armui-cell"
    theirs.write_text(wrong, encoding="utf-8")
    panel.controller.cell.store.read(theirs, panel.window.findChild(CellPanel)._on_read)
    assert panel.read("cell_message")
    assert panel.controller.cell.cell == read_cell(file_of(panel, "bench")) == before
