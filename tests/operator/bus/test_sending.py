"""Sending a frame by hand: the lock, the held press, the words before it."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

from armui.ui.watch.bus.bus_page import BusPage
from tests.operator.bus.actions import LEFT, BusMonitor
from tests.operator.test_palette import command


@pytest.fixture
def box(monitor):
    monitor.driver.heard()
    return monitor.window.send_box


def heard(monitor):
    monitor.run(0.2)
    return [
        f"{each.arbitration_id:03X}#{each.data.hex().upper()}" for each in monitor.driver.heard()
    ]


def test_it_is_locked_until_a_button_is_held(monitor, box):
    assert not box.identifier.isVisible()
    assert not box.hold.isVisible()
    monitor.driver.click(box.unlock)
    assert not box.is_open
    monitor.driver.hold_button(box.unlock, share=0.9)
    assert not box.is_open
    monitor.unlock()

    assert box.is_open
    assert box.identifier.isVisible()
    monitor.click("bus_lock")
    assert not box.is_open


def test_a_question_goes_out_on_a_press(monitor, box):
    monitor.unlock()
    monitor.write("121", "01 01 FF 10 10 10 00 05")
    assert "nothing moves" in box.message.text()
    monitor.click("bus_send")

    assert heard(monitor) == ["121#0101FF1010100005"]
    assert "Sent: 0x121" in box.message.text()
    assert monitor.driver.codes()[-1] == "frame_sent_by_hand"


def test_the_palette_sends_what_is_typed(monitor, box):
    monitor.unlock()
    monitor.write("121", "01 01 FF 10 10 10 00 05")
    command(monitor.driver, "send bus")

    assert heard(monitor) == ["121#0101FF1010100005"]
    assert "Sent: 0x121" in box.message.text()


def test_what_is_typed_is_read_while_it_is_typed(monitor, box):
    monitor.unlock()
    assert box.decoded.text() == ""
    monitor.write("155", "00 00 2E E0")
    assert box.decoded.text() == "Target angles J1, J2: 4 bytes instead of 8"
    QTest.keyClicks(box.data, " FF FF D1 20")
    assert box.decoded.text() == "Target angles J1, J2: J1 12.000°   J2 -12.000°"
    monitor.write("2A1", "00")
    assert box.decoded.text().startswith("Arm status: ")  # also of what is not sent by hand
    monitor.write("3C1", "00")
    assert box.decoded.text().startswith("Unknown")
    monitor.write("15", "0")
    assert box.decoded.text() == ""
    assert heard(monitor) == []


def test_what_moves_the_arm_is_held_and_says_what_happens(monitor, box):
    monitor.unlock()
    monitor.write("0x471", "07 01 00 00 00 00 00 00")
    assert not box.send.isVisible()
    assert "the ARM DROPS" in box.message.text()
    monitor.driver.click(box.hold)
    monitor.driver.hold_button(box.hold, share=0.9)
    assert heard(monitor) == []
    monitor.driver.hold_button(box.hold)

    assert heard(monitor) == ["471#0701000000000000"]


def test_by_keys_alone(monitor, box):
    box.unlock.setFocus()
    QTest.keyPress(box.unlock, Qt.Key.Key_Space)
    box.unlock.progress.setCurrentTime(box.unlock.progress.duration())
    QTest.keyRelease(box.unlock, Qt.Key.Key_Space)
    assert box.is_open
    assert box.identifier.hasFocus()
    QTest.keyClicks(box.identifier, "155")
    QTest.keyClick(box.identifier, Qt.Key.Key_Tab)
    assert box.data.hasFocus()
    QTest.keyClicks(box.data, "0000000000000000")
    QTest.keyClick(box.data, Qt.Key.Key_Return)
    assert monitor.window.isVisible()
    assert heard(monitor) == []
    box.hold.setFocus()
    QTest.keyPress(box.hold, Qt.Key.Key_Space)
    box.hold.progress.setCurrentTime(box.hold.progress.duration())

    assert heard(monitor) == ["155#0000000000000000"]
    assert monitor.driver.controller.operating_state.other_host is not None


@pytest.mark.parametrize(
    ("identifier", "data", "words"),
    [
        ("G", "", "not a hexadecimal number"),
        ("800", "", "more than 11 bits"),
        ("155", "1", "not whole bytes"),
        ("155", "00" * 9, "9 bytes do not fit"),
        ("2A1", "", "sent by the arm itself"),
        ("150", "02", "lets the arm drop"),
    ],
)
def test_what_is_wrong_is_said_while_it_is_written(monitor, box, identifier, data, words):
    monitor.unlock()
    monitor.write(identifier, data)

    assert words in box.message.text()
    assert not box.send.isEnabled() or not box.send.isVisible()
    assert not box.hold.isEnabled()


def test_what_is_meant_is_what_stands_there_when_the_press_begins(monitor, box):
    monitor.unlock()
    monitor.write("471", "07 02 00 00 00 00 00 00")
    monitor.driver.press(box.hold)
    box.data.setText("07 01 00 00 00 00 00 00")
    box.hold.progress.setCurrentTime(box.hold.progress.duration())

    assert heard(monitor) == []


def test_it_locks_when_it_is_hidden_after_a_while_and_with_the_device(monitor, box):
    monitor.unlock()
    monitor.window.close()
    assert not box.is_open
    monitor.driver.click("bus_button")
    monitor.unlock()
    box._timer.timeout.emit()
    assert not box.is_open
    monitor.unlock()
    monitor.driver.controller.disconnect_device()
    assert not box.is_open
    assert not box.unlock.isEnabled()
    assert "device" in box.unlock.toolTip()


def test_a_connection_that_only_listens_is_never_unlocked(app_driver):
    app_driver.controller.connect_device(replace(app_driver.device, listen_only=True))
    app_driver.run(1.0)
    box = BusMonitor(app_driver).window.send_box

    assert not box.unlock.isEnabled()
    assert "only listens" in box.unlock.toolTip()


def test_the_stop_works_while_the_button_is_held(monitor, box):
    monitor.unlock()
    monitor.write("155", "0000000000000000")
    monitor.driver.press(box.hold)
    QTest.keyClick(monitor.window, Qt.Key.Key_F12)
    monitor.run(0.3)

    assert monitor.driver.firmware.condition.stopped
    QTest.mouseRelease(box.hold, LEFT)
    assert not box.hold.isEnabled()


def test_a_frame_of_another_host_can_be_taken_into_the_fields(monitor, box, company):
    company.say("472#0101000000000000")
    monitor.run()
    monitor.unlock()
    row = monitor.model.row_of(monitor.index("0x472", "another host"))
    menu = monitor.window._menu_of(row, [])
    assert isinstance(menu, QMenu)
    texts = [action.text() for action in menu.actions()]
    assert texts[-1] == "Copy to the send fields"
    menu.actions()[-1].trigger()

    assert (box.identifier.text(), box.data.text()) == ("472", "01 01 00 00 00 00 00 00")
    assert isinstance(monitor.window, BusPage)
