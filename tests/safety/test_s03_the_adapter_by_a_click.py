"""S3, S4: setting the adapter up holds nobody, and never cuts a moving arm off from its stop.

`up` with another bit rate, `reset` and `down` switch the interface off, if for a moment. What the
arm does without its bus is what it was told last.
"""

import sys
from dataclasses import replace

import pytest

from armui.arm.device import Device
from armui.control.link.link_state import LinkState
from armui.control.operating_state import StopState
from armui.doctor.adapter_change import AdapterChange, Done, Planned
from armui.ui.dialogs.adapter_line import AdapterLine
from tests.accepted import accepted

CAN0 = Device("socketcan", "can0", None)
SWITCHING = (("up", "can0", "500000"), ("reset", "can0"), ("down", "can0"))


class Changes:
    """A helper that a test answers; it notes what it was told."""

    def __init__(self):
        self.begun = []
        self.went = 0
        self.ended = 0
        self.on_answer = None

    def __call__(self, words, on_answer, command):
        self.begun.append(tuple(words))
        self.on_answer = on_answer
        return self

    def go(self):
        self.went += 1

    def end(self):
        self.ended += 1


def not_listening(_arguments, _tell):
    return Changes()


@pytest.fixture
def changes():
    return Changes()


@pytest.fixture
def on_can0(rig):
    """The arm, ready, on an interface of the kernel."""
    rig.device = replace(CAN0, channel=rig.channel)
    rig.ready()
    return rig


@pytest.fixture
def line(qtbot, on_can0, changes):
    line = AdapterLine(on_can0.controller, changes, not_listening, lambda: True)
    qtbot.addWidget(line)
    return line


def remedy(rig, words):
    """A verb for the interface the arm is on."""
    return (words[0], rig.channel, *words[2:])


def set_moving(rig):
    accepted(rig.controller.motion.send_joints((20.0, 0.0, 0.0, 0.0, 0.0, 0.0)))
    rig.run_until(lambda: rig.controller.operating_state.moving)


def test_under_a_moving_arm_nothing_is_switched(on_can0, line, changes):
    set_moving(on_can0)
    for words in SWITCHING:
        line.choose(remedy(on_can0, words))
        assert changes.begun == []
        assert "goes on with what it was told last" in line.text()
    other = ("reset", "can7")
    line.choose(other)  # another adapter is none of this arm's business
    assert changes.begun == [other]


def test_an_arm_that_sets_off_while_the_password_is_asked_for_is_not_cut_off(
    qapp, on_can0, line, changes
):
    line.choose(remedy(on_can0, ("reset", "can0")))
    assert len(changes.begun) == 1
    set_moving(on_can0)
    changes.on_answer(Planned())
    qapp.processEvents()
    assert (changes.went, changes.ended) == (0, 1)
    assert "goes on with what it was told last" in line.text()


def test_a_stop_that_is_not_confirmed_keeps_its_adapter(on_can0, line, changes):
    set_moving(on_can0)
    on_can0.controller.emergency_stop()
    state = on_can0.controller.operating_state
    assert (state.link, state.stop) == (LinkState.ONLINE, StopState.REQUESTED)
    line.choose(remedy(on_can0, ("reset", "can0")))
    assert changes.begun == []


def test_at_rest_and_where_the_bus_is_dead_it_may_be_reset(qapp, on_can0, line, changes):
    line.choose(remedy(on_can0, ("reset", "can0")))
    changes.on_answer(Planned())
    qapp.processEvents()
    assert changes.went == 1
    changes.on_answer(Done({"up": True}))
    qapp.processEvents()
    set_moving(on_can0)
    on_can0.powered = False  # nothing is heard any more: only the reset leads back to it
    on_can0.run_until(lambda: on_can0.controller.operating_state.link is LinkState.OFFLINE)
    line.choose(remedy(on_can0, ("reset", "can0")))
    assert len(changes.begun) == 2


@pytest.mark.skipif(sys.platform != "linux", reason="the helper is for Linux")
@pytest.mark.parametrize(
    "says", ["", "print('{\"plan\": {}}', flush=True)"], ids=["before", "after"]
)
def test_a_stop_goes_out_while_the_helper_hangs(qtbot, tmp_path, on_can0, says):
    hung = tmp_path / "pkexec"
    hung.write_text(f"#!{sys.executable} -IS\nimport time\n{says}\ntime.sleep(600)\n")
    hung.chmod(0o755)
    begun = []

    def begin(words, on_answer, _command):
        begun.append(AdapterChange(words, on_answer, [str(hung)]))
        return begun[-1]

    line = AdapterLine(on_can0.controller, begin, not_listening, lambda: True)
    qtbot.addWidget(line)
    line.choose(("reset", "can7"))
    if says:
        qtbot.waitUntil(lambda: "Under way" in line.text(), timeout=50_000)
    set_moving(on_can0)
    on_can0.heard()
    on_can0.controller.emergency_stop()
    on_can0.run_until(lambda: on_can0.controller.operating_state.stop is StopState.STOPPED)
    assert any(frame.arbitration_id == 0x150 and frame.data[0] == 1 for frame in on_can0.heard())
    line.cancel_button.click()
    assert begun[0].wait(50.0)
