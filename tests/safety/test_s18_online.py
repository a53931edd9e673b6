"""S18: «online» means that the arm itself is heard."""

import pytest

from armui.control.recovery_steps import Action, Kind
from armui.control.situation import LinkState

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


def test_another_hosts_questions_make_no_arm(bench, other_host):
    bench.powered = False
    bench.controller.connect_device(bench.device)
    links = set()
    for _ in range(150):
        other_host.say(*QUESTIONS)
        bench.step()
        links.add(bench.controller.situation.link)
    assert LinkState.ONLINE not in links
    assert bench.controller.situation.generation is None
    assert "online" not in bench.codes()
    assert bench.controller.state.last_feedback_s is None


def test_another_hosts_question_in_the_middle_of_an_answer_does_not_cut_it(bench, other_host):
    bench.powered = False
    bench.controller.connect_device(bench.device)
    bench.step()
    other_host.say("4AF#000000002D565331", "4AF#0000533153562E56", "4AF#00000000532D5631")
    other_host.say("4AF#0100000000000000")
    other_host.say("4AF#2E382D3500000000")  # S-V1 .8-5
    bench.step()
    assert bench.controller._connection._worker.state.firmware == "S-V1.8-5"


@pytest.mark.parametrize("joined", [b"S-V1.9-0260716", b"\0\0\0S-V1.9-0260716\0\0"])
def test_a_date_that_follows_at_once_is_no_part_of_the_version(bench, other_host, joined):
    bench.powered = False
    bench.controller.connect_device(bench.device)
    bench.step()
    padded = joined + bytes(-len(joined) % 8)
    other_host.say(*(f"4AF#{padded[at : at + 8].hex()}" for at in range(0, len(padded), 8)))
    bench.step()
    assert bench.controller._connection._worker.state.firmware == "S-V1.9-0"


def test_a_leading_arm_whose_drivers_go_on_sending_is_no_dead_end(any_bench, generation):
    from tests.company import OtherHost  # noqa: PLC0415 - the fixture is for generation 2

    bench = any_bench
    leader = OtherHost(bench)
    bench.powered = False
    bench.controller.connect_device(bench.device)
    for _ in range(100):
        leader.say(*DRIVERS, *LEADING)
        bench.step()
    assert bench.controller.situation.link is LinkState.ONLINE
    assert bench.controller.situation.teaching_input
    step = bench.controller.recovery.step
    assert (step.kind, step.action) == (Kind.TEACHING_INPUT, Action.LEAVE_TEACHING_INPUT)
    assert bench.controller.recovery.act(step) is None
    bench.powered = True  # its controller has become a motion output and tells where it is
    for _ in range(10):
        leader.say(*DRIVERS)
        bench.step()
    assert not bench.controller.situation.teaching_input
    leader.close()
