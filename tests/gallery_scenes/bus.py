"""The window 总线: a second host and an unknown frame on the bus of a moving arm."""

from __future__ import annotations

import can
from PySide6.QtWidgets import QWidget

from armui.bus.link import BUS_OFF
from armui.ui.watch.bus.bus_page import BusPage
from tests.app_driver import AppDriver
from tests.company import OtherHost

SIZE_PX = (1180, 760)
_TEMPERATURES = 609


def _window(app_driver: AppDriver) -> BusPage:
    app_driver.click("bus_button")
    window = app_driver.taken_out(BusPage)
    window.resize(*SIZE_PX)
    window.filter_bar.by_id.click()
    for text in (window.filter_bar.text, window.filter_bar.ids):
        text.clear()
    return window


def _company(app_driver: AppDriver) -> None:
    """A host that asks and lights lamps, an unknown frame, one too short, one of 29 bits."""
    host = OtherHost(app_driver)
    lamps = host.stream(lambda _t_s: ["121#0101000010FF0007"], rate_hz=5)
    unknown = host.stream(lambda t_s: [f"3C1#0102{round(100 * t_s) & 0xFF:02X}"], rate_hz=20)
    app_driver.run(0.9)
    host.say("472#0101000000000000", "2A8#0011")
    with can.Bus(interface="virtual", channel=app_driver.channel) as bus:
        bus.send(can.Message(arbitration_id=0x18FF50E5, data=b"\x01\x02\x03", is_extended_id=True))
        bus.send(can.Message(arbitration_id=0x040, is_error_frame=True, data=bytes(8)))
    app_driver.run(0.1)
    lamps.end()
    unknown.end()
    host.close()


def _expand(window: BusPage, *identifiers: int) -> None:
    model = window.model
    for place in range(model.rowCount()):
        index = model.index(place, 0)
        row = model.row_of(index)
        window.tree.setExpanded(index, row.arbitration_id in identifiers and not row.flags)


def by_identifier(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver)
    _company(app_driver)
    window.refresh()
    window.filter_bar.ids.setText("40, 121, 2A5-2A8, 3C1-7FFFFFFF")
    _expand(window, 0x2A5, 0x3C1, 0x472)
    window.tree.scrollToTop()
    window.filter_bar.pause.setChecked(True)
    return window.window()


def in_order(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver)
    _company(app_driver)
    window.filter_bar.in_order.click()
    window.refresh()
    window.filter_bar.pause.setChecked(True)
    window.trace.scrollToBottom()
    return window.window()


def by_hand(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver)
    app_driver.run(0.5)
    window.filter_bar.text.setText("0x26")
    window.refresh()
    _expand(window, _TEMPERATURES)
    app_driver.hold_button(window.send_box.unlock)
    window.send_box.take(0x471, bytes.fromhex("0701"))
    window.filter_bar.pause.setChecked(True)
    return window.window()


def blocked(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver)
    app_driver.run(0.3)
    connection = app_driver.controller._connection
    device = connection.device
    connection.problem = BUS_OFF(device="can0", interface="socketcan", channel="can0")
    app_driver.step()
    window.refresh()
    connection.problem = None
    assert device is not None
    window.filter_bar.pause.setChecked(True)
    return window.window()
