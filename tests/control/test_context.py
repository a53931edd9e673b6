"""How a part of the controller sends a motion: asked for first, numbered, slower ones led."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast
from unittest.mock import Mock

import pytest

from armui.arm.state import ArmState
from armui.control.context import COMMAND_OVER, GENERATION_UNKNOWN, REFUSED
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST, OFFLINE, LinkState
from armui.control.motion.motion_command import CommandKind, End, MotionCommand
from armui.control.motion.motion_context import MotionContext
from armui.control.operating_state import OperatingState
from armui.control.operations.started import Ending, Started
from armui.control.safety.other_command import OTHER_HOST
from armui.protocol.codec import Codec
from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.telemetry.events import EventKind, Level
from armui.ways.passes import Pass
from tests.control.heard_arm import HERE, NOWHERE, THERE, Arm, status
from tests.moments import now

GOES = Notice("goes", "{percent}", Level.INFO, EventKind.COMMAND)
TARGET = Frame(0x155, bytes(8))
PASSED = Pass()
TOOL = (object(),)


class Connection:
    """Stands for the way to the arm."""

    def __init__(self) -> None:
        self.codec = Codec(Generation.TWO)
        self.happened: list[Any] = []
        self.works = True
        self.device: object | None = None

    def void(self, newest) -> None:
        self.happened.append(("void", newest))

    def send(self, frames, keep_s, number, passed) -> bool:
        assert passed is PASSED
        self.happened.append((list(frames), keep_s, number))
        return self.works


class Part:
    """A part's context, and what came of it."""

    def __init__(self) -> None:
        self.arm = Arm()
        self.connection = Connection()
        self.told: list[Any] = []
        self.looks = 0
        self.context = MotionContext(
            connection=cast("Any", self.connection),
            emit_event=lambda code, _started=None, /, **params: self.told.append((code, params)),
            clock=lambda: self.arm.now_s,
            state=ArmState,
            operating_state=OperatingState,
            refresh=OperatingState,
            observe=self._look,
            authority=self.arm.authority,
            begun=Mock(),
            gate=Mock(),
        )

    def _look(self) -> None:
        self.looks += 1
        self.arm.look()

    def send(self, percent=30, **fields):
        """A motion to joint angles."""
        given = {"passed": PASSED, "joints_deg": THERE, "move_mode": MoveMode.MOVE_J, **fields}
        return self.context.send_motion(
            CommandKind.JOINTS, [TARGET], started=Started("a"), speed_percent=percent, **given
        )


@pytest.fixture
def part():
    return Part()


def other_host(part):
    part.arm.other()


def test_what_is_not_done_is_told(part):
    refusal = OFFLINE()
    assert part.context.refuse(refusal) is refusal
    assert part.told == [(REFUSED, {"reason": refusal})]


def test_how_a_command_ended_or_goes_is_noted_and_told(part):
    started = Started("a")
    part.context.report(started, GOES, percent=5)
    assert now(started.ending) is None
    assert started.result.params == {"percent": 5}
    part.context.close(started, Ending.FAILED, GOES, percent=6)
    assert started.ending is Ending.FAILED
    assert started.result.params == {"percent": 6}
    assert part.told == [(GOES, {"percent": 5}), (GOES, {"percent": 6})]


@pytest.mark.parametrize(
    ("link", "generation", "reason"),
    [
        (LinkState.ONLINE, Generation.TWO, None),
        (LinkState.ONLINE, None, GENERATION_UNKNOWN),
        (LinkState.OFFLINE, Generation.TWO, OFFLINE),
        (LinkState.OFFLINE, None, OFFLINE),
    ],
)
def test_why_the_arm_cannot_be_asked(part, link, generation, reason):
    part.connection.link, part.connection.generation = link, generation
    refusal = part.context.why_unknown()
    assert (refusal and refusal.reason) == reason


# A motion -----------------------------------------------------------------------------------------


def test_a_motion_is_ours_from_the_moment_it_is_sent(part):
    command = part.send(42, tool=TOOL, keep_s=0.125, move_mode=MoveMode.MOVE_L)
    assert isinstance(command, MotionCommand)
    assert command is part.arm.authority.command
    assert (command.kind, command.sent_s) == (CommandKind.JOINTS, part.arm.now_s)
    assert (command.speed_percent, command.joints_deg, command.tool) == (42, THERE, TOOL)
    assert part.connection.happened[0] == ("void", command.number)
    frames, keep_s, number = part.connection.happened[1]
    assert frames[-1] == TARGET
    assert (keep_s, number) == (0.125, command.number)
    part.arm.look()
    assert part.arm.authority.mode_in_force() == (ControlMode.CAN_CONTROL, MoveMode.MOVE_L)


def test_who_moves_the_arm_is_looked_at_first(part):
    other_host(part)
    assert part.send().reason == OTHER_HOST
    assert part.looks == 1
    assert part.connection.happened == []
    assert part.arm.authority.command is None


def test_what_was_refused_has_ended(part):
    other_host(part)
    started = Started("a")
    part.context.send_motion(
        *(CommandKind.JOINTS, [TARGET]),
        passed=PASSED,
        started=started,
        move_mode=MoveMode.MOVE_J,
        speed_percent=30,
    )
    assert started.ending is Ending.REFUSED


def test_what_could_not_be_sent_is_not_ours(part):
    part.connection.works = False
    assert part.send().reason == LINK_LOST
    assert part.arm.authority.command is None
    assert part.arm.authority.ended is End.NOT_SENT


# Its speed ----------------------------------------------------------------------------------------

SLOWER = Frame(0x151, bytes.fromhex("01 01 05 00 00 00 00 00"))


@pytest.mark.parametrize(
    ("had", "percent", "leads"), [(30, 5, True), (5, 5, False), (5, 30, False), (None, 5, True)]
)
def test_a_lower_percentage_goes_out_before_the_target(part, had, percent, leads):
    part.arm.look()
    part.arm.authority.arm_percent = had
    part.send(percent)
    frames, _, _ = part.connection.happened[1]
    assert frames == ([SLOWER, TARGET] if leads else [TARGET])


def test_the_speed_alone_keeps_the_modes(part):
    frames = part.context.speed_frames((ControlMode.CAN_CONTROL, MoveMode.MOVE_L), 7)
    assert frames == [Frame(0x151, bytes.fromhex("01 02 07 00 00 00 00 00"))]


@pytest.mark.parametrize(
    "changes",
    [{"control_mode": ControlMode.STANDBY}, {"control_mode": ControlMode.ETHERNET_CONTROL}],
    ids=["standby", "somebody else"],
)
def test_where_no_target_starts_nothing_goes_before_it(part, changes):
    part.arm.status = status(**changes)
    part.arm.look()
    assert part.context.lead_frames(5) == []


# A stream -----------------------------------------------------------------------------------------


def go_on(part, command, keep_s=None):
    return part.context.send_on(command, [TARGET], passed=PASSED, joints_deg=NOWHERE, keep_s=keep_s)


def test_the_next_setpoint_goes_out_alone_under_the_same_number(part):
    command = part.send(joints_deg=HERE)
    part.connection.happened.clear()
    part.arm.now_s += 0.02
    further = go_on(part, command, 0.0625)
    assert further == replace(command, joints_deg=NOWHERE, sent_s=part.arm.now_s)
    assert further is part.arm.authority.command
    assert part.connection.happened == [([TARGET], 0.0625, command.number)]


def test_a_stream_that_is_over_does_not_go_on(part):
    first = part.send()
    part.send()
    part.connection.happened.clear()
    assert go_on(part, first).reason == COMMAND_OVER
    assert part.connection.happened == []


def test_a_stream_gives_way_to_another_host(part):
    command = part.send()
    part.connection.happened.clear()
    part.arm.now_s += 0.02
    other_host(part)
    assert go_on(part, command).reason == OTHER_HOST
    assert part.connection.happened == []
    assert part.looks == 2


def test_a_setpoint_that_cannot_be_sent_is_told(part):
    command = part.send()
    part.connection.works = False
    assert go_on(part, command).reason == LINK_LOST
    assert part.arm.authority.command is None
    assert part.arm.authority.ended is End.NOT_SENT
