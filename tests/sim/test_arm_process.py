"""The simulated arm in a process of its own: its line, its hand, its beginning and its end."""

import multiprocessing
import socket
import time
from typing import Any

import pytest

from armui.arm.limits import JOINTS
from armui.arm.rest_pose import REST_DEG
from armui.protocol.codec import Codec, Message
from armui.protocol.frame_records import RECORD_BYTES, pack, unpack
from armui.protocol.generation import Generation, PiperModel
from armui.sim.arm_choice import HAND, ArmChoice
from armui.sim.arm_process import PROCESS_NAME, ArmProcess, LineHand
from armui.sim.line_arm import LineArm
from armui.system.record_socket import RecordSocket
from tests.posix import kill
from tests.sim.talk import ENABLE, frame

LIMIT_S = 60.0
TWO = Generation.TWO
RECORD = "150#0000010000000000"
SIX = (10.0, 20.0, -30.0, 5.0, 6.0, 7.0)


def angles_in(frames):
    """The joint angles last told in them, as far as they are."""
    codec, told = Codec(TWO), {}
    for each in frames:
        message = codec.decode(each)
        if isinstance(message, Message) and message.name.startswith("Joint"):
            told.update(message.signals)
    return tuple(told[f"J{joint}"] for joint in JOINTS) if len(told) == 6 else None


class Desk:
    """A line arm in this process, with the other ends of its lines."""

    def __init__(self, joints_deg=(0.0,) * 6):
        (frames, there), (hand, hand_there) = socket.socketpair(), socket.socketpair()
        self.line, self.hand_line = (
            RecordSocket(frames, RECORD_BYTES),
            RecordSocket(hand, HAND.size),
        )
        self.hand = LineHand(self.hand_line)
        self.theirs = RecordSocket(there, RECORD_BYTES), RecordSocket(hand_there, HAND.size)
        self.arm = LineArm(ArmChoice(TWO, joints_deg=joints_deg), *self.theirs)

    def run(self, seconds):
        """Let time pass; what is said meanwhile is read."""
        heard = []
        for _ in range(round(seconds / 0.02)):
            self.arm.poll(0.02)
            heard += unpack(self.line.receive())
        return heard

    def teach(self):
        self.line.send(pack([frame(ENABLE), frame(RECORD)]))
        self.run(0.1)

    def close(self):
        for each in (self.line, self.hand_line, *self.theirs):
            each.close()


@pytest.fixture
def desk():
    desk = Desk()
    yield desk
    desk.close()


def test_a_poll_is_one_message_and_what_it_hears_is_obeyed(desk):
    desk.line.send(pack([frame(ENABLE)]))
    desk.arm.poll(0.005)
    said = unpack(desk.line.receive())
    assert [each.arbitration_id for each in said[:3]] == [0x476, 0x2A1, 0x2A2]
    assert len(said) == 16
    assert desk.arm.firmware.enabled == (True,) * 6


def test_a_program_that_does_not_read_loses_bursts_and_holds_nobody_up(desk):
    for _ in range(100_000):
        desk.arm.poll(0.02)
        if desk.arm.lost:
            break
    assert desk.arm.lost
    sent = desk.arm.sent
    heard = []
    while part := unpack(desk.line.receive()):
        heard += part
    assert len(heard) == sent  # whole bursts, in order
    assert desk.run(0.02)


def test_the_hand_leads_it_and_lets_go(desk):
    desk.teach()
    desk.hand.lead_to(SIX, speed_deg_s=30.0)
    desk.run(0.5)
    # the joint with the longest way turns at 30°/s
    assert desk.arm.firmware.joints_deg == pytest.approx([angle / 2 for angle in SIX], abs=0.7)
    desk.hand.release()
    desk.run(0.02)
    rested = desk.arm.firmware.joints_deg
    desk.run(0.5)
    assert desk.arm.firmware.joints_deg == rested
    desk.hand.lead_to(SIX)
    desk.run(1.0)
    assert desk.arm.firmware.joints_deg == pytest.approx(SIX)


def test_a_hand_whose_line_ends_has_let_go(desk):
    desk.teach()
    desk.hand.lead_to(SIX)
    desk.run(0.1)
    desk.hand_line.close()
    desk.run(0.02)
    rested = desk.arm.firmware.joints_deg
    desk.run(0.5)
    assert desk.arm.firmware.joints_deg == rested
    assert desk.run(0.1)  # it lives on


def test_a_hand_that_is_not_felt_lets_go_and_holds_nobody_up(desk):
    """The arm's process hangs: where its line is full, it is closed."""
    desk.teach()
    for _ in range(1_000_000):
        desk.hand.lead_to(SIX)
        if desk.hand_line.fileno() < 0:
            break
    assert desk.hand_line.fileno() < 0
    desk.hand.release()
    for _ in range(10):
        desk.run(0.5)
    rested = desk.arm.firmware.joints_deg
    desk.run(0.5)
    assert desk.arm.firmware.joints_deg == rested


def test_the_end_of_the_line_ends_its_life(desk):
    desk.line.close()
    desk.arm.run()  # comes back


@pytest.fixture
def processes():
    """Starts processes; ends them afterwards."""
    begun = []

    def begin(choice):
        begun.append(ArmProcess(choice))
        return begun[-1]

    yield begin
    for each in begun:
        each.end()
    assert not any(each.name == PROCESS_NAME for each in multiprocessing.active_children())


def test_it_lies_as_it_is_told_says_so_and_ends_with_its_line(processes):
    arm = processes(ArmChoice(TWO, joints_deg=SIX))
    arm.wait_until_it_lives(LIMIT_S)
    heard: list[Any] = []
    until_s = time.monotonic() + LIMIT_S
    while (told := angles_in(heard)) is None:
        assert time.monotonic() < until_s
        heard += unpack(arm.line.receive(1.0))
    assert told == pytest.approx(SIX, abs=0.01)
    arm.line.close()  # the program is gone
    arm._process.join(LIMIT_S)
    assert arm._process.exitcode == 0


def listen_for_ever(line):
    while line.receive(LIMIT_S):
        pass


def test_a_killed_one_is_the_end_of_the_line(processes):
    arm = processes(ArmChoice(TWO))
    arm.wait_until_it_lives(LIMIT_S)
    kill(arm.pid)
    with pytest.raises(ConnectionError):
        listen_for_ever(arm.line)
    arm.hand.lead_to(SIX)  # nobody is there; nobody minds


def test_one_that_cannot_live_is_told_of_at_once(processes, capfd):
    arm = processes(ArmChoice(TWO, model="nosuch"))  # type: ignore[arg-type]  # as a damaged installation
    with pytest.raises(ConnectionError):
        arm.wait_until_it_lives(LIMIT_S)
    assert "AttributeError" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("model", "version", "joints"),
    [
        (PiperModel.PIPER, None, REST_DEG),
        (PiperModel.PIPER_X, "S-V1.9-0", REST_DEG),
        (PiperModel.PIPER, "S-V1.6-2", (0.0, 0.001, -0.029, *REST_DEG[3:])),
    ],
)
def test_without_angles_it_lies_as_a_real_one(model, version, joints):
    """The same place, whatever zeros the firmware counts from."""
    one, other = socket.socketpair()
    line, hand_line = RecordSocket(one, RECORD_BYTES), RecordSocket(other, HAND.size)
    arm = LineArm(ArmChoice(TWO, model, version), line, hand_line)
    assert arm.firmware.joints_deg == pytest.approx(joints)
    line.close()
    hand_line.close()
