"""An operator at the page 关节状态: faults in the simulated arm in, words on the screen out."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QTableView

from armui.arm.joint_status import StatusVerdict
from armui.control.link.link_state import NOT_CONNECTED, LinkState
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.ui.watch.joint_status_page import JointStatusPage
from armui.ui.widgets.message_line import MessageLine
from tests.accepted import accepted
from tests.faulty_arm import FaultyDrivers
from tests.generations import ONE_IS_ENOUGH

ROWS = {
    Generation.ONE: [
        "Status code:",
        "Supply voltage:",
        "Motor temperature:",
        "Driver current:",
        "Driver temperature:",
        "Sensor:",
        "Driver error:",
        "Driver enabled:",
        "Homing:",
        "Joint communication:",
    ],
    Generation.TWO: [
        "Status code:",
        "Supply voltage:",
        "Motor temperature:",
        "Driver current:",
        "Driver temperature:",
        "Collision protection:",
        "Driver error:",
        "Driver enabled:",
        "Stall protection:",
        "Joint communication:",
    ],
}
FAULTS = {
    0: ("Supply voltage:", "Too low"),
    1: ("Motor temperature:", "Too hot"),
    2: ("Driver current:", "Overcurrent"),
    3: ("Driver temperature:", "Too hot"),
    5: ("Driver error:", "Error"),
}
OF_GENERATION = {
    Generation.ONE: {**FAULTS, 4: ("Sensor:", "Abnormal")},
    Generation.TWO: {
        **FAULTS,
        4: ("Collision protection:", "Triggered"),
        7: ("Stall protection:", "Triggered"),
    },
}


class Table:
    """The open page as an operator reads it."""

    def __init__(self, app_driver):
        app_driver.click("joint_status_button")
        self.page = app_driver.page(JointStatusPage)
        self.view = self.page.findChild(QTableView)
        self.model = self.view.model()

    def rows(self):
        return [
            self.model.headerData(row, Qt.Orientation.Vertical)
            for row in range(self.model.rowCount())
        ]

    def index(self, item, joint):
        return self.model.index(self.rows().index(item), joint - 1)

    def read(self, item, joint):
        return self.index(item, joint).data()

    def tip(self, item, joint):
        return self.index(item, joint).data(Qt.ItemDataRole.ToolTipRole)

    def unusual(self):
        """Every cell that is not as it is when all is well: row, joint, word."""
        well = {"Normal", "Enabled", "Homed"}
        return [
            (item, joint, self.read(item, joint))
            for item in self.rows()[1:]
            for joint in range(1, 7)
            if self.read(item, joint) not in well
        ]


@pytest.fixture
def ready(any_driver):
    """Connected and enabled, with drivers that can be made to complain."""
    any_driver.faults = FaultyDrivers(any_driver.firmware)
    any_driver.connect()
    any_driver.enable_by_hand()
    any_driver.heard()
    return any_driver


def button(app_driver):
    return app_driver.find("joint_status_button")


def test_before_connecting_every_cell_is_empty_and_the_button_knows_nothing(app_driver):
    assert button(app_driver).state_text == "Unknown —"
    table = Table(app_driver)
    words = {table.read(item, joint) for item in table.rows() for joint in range(1, 7)}
    assert words == {"—"}


def test_an_arm_without_faults_is_normal_in_every_cell(ready):
    table = Table(ready)
    ready.step()
    generation = ready.firmware.generation
    assert table.rows() == ROWS[generation]
    assert table.unusual() == []
    # generation 1 has come home once: bit 7
    assert table.read("Status code:", 3) == ("0xC0" if generation is Generation.ONE else "0x40")
    assert button(ready).state_text == "Normal"


def test_each_fault_is_in_its_cell_and_in_the_button_and_goes_when_it_ends(ready):
    table = Table(ready)
    for bit, (item, word) in OF_GENERATION[ready.firmware.generation].items():
        ready.faults.bits[3] = 1 << bit
        ready.run(0.12)
        assert table.unusual() == [(item, 3, word)]
        assert int(table.read("Status code:", 3), 16) & 1 << bit
        assert button(ready).state_text == "Fault J3"
        assert f"J3  {item} {word}" in button(ready).toolTip()

        ready.faults.bits.clear()
        ready.run(0.12)
        assert table.unusual() == []
        assert button(ready).state_text == "Normal"


def test_a_joint_the_controller_cannot_talk_to(ready):
    table = Table(ready)
    ready.firmware.set_communication_fault(5, present=True)
    ready.run(0.1)
    assert table.unusual() == [("Joint communication:", 5, "Abnormal")]
    assert button(ready).state_text == "Fault J5"
    ready.firmware.set_communication_fault(5, present=False)
    ready.run(0.1)
    assert table.unusual() == []
    assert button(ready).state_text == "Normal"


@ONE_IS_ENOUGH
def test_disabled_motors_are_said_in_the_table_and_in_the_button(any_driver):
    any_driver.connect()
    table = Table(any_driver)
    any_driver.step()
    assert table.unusual() == [("Driver enabled:", joint, "Disabled") for joint in range(1, 7)]
    assert button(any_driver).state_text == "Disabled"


@ONE_IS_ENOUGH
def test_the_figures_stand_beside_the_words(ready):
    table = Table(ready)
    ready.step()
    assert " V · since " in table.tip("Supply voltage:", 1)
    assert "°C" in table.tip("Motor temperature:", 1)
    assert " A · " in table.tip("Driver current:", 1)
    assert "Enabled · 0.0°/s · since " in table.tip("Driver enabled:", 2)


def test_a_silent_driver_is_stale_and_the_button_names_it(ready):
    table = Table(ready)
    ready.faults.silent.add(4)
    ready.run(0.8)
    assert "not heard of late" in table.tip("Supply voltage:", 4)
    assert "not heard of late" not in table.tip("Supply voltage:", 3)
    assert button(ready).state_text == "Unknown J4"
    assert ready.read("recovery_text").startswith("Nothing is heard from the motor of joint 4.")


@ONE_IS_ENOUGH
def test_a_silent_arm_is_offline_and_its_table_stale(ready):
    table = Table(ready)
    ready.powered = False
    ready.run(0.8)
    assert button(ready).state_text == "Offline"
    assert "not heard of late" in table.tip("Joint communication:", 1)
    assert not table.page.clear_buttons[1].isEnabled()
    assert "nothing is heard" in table.page.clear_buttons[1].toolTip()
    ready.powered = True
    ready.run_until(lambda: button(ready).state_text == "Normal")
    assert table.page.clear_buttons[1].isEnabled()


@ONE_IS_ENOUGH
def test_disconnecting_leaves_nothing_standing(ready):
    table = Table(ready)
    ready.controller.disconnect_device()
    assert ready.controller.operating_state.link is LinkState.NO_DEVICE
    words = {table.read(item, joint) for item in table.rows() for joint in range(1, 7)}
    assert words == {"—"}
    assert button(ready).state_text == "Unknown —"


def test_connecting_accuses_no_arm_of_bits_of_the_other_generation(any_driver):
    """Bit 7 is «homed» in generation 1; until the arm has said which it speaks it says nothing."""
    seen = []
    monitor = any_driver.window._joint_monitor
    monitor.worst_changed.connect(lambda: seen.append(monitor.worst.verdict))
    any_driver.connect()
    assert StatusVerdict.FAULT not in seen
    assert seen[-1] is StatusVerdict.DISABLED


@ONE_IS_ENOUGH
def test_a_hidden_page_does_no_work_and_catches_up(ready):
    table = Table(ready)
    table.page.close()
    ready.faults.bits[2] = 0x01
    ready.run(0.2)
    assert table.read("Supply voltage:", 2) == "Normal"
    assert button(ready).state_text == "Fault J2"
    ready.click("joint_status_button")
    assert table.read("Supply voltage:", 2) == "Too low"


@ONE_IS_ENOUGH
def test_it_stays_in_sight_beside_the_panel_that_moves_the_arm(ready):
    table = Table(ready)
    assert table.page.window() is ready.window
    ready.click("jog_plus_1")
    ready.run_until(lambda: round(ready.firmware.joints_deg[0], 3) == 1)
    assert table.page.isVisible()
    assert ready.find("jog_plus_1").isVisible()


@pytest.fixture
def in_english_again(ready):
    """The words belong to the application, which the next test uses too."""
    yield
    ready.store.change(language="en")


@pytest.mark.usefixtures("in_english_again")
def test_the_language_changes_while_it_is_open(ready):
    table = Table(ready)
    ready.faults.bits[1] = 0x05
    ready.run(0.2)
    ready.store.change(language="zh")
    QApplication.processEvents()
    assert table.page.title == "关节状态"
    last_but_one = "回零状态:" if ready.firmware.generation is Generation.ONE else "堵转保护:"
    assert table.rows()[:5] == ["状态码:", "电源电压:", "电机温度:", "驱动器电流:", "驱动器温度:"]
    assert table.rows()[6:] == ["驱动器错误状态:", "驱动器使能状态:", last_but_one, "关节通讯:"]
    assert table.read("电源电压:", 1) == "过低"
    assert table.read("驱动器电流:", 1) == "过流"
    assert table.read("驱动器使能状态:", 1) == "使能"
    assert button(ready).state_text == "有故障 J1"


def test_the_keyboard_opens_it_and_reads_a_cell_in_full(ready):
    button(ready).setFocus()
    QTest.keyClick(button(ready), Qt.Key.Key_Space)
    page = ready.page(JointStatusPage)
    view = page.findChild(QTableView)
    view.setFocus()
    view.setCurrentIndex(view.model().index(1, 0))
    QTest.keyClick(view, Qt.Key.Key_Right)
    detail = page.findChild(QLabel, "joint_status_detail").text()
    assert detail.startswith("J2  Supply voltage: Normal · ")


# Clearing errors ----------------------------------------------------------------------------------

CLEAR_2 = {
    Generation.ONE: Frame(0x475, bytes.fromhex("02 00 00 00 00 AE 00 00")),
    Generation.TWO: Frame(0x475, bytes.fromhex("02 00 00 7F FF AE 00 00")),
}


def message(table):
    return table.page.findChild(MessageLine, "joint_status_message").text()


def test_clearing_an_error_sends_it_and_waits_for_the_arms_answer(ready):
    table = Table(ready)
    ready.click(table.page.clear_buttons[2])
    assert "Clear error sent to joint 2" in message(table)
    ready.step()
    assert ready.heard() == [CLEAR_2[ready.firmware.generation]]
    assert message(table).startswith("Joint 2: the arm has confirmed")
    assert ready.codes()[-2:] == ["clear_error_sent", "clear_error_answered"]


@ONE_IS_ENOUGH
def test_no_answer_within_a_second_is_said(ready):
    table = Table(ready)
    ready.firmware.on_frame = lambda _frame: []
    ready.click(table.page.clear_buttons[6])
    ready.run(0.9)
    assert ready.codes()[-1] == "clear_error_sent"
    ready.run(0.2)
    assert ready.codes()[-1] == "clear_error_unanswered"
    assert message(table).startswith("Joint 6: the arm did not confirm")


@ONE_IS_ENOUGH
def test_one_error_at_a_time(ready):
    table = Table(ready)
    ready.click(table.page.clear_buttons[1])
    ready.click(table.page.clear_buttons[4])
    assert "clearing a joint's error" in message(table)
    ready.run(0.1)
    assert len(ready.heard()) == 1


@ONE_IS_ENOUGH
def test_a_stopped_arm_may_be_asked_too(ready):
    ready.controller.emergency_stop()
    ready.run_until(lambda: "stop_confirmed" in ready.codes())
    accepted(ready.controller.joint_errors.clear(1))
    ready.step()
    assert ready.codes()[-1] == "clear_error_answered"


def test_an_answer_to_nothing_is_no_answer(ready):
    ready.run(2.0)
    assert not {"clear_error_answered", "clear_error_unanswered"} & set(ready.codes())


@ONE_IS_ENOUGH
def test_after_disconnecting_no_answer_is_missed(ready):
    accepted(ready.controller.joint_errors.clear(1))
    ready.controller.disconnect_device()
    ready.connect()
    ready.run(1.2)
    assert "clear_error_unanswered" not in ready.codes()


def test_without_an_arm_nothing_is_cleared(app_driver):
    assert app_driver.controller.joint_errors.clear(1).reason == NOT_CONNECTED
    assert app_driver.codes() == ["refused"]
