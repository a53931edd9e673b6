"""CSV as pandas and Parquet as pyarrow see it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pandas as pd
import pytest
from pyarrow import parquet

from armui.protocol.codec import Codec, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.session.exports.export import export_log
from armui.session.exports.request import ArmOptions, ExportFormat, ExportRequest
from tests.session.exports.logs import START_S, blf, candump, session

# 12° = 12000 = 0x2EE0, -90.5° = -90500 = 0xFFFE9E7C
ANGLES = (
    Frame(0x2A5, bytes.fromhex("00002EE0FFFE9E7C")),
    Frame(0x2A6, bytes.fromhex("0000000000015F90")),
    Frame(0x2A7, bytes.fromhex("FFFFFFFF00000001")),
)
TARGETS = tuple(Frame(each.arbitration_id - 0x150, each.data) for each in ANGLES)
STOP = Frame(0x150, bytes.fromhex("0100000000000000"))
POSE_TARGET = Frame(0x152, bytes.fromhex("0000DB40FFFFFC18"))  # X 56.128 mm, Y -1 mm
FORMATS = pytest.mark.parametrize("kind", [ExportFormat.CSV, ExportFormat.PARQUET])


def table(log: Path, kind: ExportFormat, **more: Any) -> pd.DataFrame:
    """The columns by name, whichever format it went through."""
    target = log.with_name(f"{log.stem}-table.{kind}")
    report = export_log(ExportRequest(log, target, kind, replace=True, **more))
    if kind is ExportFormat.CSV:
        found = pd.read_csv(target, encoding="utf-8-sig")
        found.columns = [name.partition(" [")[0] for name in found.columns]
    else:
        found = pd.read_parquet(target)
    assert report.items == len(found)
    return found


@FORMATS
@pytest.mark.parametrize("generation", list(Generation))
def test_a_row_is_a_set_of_angles_with_what_was_last_heard(tmp_path, kind, generation):
    frames = [
        (1.0, Frame(0x261, bytes.fromhex("00F000191E440000"))),  # 24 V, 25 °C, 30 °C, overcurrent
        *((1.1, each) for each in ANGLES),
        *((1.2, each) for each in ANGLES),
        (1.3, ANGLES[0]),
    ]
    found = table(candump(tmp_path / "a.log", frames), kind, wishes=ArmOptions(generation))
    assert found["time"].tolist() == pytest.approx([1.1, 1.2])
    assert found["since_start"].tolist() == pytest.approx([0.1, 0.2])
    row = found.iloc[1]
    joints = [row[f"arm.joint_angle.{joint}"] for joint in range(1, 7)]
    assert joints == [12.0, -90.5, 0.0, 90.0, -0.001, 0.001]
    assert row["arm.voltage.1"] == 24.0
    assert row["arm.driver_temperature.1"] == 25
    assert row["arm.driver_faults.1"] == 0b100
    assert row["arm.enabled.1"] == 1
    assert pd.isna(row["arm.voltage.2"])
    assert pd.isna(row["arm.arm_status"])


@FORMATS
def test_what_was_heard_too_long_ago_is_empty(tmp_path, kind):
    slow = (1.0, Frame(0x261, bytes.fromhex("00F000191E400000")))
    frames = [slow, *((at_s, each) for at_s in (1.4, 1.6) for each in ANGLES)]
    found = table(candump(tmp_path / "a.log", frames), kind)
    assert found["arm.voltage.1"].isna().tolist() == [False, True]


@FORMATS
def test_a_command_stands_until_another_one_or_a_stop(tmp_path, kind):
    steps = [
        (1.0, ANGLES), (1.1, TARGETS), (1.2, ANGLES), (9.0, ANGLES), (9.1, (STOP,)), (9.2, ANGLES),
        (9.3, TARGETS), (9.4, ANGLES), (9.5, (POSE_TARGET,)), (9.6, ANGLES),
    ]  # fmt: skip
    frames = [(at_s, frame) for at_s, step in steps for frame in step]
    found = table(candump(tmp_path / "a.log", frames), kind)
    assert found["time"].tolist() == pytest.approx([1.0, 1.2, 9.0, 9.2, 9.4, 9.6])
    known = found["command.joint_angle.1"].notna().tolist()
    assert known == [False, True, True, False, True, False]
    assert found["command.joint_angle.1"][2] == 12.0
    assert found["command.pose_x"].notna().tolist() == [False] * 5 + [True]
    assert found["command.pose_x"][5] == 56.128


def test_the_header_of_csv_has_units(tmp_path):
    log = candump(tmp_path / "a.log", [(1.0, each) for each in ANGLES])
    export_log(ExportRequest(log, tmp_path / "a.csv", ExportFormat.CSV))
    data = (tmp_path / "a.csv").read_bytes()
    assert data.startswith(b"\xef\xbb\xbf")
    lines = data.decode("utf-8-sig").split("\r\n")
    titles = lines[0].split(",")
    assert titles[:3] == ["time [s]", "since_start [s]", "arm.joint_angle.1 [°]"]
    assert "arm.motor_speed.1 [°/s]" in titles
    assert "arm.arm_status" in titles
    assert lines[1].startswith("1.000000,0.000000,12.0,-90.5,0.0,90.0,-0.001,0.001,")
    assert lines[1].count(",") == lines[0].count(",")
    assert lines[2:] == [""]


def test_the_columns_of_parquet_have_types_and_units(tmp_path):
    log = candump(tmp_path / "a.log", [(1.0, each) for each in ANGLES])
    wishes = ArmOptions(Generation.TWO, "S-V1.8-5")
    export_log(ExportRequest(log, tmp_path / "a.parquet", ExportFormat.PARQUET, wishes=wishes))
    schema = parquet.read_schema(tmp_path / "a.parquet")
    units = {field.name: field.metadata[b"unit"].decode() for field in schema}
    types = {field.name: str(field.type) for field in schema}
    assert (units["time"], types["time"]) == ("s", "double")
    assert (units["arm.joint_angle.1"], types["arm.joint_angle.1"]) == ("°", "double")
    assert (units["arm.motor_current.6"], types["arm.motor_current.6"]) == ("A", "double")
    assert (units["arm.arm_status"], types["arm.arm_status"]) == ("", "int32")
    assert schema.metadata[b"source"] == b"a.log"
    assert schema.metadata[b"arm"] == b"PiPER, generation 2, S-V1.8-5"


@pytest.mark.parametrize("generation", list(Generation))
def test_what_a_message_leaves_out_is_blank_in_csv(tmp_path, generation):
    log = blf(tmp_path / "a.blf", session(0.6, generation))
    export_log(ExportRequest(log, tmp_path / "a.csv", ExportFormat.CSV))
    assert b"nan" not in (tmp_path / "a.csv").read_bytes()


def test_encoder_pulses_are_no_angle(tmp_path):
    """Generation 1 tells a motor's position in pulses: there is no such column."""
    log = candump(tmp_path / "a.log", [(1.0, each) for each in ANGLES])
    one, two = (
        table(log, ExportFormat.CSV, wishes=ArmOptions(generation)) for generation in Generation
    )
    assert "arm.motor_position.1" not in one
    assert "arm.motor_position.1" in two
    assert "command.mit_position.1" not in one


@FORMATS
@pytest.mark.parametrize("generation", list(Generation))
def test_a_session_says_what_the_codec_says_frame_by_frame(tmp_path, kind, generation):
    """Compared with a plain loop over the frames that keeps what it heard last."""
    heard = session(0.6, generation)
    found = table(blf(tmp_path / "录制.blf", heard), kind)
    codec = Codec(generation)
    last: dict[str, float] = {}
    rows: list[dict[str, float]] = []
    factor = {Generation.ONE: 6.0, Generation.TWO: 57.29577951308232}[generation]
    for _at_s, frame in heard:
        message = codec.decode(frame)
        assert isinstance(message, Message)
        for name, value in message.signals.items():
            last[f"{message.name}.{name}"] = value
        if message.name == "JointFeedback56":
            rows.append(dict(last))
    assert len(found) == len(rows)
    for column, signal, scale in (
        ("arm.joint_angle.1", "JointFeedback12.J1", 1.0),
        ("arm.pose_x", "EndPose1.X", 1.0),
        ("arm.arm_status", "ArmStatus.Status", 1.0),
        ("arm.not_reached", "ArmStatus.MotionState", 1.0),
        ("arm.motor_speed.1", "DriverFast1.Speed", factor),
        ("arm.motor_current.3", "DriverFast3.Current", 1.0),
        ("arm.enabled.6", "DriverSlow6.Enabled", 1.0),
        ("command.joint_angle.1", "JointTarget12.J1", 1.0),
        ("command.speed_percent", "ModeControl.SpeedPercent", 1.0),
    ):
        wanted = [row.get(signal, float("nan")) * scale for row in rows]
        assert found[column].astype(float).tolist() == pytest.approx(wanted, nan_ok=True), column
    assert found["command.joint_angle.1"].notna().any()


def test_long_logs_are_the_same_in_many_pieces(tmp_path, monkeypatch):
    log = candump(tmp_path / "a.log", session(1.0))
    whole = table(log, ExportFormat.CSV)
    monkeypatch.setattr("armui.session.exports.history._ENOUGH", 1)
    monkeypatch.setattr("armui.session.text_logs._LINES_AT_ONCE", 7)
    monkeypatch.setattr("armui.session.source._BLOCK", 700)
    pd.testing.assert_frame_equal(table(log, ExportFormat.CSV), whole)


@FORMATS
def test_a_stretch_and_a_channel(tmp_path, kind):
    heard = session(0.5)
    other = [(at_s, frame) for at_s, frame in session(0.1) if frame.arbitration_id < 0x2A8]
    log = candump(tmp_path / "a.log", heard)
    text = log.read_text() + candump(tmp_path / "b.log", other, "can1").read_text()
    log.write_text(text)
    found = table(log, kind, begin_s=0.2, end_s=0.3)
    assert found["since_start"].min() == pytest.approx(0.2)
    assert found["since_start"].max() == pytest.approx(0.3)
    assert len(found) == 21
    assert len(table(log, kind, wishes=ArmOptions(channel="can1"))) == 20
    assert found["time"].iloc[0] == pytest.approx(START_S + 0.2, abs=1e-5)
