"""The operating state is read without a look at the arm; what sends a motion looks for itself."""

from armui.control.authority import Authority
from armui.control.devices.zeroing import why_not_zero
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.other_command import OTHER_HOST
from tests.company import OtherHost
from tests.sim.talk import target


def test_reading_looks_at_nothing_and_tells_nobody(rig, monkeypatch):
    rig.ready()
    seen: list[object] = []
    told: list[object] = []
    rig.controller.operating_state_changed.connect(told.append)
    monkeypatch.setattr(Authority, "observe", lambda _self, observation: seen.append(observation))
    rig.time_s += 5.0  # the arm is silent by now
    before = rig.controller.operating_state
    assert rig.controller.operating_state is before
    assert rig.controller.recovery.why_not(rig.controller.recovery.step) is None
    assert rig.controller.cartesian.why_unknown() is None
    assert why_not_zero(before) is None
    assert (seen, told) == ([], [])


def test_a_tick_looks_once(rig, monkeypatch):
    rig.ready()
    seen, observe = [], Authority.observe

    def noted(authority, observation):
        seen.append(observation)
        observe(authority, observation)

    monkeypatch.setattr(Authority, "observe", noted)
    rig.controller.tick()
    assert len(seen) == 1


def test_a_motion_is_judged_by_what_was_heard_since_the_last_tick(rig):
    rig.ready()
    other = OtherHost(rig)
    rig.heard()
    rig.controller._timer.stop()  # it may be due while the bus thread is waited for
    operating_state = rig.controller.operating_state
    other.say(*target(10, 0, 0, 0, 0, 0))
    rig._settle()  # heard by the bus thread; no tick has passed
    assert rig.controller.operating_state is operating_state
    assert operating_state.cannot_move is None
    context = rig.controller._context
    assert context.why_no_motion().reason == OTHER_HOST
    assert (
        rig.controller.operating_state is operating_state
    )  # the interlocks tell nobody in mid-command
    assert rig.controller.motion.jog(1, 1.0).reason == OTHER_HOST
    assert rig.controller.operating_state.cannot_move.reason == OTHER_HOST


def test_a_command_of_the_operator_is_judged_by_the_time_it_is_given(rig):
    rig.ready()
    assert rig.controller.operating_state.cannot_move is None
    rig.heard()
    rig.time_s += 5.0
    assert rig.controller.motion.jog(1, 1.0).reason == FEEDBACK_SILENT
    assert not rig.heard()
