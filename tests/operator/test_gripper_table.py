"""The gripper table by clicking: what the arm is then asked for, what is shown, what is kept."""

from dataclasses import replace

import pytest
from PySide6.QtTest import QTest

from armui.cell.cell import Cell
from armui.control.parameters.arm_model import arm_model
from armui.control.run.progress import RunPhase
from armui.control.run.replay import Replay
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.points.program import GripperOpening
from armui.ui import words
from tests.accepted import accepted
from tests.control.test_replayer import wave
from tests.control.under_way import OUT, run_of, to
from tests.trajectory.arms import joint, run

PAIRS = ((10.0, 8.0), (45.0, 38.0), (60.0, 50.0))
BENCH = Cell("bench", gripper_table=PAIRS, gripper_calibrated=True)


def sent(driver):
    """The payloads of 0x159 that the arm was sent since the last call."""
    return [each.data.hex().upper() for each in driver.heard() if each.arbitration_id == 0x159]


@pytest.fixture
def bench(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.cell.take(BENCH))
    app_driver.run(0.1)
    app_driver.heard()
    return app_driver


def test_without_a_table_nothing_changes(app_driver):
    app_driver.ready()
    app_driver.heard()
    accepted(app_driver.controller.gripper.move(38.0, 1.0))
    app_driver.run(0.1)
    # 38.000 mm = 38,000 = 0x00009470; 1 N·m = 1,000 = 0x03E8; enabled
    assert sent(app_driver) == ["0000947003E80100"]


def test_a_target_is_asked_for_by_the_table(bench):
    accepted(bench.controller.gripper.move(38.0, 1.0))
    bench.run(3.0)
    # 45.000 mm = 45,000 = 0x0000AFC8
    assert sent(bench) == ["0000AFC803E80100"]
    assert bench.controller.state.gripper.value.opening_mm == pytest.approx(45.0, abs=0.1)
    (there,) = [each for each in bench.events if each.code == "gripper_there"]
    assert there.params == {"value": pytest.approx(38.0, abs=0.1), "unit": "mm_calibrated"}
    bench.click("menu_gripper")
    assert bench.find("gripper_opening_measured").text().startswith("38.0")
    assert bench.find("gripper_calibrated").isVisible()
    assert "mm, calibrated" in words.event(there)


def test_limits_are_those_that_are_measured(bench):
    figures = bench.controller.gripper.figures.travel
    # 100 mm at most: 50 + 40 · 12 / 15
    assert (figures.minimum, figures.maximum) == (0.0, 82.0)
    assert bench.controller.gripper.move(82.5, 1.0).reason.id == "figure_out_of_range"
    accepted(bench.controller.gripper.move(82.0, 1.0))
    bench.run(0.1)
    assert sent(bench) == ["000186A003E80100"]  # 100,000


def test_a_point_is_asked_for_by_the_table(bench):
    controller = bench.controller
    accepted(controller.player.start(run_of(to(OUT, gripper=GripperOpening(38.0)))))
    bench.run_until(lambda: controller.player.phase is RunPhase.DONE)
    assert sent(bench) == ["0000AFC803E80100"]


def test_a_recording_is_replayed_as_the_arm_told_it(bench):
    recording = wave()
    samples = recording.samples.copy()
    samples[:, -1] = 38.0
    accepted(bench.controller.replayer.start(Replay(replace(recording, samples=samples))))
    bench.run(4.0)
    assert {each[:8] for each in sent(bench)} == {"00009470"}


def test_a_point_that_is_taken_over_has_the_measured_opening(bench):
    accepted(bench.controller.gripper.move(38.0, 1.0))
    bench.run(3.0)
    gripper = bench.controller.state.gripper.value
    assert bench.controller.gripper.shown(gripper) == pytest.approx(38.0, abs=0.05)
    assert bench.controller.gripper.as_asked(GripperOpening(38.0)) == GripperOpening(45.0)


def test_the_check_knows_what_is_beyond_the_stroke(bench):
    bench.click("menu_gripper")  # the stroke is read there
    bench.run(1.0)
    stroke_mm = arm_model(bench.controller).stroke_mm
    widest_mm = arm_model(bench.controller).widest_mm
    assert stroke_mm is not None
    assert widest_mm is not None
    assert widest_mm == pytest.approx(50.0 + (stroke_mm - 60.0) * 12.0 / 15.0)
    for opening_mm, codes in ((widest_mm - 1.0, []), (widest_mm + 1.0, ["gripper_beyond_stroke"])):
        points = run(replace(joint(*OUT), gripper=GripperOpening(opening_mm)))
        report = check(CheckRequest(points, arm_model(bench.controller), OUT))
        found = [each.code for each in report.findings if each.code.startswith("gripper")]
        assert found == codes


def test_switched_off_it_is_kept_and_not_applied(bench):
    bench.click("menu_cell")
    bench.click("cell_tab_gripper")
    assert bench.find("cell_gripper_on").isChecked()
    bench.click("cell_gripper_on")
    assert bench.controller.cell.cell == Cell("bench", gripper_table=PAIRS)
    accepted(bench.controller.gripper.move(38.0, 1.0))
    bench.run(0.1)
    assert sent(bench) == ["0000947003E80100"]


def test_from_the_first_click_to_the_calibrated_gripper(app_driver):
    driver = app_driver
    driver.ready()
    driver.click("menu_cell")
    driver.type_into("cell_name", "bench")
    driver.click("cell_tab_gripper")
    driver.run(1.0)
    driver.click("cell_gripper_widths")
    widths = [driver.find(f"cell_gripper_asked_{place}").value for place in range(5)]
    assert widths == [7.0, 21.0, 35.0, 49.0, 63.0]  # of 70 mm
    assert "Row 1: press Open" in driver.read("cell_gripper_next")
    driver.heard()
    for place, (asked, measured) in enumerate(zip(widths, (5, 18, 30, 43, 55.5), strict=True)):
        assert driver.find("cell_gripper_open").text() == f"Open to {asked} mm"
        driver.click("cell_gripper_open")
        driver.run(2.0)
        assert int(sent(driver)[-1][:8], 16) == 1000 * asked
        driver.type_into(f"cell_gripper_measured_{place}", str(measured))
    driver.click("cell_gripper_apply")
    cell = driver.controller.cell.cell
    assert cell.gripper_table == ((7, 5), (21, 18), (35, 30), (49, 43), (63, 55.5))
    assert cell.gripper_calibrated
    assert driver.read("cell_gripper_next").startswith("Calibrated:")


def test_one_pair_is_never_said_to_calibrate(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.cell.take(Cell("bench")))
    app_driver.click("menu_cell")
    app_driver.click("cell_tab_gripper")
    app_driver.run(1.0)
    apply = app_driver.find("cell_gripper_apply")
    assert (apply.isEnabled(), apply.toolTip()) == (False, "Nothing is changed.")
    app_driver.type_into("cell_gripper_asked_0", "7")
    app_driver.type_into("cell_gripper_measured_0", "8")
    assert app_driver.read("cell_gripper_next").startswith("Two pairs at least are needed")
    app_driver.click("cell_gripper_apply")
    cell = app_driver.controller.cell.cell
    assert (cell.gripper_table, cell.gripper_calibrated) == (((7.0, 8.0),), False)
    assert app_driver.read("cell_gripper_next").startswith("Two pairs at least are needed")
    assert not apply.isEnabled()
    app_driver.type_into("cell_gripper_asked_1", "35")
    app_driver.type_into("cell_gripper_measured_1", "30")
    assert app_driver.read("cell_gripper_next").startswith("Press Apply: openings are calibrated")
    app_driver.click("cell_gripper_apply")
    assert app_driver.controller.cell.cell.gripper_calibrated


def test_a_table_that_is_switched_off_can_be_applied_again(bench):
    bench.click("menu_cell")
    bench.click("cell_tab_gripper")
    assert not bench.find("cell_gripper_apply").isEnabled()
    bench.click("cell_gripper_on")
    bench.click("cell_gripper_apply")
    assert bench.controller.cell.cell == BENCH


def test_what_was_measured_and_not_applied_survives_a_new_name(bench):
    bench.click("menu_cell")
    bench.click("cell_tab_gripper")
    bench.type_into("cell_gripper_measured_1", "23.5")
    bench.click("cell_manage_button")
    QTest.keyClicks(bench.find("cell_name"), "bench A")  # Enter would make another one
    bench.click("cell_rename_button")
    assert bench.controller.cell.cell.name == "bench A"
    assert bench.find("cell_gripper_measured_1").value == 23.5
    accepted(bench.controller.cell.take(Cell("other", gripper_table=PAIRS)))
    bench.run(0.1)
    assert bench.find("cell_gripper_measured_1").value == PAIRS[1][1]


def test_what_does_not_rise_is_refused_in_the_panel(bench):
    bench.click("menu_cell")
    bench.click("cell_tab_gripper")
    bench.type_into("cell_gripper_measured_1", "5")
    bench.click("cell_gripper_apply")
    assert "does not rise: 5 mm measured at 45 mm asked" in bench.read("cell_message")
    assert bench.controller.cell.cell == BENCH
