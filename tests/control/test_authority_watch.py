"""What the authority is told of the link, and what the operator is told of the authority."""

from __future__ import annotations

from typing import Any, cast

import pytest

from armui.arm.other_hosts import OtherHosts
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Reading
from armui.control.authority import Authority
from armui.control.authority_watch import (
    CANCEL_UNHEEDED,
    LEADER_ARM_MOVES,
    MOTION_TOO_FAST,
    MOTION_UNHEEDED,
    OTHER_HOST_GONE,
    OTHER_HOST_MOVES,
    TAKEN_OVER,
    AuthorityWatch,
)
from armui.control.events import Notice
from armui.control.link.link_state import LinkState
from armui.control.link.offsets import OffsetFollower
from armui.control.motion.motion_command import CommandKind, End, Mover
from armui.control.operations.started import Ending, Started
from armui.control.safety.other_command import OTHER_HOST, OTHER_HOST_STREAMS, OTHER_MODE
from armui.control.safety.overspeed import TOO_FAST
from armui.protocol.addressing import Addressing
from armui.protocol.codes import MoveMode
from armui.protocol.generation import PiperModel
from armui.telemetry.events import Level
from tests.control.heard_arm import DRIVER, HERE, NOWHERE, THERE, status
from tests.moments import now
from tests.ui.arm_states import heard_six

BEGIN_S = 0.25
STEP_S = 0.015625
LEADER = (0x151, 0x155, 0x156, 0x157, 0x159)


class Connection:
    """Stands for the way to an arm that is heard without a pause."""

    def __init__(self, program) -> None:
        self._program = program
        self.device: object | None = object()
        self.offsets = OffsetFollower()
        self.link = LinkState.ONLINE
        self.idle = True
        self.model = PiperModel.PIPER
        self.hosts = OtherHosts()
        self.joints_deg = HERE
        self.status = status()
        self.voided: list[int] = []

    @property
    def newest(self) -> ArmState:
        now_s = self._program.now_s
        return ArmState(
            status=Reading(self.status, now_s),
            joints_deg=heard_six(self.joints_deg, now_s),
            drivers_slow=(Reading(DRIVER, now_s),) * 6,
        )

    @property
    def traffic(self):
        return self.hosts.traffic()

    def void(self, number: int) -> None:
        self.voided.append(number)


class Program:
    """An `AuthorityWatch` and what came of it.

    Attributes:
        told: Each notice with its figures.
        ended: The reasons for which our motion was ended.
    """

    def __init__(self) -> None:
        self.now_s = BEGIN_S
        self.told: list[tuple[Notice, dict[str, Any]]] = []
        self.ended: list[Refusal] = []
        self.authority = Authority()
        self.connection = Connection(self)
        self.watch = AuthorityWatch(
            self.authority, cast("Any", self.connection), self._emit_event, self.ended.append
        )
        self.wait(0.5)

    def _emit_event(self, notice, _started=None, /, **params) -> None:
        self.told.append((notice, params))

    def wait(self, seconds: float, deg: float = 0.0) -> None:
        """Advance every 1/64 s while joint 1 turns so far each time."""
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self.now_s += STEP_S
            joints_deg = self.connection.joints_deg
            self.connection.joints_deg = (joints_deg[0] + deg, *joints_deg[1:])
            self.watch.follow_arm(self.now_s)

    def other(self, *identifiers: int) -> None:
        """Another host sends frames now."""
        for each in identifiers:
            self.connection.hosts.note(each, bytes(8), self.now_s)

    def send(self, percent: int = 30, kind=CommandKind.JOINTS, target=HERE, started=None):
        """A command of ours."""
        return self.authority.begin(
            kind,
            now_s=self.now_s,
            move_mode=MoveMode.MOVE_J,
            speed_percent=percent,
            joints_deg=target,
            started=started,
        )

    def ordered(self, target=THERE, kind=CommandKind.JOINTS) -> Started:
        """A command of ours, with the record of its operation."""
        started = Started("send_joints")
        self.send(kind=kind, target=target, started=started)
        self.wait(STEP_S)
        return started

    def stand_at(self, joint_1_deg: float, *, reached: bool, arm_status: int = 0) -> None:
        """Joint 1 turns as far at 40°/s, and the arm rests there."""
        self.connection.status = status(reached=False)
        self.wait(joint_1_deg / 40, deg=0.625)
        self.connection.status = status(reached=reached, arm_status=arm_status)
        self.wait(1.0)

    @property
    def notices(self) -> list[Notice]:
        """Those that were told."""
        return [notice for notice, _ in self.told]


@pytest.fixture
def program():
    return Program()


# What the authority is told -----------------------------------------------------------------------


def test_it_hears_the_arm(program):
    assert now(program.authority.mover) is Mover.NOBODY
    program.connection.link = LinkState.OFFLINE
    program.wait(STEP_S)
    assert program.authority.mover is Mover.UNKNOWN


def test_without_a_device_nothing_is_heard(program):
    program.connection.device = None
    program.connection.link = LinkState.NO_DEVICE
    program.watch.observe(program.now_s)
    assert now(program.authority.mover) is Mover.NOBODY


def test_frames_that_have_not_left_are_about_to_move_the_arm(program):
    command = program.send()
    program.wait(0.5)
    assert program.authority.command.sent_s == command.sent_s
    program.connection.idle = False
    program.wait(STEP_S)
    assert program.authority.command.sent_s == program.now_s


@pytest.mark.parametrize(
    ("own", "certain", "identifier", "counts"),
    [
        (0x00, True, 0x155, True),
        (0x00, True, 0x165, False),
        (0x10, True, 0x165, True),
        (0x10, True, 0x155, False),
        (0x10, False, 0x155, True),
        (0x10, False, 0x175, True),
    ],
)
def test_whose_frames_move_the_arm(program, own, certain, identifier, counts):
    program.connection.offsets.addressing = Addressing(0x00, own)
    program.connection.offsets.control_known = certain
    program.other(identifier)
    program.wait(STEP_S)
    assert program.authority.other.commands is counts


def test_what_waits_is_voided_when_a_command_has_ended_and_only_then(program):
    assert program.connection.voided == []
    command = program.send()
    program.wait(STEP_S)
    assert program.connection.voided == [command.number]
    program.wait(0.1)
    assert len(program.connection.voided) == 1
    program.other(0x155)
    program.wait(0.1)
    assert program.authority.ended is End.OTHER_HOST
    assert program.connection.voided == [command.number, program.authority.number]
    assert program.authority.number > command.number


# What the operator is told ------------------------------------------------------------------------


def test_another_host_is_named_a_tenth_of_a_second_later_and_when_it_is_gone(program):
    program.other(0x155, 0x151)
    program.wait(0.09375)
    assert program.told == []
    program.wait(STEP_S)
    assert program.told == [(OTHER_HOST_MOVES, {"frames": "0x151, 0x155"})]
    program.wait(1.5)
    assert len(program.told) == 1
    program.wait(0.5)
    assert program.notices == [OTHER_HOST_MOVES, OTHER_HOST_GONE]


def test_a_leader_is_named_as_one(program):
    for _ in range(12):
        program.other(*LEADER)
        program.wait(STEP_S)
    assert program.notices == [LEADER_ARM_MOVES]


def test_the_same_host_beginning_anew_is_named_at_once(program):
    """It is known by then; a take-over ends what the operator was told of."""
    program.other(0x155)
    program.wait(0.6)
    assert program.watch.take_over(program.now_s) is None
    program.wait(STEP_S)
    assert program.notices == [
        OTHER_HOST_MOVES,
        TAKEN_OVER,
        OTHER_HOST_GONE,
    ]
    program.other(0x155)
    program.wait(0.125)
    assert program.notices[3:] == [OTHER_HOST_MOVES]


def test_a_stream_is_not_taken_over(program):
    program.other(0x155)
    program.wait(0.25)
    refusal = program.watch.take_over(program.now_s)
    assert refusal.reason == OTHER_HOST_STREAMS
    assert TAKEN_OVER not in program.notices


def test_a_frame_heard_just_before_a_take_over_counts(program):
    program.other(0x155)
    program.wait(0.6)
    program.other(0x155)
    assert program.watch.take_over(program.now_s).reason == OTHER_HOST_STREAMS


def test_a_cancel_that_is_not_heeded_is_told_once(program):
    for count in (1, 2):
        program.authority.cancelled(program.now_s)
        program.wait(1.5, deg=1.0)
        assert program.notices == [CANCEL_UNHEEDED] * count
        program.wait(1.0)


def test_a_motion_that_is_far_too_fast_is_ended_and_told(program):
    program.connection.status = status(reached=False)
    program.send(5)
    program.wait(0.25, deg=1.0)
    assert {each.reason for each in program.ended} == {TOO_FAST}
    notice, params = program.told[0]
    assert notice == MOTION_TOO_FAST
    assert params == {"reason": program.ended[0]}


def test_a_motion_at_its_speed_is_left_alone(program):
    program.connection.status = status(reached=False)
    program.send(100)
    program.wait(0.25, deg=1.0)
    assert program.ended == []
    assert program.told == []


# How a command of ours ends ----------------------------------------------------------------------


def test_one_that_arrives_is_done(program):
    started = program.ordered()
    program.stand_at(40.0, reached=True)
    assert started.ending is Ending.DONE
    assert (started.result.code, started.result.level) == ("arrived", Level.DONE)
    assert program.told == []


def test_one_that_rests_and_has_not_arrived_by_what_the_arm_says_has_failed(program):
    started = program.ordered()
    program.stand_at(40.0, reached=False)
    assert started.ending is Ending.FAILED
    assert (started.result.code, started.result.params) == ("motion_cut", {"end": "short"})


@pytest.mark.parametrize("said", [2, 3, 4], ids=["no solution", "singular", "beyond a limit"])
def test_one_that_the_arm_itself_refuses_has_failed_though_it_stands(program, said):
    started = program.ordered()
    program.stand_at(40.0, reached=True, arm_status=said)
    assert started.ending is Ending.FAILED
    assert (started.result.code, started.result.params) == ("motion_cut", {"end": "refused"})


@pytest.mark.parametrize(
    ("end", "level"),
    [(End.CANCELLED, Level.INFO), (End.REPLACED, Level.INFO), (End.STOPPED, Level.WARNING)],
)
def test_one_that_is_cut_off_says_by_what(program, end, level):
    started = program.ordered()
    if end is End.REPLACED:
        program.send()
    else:
        program.authority.end_command(end)
    program.wait(STEP_S)
    assert started.ending is Ending.CUT_OFF
    assert started.result.level is level
    assert started.result.params == {"end": end.name}
    assert program.authority.over == []


def test_the_next_command_of_the_same_operation_cuts_nothing_off(program):
    started = program.ordered()
    program.send(target=NOWHERE, started=started)
    program.wait(STEP_S)
    assert started.ending is None
    program.authority.end_command(End.STOPPED)
    program.wait(STEP_S)
    assert started.ending is Ending.CUT_OFF


def test_a_replay_ends_its_own_record(program):
    started = program.ordered(kind=CommandKind.REPLAY)
    program.authority.end_command(End.STOPPED)
    program.wait(STEP_S)
    assert started.ending is None


def test_a_motion_that_the_arm_does_not_take_up_is_told_and_has_failed(program):
    program.ordered(target=HERE)
    program.wait(1.5)
    assert program.told == []
    program.connection.status = status(reached=False)
    for count in (1, 2):
        started = program.ordered()
        program.wait(0.25)
        assert now(started.ending) is None
        program.wait(0.75)
        assert program.notices == [MOTION_UNHEEDED] * count
        assert started.ending is Ending.FAILED
        assert started.result.level is Level.FAULT


def test_so_is_one_whose_mode_the_arm_did_not_take_up(program):
    """It has ended by then, and is the last of those that have."""
    first, last = program.ordered(), Started("send_joints")
    program.send(target=NOWHERE, started=last)
    program.authority.end_command(End.OTHER_MODE)
    program.wait(STEP_S)
    assert program.notices == [MOTION_UNHEEDED]
    assert first.ending is Ending.CUT_OFF
    assert last.ending is Ending.FAILED


def test_a_motion_that_is_held_back_is_neither_unheeded_nor_over(program):
    started = program.ordered()
    program.authority.paused()
    program.wait(2.0)
    assert started.ending is None
    program.authority.went_on(program.now_s)
    program.wait(STEP_S)
    assert program.told == []


def test_another_connection_ends_what_the_last_one_began(program):
    started = program.ordered()
    program.authority.end_command(End.OTHER_MODE)
    program.watch.reset(program.now_s)
    assert started.ending is Ending.CUT_OFF
    program.wait(2.0)
    assert program.told == []


# Who it is ----------------------------------------------------------------------------------------


def test_nobody_else_is_not_reported(program):
    assert program.watch.report() is None


def test_another_host_is_reported_while_it_stands_against_a_motion(program):
    for _ in range(7):
        program.other(0x155)
        program.wait(STEP_S)
    report = program.watch.report()
    assert report.frames == "0x155"
    assert report.rate_hz == 60
    assert report.refusal.reason == OTHER_HOST
    assert report.may_be_taken_over is False
    program.wait(0.6)
    later = program.watch.report()
    assert later.may_be_taken_over is True
    assert later.since is report.since
    program.wait(2.0)
    assert program.watch.report() is None


@pytest.mark.parametrize("between", ["gone", "forgotten", "taken over"])
def test_the_next_one_has_a_time_of_its_own(program, between):
    program.other(0x155)
    program.wait(0.6)
    first = program.watch.report().since
    if between == "gone":
        program.wait(2.0)
        assert program.watch.report() is None
    elif between == "forgotten":
        program.watch.reset(program.now_s)
    else:
        assert program.watch.take_over(program.now_s) is None
    program.other(0x155)
    program.wait(STEP_S)
    assert program.watch.report().since is not first


def test_a_mode_without_frames_is_reported_too(program):
    program.connection.status = status(move_mode=MoveMode.MOVE_M)
    program.wait(STEP_S)
    report = program.watch.report()
    assert report.refusal.reason == OTHER_MODE
    assert report.since is program.watch.report().since
    program.connection.status = status()
    program.wait(STEP_S)
    assert program.watch.report() is None
    program.connection.status = status(move_mode=MoveMode.MOVE_M)
    program.wait(STEP_S)
    assert program.watch.report().since is not report.since


def test_over_another_connection_it_is_told_anew(program):
    program.other(0x155)
    program.wait(0.2)
    program.watch.reset(program.now_s)
    program.wait(STEP_S)
    assert program.notices == [OTHER_HOST_MOVES] * 2


def test_over_another_connection_a_cancel_is_told_anew(program):
    program.authority.cancelled(program.now_s)
    program.wait(1.5, deg=1.0)
    program.watch.reset(program.now_s)
    program.wait(STEP_S, deg=1.0)
    assert program.notices == [CANCEL_UNHEEDED] * 2
