"""S18: «online» means that the arm itself is heard."""

import pytest

from armui.arm.tracker import Tracker
from armui.control.link.link_state import LinkState
from armui.control.safety.recovery_steps import Action, StepKind
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.company import OtherHost

QUESTIONS = (
    "4AF#0100000000000000",
    "4AF#01",
    "472#0101000000000000",
    "477#0100000000000000",
    "477#0200000000000000",
)
DRIVERS = [f"25{joint}#0000000000000000" for joint in range(1, 7)] + [
    f"26{joint}#00F0001919000000" for joint in range(1, 7)
]
LEADING = ("155#0000000000000000", "156#0000000000000000", "157#0000000000000000")


def test_another_hosts_questions_make_no_arm(rig, other_host):
    rig.powered = False
    rig.controller.connect_device(rig.device)
    links = set()
    for _ in range(150):
        other_host.say(*QUESTIONS)
        rig.step()
        links.add(rig.controller.operating_state.link)
    assert LinkState.ONLINE not in links
    assert rig.controller.operating_state.generation is None
    assert "online" not in rig.codes()
    assert rig.controller.state.last_feedback_s is None


def version_heard(*payloads):
    """What a tracker makes of 0x4AF frames."""
    codec = Codec(Generation.TWO)
    tracker = Tracker(codec)
    for payload in payloads:
        tracker.update(codec.decode(Frame(0x4AF, payload)), 1.0)
    return tracker.snapshot().firmware


def test_another_hosts_question_in_the_middle_of_an_answer_does_not_cut_it():
    question = bytes.fromhex("01 00 00 00 00 00 00 00")
    assert version_heard(b"\0\0\0\0S-V1", question, b".8-5\0\0\0\0") == "S-V1.8-5"
    assert version_heard(b"\0\0\0\0S-V1", b"\x01", b".8-5\0\0\0\0") == "S-V1.8-5"


@pytest.mark.parametrize("text", [b"S-V1.9-0260716", b"\0\0\0S-V1.9-0260716\0\0"])
def test_a_date_that_follows_at_once_is_no_part_of_the_version(text):
    padded = text + bytes(-len(text) % 8)
    payloads = [padded[at : at + 8] for at in range(0, len(padded), 8)]
    assert version_heard(*payloads) == "S-V1.9-0"


def test_an_answer_that_lost_a_frame_gives_no_version_and_the_next_one_does():
    whole = (b"\0\0\0\0S-V1", b".8-5\0\0\0\0")
    assert version_heard(whole[0], b"25\0\0\0\0\0\0") is None
    assert version_heard(whole[0], b"25\0\0\0\0\0\0", *whole) == "S-V1.8-5"


def test_a_leading_arm_whose_drivers_go_on_sending_is_no_dead_end(any_rig, generation):
    rig = any_rig
    leader = OtherHost(rig)
    rig.powered = False
    rig.controller.connect_device(rig.device)
    for _ in range(100):
        leader.say(*DRIVERS, *LEADING)
        rig.step()
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert rig.controller.operating_state.teaching_input
    step = rig.controller.recovery.step
    assert (step.kind, step.action) == (StepKind.TEACHING_INPUT, Action.LEAVE_TEACHING_INPUT)
    assert rig.controller.recovery.act(step) is None
    rig.powered = True  # its controller has become a motion output and tells where it is
    for _ in range(10):
        leader.say(*DRIVERS)
        rig.step()
    assert not rig.controller.operating_state.teaching_input
    leader.close()
