"""Every message, signal, code, sender and error of the bus has its words in both languages."""

import pytest

from armui.control.safety.hand_frame import FrameEffect
from armui.protocol.codec import Codec, InvalidFrame
from armui.protocol.frame import Frame, FrameFlag
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from armui.telemetry.bus_errors import BusError
from armui.telemetry.bus_senders import Sender
from armui.ui.translation import Translator
from armui.ui.words import frames
from armui.ui.words.frames import frame_effect, message_name, signal_name, signal_value, signal_word
from tests.ui.test_words import has_chinese

SAME_IN_BOTH = {"Kp", "Kd", "MIT", *(f"MOVE {kind}" for kind in ("P", "J", "L", "C", "M", "CPV"))}
AXES = {*(f"J{joint}" for joint in range(1, 7)), "X", "Y", "Z", "RX", "RY", "RZ"}


@pytest.fixture
def chinese(qapp):
    translator = Translator(qapp)
    translator.set_language("zh")
    yield
    translator.set_language("en")


@pytest.mark.parametrize("generation", Generation)
def test_messages_and_signals(chinese, generation):
    for message in load_database(generation).messages:
        assert has_chinese(message_name(message.name)), message.name
        for signal in message.signals:
            name = signal_name(signal.name)
            assert has_chinese(name) or name in AXES | SAME_IN_BOTH, (message.name, signal.name)
            for word in (signal.choices or {}).values():
                said = signal_word(str(word))
                assert has_chinese(said) or said in AXES | SAME_IN_BOTH, (signal.name, str(word))


def test_names_of_one_message_differ(qapp):
    for message in load_database(Generation.TWO).messages:
        names = [signal_name(signal.name) for signal in message.signals]
        assert len(set(names)) == len(names), message.name


@pytest.mark.parametrize("effect", FrameEffect)
def test_what_a_frame_does(chinese, effect):
    assert has_chinese(frame_effect(effect))


def test_senders_and_errors(chinese):
    said = [frames.frame_sender(sender) for sender in Sender]
    assert all(has_chinese(each) for each in said)
    assert len(set(said)) == len(said)
    assert frames.frame_sender(Sender.OTHER, leader=True) == "主臂"
    assert frames.frame_sender(Sender.ARM, leader=True) == "机械臂"
    for error in BusError:
        assert has_chinese(frames.bus_errors((error,)))
    assert has_chinese(frames.bus_errors(()))


@pytest.mark.parametrize(
    ("arbitration_id", "flags", "text"),
    [
        (0x3C1, 0, "Unknown: not in the tables of this arm"),
        (0x2B1, 0, "Of an arm with other identifiers (0x470)"),
        (0x4B0, 0, "Firmware upgrade: not documented"),
        (0x18FF50E5, FrameFlag.EXTENDED, "29-bit identifier: the arm uses none"),
        (0x155, FrameFlag.REMOTE, "Remote frame: a question without data"),
        (0x155, FrameFlag.FD, "CAN FD frame: the arm speaks classic CAN"),
        (0x004, FrameFlag.ERROR, "Error frame of the adapter"),
    ],
)
def test_frames_of_no_message(qapp, arbitration_id, flags, text):
    assert frames.frame_kind(arbitration_id, flags, Codec(Generation.TWO)) == text


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("2A8#0011", "2 bytes instead of 8"),
        ("470#00", "1 bytes instead of 4 / 8"),
        ("2A1#0963000000000000", "outside its table: Control mode = 9, Status = 99"),
        ("3C1#00", "Unknown: not in the tables of this arm"),
    ],
)
def test_what_is_wrong_with_a_frame(qapp, line, text):
    codec = Codec(Generation.TWO)
    identifier, _, data = line.partition("#")
    frame = Frame(int(identifier, 16), bytes.fromhex(data))
    invalid = codec.decode(frame)
    assert isinstance(invalid, InvalidFrame)
    assert frames.why_invalid(invalid, len(frame.data), codec) == text


@pytest.mark.parametrize(
    ("line", "signal", "text"),
    [
        ("2A5#00002EE0FFFFD120", "J2", "-12.000°"),
        ("261#00F1002020400000", "Voltage", "24.1 V"),
        ("261#00F1002020400000", "DriverTemperature", "32 °C"),
        ("151#010132AD00000000", "MitMode", "MIT (173)"),
        ("151#0101320000000000", "SpeedPercent", "50 %"),
        ("473#0106000000012C00", "MaxSpeed", "3.00 rad/s"),
        ("471#0702000000000000", "Action", "Enable (2)"),
        ("476#7100000000000000", "Index", "Motors on and off (113)"),
        ("474#017FFF7FFF7FFF00", "MaxAngle", "Leave unchanged (3276.7)"),
    ],
)
def test_values_with_units_and_words(qapp, line, signal, text):
    codec = Codec(Generation.TWO)
    identifier, _, data = line.partition("#")
    frame = Frame(int(identifier, 16), bytes.fromhex(data))
    decoded = codec.decode(frame)
    message = decoded.message if isinstance(decoded, InvalidFrame) else decoded
    assert message is not None
    layout = codec.layout(frame.arbitration_id)
    assert signal_value(layout.signals[signal], message.signals[signal]) == text
