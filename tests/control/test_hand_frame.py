"""Frames typed by hand: whether they are any, and what they do."""

import pytest

from armui.arm.refusal import Refusal
from armui.control.safety.hand_frame import FrameEffect, effect_of, parse_frame, why_never
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from tests.sim.talk import frame


@pytest.mark.parametrize(
    ("identifier", "data", "expected"),
    [
        ("155", "00 00 27 10 00 00 00 00", Frame(0x155, bytes.fromhex("0000271000000000"))),
        (" 0x155 ", "0000271000000000", Frame(0x155, bytes.fromhex("0000271000000000"))),
        ("7ff", "", Frame(0x7FF, b"")),
        ("1", "0x01,0xAB", Frame(0x001, b"\x01\xab")),
        ("471", "07.01", Frame(0x471, b"\x07\x01")),
    ],
)
def test_what_is_a_frame(identifier, data, expected):
    assert parse_frame(identifier, data) == expected


@pytest.mark.parametrize(
    ("identifier", "data", "code", "params"),
    [
        ("", "00", "frame_id_bad", {"value": ""}),
        ("15G", "00", "frame_id_bad", {"value": "15G"}),
        ("-1", "00", "frame_id_bad", {"value": "-1"}),
        ("800", "00", "frame_id_too_high", {"value": "0x800"}),
        ("99999999999999999999", "00", "frame_id_too_high", {"value": "0x99999999999999999999"}),
        ("155", "0", "frame_data_bad", {"value": "0"}),
        ("155", "00 1", "frame_data_bad", {"value": "1"}),
        ("155", "zz", "frame_data_bad", {"value": "zz"}),
        ("155", "00 " * 9, "frame_data_long", {"count": 9}),
        ("155", "一二", "frame_data_bad", {"value": "一二"}),
    ],
)
def test_what_is_none_is_named(identifier, data, code, params):
    refusal = parse_frame(identifier, data)
    assert isinstance(refusal, Refusal)
    assert (refusal.code, dict(refusal.params)) == (code, params)


@pytest.mark.parametrize(
    ("line", "effect"),
    [
        ("150#0100000000000000", FrameEffect.SINKS),
        ("170#01", FrameEffect.SINKS),
        ("150#0006000000000000", FrameEffect.ENDS),
        ("150#0001000000000000", FrameEffect.ENDS),
        ("150#0002000000000000", FrameEffect.MOVES),
        ("150#0000060000000000", FrameEffect.ENDS),
        ("150#0000030000000000", FrameEffect.MOVES),
        ("150#0000010000000000", FrameEffect.HAND),
        ("150#0006030000000000", FrameEffect.MOVES),
        ("150#", FrameEffect.MOVES),
        ("151#0101320000000000", FrameEffect.MOVES),
        ("151#010400AD00000000", FrameEffect.LIMP),
        ("151#0105320000000000", FrameEffect.LIMP),
        ("151#0106320000000000", FrameEffect.LIMP),
        ("161#010100AD00000000", FrameEffect.LIMP),
        ("151#0200000000000000", FrameEffect.HAND),
        ("155#0000000000000000", FrameEffect.MOVES),
        ("159#0000000000000100", FrameEffect.GRIPPER),
        ("15C#7FFF7FF0007FF7F7", FrameEffect.DIRECT),
        ("183#77706F00006FE8", FrameEffect.DIRECT),
        ("471#0702000000000000", FrameEffect.POWER),
        ("471#0101000000000000", FrameEffect.DROPS),
        ("470#FC00000000000000", FrameEffect.ROLE),
        ("475#01AE000000000000", FrameEffect.SETTING),
        ("477#0200000000000000", FrameEffect.HARMLESS),
        ("477#0001000000000000", FrameEffect.SETTING),
        ("477#000000AE02000000", FrameEffect.SETTING),
        ("422#0100000000000000", FrameEffect.SILENCE),
        ("422#0000000000000000", FrameEffect.HARMLESS),
        ("472#0101000000000000", FrameEffect.HARMLESS),
        ("4AF#0100000000000000", FrameEffect.HARMLESS),
        ("121#0101FF0000000000", FrameEffect.HARMLESS),
        ("191#0101010000000000", FrameEffect.MOVES),
        ("487#050505FFFFFF0000", FrameEffect.SETTING),
        ("181#726B7000000000", FrameEffect.HARMLESS),
        ("181#77706F00006FE8", FrameEffect.DIRECT),
        ("192#00", FrameEffect.UNKNOWN),
        ("3C1#00", FrameEffect.UNKNOWN),
    ],
)
def test_what_a_frame_does(line, effect):
    assert effect_of(frame(line)) is effect


def test_every_message_of_a_host_is_known():
    for message in load_database(Generation.TWO).messages:
        if message.senders == ["HOST"]:
            effect = effect_of(Frame(message.frame_id, bytes([0, 2])))
            assert effect is not FrameEffect.UNKNOWN, message.name


def test_no_message_of_an_arm_is_ever_sent():
    codec = Codec(Generation.TWO)
    for message in load_database(Generation.TWO).messages:
        if message.senders == ["ARM"]:
            assert why_never(Frame(codec.addressing.to_wire(message.frame_id), bytes(8)))
