"""Motions of all kinds in random cells: how deep the simulated arm comes into any zone.

`python -m tests.safety.many_motions --seeds 100 --first 0` plays so many cells, some motions each,
and says what came of it by kind: taken and refused, the least gap, the largest depth, and refusals
for which the oracle knows no reason. Each line of what went wrong names its seed, which
`--seeds 1 --first SEED` plays again. The judge measures meshes and the arm's true angles
(:mod:`tests.safety.mesh_oracle`); nothing of the program's own checks is asked.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtCore import QCoreApplication

from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.placement import Placement
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import MOST_PLANES, AreaBox, AreaPlane, Zone
from armui.control.arm_controller import ArmController
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.motion.steered_path import SteeredJog
from armui.control.operations.started import Started
from armui.control.parameters.arm_model import arm_model
from armui.control.run.progress import Run
from armui.control.run.replay import Replay
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import JogFrame
from armui.kinematics.poses import Pose, flange_pose
from armui.protocol import commands
from armui.protocol.codec import Codec
from armui.protocol.codes import MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from armui.trajectory.planning.check import CheckOutcome, CheckRequest
from armui.trajectory.planning.check import check as check_way
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted
from tests.cell.areas import area_of
from tests.control.jogger import hold
from tests.safety.inline_rig import InlineRig
from tests.safety.mesh_oracle import Gap, Judge, MeshOracle, frame_of
from tests.safety.watched_arm import Watch, rest, settle

MARGINS_MM = (2.0, 10.0)
"""The least that a cell may have, and the usual one."""
SLACK_MM = 1.0
NO_REASON_MM = 3.0
"""A way that keeps so much more than the margin everywhere was refused without a reason."""
CLEAR_MM = 28.0
"""So far is every zone from the meshes at the beginning: what encloses them is wider."""
MOTIONS = 6
"""In each cell."""
SMALL_STEPS = 50
SHARES = (1.0, 0.5, 0.25, 0.1)
"""What is refused is pressed again for so much of its way: it ends nearer to what is in the way."""
_GHOST_S = 14.0
_TRIES = 8
_NEAR_ENOUGH_MM = 6.0
_MIDDLE_MM = np.array((0.0, 0.0, 250.0))
"""Boxes are moved towards here or away."""
TURNS = [0.2 * way * np.eye(6)[joint] for joint in range(6) for way in (1, -1)]
"""Small steps of each joint, either way."""
_FRAMES = (JogFrame.BASE, JogFrame.TOOL)


@dataclass
class Motion:
    """What came of one motion.

    Attributes:
        seed, number: It is the so-manieth of this seed.
        kind: What it was.
        margin_mm: What the arm has to keep from the zones.
        taken, refused: How many presses the program took and refused.
        reasons: The reasons that it gave.
        first, least: The gaps at its beginning and where it was nearest.
        groundless: For each refusal without a reason in the oracle: its code, and by how much more
            than the margin the way that was refused stays away.
        early_mm: By how much more than the margin a jog was away that was ended before a zone.
    """

    seed: int
    number: int
    kind: str
    margin_mm: float
    taken: int = 0
    refused: int = 0
    reasons: Counter[str] = field(default_factory=Counter)
    first: Gap = field(default_factory=lambda: Gap(np.inf))
    least: Gap = field(default_factory=lambda: Gap(np.inf))
    groundless: list[tuple[str, float]] = field(default_factory=list)
    early_mm: list[float] = field(default_factory=list)

    @property
    def depth_mm(self) -> float:
        """How deep the arm came into a zone."""
        return max(0.0, -self.least.mm)

    @property
    def intrudes(self) -> bool:
        """Whether it came nearer than the margin, less what measuring wavers by."""
        return self.least.mm < min(self.margin_mm, self.first.mm) - SLACK_MM


class Scene:
    """A random cell around a random pose, and the arm in it.

    Args:
        seed: Everything follows from it.
    """

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self.rng = np.random.default_rng(seed)
        self.jogs = seed % 3 == 0
        rng = self.rng
        names = [each.value for each in PiperModel]
        name = PiperModel.PIPER.value if rng.random() < 0.7 else str(rng.choice(names))
        self.model = PiperModel(name)
        self.margin_mm = float(rng.choice(MARGINS_MM))
        self.opening_mm = round(
            float(rng.uniform(0.0, model_data(self.model).gripper.strokes_mm[0])), 1
        )
        self.cell = self._cell()
        self.rig = InlineRig(f"motions {seed}")
        if not self.jogs:
            self.rig.repeat_nothing()  # a jog is told as often as a real arm tells

    def _cell(self) -> Cell:
        rng = self.rng
        cell = Cell("random")
        if rng.random() < 0.4:
            tip = (*rng.uniform(-60.0, 60.0, 2), rng.uniform(60.0, 220.0), 0.0, 0.0, 0.0)
            cell = replace(cell, tools=(Tool("t", _rounded(tip), rng.uniform(2, 20)),), tool="t")
        if rng.random() < 0.4:
            size = _rounded(rng.uniform(20.0, 160.0, 3))
            place = (*rng.uniform(-30, 30, 2), rng.uniform(100, 200), *rng.uniform(-90, 90, 3))
            held = HeldObject("h", _rounded(place), size, is_rod=bool(rng.random() < 0.4))
            if held.is_rod:
                held = replace(held, size_mm=(size[0] / 2, size[0] / 2, max(size)))
            cell = replace(cell, held_objects=(held,), held="h")
        if rng.random() < 0.3:
            turns = rng.uniform(-180.0, 180.0, 3)
            cell = replace(cell, placement=Placement((0.0, 0.0, 800.0, *_rounded(turns))))
        frame = UserFrame("u", _rounded((*rng.uniform(-200, 200, 3), *rng.uniform(-180, 180, 3))))
        cell = replace(cell, frames=(frame,), frame="u")
        limits = model_data(self.model).limits
        low, high = (
            np.array([getattr(each, n) for each in limits]) for n in ("min_deg", "max_deg")
        )
        self.lies_deg = _rounded(
            (low + high) / 2.0 + 0.8 * rng.uniform(-0.5, 0.5, 6) * (high - low)
        )
        return replace(cell, area=area_of(*self._zones(cell), margin_mm=self.margin_mm))

    def _zones(self, cell: Cell) -> Iterator[Zone]:
        """Yield planes and boxes around the arm where it lies, one of them at least near."""
        rng, planes = self.rng, 0
        for number in range(int(rng.integers(1, 21))):
            furthest_mm = CLEAR_MM + 15.0 if number == 0 else rng.choice((80.0, 350.0, 350.0))
            near_mm = float(rng.uniform(CLEAR_MM, furthest_mm))
            turns = _rounded(rng.uniform(-180.0, 180.0, 3))
            if planes < MOST_PLANES and rng.random() < 0.25:
                zone: Zone = AreaPlane(f"plane {number}", (0.0, 0.0, 0.0, *turns))
                planes += 1
            else:
                place = rng.uniform((-600.0, -600.0, -100.0), (600.0, 600.0, 800.0))
                size = _rounded(rng.uniform(20.0, 250.0, 3))
                zone = AreaBox(f"box {number}", (*_rounded(place), *turns), size)
            moved = self._moved(zone, near_mm, cell)
            if moved is not None:
                yield moved

    def _moved(self, zone: Zone, near_mm: float, cell: Cell) -> Zone | None:
        """Return a zone so far from the arm; ``None`` if it does not come to that."""
        normal = frame_of(zone.pose)[:3, 2]
        for _ in range(_TRIES):
            gap = MeshOracle(zone, model=self.model, cell=cell).nearest(
                self.lies_deg, self.opening_mm
            )
            off_mm = gap.mm - near_mm
            if abs(off_mm) < _NEAR_ENOUGH_MM and gap.mm >= CLEAR_MM:
                return zone
            place = np.array(zone.pose[:3])
            if isinstance(zone, AreaPlane):
                way = normal
            else:
                way = _MIDDLE_MM - place
                way = way / max(float(np.linalg.norm(way)), 1.0)
            zone = replace(zone, pose=(*_rounded(place + off_mm * way), *zone.pose[3:]))
        return None

    def begin(self) -> None:
        """Switch the arm on, put the cell in force, and watch."""
        rig = self.rig
        rig.lie(self.lies_deg, self.model)
        rig.firmware.gripper.lead_to(self.opening_mm)
        rig.connect(self.model)
        accepted(rig.controller.motors.enable())
        rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
        accepted(rig.controller.cell.take(self.cell))
        rig.run(0.2)
        self.oracle = MeshOracle.of(self.cell, self.model)
        self.kinematics = Kinematics(model_data(self.model).geometry)

    def play(self, motions: int | Sequence[str]) -> Iterator[Motion]:
        """Yield what came of so many motions, or one of each of some kinds; a touch is the last."""
        kinds = JOG_KINDS if self.jogs else KINDS
        names = list(kinds)
        for number in range(motions if isinstance(motions, int) else len(motions)):
            if isinstance(motions, int):
                name = names[int(self.rng.integers(len(names)))]
            else:
                name = motions[number]
            motion = Motion(self.seed, number, name, self.margin_mm)
            self.controller.motion.set_speed_percent(int(self.rng.choice((10, 30, 50, 100, 100))))
            self.rig.run(0.1)
            watch = Watch(self.rig, self.oracle)
            motion.first = watch.least
            kinds[name](self, motion)
            self.rig.run(0.3)
            motion.least = watch.end()
            yield motion
            if motion.depth_mm > 0.0 or self.controller.operating_state.cannot_move is not None:
                return

    @property
    def controller(self) -> ArmController:
        """The program's controller."""
        return self.rig.controller

    @property
    def here_deg(self) -> tuple[float, ...]:
        """Where the arm truly is."""
        return self.rig.firmware.true_joints_deg

    # What is pressed --------------------------------------------------------------------------

    def near_joints(self, most_deg: float = 70.0) -> tuple[float, ...]:
        """Six angles within the limits, not too far."""
        limits = model_data(self.model).limits
        turned = np.array(self.here_deg) + self.rng.uniform(-1.0, 1.0, 6) * most_deg
        low, high = (
            np.array([getattr(each, n) for each in limits]) for n in ("min_deg", "max_deg")
        )
        return _rounded(np.clip(turned, low + 1.0, high - 1.0))

    def near_pose(self, most_mm: float = 150.0) -> tuple[float, ...]:
        """A pose of the tool near to the present one."""
        pose = np.array(self.controller.cartesian.tool_pose(self.controller.state))
        off = self.rng.uniform(-1.0, 1.0, 6) * (*(most_mm,) * 3, 20.0, 20.0, 20.0)
        return _rounded(pose + off)

    def press(self, motion: Motion, way: Way) -> Started | Refusal | None:
        """Press a motion, and if it is refused the first part of it, shorter each time.

        A refusal is weighed by what the arm would have done.
        """
        answer: Started | Refusal | None = None
        for share in SHARES:
            order = way(share)
            answer = order.press(self.controller)
            self.weigh(motion, answer, order)
            if isinstance(answer, Started):
                break
        return answer

    def weigh(self, motion: Motion, answer: Started | Refusal | None, order: Order | None) -> None:
        """Count an answer; one that refuses is asked for its reason."""
        if isinstance(answer, Started):
            motion.taken += 1
            return
        motion.refused += 1
        if isinstance(answer, Refusal):
            motion.reasons[str(answer.reason.id)] += 1
            # of the arm against itself, its limits and its reach the oracle knows nothing
            if order is not None and "area" in str(answer.reason.id):
                gap_mm = self.would_keep_mm(order)
                if gap_mm is not None and gap_mm > self.margin_mm + NO_REASON_MM:
                    motion.groundless.append((str(answer.reason.id), gap_mm - self.margin_mm))

    def would_keep_mm(self, order: Order) -> float | None:
        """Return the least gap of an arm that is sent there all the same.

        Returns:
            ``None`` if the arm itself refuses, or comes so near that there is a reason.
        """
        twin = Firmware(Generation.TWO, joints_deg=self.here_deg, model=self.model)
        codec = Codec(Generation.TWO)
        for frame in commands.enable_motors(codec):
            twin.on_frame(frame)
        twin.step(0.3)
        for frame in order.frames(codec, self.controller.motion.speed_percent):
            twin.on_frame(frame)
        judge, opening_mm = Judge(self.oracle), self.rig.firmware.gripper.travel
        judge.see(twin.true_joints_deg, opening_mm)
        still = 0
        for _ in range(round(_GHOST_S / 0.02)):
            twin.step(0.02)
            if twin.condition.status != 0:
                return None
            judge.see(twin.true_joints_deg, opening_mm)
            if judge.least.mm <= self.margin_mm + NO_REASON_MM:
                return None
            still = still + 1 if max(map(abs, twin.mechanics.speeds_deg_s)) < 0.02 else 0
            if still > 10:
                break
        return judge.least.mm

    def nearer(self, deltas: Sequence[np.ndarray]) -> int:
        """Return which of some small turns of the joints leads nearest to a zone."""
        here, opening = np.array(self.here_deg), self.rig.firmware.gripper.travel
        gaps = [self.oracle.nearest(here + each, opening).mm for each in deltas]
        return int(np.argmin(gaps))


@dataclass(frozen=True)
class Order:
    """A single motion: how it is pressed, and the frames that a host would send for it."""

    press: Callable[..., Started | Refusal]
    frames: Callable[[Codec, int], list[Frame]]


Way = Callable[[float], Order]
"""Gives the order for a share of a way."""


def to_joints(scene: Scene, target: Sequence[float]) -> Way:
    here = np.array(scene.here_deg)

    def order(share: float) -> Order:
        part = _rounded(here + share * (np.array(target) - here))
        return Order(
            lambda controller: controller.motion.send_joints(part),
            lambda codec, percent: commands.move_joints(codec, part, speed_percent=percent),
        )

    return order


def go_home(scene: Scene) -> Way:
    to_zero = to_joints(scene, (0.0,) * 6)

    def order(share: float) -> Order:
        whole = Order(lambda controller: controller.motion.go_home(), to_zero(1.0).frames)
        return whole if share == 1.0 else to_zero(share)

    return order


def to_pose(scene: Scene, target: Sequence[float], mode: MoveMode) -> Way:
    here = np.array(_tool_pose(scene))

    def order(share: float) -> Order:
        part = _rounded(here + share * (np.array(target) - here))
        flange = flange_pose(part, scene.controller.cartesian.tool)
        return Order(
            lambda controller: controller.cartesian.move(part, mode),
            lambda codec, percent: commands.move_pose(
                codec, flange, speed_percent=percent, move_mode=mode
            ),
        )

    return order


def on_arc(scene: Scene) -> Way:
    here = _tool_pose(scene)
    offs = scene.rng.uniform(-70.0, 70.0, (2, 3))
    tool = scene.controller.cartesian.tool

    def order(share: float) -> Order:
        middle, end = ((*_rounded(np.array(here[:3]) + share * off), *here[3:]) for off in offs)
        places = [flange_pose(each, tool) for each in (here, middle, end)]
        return Order(
            lambda controller: controller.cartesian.move_arc(here, middle, end),
            lambda codec, percent: commands.move_arc(codec, *places, speed_percent=percent),
        )

    return order


def _tool_pose(scene: Scene) -> tuple[float, ...]:
    pose = scene.controller.cartesian.tool_pose(scene.controller.state)
    assert pose is not None
    return tuple(pose)


def any_way(scene: Scene) -> Way:
    which = scene.rng.integers(6)
    if which == 0:
        return to_pose(scene, scene.near_pose(), MoveMode.MOVE_P)
    if which == 1:
        return to_pose(scene, scene.near_pose(), MoveMode.MOVE_L)
    if which == 2:
        return go_home(scene)
    if which == 3:
        return on_arc(scene)
    return to_joints(scene, scene.near_joints())


def single(make: Callable[[Scene], Way]) -> Callable[[Scene, Motion], None]:
    """A single motion from rest."""

    def play(scene: Scene, motion: Motion) -> None:
        settle_if_taken(scene, scene.press(motion, make(scene)))

    return play


def second(scene: Scene, motion: Motion) -> None:
    """Two or three motions, each into the one under way."""
    answer = scene.press(motion, any_way(scene))
    for _ in range(int(scene.rng.integers(1, 3))):
        if not isinstance(answer, Started):
            break
        scene.rig.run(float(scene.rng.choice((0.04, 0.1, 0.2, 0.4, 0.6))))
        order = any_way(scene)(float(scene.rng.choice(SHARES)))
        answer = order.press(scene.controller)
        scene.weigh(motion, answer, None)
    settle_if_taken(scene, answer)
    rest(scene.rig)


def quick_steps(scene: Scene, motion: Motion) -> None:
    """Steps 40 ms apart, of one joint or along one axis."""
    joint, way = int(scene.rng.integers(1, 7)), int(scene.rng.choice((-1, 1)))
    for _ in range(20):
        scene.weigh(motion, scene.controller.motion.jog(joint, way * 1.5), None)
        scene.rig.run(0.04)
    scene.rig.run(2.0)


def small_steps(scene: Scene, motion: Motion) -> None:
    """Many small motions in a row, each towards the nearest zone."""
    rng = scene.rng
    kind = int(rng.integers(4))
    for number in range(SMALL_STEPS):
        if number % 10 == 0:
            which = scene.nearer(TURNS) if kind < 2 else _axis_towards(scene)
        joint, way = which // 2, 1 - 2 * (which % 2)
        controller = scene.controller
        if kind == 0:
            answer = controller.motion.jog(joint + 1, 0.2 * way)
        elif kind == 1:
            target = np.array(controller.state.angles_deg()) + TURNS[which]
            answer = controller.motion.send_joints(_rounded(target))
        elif kind == 2:
            answer = controller.cartesian.step(joint, 0.9 * way, JogFrame.BASE)
        else:
            pose = np.array(controller.cartesian.tool_pose(controller.state))
            pose[joint] += 0.8 * way
            mode = MoveMode.MOVE_P if number % 2 else MoveMode.MOVE_L
            answer = controller.cartesian.move(_rounded(pose), mode)
        scene.weigh(motion, answer, None)
        settle_if_taken(scene, answer)


def _axis_towards(scene: Scene) -> int:
    """Return the axis of the base, and its direction, that leads nearest to a zone."""
    here, turns = scene.here_deg, []
    pose = np.array(scene.kinematics.forward(here))
    for axis in range(3):
        for way in (1, -1):
            moved = pose.copy()
            moved[axis] += 3.0 * way
            found = scene.kinematics.inverse(Pose(*moved.tolist()), here)
            turns.append(np.array(found[0]) - here if found else np.zeros(6))
    return scene.nearer(turns)


def run(scene: Scene, motion: Motion) -> None:
    """A run of some points, checked as the window does, and let go if nothing speaks against it."""
    controller, rng = scene.controller, scene.rng
    here, pose = np.array(scene.here_deg), np.array(_tool_pose(scene))
    modes = rng.choice((MoveMode.MOVE_J, MoveMode.MOVE_P, MoveMode.MOVE_L), rng.integers(3, 7))
    off_deg = rng.uniform(-30.0, 30.0, (len(modes), 6))
    off_mm = rng.uniform(-60.0, 60.0, (len(modes), 6)) * (1.0, 1.0, 1.0, 0.3, 0.3, 0.3)
    for share in SHARES:
        points = []
        for mode, deg, mm in zip(map(MoveMode, modes), off_deg, off_mm, strict=True):
            target = here + share * deg
            if mode is not MoveMode.MOVE_J:
                target = flange_pose(_rounded(pose + share * mm), controller.cartesian.tool)
            points.append(Waypoint(mode, _rounded(target), speed_percent=100))
        outcome = _checked(scene, motion, Trajectory("random", points=tuple(points)))
        if outcome is not None:
            answer = controller.player.start(Run("random", points, outcome.expected_s))
            scene.weigh(motion, answer, None)
            settle_if_taken(scene, answer, 60.0)
            return


def replay(scene: Scene, motion: Motion) -> None:
    """A recording along a smooth way, approached first as the window does."""
    here, rng = np.array(scene.here_deg), scene.rng
    times = np.arange(0.0, 3.0, 0.01)
    samples = np.full((len(times), 8), np.nan)
    samples[:, 0] = times
    swing = (np.array(scene.near_joints(35.0)) - here) * rng.choice((0, 1, 1), 6)
    shape = (1.0 - np.cos(np.pi * times / 1.5)) / 2.0
    for share in SHARES:
        samples[:, 1:7] = here + share * shape[:, None] * swing
        recording = Recording("random", samples=samples.copy())
        if _checked(scene, motion, recording) is not None:
            answer = scene.controller.replayer.start(Replay(recording))
            scene.weigh(motion, answer, None)
            settle_if_taken(scene, answer, 20.0)
            return


def _checked(scene: Scene, motion: Motion, content: Trajectory | Recording) -> CheckOutcome | None:
    """Return what the check of the window says of a content; ``None`` if it may not be run."""
    controller = scene.controller
    start_deg = controller.state.angles_deg()
    assert start_deg is not None
    area = controller.area_guard.check()
    outcome = check_way(CheckRequest(content, arm_model(controller), start_deg, area=area))
    if not outcome.errors:
        return outcome
    motion.refused += 1
    motion.reasons.update(str(each.kind.id) for each in outcome.errors)
    return None


def settle_if_taken(scene: Scene, answer: Started | Refusal | None, seconds: float = 14.0) -> None:
    if isinstance(answer, Started):
        settle(scene.rig, answer, seconds)


def joint_jog(scene: Scene, motion: Motion) -> None:
    which = scene.nearer(TURNS) if scene.rng.random() < 0.5 else int(scene.rng.integers(12))
    held(scene, motion, JointJog(which // 2 + 1, 1 - 2 * (which % 2)))


def tool_jog(scene: Scene, motion: Motion) -> None:
    if scene.rng.random() < 0.5:
        which = _axis_towards(scene)
        held(scene, motion, ToolJog(which // 2, 1 - 2 * (which % 2), JogFrame.BASE))
        return
    frame = (*_FRAMES, scene.cell.chosen_frame)[int(scene.rng.integers(3))]
    assert frame is not None
    way = int(scene.rng.choice((-1, 1)))
    held(scene, motion, ToolJog(int(scene.rng.integers(6)), way, frame))


def steered_jog(scene: Scene, motion: Motion) -> None:
    rng = scene.rng
    frame = (None, *_FRAMES, scene.cell.chosen_frame)[int(rng.integers(4))]
    rates = rng.uniform(-1.0, 1.0, 6) * (rng.random(6) < 0.5)
    if not rates.any():
        rates[0] = 1.0
    held(scene, motion, SteeredJog(tuple(map(float, rates)), frame, "pad"))


def held(scene: Scene, motion: Motion, jog: JointJog | ToolJog | SteeredJog) -> None:
    """Hold a jog until it ends or is let go of; one that is steered changes its mind."""
    rig, jogging = scene.rig, scene.controller.jogging
    told = len(rig.events)
    answer = jogging.start(jog)
    scene.weigh(motion, answer, None)
    for tick in range(int(scene.rng.integers(20, 250))):
        if isinstance(jog, SteeredJog):
            if tick % 60 == 59:
                jog = replace(jog, rates=tuple(map(float, scene.rng.uniform(-1.0, 1.0, 6))))
            jogging.steer(jog)
        hold(rig, 0.01)
        if not jogging.active:
            break
    jogging.stop()
    hold(rig, 0.3)
    for event in rig.events[told:]:
        reason = event.params.get("reason")
        if event.code == "jog_ended" and isinstance(reason, Refusal):
            motion.reasons[str(reason.reason.id)] += 1
            if "area" in str(reason.reason.id):
                here = scene.oracle.nearest(scene.here_deg, rig.firmware.gripper.travel)
                motion.early_mm.append(here.mm - scene.margin_mm)


def tapped(scene: Scene, motion: Motion) -> None:
    """A button tapped again and again, towards the nearest zone."""
    which = scene.nearer(TURNS)
    jog = JointJog(which // 2 + 1, 1 - 2 * (which % 2))
    for _ in range(SMALL_STEPS):
        scene.weigh(motion, scene.controller.jogging.start(jog), None)
        hold(scene.rig, 0.05)
        scene.controller.jogging.stop()
        hold(scene.rig, 0.1)


KINDS: dict[str, Callable[[Scene, Motion], None]] = {
    "joints": single(lambda scene: to_joints(scene, scene.near_joints())),
    "MOVE P": single(lambda scene: to_pose(scene, scene.near_pose(), MoveMode.MOVE_P)),
    "MOVE L": single(lambda scene: to_pose(scene, scene.near_pose(), MoveMode.MOVE_L)),
    "MOVE C": single(on_arc),
    "home": single(go_home),
    "second": second,
    "second again": second,
    "quick steps": quick_steps,
    "small steps": small_steps,
    "run": run,
    "replay": replay,
}
JOG_KINDS: dict[str, Callable[[Scene, Motion], None]] = {
    "joint jog": joint_jog,
    "tool jog": tool_jog,
    "steered jog": steered_jog,
    "tapped": tapped,
}


def play(seed: int, motions: int | Sequence[str] = MOTIONS) -> list[Motion]:
    """Play one cell with so many motions, or some kinds of them; return what came of each."""
    scene = Scene(seed)
    try:
        scene.begin()
        return list(scene.play(motions))
    finally:
        scene.rig.close()


def _rounded(values: Sequence[float] | np.ndarray) -> tuple[float, ...]:
    return tuple(round(float(value), 2) for value in values)


def report(motions: Sequence[Motion], left_out: int, seconds: float) -> str:
    """Return the figures of many motions as a table, and a line for each that went wrong."""
    by_kind: dict[str, list[Motion]] = defaultdict(list)
    for motion in motions:
        by_kind[motion.kind].append(motion)
    lines = [
        f"{len(motions)} motions in {seconds:.0f} s of processor time, {left_out} seeds left out",
        "kind           count  taken refused   least  depth touch < 9 mm groundless",
    ]
    for kind, some in sorted(by_kind.items()):
        least = min(each.least.mm for each in some)
        lines.append(
            f"{kind:14}{len(some):6}{sum(each.taken for each in some):7}"
            f"{sum(each.refused for each in some):8}{least:8.1f}"
            f"{max(each.depth_mm for each in some):7.1f}"
            f"{sum(each.depth_mm > 0.0 for each in some):6}{sum(each.intrudes for each in some):7}"
            f"{sum(len(each.groundless) for each in some):11}"
        )
    for each in motions:
        if each.depth_mm > 0.0 or each.intrudes:
            what = "TOUCH" if each.depth_mm > 0.0 else "near"
            lines.append(
                f"{what}: seed {each.seed}, motion {each.number}, {each.kind}: "
                f"{each.first.mm:.1f} → {each.least.mm:.1f} mm, {each.least.part} in "
                f"{each.least.zone}"
            )
    reasons: Counter[str] = Counter()
    for each in motions:
        reasons.update(each.reasons)
    lines.append(f"reasons: {dict(reasons.most_common())}")
    groundless = [(gap, code, each.seed) for each in motions for code, gap in each.groundless]
    if groundless:
        gaps = np.array([gap for gap, *_ in groundless])
        quantiles = np.quantile(gaps, (0.5, 0.95, 1.0)).round(1).tolist()
        lines.append(f"refused without a reason, beyond the margin: {quantiles} mm")
        for gap, code, seed in sorted(groundless, reverse=True)[:10]:
            lines.append(f"  seed {seed}: {code}, {gap:.1f} mm more kept")
    early = np.array([gap for each in motions for gap in each.early_mm])
    if len(early):
        quantiles = np.quantile(early, (0.5, 0.95, 1.0)).round(1).tolist()
        lines.append(f"{len(early)} jogs ended by a zone, so far before the margin: {quantiles} mm")
    return "\n".join(lines)


def main() -> None:
    """Play many cells and tell what came of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=10, help="how many cells")
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--motions", type=int, default=MOTIONS, help="in each cell")
    options = parser.parse_args()
    application = QCoreApplication([])
    began_s, found, left_out = time.process_time(), [], 0
    for seed in range(options.first, options.first + options.seeds):
        try:
            found += play(seed, options.motions)
            print(f"seed {seed} played", file=sys.stderr)
        except AssertionError as error:  # the computer was too busy for the bus thread
            left_out += 1
            print(f"seed {seed} left out: {error}", file=sys.stderr)
    print(report(found, left_out, time.process_time() - began_s))
    application.quit()


if __name__ == "__main__":
    main()
