"""When a motion of ours is seen not to have been taken by the arm."""

from __future__ import annotations

from dataclasses import replace

import pytest

from armui.arm.state import ArmState, Reading
from armui.control.motion.motion_command import CommandKind, End, MotionCommand
from armui.control.safety.command_acknowledgement import AcknowledgementMonitor
from armui.protocol.codes import ArmStatusCode
from tests.control.heard_arm import HERE, THERE, status
from tests.moments import now
from tests.ui.arm_states import heard_six

BEGIN_S = 0.25
STEP_S = 0.0625
AT = (300.0, 0.0, 250.0, 0.0, 90.0, 0.0)
JOINTS = MotionCommand(1, CommandKind.JOINTS, BEGIN_S, 20, THERE)
POSE = MotionCommand(1, CommandKind.POSE, BEGIN_S, 20, leads_away=True)
JOG = MotionCommand(1, CommandKind.JOG, BEGIN_S, 20, THERE)
ALL = pytest.mark.parametrize("command", [JOINTS, POSE, JOG], ids=["joints", "pose", "jog"])


class Watched:
    """An arm that is looked at every sixteenth of a second."""

    def __init__(self) -> None:
        self.watch = AcknowledgementMonitor()
        self.now_s = BEGIN_S
        self.joints_deg: tuple[float, ...] | None = HERE
        self.in_time_since_s = 0.0
        self.pose: tuple[float, ...] | None = AT
        self.status = status()

    def look(self, command: MotionCommand | None, ended: End | None = None) -> bool:
        heard = (None,) * 6 if self.joints_deg is None else heard_six(self.joints_deg, self.now_s)
        state = ArmState(
            status=Reading(self.status, self.now_s),
            joints_deg=heard,
            pose=(None,) * 6 if self.pose is None else heard_six(self.pose, self.now_s),
            in_time_since_s=self.in_time_since_s,
        )
        seen = self.watch.observe(command, ended, state, self.now_s)
        self.now_s += STEP_S
        return seen

    def looks(self, command: MotionCommand | None, seconds: float) -> int:
        return sum(self.look(command) for _ in range(round(seconds / STEP_S)))


@pytest.fixture
def arm():
    return Watched()


def turned(by_deg):
    return (HERE[0] + by_deg, *HERE[1:])


@ALL
def test_an_arm_that_stands_for_a_second_has_not_taken_it_and_that_is_seen_once(arm, command):
    assert arm.looks(command, 1.0) == 0
    assert arm.look(command)
    assert arm.looks(command, 5.0) == 0


@ALL
@pytest.mark.parametrize(("by_deg", "seen"), [(0.19, 1), (0.21, 0)])
def test_a_fifth_of_a_degree_shows_that_it_has(arm, command, by_deg, seen):
    arm.look(command)
    arm.joints_deg = turned(-by_deg)
    assert arm.looks(command, 0.5) == 0
    arm.joints_deg = HERE
    assert arm.looks(command, 5.0) == seen


@pytest.mark.parametrize(
    ("pose", "seen"),
    [
        ((300.0, 0.0, 250.4, 0.0, 90.0, 0.0), 1),
        ((300.0, 0.0, 250.6, 0.0, 90.0, 0.0), 0),
        ((300.0, 0.0, 250.0, 0.0, 89.9, 0.0), 1),
        ((300.0, 0.0, 250.0, 0.0, 89.7, 0.0), 0),
    ],
)
def test_a_step_of_the_tool_shows_by_the_flange_where_the_joints_hardly_turn(arm, pose, seen):
    arm.look(POSE)
    arm.joints_deg, arm.pose = turned(0.1), pose
    assert arm.looks(POSE, 5.0) == seen


def test_a_motion_by_joints_does_not_show_by_the_flange(arm):
    arm.look(JOINTS)
    arm.pose = (320.0, 0.0, 250.0, 0.0, 90.0, 0.0)
    assert arm.looks(JOINTS, 5.0) == 1


@ALL
def test_an_arm_that_says_what_is_wrong_has_taken_it(arm, command):
    arm.look(command)
    arm.status = status(arm_status=ArmStatusCode.NO_SOLUTION)
    arm.look(command)
    arm.status = status()
    assert arm.looks(command, 5.0) == 0


@ALL
def test_an_arm_that_leaves_the_mode_by_itself_has_not_taken_it(arm, command):
    arm.look(command)
    assert arm.look(None, End.OTHER_MODE)
    assert not arm.look(None, End.OTHER_MODE)


@pytest.mark.parametrize(("by_deg", "seen"), [(0.49, False), (0.51, True)])
def test_one_that_stands_elsewhere_has_not(arm, by_deg, seen):
    command = replace(JOINTS, joints_deg=turned(by_deg))
    arm.look(command)
    assert arm.look(None, End.MOVED_AWAY) is seen


@pytest.mark.parametrize(
    "end", [each for each in End if each not in {End.OTHER_MODE, End.MOVED_AWAY}], ids=str
)
def test_nothing_is_seen_of_what_somebody_has_ended(arm, end):
    arm.look(JOINTS)
    assert not arm.look(None, end)
    assert not arm.look(None, End.OTHER_MODE)


@pytest.mark.parametrize("kind", [CommandKind.RUN, CommandKind.REPLAY])
def test_runs_say_it_themselves(arm, kind):
    assert arm.looks(replace(JOINTS, kind=kind), 5.0) == 0
    assert not arm.look(None, End.OTHER_MODE)


def test_a_motion_that_leads_nowhere_shows_nothing(arm):
    assert arm.looks(replace(JOINTS, joints_deg=HERE), 5.0) == 0
    assert arm.looks(replace(POSE, number=2, leads_away=False), 5.0) == 0
    assert not arm.look(None, End.MOVED_AWAY)


def test_a_pose_counts_as_it_was_sent_whatever_angles_it_is_given(arm):
    assert arm.looks(POSE, 0.5) == 0
    assert arm.looks(replace(POSE, joints_deg=HERE), 1.0) == 1


def test_the_time_runs_from_when_the_frames_were_out(arm):
    assert arm.looks(JOINTS, 0.5) == 0
    late = replace(JOINTS, sent_s=arm.now_s)
    assert arm.looks(late, 1.0) == 0
    assert arm.look(late)


def test_the_setpoints_of_a_jog_do_not_put_it_off(arm):
    assert not any(arm.look(replace(JOG, sent_s=arm.now_s)) for _ in range(16))
    assert arm.look(replace(JOG, sent_s=arm.now_s))


def test_a_jog_that_has_not_got_far_is_waited_for(arm):
    slow = replace(JOG, joints_deg=turned(0.3))
    assert arm.looks(slow, 2.0) == 0
    assert arm.look(replace(slow, joints_deg=turned(0.6)))


def test_each_command_is_followed_anew(arm):
    assert arm.looks(JOINTS, 2.0) == 1
    assert arm.looks(replace(JOINTS, number=2), 2.0) == 1
    arm.look(replace(JOINTS, number=3))
    arm.joints_deg = THERE
    assert arm.looks(replace(JOINTS, number=3), 2.0) == 0
    assert arm.looks(replace(JOINTS, number=4, joints_deg=HERE), 2.0) == 1


def test_nothing_is_seen_where_the_angles_are_not_heard(arm):
    arm.joints_deg = None
    assert arm.looks(JOINTS, 2.0) == 0
    arm.joints_deg = HERE
    assert arm.looks(replace(JOINTS, number=2), 0.5) == 0
    arm.joints_deg = None
    arm.look(replace(JOINTS, number=2))
    arm.joints_deg = HERE
    assert arm.looks(replace(JOINTS, number=2), 1.0) == 1


def test_what_is_forgotten_is_not_taken_up_again(arm):
    arm.look(JOINTS)
    arm.watch.reset()
    assert arm.looks(JOINTS, 2.0) == 0


def test_the_setpoint_a_jog_has_come_to_counts_when_it_ends(arm):
    arm.look(replace(JOG, joints_deg=turned(0.3)))
    arm.look(replace(JOG, joints_deg=turned(0.6)))
    assert arm.look(None, End.MOVED_AWAY)


@pytest.mark.parametrize("command", [JOINTS, replace(POSE, leads_away=False)])
def test_it_waits_for_a_motion_that_leads_away_until_it_shows(arm, command):
    leads = command is JOINTS
    assert now(arm.watch.waits) is False
    arm.look(command)
    assert now(arm.watch.waits) is leads
    arm.joints_deg = turned(1.0)
    arm.look(command)
    assert arm.watch.waits is False


def test_a_flange_first_heard_on_the_way_shows_nothing(arm):
    """Where it stood at sending is not known, and no joint has turned."""
    arm.pose = None
    arm.look(POSE)
    arm.pose = AT
    assert arm.looks(POSE, 5.0) == 1


@pytest.mark.parametrize(("silent_s", "after_s"), [(0.5, 0.5), (0.75, 0.75)])
def test_angles_that_stayed_out_are_waited_for(arm, silent_s, after_s):
    """They must have arrived for the last half second before anything is held against the arm."""
    arm.looks(JOINTS, 0.5)
    silent = arm.joints_deg
    arm.joints_deg = None
    assert arm.looks(JOINTS, silent_s) == 0
    arm.joints_deg, arm.in_time_since_s = silent, arm.now_s
    assert arm.looks(JOINTS, 0.5) == 0
    assert arm.looks(JOINTS, after_s) == 1
