"""S20: ending the program ends its motion first, waits with a limit and never blocks the window."""

import threading
import time
from contextlib import contextmanager

import can
import pytest
from PySide6.QtWidgets import QApplication

from armui.arm.device import Device
from armui.bus import worker
from armui.control.arm_controller import ArmController
from armui.control.link.link_state import LinkState
from armui.control.motion.jog_path import JointJog
from armui.control.motion.jogging import Jogging
from armui.control.run.progress import Run
from armui.protocol.codes import MoveMode
from armui.protocol.frame import Frame
from armui.trajectory.points.program import Waypoint
from armui.ui.dialogs.confirm_dialog import CloseQuestion, ConfirmDialog
from armui.ui.shell.leaving import gives_way
from tests.accepted import accepted
from tests.arm_rig import TIMEOUT_MS
from tests.failing import failing, functions_of

FAR = (60.0, 60.0, -60.0, 0.0, 0.0, 0.0)
ABORT = bytes([0, 6, 0, 0, 0, 0, 0, 0])  # 0x150 byte 1: the trajectory command 6, end it


class SlowOpener:
    """Opens a device when it is told to, as a driver that takes seconds."""

    def __init__(self, channel):
        self.channel = channel
        self.free = threading.Event()
        self.begun = threading.Event()
        self.open = 0

    @contextmanager
    def __call__(self, _device):
        self.begun.set()
        assert self.free.wait(TIMEOUT_MS / 1e3)
        with can.Bus(interface="virtual", channel=self.channel) as bus:
            self.open += 1
            yield bus
            self.open -= 1


@pytest.fixture
def opener(request):
    opener = SlowOpener(request.node.nodeid)
    yield opener
    opener.free.set()


def spin_until(condition):
    deadline = time.monotonic() + TIMEOUT_MS / 1e3
    while not condition():
        QApplication.processEvents()
        assert time.monotonic() < deadline


def connected(opener, find=list):
    controller = ArmController(opener, find=find)
    controller.connect_device(Device("virtual", opener.channel, None))
    assert opener.begun.wait(TIMEOUT_MS / 1e3)
    return controller


def test_disconnecting_does_not_wait_for_a_driver_that_opens(qapp, opener):
    """The driver lets go only after the window has: a wait without a limit would never end."""
    controller = connected(opener)
    controller.disconnect_device()
    assert controller.operating_state.link is LinkState.NO_DEVICE
    assert not opener.free.is_set()
    assert len(controller._connection._ending) == 1
    opener.free.set()
    spin_until(lambda: not controller._connection._ending)
    assert opener.open == 0
    assert controller.shutdown()


def test_the_same_device_is_opened_again_only_when_it_was_closed(qapp, opener):
    controller = connected(opener)
    opener.begun.clear()
    controller.connect_device(Device("virtual", opener.channel, None))
    assert not opener.begun.is_set()
    opener.free.set()
    spin_until(lambda: controller.operating_state.link is LinkState.OFFLINE)
    assert opener.open == 1
    assert controller.shutdown()
    assert opener.open == 0


def test_the_end_waits_for_a_driver_with_a_limit(qapp, opener):
    controller = connected(opener)
    assert controller.shutdown() is False
    assert not opener.free.is_set()
    opener.free.set()
    spin_until(controller.shutdown)


def test_the_end_waits_for_a_search_with_a_limit_and_ends_the_motion_before(qapp, rig):
    free, searching = threading.Event(), threading.Event()

    def find():
        searching.set()
        assert free.wait(TIMEOUT_MS / 1e3)
        return []

    rig.ready()
    rig.controller._finder._find = find
    rig.controller.search_devices()
    assert searching.wait(TIMEOUT_MS / 1e3)
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(1.0)
    rig.heard()
    assert rig.controller.shutdown() is False
    assert (0x150, ABORT) in frames(rig)
    free.set()
    spin_until(rig.controller.shutdown)


def frames(rig):
    return [(frame.arbitration_id, bytes(frame.data)) for frame in rig.heard()]


def test_ending_the_program_ends_a_single_motion(any_rig):
    rig = any_rig
    rig.ready()
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(1.0)
    rig.heard()
    rig.controller.shutdown()
    assert (0x150, ABORT) in frames(rig)


def lose_aborts(rig, most):
    """The arm does not hear the first ends of a motion that it is told."""
    to_arm = rig.node.link.to_arm
    lost: list[Frame] = []

    def without(frames, at_s):
        reached = to_arm(frames, at_s)
        for frame in [each for each in reached if bytes(each.data) == ABORT][: most - len(lost)]:
            reached.remove(frame)
            lost.append(frame)
        return reached

    rig.node.link.to_arm = without
    return lost


@pytest.mark.each_value(full="each loss in both generations")
@pytest.mark.parametrize("missed", [0, 1, 3])
def test_an_end_that_the_arm_did_not_hear_is_told_again(any_rig, missed):
    rig = any_rig
    rig.ready()
    rig.controller.motion.set_speed_percent(20)
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(1.0)
    rig.heard()
    lost, began_s = lose_aborts(rig, missed), rig.time_s
    rig.controller.shutdown()
    assert len(lost) == missed
    assert frames(rig).count((0x150, ABORT)) > missed
    assert max(map(abs, rig.firmware.mechanics.speeds_deg_s)) < 1.0
    assert rig.time_s - began_s < 0.55


def test_an_arm_that_does_not_listen_is_told_for_half_a_second(rig):
    rig.ready()
    rig.controller.motion.set_speed_percent(20)
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(1.0)
    rig.heard()
    lost, began_s = lose_aborts(rig, 100), rig.time_s
    rig.controller.shutdown()
    # each 0.1 s, and once more by the controller's tick after 0.3 s
    assert len(lost) == frames(rig).count((0x150, ABORT)) == 6
    assert rig.time_s - began_s == pytest.approx(0.5, abs=0.03)


def test_a_jog_that_cannot_be_ended_does_not_keep_the_program_open(rig):
    rig.ready()
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.run(0.5)
    with failing(*(each for each in functions_of(Jogging) if each.__name__ == "end_jog")):
        assert rig.controller.shutdown()
    assert rig.controller.operating_state.link is LinkState.NO_DEVICE
    assert max(map(abs, rig.firmware.mechanics.speeds_deg_s)) < 1.0


def test_the_end_of_a_run_leaves_though_the_device_is_closed_behind_it(rig, monkeypatch):
    monkeypatch.setattr(worker, "_LAST_S", TIMEOUT_MS / 1e3)
    rig.ready()
    run = Run("run", [Waypoint(MoveMode.MOVE_J, (140.0, *FAR[1:]))], [2.0])
    accepted(rig.controller.player.start(run))
    rig.run(0.5)
    rig.heard()
    rig.hold_driver()
    accepted(rig.controller.motion.set_speed_percent(50))
    rig.step()  # the driver has it by then: the window's thread may not send past it
    bus_thread = rig.controller._connection._worker
    rig.controller.disconnect_device()
    rig.free_driver()
    assert bus_thread.released.wait(TIMEOUT_MS / 1e3)
    assert (0x150, ABORT) in frames(rig)


def test_at_rest_nothing_is_sent_at_the_end(any_rig):
    rig = any_rig
    rig.ready()
    rig.run(1.0)
    rig.heard()
    rig.controller.shutdown()
    assert rig.heard() == []


def moving(app_driver):
    app_driver.connect_by_hand()
    app_driver.enable_by_hand()
    accepted(app_driver.controller.motion.send_joints(FAR))
    app_driver.run_until(lambda: app_driver.controller.operating_state.moving)
    app_driver.run(0.5)
    app_driver.heard()
    app_driver.window.close()
    assert app_driver.window.isVisible()
    return app_driver.dialog(CloseQuestion)


def test_closing_the_window_ends_the_motion_first(any_driver):
    question = moving(any_driver)
    any_driver.click(question.action_button)
    assert (0x150, ABORT) in frames(any_driver)
    assert any_driver.window.isVisible()
    any_driver.run_until(lambda: not any_driver.window.isVisible(), seconds=4.0)
    assert not any_driver.controller.operating_state.moving


def test_the_operator_may_let_it_finish(any_driver):
    question = moving(any_driver)
    any_driver.click(question.let_finish_button)
    assert not any_driver.window.isVisible()
    any_driver.program.shutdown()
    assert (0x150, ABORT) not in frames(any_driver)


def test_an_arm_that_does_not_come_to_rest_keeps_no_window(app_driver):
    question = moving(app_driver)
    app_driver.firmware.on_frame = lambda _frame: []
    app_driver.click(question.action_button)
    assert app_driver.window.isVisible()
    (ending,) = [one for one in app_driver.window.children() if type(one).__name__ == "_Ending"]
    ending._limit.timeout.emit()
    assert not app_driver.window.isVisible()


def test_the_stop_in_the_question_closes_nothing(app_driver):
    moving(app_driver)
    app_driver.controller.emergency_stop()
    app_driver.run(0.5)
    assert not app_driver.window.findChildren(CloseQuestion)
    assert app_driver.window.isVisible()


def test_the_question_goes_once_the_arm_has_arrived(app_driver):
    moving(app_driver)
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving, seconds=20.0)
    app_driver.run(0.2)
    assert not app_driver.window.findChildren(CloseQuestion)
    assert app_driver.window.isVisible()
    assert app_driver.window.close()
    assert not app_driver.window.isVisible()


def test_while_the_arm_sinks_closing_asks_and_the_question_goes_with_it(app_driver):
    app_driver.lie((0.0, 12.0, -15.0, 0.0, 0.0, 0.0))
    app_driver.ready()
    app_driver.controller.emergency_stop()
    app_driver.run_until(lambda: gives_way(app_driver.controller.operating_state))
    app_driver.window.close()
    assert app_driver.window.isVisible()
    assert "does not hold it" in app_driver.dialog(ConfirmDialog).text()
    app_driver.run_until(lambda: not gives_way(app_driver.controller.operating_state), 60.0)
    app_driver.run(0.2)
    assert not app_driver.window.findChildren(ConfirmDialog)
    assert app_driver.window.close()
