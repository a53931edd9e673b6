"""An operator who slows a run by the slider at the top, and by keys."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu, QWidget

from armui.control.run.progress import RunPhase
from armui.ui import words
from tests.operator.test_running import BACK, OUT, Operator, to


def running(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.send()
    operator.until(lambda: operator.progress.index == 1)
    app_driver.run(0.2)
    app_driver.heard()
    return operator


def told(app_driver):
    app_driver.step()
    return [frame.data[2] for frame in app_driver.heard() if frame.arbitration_id == 0x151]


def handle(slider):
    return QPoint(round(9 + (slider.width() - 18) * slider.sliderPosition() / 100), 12)


def test_the_slider_slows_while_it_is_dragged_and_speeds_up_when_let_go(app_driver):
    running(app_driver)
    slider = app_driver.find("speed_slider")
    assert slider.isVisible()
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=handle(slider))
    half = QPoint(round(9 + (slider.width() - 18) * 0.5), 12)
    QTest.mouseMove(slider, half)
    assert told(app_driver)[-1] == 50
    QTest.mouseMove(slider, QPoint(slider.width() - 9, 12))
    assert told(app_driver) == []
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=QPoint(slider.width() - 9, 12))
    assert told(app_driver) == [100]
    assert app_driver.find("speed_field").value() == 100


def test_keys_slow_the_run_also_behind_a_menu(app_driver):
    operator = running(app_driver)
    menu = QMenu(app_driver.window)
    menu.addAction("something")
    menu.popup(app_driver.window.mapToGlobal(QPoint(50, 50)))
    QTest.keyClick(menu, Qt.Key.Key_F8)
    assert told(app_driver) == [90]
    menu.close()
    QTest.keyClick(operator.window, Qt.Key.Key_F8)
    assert told(app_driver)[-1] == 80
    QTest.keyClick(operator.window, Qt.Key.Key_F7)
    assert told(app_driver)[-1] == 90
    assert app_driver.read("speed_field") == "90 %"


def test_0_percent_is_shown_as_a_pause_and_goes_on_by_holding_continue(app_driver):
    operator = running(app_driver)
    app_driver.type_into("speed_field", "0")
    assert operator.progress.phase is RunPhase.PAUSED
    first_raise = "paused: raise the speed at the top, then hold “Continue” for 1 s"
    app_driver.run(1.5)
    assert operator.text("run_text").count("Continue") == 1
    assert first_raise in operator.text("run_text")
    here = tuple(app_driver.firmware.joints_deg)
    app_driver.hold_button("run_continue")
    assert operator.text("run_text").count("Continue") == 1
    assert first_raise in operator.text("run_text")
    app_driver.type_into("speed_field", "40")
    app_driver.run(1.0)
    assert "paused: hold “Continue” for 1 s" in operator.text("run_text")
    assert tuple(app_driver.firmware.joints_deg) == here
    app_driver.heard()
    app_driver.hold_button("run_continue")
    app_driver.run(0.2)
    assert told(app_driver)[:1] == [40]
    operator.until_over()
    assert operator.text("run_text").endswith("done")


def typed_slowly(driver, field):
    """Half a figure, then something that the window shows anew, then the rest and Enter."""
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "1")
    driver.controller.operating_state_changed.emit(driver.controller.operating_state)
    driver.run(0.1)
    QTest.keyClicks(field, "5")
    driver.heard()
    QTest.keyClick(field, Qt.Key.Key_Return)
    driver.step()


def test_what_is_typed_counts_whatever_changes_meanwhile(app_driver):
    running(app_driver)
    field = app_driver.find("speed_field")
    typed_slowly(app_driver, field)
    assert app_driver.controller.speed_override.percent == 15
    QTest.keyClick(app_driver.window, Qt.Key.Key_F8)
    assert app_driver.read("speed_field") == "5 %", "what counts is shown, typed in or not"


def test_what_is_typed_in_the_top_bar_counts_whatever_changes_meanwhile(app_driver):
    app_driver.ready()
    typed_slowly(app_driver, app_driver.find("speed_field"))
    assert app_driver.controller.motion.speed_percent == 15


def test_without_a_run_the_keys_set_the_speed_in_the_top_bar(app_driver):
    app_driver.ready()
    QTest.keyClick(app_driver.window, Qt.Key.Key_F8)
    assert app_driver.find("speed_field").value() == 20
    QTest.keyClick(app_driver.window, Qt.Key.Key_F7)
    assert app_driver.find("speed_field").value() == 30


def test_the_slider_in_the_top_bar_slows_while_it_is_dragged(app_driver):
    app_driver.ready()
    slider = app_driver.find("speed_slider")
    app_driver.heard()
    begin = handle(slider)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=begin)
    QTest.mouseMove(slider, QPoint(round(9 + (slider.width() - 18) * 0.1), 12))
    assert told(app_driver)[-1] == 10
    QTest.mouseMove(slider, begin)  # where it was taken
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=begin)
    assert told(app_driver)[-1] == 30
    assert app_driver.find("speed_field").value() == 30


def test_the_strip_fits_a_small_window(app_driver):
    running(app_driver)
    for name in ("run_pause", "run_stop"):
        part = app_driver.find(name)
        strip = app_driver.window.findChild(QWidget, "run_strip")
        left = part.mapTo(strip, QPoint(0, 0)).x()
        assert 0 <= left <= strip.width() - part.width()


def test_a_speed_beyond_the_range_is_refused_in_words_and_not_sent(app_driver):
    app_driver.ready()
    field = app_driver.find("speed_field")
    for typed in ("150", "-5"):
        app_driver.heard()
        app_driver.type_into("speed_field", typed)
        assert told(app_driver) == []
        assert app_driver.read("speed_field") == "30 %"
        assert words.event(app_driver.events[-1]) == (
            f"Not sent. Speed: {typed} is out of range. Enter a whole number from 0 to 100."
        )
    app_driver.type_into("speed_field", "100")
    before = len(app_driver.events)
    QTest.keyClick(field, Qt.Key.Key_Up)
    assert (field.value(), len(app_driver.events)) == (100, before)
