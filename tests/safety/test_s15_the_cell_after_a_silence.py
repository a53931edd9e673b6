"""S15: a cell stays in force over a short silence only if the arm shows that it is the same."""

from dataclasses import replace

import pytest

from armui.cell.tools import NO_TOOL
from armui.control.cell.cell_reasons import CELL_NOT_CONFIRMED
from armui.control.link.link_state import LinkState
from armui.control.safety.recovery_steps import StepKind
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, bend
from tests.control.under_way import BACK
from tests.faulty_arm import HardOfHearing
from tests.moments import now
from tests.safety.test_s15_the_cell_is_confirmed import BENCH, MOTION, PEN, again

ENABLED_BIT = 0x40
LIMIT_ANSWER = 0x473


@pytest.fixture
def arm_repeats():
    return False


@pytest.fixture
def confirmed(rig):
    """An enabled arm with the cell «bench», confirmed by the operator."""
    bend(rig)
    return with_bench(rig)


def with_bench(rig):
    rig.controller.cell.take_loaded({"bench": BENCH})
    again(rig, "bench")
    accepted(rig.controller.cell.confirm())
    rig.run(0.2)
    rig.events.clear()
    return rig


def silence(rig, seconds, meanwhile=lambda _rig: None):
    """Nothing is heard of the arm for so long; how the cell stands two seconds later."""
    before = rig.controller.mark.arms
    rig.firmware.feedback_stopped = True
    rig.run(seconds)
    assert now(rig.controller.operating_state.link) is LinkState.OFFLINE
    meanwhile(rig)
    rig.firmware.feedback_stopped = False
    rig.run(2.0)
    assert rig.controller.mark.arms == before + 1
    assert rig.controller.operating_state.link is LinkState.ONLINE
    return in_force(rig)


def in_force(rig):
    """Whether motions are taken with the cell's tool, or nothing moves and it is asked for."""
    controller = rig.controller
    refusal = controller.operating_state.cannot_send_motion
    if refusal is None:
        assert controller.cartesian.tool == PEN.pose
        assert controller.cell.in_force == BENCH
        return True
    assert (refusal.reason, refusal.params) == (CELL_NOT_CONFIRMED, {"name": "bench"})
    assert controller.cartesian.tool == NO_TOOL
    assert controller.recovery.step.kind is StepKind.CELL_UNCONFIRMED
    return False


@pytest.mark.parametrize("seconds", [0.6, 9.0])
def test_the_same_arm_that_rests_where_it_was_keeps_its_cell(confirmed, seconds):
    assert silence(confirmed, seconds)
    (told,) = [each for each in confirmed.events if each.code == "cell_stays"]
    assert told.params["name"] == "bench"
    assert told.params["seconds"] == pytest.approx(seconds, abs=0.1)
    accepted(confirmed.controller.motion.send_joints(BACK))


def test_so_it_does_over_one_silence_after_the_other(confirmed):
    for _ in range(3):
        assert silence(confirmed, 0.7)


def test_after_ten_seconds_it_is_asked_for(confirmed):
    assert not silence(confirmed, 10.1)


# Each condition by itself -----------------------------------------------------------------------


def another_version(rig):
    arm = rig.firmware
    arm.type = replace(arm.type, version=Firmware(arm.generation, version="S-V1.8-8").type.version)


def another_limit(rig):
    limits = rig.firmware.settings.limits
    limits[3] = limits[3]._replace(max_deg=limits[3].max_deg - 0.1)


def another_acceleration(rig):
    rig.firmware.settings.accelerations_deg_s2[5] -= 1.0


class Disabled:
    """A driver that says that its motor is off; the joint stays where it is."""

    def __init__(self, firmware, joint):
        step = firmware.step
        spoilt = 0x260 + joint

        def told(dt_s):
            return [
                self._off(each) if each.arbitration_id == spoilt else each for each in step(dt_s)
            ]

        firmware.step = told

    @staticmethod
    def _off(frame):
        data = bytearray(frame.data)
        data[5] &= ~ENABLED_BIT
        return frame._replace(data=bytes(data))


def motor_off_after(rig):
    Disabled(rig.firmware, 6)


def turned(joint, by_deg):
    def turn(rig):
        here = list(rig.firmware.mechanics.positions_deg)
        here[joint - 1] += by_deg
        rig.firmware.mechanics.count_anew(here)

    return turn


ASKED = {
    "another version": another_version,
    "another limit": another_limit,
    "another acceleration": another_acceleration,
    "a motor that is off": motor_off_after,
    "joint 1 elsewhere": turned(1, 1.1),
    "joint 6 elsewhere": turned(6, -1.1),
}


@pytest.mark.parametrize("meanwhile", ASKED.values(), ids=ASKED)
def test_one_difference_is_enough_to_be_asked(confirmed, meanwhile):
    assert not silence(confirmed, 1.0, meanwhile)
    assert "cell_stays" not in confirmed.codes()


@pytest.mark.parametrize("joint", [1, 6])
def test_less_than_a_degree_is_the_same_place(confirmed, joint):
    assert silence(confirmed, 1.0, turned(joint, 0.9))


def test_a_motor_that_was_off_before_is_enough(confirmed):
    step = confirmed.firmware.step
    Disabled(confirmed.firmware, 6)
    confirmed.run(0.5)

    def on_again(rig):
        rig.firmware.step = step

    assert not silence(confirmed, 1.0, on_again)


def test_an_arm_that_names_no_version_is_asked(any_rig):
    """Generation 1 answers nothing: one arm is like the other."""
    bend(any_rig)
    with_bench(any_rig)
    any_rig.ear = HardOfHearing(any_rig.firmware)
    assert not silence(any_rig, 1.0, lambda rig: rig.ear.mute_on.add(0x4AF))


def test_an_arm_that_does_not_tell_its_limits_is_asked(confirmed):
    confirmed.ear = HardOfHearing(confirmed.firmware)
    assert not silence(confirmed, 1.0, lambda rig: rig.ear.mute_on.add(LIMIT_ANSWER))


def test_another_arm_on_the_same_adapter_is_asked(confirmed):
    """Of the same make, with the same answers; only its motors are off, and it lies elsewhere."""
    rig = confirmed
    rig.powered = False
    rig.run(1.0)
    rig.firmware = Firmware(rig.firmware.generation)
    rig.node = Node(rig.firmware, rig._arm_bus)
    rig.powered = True
    rig.run(3.0)
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert rig.controller.cell.unconfirmed.reason == CELL_NOT_CONFIRMED


def test_a_power_cycle_is_asked(confirmed):
    rig = confirmed
    rig.firmware.switch_off()
    rig.run(1.0)
    rig.firmware.switch_on()
    rig.run(3.0)
    assert rig.controller.cell.unconfirmed.reason == CELL_NOT_CONFIRMED


def test_a_cell_that_was_never_confirmed_is_asked(rig):
    bend(rig)
    rig.controller.cell.take_loaded({"bench": BENCH})
    again(rig, "bench")
    assert not silence(rig, 1.0)


def test_the_adapter_that_was_gone_meanwhile_is_asked(confirmed, qtbot):
    rig = confirmed
    rig.unplug(OSError(19, "No such device"))
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.LOST)
    rig.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())
    rig.run(3.0)
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert not in_force(rig)


# Until it is known ------------------------------------------------------------------------------


def test_nothing_moves_until_the_answers_have_come(confirmed):
    rig = confirmed
    rig.ear = HardOfHearing(rig.firmware)
    rig.firmware.feedback_stopped = True
    rig.run(1.0)
    rig.ear.mute_on.add(LIMIT_ANSWER)
    rig.firmware.feedback_stopped = False
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    rig.heard()
    for _ in range(25):
        rig.step()
        refused = rig.controller.motion.send_joints(BACK)
        assert refused.reason in {CELL_NOT_CONFIRMED, *other_reasons(rig)}
        assert rig.controller.cartesian.tool == NO_TOOL
    assert [each for each in rig.heard() if each.arbitration_id in MOTION] == []
    rig.ear.mute_on.clear()
    rig.run(1.0)
    assert in_force(rig)


def other_reasons(rig):
    """Nothing else may speak for what the cell waits for, but for the first moments."""
    return set() if rig.controller.operating_state.generation else {_why(rig)}


def _why(rig):
    return rig.controller.operating_state.cannot_move.reason


def test_a_second_silence_before_the_answers_have_come_is_no_way_around_it(confirmed):
    """Together they last longer than ten seconds."""
    rig = confirmed
    rig.ear = HardOfHearing(rig.firmware)
    rig.firmware.feedback_stopped = True
    rig.run(6.0)
    rig.ear.mute_on.update({LIMIT_ANSWER, 0x4AF})
    rig.firmware.feedback_stopped = False
    rig.run(0.3)
    rig.ear.mute_on.clear()
    assert not silence(rig, 5.0)


def test_the_operator_may_confirm_it_meanwhile(confirmed):
    rig = confirmed
    rig.ear = HardOfHearing(rig.firmware)
    rig.firmware.feedback_stopped = True
    rig.run(1.0)
    rig.ear.mute_on.add(LIMIT_ANSWER)
    rig.firmware.feedback_stopped = False
    rig.run(0.4)
    accepted(rig.controller.cell.confirm())
    assert in_force(rig)
    rig.firmware.mechanics.count_anew([angle + 5.0 for angle in BENT_DEG])
    rig.run(2.0)
    assert in_force(rig), "what was confirmed is not taken back by what comes later"
