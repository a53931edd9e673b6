"""Stops and halts: on which identifiers they go out, what is told, and what is followed."""

from __future__ import annotations

from typing import Any, cast

import pytest

from armui.arm.device import Device
from armui.arm.state import ArmState, Reading
from armui.control.context import REFUSED
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST, NOT_CONNECTED, OFFLINE, LinkState
from armui.control.link.offsets import OffsetFollower
from armui.control.operating_state import StopState
from armui.control.operations.started import Ending, Started
from armui.control.safety.stopping import (
    HALT_AT_REST,
    HALT_LISTEN_ONLY,
    HALT_NOT_OUT,
    HALT_SENT,
    STOP_ABANDONED,
    STOP_CONFIRMED,
    STOP_LAPSED,
    STOP_NOT_SENT,
    STOP_REACHES_OTHER,
    STOP_SENT,
    STOP_UNCONFIRMED,
    STOP_UNDONE,
    STOP_WITHDRAWN,
    Stopping,
)
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import ArmStatusCode, ControlMode, TeachingState
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.control.heard_arm import status

BEGIN_S = 0.25
STEP_S = 0.015625
STOP = bytes.fromhex("01 00 00 00 00 00 00 00")
ABORT = bytes.fromhex("00 06 00 00 00 00 00 00")
ABORT_TEACHING = bytes.fromhex("00 00 06 00 00 00 00 00")
STOPPED, RUNNING = ArmStatusCode.EMERGENCY_STOP, ArmStatusCode.NORMAL
DEVICE = Device("virtual", "one")
OTHER = Device("virtual", "two")


def told(arm_status=RUNNING, at_s=BEGIN_S, **changes):
    return ArmState(status=Reading(status(arm_status=arm_status, **changes), at_s))


class Connection:
    """Stands for the way to the arm."""

    def __init__(self, happened) -> None:
        self.device: Device | None = DEVICE
        self.link = LinkState.ONLINE
        self.codec = Codec(Generation.TWO)
        self.offsets = OffsetFollower()
        self.newest = ArmState()
        self.sent: list[list[Frame]] = []
        self.on_the_bus = True
        self._happened = happened

    def send_urgent(self, frames) -> bool:
        self.sent.append(list(frames))
        self._happened.append("sent")
        return self.on_the_bus


class Console:
    """A `Stopping` and all it needs.

    Attributes:
        happened: What was sent, told and ended, in order.
        params: The figures of the newest notice.
        named: Those of all notices.
        records: The records of commands that were told, in order.
    """

    def __init__(self) -> None:
        self.now_s = BEGIN_S
        self.happened: list[str | Notice] = []
        self.params: dict[str, Any] = {}
        self.named: list[Any] = []
        self.records: list[Started] = []
        self.connection = Connection(self.happened)
        self.stopping = Stopping(
            cast("Any", self.connection),
            self._emit_event,
            lambda: self.now_s,
            lambda: self.happened.append("all ended"),
        )

    def _emit_event(self, notice, started=None, /, **params) -> None:
        self.happened.append(notice)
        if started is not None and started not in self.records:
            self.records.append(started)
        self.params = params
        self.named.extend(params.values())

    def take(self) -> list[str | Notice]:
        """What happened since this was asked last."""
        happened, self.happened[:] = list(self.happened), []
        return happened

    def advance(self, arm_status=RUNNING, *, resuming=False, still=False, seconds=STEP_S):
        """The arm says something now."""
        self.now_s += seconds
        state = told(arm_status, self.now_s)
        self.stopping.follow_arm(state, self.now_s, resuming=resuming, still=still)

    def stop_and_confirm(self) -> None:
        """A stop, and the arm's word."""
        self.stopping.stop()
        self.advance(STOPPED)
        assert self.take()[-1] == STOP_CONFIRMED


@pytest.fixture
def console():
    return Console()


def on_all(data, first=0x00):
    """A frame under the arm's own control offset, the others behind."""
    offsets = (first, *(each for each in OFFSETS if each != first))
    return [Frame(0x150 + each, data) for each in offsets]


# The stop -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", OFFSETS)
def test_it_goes_out_on_all_three_its_own_first(console, offset):
    console.connection.codec = Codec(Generation.TWO, Addressing(0x00, offset))
    console.stopping.stop()
    assert console.connection.sent == [on_all(STOP, offset)]


@pytest.mark.parametrize(("on_the_bus", "notice"), [(True, STOP_SENT), (False, STOP_NOT_SENT)])
def test_it_is_sent_before_anything_else_is_done(console, on_the_bus, notice):
    console.connection.on_the_bus = on_the_bus
    console.stopping.stop()
    assert console.take() == ["sent", "all ended", notice]


def test_without_a_device_it_is_said_that_it_was_not_sent(console):
    console.connection.device = None
    console.stopping.stop()
    assert console.take() == [STOP_NOT_SENT]
    assert not console.stopping.emergency_stop.requested


@pytest.mark.parametrize(
    ("own", "heard", "named"),
    [
        (0x00, {0x00}, []),
        (0x00, {0x00, 0x10}, ["0x2B1"]),
        (0x00, {0x20}, ["0x2C1"]),
        (0x10, {0x00, 0x10, 0x20}, ["0x2A1", "0x2C1"]),
    ],
)
def test_other_arms_that_are_heard_are_named(console, own, heard, named):
    console.connection.offsets.addressing = Addressing(own, 0x00)
    fresh, old = BEGIN_S - 0.5, BEGIN_S - 0.51
    times = tuple(fresh if each in heard else old for each in OFFSETS)
    console.connection.newest = ArmState(status_heard_s=times)
    console.stopping.stop()
    assert console.named == named
    assert console.take()[3:] == [STOP_REACHES_OTHER] * len(named)


def test_what_becomes_of_it_is_told_once(console):
    console.stopping.stop()
    console.take()
    console.advance(seconds=0.5)
    assert console.take() == ["sent"]
    console.advance()
    assert console.take() == [STOP_UNCONFIRMED]
    console.advance()
    assert console.take() == []
    console.advance(STOPPED)
    assert console.take() == [STOP_CONFIRMED]
    console.advance(STOPPED)
    assert console.take() == []


def test_the_next_one_that_is_overdue_is_told_again(console):
    for _ in range(2):
        console.stopping.stop()
        console.take()
        console.advance(seconds=0.6)
        assert STOP_UNCONFIRMED in console.take()
        console.advance(STOPPED)
        console.take()


def test_that_it_has_lapsed_is_told_once(console):
    console.stopping.stop()
    console.connection.link = LinkState.OFFLINE
    console.advance(seconds=9.0)
    assert STOP_LAPSED not in console.take()
    console.advance(seconds=2.0)
    assert console.take() == [STOP_LAPSED]
    console.advance()
    assert console.take() == []
    console.stopping.stop()
    console.advance()
    console.take()
    console.advance(seconds=11.0)
    assert STOP_LAPSED in console.take()


def test_that_it_has_lapsed_is_told_at_the_first_look(console):
    console.stopping.stop()
    console.connection.link = LinkState.OFFLINE
    console.advance(seconds=11.0)
    assert STOP_LAPSED in console.take()


def test_an_arm_that_is_online_is_not_away(console):
    console.stopping.stop()
    for _ in range(12):
        console.advance(seconds=1.0)
    assert STOP_LAPSED not in console.take()


def test_where_it_stands_is_by_an_arm_that_is_online(console):
    def stands(resuming=False):
        return console.stopping.state(told(STOPPED), BEGIN_S, resuming=resuming)

    assert stands() is StopState.STOPPED
    assert stands(resuming=True) is StopState.RESUMING
    console.connection.link = LinkState.OFFLINE
    assert stands() is StopState.RUNNING


def test_a_stop_that_is_outstanding_may_be_withdrawn(console):
    console.stopping.withdraw()
    assert console.take() == []
    console.stopping.stop()
    console.take()
    console.stopping.withdraw()
    assert console.take() == [STOP_WITHDRAWN]
    assert not console.stopping.emergency_stop.requested


# Another connection -------------------------------------------------------------------------------


@pytest.mark.parametrize(("device", "kept"), [(DEVICE, True), (OTHER, False)])
def test_an_outstanding_stop_holds_for_the_device_it_was_asked_of(console, device, kept):
    console.stopping.stop()
    console.take()
    console.stopping.on_connecting(device)
    assert console.stopping.emergency_stop.requested is kept
    assert console.take() == ([] if kept else [STOP_ABANDONED])
    assert console.params == ({} if kept else {"device": DEVICE})


def test_what_is_confirmed_or_was_never_asked_for_is_not_abandoned(console):
    console.stopping.on_connecting(OTHER)
    assert console.take() == []
    console.stop_and_confirm()
    console.stopping.on_connecting(OTHER)
    assert console.take() == []


def test_over_another_connection_nobody_undoes_a_stop(console):
    console.stop_and_confirm()
    console.stopping.on_connecting(DEVICE)
    console.advance(RUNNING)
    assert console.take() == []


# Undone -------------------------------------------------------------------------------------------


def test_another_host_that_undoes_it_is_told_and_not_stopped_again_by_itself(console):
    assert console.stopping.stop_again is False
    console.stop_and_confirm()
    console.advance(STOPPED)
    console.advance(RUNNING)
    assert console.take() == [STOP_UNDONE]
    assert not console.stopping.emergency_stop.requested


def test_as_a_setting_it_is_stopped_again(console):
    console.stopping.stop_again = True
    console.stop_and_confirm()
    console.advance(RUNNING)
    assert console.take() == [STOP_UNDONE, "sent", "all ended", STOP_SENT]
    assert console.stopping.emergency_stop.requested


def test_our_own_resume_undoes_nothing(console):
    console.stopping.stop_again = True
    console.stop_and_confirm()
    console.advance(RUNNING, resuming=True)
    assert console.take() == []


# Halt and hold ------------------------------------------------------------------------------------


def halt(console):
    return console.stopping.halt(lambda: console.happened.append("driven ended"))


@pytest.mark.parametrize(("on_the_bus", "notice"), [(True, HALT_SENT), (False, HALT_NOT_OUT)])
def test_a_halt_is_sent_before_anything_else_is_done(console, on_the_bus, notice):
    console.connection.on_the_bus, console.connection.newest = on_the_bus, told()
    assert halt(console) is None
    assert console.take() == ["sent", "driven ended", notice]
    assert console.connection.sent == [on_all(ABORT)]


REPLAYS = [
    {"arm_status": ArmStatusCode.TEACHING_RUNNING},
    {"arm_status": ArmStatusCode.TEACHING_PAUSED},
    {"control_mode": ControlMode.TEACHING, "teaching": TeachingState.PAUSE},
    # it may have begun since
    {"control_mode": ControlMode.TEACHING, "teaching": TeachingState.STOP_RECORDING},
    None,
]
NONE = [{}, {"arm_status": ArmStatusCode.TEACHING_RECORDING}, {"arm_status": STOPPED}]


@pytest.mark.parametrize(
    ("changes", "aborts"), [*((each, True) for each in REPLAYS), *((each, False) for each in NONE)]
)
def test_a_recording_that_the_arm_runs_is_aborted_too(console, changes, aborts):
    console.connection.newest = ArmState() if changes is None else told(**changes)
    assert halt(console) is None
    expected = [*on_all(ABORT), *(on_all(ABORT_TEACHING) if aborts else [])]
    assert console.connection.sent == [expected]


@pytest.mark.parametrize(
    ("device", "link", "code"),
    [
        (
            Device("virtual", "one", listen_only=True),
            LinkState.ONLINE,
            HALT_LISTEN_ONLY,
        ),
        (DEVICE, LinkState.OFFLINE, OFFLINE),
        (DEVICE, LinkState.LOST, LINK_LOST),
        (None, LinkState.NO_DEVICE, NOT_CONNECTED),
        (DEVICE, LinkState.ONLINE, None),
    ],
)
def test_when_there_is_nothing_to_halt(console, device, link, code):
    console.connection.device, console.connection.link = device, link
    refusal = console.stopping.why_no_halt()
    assert (refusal and refusal.reason) == code
    assert halt(console) == refusal
    if code is not None:
        assert console.take() == [REFUSED]
        assert console.params == {"reason": refusal}
        assert console.connection.sent == []


def test_rest_after_a_halt_is_told_once(console):
    halt(console)
    console.take()
    console.advance(seconds=1.25)
    assert console.take() == []
    console.advance(still=True, seconds=0.05)
    assert console.take() == [HALT_AT_REST]
    console.advance(still=True)
    assert console.take() == []


@pytest.mark.parametrize(("after_s", "its_doing"), [(1.3, True), (1.35, False)])
def test_later_than_that_the_rest_of_the_arm_is_not_its_doing(console, after_s, its_doing):
    console.now_s = 0.0
    halt(console)
    console.advance(seconds=after_s)
    console.take()
    console.advance(still=True)
    assert console.take() == ([HALT_AT_REST] if its_doing else [])


ENDS = {
    "stop": lambda console: console.stopping.stop(),
    "another connection": lambda console: console.stopping.on_connecting(DEVICE),
}


@pytest.mark.parametrize("what", ENDS)
def test_what_ends_the_following_of_a_halt(console, what):
    halt(console)
    ENDS[what](console)
    console.advance(still=True)
    assert HALT_AT_REST not in console.take()


def test_a_rest_nobody_asked_for_is_not_told(console):
    console.advance(still=True)
    assert console.take() == []


# What is kept of both -----------------------------------------------------------------------------


def at_rest(console):
    console.advance(still=True)


def never_at_rest(console):
    console.advance(seconds=1.25)
    assert endings(console) == [None]
    console.advance(seconds=0.1)


def endings(console):
    return [record.ending for record in console.records]


@pytest.mark.parametrize(
    ("then", "ending"), [(at_rest, Ending.DONE), (never_at_rest, Ending.FAILED)]
)
def test_the_record_of_a_halt_says_whether_the_arm_came_to_rest(console, then, ending):
    halt(console)
    assert [(each.operation, each.ending) for each in console.records] == [("halt", None)]
    then(console)
    assert endings(console) == [ending]


def test_another_halt_or_stop_cuts_off_the_record_of_the_one_before(console):
    halt(console)
    halt(console)
    assert endings(console) == [Ending.CUT_OFF, None]
    console.stopping.stop()
    console.stopping.stop()
    assert [each.operation for each in console.records] == ["halt", "halt", "stop", "stop"]
    assert endings(console)[2:] == [Ending.CUT_OFF, None]
    console.advance(STOPPED)
    assert endings(console)[3] is Ending.DONE


def test_the_record_of_a_stop_without_a_device_says_that_it_failed(console):
    console.connection.device = None
    console.stopping.stop()
    assert endings(console) == [Ending.FAILED]
