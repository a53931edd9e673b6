"""S35, S32: a motion into one under way is judged on the way that the arm truly takes.

An arm in motion that is given another target does not go to the first one before: it goes on from
where it is, as fast as it is. Each scene has a crate that neither motion would touch by itself, and
that the arm touches when the second begins before the first has ended. The judge is the simulated
arm's true angles and its meshes; see :mod:`tests.safety.mesh_oracle`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import pytest

from armui.arm.refusal import Refusal
from armui.cell.work_area import AreaBox
from armui.control.operations.started import Started
from armui.control.safety.gate import Gate
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode
from tests.accepted import accepted
from tests.cell.areas import put
from tests.control.jogger import BENT_DEG, bend
from tests.family import PIPER
from tests.safety.inline_rig import inline_rig
from tests.safety.mesh_oracle import MeshOracle
from tests.safety.watched_arm import Watch, rest, told, watch

LEAST_MM = 9.0
WITHIN_S = 1.0
"""What was pressed leaves within this time, or it is said why not."""
HAND_DEG = BENT_DEG[3:]


@pytest.fixture
def rig(qapp, request):
    with inline_rig(request.node.nodeid) as rig:
        yield rig


def joints(*first_deg):
    """Types the first three angles; the hand keeps its own."""
    return lambda controller: controller.motion.send_joints((*first_deg, *HAND_DEG))


def pose(mode, *first_deg):
    target = tuple(round(each, 2) for each in Kinematics(PIPER).forward((*first_deg, *HAND_DEG)))
    return lambda controller: controller.cartesian.move(target, mode)


def joint_step(joint, by_deg):
    return lambda controller: controller.motion.jog(joint, by_deg)


def home(controller):
    return controller.motion.go_home()


def crate(x, y, z, edge_mm):
    return AreaBox("crate", (x, y, z, 0.0, 0.0, 0.0), (edge_mm,) * 3)


HEIGHT_MM = Kinematics(PIPER).forward(BENT_DEG)[2]
BETWEEN = crate(143.0, 323.0, 217.0, 120.0)
"""It lies between the bent arm and the same turned by 100°; a raised arm passes over it."""
BEYOND = (110.0, 70.0, -60.0)
RAISED = (10.0, 20.0, -60.0)


@dataclass(frozen=True)
class Scene:
    """Two motions, the second so long after the first.

    Attributes:
        crate: What the arm touches between the two ways.
        first, second: What is pressed.
        after_s: The time between the presses.
        percent: The speed of motions.
    """

    crate: AreaBox
    first: Callable[..., Any]
    second: Callable[..., Any]
    after_s: float
    percent: int = 100


OVER = partial(Scene, BETWEEN, joints(*RAISED))
SCENES = {
    "at once": OVER(joints(*BEYOND), 0.04),
    "after 0.1 s": OVER(joints(*BEYOND), 0.1),
    "after 0.2 s": OVER(joints(*BEYOND), 0.2),
    "after 0.2 s at 50 %": OVER(joints(*BEYOND), 0.2, 50),
    "after 0.4 s at 10 %": OVER(joints(*BEYOND), 0.4, 10),
    "a pose": OVER(pose(MoveMode.MOVE_P, *BEYOND), 0.1),
    "a step": OVER(joint_step(1, 100.0), 0.1),
    "two steps": Scene(
        crate(62.0, 245.0, 368.0, 60.0), joint_step(2, -40.0), joint_step(1, 90.0), 0.04
    ),
    "two steps at 50 %": Scene(
        crate(184.0, 182.0, 325.0, 60.0), joint_step(2, -40.0), joint_step(1, 90.0), 0.04, 50
    ),
    "sideways": Scene(
        *(crate(94.0, 165.0, 302.0, 30.0), joints(100.0, 70.0, -60.0), joints(70.0, 40.0, -30.0)),
        after_s=0.4,
    ),
    "sideways at 10 %": Scene(
        *(crate(175.0, 244.0, 234.0, 80.0), joints(100.0, 30.0, -60.0)),
        joints(100.0, 85.0, -60.0),
        after_s=1.0,
        percent=10,
    ),
    "onwards": Scene(
        *(crate(224.0, 307.0, 196.0, 30.0), joints(60.0, 70.0, -60.0), joints(100.0, 100.0, -60.0)),
        after_s=0.3,
    ),
    "a short way": Scene(
        *(crate(85.0, 323.0, 276.0, 30.0), joints(100.0, 40.0, -60.0), joints(40.0, 70.0, -60.0)),
        after_s=0.45,
    ),
    "a pose on a short way": Scene(
        *(crate(93.0, 319.0, 276.0, 20.0), joints(100.0, 40.0, -60.0)),
        pose(MoveMode.MOVE_P, 40.0, 70.0, -60.0),
        after_s=0.45,
    ),
}


class Furthest:
    """How far joint 1 has ever truly turned, in degrees."""

    def __init__(self, rig):
        self._rig, self.joint1 = rig, -360.0
        rig.company.append(self)

    def step(self, dt_s):
        self.joint1 = max(self.joint1, self._rig.firmware.true_joints_deg[0])


@pytest.fixture
def bent(rig):
    bend(rig)
    return rig


def play(rig, scene):
    """Press both; return what was said to the second, and whoever watches the arm."""
    put(rig.controller, scene.crate)
    rig.controller.motion.set_speed_percent(scene.percent)
    rig.run(0.1)
    seen = watch(rig)
    accepted(scene.first(rig.controller))
    rig.run(scene.after_s)
    rig.heard()
    return scene.second(rig.controller), seen


def answered(rig, answer):
    """Whether what was pressed has left, or it was said why not, within a second."""
    if isinstance(answer, Refusal):
        return bool(told(answer))
    for _ in range(round(WITHIN_S / 0.02)):
        if targets_heard(rig) or answer.ending is not None:
            return True
        rig.step()
    return False


def targets_heard(rig):
    """The targets since the last call; `rig.heard` leaves those of poses out."""
    heard = iter(lambda: rig._ear.recv(0), None)
    return [each for each in heard if 0x152 <= each.arbitration_id <= 0x157]


@pytest.mark.parametrize("name", [each for each in SCENES if each != "a step"])
def test_an_arm_that_goes_straight_on_would_touch(bent, monkeypatch, name):
    """What the scenes rely on: nothing is touched at first, and then only the gate is missing.

    A step begins at the first target, which is above the crate, and ends there.
    """
    scene = SCENES[name]
    oracle = MeshOracle(scene.crate)
    assert oracle.nearest(bent.firmware.true_joints_deg).mm >= LEAST_MM
    monkeypatch.setattr(Gate, "_fluent", lambda _gate, way, _motion: way)
    bent.controller.motion.set_speed_percent(scene.percent)
    bent.run(0.1)
    seen = Watch(bent, oracle)
    accepted(scene.first(bent.controller))
    bent.run(scene.after_s)
    accepted(scene.second(bent.controller))
    rest(bent)
    assert seen.least.mm < 0.0


@pytest.mark.parametrize("name", SCENES)
def test_a_second_motion_touches_nothing(bent, name):
    _, seen = play(bent, SCENES[name])
    rest(bent)
    assert seen.least.mm >= LEAST_MM


@pytest.mark.parametrize("name", SCENES)
def test_a_second_motion_leaves_within_a_second_or_it_is_said_why_not(bent, name):
    answer, _ = play(bent, SCENES[name])
    assert answered(bent, answer)
    rest(bent)


def test_the_straight_way_is_refused_from_rest(bent):
    """What the scenes rely on: this is the way that the crate bars."""
    put(bent.controller, BETWEEN)
    bent.run(0.1)
    assert told(joints(*BEYOND)(bent.controller)).params["name"] == "crate"
    accepted(joints(*RAISED)(bent.controller))
    rest(bent)
    accepted(joints(*BEYOND)(bent.controller))
    rest(bent)
    assert bent.firmware.joints_deg[0] == pytest.approx(110.0, abs=0.1)


def test_a_third_motion_is_no_better(bent):
    """Raised, back down and across, 0.1 s apart."""
    put(bent.controller, BETWEEN)
    bent.controller.motion.set_speed_percent(100)
    bent.run(0.1)
    seen = watch(bent)
    for motion in (joints(*RAISED), joints(10.0, 30.0, -60.0), joints(*BEYOND)):
        motion(bent.controller)
        bent.run(0.1)
    rest(bent)
    assert seen.least.mm >= LEAST_MM


@pytest.mark.each_value(full="each second motion at each percentage")
@pytest.mark.parametrize("percent", [10, 50, 100])
@pytest.mark.parametrize("second", [home, pose(MoveMode.MOVE_L, 20.0, 60.0, -60.0)])
def test_home_or_a_line_while_the_arm_moves_goes_there_or_says_why_not(bent, percent, second):
    put(bent.controller, crate(-300.0, 0.0, 200.0, 60.0))
    bent.controller.motion.set_speed_percent(percent)
    bent.run(0.1)
    seen = watch(bent)
    accepted(joints(60.0, 50.0, -60.0)(bent.controller))
    bent.run(0.3)
    answer = second(bent.controller)
    assert answered(bent, answer)
    rest(bent)
    assert seen.least.mm >= LEAST_MM


@pytest.mark.parametrize("percent", [10, 50, 100])
def test_the_opposite_direction_overshoots_no_wall(bent, percent):
    """A wall stands just beyond the first target; the arm turns round when it is nearly there."""
    near = joints(70.0, 70.0, -60.0)
    put(bent.controller, crate(-73.0, 441.0, 250.0, 160.0))
    bent.controller.motion.set_speed_percent(percent)
    bent.run(0.1)
    seen, furthest = watch(bent), Furthest(bent)
    accepted(near(bent.controller))
    bent.run_until(lambda: bent.firmware.joints_deg[0] > 66.0)
    for motion in (joints(10.0, 70.0, -60.0), near, joints(0.0, 60.0, -60.0)):
        answer = motion(bent.controller)
        assert answered(bent, answer)
        bent.run(0.2)
    rest(bent)
    assert seen.least.mm >= LEAST_MM
    assert 66.0 < furthest.joint1 < 70.1
    assert bent.firmware.joints_deg[:3] == pytest.approx((0.0, 60.0, -60.0), abs=0.1)


PRESSES = 12


@pytest.mark.parametrize(
    ("step", "done"),
    [
        (joint_step(1, 1.0), lambda rig: rig.firmware.joints_deg[0] - BENT_DEG[0]),
        (joint_step(5, -0.5), lambda rig: 2.0 * (BENT_DEG[4] - rig.firmware.joints_deg[4])),
        (
            lambda controller: controller.cartesian.step(2, 1.0, JogFrame.BASE),
            lambda rig: Kinematics(PIPER).forward(rig.firmware.joints_deg)[2] - HEIGHT_MM,
        ),
    ],
    ids=["joint", "joint 5", "tool"],
)
@pytest.mark.parametrize("area", [True, False], ids=["beside a crate", "in the open"])
def test_quick_steps_in_one_direction_are_all_taken_and_add_up(bent, step, done, area):
    if area:
        put(bent.controller, crate(143.0, 383.0, 217.0, 60.0))
    bent.controller.motion.set_speed_percent(50)
    bent.run(0.1)
    for number in range(PRESSES):
        answer = step(bent.controller)
        assert isinstance(answer, Started), f"press {number + 1}: {answer}"
        bent.run(0.04)
    rest(bent)
    assert done(bent) == pytest.approx(PRESSES, abs=0.3)


def test_quick_steps_towards_a_wall_end_before_it(bent):
    """As many as fit are taken; the others are refused with the zone, and none goes too far."""
    put(bent.controller, crate(143.0, 383.0, 217.0, 120.0))
    bent.controller.motion.set_speed_percent(100)
    bent.run(0.1)
    seen = watch(bent)
    answers = []
    for _ in range(60):
        answers.append(joint_step(1, 1.5)(bent.controller))
        bent.run(0.04)
    rest(bent)
    assert seen.least.mm >= LEAST_MM
    assert isinstance(answers[0], Started)
    assert told(answers[-1]).params["name"] == "crate"
