"""S37: what is late, led by a hand, or moved by somebody else is never told as sinking."""

from dataclasses import replace

from armui.arm.state import ArmState, Reading
from armui.control.safety.sinking import SinkingWatch, WatchedMotion
from armui.control.safety.uncommanded_motion import MotionKind, Unheld
from armui.protocol.codes import TeachingState
from armui.ui import words
from tests.accepted import accepted
from tests.arm_rig import STEP_S
from tests.control.jogger import bend

LOWER_DEG = (10.0, 90.0, -60.0, 15.0, 40.0, 20.0)
TOLD = {MotionKind.SINKS, MotionKind.MOVES}


def kinds_while(rig, seconds):
    """What was seen of the arm in this time."""
    kinds = set()
    for _ in range(round(seconds / STEP_S)):
        rig.step()
        motion = rig.controller.operating_state.uncommanded
        kinds.add(None if motion is None else motion.kind)
    return kinds


def told(rig):
    return [code for code in rig.codes() if code.startswith("arm_")]


# Somebody moves it -------------------------------------------------------------------------------


def test_our_own_motion_down_is_none(rig):
    bend(rig)
    accepted(rig.controller.motion.send_joints(LOWER_DEG))
    assert kinds_while(rig, 2.0) == {None}
    assert rig.controller.halt_and_hold() is None
    assert kinds_while(rig, 2.0) == {None}
    assert not told(rig)


def test_another_host_that_moves_it_down_is_none(rig, other_host):
    bend(rig)
    rig.run(1.0)
    other_host.move_to(LOWER_DEG, 50)
    assert kinds_while(rig, 3.0) == {None}
    assert not told(rig)


def test_a_hand_that_leads_it_down_is_a_hand(rig):
    bend(rig)
    rig.run(1.0)
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    rig.firmware.hand_guiding.lead_to(LOWER_DEG, speed_deg_s=20.0)
    rig.run(0.5)
    motion = rig.controller.operating_state.uncommanded
    assert motion.kind is MotionKind.LED
    assert motion.down_mm > 0
    line = words.step(rig.controller.recovery.step)
    assert line.startswith(f"The arm is moved by hand, at {motion.speed_mm_s} mm/s. ")
    assert not kinds_while(rig, 3.0) & TOLD
    assert not told(rig)


def test_its_own_way_to_the_start_of_what_it_was_taught_is_its_own(rig):
    bend(rig)
    teach = rig.controller.teaching.command
    accepted(teach(TeachingState.START_RECORDING))
    rig.run(0.5)
    rig.firmware.hand_guiding.lead_to(LOWER_DEG, speed_deg_s=20.0)
    rig.run(3.0)
    accepted(teach(TeachingState.STOP_RECORDING))
    rig.run(1.0)
    accepted(teach(TeachingState.MOVE_TO_START))
    rig.run(0.5)
    motion = rig.controller.operating_state.uncommanded
    assert motion.is_danger
    assert words.step(rig.controller.recovery.step).startswith(
        "The arm moves by itself along its taught path, or to its start: "
    )
    accepted(teach(TeachingState.ABORT))  # it still comes to rest then
    causes = set()
    for _ in range(90):
        rig.step()
        shown = rig.controller.operating_state.uncommanded
        causes.add(shown and shown.cause)
    assert causes == {Unheld.OWN_REPLAY, None}


# What arrives late -------------------------------------------------------------------------------


class Feed:
    """A watch of an arm in emergency stop, fed with angles; joint 2 turns it down."""

    def __init__(self, cause=Unheld.STOPPED):
        self.now_s, self.pauses, self.cause = 100.0, 0, cause
        self.joint_deg = 50.0
        self.watch = SinkingWatch(
            lambda joints_deg: 400.0 - 5.0 * joints_deg[1],
            lambda joints_deg: (0.0, 0.0, -5.0 * joints_deg[1]),
            lambda joints_deg: -5.0 * joints_deg[1],
            lambda: "",
        )

    def hear(self, joint_deg, at_s=None, **changes):
        """An angle of joint 2, received now or at another time."""
        self.joint_deg = joint_deg
        at_s = self.now_s if at_s is None else at_s
        angles = (0.0, joint_deg, 0.0, 0.0, 0.0, 0.0)
        a, b, c, d, e, f = (Reading(angle, at_s) for angle in angles)
        state = ArmState(pauses=self.pauses, joints_deg=(a, b, c, d, e, f), last_feedback_s=at_s)
        watched = WatchedMotion(state, self.now_s, self.cause)
        self.watch.observe(replace(watched, **changes))

    def turn(self, deg_s, seconds=1.0):
        """Turn the joint evenly, heard every 10 ms; return the kinds that were seen."""
        kinds = set()
        for _ in range(round(seconds / 0.01)):
            self.now_s += 0.01
            self.hear(self.joint_deg + deg_s * 0.01)
            kinds.add(self.kind)
        return kinds

    @property
    def kind(self):
        return None if self.watch.motion is None else self.watch.motion.kind


def test_even_motion_that_is_heard_in_time_is_told():
    feed = Feed()
    feed.turn(0.0)
    assert feed.kind is None
    feed.turn(4.0)
    motion = feed.watch.motion
    assert (motion.kind, motion.speed_mm_s) == (MotionKind.SINKS, 20)
    assert 14 <= motion.down_mm <= 20
    feed.turn(0.0)
    assert feed.kind is None
    assert feed.watch.ended is not None
    whole, at_rest = feed.watch.ended
    assert at_rest
    assert (whole.down_mm, whole.turned_deg) == (20, 4.0)


def test_minutes_of_rest_later_it_comes_back():
    feed = Feed()
    feed.turn(4.0, 0.5)
    feed.turn(0.0, 120.0)
    assert feed.kind is None
    feed.turn(4.0, 0.3)
    assert feed.kind is MotionKind.SINKS


def test_an_arm_that_is_lifted_does_not_sink():
    feed = Feed()
    feed.turn(0.0)
    assert feed.turn(-4.0) == {None, MotionKind.MOVES}


def test_nothing_is_claimed_across_a_gap():
    """The arm stands elsewhere after 0.3 s without a frame: it stands, and that is measured."""
    feed = Feed()
    feed.turn(0.0)
    feed.now_s, feed.pauses = feed.now_s + 0.3, feed.pauses + 1
    feed.hear(feed.joint_deg + 5.0)
    assert feed.kind not in TOLD
    assert not feed.turn(0.0) & TOLD
    assert feed.kind is None


def test_what_was_told_before_a_gap_is_told_on_and_counted_on():
    feed = Feed()
    feed.turn(0.0)
    feed.turn(4.0, 0.5)
    before = feed.watch.motion.down_mm
    feed.now_s, feed.pauses = feed.now_s + 0.3, feed.pauses + 1
    feed.hear(feed.joint_deg + 1.2)
    assert feed.kind is MotionKind.SINKS
    feed.turn(4.0, 0.5)
    assert feed.watch.motion.down_mm >= before + 14


def test_old_angles_that_come_again_and_again_move_nothing():
    feed = Feed()
    feed.turn(0.0)
    heard_s = feed.now_s
    for _ in range(90):
        feed.now_s += 0.01
        feed.hear(feed.joint_deg + 1.0, at_s=heard_s)
        assert feed.kind is None


def test_angles_counted_from_another_zero_are_no_motion():
    feed = Feed()
    feed.turn(0.0)
    feed.now_s += 0.01
    feed.hear(0.0)
    assert not feed.turn(0.0) & TOLD
    feed.turn(4.0, 0.5)
    feed.now_s += 0.01
    feed.hear(feed.joint_deg + 50.0)
    feed.turn(4.0, 0.5)
    assert 15 <= feed.watch.motion.down_mm <= 20


def test_a_powered_arm_may_sag_by_half_a_degree():
    feed = Feed(Unheld.NOT_TOLD)
    feed.turn(0.0)
    feed.turn(2.0, 0.25)
    assert feed.kind is None
    feed.turn(0.0)
    feed.turn(2.0, 0.5)
    assert feed.kind is MotionKind.SINKS


def test_where_a_hand_may_lead_both_are_said():
    """In drag teaching, with no recording under way: nobody is known to hold the arm."""
    feed = Feed(Unheld.DRAG_TEACHING)
    feed.turn(0.0)
    assert MotionKind.SINKS not in feed.turn(4.0)
    assert feed.watch.motion is not None
    said = words.uncommanded_motion(feed.watch.motion)
    assert said.startswith("The arm moves, by a hand or its own weight: ")
    assert f"{feed.watch.motion.down_mm} mm lower" in said


def test_whether_it_rests_is_not_known_before_it_is_measured():
    feed = Feed()
    feed.turn(0.0, 0.2)
    assert feed.kind is MotionKind.UNMEASURED
    feed.turn(0.0, 0.5)
    assert feed.kind is None
