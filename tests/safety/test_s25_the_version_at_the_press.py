"""S25, S15: what is dangerous with another version is done by the version named at the press."""

import can
import pytest

from armui.control.link.link_state import LinkState
from armui.control.safety.mode_exit import VERSION_UNANSWERED
from armui.control.safety.recovery_steps import Action
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.sim.parameters.parameter_server import identity_text
from tests.sim.talk import frame, ready, tell
from tests.sim.test_direct_control import STIFF, hold

A = (10.0, 45.0, -45.0, 0.0, 20.0, 0.0)
MIT = "151#010600AD00000000"
OLD_MIT = "151#010400AD00000000"
NEW, OLD = "S-V1.8-9", "S-V1.8-2"


def in_mit(version, joints_deg=A):
    """An arm of this version that another host holds in MIT."""
    arm = ready(joints_deg=joints_deg, version=version)
    arm.step(0.5)
    tell(arm, MIT if version == NEW else OLD_MIT, *hold(joints_deg, **STIFF))
    arm.step(0.5)
    assert arm.joints_deg == pytest.approx(joints_deg, abs=1.0)
    return arm


def put(rig, arm):
    """Put an arm in the place of the one that is connected, without a pause."""
    rig.firmware = arm
    rig.node = Node(arm, rig._arm_bus)


@pytest.fixture
def held(rig, other_host):
    """An arm with S-V1.8-9 that another host has left in MIT; «leave the mode» is offered."""
    rig.lie(A, version=NEW)
    rig.connect()
    rig.controller.motion.set_speed_percent(60)
    rig.run(0.1)  # the arm before has heard it
    put(rig, in_mit(NEW))
    other_host.say(MIT, *hold(A, **STIFF))
    rig.run(3.0)
    assert rig.controller.recovery.step.action is Action.LEAVE_MODE
    rig.heard()
    return rig


def press(rig):
    return rig.controller.recovery.act(rig.controller.recovery.step)


def mode_words(rig):
    return [each for each in rig.heard() if each.arbitration_id == 0x151]


def reasons(rig):
    return [event.params["reason"].reason for event in rig.events if event.params.get("reason")]


def version_frames(text, model=PiperModel.PIPER):
    whole = identity_text(text, model)
    return [Frame(0x4AF, whole[at : at + 8].ljust(8, b"\0")) for at in range(0, len(whole), 8)]


def answer(rig, frames):
    """Have the arm answer the question for its version so, each time."""
    asked = []

    def on_question(_signals):
        asked.append(1)
        return list(frames)

    rig.firmware._handlers["FirmwareVersion"] = on_question
    return asked


def test_the_arm_is_left_by_its_own_word(held):
    assert press(held) is None
    held.run(0.5)
    assert frame("151#01013C0000000000") in mode_words(held)
    assert held.firmware.joints_deg == pytest.approx(A, abs=1.0)


@pytest.mark.parametrize("paused_s", [0.0, 0.06, 0.3])
def test_an_arm_put_in_its_place_does_not_fall(held, paused_s):
    other = in_mit(OLD)
    held.powered = False
    held.run(paused_s)
    held.powered = True
    put(held, other)
    press(held)
    held.run(2.0)
    assert mode_words(held) == []
    assert other.joints_deg == pytest.approx(A, abs=1.0)


def test_after_the_exchange_nothing_of_the_old_arm_counts(held):
    put(held, in_mit(OLD))
    press(held)
    held.run(3.0)
    assert held.controller.state.firmware == OLD
    assert held.controller.recovery.step.action is Action.RESET


def test_a_short_pause_is_enough_to_ask_who_it_is(held):
    """Nobody presses anything; the other version is known within a second."""
    other = in_mit(OLD)
    held.powered = False
    held.run(0.2)
    held.powered = True
    put(held, other)
    held.run(1.0)
    held.run_until(lambda: held.controller.operating_state.link is LinkState.ONLINE)
    held.run_until(lambda: held.controller.state.firmware == OLD, 2.0)


def test_another_arm_with_the_same_version_is_known_by_its_angles(rig):
    rig.lie(A, version=NEW)
    rig.ready()
    arms = rig.controller._connection.mark.arms
    rig.powered = False
    rig.run(0.2)
    rig.powered = True
    put(rig, Firmware(Generation.TWO, joints_deg=(-120.0, 45.0, -45.0, 0.0, 20.0, 0.0)))
    rig.run(1.0)
    assert rig.controller._connection.mark.arms == arms + 1


def test_a_pause_alone_makes_no_other_arm_of_it(rig):
    rig.lie(A, version=NEW)
    rig.ready()
    arms = rig.controller._connection.mark.arms
    rig.powered = False
    rig.run(0.3)
    rig.powered = True
    rig.run(2.0)
    assert rig.controller._connection.mark.arms == arms
    assert rig.controller.operating_state.cannot_move is None


def test_a_lost_answer_is_asked_for_again(held):
    whole = version_frames(NEW)
    asked = []

    def on_question(_signals):
        asked.append(1)
        return [] if len(asked) == 1 else whole

    held.firmware._handlers["FirmwareVersion"] = on_question
    assert press(held) is None
    held.run(0.9)
    assert len(asked) == 2
    assert frame("151#01013C0000000000") in mode_words(held)


def test_without_an_answer_nothing_is_sent(held):
    asked = answer(held, [])
    assert press(held) is None
    held.run(3.0)
    assert len(asked) == 3
    assert mode_words(held) == []
    assert VERSION_UNANSWERED in reasons(held)


@pytest.mark.parametrize("lost", range(11))
def test_a_torn_answer_is_no_other_version(held, lost):
    """Whatever frame is missing: the right version, or nothing."""
    whole = version_frames(NEW)
    answer(held, whole[:lost] + whole[lost + 1 :])
    press(held)
    held.run(2.0)
    assert held.controller.state.firmware == NEW
    assert held.firmware.joints_deg == pytest.approx(A, abs=1.0)


def test_an_answer_that_comes_too_late_moves_nothing(held):
    answer(held, [])
    assert press(held) is None
    held.run(1.1)
    tell(held.firmware)
    held.firmware._handlers.pop("FirmwareVersion")
    late = version_frames(NEW)
    for each in late:
        held.node._bus.send(message(each))
    held.run(1.0)
    assert mode_words(held) == []


def test_two_arms_that_answer_move_nothing(held):
    answer(held, version_frames(NEW) + version_frames(OLD))
    press(held)
    held.run(2.0)
    assert mode_words(held) == []


def test_answers_of_two_arms_that_are_mixed_move_nothing(held):
    """Frame by frame in turn: S-V1 of the one and .8-9 of the other stand beside one another."""
    pairs = zip(version_frames(NEW), version_frames(OLD), strict=True)
    answer(held, [each for pair in pairs for each in reversed(pair)])
    press(held)
    held.run(2.0)
    assert mode_words(held) == []


def test_a_second_host_that_asks_too_is_no_harm(held, other_host):
    assert press(held) is None
    other_host.say("4AF#0100000000000000")
    held.run(0.9)
    assert frame("151#01013C0000000000") in mode_words(held)
    assert held.firmware.joints_deg == pytest.approx(A, abs=1.0)


def test_an_answer_of_before_the_press_does_not_count(held, other_host):
    """A second host has asked the arm of before; the one in its place answers nothing."""
    other_host.say("4AF#0100000000000000")
    held.step()
    other = in_mit(OLD)
    other._handlers["FirmwareVersion"] = lambda _signals: []
    put(held, other)
    press(held)
    held.run(2.0)
    assert mode_words(held) == []
    assert other.joints_deg == pytest.approx(A, abs=1.0)


@pytest.mark.parametrize("end", ["emergency_stop", "halt_and_hold"])
def test_a_stop_or_a_halt_meanwhile_ends_it(held, end):
    answer(held, [])
    assert press(held) is None
    held.step()
    getattr(held.controller, end)()
    held.firmware._handlers["FirmwareVersion"] = lambda _signals: version_frames(NEW)
    held.run(2.0)
    assert mode_words(held) == []


def message(said):
    return can.Message(arbitration_id=said.arbitration_id, data=said.data, is_extended_id=False)
