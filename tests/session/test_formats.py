"""Every log that python-can's readers open gives the same frames, whoever wrote it."""

from __future__ import annotations

from pathlib import Path

import can
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from armui.protocol.frame import FrameFlag
from armui.session.frames import Damage, LoggedFrame
from armui.session.reader import LogFile
from tests.session.foreign_blf import container, file, frame, obj

SUFFIXES = (".log", ".asc", ".blf", ".trc", ".csv", ".db")
# What `candump -L can0 can1` printed on a bus with an unplugged adapter, and with the options -8
# and -t a: error frames of several classes, both channels, extended and remote frames, CAN FD.
CANDUMP = """\
(1718900001.120001) can0 2A1#0100000100000000
(1718900001.120243) can1 2A1#0100000100000000
(1718900001.120480) can0 18FEF100#FF0000A0FF1F00FF
(1718900001.120900) can0 2A5#FFFFD3B8FFFFF3D5
(1718900001.121004) can0 20000004#0008000000000060 R
(1718900001.121300) can1 20000088#0000190000000000
(1718900001.122000) can0 20000040#0000000000000000
(1718900001.122400) can0 123#R8
(1718900001.122800) can0 123#R
(1718900001.123000) can0 123##1112233445566778899AABBCC
(1718900001.123500) can0 2A6#0000000000000000 T
(1718900001.124000) can0 151#
(1718900001.124500) can1 7FF#1122334455667788_9
 (1718900001.125000)  can0  2A7   [8]  00 00 11 22 00 00 33 44
 (1718900001.125500)  can1  TX - -  2A8   [3]  00 00 11
 (1718900001.126000)  can0  20000080   [8]  00 00 02 00 00 00 00 00   ERRORFRAME
"""
# Lines as CANalyzer 9 and CANoe 11 write them.
ASC = """\
date Sam Sep 30 15:06:13.191 2017
base hex  timestamps absolute
internal events logged
// version 9.0.0
Begin Triggerblock Sam Sep 30 15:06:13.191 2017
   0.000000 Start of measurement
   0.015991 CAN 1 Status:chip status error passive - TxErr: 132 RxErr: 0
   1.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%
   2.501000 1  ErrorFrame
   2.501010 1  ErrorFrame    ECC: 10100010
   2.510001 2  100             Tx   r
   2.520003 3  200             Tx   r 8 Length = 1704000 BitCount = 145 ID = 88888888x
   2.584921 4  300             Tx   r a
   3.098426 1  18EBFF00x       Rx   d 8 01 A0 0F A6 60 3B D1 40  Length = 273910 BitCount = 141
   3.148421 1  18EBFF00x       Rx   d f 02 1F DE 80 25 DF C0 2B  Length = 271910 BitCount = 140
   3.197693 1  2A5             Rx   d 9 03 E1 00 4B FF FF 3C 0F  Length = 283910 BitCount = 146
  20.305233 2  J1939TP FEE3p 6 0 0  -  Rx   d 23 A0 0F A6 60
  30.005020 CANFD   2 Rx        300                                   1 0 8  8 01 02 03 04 05 06 07 08  102203  133  303000 e0006659
  30.506898 CANFD   4 Rx   0EE4BB01x  Generic_Name_12  0 1 d 32 01 02 03 04 05 06 07 08 01 02 03 04 05 06 07 08 01 02 03 04 05 06 07 08 01 02 03 04 05 06 07 08 102500 133 303000 e0006659
  31.001000 1  7FF             Rx   d 0
End TriggerBlock
"""  # noqa: E501


def read(path: Path) -> tuple[list[LoggedFrame], list[Damage]]:
    with LogFile(path) as log:
        return [each for batch in log.batches() for each in batch], log.damages.since(0)


def as_python_can_has_it(path: Path) -> list[tuple[object, ...]]:
    with can.LogReader(path) as reader:
        return [
            (m.timestamp, m.arbitration_id, bytes(m.data), m.channel, m.is_extended_id,
             m.is_remote_frame, m.is_error_frame, m.is_fd, m.is_rx)
            for m in reader
        ]  # fmt: skip


def in_those_terms(frames: list[LoggedFrame]) -> list[tuple[object, ...]]:
    return [
        (f.time_s, f.frame.arbitration_id, f.frame.data, f.channel,
         bool(f.flags & FrameFlag.EXTENDED), bool(f.flags & FrameFlag.REMOTE),
         bool(f.flags & FrameFlag.ERROR), bool(f.flags & FrameFlag.FD),
         not f.flags & FrameFlag.TRANSMITTED)
        for f in frames
    ]  # fmt: skip


def written(path: Path, messages: list[can.Message]) -> Path:
    with can.Logger(path) as logger:
        for each in messages:
            logger(each)
    return path


classic = st.builds(
    lambda n, extended, data, remote, received: can.Message(
        arbitration_id=n if extended else n & 0x7FF, is_extended_id=extended,
        is_remote_frame=remote, data=b"" if remote else data, dlc=len(data), is_rx=received,
        channel=1,
    ),
    st.integers(0, 0x1FFFFFFF), st.booleans(), st.binary(max_size=8), st.booleans(), st.booleans(),
)  # fmt: skip


@pytest.mark.parametrize("suffix", SUFFIXES)
@settings(
    max_examples=20,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(messages=st.lists(classic, min_size=1, max_size=30))
def test_what_python_can_writes_is_read_as_python_can_reads_it(tmp_path, suffix, messages):
    if suffix == ".trc":  # its writer knows no remote frames
        messages = [each for each in messages if not each.is_remote_frame] or [can.Message()]
    for number, message in enumerate(messages):
        message.timestamp = 1_700_000_000 + number / 128
    path = tmp_path / f"run{suffix}"
    path.unlink(missing_ok=True)
    written(path, messages)
    frames, damages = read(path)
    assert damages == []
    assert len(frames) == len(messages)
    assert in_those_terms(frames) == as_python_can_has_it(path)


@settings(
    max_examples=60,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(
    lines=st.lists(
        st.tuples(
            st.integers(0, 2**34), st.sampled_from(["can0", "1", "vcan-x"]),
            st.one_of(st.integers(0, 0x7FF).map("{:03X}".format),
                      st.integers(0, 0x1FFFFFFF).map("{:08x}".format)),
            st.binary(max_size=8), st.sampled_from(["", " R", " T"]),
        ),
        min_size=1, max_size=40,
    )
)  # fmt: skip
def test_blocks_of_candump_lines_are_what_the_reader_makes_of_them_one_by_one(tmp_path, lines):
    path = tmp_path / "run.log"
    path.write_text(
        "".join(
            f"({time / 2**4:.6f}) {channel} {identifier}#{data.hex().upper()}{direction}\n"
            for time, channel, identifier, data, direction in lines
        )
    )
    frames, damages = read(path)
    assert damages == []
    assert in_those_terms(frames) == as_python_can_has_it(path)


def test_a_real_candump_with_error_frames_extended_identifiers_and_two_channels(tmp_path):
    path = tmp_path / "bus.log"
    path.write_text(CANDUMP)
    frames, damages = read(path)
    assert damages == []
    assert len(frames) == len(CANDUMP.splitlines())
    assert [f.time_s for f in frames] == sorted(f.time_s for f in frames)
    assert [f.channel for f in frames].count("can1") == 4
    errors = [f for f in frames if f.flags & FrameFlag.ERROR]
    # class bits of linux/can/error.h: controller 4, protocol and bus error 8 + 80, bus off 40
    assert [f.frame.arbitration_id for f in errors] == [0x04, 0x88, 0x40, 0x80]
    assert errors[0].frame.data == bytes.fromhex("0008000000000060")
    assert errors[1].channel == "can1"
    assert frames[2].frame == (0x18FEF100, bytes.fromhex("FF0000A0FF1F00FF"))
    assert frames[2].flags == FrameFlag.EXTENDED
    assert [f.flags for f in frames[7:9]] == [FrameFlag.REMOTE] * 2
    assert frames[9].flags == FrameFlag.FD | FrameFlag.BITRATE_SWITCH
    assert frames[9].frame.data.hex() == "112233445566778899aabbcc"
    assert frames[10].flags == FrameFlag.TRANSMITTED
    assert frames[12].frame == (0x7FF, bytes.fromhex("1122334455667788"))
    assert frames[13].frame == (0x2A7, bytes.fromhex("0000112200003344"))
    assert frames[14].frame == (0x2A8, bytes.fromhex("000011"))
    assert frames[14].flags == FrameFlag.TRANSMITTED


def test_the_same_lines_in_a_txt_file(tmp_path):
    path = tmp_path / "bus.txt"
    path.write_text(CANDUMP)
    assert len(read(path)[0]) == len(CANDUMP.splitlines())


def test_vectors_asc_with_long_length_codes_and_extended_identifiers(tmp_path):
    path = tmp_path / "canoe.asc"
    path.write_text(ASC)
    frames, damages = read(path)
    assert damages == []
    assert in_those_terms(frames) == as_python_can_has_it(path)
    assert len(frames) == 11
    assert [f.frame.data.hex() for f in frames[6:8]] == ["021fde8025dfc02b", "03e1004bffff3c0f"]
    assert not any(f.flags & FrameFlag.IMPOSSIBLE for f in frames)


FOREIGN = {
    # CAN_MESSAGE without what follows the data in CAN_MESSAGE2, header of version 2, a length code
    # of 15, markers and statistics in between
    "old objects": [container(obj(96, bytes(40)) + frame(0x2A5, b"12345678", kind=1))],
    "header 2": [container(frame(0x2A5, b"12345678", version=2))],
    "length code": [container(frame(0x2A5, b"12345678", dlc=15))],
    "statistics": [container(obj(4, bytes(48)) + frame(0x2A5, b"12345678") + obj(4, bytes(48)))],
    "not packed": [container(frame(0x2A5, b"12345678"), packed=False)],
    "unknown objects": [obj(115, bytes(8)), container(frame(0x2A5, b"12345678")), obj(6, b"abcd")],
}


@pytest.mark.parametrize("name", FOREIGN)
def test_blf_files_of_other_tools(tmp_path, name):
    path = tmp_path / "foreign.blf"
    path.write_bytes(file(*FOREIGN[name], header_size=152))
    frames, damages = read(path)
    assert damages == []
    assert [f.frame for f in frames] == [(0x2A5, b"12345678")]
    assert in_those_terms(frames) == as_python_can_has_it(path)


def test_a_blf_frame_that_contradicts_itself_is_given_and_named(tmp_path):
    path = tmp_path / "foreign.blf"
    path.write_bytes(file(container(frame(0x4444444, b"12345678", dlc=51))))
    frames, damages = read(path)
    assert in_those_terms(frames) == as_python_can_has_it(path)
    assert [f.flags for f in frames] == [FrameFlag.IMPOSSIBLE]
    assert [d.frame_given for d in damages] == [True]


def test_blf_frames_outside_of_containers_are_read_too(tmp_path):
    path = tmp_path / "bare.blf"
    path.write_bytes(file(frame(0x2A5, b"12345678"), frame(0x2A6, b"1234", 5_000_000)))
    frames, damages = read(path)
    assert damages == []
    assert [f.frame for f in frames] == [(0x2A5, b"12345678"), (0x2A6, b"1234")]
    assert frames[1].time_s == pytest.approx(0.005)


def test_a_blf_frame_that_is_split_between_containers(tmp_path):
    whole = b"".join(frame(0x2A5, bytes([n] * 8), n) for n in range(50))
    path = tmp_path / "split.blf"
    path.write_bytes(file(*(container(whole[n : n + 77]) for n in range(0, len(whole), 77))))
    frames, damages = read(path)
    assert damages == []
    assert [f.frame.data[0] for f in frames] == list(range(50))


def test_a_blf_without_can_frames_is_a_log(tmp_path):
    path = tmp_path / "lin.blf"
    path.write_bytes(file(container(obj(11, bytes(40)))))
    assert read(path) == ([], [])


def test_positions_for_a_progress_bar(tmp_path):
    path = tmp_path / "run.log"
    path.write_text("(1.0) can0 2A5#0000000000000000\n" * 30_000)
    with LogFile(path) as log:
        positions = [log.position for _batch in log.batches()]
        assert positions == sorted(positions)
        assert positions[0] < log.size / 2
        assert positions[-1] == log.size == path.stat().st_size
        assert log.frames == 30_000
