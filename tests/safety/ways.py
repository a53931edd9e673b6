"""Ways that were checked, driven in the simulated arm: by the program's own player and replayer.

`python -m tests.safety.ways` makes random programs, checks each and drives it: what the check lets
pass never ends in a fault of the arm, and where it names a point that cannot be reached the arm
refuses just that. The arm's time is the only clock; nobody waits for it.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final
from unittest.mock import Mock

import numpy as np
from PySide6.QtCore import QCoreApplication

from armui.arm.models import ArmModel, model_data
from armui.arm.other_hosts import OtherTraffic
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, EndLimits
from armui.arm.tracker import Tracker
from armui.control.authority import Authority
from armui.control.motion.motion_command import Observation
from armui.control.motion.motion_context import MotionContext
from armui.control.operating_state import OperatingState
from armui.control.run.player import Player
from armui.control.run.progress import ENDLESS, OVER, Progress, Run, RunPhase
from armui.control.run.replay import Replay
from armui.control.run.replayer import Replayer
from armui.control.safety.gate import Gate
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol import commands
from armui.protocol.codec import Codec
from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from armui.trajectory.planning.check import (
    ARC_AT_LIMIT,
    PATH_BEYOND_LIMIT,
    TARGET_BEYOND_LIMIT,
    CheckOutcome,
    CheckRequest,
    check,
)
from armui.trajectory.planning.findings import Finding, Severity
from armui.trajectory.planning.planning import (
    ARC_NO_CIRCLE,
    OUT_OF_REACH,
    PATH_OUT_OF_REACH,
    PATH_SINGULAR,
)
from armui.trajectory.points.program import GripperAngle, GripperOpening, Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from armui.ui import words
from armui.ui.words.findings import finding as finding_text
from armui.ways.rules import rules_of
from tests.accepted import accepted
from tests.arm_rig import at_once

STEP_S: Final = 0.25
"""Between two looks at an arm that runs points by itself."""
STREAM_S: Final = 0.02
"""And at one that is told 50 targets a second."""
MOST_POINTS: Final = 12
_WITHIN_S: Final = 3600.0

REFUSED_BY_THE_ARM: Final = frozenset(
    {
        TARGET_BEYOND_LIMIT,
        PATH_BEYOND_LIMIT,
        OUT_OF_REACH,
        PATH_OUT_OF_REACH,
        PATH_SINGULAR,
        ARC_NO_CIRCLE,
    }
)
"""What the arm itself says of a point it is sent to; the rest only the program looks at."""


class Bus:
    """The arm at the other end of a cable that takes no time: what a part calls its connection.

    Attributes:
        lost: Identifiers of frames that do not come through.
    """

    device = Mock(listen_only=False)

    def __init__(self, firmware: Firmware, codec: Codec, newest: Callable[[], ArmState]) -> None:
        self._firmware = firmware
        self._newest = newest
        self.lost: frozenset[int] = frozenset()
        self.codec = codec
        self.generation = firmware.generation

    @property
    def newest(self) -> ArmState:
        """The arm as heard."""
        return self._newest()

    def send(self, frames: Sequence[Frame], *_: object, **__: object) -> bool:
        """Let the arm hear frames."""
        for frame in frames:
            if frame.arbitration_id not in self.lost:
                self._firmware.on_frame(frame)
        return True

    send_urgent = send

    def void(self, number: int) -> None:
        """Nothing waits here."""


class Driver:
    """A simulated arm with power on its motors, and the parts of the program that run something.

    Args:
        start_deg: Where it stands.
        step_s: Between two looks at it.
    """

    def __init__(
        self,
        start_deg: Sequence[float],
        model: PiperModel = PiperModel.PIPER,
        generation: Generation = Generation.TWO,
        step_s: float = STEP_S,
    ) -> None:
        self.now_s = 1000.0
        self._step_s = step_s
        self.firmware = Firmware(generation, joints_deg=start_deg, model=model)
        for slot in self.firmware._schedule._slots:
            slot.due_ns = slot.period_ns = round(step_s * 1e9)
        self.firmware._schedule.next_ns = round(step_s * 1e9)
        codec = Codec(generation)
        self._codec, self._tracker, self._model = codec, Tracker(codec), model
        self.bus = Bus(self.firmware, codec, self.state)
        self.authority = Authority()
        limits = tuple(self.firmware.settings.limits)
        state = Mock(
            OperatingState,
            occupied=None,
            cannot_run=None,
            model=model,
            model_fit=Mock(wrong=None, geometry=self.firmware.type.geometry),
            limits=limits,
        )
        context = MotionContext(
            connection=self.bus,  # type: ignore[arg-type] # stands in for it
            emit_event=lambda *_, **__: None,
            clock=lambda: self.now_s,
            state=self.state,
            operating_state=lambda: state,
            refresh=lambda: state,
            observe=self._observe,
            authority=self.authority,
            begun=lambda _name: None,
            gate=lambda: self.gate,
        )
        rules = rules_of(self.arm_model())
        self.gate = Gate(context, lambda: (None, lambda: rules), at_once)
        self.player, self.replayer = Player(context), Replayer(context)
        self.bus.send(commands.enable_motors(codec))
        self.bus.send(
            commands.set_mode(
                codec,
                control_mode=ControlMode.CAN_CONTROL,
                move_mode=MoveMode.MOVE_J,
                speed_percent=100,
            )
        )
        self.step()

    def state(self) -> ArmState:
        """The arm as heard."""
        return self._tracker.snapshot()

    def _observe(self) -> None:
        self.authority.observe(
            Observation(
                self.state(), OtherTraffic(), (0,), True, self.now_s, False, model=self._model
            )
        )

    def step(self) -> None:
        """Let time pass, and the program look at what was heard."""
        self.now_s += self._step_s
        for frame in self.firmware.step(self._step_s):
            self._tracker.update(self._codec.decode(frame), self.now_s)
        self._observe()
        if self.authority.overspeed is not None:
            self.player.end_run(self.authority.overspeed)
        for part in (self.gate, self.player, self.replayer):
            part.follow_arm()

    def arm_model(self) -> ArmModel:
        """What the check is told of it."""
        settings, data = self.firmware.settings, model_data(self._model)
        return ArmModel(
            limits=tuple(settings.limits),
            accelerations_deg_s2=tuple(settings.accelerations_deg_s2),
            end_limits=EndLimits(*settings.end_limits),
            kinematics=Kinematics(self.firmware.type.geometry),
            tool_mm=data.gripper.reach_mm,
            gripper_turned_deg=data.gripper.turned_deg,
        )

    def run(self, way: Way, checked: CheckOutcome) -> Progress:
        """Drive a way to its end, or a cycle further than was looked at; how it ended."""
        most = int(checked.path.cycles.max(initial=1)) + 1
        content = way.content
        part: Player | Replayer = self.player
        if isinstance(content, Recording):
            part = self.replayer
            replay = Replay(content, way.speed_percent, way.cycles, checked.profile)
            accepted(self.replayer.start(replay))
        else:
            run = Run(
                content.name,
                content.points,
                checked.expected_s,
                way.cycles,
                way.first,
                way.speed_percent,
                way.step_by_step,
            )
            accepted(self.player.start(run))
        begun_s = self.now_s
        while part.progress.phase not in OVER:
            if part.progress.phase is RunPhase.WAITING:
                part.go_on()
            if part.progress.cycle > most and way.cycles == ENDLESS:
                return part.progress
            assert self.now_s - begun_s < _WITHIN_S, "the run does not end"
            self.step()
        return part.progress


@dataclass(frozen=True, slots=True)
class Way:
    """Something to be run, and how."""

    content: Trajectory | Recording
    start_deg: tuple[float, ...]
    model: PiperModel
    generation: Generation
    cycles: int = 1
    first: int = 0
    speed_percent: int = 100
    step_by_step: bool = False


@dataclass(frozen=True, slots=True)
class Judged:
    """What the check said of a way, and what became of it.

    Attributes:
        findings: Of the check.
        cycles: How many cycles it looked at.
        progress: How the run ended; ``None``: it was not driven.
        wrong: What contradicts the promise; "" if nothing does.
    """

    findings: tuple[Finding, ...]
    cycles: int
    progress: Progress | None
    wrong: str = ""

    @property
    def kind(self) -> str:
        """How the way is counted."""
        severities = {each.severity for each in self.findings}
        if Severity.ERROR in severities:
            return "refused, and by the arm too" if self.progress else "refused by the program"
        return "driven with warnings" if severities else "driven without findings"


def judge(way: Way) -> Judged:
    """Check a way and drive it."""
    streamed = isinstance(way.content, Recording)
    driver = Driver(way.start_deg, way.model, way.generation, STREAM_S if streamed else STEP_S)
    start_deg = driver.state().angles_deg()
    assert start_deg is not None
    arm = driver.arm_model()
    checked = check(CheckRequest(way.content, arm, start_deg, way.first, way.cycles))
    findings, path = checked.findings, checked.path
    cycles = int(path.cycles.max(initial=1))
    for found in findings:
        text = finding_text(found)
        if not text or "{" in text:
            return Judged(findings, cycles, None, f"no reason for {found}")
    errors = [each for each in findings if each.severity is Severity.ERROR]
    if errors and not any(each.kind in REFUSED_BY_THE_ARM for each in errors):
        return Judged(findings, cycles, None)
    if errors and streamed:
        return Judged(findings, cycles, None)
    progress = driver.run(way, checked)
    faulty = progress.phase is RunPhase.FAILED
    at = (progress.cycle, progress.index + 1, _text(progress.refusal))
    if not errors:
        return Judged(findings, cycles, progress, f"passed, but {at}" if faulty else "")
    order = [(each.cycle, each.row) for each in errors if each.kind in REFUSED_BY_THE_ARM]
    first = min(order, key=lambda each: (each[0], each[1] or 0))
    if not faulty:
        return Judged(findings, cycles, progress, f"refused at {first}, but the arm does it")
    told = (first[0], (first[1] or 0) + 1)
    rounded = {(each.cycle, (each.row or 0) + 1) for each in errors if each.kind == ARC_AT_LIMIT}
    if at[:2] != told and not (at[:2] in rounded and at[:2] < told):
        return Judged(findings, cycles, progress, f"refused at {told}, the arm fails at {at}")
    return Judged(findings, cycles, progress)


def _text(reason: Refusal | None) -> str:
    return "" if reason is None else words.refusal(reason)


# Random ways ----------------------------------------------------------------------------------


class Ways:
    """Makes ways by chance.

    Args:
        seed: The same seed makes the same way.
        model: Of the arm; by default by chance.
    """

    def __init__(self, seed: int, model: PiperModel | None = None) -> None:
        self._random = random.Random(seed)
        draw = self._random
        self._model = model or draw.choice(list(PiperModel))
        self._generation = draw.choice(list(Generation))
        firmware = Firmware(self._generation, model=self._model)
        self._kinematics = firmware.kinematics
        limits = model_data(self._model).limits
        self._low = [each.min_deg for each in limits]
        self._high = [each.max_deg for each in limits]
        middle = self._joints(0.25)
        self._middle, self._spread = middle, draw.choice((0.04, 0.08, 0.2, 0.5))

    def way(self) -> Way:
        """One of them."""
        draw = self._random
        start_deg = self._near()
        if draw.random() < 0.06:
            return Way(
                self._recording(start_deg),
                self._near(),
                self._model,
                self._generation,
                cycles=draw.choice((1, 2, 3)),
                speed_percent=draw.choice((50, 100, 75)),
            )
        points: tuple[Waypoint, ...] = ()
        here = start_deg
        for _ in range(draw.randint(1, MOST_POINTS)):
            point, here = self._point(here)
            points = (*points, point)
        if draw.random() < 0.8:
            points = self._mended(points, start_deg)
        return Way(
            Trajectory("way", points=points),
            start_deg,
            self._model,
            self._generation,
            cycles=draw.choice((1, 2, 2, 3, ENDLESS)),
            first=draw.choice((0, 0, draw.randrange(max(1, len(points))))),
            speed_percent=draw.choice((50, 100, 100, 25)),
            step_by_step=draw.random() < 0.2,
        )

    def _mended(
        self, points: tuple[Waypoint, ...], start_deg: tuple[float, ...]
    ) -> tuple[Waypoint, ...]:
        """The points without those that cannot be run once, one after the other."""
        arm = Driver(start_deg, self._model, self._generation).arm_model()
        for _ in range(MOST_POINTS):
            found = check(CheckRequest(Trajectory("way", points=points), arm, start_deg)).errors
            bad = [each.row for each in found if each.row is not None]
            if not bad:
                break
            points = (*points[: min(bad)], *points[min(bad) + 1 :])
        return points or (Waypoint(MoveMode.MOVE_J, self._near()),)

    def _joints(self, share: float) -> tuple[float, ...]:
        """Six angles in the middle part of their ranges, of this share to either side."""
        return tuple(
            round((low + high) / 2 + self._random.uniform(-share, share) * (high - low), 3)
            for low, high in zip(self._low, self._high, strict=True)
        )

    def _near(self) -> tuple[float, ...]:
        """Six angles about where the program goes on."""
        off = (self._random.uniform(-self._spread, self._spread) for _ in range(6))
        return tuple(
            round(min(max(angle + each * (high - low), low), high), 3)
            for angle, each, low, high in zip(self._middle, off, self._low, self._high, strict=True)
        )

    def _pose(
        self, joints_deg: Sequence[float], mm: float = 0.0, deg: float = 0.0
    ) -> tuple[float, ...]:
        pose = list(self._kinematics.forward(joints_deg))
        for axis in range(3):
            pose[axis] += self._random.uniform(-mm, mm)
            pose[axis + 3] += self._random.uniform(-deg, deg)
        return tuple(round(each, 3) for each in pose)

    def _point(self, here: tuple[float, ...]) -> tuple[Waypoint, tuple[float, ...]]:
        """A point, and about where the joints are behind it."""
        draw = self._random
        move = draw.choice(
            (
                MoveMode.MOVE_J,
                *(MoveMode.MOVE_P,) * 3,
                *(MoveMode.MOVE_L,) * 4,
                *(MoveMode.MOVE_C,) * 2,
            )
        )
        gripper: GripperAngle | GripperOpening | None = None
        if draw.random() < 0.1:
            gripper = (
                GripperAngle(draw.uniform(0.0, 60.0))
                if self._generation is Generation.ONE
                else GripperOpening(draw.uniform(0.0, 60.0))
            )
        told = Waypoint(
            move,
            here,
            speed_percent=draw.choice((100, 100, 50, draw.randint(20, 100))),
            dwell_s=draw.choice((0.0, 0.0, 0.0, 0.3)),
            gripper=gripper,
        )
        there = self._near()
        if move is MoveMode.MOVE_J:
            return replace(told, target=there), there
        if move is MoveMode.MOVE_P or draw.random() < 0.3:
            target = self._pose(there)
        else:
            there = here
            mm, deg = draw.choice(((40.0, 10.0), (120.0, 0.0), (150.0, 40.0), (0.0, 60.0)))
            target = self._pose(here, mm, deg)
        middle = self._pose(here, 60.0, 10.0) if move is MoveMode.MOVE_C else None
        return replace(told, target=target, middle=middle), there

    def _recording(self, first_deg: tuple[float, ...]) -> Recording:
        """Some seconds of smooth motion."""
        corners = [first_deg, *(self._near() for _ in range(self._random.randint(1, 3)))]
        times_s = np.arange(0.0, 3.0 * len(corners), 0.02)
        at = 3.0 * np.arange(len(corners))
        samples = np.full((len(times_s), 8), np.nan)
        samples[:, 0] = times_s
        for joint, angles in enumerate(zip(*corners, strict=True), start=1):
            eased = np.interp(times_s, at, np.arange(len(corners)))
            whole, part = np.floor(eased).astype(int), eased % 1.0
            nexts = np.minimum(whole + 1, len(corners) - 1)
            ease = part * part * (3.0 - 2.0 * part)
            track = np.array(angles)
            samples[:, joint] = np.round(track[whole] + ease * (track[nexts] - track[whole]), 3)
        return Recording("way", samples=samples)


def judged(
    seeds: Iterator[int] | range, model: PiperModel | None = None
) -> Iterator[tuple[int, Way, Judged]]:
    """Each seed, its way and what became of it."""
    for seed in seeds:
        way = Ways(seed, model).way()
        yield seed, way, judge(way)


def main() -> int:
    """Make, check and drive ways; those that contradict the promise are told."""
    parser = argparse.ArgumentParser(prog="python -m tests.safety.ways", description=__doc__)
    parser.add_argument("--count", type=int, default=2000, help="how many ways")
    parser.add_argument("--seed", type=int, default=1, help="of the first")
    options = parser.parse_args()
    application = QCoreApplication([])
    kinds: Counter[str] = Counter()
    found: Counter[str] = Counter()
    cycles: Counter[int] = Counter()
    wrong, later, begun_s = 0, 0, time.monotonic()
    for seed, way, result in judged(range(options.seed, options.seed + options.count)):
        kinds[result.kind] += 1
        found.update({each.code for each in result.findings})
        cycles[result.cycles] += 1
        later += min((each.cycle for each in result.findings), default=1) > 1
        if (seed - options.seed) % 100 == 99:
            sys.stdout.write(f"{dict(kinds)}, wrong {wrong}\n")
            sys.stdout.flush()
        if result.wrong:
            wrong += 1
            count = len(getattr(way.content, "points", ()))
            sys.stdout.write(
                f"seed {seed}: {way.model} {count} points cycles {way.cycles} from {way.first}: "
                f"{result.wrong}; {[(str(e.code), e.cycle, e.row) for e in result.findings]}\n"
            )
            sys.stdout.flush()
    sys.stdout.write(f"{dict(kinds)}\ncycles looked at: {dict(sorted(cycles.items()))}\n")
    sys.stdout.write(f"with findings of a later cycle only: {later}\n")
    sys.stdout.write(f"findings: {dict(found.most_common())}\n")
    sys.stdout.write(f"wrong: {wrong} of {options.count} in {time.monotonic() - begun_s:.0f} s\n")
    del application
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
