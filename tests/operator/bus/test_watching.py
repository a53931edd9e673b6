"""What the window shows of the frames on the bus, and what it costs when nobody looks."""

import can
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from armui.bus.link import BUS_OFF
from armui.ui.watch.bus.cells import Tone
from armui.ui.watch.bus.frame_model import FrameColumn
from armui.ui.watch.bus.trace_model import TraceColumn
from tests.accepted import accepted
from tests.company import OtherArm
from tests.operator.bus.actions import LEFT, BusMonitor, painted
from tests.operator.plots.actions import ask_for_menu, trigger

UNKNOWN = "3C1#0102"


@pytest.fixture(autouse=True)
def no_menu_is_left():
    yield
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()


def test_the_arms_frames_with_rate_jitter_and_count(monitor):
    monitor.run(2.0)
    index = monitor.index("0x2A5")
    cells = [monitor.cell(index, column) for column in FrameColumn]

    assert cells[:3] == ["0x2A5", "Angles of J1, J2", "arm"]
    assert float(cells[FrameColumn.RATE]) == pytest.approx(200, abs=3)
    assert cells[FrameColumn.JITTER].startswith("±")
    assert int(cells[FrameColumn.COUNT]) == pytest.approx(440, abs=8)
    assert len(cells[FrameColumn.LAST]) == len("12:34:56.789")
    assert monitor.read("bus_lost") == "0"
    assert monitor.read("bus_load").endswith("%")


def test_signals_with_units_and_words_below_a_frame(monitor):
    monitor.expand(monitor.index("0x2A5"))
    monitor.run()

    assert monitor.details(monitor.index("0x2A5")) == {"J1": "0.000°", "J2": "0.000°"}
    status = monitor.details(monitor.index("0x2A1"))
    assert status["Status"] == "Normal (0)"
    assert status["Control mode"] in {"Standby (0)", "CAN control (1)"}
    assert monitor.details(monitor.index("0x263"))["Voltage"].endswith(" V")
    assert monitor.tree.isExpanded(monitor.index("0x2A5"))


def test_what_a_frame_says_stands_in_its_row(monitor):
    assert monitor.cell(monitor.index("0x2A5"), FrameColumn.SAYS) == "J1 0.000°   J2 0.000°"
    accepted(monitor.driver.controller.motion.send_joints((5.0, *[0.0] * 5)))
    monitor.run(3.0)
    says = monitor.index("0x2A5").siblingAtColumn(FrameColumn.SAYS)

    assert says.data() == "J1 5.000°   J2 0.000°"
    assert says.data(Qt.ItemDataRole.ToolTipRole) == "J1: 5.000°\nJ2: 0.000°"
    assert "Status Normal (0)" in monitor.cell(monitor.index("0x2A1"), FrameColumn.SAYS)


def test_the_words_change_with_the_language(monitor):
    monitor.expand(monitor.index("0x2A1"))
    monitor.driver.store.change(language="zh")
    monitor.run()

    assert monitor.cell(monitor.index("0x2A1"), FrameColumn.NAME) == "机械臂状态"
    assert monitor.details(monitor.index("0x2A1"))["状态"] == "正常 (0)"
    assert monitor.window.title == "总线监视"


def test_who_sends_what(monitor, company):
    company.move_to((0.0,) * 6, 10)
    monitor.run()
    assert monitor.cell(monitor.index("0x155"), FrameColumn.SENDER) == "another host"
    tone = painted(monitor.index("0x155").siblingAtColumn(FrameColumn.SENDER)).tone
    assert tone is Tone.NOTE
    monitor.driver.run(4.0)
    accepted(monitor.driver.controller.motion.send_joints((5.0, *[0.0] * 5)))
    monitor.run()

    assert ("0x155", "another host") in monitor.rows()
    assert ("0x155", "this program") in monitor.rows()
    assert ("0x2A1", "arm") in monitor.rows()


def test_a_leader_arm_is_called_one_and_a_second_arm_too(monitor):
    leader = OtherArm.leader(monitor.driver)
    other = OtherArm(monitor.driver, 0x20)
    monitor.run(1.0)

    assert ("0x155", "leader arm") in monitor.rows()
    assert ("0x2C5", "another arm") in monitor.rows()
    assert "other identifiers" in monitor.cell(monitor.index("0x2C5"), FrameColumn.NAME)
    leader.close()
    other.close()


def test_unknown_and_malformed_frames_with_the_reason(monitor, company):
    company.say(UNKNOWN, "2A8#0011", "151#09")
    with can.Bus(interface="virtual", channel=monitor.driver.channel) as bus:
        bus.send(can.Message(arbitration_id=0x18FF50E5, data=b"\x01", is_extended_id=True))
        bus.send(can.Message(arbitration_id=0x040, is_error_frame=True, data=bytes(8)))
    monitor.run()

    assert monitor.cell(monitor.index("0x3C1"), FrameColumn.NAME).startswith("Unknown")
    assert monitor.cell(monitor.index("0x18FF50E5"), FrameColumn.NAME).startswith("29-bit")
    assert "2 bytes instead of 8" in monitor.details(monitor.index("0x2A8"))
    assert painted(monitor.index("0x2A8")).tone is Tone.TROUBLE
    assert "1 bytes instead of 8" in monitor.details(monitor.index("0x151"))
    error = monitor.index("0x040", "adapter")
    assert monitor.cell(error, FrameColumn.NAME) == "Error frame of the adapter"
    assert monitor.read("bus_errors").startswith("1")
    monitor.unfold_filter()
    monitor.click("bus_only_unknown")
    assert monitor.ids() == ["0x151", "0x2A8", "0x3C1", "0x18FF50E5", "0x040"]


def test_error_frames_of_a_linux_adapter_are_words_with_the_remedy(monitor):
    with can.Bus(interface="virtual", channel=monitor.driver.channel) as bus:
        bus.send(can.Message(arbitration_id=0x020, is_error_frame=True, data=bytes(8)))
    monitor.run()
    texts = monitor.window._texts
    texts.interface = "socketcan"
    row = monitor.model.row_of(monitor.index("0x020", "adapter"))

    assert "nobody acknowledges: check the arm's power" in texts.trouble(row)


def test_a_value_outside_its_table_is_named(monitor, company):
    company.say("2A1#0963010000000000")
    monitor.run()
    details = monitor.details(monitor.index("0x2A1"))

    assert any("outside its table: Control mode = 9, Status = 99" in each for each in details)


def test_bytes_that_change_are_lit_for_a_second(monitor, company):
    company.say("3C1#010203")
    monitor.run()
    company.say("3C1#01FF03")
    monitor.run()
    payload = painted(monitor.index("0x3C1").siblingAtColumn(FrameColumn.DATA)).payload
    assert payload.text == "01 FF 03"
    assert payload.lit[:3] == (False, True, False)
    monitor.run(1.2)

    payload = painted(monitor.index("0x3C1").siblingAtColumn(FrameColumn.DATA)).payload
    assert not any(payload.lit)


def test_a_frame_that_stops_is_silent(monitor, company):
    stream = company.stream(lambda _t_s: [UNKNOWN], rate_hz=50)
    monitor.run(1.0)
    stream.end()
    monitor.run(1.0)

    assert monitor.cell(monitor.index("0x3C1"), FrameColumn.RATE) == "silent"
    assert painted(monitor.index("0x3C1")).tone is Tone.MUTED


def test_filters_by_text_identifier_and_sender(monitor, company):
    company.say(UNKNOWN, "472#0101000000000000")
    monitor.run()
    monitor.type_into("bus_text", "angles")
    assert monitor.ids() == ["0x2A5", "0x2A6", "0x2A7"]
    monitor.type_into("bus_ids", "2A6-7FF")
    assert monitor.ids() == ["0x2A6", "0x2A7"]
    monitor.type_into("bus_ids", "2A6 nonsense")
    assert monitor.ids() == ["0x2A6"]  # as long as it was understood
    assert "nonsense" in monitor.find("bus_ids").toolTip()
    monitor.type_into("bus_ids", "")
    monitor.type_into("bus_text", "")
    box = monitor.find("bus_senders")
    box.setCurrentIndex(box.findText("another host"))
    assert monitor.ids() == ["0x472"]


def test_the_button_of_the_filter_says_that_something_is_left_out(monitor):
    assert monitor.find("bus_filter").text() == "Filter"
    monitor.unfold_filter()
    monitor.click("bus_only_unknown")
    monitor.type_into("bus_ids", "2A6")
    assert monitor.find("bus_filter").text() == "Filter (2)"
    monitor.click("bus_only_unknown")
    monitor.type_into("bus_ids", "")
    assert monitor.find("bus_filter").text() == "Filter"


def test_only_what_has_changed_since(monitor, company):
    company.say(UNKNOWN)
    monitor.run(0.5)
    monitor.type_into("bus_ids", "3C1")
    assert monitor.ids() == ["0x3C1"]
    monitor.unfold_filter()
    monitor.click("bus_only_changed")
    monitor.run()
    assert monitor.ids() == []
    company.say("3C1#0103")
    monitor.run()

    assert monitor.ids() == ["0x3C1"]


def test_pause_lets_the_figures_stand_and_says_so(monitor):
    monitor.driver.wait(monitor.window.isActiveWindow)
    QTest.keyClick(monitor.window, Qt.Key.Key_P, Qt.KeyboardModifier.ControlModifier)
    monitor.driver.wait(monitor.find("bus_pause").isChecked)
    before = [monitor.cell(i, FrameColumn.COUNT) for i in monitor.indexes()]
    monitor.run(1.0)
    assert [monitor.cell(i, FrameColumn.COUNT) for i in monitor.indexes()] == before
    assert monitor.read("bus_paused").startswith("Paused")
    assert not monitor.find("bus_rate").isVisible()  # no figure of now beside those that stand
    monitor.click("bus_pause")
    monitor.run()

    assert monitor.read("bus_paused") == ""
    # what came meanwhile was counted
    assert int(monitor.cell(monitor.index("0x2A5"), FrameColumn.COUNT)) > 240


def test_clear_begins_anew(monitor, company):
    company.say(UNKNOWN)
    monitor.run(1.0)
    monitor.click("bus_clear")
    assert monitor.ids() == []
    monitor.run(0.1)

    assert "0x3C1" not in monitor.ids()
    assert int(monitor.cell(monitor.index("0x2A5"), FrameColumn.COUNT)) < 30


def test_frames_in_order_of_time(monitor, company):
    monitor.click("bus_in_order")
    company.say(UNKNOWN)
    monitor.run(0.1)
    monitor.click("bus_pause")
    model = monitor.window.trace_model
    shown = [model.index(place, TraceColumn.ID).data() for place in range(model.rowCount())]
    times = [model.index(place, TraceColumn.TIME).data() for place in range(model.rowCount())]

    assert times == sorted(times)
    place = shown.index("0x3C1")
    assert model.index(place, TraceColumn.SENDER).data() == "not known"
    joints = shown.index("0x2A5")
    assert model.index(joints, TraceColumn.SAYS).data() == "J1 0.000°   J2 0.000°"
    monitor.run(0.5)
    assert model.rowCount() == len(shown)  # it stands
    trace = monitor.window.trace
    trace.setFocus()
    trace.setCurrentIndex(model.index(place, 0))
    QTest.keyClick(trace, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert QGuiApplication.clipboard().text().endswith(" 3C1#0102\n")


def test_the_filter_holds_for_single_frames_too(monitor, company):
    monitor.click("bus_in_order")
    monitor.type_into("bus_ids", "3C1")
    company.say(UNKNOWN, UNKNOWN, "3C1#0103")
    monitor.run()
    model = monitor.window.trace_model
    assert model.rowCount() == 3
    monitor.unfold_filter()
    monitor.click("bus_only_changed")
    monitor.run()
    assert model.rowCount() == 1
    assert painted(model.index(0, TraceColumn.DATA)).payload.lit == (False, True)


def test_a_click_on_the_sign_shows_the_curve(monitor):
    index = monitor.index("0x2A5")
    monitor.expand(index)
    signal = monitor.detail(monitor.index("0x2A5"), "J2")
    sign = monitor.tree._sign(signal)
    QTest.mouseClick(monitor.tree.viewport(), LEFT, pos=sign.center())

    assert drawn(monitor) == "arm.joint_angle.2"


def drawn(monitor):
    """What the plots were asked for last."""
    plots = monitor.driver.window._workspace.kept("plots")
    monitor.driver.wait(lambda: plots._known and plots.board.built)
    places = [plots.board.plot_layout.find(key) for key in ("arm.joint_angle.2", "arm.voltage.1")]
    return next(
        key
        for key, place in zip(("arm.joint_angle.2", "arm.voltage.1"), places, strict=True)
        if place is not None
    )


def test_enter_and_the_right_button_do_the_same(monitor):
    index = monitor.index("0x2A5")
    monitor.expand(index)
    signal = monitor.detail(monitor.index("0x2A5"), "J2")
    asked: list[object] = []
    monitor.tree.curves_wanted.disconnect()
    monitor.tree.curves_wanted.connect(asked.append)
    monitor.tree.setCurrentIndex(signal)
    QTest.keyClick(monitor.tree, Qt.Key.Key_Return)
    assert asked == [["arm.joint_angle.2"]]
    assert monitor.window.isVisible()
    place = monitor.tree.visualRect(signal).center()
    assert monitor.window.quantities_at(monitor.tree.viewport().mapTo(monitor.window, place)) == [
        "arm.joint_angle.2"
    ]
    menu = menu_at(monitor, place)
    trigger(menu, "Show as curve")
    assert drawn(monitor) == "arm.joint_angle.2"


def menu_at(monitor, place: QPoint):
    ask_for_menu(monitor.tree.viewport(), place)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def test_the_menu_copies_a_frame_and_filters_by_it(monitor, company):
    company.say(UNKNOWN)
    monitor.run()
    monitor.tree.scrollTo(monitor.index("0x3C1"))
    place = monitor.tree.visualRect(monitor.index("0x3C1")).center()
    trigger(menu_at(monitor, place), "Copy 3C1#0102")
    assert QGuiApplication.clipboard().text() == "3C1#0102"
    trigger(menu_at(monitor, place), "Show this identifier alone")
    assert monitor.ids() == ["0x3C1"]


def test_bus_off_and_losses_are_said_in_words(monitor, monkeypatch):
    driver = monitor.driver
    assert not monitor.find("bus_message").isVisible()
    params = {"device": "can0", "interface": "socketcan", "channel": "can0"}
    driver.controller._connection.problem = BUS_OFF(**params)
    driver.step()
    worker = type(driver.controller._connection._worker)
    monkeypatch.setattr(worker, "frames_dropped", property(lambda _worker: 12))
    monitor.run()

    text = monitor.window.summary.message.text()
    assert "can0 is bus off" in text
    assert "12 frames were lost" in text
    assert monitor.read("bus_lost") == "12"
    driver.controller._connection.problem = None


def test_hidden_it_listens_to_nothing_and_begins_anew(monitor):
    connection = monitor.driver.controller._connection
    assert monitor.window.statistics in connection._listeners
    monitor.window.close()
    assert monitor.window.statistics not in connection._listeners
    assert not monitor.window._timer.isActive()
    monitor.driver.step()  # what was on its way has come
    waiting = len(monitor.window.statistics._waiting)
    monitor.driver.run(1.0)
    assert len(monitor.window.statistics._waiting) == waiting
    monitor.driver.click("bus_button")
    monitor.run(0.1)

    assert int(monitor.cell(monitor.index("0x2A5"), FrameColumn.COUNT)) < 40


def test_another_device_is_counted_by_itself(monitor):
    driver = monitor.driver
    driver.controller.disconnect_device()
    monitor.run()
    assert "0x2A5" in monitor.ids()  # what was counted stands
    driver.connect()
    monitor.run()
    assert "0x2A5" in monitor.ids()


def test_opened_before_any_device(app_driver):
    monitor = BusMonitor(app_driver)
    monitor.window.refresh()
    assert monitor.ids() == []
    app_driver.connect()
    monitor.run()

    assert ("0x2A5", "arm") in monitor.rows()
    assert "0x472" in monitor.ids()  # what this program asked


def test_a_codec_that_is_not_proven_is_said(monitor):
    message = monitor.find("bus_message")
    assert not message.isVisible()
    monitor.window.statistics.know_generation(None)
    monitor.window.refresh()

    assert message.isVisible()
    assert message.text().startswith("Generation not known yet")


@pytest.mark.styled
def test_in_a_narrow_window_the_data_are_seen_whole(monitor):
    window = monitor.window.window()
    window.resize(1500, 700)
    window.resize(800, 700)
    header = monitor.tree.header()
    right = header.sectionViewportPosition(FrameColumn.DATA) + header.sectionSize(FrameColumn.DATA)
    assert right <= monitor.tree.viewport().width()
    assert header.sectionSize(FrameColumn.SAYS) >= 220
    window.resize(2200, 700)
    assert header.length() <= monitor.tree.viewport().width()
