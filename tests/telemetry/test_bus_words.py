"""Who sends a frame, what an error frame says, and which curve a signal is drawn as."""

import pytest

from armui.protocol.addressing import Addressing
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from armui.telemetry.bus_errors import BusError, errors_of
from armui.telemetry.bus_senders import FIXED_FEEDBACK, Sender, sender_of, speaks_for_arm
from armui.telemetry.quantities import QUANTITIES, quantity_key

# Senders ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("generation", Generation)
def test_senders_are_those_of_the_protocol(generation):
    for message in load_database(generation).messages:
        sender = sender_of(Frame(message.frame_id, bytes(8)), 0, Addressing())
        # both send the version's; and a leader arm (0x470) sends commands as hosts do
        by_host = "HOST" in message.senders and message.name != "FirmwareVersion"
        assert sender is (Sender.OTHER if by_host else Sender.ARM), message.name


def test_the_table_of_senders_has_no_identifier_that_the_protocol_has_not():
    told = {
        message.frame_id
        for generation in Generation
        for message in load_database(generation).messages
        if "HOST" not in message.senders
    }
    assert FIXED_FEEDBACK - told == set()


@pytest.mark.parametrize("offset", [0x10, 0x20])
@pytest.mark.parametrize("generation", Generation)
def test_commands_under_another_control_offset_are_another_hosts(generation, offset):
    shifted = Addressing(control_offset=offset)
    moved = {
        shifted.to_wire(message.frame_id)
        for message in load_database(generation).messages
        if "HOST" in message.senders and shifted.to_wire(message.frame_id) != message.frame_id
    }
    assert moved
    for identifier in moved:
        assert sender_of(Frame(identifier, bytes(8)), 0, shifted) is Sender.OTHER, hex(identifier)


@pytest.mark.parametrize("offset", [0x00, 0x10, 0x20])
def test_feedback_of_another_offset_is_another_arms(offset):
    for other in (0x00, 0x10, 0x20):
        addressing = Addressing(feedback_offset=offset)
        sender = sender_of(Frame(0x2A5 + other, bytes(8)), 0, addressing)
        assert sender is (Sender.ARM if other == offset else Sender.OTHER_ARM)


@pytest.mark.parametrize("identifier", [0x2A0, 0x2A9, 0x2B0, 0x2C9, 0x155, 0x3C1, 0x4AF])
def test_what_no_arm_alone_says(identifier):
    assert not speaks_for_arm(identifier)


# Error frames -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arbitration_id", "data", "errors"),
    [
        (0x040, "0000000000000000", (BusError.BUS_OFF,)),
        (0x020, "0000000000000000", (BusError.NO_ACKNOWLEDGE,)),
        (0x004, "0001000000000000", (BusError.RECEIVE_OVERFLOW,)),
        (0x004, "0020000000000000", (BusError.ERROR_PASSIVE,)),
        (0x004, "0008000000000000", (BusError.MANY_ERRORS,)),
        (0x004, "0000000000000000", (BusError.CONTROLLER,)),
        (0x044, "0010000000000000", (BusError.BUS_OFF, BusError.ERROR_PASSIVE)),
        (0x100, "", (BusError.RESTARTED,)),
        (0x000, "", ()),
    ],
)
def test_what_an_error_frame_says(arbitration_id, data, errors):
    assert errors_of(arbitration_id, bytes.fromhex(data), "socketcan") == errors
    assert errors_of(arbitration_id, bytes.fromhex(data), "pcan") == ()


# Quantities ---------------------------------------------------------------------------------------


def test_signals_that_are_kept_have_the_key_of_their_curve():
    assert quantity_key(Sender.ARM, "JointFeedback34", "J4") == "arm.joint_angle.4"
    assert quantity_key(Sender.OWN, "JointTarget34", "J4") == "own.joint_angle.4"
    assert quantity_key(Sender.OTHER, "JointTarget34", "J4") == "other.joint_angle.4"
    assert quantity_key(Sender.ARM, "DriverSlow2", "Overcurrent") == "arm.driver_faults.2"
    assert quantity_key(Sender.ARM, "ArmStatus", "ControlMode") == "arm.control_mode"
    assert quantity_key(Sender.OTHER_ARM, "JointFeedback34", "J4") is None
    assert quantity_key(Sender.ARM, "LimitFeedback", "MaxAngle") is None


def test_every_key_is_one_that_can_be_drawn():
    told = {
        quantity_key(sender, message.name, signal.name)
        for sender in Sender
        for message in load_database(Generation.TWO).messages
        for signal in message.signals
    } - {None}

    assert told <= set(QUANTITIES)
    assert len(told) > 100
