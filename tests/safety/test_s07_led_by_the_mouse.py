"""S7: the mouse leads a simulated arm that gives way, by the simulator's hand, and no other arm."""

import time
from dataclasses import replace

import can
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.app import open_device
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.simulated_arms import SIMULATED, SimulatedArms
from armui.system.paths import URDF
from armui.viewport.client import PictureClient
from armui.viewport.grips import GripKind
from armui.viewport.handles import HandleKind
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from tests.picture_hand import Hand
from tests.sim.talk import ENABLE, frame

RECORD = "150#0000010000000000"
WITHIN_S = 30.0
MOTION_FRAMES = {*range(0x150, 0x160)} - {0x15A, 0x15F}


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


class Spy:
    """The simulator's hand; says what it was told."""

    def __init__(self, hand):
        self.hand = hand
        self.told = []

    def lead_to(self, joints_deg, speed_deg_s=30.0):
        self.told.append(tuple(joints_deg))
        self.hand.lead_to(joints_deg, speed_deg_s)

    def release(self):
        self.told.append(None)
        self.hand.release()


class Teacher(Hand):
    """At 示教, with the picture beside it."""

    def __init__(self, app_driver, shape):
        super().__init__(app_driver, shape, kind=None)
        app_driver.click("menu_teaching")
        self.spy = Spy(app_driver.firmware.hand_guiding)
        app_driver.window._picture._led_arm._hand = lambda: self.spy

    def record(self):
        self.app_driver.click("teaching_start_recording")
        self.app_driver.confirm()
        self.app_driver.run_until(lambda: "Recording" in self.app_driver.read("teaching_phase"))
        self.app_driver.heard()
        self.look()

    def take(self, number):
        """Take the arc of a joint; returns the place, and one further along it."""
        grip = self.grip(GripKind.JOINT, number)
        at = np.array(self.place_on(grip))
        away = at - self.view.projection.pixel(grip.origin)
        self.press(tuple(at))
        return at, at + np.array([-away[1], away[0]]) * 0.4

    @property
    def joints_deg(self):
        return self.app_driver.firmware.joints_deg

    def sent(self):
        return [each for each in self.app_driver.heard() if each.arbitration_id in MOTION_FRAMES]


@pytest.fixture
def teacher(app_driver, shape):
    return Teacher(app_driver, shape)


def note(teacher):
    line = teacher.app_driver.find("picture_note")
    return line.text() if line.isVisible() else ""


def test_the_mouse_leads_the_simulated_arm_and_it_records_that(teacher):
    teacher.record()
    assert "lead it by the handles" in note(teacher)
    _, there = teacher.take(1)
    teacher.move(tuple(there))
    goal = teacher.spy.told[-1]
    assert abs(goal[0]) > 5.0
    assert teacher.joints_deg[0] == pytest.approx(0.0, abs=0.1)  # a hand takes its time
    teacher.app_driver.run(3.0)
    assert teacher.joints_deg == pytest.approx(goal, abs=0.1)
    teacher.release(tuple(there))
    assert teacher.spy.told[-1] is None
    assert teacher.sent() == []  # no bus is needed for it
    teacher.app_driver.click("teaching_stop_recording")
    phase = "nothing under way"
    teacher.app_driver.run_until(lambda: phase in teacher.app_driver.read("teaching_phase"))
    recorded = np.array(teacher.app_driver.firmware.teaching.recording)
    assert np.ptp(recorded[:, 0]) == pytest.approx(abs(goal[0]), abs=0.2)
    teacher.look()
    assert teacher.view._handles.place is None
    assert note(teacher) == ""


def test_an_arm_that_is_let_go_stays_where_it_has_come_to(teacher):
    teacher.record()
    _, there = teacher.take(1)
    teacher.move(tuple(there))
    goal = teacher.spy.told[-1][0]
    teacher.app_driver.run(0.1)
    teacher.release(tuple(there))
    teacher.app_driver.run(0.1)
    rested = teacher.joints_deg
    assert 0.5 < abs(rested[0]) < abs(goal) - 0.5
    teacher.app_driver.run(1.0)
    assert teacher.joints_deg == pytest.approx(rested, abs=0.01)


def test_the_chosen_handles_lead_it_too(teacher):
    teacher.record()
    teacher.choose(HandleKind.TOOL)
    teacher.look()
    assert teacher.view._handles.place.kind is HandleKind.TOOL


@pytest.mark.parametrize("end", ["escape", "back", "stop", "hidden", "unplugged"])
def test_whatever_ends_the_drag_no_hand_stays_on_the_arm(teacher, end):
    teacher.record()
    at, there = teacher.take(1)
    teacher.move(tuple(there))
    teacher.app_driver.run(0.1)
    if end == "escape":
        QTest.keyClick(teacher.view, Qt.Key.Key_Escape)
    elif end == "back":
        teacher.move(tuple(at))
        teacher.release(tuple(at))
    elif end == "stop":
        teacher.app_driver.click("stop_button")
        teacher.app_driver.run(0.2)
        teacher.look()
    elif end == "hidden":
        teacher.view.hide()
    else:
        teacher.app_driver.unplug(OSError("gone"))
        teacher.app_driver.run(1.0)
        teacher.look()
    assert teacher.spy.told[-1] is None
    told = len(teacher.spy.told)
    teacher.move(tuple(there))
    assert len(teacher.spy.told) == told


def test_an_arm_that_is_not_simulated_here_is_never_led(app_driver, shape):
    """As a simulated one of another process, or a real one, would be connected."""
    app_driver.device = replace(app_driver.device, simulated=False)
    teacher = Teacher(app_driver, shape)
    assert not app_driver.controller.operating_state.device.simulated
    teacher.record()
    assert teacher.view._handles.place is None
    assert note(teacher) == ""
    middle = (teacher.view.width() / 2.0, teacher.view.height() / 2.0)
    teacher.press(middle)
    teacher.move((middle[0] + 60.0, middle[1] + 20.0))
    teacher.release((middle[0] + 60.0, middle[1] + 20.0))
    app_driver.run(0.5)
    assert teacher.spy.told == []
    assert teacher.sent() == []
    assert teacher.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)


def test_a_simulated_arm_that_does_not_give_way_is_never_led(teacher):
    teacher.app_driver.click("menu_motion")
    teacher.choose(HandleKind.JOINTS)
    teacher.drag(teacher.grip(GripKind.JOINT, 1), (10.0, 6.0))
    teacher.app_driver.run(0.5)
    assert teacher.spy.told == []
    assert teacher.sent() == []
    assert teacher.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)


def test_a_late_picture_leads_nothing(teacher, monkeypatch):
    teacher.record()
    grip = teacher.grip(GripKind.JOINT, 1)
    at = teacher.place_on(grip)
    monkeypatch.setattr(PictureClient, "is_stale", True)
    teacher.press(at)
    teacher.move((at[0] + 20.0, at[1] + 20.0))
    teacher.release((at[0] + 20.0, at[1] + 20.0))
    assert teacher.spy.told == []


def test_the_hand_is_there_for_as_long_as_the_simulated_arm():
    arms = SimulatedArms()
    there = []
    real = replace(SIMULATED[0], simulated=False, channel="nothing-simulated")
    for device in (SIMULATED[0], real):
        there.append(arms.hand is not None)
        with open_device(device, arms):
            there.append(arms.hand is not None)
        there.append(arms.hand is not None)
    assert there == [False, True, False, False, False, False]


def test_the_hand_reaches_the_arm_in_its_process():
    """In drag teaching it follows, as it is told on the bus; without a hand it stays."""
    arms, codec = SimulatedArms(joints_deg=(0.0,) * 6), Codec(Generation.TWO)

    def turned_to(bus, angle_deg):
        until_s = time.monotonic() + WITHIN_S
        while time.monotonic() < until_s:
            if (heard := bus.recv(1.0)) is None or heard.arbitration_id != 0x2A5:
                continue
            message = codec.decode(Frame(heard.arbitration_id, bytes(heard.data)))
            if abs(message.signals["J1"] - angle_deg) < 0.05:
                return True
        return False

    with open_device(SIMULATED[0], arms) as bus:
        arms.hand.lead_to((10.0, 0.0, 0.0, 0.0, 0.0, 0.0))  # does not give way yet
        for text in (ENABLE, RECORD):
            identifier, data = frame(text)
            bus.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=False))
        arms.hand.lead_to((20.0, 0.0, 0.0, 0.0, 0.0, 0.0), 60.0)
        assert turned_to(bus, 20.0)
        arms.hand.release()
        assert turned_to(bus, 20.0)
