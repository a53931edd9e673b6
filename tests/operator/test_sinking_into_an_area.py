"""S32: sinking is excepted from the work area, and is said before: what is below the arm."""

import pytest

from armui.cell.work_area import AreaBox, AreaPlane
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.accepted import accepted
from tests.cell.areas import check_of, put

BELOW = AreaBox("crate", (250.0, 0.0, 40.0, 0.0, 0.0, 0.0), (200.0, 200.0, 80.0))
BESIDE = AreaBox("rack", (-100.0, 500.0, 200.0, 0.0, 0.0, 0.0), (200.0, 100.0, 400.0))
ABOVE = AreaPlane("ceiling", (0.0, 0.0, 900.0, 180.0, 0.0, 0.0))
AHEAD_DEG = (0.0, 80.0, -60.0, 0.0, 20.0, 0.0)
"""The arm reaches ahead, over the crate."""


@pytest.fixture
def over(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.motion.send_joints(AHEAD_DEG))
    app_driver.come_to_rest()
    return app_driver


def question(driver):
    return driver.dialog(ConfirmDialog).text()


def test_what_is_below_counts_and_what_is_beside_or_above_does_not():
    assert check_of(BELOW, BESIDE, ABOVE).below(AHEAD_DEG) == ("crate",)
    assert check_of(AreaPlane("table")).below(AHEAD_DEG) == ("table",)
    assert check_of(BELOW).below((90.0, *AHEAD_DEG[1:])) == ()


def test_disabling_says_what_is_below(over):
    put(over.controller, BELOW, BESIDE, ABOVE)
    over.click("enable_button")
    assert question(over).endswith("The work area does not hold it then: below the arm is crate.")
    assert "rack" not in question(over)


def test_a_stop_tells_it_and_resuming_says_it(over):
    put(over.controller, BELOW)
    over.click("stop_button")
    over.run(0.5)
    (told,) = [each for each in over.events if each.code == "area_below"]
    assert told.params == {"names": "crate"}
    assert "crate" in over.find("recovery_hold_button").toolTip()


def test_without_an_area_nothing_is_added(over):
    over.click("enable_button")
    assert question(over) == "The arm will drop when its motors are disabled. Hold the arm."
    over.dialog(ConfirmDialog).reject()
    put(over.controller, BESIDE)
    over.click("stop_button")
    over.run(0.5)
    assert "area_below" not in over.codes()
