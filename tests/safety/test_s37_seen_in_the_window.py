"""S37: line, top bar and status bar say what the arm does, in both languages; nothing slides."""

import pytest
from PySide6.QtCore import QRect, Qt

from armui.control.operating_state import StopState
from armui.ui import words
from tests.control.jogger import bend
from tests.safety.test_s37_not_heard import pull_the_adapter

LOW_DEG = (10.0, 160.0, -75.0, 15.0, 40.0, 20.0)
"""Some four seconds above where it comes to lie."""
BUTTONS = ("communication_button", "enable_button", "halt_button", "stop_button")


@pytest.fixture
def raised(app_driver):
    bend(app_driver, LOW_DEG)
    app_driver.run(0.6)
    return app_driver


def places(driver):
    """Where the buttons of the top bar lie."""
    found = [driver.find(name) for name in BUTTONS]
    return [QRect(each.mapTo(driver.window, each.rect().topLeft()), each.size()) for each in found]


def short(driver):
    return words.uncommanded_motion_short(driver.controller.operating_state.uncommanded)


def test_after_the_stop_everything_says_that_it_sinks_until_it_rests(raised):
    before = places(raised)
    raised.controller.emergency_stop()
    raised.run(1.5)
    assert raised.controller.operating_state.stop is StopState.STOPPED
    for enable, line, status in (("Sinking", "The arm sinks: ", "Sinks "),) * 2:
        assert raised.read("enable_button") == enable
        assert raised.read("recovery_text").startswith(line)
        assert raised.read("status_motion") == short(raised)
        assert raised.read("status_motion").startswith(status)
        assert raised.find("stop_button")._caption() == short(raised)
        assert places(raised) == before
        raised.run(1.0)
    raised.run(5.0)
    assert raised.controller.operating_state.uncommanded is None
    assert raised.read("enable_button") == "Stopped"
    assert raised.find("stop_button")._caption() == "The arm is at rest"
    assert raised.read("recovery_text").startswith("Emergency stop: ")
    assert raised.find("status_motion").isHidden()
    assert places(raised) == before


def test_where_there_is_little_room_the_line_says_first_to_hold_it(raised):
    raised.controller.emergency_stop()
    raised.run(1.5)
    *_, shortest = words.step_texts(raised.find("recovery_line")._step)
    assert shortest == f"Hold it. {short(raised)}."


def test_another_language_is_taken_on_while_it_sinks(raised):
    raised.controller.emergency_stop()
    raised.run(1.5)
    raised.store.change(language="zh")
    raised.run(0.1)
    assert raised.read("enable_button") == "下沉中"
    assert raised.read("recovery_text").startswith("机械臂正在下沉：")
    assert raised.read("status_motion").startswith("下沉 ")
    assert raised.find("stop_button")._caption().startswith("下沉 ")
    raised.store.change(language="en")
    raised.run(0.1)
    assert raised.read("enable_button") == "Sinking"
    assert raised.read("recovery_text").startswith("The arm sinks: ")


def test_a_pulled_cable_is_said_where_the_operator_looks(raised):
    pull_the_adapter(raised)
    assert raised.read("enable_button") == "Not heard"
    assert raised.find("communication_button")._second_line() == "May be moving"
    assert raised.read("recovery_text").startswith("The arm may be moving: it stood still ")
    assert raised.read("status_motion") == "May be moving"
    raised.store.change(language="zh")
    raised.wait(lambda: raised.read("enable_button") == "无反馈")  # a rig without a bus runs no Qt
    assert raised.find("communication_button")._second_line() == "可能仍在运动"
    assert raised.read("recovery_text").startswith("机械臂可能仍在运动：")


@pytest.mark.parametrize("width", [1280, 700, 420])
def test_however_narrow_the_line_what_the_arm_does_is_not_cut(raised, width):
    raised.controller.emergency_stop()
    raised.run(1.0)
    line = raised.find("recovery_line")
    line.setFixedWidth(width)
    raised.run(0.5)
    text = raised.find("recovery_text")
    flags = Qt.TextFlag.TextWordWrap
    room = QRect(0, 0, text.width(), 1 << 16)
    assert text.fontMetrics().boundingRect(room, flags, text.text()).height() <= text.height()
    assert f"{raised.controller.operating_state.uncommanded.speed_mm_s} mm/s" in text.text()
