"""Logs in the forms that owners have: pasted from a terminal, or saved by other programs."""

from __future__ import annotations

import math
from datetime import datetime
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from armui.protocol.frame import FrameFlag
from armui.session.frames import Damage, LoggedFrame, NotALogError
from armui.session.reader import LogFile
from tests.session.indexed import open_indexed

ARM = (
    (0x2A5, "0000AFC8FFFFF060"),
    (0x2A6, "00000FA0FFFFEC78"),
    (0x2A7, "00001388000003E8"),
    (0x2A1, "0100000100000000"),
    (0x155, "00002710FFFFD8F0"),
    (0x47B, "0101010101010000"),
)
START_S = 1_786_000_000.25
STEPS_S = (0.0, 0.000125, 0.000250, 0.000375, 0.004, 0.0041)


def read(path: Path) -> tuple[list[LoggedFrame], list[Damage], list[str]]:
    with LogFile(path) as log:
        frames = [each for batch in log.batches() for each in batch]
        return frames, log.damages.since(0), [each.code for each in log.damages.notes]


def rows(frames=ARM, start_s=0.0, steps=STEPS_S):
    return [(start_s + step, *each) for step, each in zip(steps, frames, strict=True)]


def spaced(data: str, between: str = " ") -> str:
    return between.join(data[n : n + 2] for n in range(0, len(data), 2))


def swapped(data: str) -> str:
    return "`".join(reversed(spaced(data).split()))


def binary(data: str) -> str:
    return " ".join(f"{each:08b}" for each in bytes.fromhex(data))


def ascii_of(data: str) -> str:
    return "".join(chr(each) if 0x1F < each < 0x7F else "." for each in bytes.fromhex(data))


def screen(time: str, number: int, shown: str, *, extra="", behind="", length="[{}]", size=8):
    begins = f" {time} " if time else " "
    return f"{begins} can0{extra}  {number:03X}   {length.format(size)}  {shown}{behind}"


def date(at_s: float) -> str:
    return datetime.fromtimestamp(at_s).strftime("(%Y-%m-%d %H:%M:%S.%f)")  # local, as candump


def savvy(at_s: float, number: int, data: str, *, direction: str = "Rx,") -> str:
    return f"{round(at_s * 1e6)},{number:08X},false,{direction}0,8,{spaced(data, ',')},"


SAVVY_TITLES = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8"
ZLG_TITLES = "序号,系统时间,时间标识,CAN通道,传输方向,ID号,帧类型,帧格式,长度,数据"


def zlg(place: int, clock: str, mark: str, number: int, data: str) -> str:
    return f"{place},{clock},{mark},ch1,接收,0x{number:04X},数据帧,标准帧,0x08,x| {spaced(data)} "


def clock(at_s: float) -> str:
    return f"09:{int(at_s // 60):02d}:{at_s % 60:09.6f}"


def candump(**how):
    def text(given):
        last_s = given[0][0]
        lines = []
        for at_s, number, data in given:
            since_s, last_s = at_s - last_s, at_s
            time = {
                "": "",
                "a": f"({at_s:017.6f})",
                "z": f"({at_s - given[0][0]:010.6f})",
                "d": f"({since_s:010.6f})",
                "A": date(at_s),
            }[how.get("t", "a")]
            line = screen(
                time, number, how.get("data", spaced)(data), size=len(data) // 2,
                extra=how.get("extra", ""), length=how.get("length", "[{}]"),
                behind=f"   '{ascii_of(data)}'" if how.get("ascii") else "",
            )  # fmt: skip
            if how.get("colour"):
                line = f"\x1b[1m\x1b[31m{line}\x1b[0m"
            lines.append(line)
        return "\n".join(lines) + "\n"

    return text


def candump_l(given):
    return "".join(f"({at_s:.6f}) can0 {number:03X}#{data}\n" for at_s, number, data in given)


def table(titles, row):
    return lambda given: "\n".join([titles, *(row(*each) for each in enumerate(given))]) + "\n"


def trc(version: str, row, columns: str = ""):
    def text(given):
        head = [f";$FILEVERSION={version}", ";$STARTTIME=46000.5", *filter(None, [columns]), ";"]
        begin_s = given[0][0]
        lines = [row(n + 1, (s - begin_s) * 1e3, i, d) for n, (s, i, d) in enumerate(given)]
        return "\r\n".join([*head, *lines]) + "\r\n"

    return text


def asc(row, *head: str):
    def text(given):
        return "\n".join(
            [*head, *(row(s - given[0][0], i, d) for s, i, d in given), "End TriggerBlock"]
        )

    return text


def asc_row(at_s, number, data):
    return f"   {at_s:.6f} 1  {number:X}             Rx   d {len(data) // 2} {spaced(data)}"


FORMS = {
    "-L": (".log", candump_l),
    "-ta": (".log", candump()),
    "-ta in .txt": (".txt", candump()),
    "-tz": (".log", candump(t="z")),
    "-tA": (".log", candump(t="A")),
    "-tA -c": (".txt", candump(t="A", colour=True)),
    "-tz -x": (".txt", candump(t="z", extra="  RX - -")),
    "-ta -a": (".txt", candump(ascii=True)),
    "-ta -S": (".txt", candump(data=swapped)),
    "-ta -i": (".txt", candump(data=binary)),
    "-ta -8": (".txt", candump(length="{{{}}}")),
    "without times": (".txt", candump(t="")),
    "without times, -a -c": (".txt", candump(t="", ascii=True, colour=True)),
    "SavvyCAN": (".csv", table(SAVVY_TITLES, lambda _n, each: savvy(*each))),
    "SavvyCAN before Dir": (
        ".csv",
        table(SAVVY_TITLES.replace("Dir,", ""), lambda _n, each: savvy(*each, direction="")),
    ),
    "CANTest": (
        ".csv",
        table(
            ZLG_TITLES,
            lambda n, e: zlg(n, "09:00:00.000", f"0x{round(e[0] * 1e4) % 2**32:08X}", *e[1:]),
        ),
    ),
    "CANTest without marks": (
        ".csv",
        table(ZLG_TITLES, lambda n, e: zlg(n, f'="{clock(e[0] % 600)}"', "无", *e[1:])),
    ),
    "ZCANPRO": (
        ".csv",
        table(
            "序号,系统时间,时间标识,CAN通道,ID号,帧类型,帧格式,CAN类型,长度,数据",
            lambda n, e: (
                f'{n},="17:54:13.761949,{e[0]:.6f},ch1,0x{e[1]:x},数据帧,标准帧,CAN,8,'
                f"x| {spaced(e[2])}"
            ),
        ),
    ),
    "USB_CAN TOOL": (
        ".csv",
        table(
            "序号,传输方向,时间标识,名称,帧ID(靠右对齐),帧格式,帧类型,数据长度,数据(HEX)",
            lambda n, e: (
                f"{n},接收,{clock(e[0] % 600)},,0x{e[1]:08x},数据帧,标准帧,0x08,{spaced(e[2])}"
            ),
        ),
    ),
    "TRC 1.0": (".trc", trc("1.0", lambda n, ms, i, d: f"{n:6}) {ms:9.3f} {i:04X} 8 {spaced(d)}")),
    "TRC 1.1": (
        ".trc", trc("1.1", lambda n, ms, i, d: f"{n:6}) {ms:9.3f}  Rx  {i:04X}  8  {spaced(d)}"),
    ),
    "TRC 1.2": (
        ".trc", trc("1.2", lambda n, ms, i, d: f"{n:6}) {ms:9.3f} 1  Rx  {i:04X}  8  {spaced(d)}"),
    ),
    "TRC 1.3": (
        ".trc",
        trc("1.3", lambda n, ms, i, d: f"{n:6}) {ms:9.3f} 1  Rx  {i:04X} -  8  {spaced(d)}"),
    ),
    "TRC 2.0": (
        ".trc",
        trc(
            "2.0", lambda n, ms, i, d: f"{n:6} {ms:9.3f} DT {i:04X} Rx 8 {spaced(d)}",
            ";$COLUMNS=N,O,T,I,d,l,D",
        ),
    ),
    "TRC 2.1": (
        ".trc",
        trc(
            "2.1", lambda n, ms, i, d: f"{n:6} {ms:9.3f} DT 1 {i:04X} Rx - 8 {spaced(d)}",
            ";$COLUMNS=N,O,T,B,I,d,R,L,D",
        ),
    ),
    "ASC": (".asc", asc(asc_row, "date Sam Mai 2 11:02:03.4 2026", "base hex")),
    "ASC in decimal": (
        ".asc",
        asc(
            lambda s, i, d: (
                f"   {s:.6f} 1  {i}  Rx  d 8 {' '.join(str(each) for each in bytes.fromhex(d))}"
            ),
            "date mer. févr. 4 11:02:03.4 2026", "base dec  timestamps absolute",
            "internal events logged",
        ),
    ),
    "ASC with names": (
        ".asc",
        asc(
            lambda s, i, d: (
                f"   {s:.6f} 1  Joint_Feedback_{i}  Rx  d 8 {spaced(d)}  Length = 228000 "
                f"BitCount = 118 ID = {i}"
            ),
            "date Sat Feb 7 01:02:03.4 pm 2026", "base hex  timestamps absolute",
        ),
    ),
    "ASC of a channel of CAN FD": (
        ".asc",
        asc(
            lambda s, i, d: (
                f"   {s:.6f} CANFD   1 Rx        {i:x}                                   0 0 8  8 "
                f"{spaced(d)}   102203  133   200000 e0006659 46500250 460a0250 2001173"
            ),
            "date 周六 5月 2 11:02:03.4 下午 2026", "base hex  timestamps absolute",
            "internal events logged",
        ),
    ),
}  # fmt: skip
UNTIMED = {"without times", "without times, -a -c"}


@pytest.mark.parametrize("name", FORMS)
def test_the_same_frames_in_every_form(tmp_path, name):
    suffix, text = FORMS[name]
    path = tmp_path / f"mine{suffix}"
    path.write_text(text(rows(start_s=START_S)), encoding="utf-8")
    frames, damages, notes = read(path)
    assert [(f.frame.arbitration_id, f.frame.data.hex().upper()) for f in frames] == list(ARM)
    assert {f.flags for f in frames} == {FrameFlag(0)}
    assert damages == []
    steps = [f.time_s - frames[0].time_s for f in frames]
    if name in UNTIMED:
        assert steps == pytest.approx([n / 1000 for n in range(6)])
        assert notes == ["log_no_times"]
    else:
        assert steps == pytest.approx(STEPS_S, abs=1e-4 if name == "CANTest" else 3e-6)
        assert notes == []


@pytest.mark.parametrize("name", ["-ta", "-tA", "-L", "SavvyCAN"])
def test_dates_are_kept(tmp_path, name):
    suffix, text = FORMS[name]
    path = tmp_path / f"mine{suffix}"
    path.write_text(text(rows(start_s=START_S)))
    assert read(path)[0][0].time_s == pytest.approx(START_S, abs=1e-5)


@settings(
    max_examples=25, deadline=None, derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)  # fmt: skip
@given(
    given_frames=st.lists(
        st.tuples(
            st.integers(0, 900), st.integers(0, 0x7FF),
            st.binary(min_size=8, max_size=8).map(lambda each: each.hex().upper()),
        ),
        min_size=1, max_size=30,
    )
)  # fmt: skip
@pytest.mark.parametrize("name", FORMS)
def test_any_frames_are_equal_in_every_form(tmp_path, name, given_frames):
    suffix, text = FORMS[name]
    path = tmp_path / f"any{suffix}"
    at_s, given_rows = 7.5, []
    for pause, number, data in given_frames:
        at_s += pause / 1e4
        given_rows.append((at_s, number, data))
    path.write_text(text(given_rows), encoding="utf-8")
    frames, damages, _notes = read(path)
    assert [(f.frame.arbitration_id, f.frame.data.hex().upper()) for f in frames] == [
        (number, data) for _at_s, number, data in given_rows
    ]
    assert damages == []
    if name not in UNTIMED:
        times = [f.time_s - frames[0].time_s for f in frames]
        wanted = [each[0] - given_rows[0][0] for each in given_rows]
        if not name.startswith("-tz"):  # with few frames it may be -td as well
            assert times == pytest.approx(wanted, abs=2e-4)


# --- times --------------------------------------------------------------------------------------


def arm_like(count: int) -> list[tuple[float, int, str]]:
    """Bursts of frames every 5 ms, as an arm sends them."""
    return [
        (START_S + 0.005 * (n // 6) + 0.000118 * (n % 6) + 1e-6 * (n * 7 % 5), *ARM[n % 6])
        for n in range(count)
    ]


@pytest.mark.parametrize("count", [12, 300, 9_000])
def test_pauses_of_td_are_added_up(tmp_path, count):
    path = tmp_path / "pauses.txt"
    path.write_text(candump(t="d")(arm_like(count)))
    frames, damages, notes = read(path)
    assert frames[-1].time_s == pytest.approx(0.005 * ((count - 1) // 6) + 0.00059, abs=3e-5)
    assert [f.time_s for f in frames] == sorted(f.time_s for f in frames)
    assert damages == []
    assert notes == ["log_pauses_added"]


@pytest.mark.parametrize("count", [12, 300, 9_000])
def test_times_of_tz_are_not(tmp_path, count):
    path = tmp_path / "since.txt"
    path.write_text(candump(t="z")(arm_like(count)))
    frames, damages, notes = read(path)
    assert frames[-1].time_s == pytest.approx(0.005 * ((count - 1) // 6) + 0.00059, abs=3e-5)
    assert (damages, notes) == ([], [])


def test_tz_of_two_interfaces_whose_frames_come_out_of_turn(tmp_path):
    path = tmp_path / "two.txt"
    own, other = arm_like(400), arm_like(400)
    lines = [line for each in zip(own, other, strict=True) for line in each]
    texts = candump(t="z")([(own[0][0], *ARM[0]), *lines]).splitlines()[1:]
    # one interface is read 20 frames late throughout
    shifted = [
        text.replace("can0", "can1")
        if n % 2
        else f" ({lines[max(0, n - 40)][0] - START_S:010.6f})  can0" + text.split("can0")[1]
        for n, text in enumerate(texts)
    ]
    path.write_text("\n".join(shifted))
    frames, _damages, notes = read(path)
    assert notes == []
    assert max(f.time_s for f in frames) < 0.4
    assert {f.channel for f in frames} == {"can0", "can1"}


def test_relative_times_of_an_asc_are_added_up(tmp_path):
    path = tmp_path / "relative.asc"
    lines = [asc_row(0.25, *ARM[0]), asc_row(0.5, *ARM[1]), asc_row(0.125, *ARM[2])]
    path.write_text("\n".join(["base hex  timestamps relative", *lines]) + "\n")
    frames, damages, notes = read(path)
    assert [f.time_s for f in frames] == pytest.approx([0.25, 0.75, 0.875])
    assert (damages, notes) == ([], ["log_pauses_added"])


def test_frames_without_a_time_stand_behind_those_that_have_one(tmp_path):
    path = tmp_path / "mixed.log"
    path.write_text(
        f"({START_S:.6f}) can0 2A5#{ARM[0][1]}\n  can0  2A6   [8]  {spaced(ARM[1][1])}\n"
        f"can0 2A7#{ARM[2][1]}\n"
    )
    frames, damages, notes = read(path)
    assert [f.time_s - START_S for f in frames] == pytest.approx([0.0, 0.001, 0.002], abs=1e-5)
    assert (damages, notes) == ([], ["log_no_times"])


def test_times_that_are_made_up_tell_of_no_silence_and_no_jump(tmp_path):
    path = tmp_path / "gripper.txt"
    far, near = "00015F90", "00000064"
    path.write_text(
        "".join(f"  can0  2A8   [8]  {spaced(each + '00000001')}\n" for each in (far, near, far))
    )
    session = open_indexed(path)
    assert [each.code for each in session.notes] == ["log_no_times"]
    assert session.marks == ()
    session.close()


# --- what stands between the frames -------------------------------------------------------------

PASTED = f"""\
owner@desk:~$ candump -ta -e -d can0,0:0,#FFFFFFFF
\x1b[0m (1786000000.000100)  can0  2A5   [8]  {spaced(ARM[0][1])}

\t(1786000000.000200)\tcan0\t2A6\t[8]\t{spaced(ARM[1][1])}
 (1786000000.000300)  can0  20000004   [8]  00 08 00 00 00 00 60 00   ERRORFRAME
\tcontroller-problem{{tx-error-warning}}
\terror-counter-tx-rx{{{{96}}{{0}}}}
DROPCOUNT: dropped 2 CAN frames on 'can0' socket (total drops 2)
 (1786000000.000400)  can1  18FF00A1   [2]  0A 0B
 (1786000000.000500)  can0  2A7   [8]  remote request
^C (1786000000.000600)  can0  2A7   [8]  {spaced(ARM[2][1])}
^C
 (1786000000.000700)  can0  2A1   [8]  01 0^C
owner@desk:~$ """


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_what_a_terminal_shows_besides_is_no_damage(tmp_path, end):
    path = tmp_path / "pasted.txt"
    path.write_bytes(PASTED.replace("\n", end).encode())
    frames, damages, notes = read(path)
    assert damages == []
    assert notes == ["log_last_line_torn"]
    ids = [f.frame.arbitration_id for f in frames]
    assert ids == [0x2A5, 0x2A6, 0x04, 0x18FF00A1, 0x2A7, 0x2A7]
    assert frames[2].flags & FrameFlag.ERROR
    assert frames[3].flags == FrameFlag.EXTENDED
    assert frames[4].flags == FrameFlag.REMOTE


@pytest.mark.parametrize(
    "torn",
    ["(1786000000.3000^C\n", "(1786000000.30", "(1786000000.300000) can0 2A7#00001", "^C\n",
     " (1786000000.300000)  can0  2A7   [8]  00 00"],
)  # fmt: skip
def test_a_torn_last_line_is_no_damage(tmp_path, torn):
    path = tmp_path / "torn.log"
    path.write_text(candump_l(rows(start_s=START_S)) + torn)
    frames, damages, notes = read(path)
    assert (len(frames), damages) == (6, [])
    assert notes == ([] if torn == "^C\n" else ["log_last_line_torn"])


@pytest.mark.parametrize("name", ["TRC 2.1", "ASC", "SavvyCAN", "TRC 1.2"])
def test_nor_in_other_forms(tmp_path, name):
    suffix, text = FORMS[name]
    whole = text(rows(start_s=START_S)).removesuffix("\nEnd TriggerBlock").rstrip()
    path = tmp_path / f"torn{suffix}"
    path.write_text(whole[:-4])
    frames, damages, notes = read(path)
    assert ([f.frame.arbitration_id for f in frames], damages) == ([i for i, _d in ARM[:-1]], [])
    assert notes == ["log_last_line_torn"]


def test_a_line_torn_in_the_middle_is_damage(tmp_path):
    path = tmp_path / "torn.log"
    good = candump_l(rows(start_s=START_S))
    path.write_text(good + "(1786000000.30\n" + good)
    frames, damages, notes = read(path)
    assert (len(frames), notes) == (12, [])
    assert [each.place for each in damages] == ["line 7"]


def test_fewer_bytes_than_the_screen_tells_are_no_frame(tmp_path):
    path = tmp_path / "short.txt"
    line = f"  can0  2A5   [8]  {spaced(ARM[0][1])}\n"
    path.write_text(line + "  can0  2A6   [8]  00 00 0F A0\n" + line)
    frames, damages, _notes = read(path)
    assert len(frames) == 2
    assert [each.place for each in damages] == ["line 2"]


def test_can_fd_and_sent_frames_of_x(tmp_path):
    path = tmp_path / "fd.txt"
    path.write_text(
        f" (000.000000)  can0  TX B E  2A5  [12]  {spaced('0123456789ABCDEF01234567')}\n"
        f" (000.000100)  can0  TX - -  155   [8]  {spaced(ARM[4][1])}\n"
    )
    frames, damages, _notes = read(path)
    assert damages == []
    assert frames[0].flags == (
        FrameFlag.FD | FrameFlag.BITRATE_SWITCH | FrameFlag.ERROR_STATE | FrameFlag.TRANSMITTED
    )
    assert frames[1].flags == FrameFlag.TRANSMITTED


@pytest.mark.parametrize(
    "begins",
    ["Start der Messung", "Début de la mesure", "开始测量", "Start of measurement",
     "CAN 1 Status:chip status error passive", "1  Statistic: D 3 R 0 XD 0 XR 0 E 0 O 0 B 0.10%",
     "SV: 3 0 1 ::Arm::Ready = 1", "CAN 2 Status:Fehler passiv", "1  OverloadFrame"],
)  # fmt: skip
@pytest.mark.parametrize("encoding", ["utf-8", "gb18030", "cp1252"])
def test_events_of_an_asc_in_any_language_are_no_damage(tmp_path, begins, encoding):
    if encoding == "cp1252" and not begins.isascii() and "D" not in begins:
        begins = "Début"
    path = tmp_path / "events.asc"
    when = {"utf-8": "Mér Mär 3", "gb18030": "周二 3月 3", "cp1252": "Die Mär 3"}[encoding]
    lines = [
        f"date {when} 05:06:07.8 pm 2026", "base hex  timestamps absolute",
        "internal events logged", f"Begin Triggerblock {when} 05:06:07.8 pm 2026",
        f"   0.000000 {begins}", asc_row(0.1, *ARM[0]), f"   0.200000 {begins}",
        asc_row(0.3, *ARM[1]), "End TriggerBlock",
    ]  # fmt: skip
    path.write_bytes("\n".join(lines).encode(encoding, "replace"))
    frames, damages, _notes = read(path)
    assert [f.frame.arbitration_id for f in frames] == [0x2A5, 0x2A6]
    assert damages == []


def test_a_damaged_line_of_an_asc_is_still_damage(tmp_path):
    path = tmp_path / "damaged.asc"
    bad = [
        "   0.150000 1  2A5  Rx  d 8 00 zz",
        "   0.160000 CANFD 1 Rx 2A5 0",
        "0.17 1 Join Rx d 8 00",
    ]
    lines = ["base hex  timestamps absolute", asc_row(0.1, *ARM[0]), *bad, asc_row(0.3, *ARM[1])]
    path.write_text("\n".join([*lines, ""]))
    frames, damages, _notes = read(path)
    assert len(frames) == 2
    assert [each.place for each in damages] == ["line 3", "line 4", "line 5"]


def test_lines_of_a_trc_that_are_no_data(tmp_path):
    path = tmp_path / "all.trc"
    path.write_text(
        ";$FILEVERSION=2.1\n;$STARTTIME=46000.5\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n"
        "  1  0.100 ST 1         Rx -  4    00 00 00 08\n"
        "  2  0.200 ER 1    0002 Rx -  5    04 00 02 00 00\n"
        "  3  0.300 EV 1                    a remark: über alles\n"
        "  4  0.400 RR 1    02A5 Rx -  8\n"
        "  5  0.500 EC 1         Rx -  2    00 00\n"
        f"  6  0.600 DT 1    02A6 Tx -  8    {spaced(ARM[1][1])}\n"
        f"  7  0.700 FD 1    02A6 Rx -  8    {spaced(ARM[1][1])}\n",
        encoding="utf-8",
    )
    frames, damages, _notes = read(path)
    assert damages == []
    assert [f.flags for f in frames] == [FrameFlag.REMOTE, FrameFlag.TRANSMITTED, FrameFlag.FD]


# --- tables -------------------------------------------------------------------------------------


@pytest.mark.parametrize("encoding", ["gb18030", "utf-8", "utf-8-sig"])
def test_tables_of_zlg_in_both_encodings(tmp_path, encoding):
    path = tmp_path / "zlg.csv"
    lines = [
        ZLG_TITLES,
        zlg(0, "09:00:00.100", "0x00000064", *ARM[0]),
        zlg(1, "09:00:00.101", "0x0000006F", *ARM[1]).replace("接收", "发送"),
        "2,09:00:00.102,0x00000070,ch2,接收,0x18FF00A1,数据帧,扩展帧,0x02,x| 0A 0B ",
        "3,09:00:00.103,0x00000071,ch1,接收,0x02A5,远程帧,标准帧,0x08,x| ",
    ]  # fmt: skip
    path.write_bytes("\r\n".join([*lines, ""]).encode(encoding))
    frames, damages, _notes = read(path)
    assert damages == []
    assert [f.time_s for f in frames] == pytest.approx([0.01, 0.0111, 0.0112, 0.0113])
    assert [f.flags for f in frames] == [
        FrameFlag(0), FrameFlag.TRANSMITTED, FrameFlag.EXTENDED, FrameFlag.REMOTE,
    ]  # fmt: skip
    assert [f.channel for f in frames] == ["ch1", "ch1", "ch2", "ch1"]


def test_a_row_of_a_table_that_is_none_costs_itself(tmp_path):
    path = tmp_path / "savvy.csv"
    lines = [SAVVY_TITLES, savvy(1.0, *ARM[0]), "17,nonsense,,,", savvy(1.1, *ARM[1]), ""]
    path.write_text("\n".join(lines))
    frames, damages, _notes = read(path)
    assert len(frames) == 2
    assert [each.place for each in damages] == ["line 3"]


@pytest.mark.parametrize(
    ("suffix", "content", "says"),
    [
        (".log", b"***BUSMASTER Ver 3.2.2***\n***PROTOCOL CAN***\n", "BUSMASTER"),
        (".txt", b"Chn Identifier Flg   DLC  D0...1...2...3\n 0 000002A5\n", "Kvaser"),
        (".log", b"\n\r\r\n" + bytes(60), "Wireshark"),
        (".csv", b'"No.","Time","Source"\n"1","0.1","x"\n', "Wireshark"),
        (".csv", "编号,帧名\n1,2\n".encode("gb18030"), "ZLG"),
        (".csv", "索引,帧编号,内容\n1,2,3\n".encode(), "ZLG"),
        (".csv", b"wait,j1,j2,j3\n0.1,0.2,0.3,0.4\n", "titles that are not known"),
        (".csv", b"Index,Time,What\n0,1,2\n", "titles that are not known"),
    ],
)
def test_what_is_not_known_is_refused_with_the_way(tmp_path, suffix, content, says):
    path = tmp_path / f"other{suffix}"
    path.write_bytes(content)
    with pytest.raises(NotALogError, match=says) as refused:
        read(path)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("name", "suffix", "looks_like"),
    [("CANTest", ".txt", ".csv"), ("SavvyCAN", ".log", ".csv"), ("without times", ".csv", ".log")],
)
def test_forms_under_another_suffix_are_named(tmp_path, name, suffix, looks_like):
    path = tmp_path / f"other{suffix}"
    path.write_text(FORMS[name][1](rows(start_s=START_S)), encoding="utf-8")
    with pytest.raises(NotALogError, match=f"looks like a {looks_like} file"):
        read(path)


@pytest.mark.parametrize("name", ["without times", "SavvyCAN", "CANTest", "-tA", "ASC with names"])
def test_a_replay_opens_them(tmp_path, name):
    suffix, text = FORMS[name]
    path = tmp_path / f"mine{suffix}"
    path.write_text(text(rows(start_s=START_S)), encoding="utf-8")
    session = open_indexed(path)
    assert session.frames == 6
    assert sum(map(len, session.frames_between(-math.inf, math.inf))) == 6
    assert [each.code for each in session.notes] == (["log_no_times"] if name in UNTIMED else [])
    session.close()
