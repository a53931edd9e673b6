"""S12, S14, S16: what is driven is what the widgets show at the press, and what was checked so."""

import math
from typing import Any

import pytest

from armui.control.operations.started import Started
from armui.control.run.progress import RunPhase
from armui.control.run.run_request import RequestState
from armui.protocol.codes import EndLoad
from armui.protocol.generation import PiperModel
from tests.operator.test_running import BACK, OUT, UP, Operator, to

FAR = (90.0, 60.0, -60.0, 0.0, 20.0, 0.0)


class AtRunBar(Operator):
    """An operator who turns what stands beside 发送."""

    def choose(self, *, speed=None, steps=None, first=None, times=None):
        if speed is not None:
            self.app_driver.controller.motion.set_speed_percent(speed)
        if steps is not None:
            self.child("run_steps").setChecked(steps)
        if first is not None:
            self.child("run_first").setValue(first)
        if times is not None:
            self.child("run_cycles").setCurrentIndex(1)
            self.child("run_times").setValue(times)

    def accept(self):
        button = self.child("accept_warnings")
        assert button.isVisible()
        self.app_driver.click(button)

    @property
    def warned(self):
        return self.child("accept_warnings").isVisible()

    @property
    def running(self):
        return self.app_driver.controller.player.running

    def fastest_deg_s(self, seconds=20.0):
        """The highest speed of any joint until the run waits or is over."""
        driver, fastest = self.app_driver, 0.0
        for _ in range(round(seconds / 0.02)):
            driver.step()
            fastest = max(fastest, *map(abs, driver.firmware.mechanics.speeds_deg_s))
            if not self.running or self.progress.phase is RunPhase.WAITING:
                return fastest
        return fastest


@pytest.fixture
def warned(app_driver):
    """Warnings are shown and wait to be accepted; 100 %, no steps."""
    operator = AtRunBar(app_driver, to(FAR), to(BACK), to(UP))
    operator.click("run_send")
    assert operator.warned
    assert not operator.running
    return operator


def accepted(operator):
    """Accept until it runs, or is refused; returns how often it was asked anew."""
    asked = 0
    while not operator.running and operator.warned:
        operator.accept()
        asked += 1
        assert asked < 5
    return asked


def test_speed_and_steps_turned_after_the_check_are_checked_and_driven(warned):
    warned.choose(speed=5, steps=True)
    warned.accept()
    assert not warned.running, "it was asked anew"
    assert warned.warned
    warned.accept()
    assert warned.running
    assert warned.fastest_deg_s() < 20.0
    assert warned.progress.phase in {RunPhase.WAITING, RunPhase.MOVING}


@pytest.mark.parametrize(
    "choice", [{"speed": 99}, {"steps": True}, {"first": 2}, {"times": 2}], ids=str
)
def test_any_choice_turned_is_driven(warned, choice):
    warned.choose(**choice)
    accepted(warned)
    warned.app_driver.step()
    run = warned.app_driver.controller.player._run
    assert run is not None
    shown = {
        "speed": run.speed_percent,
        "steps": run.step_by_step,
        "first": run.first + 1,
        "times": run.cycles,
    }
    assert choice.items() <= shown.items()


def test_what_was_not_turned_is_asked_once(warned):
    assert accepted(warned) == 1


def test_turned_there_and_back_is_as_it_was_checked(warned):
    warned.choose(speed=5)
    warned.choose(speed=100)
    assert accepted(warned) == 1


def test_turned_while_the_check_is_under_way(slow_driver):
    operator = AtRunBar(slow_driver, to(OUT), to(BACK))
    operator.click("run_send")
    operator.choose(speed=5, steps=True)
    slow_driver.workers.work()  # of the check for 100 %
    slow_driver.workers.work()  # of the one for what is shown now
    accepted(operator)
    slow_driver.workers.work()
    slow_driver.step()
    run = slow_driver.controller.player._run
    assert (run.speed_percent, run.step_by_step) == (5, True)


def test_go_on_from_a_row_goes_as_shown(app_driver):
    operator = AtRunBar(app_driver, to(OUT), to(FAR), to(UP))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    app_driver.run(0.1)
    app_driver.controller.player.stop()
    operator.until_over()
    operator.choose(speed=5, steps=True)
    operator.send("run_resume")
    assert operator.running
    assert app_driver.controller.player._run.first == 1
    assert operator.fastest_deg_s() < 20.0


def test_the_choices_of_a_run_under_way_are_its_own(app_driver):
    operator = AtRunBar(app_driver, to(OUT), to(BACK))
    operator.send()
    names = ("run_cycles", "run_first", "run_steps")
    assert not any(operator.child(name).isEnabled() for name in names)
    operator.until_over()
    assert all(operator.child(name).isEnabled() for name in names)


# What a check belongs to ----------------------------------------------------------------------


def tool(driver):
    driver.controller.cartesian.tool = (0.0, 0.0, 320.0, 0.0, 0.0, 0.0)


def load(driver):
    assert isinstance(driver.controller.end_reports.set_load(EndLoad.FULL), Started)
    driver.run(0.5)


def setting(driver):
    driver.controller.transactions.alterations += 1


def another_arm(driver):
    driver.controller._connection._arms += 1


def model(driver):
    driver.controller._connection.model = PiperModel.PIPER_L
    driver.controller._refresh()


@pytest.mark.parametrize("change", [tool, load, setting, another_arm, model])
def test_another_arm_or_tool_than_was_checked_is_not_run(warned, change):
    change(warned.app_driver)
    warned.accept()
    warned.app_driver.run(1.0)
    assert not warned.running
    assert math.dist(warned.app_driver.firmware.joints_deg, (0.0,) * 6) < 0.5
    heard = {each.arbitration_id for each in warned.app_driver.node.heard}
    assert not {0x155, 0x156, 0x157} & heard


# What is about to begin -----------------------------------------------------------------------


def test_a_stop_withdraws_the_question_too(warned):
    """Whoever stops the arm does not mean to be asked whether it shall set out."""
    driver, request = warned.app_driver, warned.window._run_bar._request
    driver.press(driver.find("stop_button"))
    driver.run(0.5)
    assert request.state is RequestState.GIVEN_UP
    assert not warned.warned
    assert warned.child("findings_list").isVisible()
    warned.child("accept_warnings").click()
    assert not warned.running


def test_another_press_takes_the_place_of_the_question(warned):
    first = warned.window._run_bar._request
    warned.choose(speed=50)
    warned.click("run_send")
    first.accept()
    assert not warned.running
    assert accepted(warned) == 1


def test_an_arm_that_comes_while_a_slow_disk_reads_is_not_the_one_pressed_for(warned):
    bar = warned.window._run_bar
    reading: list[Any] = []
    bar._content = reading.append
    warned.click("run_send")
    assert not warned.child("run_send").isEnabled()
    warned.app_driver.controller._connection._arms += 1
    reading[0](warned.window.document.trajectory())
    assert not warned.running
    assert not warned.warned
    assert "another arm answers" in warned.text("editor_message")


@pytest.mark.parametrize("end", ["emergency_stop", "halt_and_hold"])
def test_what_was_asked_before_a_stop_or_a_halt_cannot_be_accepted_after_it(warned, end):
    getattr(warned.app_driver.controller, end)()
    assert not warned.warned
    assert not warned.running
