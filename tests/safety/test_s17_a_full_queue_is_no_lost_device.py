"""S17: a full transmit queue is waited for, said, and called what it is; only a loss is a loss."""

import errno

import can
import pytest
from can.interfaces.kvaser import constants as kvaser

from armui.arm.device import Device
from armui.bus.link import BUS_OFF as BUS_OFF_REASON
from armui.bus.link import BUS_SEND_BLOCKED, BUS_UNACKNOWLEDGED, BusHealth, BusState
from armui.bus.send_errors import queue_is_full
from armui.control.link.link_state import LinkState
from armui.ui import words
from tests.accepted import accepted


class USBTimeoutError(OSError):
    """As pyusb has it; the package itself is not needed for the tests."""


def caused(error, cause):
    error.__cause__ = cause
    return error


FULL = [
    can.CanOperationError("Transmit buffer full"),  # socketcan, after its time-out
    can.CanOperationError("Failed to transmit: No buffer space available", errno.ENOBUFS),
    can.CanOperationError("Failed to transmit", errno.EAGAIN),
    caused(
        can.CanOperationError("The message could not be sent"),  # gs_usb
        OSError(errno.ETIMEDOUT, "Operation timed out"),
    ),
    caused(
        can.CanOperationError("The message could not be sent"), USBTimeoutError(-116, "timeout")
    ),
    can.CanTimeoutError("Send timed out after 0.05 seconds"),  # canalystii, serial, ixxat
    can.CanOperationError("Failed to send: The transmit queue is full"),  # PCAN
    can.CanOperationError("Failed to send: The CAN controller is in bus-off state."),
    can.CanOperationError("Could not send message to one or more recipients"),  # virtual
]

GONE = [
    can.CanOperationError("Failed to transmit: No such device", errno.ENODEV),
    can.CanOperationError("Failed to transmit: Network is down", errno.ENETDOWN),
    caused(
        can.CanOperationError("The message could not be sent"), OSError(errno.ENODEV, "unplugged")
    ),
    can.CanOperationError("writing to closed port"),
    can.CanOperationError("Cannot operate on a closed bus"),
    ValueError("something else"),
]


@pytest.mark.parametrize("error", FULL, ids=str)
def test_a_full_queue_is_told_from(error):
    assert queue_is_full(error)


@pytest.mark.parametrize("error", GONE, ids=str)
def test_a_device_that_is_gone(error):
    assert not queue_is_full(error)


def test_the_makers_numbers_are_not_taken_for_those_of_the_operating_system():
    class CANLIBOperationError(can.CanOperationError):
        __module__ = "can.interfaces.kvaser.canlib"

    assert queue_is_full(CANLIBOperationError("x", kvaser.canERR_TXBUFOFL))
    assert not queue_is_full(CANLIBOperationError("x", kvaser.canERR_NOTFOUND))


def fill(rig, error=FULL[0]):
    """From now on no frame of the program gets out; answers a list that grows with each try."""
    tries = []

    def full(*_args, **_kwargs):
        tries.append(rig.time_s)
        raise error

    rig._host_bus.send = full
    return tries


def empty(rig):
    del rig._host_bus.send


def step_blocked(rig, qtbot, tries, seconds):
    """Let time pass although something waits; the rig's own step waits until nothing does."""
    connection = rig.controller._connection
    for _ in range(round(seconds / 0.1)):
        before = len(tries)
        # the sending thread looks at the queue at each moment of the arm's time
        qtbot.waitUntil(lambda before=before: len(tries) > before or connection.idle)
        for _ in range(5):
            rig.time_s += 0.02
            rig.node.poll(0.02)
            rig.controller.tick()


@pytest.mark.parametrize("error", [FULL[0], FULL[3]], ids=["socketcan", "gs_usb"])
def test_it_is_waited_for_and_after_half_a_second_called_what_it_is(rig, qtbot, error):
    rig.ready()
    tries = fill(rig, error)
    accepted(rig.controller.motion.send_joints((10.0, 0.0, 0.0, 0.0, 0.0, 0.0)))
    step_blocked(rig, qtbot, tries, 0.7)
    qtbot.waitUntil(lambda: "bus_blocked" in rig.codes())
    told = next(each for each in rig.events if each.code == "bus_blocked")
    assert told.params["reason"].reason == BUS_SEND_BLOCKED  # the arm is heard all the while
    assert "link_lost" not in rig.codes()
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert "Unplug the adapter" in words.event(told)
    empty(rig)
    rig.heard()
    rig.step()
    assert rig.heard() == []  # too old: it would act late
    accepted(rig.controller.motors.enable())
    qtbot.waitUntil(lambda: "bus_unblocked" in rig.codes())


def test_a_stop_waits_in_front_and_goes_out_when_the_queue_takes_it(rig, qtbot):
    rig.ready()
    tries = fill(rig)
    rig.controller.motion.send_joints((10.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    rig.controller.emergency_stop()
    assert rig.codes()[-1] == "stop_not_sent"
    step_blocked(rig, qtbot, tries, 1.0)
    assert not rig.firmware.condition.stopped
    rig.heard()
    empty(rig)
    qtbot.waitUntil(lambda: rig.controller._connection.idle)
    assert {each.arbitration_id for each in rig.heard()} == {0x150}
    rig.run_until(lambda: "stop_confirmed" in rig.codes())


def test_nothing_that_waited_is_sent_after_a_loss(rig, qtbot):
    rig.ready()
    fill(rig)
    rig.controller.motion.send_joints((10.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    rig.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: rig.controller.operating_state.link is LinkState.LOST)
    rig.heard()
    rig.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())
    rig.run(1.0)
    assert not {0x155, 0x156, 0x157} & {each.arbitration_id for each in rig.heard()}


# Error frames -------------------------------------------------------------------------------------

BUS_OFF, WARNING, RESTARTED = 0x040, 0x004, 0x100


def test_bus_off_is_said_until_frames_are_heard_again():
    health = BusHealth(Device("socketcan", "can0", None))
    health.on_error_frame(WARNING)
    assert health.problem(1.0, blocked=False) is None
    health.on_error_frame(BUS_OFF)
    problem = health.problem(1.0, blocked=False)
    assert (problem.code, problem.params["channel"]) == ("bus_off", "can0")
    health.on_frame(2.0)
    assert health.problem(2.0, blocked=False) is None
    health.on_error_frame(BUS_OFF)
    health.on_error_frame(RESTARTED)
    assert health.problem(3.0, blocked=False) is None


def test_who_is_to_blame_is_told_by_what_is_heard():
    health = BusHealth(Device("socketcan", "can0", None))
    assert health.problem(1.0, blocked=True).reason == BUS_UNACKNOWLEDGED
    health.on_frame(1.0)
    assert health.problem(1.4, blocked=True).reason == BUS_SEND_BLOCKED
    assert health.problem(1.6, blocked=True).reason == BUS_UNACKNOWLEDGED


def test_error_frames_of_another_layout_are_not_read():
    health = BusHealth(Device("pcan", "PCAN_USBBUS1"))
    health.on_error_frame(BUS_OFF)
    assert health.problem(1.0, blocked=False) is None


def test_bus_off_reaches_the_operator(rig, qtbot, monkeypatch):
    monkeypatch.setattr("armui.bus.link.LINUX_ERROR_FRAMES", frozenset({"virtual"}))
    rig.connect()
    rig._arm_bus.send(
        can.Message(arbitration_id=BUS_OFF, is_error_frame=True, data=bytes(8), is_extended_id=True)
    )
    qtbot.waitUntil(lambda: "bus_blocked" in rig.codes())
    told = next(each for each in rig.events if each.code == "bus_blocked")
    assert told.params["reason"].reason == BUS_OFF_REASON
    assert rig.controller.operating_state.link_problem.reason == BUS_OFF_REASON
    rig.run(0.1)
    qtbot.waitUntil(lambda: "bus_unblocked" in rig.codes())
    assert BusState.BLOCKED is not rig.controller._connection._bus_state
