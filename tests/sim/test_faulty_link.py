"""Frames that get lost, late, or were never sent; on the link alone and on a bus."""

from __future__ import annotations

import can
import pytest

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.faults.faulty_link import FaultyLink
from armui.sim.faults.schedule import read_fault
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.sim.talk import ENABLE, FRAMES_A_SECOND, frame

FRAMES = [Frame(0x151, bytes((number,) * 8)) for number in range(100)]


def test_a_good_line_changes_nothing() -> None:
    link = FaultyLink()
    assert link.to_arm(FRAMES, 0.0) == FRAMES
    assert link.to_bus(FRAMES, 0.0, 0.005) == (FRAMES, 0)


def test_lost_frames_are_missing_and_the_rest_is_in_order() -> None:
    link = FaultyLink(seed=1)
    link.loss = 0.3
    kept, lost = link.to_bus(FRAMES * 100, 0.0, 0.005)
    assert len(kept) + lost == 10_000
    assert lost == pytest.approx(3_000, rel=0.1)
    again = FaultyLink(seed=1)
    again.loss = 0.3
    assert again.to_bus(FRAMES * 100, 0.0, 0.005) == (kept, lost)
    one_way = link.to_arm(FRAMES, 0.0)
    assert len(one_way) < 100
    assert one_way == [each for each in FRAMES if each in one_way]


def test_late_frames_arrive_in_order_and_complete() -> None:
    link = FaultyLink()
    link.latency_s = 0.02
    arrived = [link.to_arm(FRAMES[tick : tick + 1], tick * 0.005) for tick in range(10)]
    assert arrived == [[]] * 4 + [[each] for each in FRAMES[:6]]
    link.latency_s = 0.0
    # what is under way is not overtaken
    assert link.to_arm([FRAMES[10]], 0.05) == [FRAMES[6]]
    assert link.to_arm([], 1.0) == [*FRAMES[7:11]]


def test_off_means_nothing_either_way() -> None:
    link = FaultyLink()
    link.latency_s = 0.1
    link.to_arm(FRAMES, 0.0)
    link.to_bus(FRAMES, 0.0, 0.005)
    link.off = True
    assert link.to_arm(FRAMES, 0.2) == []
    assert link.to_bus(FRAMES, 0.2, 0.005) == ([], 200)
    link.off, link.latency_s = False, 0.0
    assert link.to_arm([], 0.3) == []
    assert link.to_bus([], 0.3, 0.005) == ([], 0)


def test_garbage_comes_at_its_rate_and_is_always_a_frame() -> None:
    link = FaultyLink()
    link.garbage_per_s = 1500.0
    frames = [each for _ in range(200) for each in link.to_bus([], 0.0, 0.005)[0]]
    assert len(frames) == 1500
    assert {len(each.data) for each in frames} == set(range(9))
    assert all(0 <= each.arbitration_id <= 0x7FF for each in frames)


def node_with(fault: str, channel: str) -> tuple[can.BusABC, can.BusABC, Node]:
    host = can.Bus(interface="virtual", channel=channel)
    bus = can.Bus(interface="virtual", channel=channel)
    return host, bus, Node(Firmware(Generation.TWO), bus, faults=[read_fault(fault)], seed=7)


def count(host: can.BusABC) -> int:
    frames = 0
    while host.recv(timeout=0.0) is not None:
        frames += 1
    return frames


@pytest.mark.parametrize(
    ("fault", "least", "most"),
    [
        ("bus-off@1-2", 0, 0),
        ("lost-frames:0.5@1-2", 1300, 1700),
        ("latency:0.5@1-2", 1480, 1560),
        ("garbage:1000@1-2", FRAMES_A_SECOND + 1000, FRAMES_A_SECOND + 1000),
        ("feedback-stopped@1-2", 0, 0),
    ],
)
def test_faults_of_the_line_on_a_bus(fault: str, least: int, most: int) -> None:
    host, bus, node = node_with(fault, f"test_faults_of_the_line {fault}")
    with host, bus:
        counts = []
        for _ in range(3):
            for _ in range(200):
                node.poll(0.005)
            counts.append(count(host))
        assert counts[0] == FRAMES_A_SECOND
        assert least <= counts[1] <= most
        # what was late comes, the rest is as before
        assert FRAMES_A_SECOND - 40 <= counts[2] <= 1.5 * FRAMES_A_SECOND + 40
        assert node.sent == sum(counts)


def test_an_arm_that_is_bus_off_hears_nothing() -> None:
    host, bus, node = node_with("bus-off@0-0.1", "test_an_arm_that_is_bus_off")
    identifier, data = frame(ENABLE)
    message = can.Message(arbitration_id=identifier, data=data, is_extended_id=False)
    with host, bus:
        host.send(message)
        node.poll(0.2)
        assert node.firmware.enabled == (False,) * 6
        assert not node.heard
        assert node.lost > 0
        host.send(message)
        node.poll(0.005)
        assert node.firmware.enabled == (True,) * 6


def test_the_next_frames_of_one_identifier_get_lost_and_no_others() -> None:
    link = FaultyLink()
    modes = [Frame(0x151, bytes((number,) * 8)) for number in range(3)]
    others = [Frame(0x155, bytes(8))]
    link.lose_to_arm(0x151)
    assert link.to_arm(modes[:1] + others, 0.0) == others
    assert link.to_arm(modes, 0.0) == modes
    link.lose_to_bus(0x2A1, 2)
    told = [Frame(0x2A1, bytes((number,) * 8)) for number in range(3)]
    assert link.to_bus(told[:1], 0.0, 0.005) == ([], 1)
    assert link.to_bus(told, 0.0, 0.005) == (told[1:], 1)
    assert link.to_bus(told, 0.0, 0.005) == (told, 0)


def test_one_identifier_is_silent_until_it_is_not() -> None:
    link = FaultyLink()
    link.mute_on |= {0x2A5, 0x2A6}
    link.deaf_to.add(0x150)
    told = [Frame(identifier, bytes(8)) for identifier in (0x2A1, 0x2A5, 0x2A6)]
    for _ in range(3):
        assert link.to_bus(told, 0.0, 0.005) == (told[:1], 2)
        assert link.to_arm([frame("150#0100000000000000"), *FRAMES], 0.0) == FRAMES
    link.mute_on.clear()
    link.deaf_to.clear()
    assert link.to_bus(told, 0.0, 0.005) == (told, 0)
    assert link.to_arm([frame("150#0100000000000000")], 0.0)
