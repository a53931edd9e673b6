"""S16: a point shown for a tool is driven to the flange's pose that it keeps, whatever the tool."""

import pytest

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.protocol.codes import MoveMode
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.points.clipboard import from_text, to_text
from armui.trajectory.points.program import Waypoint
from tests.accepted import accepted
from tests.operator.editor.actions import Editor

PEN = Tool("pen", (10.0, -5.0, 100.0, 15.0, -25.0, 40.0), 10.0)
LONG = Tool("pen", (10.0, -5.0, 130.0, 15.0, -25.0, 40.0), 10.0)
BENCH = with_part(Cell("bench"), PEN)
OTHERS = {
    "the same": BENCH,
    "a longer one": with_part(BENCH, LONG, instead_of="pen"),
    "none": Cell("bench", (PEN,)),
}
POINT = Waypoint(MoveMode.MOVE_P, (300.0, 0.0, 250.0, 0.0, 85.0, 0.0), None, 100)
TOLD = {0x152: "000493e000000000", 0x153: "0003d09000000000", 0x154: "00014c0800000000"}
"""X 300, Y 0; Z 250, RX 0; RY 85, RZ 0, in thousandths."""


def poses_heard(driver):
    told = {}
    while (heard := driver._ear.recv(0)) is not None:
        if heard.arbitration_id in TOLD:
            told[heard.arbitration_id] = bytes(heard.data).hex()
    return told


@pytest.mark.each_value(full="each tool, both ways")
@pytest.mark.parametrize("other", OTHERS)
@pytest.mark.parametrize("way", ["go_to", "run"])
def test_a_tool_chosen_just_before_the_press_changes_nothing_that_is_sent(app_driver, way, other):
    app_driver.ready()
    accepted(app_driver.controller.cell.take(BENCH))
    editor = Editor(app_driver, POINT)
    editor.choose(0)
    app_driver.heard()
    accepted(app_driver.controller.cell.change(OTHERS[other]))
    if way == "go_to":
        editor.act("go_to")
    else:
        editor.click("run_send")
        accept = editor.child("accept_warnings")
        if accept.isVisible():
            app_driver.click(accept)
        app_driver.run_until(lambda: app_driver.controller.player.running)
    app_driver.run(0.3)
    assert poses_heard(app_driver) == TOLD


def test_a_tool_changed_between_check_and_acceptance_withdraws_the_question(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.cell.take(BENCH))
    editor = Editor(app_driver, POINT)
    app_driver.heard()
    editor.click("run_send")
    assert editor.child("accept_warnings").isVisible()
    accepted(app_driver.controller.cell.change(OTHERS["a longer one"]))
    assert not editor.child("accept_warnings").isVisible()
    app_driver.run(0.3)
    assert poses_heard(app_driver) == {}


def test_an_older_program_refuses_the_rows_of_a_tool():
    """It takes a first cell that is no motion for the first figure."""
    row = to_text((POINT,), of_tool=True)
    assert row.split("\t")[0] == "TCP MOVE P"
    assert from_text(row) == (POINT,)
    with pytest.raises(TrajectoryFileError):
        from_text(row.replace("TCP ", "TCP-"))  # as one that does not know the word
