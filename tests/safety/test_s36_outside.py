"""S36: a joint outside its limits only comes back, on every way; what is outside is named.

A real arm lies with J2 and J3 two degrees outside when it is switched on, and its firmware refuses
every target in which any joint is outside. The judge is the simulated arm's true angles.
"""

import re
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

from armui.arm.limits import JOINTS_OUTSIDE
from armui.arm.refusal import Refusal
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.operations.started import Started
from armui.control.run.replay import Replay
from armui.control.safety.recovery_steps import StepKind
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode, TrajectoryCommand
from armui.protocol.generation import PiperModel
from armui.trajectory.samples.recording import Recording
from armui.ui import words
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, hold
from tests.family import FACTORY_LIMITS, ranges
from tests.safety.inline_rig import inline_rig
from tests.safety.watched_arm import settle, told

REST_DEG = (0.0, -1.999, 1.971, -1.412, 22.110, -2.608)
"""How a real arm lies when it is switched on."""
NOISE_DEG = 0.05
INSIDE_DEG = 0.5
SLOW_PERCENT = 10
CLEAR_J5_DEG = 15.0
"""From here on hand and base are apart."""
LOW_DEG, HIGH_DEG = (np.array(each) for each in ranges(PiperModel.PIPER))


@pytest.fixture
def rig(qapp, request):
    with inline_rig(request.node.nodeid) as rig:
        yield rig


def outside_deg(joints_deg):
    """How far each joint is outside its limits."""
    return np.maximum(np.maximum(LOW_DEG - joints_deg, joints_deg - HIGH_DEG), 0.0)


class OutsideWatch:
    """Looks at each step whether a joint is further outside than it has been.

    Attributes:
        furthest_deg: The most by which each joint came further out than at the beginning.
        speeds_deg_s: The fastest of each joint.
        targets_deg: The targets that the arm accepted, in order.
    """

    def __init__(self, rig):
        self._rig = rig
        self._first = outside_deg(np.array(rig.firmware.true_joints_deg))
        self.furthest_deg = np.zeros(6)
        self.speeds_deg_s = np.zeros(6)
        self.targets_deg = [rig.firmware.targets_deg]
        rig.company.append(self)

    def step(self, dt_s):
        firmware = self._rig.firmware
        out = outside_deg(np.array(firmware.true_joints_deg)) - self._first
        self.furthest_deg = np.maximum(self.furthest_deg, out)
        speeds = np.abs(firmware.mechanics.speeds_deg_s)
        self.speeds_deg_s = np.maximum(self.speeds_deg_s, speeds)
        if firmware.targets_deg != self.targets_deg[-1]:
            self.targets_deg.append(firmware.targets_deg)


def lying(rig, joints_deg):
    """Switch an arm on that lies so, and enable it."""
    rig.lie(joints_deg)
    rig.connect()
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: all(rig.controller.operating_state.enabled))
    rig.run(0.5)
    rig.controller.motion.set_speed_percent(50)
    return OutsideWatch(rig)


def at(**joints):
    """A comfortable pose, but for some joints."""
    return tuple(joints.get(f"j{n}", angle) for n, angle in enumerate(BENT_DEG, start=1))


@pytest.fixture
def resting(rig):
    rig.watch = lying(rig, REST_DEG)
    return rig


def pose(rig, mode):
    x, y, z, *turn = rig.controller.cartesian.tool_pose(rig.controller.state)
    return rig.controller.cartesian.move((x + 5.0, y, z + 5.0, *turn), mode)


def step_joint(controller, *, joint, way):
    return controller.motion.jog(joint, way)


PRESSES: dict[str, Callable[..., Any]] = {
    **{
        f"step J{joint} {way:+d}": partial(step_joint, joint=joint, way=way)
        for joint in range(1, 7)
        for way in (1, -1)
    },
    "tool step": lambda c: c.cartesian.step(2, 5.0, JogFrame.BASE),
    "typed where it lies": lambda c: c.motion.send_joints(REST_DEG),
    "typed further out": lambda c: c.motion.send_joints((0.0, -3.0, 3.0, 0.0, 20.0, 0.0)),
    "typed with one still outside": lambda c: c.motion.send_joints((0, 5.0, 2.0, 0, 20.0, 0)),
    "typed inside": lambda c: c.motion.send_joints((0.0, 5.0, -5.0, 0.0, 15.0, 0.0)),
    "home": lambda c: c.motion.go_home(),
}


@pytest.mark.parametrize("name", PRESSES)
def test_no_press_leads_further_out_of_the_rest_pose(resting, name):
    settle(resting, PRESSES[name](resting.controller))
    resting.run(1.0)
    assert resting.watch.furthest_deg.max() <= NOISE_DEG


@pytest.mark.parametrize("mode", [MoveMode.MOVE_P, MoveMode.MOVE_L])
def test_no_pose_leads_further_out_of_the_rest_pose(resting, mode):
    settle(resting, pose(resting, mode))
    resting.run(1.0)
    assert resting.watch.furthest_deg.max() <= NOISE_DEG


JOGS = [JointJog(joint, way) for joint in range(1, 7) for way in (1, -1)]


def ended(rig):
    """Why the last jog ended, or was not begun."""
    told_last = [each for each in rig.events if each.code in {"jog_ended", "refused"}]
    return told_last[-1].params["reason"] if told_last else None


@pytest.mark.parametrize("jog", [*JOGS, ToolJog(2, 1, JogFrame.BASE)], ids=str)
def test_no_held_jog_leads_further_out_of_the_rest_pose(resting, jog):
    resting.controller.jogging.start(jog)
    hold(resting, 1.0)
    resting.controller.jogging.stop()
    hold(resting, 0.3)
    assert resting.watch.furthest_deg.max() <= NOISE_DEG


def names_what_is_outside(refusal, *joints):
    """Whether a sentence names these joints, and no bound that is not theirs."""
    sentence = words.refusal(told(refusal))
    wrong = {
        f"{bound:g}"
        for joint in joints
        for bound in (LOW_DEG[joint - 1], HIGH_DEG[joint - 1])
        if bound
    } - {f"{nearest_bound(joint):g}" for joint in joints}
    figures = {each.replace("−", "-") for each in re.findall(r"[-−]?\d+(?:\.\d+)?", sentence)}
    return all(f"J{joint}" in sentence for joint in joints) and not wrong & figures


def nearest_bound(joint):
    return OUTSIDE_BOUNDS[joint]


OUTSIDE_BOUNDS = {1: 150.0, 2: 0.0, 3: 0.0, 4: 100.0, 6: -120.0}
"""Which limit each joint is beyond in these tests."""


@pytest.mark.parametrize(("joint", "way"), [(1, 5.0), (4, -3.0), (6, 2.0), (5, -2.0)])
def test_another_joints_step_names_what_is_outside(resting, joint, way):
    answer = resting.controller.motion.jog(joint, way)
    assert names_what_is_outside(answer, 2, 3)


@pytest.mark.parametrize("joint", [1, 4, 5, 6])
def test_another_joints_held_jog_names_what_is_outside(resting, joint):
    answer = resting.controller.jogging.start(JointJog(joint, 1))
    hold(resting, 1.0)
    assert names_what_is_outside(answer if isinstance(answer, Refusal) else ended(resting), 2, 3)


def test_ready_is_not_said_while_nothing_can_be_done(resting):
    step = resting.controller.recovery.step
    assert step.kind is not StepKind.READY
    sentence = words.step(step)
    assert "J2" in sentence
    assert "J3" in sentence


def test_inside_ready_is_said(rig):
    lying(rig, BENT_DEG)
    assert rig.controller.recovery.step.kind is StepKind.READY


# One joint alone outside ------------------------------------------------------------------------

ALONE = {
    "J1": (1, at(j1=152.0), -1.0),
    "J2": (2, at(j2=-2.0), 1.0),
    "J3": (3, at(j3=1.9, j5=0.0), -1.0),  # at 40° the hand would lie in the base
    "J4": (4, at(j4=101.5), -1.0),
    "J6": (6, at(j6=-121.6), 1.0),
}


@pytest.mark.parametrize("name", ALONE)
def test_a_joint_alone_outside_is_stepped_back_to_its_limit_at_least(rig, name):
    joint, lies_deg, way = ALONE[name]
    watch = lying(rig, lies_deg)
    assert settle(rig, rig.controller.motion.jog(joint, way))
    angle = rig.firmware.true_joints_deg[joint - 1]
    assert outside_deg(np.array(rig.firmware.true_joints_deg)).max() <= NOISE_DEG
    assert abs(angle - lies_deg[joint - 1]) <= 3.0
    assert watch.furthest_deg.max() <= NOISE_DEG


@pytest.mark.parametrize("name", ["J1", "J2", "J6"])
def test_a_joint_alone_outside_is_jogged_back(rig, name):
    joint, lies_deg, way = ALONE[name]
    watch = lying(rig, lies_deg)
    assert isinstance(rig.controller.jogging.start(JointJog(joint, round(way))), Started)
    hold(rig, 1.5)
    rig.controller.jogging.stop()
    hold(rig, 0.3)
    assert outside_deg(np.array(rig.firmware.true_joints_deg)).max() <= NOISE_DEG
    assert watch.furthest_deg.max() <= NOISE_DEG


@pytest.mark.parametrize("name", ALONE)
def test_a_joint_alone_outside_is_not_stepped_further(rig, name):
    joint, lies_deg, way = ALONE[name]
    watch = lying(rig, lies_deg)
    told(rig.controller.motion.jog(joint, -way))
    rig.controller.jogging.start(JointJog(joint, -round(way)))
    hold(rig, 0.8)
    rig.controller.jogging.stop()
    hold(rig, 0.3)
    assert watch.furthest_deg.max() <= NOISE_DEG


@pytest.mark.parametrize(("name", "other"), [("J1", 4), ("J4", 1), ("J6", 2)])
def test_a_step_of_another_joint_names_the_one_that_is_outside(rig, name, other):
    joint, lies_deg, _ = ALONE[name]
    lying(rig, lies_deg)
    answer = rig.controller.motion.jog(other, 3.0)
    sentence = words.refusal(told(answer))
    assert f"J{joint}" in sentence
    assert f"J{other}" not in sentence


@pytest.mark.parametrize("name", ALONE)
def test_a_tool_step_names_what_is_outside(rig, name):
    """The arm takes no line that begins outside, wherever it ends."""
    lying(rig, ALONE[name][1])
    for axis, amount in ((0, -20.0), (1, 20.0), (2, 20.0)):
        answer = rig.controller.cartesian.step(axis, amount, JogFrame.BASE)
        assert told(answer).reason == JOINTS_OUTSIDE
        assert name in words.refusal(answer)


def test_a_replay_begins_with_the_way_inside(resting):
    samples = np.linspace((0.0, 5.0, -5.0, 0.0, 15.0, 0.0), (0.0, 20.0, -20.0, 0.0, 15.0, 0.0), 201)
    times = np.linspace(0.0, 4.0, 201)[:, None]
    recording = Recording("r", samples=np.hstack((times, samples, np.full((201, 1), np.nan))))
    accepted(resting.controller.replayer.start(Replay(recording)))
    resting.run_until(lambda: not resting.controller.replayer.running, 60.0)
    assert resting.firmware.true_joints_deg == pytest.approx(samples[-1], abs=0.2)
    assert resting.watch.furthest_deg.max() <= NOISE_DEG
    first, *_ = resting.watch.targets_deg[1:]
    assert first[1:3] == pytest.approx((INSIDE_DEG, -INSIDE_DEG), abs=0.01)
    assert "run_from_outside" in {each.code for each in resting.events}


@pytest.mark.parametrize("beyond_deg", [0.1, 0.4])
def test_sag_beyond_a_limit_is_sent_as_the_limit(rig, beyond_deg):
    """The joint hangs a little out; another one's step is taken and does not bring it back."""
    watch = lying(rig, at(j4=100.0 + beyond_deg))
    assert settle(rig, rig.controller.motion.jog(6, 2.0))
    assert rig.firmware.targets_deg[3] == pytest.approx(FACTORY_LIMITS[3].max_deg, abs=1e-3)
    assert rig.firmware.joints_deg[5] == pytest.approx(BENT_DEG[5] + 2.0, abs=0.1)
    assert watch.furthest_deg.max() <= NOISE_DEG


# The way back as one operation ------------------------------------------------------------------


def come_inside(rig):
    """Hold the button until nothing moves any more."""
    answer = accepted(rig.controller.motion.come_inside())
    rig.run_until(lambda: answer.ending is not None, seconds=40.0)
    rig.run(1.0)


def test_the_way_back_brings_all_in_together_and_hand_and_base_apart(resting):
    come_inside(resting)
    first, *others = resting.watch.targets_deg[1:]
    assert first[1] == pytest.approx(INSIDE_DEG, abs=1e-3)
    assert first[2] == pytest.approx(-INSIDE_DEG, abs=1e-3)
    assert [first[n] for n in (0, 3, 4, 5)] == pytest.approx(
        [REST_DEG[n] for n in (0, 3, 4, 5)], abs=0.05
    )
    assert others[-1][4] == pytest.approx(CLEAR_J5_DEG, abs=0.5)
    assert resting.firmware.joints_deg[4] == pytest.approx(CLEAR_J5_DEG, abs=0.5)
    assert outside_deg(np.array(resting.firmware.true_joints_deg)).max() == 0.0
    assert resting.watch.furthest_deg.max() <= NOISE_DEG


def test_the_way_back_is_slow_whatever_the_speed_is(resting):
    resting.controller.motion.set_speed_percent(100)
    come_inside(resting)
    fastest = [each.max_speed_deg_s * SLOW_PERCENT / 100.0 for each in FACTORY_LIMITS]
    assert (resting.watch.speeds_deg_s <= np.array(fastest) * 1.02 + NOISE_DEG).all()
    assert resting.watch.speeds_deg_s.max() > 0.0


@pytest.mark.parametrize("happens", ["pause", "0 %", "the speed is raised"])
def test_the_way_back_stays_slow(resting, happens):
    controller = resting.controller
    controller.motion.set_speed_percent(60)
    answer = accepted(controller.motion.come_inside())
    resting.run(0.1)
    if happens == "the speed is raised":
        accepted(controller.motion.set_speed_percent(90))
    else:
        if happens == "pause":
            accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
        else:
            accepted(controller.motion.set_speed_percent(0))
        resting.run(1.0)
        controller.motion.set_speed_percent(60)
        accepted(controller.planned_motion.command(TrajectoryCommand.CONTINUE))
    resting.run(0.1)
    assert resting.firmware.condition.speed_percent == SLOW_PERCENT
    resting.run_until(lambda: answer.ending is not None, seconds=40.0)
    rested_percent = controller.motion.speed_percent
    resting.run_until(lambda: resting.firmware.condition.speed_percent == rested_percent)
    assert resting.firmware.joints_deg[4] == pytest.approx(CLEAR_J5_DEG, abs=0.5)


def test_after_the_way_back_the_arm_is_ready_and_moves(resting):
    come_inside(resting)
    assert resting.controller.recovery.step.kind is StepKind.READY
    assert settle(resting, resting.controller.motion.jog(1, 5.0))
    assert resting.firmware.joints_deg[0] == pytest.approx(REST_DEG[0] + 5.0, abs=0.1)
    resting.controller.jogging.start(JointJog(2, 1))
    hold(resting, 0.5)
    assert resting.controller.jogging.active


@pytest.mark.parametrize("name", ALONE)
def test_the_way_back_of_a_single_joint_moves_no_other(rig, name):
    joint, lies_deg, way = ALONE[name]
    watch = lying(rig, lies_deg)
    lay_deg = rig.firmware.true_joints_deg  # without power it has sunk a little
    come_inside(rig)
    bound = nearest_bound(joint)
    now_deg = rig.firmware.true_joints_deg
    assert now_deg[joint - 1] == pytest.approx(bound + np.sign(way) * INSIDE_DEG, abs=0.1)
    for other in set(range(1, 7)) - {joint}:
        assert now_deg[other - 1] == pytest.approx(lay_deg[other - 1], abs=0.5)
    assert watch.furthest_deg.max() <= NOISE_DEG


def test_joint_5_follows_where_joint_3_alone_is_outside_and_the_hand_lies_on_the_base(rig):
    """The rest pose of a real arm, but for joint 2."""
    lies_deg = (REST_DEG[0], 1.0, *REST_DEG[2:])
    watch = lying(rig, lies_deg)
    lay_deg = rig.firmware.true_joints_deg
    assert "then J5" in rig.controller.recovery.step.kind.value.source, "said before the press"
    come_inside(rig)
    rig.run_until(lambda: abs(rig.firmware.joints_deg[4] - CLEAR_J5_DEG) < 0.1)
    rig.run(0.5)
    now_deg = rig.firmware.true_joints_deg
    assert now_deg[2] == pytest.approx(-INSIDE_DEG, abs=0.1)
    for other in (1, 2, 4, 6):
        assert now_deg[other - 1] == pytest.approx(lay_deg[other - 1], abs=0.5)
    first, second = watch.targets_deg[1:]
    assert first[4] == pytest.approx(lies_deg[4], abs=0.5)  # only once joint 3 is inside
    assert second[2] == pytest.approx(-INSIDE_DEG, abs=1e-3)
    assert watch.furthest_deg.max() <= NOISE_DEG


@pytest.mark.parametrize("end", ["stop", "halt"])
def test_a_stop_ends_the_way_back_for_good(resting, end):
    controller = resting.controller
    answer = accepted(controller.motion.come_inside())
    resting.run(0.1)
    if end == "stop":
        controller.emergency_stop()
    else:
        controller.halt_and_hold()
    resting.run(1.0)
    assert answer.ending is not None
    count = len(resting.watch.targets_deg)
    resting.run(3.0)
    assert len(resting.watch.targets_deg) == count


def test_another_host_that_moves_the_arm_has_it_refused(resting, other_host):
    other_host.move_to((0.0, 5.0, -5.0, 0.0, 15.0, 0.0), 5)
    resting.run(0.2)
    told(resting.controller.motion.come_inside())


def test_inside_there_is_no_way_back(rig):
    lying(rig, BENT_DEG)
    told(rig.controller.motion.come_inside())
