"""From what was heard to what the operator can do: the reasons against it, and their order."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from armui.arm.device import Device
from armui.arm.limits import JointLimits
from armui.arm.state import ArmState, Reading
from armui.control.assessment import assess
from armui.control.link.link_state import LINK_LOST, LISTEN_ONLY, OFFLINE, LinkState
from armui.control.link.offsets import OffsetFollower
from armui.control.motion.motion_command import PLAN_PAUSED, Hold, Mover
from armui.control.operating_state import BUSY, RUN_UNDER_WAY, Busy, OperatingState, StopState
from armui.control.run.progress import RunPhase
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.interlocks import (
    ARM_FAULT,
    CONTROL_OFFSET_UNKNOWN,
    NOT_ENABLED,
    OTHER_CONTROL,
    SPEED_ZERO,
    STOPPED,
)
from armui.control.safety.other_command import OTHER_HOST
from armui.protocol.addressing import Addressing
from armui.protocol.codes import ArmStatusCode, ControlMode
from armui.protocol.generation import Generation
from tests.control.heard_arm import DRIVER, HERE, NORMAL, THERE, Arm, status
from tests.family import FACTORY_LIMITS

DEVICE = Device("virtual", "one")
OFF = DRIVER._replace(enabled=False)
LIMITS = JointLimits(-90.0, 90.0, 100.0)


class Console:
    """An arm, what the program does, and what may be done."""

    def __init__(self) -> None:
        self.arm = Arm()
        self.known = OperatingState(
            link=LinkState.ONLINE,
            device=DEVICE,
            link_problem=None,
            stop=StopState.RUNNING,
            stop_unconfirmed=False,
            busy=None,
            speed_percent=30,
            generation=Generation.TWO,
        )
        self.offsets = OffsetFollower()
        self.changes: dict[str, Any] = {}

    @property
    def state(self) -> ArmState:
        """The arm as heard now."""
        now_s = self.arm.now_s
        heard = {
            "status": Reading(self.arm.status, now_s),
            "joints_deg": tuple(Reading(each, now_s) for each in self.arm.joints_deg),
            "drivers_slow": (Reading(DRIVER, now_s),) * 6,
        }
        return ArmState(**{**heard, **self.changes})

    def given(self, **fields) -> None:
        """What the program knows beside the arm's own words."""
        self.known = replace(self.known, **fields)

    def assess(self):
        """What the operator can do."""
        return assess(self.state, self.known, self.arm.authority, self.offsets, self.arm.now_s)


@pytest.fixture
def console():
    return Console()


def code(refusal):
    return refusal and refusal.reason


# Reasons ------------------------------------------------------------------------------------------


def speed_zero(console):
    console.given(speed_percent=0)


def held(console):
    console.arm.authority.paused()


def running(console):
    console.given(running=True)


def not_ready(console):
    console.arm.status = status(control_mode=ControlMode.REMOTE_CONTROL)


def disabled(console):
    console.changes["drivers_slow"] = (Reading(OFF, console.arm.now_s),) * 6


def other_host(console):
    console.arm.other()
    console.arm.look()


def silent(console):
    console.arm.silent.add("joints")
    console.arm.wait(0.6)
    console.arm.silent.clear()


def altering(console):
    console.given(altering="limits")


def uncertain(console):
    offsets = OffsetFollower()
    offsets.control_known = False
    console.offsets = offsets


def busy(console):
    console.given(busy=Busy.ENABLING)


def stopped(console):
    console.given(stop=StopState.STOPPED)


def offline(console):
    console.given(link=LinkState.OFFLINE)


AGAINST_A_MOTION = [
    (speed_zero, SPEED_ZERO),
    (held, PLAN_PAUSED),
    (running, RUN_UNDER_WAY),
]
AGAINST_A_RUN = [
    (not_ready, OTHER_CONTROL),
    (disabled, NOT_ENABLED),
    (other_host, OTHER_HOST),
    (silent, FEEDBACK_SILENT),
    (altering, BUSY),
    (uncertain, CONTROL_OFFSET_UNKNOWN),
]
AGAINST_ANYTHING = [
    (busy, BUSY),
    (stopped, STOPPED),
    (offline, OFFLINE),
]


def test_nothing_speaks_against_a_motion_of_an_arm_that_is_ready(console):
    operating = console.assess()
    assert operating.cannot_move is None
    assert operating.cannot_run is None
    assert operating.cannot_enable is None
    assert operating.cannot_send_motion is None


def test_each_reason_goes_before_those_that_matter_less(console):
    for kind, table in enumerate((AGAINST_A_MOTION, AGAINST_A_RUN, AGAINST_ANYTHING)):
        for happens, reason in table:
            happens(console)
            operating = console.assess()
            assert code(operating.cannot_move) == reason
            assert code(operating.cannot_run) == (reason if kind > 0 else None)
            assert code(operating.cannot_enable) == (reason if kind > 1 else None)


@pytest.mark.parametrize(
    ("happens", "reason"), [*AGAINST_A_MOTION, *AGAINST_A_RUN, *AGAINST_ANYTHING]
)
def test_each_reason_alone(console, happens, reason):
    happens(console)
    assert code(console.assess().cannot_move) == reason
    frames_may_not_leave = happens in {other_host, silent}
    sends = console.assess().cannot_send_motion
    assert code(sends) == (reason if frames_may_not_leave else None)


def test_what_is_being_set_is_named(console):
    altering(console)
    assert console.assess().cannot_run.params == {"what": "limits"}


def test_a_connection_that_only_listens_sends_nothing(console):
    console.given(device=replace(DEVICE, listen_only=True))
    assert code(console.assess().cannot_enable) == LISTEN_ONLY


# Motors -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("age_s", "driver", "enabled"),
    [(0.5, DRIVER, True), (0.5, OFF, False), (0.51, DRIVER, None), (0.51, OFF, None)],
)
@pytest.mark.parametrize("index", range(6))
def test_a_motor_is_on_by_a_fresh_word_of_its_own(console, index, age_s, driver, enabled):
    console.arm.now_s = 2.0
    six: list[Any] = [None] * 6
    six[index] = Reading(driver, 2.0 - age_s)
    console.changes["drivers_slow"] = tuple(six)
    expected = [None] * 6
    expected[index] = enabled
    assert console.assess().enabled == tuple(expected)


# Limits -------------------------------------------------------------------------------------------


def test_limits_that_were_read_go_before_the_factorys(console):
    wrong = JointLimits(-90.0, 90.0, 6553.5)
    read = Reading(LIMITS, 0.0)
    console.changes["limits"] = (read, None, Reading(wrong, 0.0), None, None, read)
    operating = console.assess()
    assert operating.limits == (LIMITS, *FACTORY_LIMITS[1:5], LIMITS)
    assert operating.limits_read == (True, False, False, False, False, True)


# Moving -------------------------------------------------------------------------------------------


def moves(console):
    console.arm.status = status(reached=False)
    console.arm.turn(5)


def test_an_arm_moves_that_says_so_and_is_measured_to(console):
    assert console.assess().moving is False
    moves(console)
    assert console.assess().moving is True
    console.arm.status = status()
    assert console.assess().moving is False
    console.arm.status = status(reached=False)
    console.arm.wait(0.5)
    assert console.assess().moving is False


def test_one_that_was_just_sent_counts_as_moving_before_it_is_measured(console):
    console.arm.send()
    assert console.assess().moving is True
    console.arm.wait(0.5)
    assert console.assess().moving is False


def test_frames_that_wait_move_no_arm_that_has_arrived(console):
    console.arm.send()
    console.arm.wait(0.5)
    console.arm.waiting = True  # a question, a lamp
    console.arm.wait(0.5)
    assert console.assess().moving is False


def test_before_the_status_is_heard_nothing_moves(console):
    moves(console)
    console.changes["status"] = None
    assert console.assess().moving is False


def test_a_motion_held_back_counts_as_moving(console):
    held(console)
    assert console.assess().moving is True


@pytest.mark.parametrize(
    "fields",
    [{"link": LinkState.OFFLINE}, {"stop": StopState.STOPPED}, {"stop": StopState.REQUESTED}],
)
def test_an_arm_that_is_away_or_stopped_does_not(console, fields):
    moves(console)
    console.given(**fields)
    assert console.assess().moving is False
    held(console)
    assert console.assess().moving is False


# A teaching input ---------------------------------------------------------------------------------


@pytest.fixture
def teaching_input(console):
    """Commands are heard, and drivers; the controller is not."""
    console.arm.now_s = 2.0
    console.changes.update(
        status=None, joints_deg=(None,) * 6, foreign_targets_s=1.5, pose=(None,) * 6
    )
    return console


def test_commands_without_feedback_are_a_teaching_inputs(teaching_input):
    assert teaching_input.assess().teaching_input is True
    teaching_input.given(link=LinkState.OFFLINE)
    assert teaching_input.assess().teaching_input is True


@pytest.mark.parametrize("link", [LinkState.NO_DEVICE, LinkState.OPENING, LinkState.LOST])
def test_without_a_bus_there_is_none(teaching_input, link):
    teaching_input.given(link=link)
    assert teaching_input.assess().teaching_input is False


@pytest.mark.parametrize("heard_s", [None, 1.49])
def test_commands_must_be_heard_of_late(teaching_input, heard_s):
    teaching_input.changes["foreign_targets_s"] = heard_s
    assert teaching_input.assess().teaching_input is False


@pytest.mark.parametrize(("age_s", "feeds"), [(0.5, True), (0.51, False)])
@pytest.mark.parametrize("what", ["status", "joints_deg", "pose"])
def test_a_controller_that_is_heard_is_none(teaching_input, what, age_s, feeds):
    value = NORMAL if what == "status" else 0.0
    heard = Reading(value, 2.0 - age_s)
    teaching_input.changes[what] = heard if what == "status" else (*(None,) * 5, heard)
    assert teaching_input.assess().teaching_input is not feeds


# What is handed on --------------------------------------------------------------------------------


def test_what_the_program_does_and_knows_is_told(console):
    problem = LINK_LOST()
    console.given(
        link_problem=problem,
        stop_unconfirmed=True,
        stop_lapsed=True,
        busy=Busy.ZEROING,
        generation=Generation.ONE,
        running=True,
        jogging=True,
        recording=True,
        altering="zero",
        run_sets_lamps=True,
        run_phase=RunPhase.PAUSED,
    )
    console.offsets.addressing = Addressing(0x10, 0x20)
    operating = console.assess()
    assert (operating.link, operating.device) == (LinkState.ONLINE, DEVICE)
    assert operating.link_problem is problem
    assert operating.stop is StopState.RUNNING
    assert (operating.stop_unconfirmed, operating.stop_lapsed) == (True, True)
    assert operating.busy is Busy.ZEROING
    assert (operating.running, operating.jogging, operating.recording) == (True, True, True)
    assert operating.run_phase is RunPhase.PAUSED
    assert (operating.altering, operating.run_sets_lamps) == ("zero", True)
    assert (operating.speed_percent, operating.generation) == (30, Generation.ONE)
    assert operating.addressing == Addressing(0x10, 0x20)
    assert operating.control_certain is True


@pytest.mark.parametrize("unheard", ["joints_deg", "pose"])
def test_which_figures_are_known_is_told(console, unheard):
    now_s = console.arm.now_s
    console.changes["pose"] = tuple(Reading(each, now_s) for each in range(6))
    operating = console.assess()
    assert (operating.angles_known, operating.pose_known) == (True, True)
    console.changes[unheard] = (None, *getattr(console.state, unheard)[1:])
    operating = console.assess()
    assert operating.angles_known is (unheard != "joints_deg")
    assert operating.pose_known is (unheard != "pose")


@pytest.mark.parametrize("happens", [disabled, running, held, None])
def test_the_check_of_a_reference_drives_no_arm_that_is_at_something_else(console, happens):
    if happens is not None:
        happens(console)
    operating = console.assess()
    against = {disabled: NOT_ENABLED, running: RUN_UNDER_WAY, held: PLAN_PAUSED, None: None}
    assert code(operating.reference.cannot_drive) == against[happens]


def test_a_stop_is_not_lapsed_unless_it_is_said(console):
    assert console.assess().stop_lapsed is False
    assert console.assess().other_host is None


def test_who_moves_the_arm_is_told(console):
    assert console.assess().mover is Mover.NOBODY
    console.arm.send()
    console.arm.wait(0.1)
    held(console)
    operating = console.assess()
    assert operating.mover is Mover.OURS
    assert operating.holds == {Hold.PAUSE}
    assert operating.held_target_deg == THERE
    assert operating.cancel_unheeded is False


def test_a_cancel_that_is_not_heeded_is_told(console):
    moves(console)
    console.arm.authority.cancelled(console.arm.now_s)
    console.arm.turn(60)
    assert console.assess().cancel_unheeded is True
    assert console.arm.joints_deg != HERE


@pytest.mark.parametrize("fault", [ArmStatusCode.COLLISION])
def test_a_fault_of_the_arm_is_told(console, fault):
    console.arm.status = status(arm_status=fault)
    assert console.assess().cannot_run == ARM_FAULT(status=fault)
