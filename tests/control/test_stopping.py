"""Stops and halts: on which identifiers they go out, what is told, and what is followed."""

from __future__ import annotations

import pytest

from armui.arm.device import Device
from armui.arm.state import ArmState, Reading
from armui.control.link.offsets import OffsetFollower
from armui.control.operating_state import LinkState, StopState
from armui.control.safety.stopping import Stopping
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


class Desk:
    """A `Stopping` and all it needs.

    Attributes:
        happened: What was sent, told and ended, in order.
    """

    def __init__(self) -> None:
        self.now_s = BEGIN_S
        self.happened: list[str] = []
        self.params: dict = {}
        self.connection = Connection(self.happened)
        self.stopping = Stopping(
            self.connection,
            self._tell,
            lambda: self.now_s,
            lambda: self.happened.append("all ended"),
        )

    def _tell(self, code, **params) -> None:
        self.happened.append(code)
        self.params = params

    def take(self) -> list[str]:
        """What happened since this was asked last."""
        happened, self.happened[:] = list(self.happened), []
        return happened

    def advance(self, arm_status=RUNNING, *, resuming=False, still=False, seconds=STEP_S):
        """The arm says something now."""
        self.now_s += seconds
        state = told(arm_status, self.now_s)
        self.stopping.advance(state, self.now_s, resuming=resuming, still=still)

    def stop_and_confirm(self) -> None:
        """A stop, and the arm's word."""
        self.stopping.stop()
        self.advance(STOPPED)
        assert self.take()[-1] == "stop_confirmed"


@pytest.fixture
def app_driver():
    return Desk()


def on_all(data, first=0x00):
    """A frame under the arm's own control offset, the others behind."""
    offsets = (first, *(each for each in OFFSETS if each != first))
    return [Frame(0x150 + each, data) for each in offsets]


# The stop -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", OFFSETS)
def test_it_goes_out_on_all_three_its_own_first(app_driver, offset):
    app_driver.connection.codec = Codec(Generation.TWO, Addressing(0x00, offset))
    app_driver.stopping.stop()
    assert app_driver.connection.sent == [on_all(STOP, offset)]


@pytest.mark.parametrize(("on_the_bus", "code"), [(True, "stop_sent"), (False, "stop_not_sent")])
def test_it_is_sent_before_anything_else_is_done(app_driver, on_the_bus, code):
    app_driver.connection.on_the_bus = on_the_bus
    app_driver.stopping.stop()
    assert app_driver.take() == ["sent", "all ended", code]


def test_without_a_device_it_is_said_that_it_was_not_sent(app_driver):
    app_driver.connection.device = None
    app_driver.stopping.stop()
    assert app_driver.take() == ["stop_not_sent"]
    assert not app_driver.stopping.keeper.requested


@pytest.mark.parametrize(
    ("own", "heard", "named"),
    [
        (0x00, {0x00}, []),
        (0x00, {0x00, 0x10}, ["0x2B1"]),
        (0x00, {0x20}, ["0x2C1"]),
        (0x10, {0x00, 0x10, 0x20}, ["0x2A1", "0x2C1"]),
    ],
)
def test_other_arms_that_are_heard_are_named(app_driver, own, heard, named):
    app_driver.connection.offsets.addressing = Addressing(own, 0x00)
    fresh, old = BEGIN_S - 0.5, BEGIN_S - 0.51
    times = tuple(fresh if each in heard else old for each in OFFSETS)
    app_driver.connection.newest = ArmState(status_heard_s=times)
    names = []
    tell = app_driver.stopping._tell
    app_driver.stopping._tell = lambda code, **params: (
        tell(code, **params) or names.extend(params.values())
    )
    app_driver.stopping.stop()
    assert names == named
    assert app_driver.take()[3:] == ["stop_reaches_other"] * len(named)


def test_what_becomes_of_it_is_told_once(app_driver):
    app_driver.stopping.stop()
    app_driver.take()
    app_driver.advance(seconds=0.5)
    assert app_driver.take() == ["sent"]
    app_driver.advance()
    assert app_driver.take() == ["stop_unconfirmed"]
    app_driver.advance()
    assert app_driver.take() == []
    app_driver.advance(STOPPED)
    assert app_driver.take() == ["stop_confirmed"]
    app_driver.advance(STOPPED)
    assert app_driver.take() == []


def test_the_next_one_that_is_overdue_is_told_again(app_driver):
    for _ in range(2):
        app_driver.stopping.stop()
        app_driver.take()
        app_driver.advance(seconds=0.6)
        assert "stop_unconfirmed" in app_driver.take()
        app_driver.advance(STOPPED)
        app_driver.take()


def test_that_it_has_lapsed_is_told_once(app_driver):
    app_driver.stopping.stop()
    app_driver.connection.link = LinkState.OFFLINE
    app_driver.advance(seconds=9.0)
    assert "stop_lapsed" not in app_driver.take()
    app_driver.advance(seconds=2.0)
    assert app_driver.take() == ["stop_lapsed"]
    app_driver.advance()
    assert app_driver.take() == []
    app_driver.stopping.stop()
    app_driver.advance()
    app_driver.take()
    app_driver.advance(seconds=11.0)
    assert "stop_lapsed" in app_driver.take()


def test_that_it_has_lapsed_is_told_at_the_first_look(app_driver):
    app_driver.stopping.stop()
    app_driver.connection.link = LinkState.OFFLINE
    app_driver.advance(seconds=11.0)
    assert "stop_lapsed" in app_driver.take()


def test_an_arm_that_is_online_is_not_away(app_driver):
    app_driver.stopping.stop()
    for _ in range(12):
        app_driver.advance(seconds=1.0)
    assert "stop_lapsed" not in app_driver.take()


def test_where_it_stands_is_by_an_arm_that_is_online(app_driver):
    def stands(resuming=False):
        return app_driver.stopping.state(told(STOPPED), BEGIN_S, resuming=resuming)

    assert stands() is StopState.STOPPED
    assert stands(resuming=True) is StopState.RESUMING
    app_driver.connection.link = LinkState.OFFLINE
    assert stands() is StopState.RUNNING


def test_a_stop_that_is_outstanding_may_be_withdrawn(app_driver):
    app_driver.stopping.withdraw()
    assert app_driver.take() == []
    app_driver.stopping.stop()
    app_driver.take()
    app_driver.stopping.withdraw()
    assert app_driver.take() == ["stop_withdrawn"]
    assert not app_driver.stopping.keeper.requested


# Another connection -------------------------------------------------------------------------------


@pytest.mark.parametrize(("device", "kept"), [(DEVICE, True), (OTHER, False)])
def test_an_outstanding_stop_holds_for_the_device_it_was_asked_of(app_driver, device, kept):
    app_driver.stopping.stop()
    app_driver.take()
    app_driver.stopping.on_connecting(device)
    assert app_driver.stopping.keeper.requested is kept
    assert app_driver.take() == ([] if kept else ["stop_abandoned"])
    assert app_driver.params == ({} if kept else {"device": DEVICE})


def test_what_is_confirmed_or_was_never_asked_for_is_not_abandoned(app_driver):
    app_driver.stopping.on_connecting(OTHER)
    assert app_driver.take() == []
    app_driver.stop_and_confirm()
    app_driver.stopping.on_connecting(OTHER)
    assert app_driver.take() == []


def test_over_another_connection_nobody_undoes_a_stop(app_driver):
    app_driver.stop_and_confirm()
    app_driver.stopping.on_connecting(DEVICE)
    app_driver.advance(RUNNING)
    assert app_driver.take() == []


# Undone -------------------------------------------------------------------------------------------


def test_another_host_that_undoes_it_is_told_and_not_stopped_again_by_itself(app_driver):
    assert app_driver.stopping.stop_again is False
    app_driver.stop_and_confirm()
    app_driver.advance(STOPPED)
    app_driver.advance(RUNNING)
    assert app_driver.take() == ["stop_undone"]
    assert not app_driver.stopping.keeper.requested


def test_as_a_setting_it_is_stopped_again(app_driver):
    app_driver.stopping.stop_again = True
    app_driver.stop_and_confirm()
    app_driver.advance(RUNNING)
    assert app_driver.take() == ["stop_undone", "sent", "all ended", "stop_sent"]
    assert app_driver.stopping.keeper.requested


def test_our_own_resume_undoes_nothing(app_driver):
    app_driver.stopping.stop_again = True
    app_driver.stop_and_confirm()
    app_driver.advance(RUNNING, resuming=True)
    assert app_driver.take() == []


# Halt and hold ------------------------------------------------------------------------------------


def halt(app_driver):
    return app_driver.stopping.halt(lambda: app_driver.happened.append("driven ended"))


@pytest.mark.parametrize(("on_the_bus", "code"), [(True, "halt_sent"), (False, "halt_not_out")])
def test_a_halt_is_sent_before_anything_else_is_done(app_driver, on_the_bus, code):
    app_driver.connection.on_the_bus = on_the_bus
    assert halt(app_driver) is None
    assert app_driver.take() == ["sent", "driven ended", code]
    assert app_driver.connection.sent == [on_all(ABORT)]


REPLAYS = [
    {"arm_status": ArmStatusCode.TEACHING_RUNNING},
    {"arm_status": ArmStatusCode.TEACHING_PAUSED},
    {"control_mode": ControlMode.TEACHING, "teaching": TeachingState.PAUSE},
]
NONE = [{}, {"arm_status": ArmStatusCode.TEACHING_RECORDING}, {"arm_status": STOPPED}]


@pytest.mark.parametrize(
    ("changes", "aborts"), [*((each, True) for each in REPLAYS), *((each, False) for each in NONE)]
)
def test_a_recording_that_the_arm_runs_is_aborted_too(app_driver, changes, aborts):
    app_driver.connection.newest = told(**changes)
    assert halt(app_driver) is None
    expected = [*on_all(ABORT), *(on_all(ABORT_TEACHING) if aborts else [])]
    assert app_driver.connection.sent == [expected]


@pytest.mark.parametrize(
    ("device", "link", "code"),
    [
        (Device("virtual", "one", listen_only=True), LinkState.ONLINE, "halt_listen_only"),
        (DEVICE, LinkState.OFFLINE, "offline"),
        (DEVICE, LinkState.LOST, "link_lost"),
        (None, LinkState.NO_DEVICE, "not_connected"),
        (DEVICE, LinkState.ONLINE, None),
    ],
)
def test_when_there_is_nothing_to_halt(app_driver, device, link, code):
    app_driver.connection.device, app_driver.connection.link = device, link
    refusal = app_driver.stopping.why_no_halt()
    assert (refusal and refusal.code) == code
    assert halt(app_driver) == refusal
    if code is not None:
        assert app_driver.take() == ["refused"]
        assert app_driver.params == {"reason": refusal}
        assert app_driver.connection.sent == []


def test_rest_after_a_halt_is_told_once(app_driver):
    halt(app_driver)
    app_driver.take()
    app_driver.advance(seconds=1.25)
    assert app_driver.take() == []
    app_driver.advance(still=True, seconds=0.05)
    assert app_driver.take() == ["halt_at_rest"]
    app_driver.advance(still=True)
    assert app_driver.take() == []


@pytest.mark.parametrize(("after_s", "its_doing"), [(1.3, True), (1.35, False)])
def test_later_than_that_the_rest_of_the_arm_is_not_its_doing(app_driver, after_s, its_doing):
    app_driver.now_s = 0.0
    halt(app_driver)
    app_driver.advance(seconds=after_s)
    app_driver.take()
    app_driver.advance(still=True)
    assert app_driver.take() == (["halt_at_rest"] if its_doing else [])


ENDS = {
    "stop": lambda app_driver: app_driver.stopping.stop(),
    "another connection": lambda app_driver: app_driver.stopping.on_connecting(DEVICE),
}


@pytest.mark.parametrize("what", ENDS)
def test_what_ends_the_following_of_a_halt(app_driver, what):
    halt(app_driver)
    ENDS[what](app_driver)
    app_driver.advance(still=True)
    assert "halt_at_rest" not in app_driver.take()


def test_a_rest_nobody_asked_for_is_not_told(app_driver):
    app_driver.advance(still=True)
    assert app_driver.take() == []
