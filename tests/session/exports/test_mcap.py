"""MCAP files as readers by others see them: mcap with mcap-ros2-support, and rosbags."""

from __future__ import annotations

import base64
import math
from collections import defaultdict
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader
from scipy.spatial.transform import Rotation

from armui.arm.models import model_data
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.forward import links
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.session.exports.export import export_log
from armui.session.exports.request import ArmOptions, ExportFormat, ExportReport, ExportRequest
from tests.family import GEOMETRIES
from tests.session.exports.logs import START_S, candump, session

Read = dict[str, list[tuple[int, int, Any]]]
# 12° = 12000 = 0x2EE0, -90.5° = -90500 = 0xFFFE9E7C
ANGLES = (
    Frame(0x2A5, bytes.fromhex("00002EE0FFFE9E7C")),
    Frame(0x2A6, bytes.fromhex("0000000000015F90")),
    Frame(0x2A7, bytes.fromhex("FFFFFFFF00000001")),
)
WANTED = [math.radians(each) for each in (12.0, -90.5, 0.0, 90.0, -0.001, 0.001)]


def export(log: Path, **more: Any) -> tuple[Path, ExportReport]:
    target = log.with_suffix(".mcap")
    return target, export_log(ExportRequest(log, target, ExportFormat.MCAP, **more))


def by_mcap(path: Path) -> Read:
    """(log time, publish time, message) of each topic, in the order of the file."""
    found: Read = defaultdict(list)
    with path.open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()], validate_crcs=True)
        for each in reader.iter_decoded_messages(log_time_order=False):
            message = each.message
            times = message.log_time, message.publish_time
            found[each.channel.topic].append((*times, each.decoded_message))
    return found


def by_rosbags(path: Path) -> Read:
    """The same by a reader with a CDR decoder and type definitions of its own."""
    found: Read = defaultdict(list)
    with AnyReader([path]) as reader:
        for connection, time_ns, raw in reader.messages():
            message = reader.deserialize(raw, connection.msgtype)
            found[connection.topic].append((time_ns, time_ns, message))
    return found


READERS = pytest.mark.parametrize("read", [by_mcap, by_rosbags])


def statuses(message: Any) -> dict[str, SimpleNamespace]:
    """The parts of a diagnostic message by name."""
    return {
        each.name: SimpleNamespace(
            level=each.level,
            message=each.message,
            hardware_id=each.hardware_id,
            values={pair.key: pair.value for pair in each.values},
        )
        for each in message.status
    }


@READERS
@pytest.mark.parametrize("generation", list(Generation))
def test_angles_are_in_radians_with_both_times(tmp_path, read, generation):
    frames = [(2.0 + place / 1000, frame) for place, frame in enumerate(ANGLES)]
    target, _report = export(candump(tmp_path / "a.log", frames), wishes=ArmOptions(generation))
    ((log_ns, publish_ns, message),) = read(target)["/joint_states"]
    assert (log_ns, publish_ns) == (2_002_000_000, 2_002_000_000)
    assert (message.header.stamp.sec, message.header.stamp.nanosec) == (2, 2_000_000)
    assert list(message.name) == ["joint1", "joint2", "joint3", "joint4", "joint5", "joint6"]
    assert list(message.position) == pytest.approx(WANTED, abs=1e-12)
    assert message.position[0] == pytest.approx(0.2094395102, abs=1e-9)
    assert (list(message.velocity), list(message.effort)) == ([], [])


@READERS
@pytest.mark.parametrize(
    ("generation", "payload", "rad_s"),
    # 0x0140 = 320: 0.320 rad/s, or 320 rpm = 33.510 rad/s
    [
        (Generation.ONE, "0140000000000000", 33.510321638),
        (Generation.TWO, "0140000000000000", 0.32),
    ],
)
def test_speeds_where_a_driver_tells_them(tmp_path, read, generation, payload, rad_s):
    frames = [(2.0, Frame(0x252, bytes.fromhex(payload))), *((2.001, each) for each in ANGLES)]
    target, _report = export(candump(tmp_path / "a.log", frames), wishes=ArmOptions(generation))
    ((*_times, message),) = read(target)["/joint_states"]
    assert message.velocity[1] == pytest.approx(rad_s)
    assert [math.isnan(each) for each in message.velocity] == [True, False, *[True] * 4]
    assert list(message.position) == pytest.approx(WANTED, abs=1e-12)


@READERS
def test_targets_are_a_topic_of_their_own(tmp_path, read):
    targets = [Frame(each.arbitration_id - 0x150, each.data) for each in ANGLES]
    frames = [(3.0, each) for each in (*targets, *ANGLES)]
    target, _report = export(candump(tmp_path / "a.log", frames))
    ((*_times, message),) = read(target)["/joint_commands"]
    assert list(message.position) == pytest.approx(WANTED, abs=1e-12)
    assert list(message.velocity) == []


def test_a_set_of_angles_with_an_old_part_is_no_joint_state(tmp_path):
    first, second, third = ANGLES
    frames = [(1.0, first), (1.6, second), (1.61, third), *((2.0, each) for each in ANGLES)]
    found = by_mcap(export(candump(tmp_path / "a.log", frames))[0])
    assert [log_ns for log_ns, *_rest in found["/joint_states"]] == [2_000_000_000]


@READERS
@pytest.mark.parametrize("name", GEOMETRIES)
def test_transforms_lead_where_the_kinematics_say(tmp_path, read, name):
    geometry, model = GEOMETRIES[name], PiperModel(name.removesuffix("-older"))
    firmware = "S-V1.5-2" if name.endswith("-older") else "S-V1.8-5"
    log = candump(tmp_path / "a.log", [(2.0, each) for each in ANGLES])
    target, report = export(log, wishes=ArmOptions(firmware=firmware, model=model))
    assert (report.model, report.why_model) == (model_data(model).name, "as asked for")
    found = read(target)
    moving, fixed = found["/tf"][0][2], found["/tf_static"][0][2]
    joints_deg = np.degrees(WANTED)
    place = {"base_link": np.eye(4)}
    for each in (*moving.transforms, *fixed.transforms):
        shift, turn = each.transform.translation, each.transform.rotation
        step = np.eye(4)
        step[:3, :3] = Rotation.from_quat([turn.x, turn.y, turn.z, turn.w]).as_matrix()
        step[:3, 3] = [shift.x * 1000, shift.y * 1000, shift.z * 1000]
        place[each.child_frame_id] = place[each.header.frame_id] @ step
    wanted = Kinematics(geometry).matrix(joints_deg.tolist())
    assert place["flange"] == pytest.approx(wanted, abs=1e-6)
    assert place["link6"] == pytest.approx(wanted, abs=1e-6)
    of_links = links(geometry, joints_deg)
    assert place["link3"][:3, 3] == pytest.approx(of_links.elbow, abs=1e-6)
    assert place["link4"][:3, 3] == pytest.approx(of_links.wrist, abs=1e-6)
    assert place["link5"][:3, 3] == pytest.approx(of_links.centre, abs=1e-6)
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]) if name.startswith("piper_x") else None
    mounted = wanted.copy()
    if quarter is not None:
        mounted[:3, :3] = wanted[:3, :3] @ quarter
    assert place["gripper_base"] == pytest.approx(mounted, abs=1e-6)


@pytest.mark.parametrize("name", GEOMETRIES)
def test_arm_and_zeros_are_found_by_the_pose_in_the_log(tmp_path, name):
    """Nothing tells the firmware: the pose that the arm reports tells the zeros of its joints."""
    geometry, model = GEOMETRIES[name], PiperModel(name.removesuffix("-older"))
    codec = Codec(Generation.ONE)
    pose = Kinematics(geometry).forward(np.degrees(WANTED).tolist())
    poses = [
        codec.encode("EndPose1", X=pose.x_mm, Y=pose.y_mm),
        codec.encode("EndPose2", Z=pose.z_mm, RX=pose.rx_deg),
        codec.encode("EndPose3", RY=pose.ry_deg, RZ=pose.rz_deg),
    ]
    frames = [(2.0, each) for each in (*poses, *ANGLES)]
    target, report = export(candump(tmp_path / "a.log", frames), wishes=ArmOptions(Generation.ONE))
    assert (report.model, report.why_model) == (model_data(model).name, "its end pose fits")
    turned = by_mcap(target)["/tf"][0][2].transforms[1].transform.rotation
    # joint 2: half of -90.5° and its zero, about an axis that lies
    half = math.radians((-90.5 + geometry.rows[1].theta_deg) / 2)
    assert turned.w == pytest.approx(math.cos(math.radians(45)) * math.cos(half))


@READERS
def test_the_end_pose_as_the_arm_tells_it(tmp_path, read):
    frames = [
        # X 56.128 mm, Y -1 mm; Z 213.266 mm, RX 90°; RY -30°, RZ 45°
        (1.0, Frame(0x2A2, bytes.fromhex("0000DB40FFFFFC18"))),
        (1.0, Frame(0x2A3, bytes.fromhex("0003411200015F90"))),
        (1.0, Frame(0x2A4, bytes.fromhex("FFFF8AD00000AFC8"))),
    ]
    target, _report = export(candump(tmp_path / "a.log", frames))
    ((*_times, message),) = read(target)["/end_pose"]
    assert message.header.frame_id == "base_link"
    position, turn = message.pose.position, message.pose.orientation
    assert (position.x, position.y, position.z) == pytest.approx((0.056128, -0.001, 0.213266))
    wanted = Rotation.from_euler("ZYX", (45, -30, 90), degrees=True).as_quat()
    found = np.array([turn.x, turn.y, turn.z, turn.w])
    assert found == pytest.approx(wanted if found @ wanted > 0 else -wanted)


@READERS
def test_the_fingers_each_go_half_of_the_opening(tmp_path, read):
    # 70 mm = 0x11170
    frame = Frame(0x2A8, bytes.fromhex("0001117000004000"))
    target, _report = export(
        candump(tmp_path / "a.log", [(1.0, frame)]), wishes=ArmOptions(Generation.TWO)
    )
    found = read(target)
    ((*_times, state),) = found["/gripper/joint_states"]
    assert list(state.name) == ["gripper_left", "gripper_right"]
    assert list(state.position) == pytest.approx([0.035, 0.035])
    ((*_times, moved),) = found["/tf"]
    left, right = moved.transforms
    assert (left.header.frame_id, left.child_frame_id) == ("gripper_base", "finger_left")
    assert (left.transform.translation.y, right.transform.translation.y) == (0.035, -0.035)


# --- diagnostics ------------------------------------------------------------------------------


@READERS
def test_a_fault_is_told_when_it_begins_and_when_it_ends(tmp_path, read):
    # 24.0 V, 25 °C, 30 °C; enabled is bit 6, overcurrent bit 2
    sound, faulty = (bytes.fromhex(f"00F000191E{byte}0000") for byte in ("40", "44"))
    at = [(10.1, sound), (10.2, sound), (10.3, faulty), (10.4, faulty), (10.5, sound)]
    log = candump(tmp_path / "a.log", [(at_s, Frame(0x263, data)) for at_s, data in at])
    target, _report = export(log, wishes=ArmOptions(Generation.TWO, "S-V1.8-5"))
    told = [(log_ns, statuses(message)) for log_ns, _, message in read(target)["/diagnostics"]]
    assert [log_ns for log_ns, _told in told] == [10_100_000_000, 10_300_000_000, 10_500_000_000]
    joints = [each["arm: joint 3"] for _at_ns, each in told]
    assert [each.message for each in joints] == ["Enabled", "Overcurrent", "Enabled"]
    assert [int.from_bytes(e.level) if isinstance(e.level, bytes) else e.level for e in joints] == [
        0, 2, 0,
    ]  # fmt: skip
    assert {each.hardware_id for each in joints} == {"PiPER, generation 2, S-V1.8-5"}
    assert joints[1].values["Voltage [V]"] == "24"
    assert joints[1].values["Motor temperature [degC]"] == "30"


@READERS
@pytest.mark.parametrize("generation", list(Generation))
def test_the_status_of_the_arm_in_words(tmp_path, read, generation):
    frames = [
        (5.5, Frame(0x2A1, bytes.fromhex("0100010000000000"))),
        # emergency stop; then joint 1 cannot be talked to (bit 0 of byte 7)
        (5.6, Frame(0x2A1, bytes.fromhex("0101010000000000"))),
        (5.65, Frame(0x261, bytes.fromhex("00F000191E400000"))),
        (5.7, Frame(0x2A1, bytes.fromhex("0105010000000001"))),
    ]
    target, _report = export(candump(tmp_path / "a.log", frames), wishes=ArmOptions(generation))
    told = [statuses(message) for *_times, message in read(target)["/diagnostics"]]
    arm = [each["arm: status"] for each in told if "arm: status" in each]
    assert [each.message for each in arm] == [
        "Normal", "Emergency stop", "Joint communication fault",
    ]  # fmt: skip
    assert [each.level in {2, b"\x02"} for each in arm] == [False, True, True]
    assert arm[0].values["Control mode"] == "CAN control"
    assert told[-1]["arm: joint 1"].message == "Communication fault"


def test_what_is_silent_is_said_to_be_stale_each_second(tmp_path):
    status = Frame(0x2A1, bytes.fromhex("0100010000000000"))
    frames = [(1.0, status), *((1.0 + step / 10, ANGLES[0]) for step in range(1, 31))]
    found = by_mcap(export(candump(tmp_path / "a.log", frames))[0])["/diagnostics"]
    told = [(log_ns / 1e9, statuses(message)["arm: status"]) for log_ns, _, message in found]
    assert [(at_s, each.level, each.message) for at_s, each in told] == [
        (1.0, 0, "Normal"),
        (2.0, 3, "Not heard for half a second"),
        (3.0, 3, "Not heard for half a second"),
        (4.0, 3, "Not heard for half a second"),
    ]


# --- a session --------------------------------------------------------------------------------


@pytest.mark.parametrize("generation", list(Generation))
def test_a_session_of_the_arm_as_both_readers_see_it(tmp_path, generation):
    heard = session(1.2, generation)
    log = candump(tmp_path / "录制 1.log", heard)
    target, report = export(log)
    one, other = by_mcap(target), by_rosbags(target)
    assert report.generation == generation
    assert set(one) == set(other)
    assert report.items == sum(map(len, one.values()))
    for topic, messages in one.items():
        assert [each[0] for each in messages] == sorted(each[0] for each in other[topic])
    sets = [at_s for at_s, frame in heard if frame.arbitration_id == 0x2A7]
    states = one["/joint_states"]
    assert [each[0] for each in states] == [round(at_s * 1e6) * 1000 for at_s in sets]
    assert states[0][2].position[0] == pytest.approx(0.2094395102)
    assert states[-1][2].position[0] > 0.3
    assert max(each[2].velocity[0] for each in states if each[2].velocity) > 0.2
    commanded = one["/joint_commands"][0][2]
    assert commanded.position[0] == pytest.approx(0.5235987756)
    topics = {"/joint_states", "/tf", "/tf_static", "/end_pose", "/joint_commands", "/diagnostics"}
    if generation is Generation.TWO:
        topics.add("/gripper/joint_states")
    assert set(one) == topics


def test_a_stretch_of_a_session(tmp_path):
    log = candump(tmp_path / "a.log", session(1.0))
    target, _report = export(log, begin_s=0.5, end_s=0.7)
    found = by_mcap(target)
    times_s = [log_ns / 1e9 - START_S for log_ns, *_rest in found["/joint_states"]]
    assert times_s[0] == pytest.approx(0.5, abs=1e-6)
    assert times_s[-1] == pytest.approx(0.7, abs=1e-6)
    assert len(times_s) == 41
    # what was heard before is known from the first message on
    assert len(found["/joint_states"][0][2].velocity) == 6


def test_an_arm_with_an_identifier_offset(tmp_path):
    shifted = [Frame(each.arbitration_id + 0x10, each.data) for each in ANGLES]
    target, report = export(candump(tmp_path / "a.log", [(1.0, each) for each in shifted]))
    assert report.offset == 0x10
    ((*_times, message),) = by_mcap(target)["/joint_states"]
    assert list(message.position) == pytest.approx(WANTED, abs=1e-12)


def test_times_that_no_ros_stamp_can_tell_are_counted(tmp_path):
    frames = [*((-1.0, each) for each in ANGLES), *((3e9, each) for each in ANGLES)]
    frames += [(5.0, each) for each in ANGLES]
    log = tmp_path / "a.csv"
    head = "timestamp,arbitration_id,extended,remote,error,dlc,data\n"
    lines = [
        f"{at_s},{hex(frame.arbitration_id)},0,0,0,8,{base64.b64encode(frame.data).decode()}\n"
        for at_s, frame in frames
    ]
    log.write_text(head + "".join(lines))
    request = ExportRequest(log, tmp_path / "a.mcap", ExportFormat.MCAP, begin_s=0.0)
    report = export_log(request)
    assert report.without_stamp == 6
    assert [each[0] for each in by_mcap(tmp_path / "a.mcap")["/joint_states"]] == [5_000_000_000]
