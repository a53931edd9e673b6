"""One entry for every operation: what it is called with, and in which state it begins."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, Final

import numpy as np

from armui.arm.parameters import Batch, Group, Parameter
from armui.arm.refusal import Refusal
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.tools import Tool
from armui.control.motion.jog_path import JointJog
from armui.control.operating_state import StopState
from armui.control.run.progress import Run
from armui.control.run.replay import Replay
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import (
    EndLoad,
    LinkageRole,
    Mounting,
    MoveMode,
    TeachingState,
    TrajectoryCommand,
)
from armui.trajectory.points.program import Waypoint
from armui.trajectory.samples.recording import Recording
from tests.safety.arm_oracle import Array, pose_of, tip_of
from tests.safety.operation_driver import Answer, Driver

Joints = tuple[float, ...]

BENT_DEG: Final[Joints] = (10.0, 70.0, -60.0, 15.0, 40.0, 20.0)
"""Away from every limit and every singular pose."""


@dataclass(frozen=True, slots=True)
class Way:
    """Where an operation is to lead; each says the same in its own words.

    Attributes:
        start_deg: Where the arm stands.
        end_deg: Where it is to go.
        joint: What a step or jog turns towards it, 1–6.
        axis: Along which axis of the base a step of the tool goes towards it, 0–2.
        arc_mm: How far the middle of an arc lies aside of it, along the base's Y axis.
    """

    start_deg: Joints
    end_deg: Joints
    joint: int = 1
    axis: int = 0
    arc_mm: float = 15.0

    @property
    def delta_deg(self) -> float:
        """By how much its joint turns."""
        return self.end_deg[self.joint - 1] - self.start_deg[self.joint - 1]

    @property
    def delta_mm(self) -> float:
        """How far the tool goes along its axis."""
        return self.end_pose[self.axis] - self.start_pose[self.axis]

    @property
    def start_pose(self) -> Joints:
        """The flange where it begins."""
        return pose_of(self.start_deg)

    @property
    def end_pose(self) -> Joints:
        """The flange where it ends."""
        return pose_of(self.end_deg)

    @property
    def arc(self) -> tuple[Joints, Joints, Joints]:
        """Three poses: along its axis, with the hand turned as at its start."""
        start = self.start_pose
        middle, end = list(start), list(start)
        middle[self.axis] += self.delta_mm / 2
        end[self.axis] += self.delta_mm
        middle[1 if self.axis != 1 else 2] += self.arc_mm
        return start, tuple(middle), tuple(end)

    @property
    def run(self) -> Run:
        """One point at the end, slower than the operator's speed."""
        point = Waypoint(MoveMode.MOVE_J, self.end_deg, speed_percent=RUN_PERCENT)
        return Run("way", [point], [2.0])

    @property
    def recording(self) -> Recording:
        """From its start to its end without a jerk."""
        start, end = np.array(self.start_deg), np.array(self.end_deg)
        seconds = max(1.0, float(np.abs(end - start).max()) / _RECORDED_DEG_S)
        times = np.arange(0.0, seconds, 0.02)
        samples = np.full((len(times), 8), math.nan)
        samples[:, 0] = times
        eased = (1.0 - np.cos(math.pi * times / seconds)) / 2.0
        samples[:, 1:7] = start + eased[:, None] * (end - start)
        return Recording("way", samples=samples, modified=datetime(2026, 1, 1, tzinfo=UTC))


RUN_PERCENT: Final = 40
SPEED_PERCENT: Final = 60
"""The operator's."""
_RECORDED_DEG_S: Final = 25.0

FREE: Final = Way(BENT_DEG, (40.0, 55.0, -45.0, 15.0, 40.0, 20.0))
"""Nothing is in the way of this one."""


def _same_state(_driver: Driver, _way: Way) -> Refusal | None:
    """It begins in an arm that stands ready."""
    return None


def _tip_at_end(way: Way) -> Array:
    return tip_of(way.end_deg)


def _tip_along(way: Way) -> Array:
    """The hand is shifted along the axis, and turned as before."""
    tip = tip_of(way.start_deg)
    tip[way.axis] += way.delta_mm
    return tip


@dataclass(frozen=True, slots=True)
class Entry:
    """How an operation is tried.

    Attributes:
        arguments: What it is called with, in order or by name, by the way it is to lead.
        frames: The motion frames it sends where nothing hinders it; empty if it sends none.
        before: Brings the arm, which stands ready at the way's start, into the state it begins in;
            it returns why that state could not be reached, or None.
        percent: The speed shown of what it does; None: the operator's.
        tip_mm: Where it leads the fingertips; None: nowhere.
    """

    arguments: Callable[[Way], Sequence[Any] | Mapping[str, Any]]
    frames: frozenset[int] = frozenset()
    before: Callable[[Driver, Way], Refusal | None] = _same_state
    percent: int | None = None
    tip_mm: Callable[[Way], Array] | None = None

    def begin(self, driver: Driver, name: str, way: Way) -> Answer:
        """Carry it out."""
        arguments = self.arguments(way)
        if isinstance(arguments, Mapping):
            return driver.begin(name, **arguments)
        return driver.begin(name, *arguments)


# The states they begin in -------------------------------------------------------------------------
# Each returns why it could not be reached, or None.


def stopped(driver: Driver, _way: Way) -> Refusal | None:
    driver.stop()
    driver.run_until(lambda: driver.now.stop is StopState.STOPPED)
    return None


def without_power(driver: Driver, _way: Way) -> Refusal | None:
    if isinstance(answer := driver.begin("motors.disable"), Refusal):
        return answer
    driver.run_until(lambda: True not in driver.now.enabled and driver.now.busy is None)
    return None


def running(driver: Driver, way: Way) -> Refusal | None:
    if isinstance(answer := driver.begin("run.start", way.run), Refusal):
        return answer
    driver.run(0.3)
    return None


def run_paused(driver: Driver, way: Way) -> Refusal | None:
    if (refusal := running(driver, way)) is not None:
        return refusal
    answer = driver.begin("run.pause")
    driver.run(0.3)
    return answer if isinstance(answer, Refusal) else None


def replaying(driver: Driver, way: Way) -> Refusal | None:
    if isinstance(answer := driver.begin("replay.start", Replay(way.recording)), Refusal):
        return answer
    driver.run(0.6)
    return None


def replay_paused(driver: Driver, way: Way) -> Refusal | None:
    if (refusal := replaying(driver, way)) is not None:
        return refusal
    answer = driver.begin("replay.pause")
    driver.run(0.3)
    return answer if isinstance(answer, Refusal) else None


def motion_under_way(driver: Driver, way: Way) -> Refusal | None:
    if isinstance(answer := driver.begin("motion.send", way.end_deg), Refusal):
        return answer
    driver.run(0.2)
    return None


def motion_paused(driver: Driver, way: Way) -> Refusal | None:
    if (refusal := motion_under_way(driver, way)) is not None:
        return refusal
    answer = driver.begin("planned.command", TrajectoryCommand.PAUSE)
    driver.run(0.3)
    return answer if isinstance(answer, Refusal) else None


def taught(driver: Driver, way: Way) -> Refusal | None:
    """A hand has led the arm towards the way's end and back, and the arm has recorded it."""
    answer = driver.begin("teaching.command", TeachingState.START_RECORDING)
    if isinstance(answer, Refusal):
        return answer
    driver.run(0.2)
    guiding = driver.arm.hand_guiding
    for place in (way.end_deg, way.start_deg):
        guiding.lead_to(place, speed_deg_s=90.0)
        driver.run(0.6)
    answer = driver.begin("teaching.command", TeachingState.STOP_RECORDING)
    driver.run(0.3)
    return answer if isinstance(answer, Refusal) else None


def in_doubt(driver: Driver, _way: Way) -> Refusal | None:
    driver.run(1.5)
    driver.arm.lost_reference.begin(4)
    driver.run_until(lambda: bool(driver.now.reference.doubtful))
    driver.run(0.5)
    return None


def checking(driver: Driver, _way: Way) -> Refusal | None:
    answer = driver.begin("reference.begin")
    driver.look_at_arm({})
    return answer if isinstance(answer, Refusal) else None


def checked(driver: Driver, _way: Way) -> Refusal | None:
    answer = driver.begin("reference.begin")
    driver.look_at_arm(dict.fromkeys(range(1, 7), 0.0))
    return answer if isinstance(answer, Refusal) else None


def room_known(driver: Driver, _way: Way) -> Refusal | None:
    driver.look_for_room(SWING_DEG)
    return None


def in_a_cell(driver: Driver, _way: Way) -> Refusal | None:
    answer = driver.begin("cell.take", Cell("bench", held_objects=(HeldObject("cube"),)))
    return answer if isinstance(answer, Refusal) else None


def log_begun(driver: Driver, _way: Way) -> Refusal | None:
    driver.begin_log()
    return None


def episode_begun(driver: Driver, _way: Way) -> Refusal | None:
    driver.begin_log()
    answer = driver.begin("episode.begin")
    return answer if isinstance(answer, Refusal) else None


def cell_unconfirmed(driver: Driver, _way: Way) -> Refusal | None:
    tool = Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0))
    answer = driver.begin("cell.take", Cell("bench", (tool,), "pen"))
    driver.unconfirm_cell()
    return answer if isinstance(answer, Refusal) else None


def beyond_its_limit(driver: Driver, way: Way) -> Refusal | None:
    """Joint 1 is found 5° beyond its limit."""
    limit = {Parameter("max_angle_deg", 1): round(way.start_deg[0] - 5.0, 1)}
    answer = driver.begin("settings.save", limit)
    driver.run_until(lambda: driver.now.outside != "")
    return answer if isinstance(answer, Refusal) else None


# The operations -----------------------------------------------------------------------------------


def _always(*arguments: Any) -> Callable[[Way], Sequence[Any]]:
    return lambda _way: arguments


SWING_DEG: Final = 10.0
"""How far each joint swings in the inspection."""
DRIVEN: Final = 1
"""The joint that the reference check drives to its mark, at 0°."""


def _tip_at_mark(way: Way) -> Array:
    angles = list(way.start_deg)
    angles[DRIVEN - 1] = 0.0
    return tip_of(angles)


_JOINTS: Final = frozenset({0x155, 0x156, 0x157})
_POSE: Final = frozenset({0x152, 0x153, 0x154})
_WORD: Final = frozenset({0x151})
_GRIPPER: Final = frozenset({0x159})
_GOES_ON: Final = frozenset({0x150})

ENTRIES: Final[Mapping[str, Entry]] = {
    # what leads the arm somewhere
    "motion.step": Entry(
        lambda way: (way.joint, way.delta_deg), _JOINTS | _WORD, tip_mm=_tip_at_end
    ),
    "motion.send": Entry(lambda way: (way.end_deg,), _JOINTS | _WORD, tip_mm=_tip_at_end),
    "motion.come_inside": Entry(_always(), _JOINTS | _WORD, before=beyond_its_limit),
    "motion.home": Entry(_always(), _JOINTS | _WORD, tip_mm=lambda _way: tip_of((0.0,) * 6)),
    "tool.move": Entry(
        lambda way: (way.end_pose, MoveMode.MOVE_P), _POSE | _WORD, tip_mm=_tip_at_end
    ),
    "tool.step": Entry(
        lambda way: (way.axis, way.delta_mm, JogFrame.BASE), _POSE | _WORD, tip_mm=_tip_along
    ),
    "tool.arc": Entry(lambda way: way.arc, _POSE | _WORD | {0x158}, tip_mm=_tip_along),
    "jog.begin": Entry(
        lambda way: (JointJog(way.joint, 1 if way.delta_deg > 0 else -1),),
        _JOINTS | _WORD,
        tip_mm=_tip_at_end,
    ),
    "run.start": Entry(
        lambda way: (way.run,), _JOINTS | _WORD, percent=RUN_PERCENT, tip_mm=_tip_at_end
    ),
    "run.go_on": Entry(_always(), _GOES_ON, run_paused, percent=RUN_PERCENT, tip_mm=_tip_at_end),
    # a replay is told at 100 %: how fast it goes lies in its targets, 50 a second
    "replay.start": Entry(
        lambda way: (Replay(way.recording),), _JOINTS | _WORD, percent=100, tip_mm=_tip_at_end
    ),
    "replay.go_on": Entry(_always(), _JOINTS, replay_paused, percent=100, tip_mm=_tip_at_end),
    # it goes nowhere: each joint comes back to where it was
    "inspection.start": Entry(_always(SWING_DEG), _JOINTS | _WORD, room_known, percent=100),
    "planned.command": Entry(
        _always(TrajectoryCommand.CONTINUE), _GOES_ON, motion_paused, tip_mm=_tip_at_end
    ),
    "teaching.command": Entry(
        _always(TeachingState.RUN_RECORDING), _GOES_ON, taught, tip_mm=_tip_at_end
    ),
    "reference.drive": Entry(
        _always(DRIVEN), _JOINTS | _WORD, checking, percent=5, tip_mm=_tip_at_mark
    ),
    "gripper.move": Entry(_always(40.0, 1.0), _GRIPPER),
    # what tells it how
    "motion.set_speed": Entry(_always(50), _WORD, percent=50),
    "mounting.tell": Entry(_always(Mounting.LEVEL), _WORD),
    "gripper.enable": Entry(_always(1.0), _GRIPPER),
    # what sends no motion frame
    "gripper.disable": Entry(_always()),
    "gripper.clear_error": Entry(_always()),
    "gripper.set_zero": Entry(_always()),
    "run.pause": Entry(_always(), before=running),
    "replay.pause": Entry(_always(), before=replaying),
    "motors.enable": Entry(_always(), before=without_power),
    "motors.disable": Entry(_always()),
    "motors.resume": Entry(_always(), before=stopped),
    "joints.set_zero": Entry(_always(1)),
    "joints.clear_error": Entry(_always(2)),
    "lamps.set": Entry(_always(1, 2, 3, 4, 5)),
    "recorder.start": Entry(_always()),
    "episode.begin": Entry(_always("stack the cubes"), before=log_begun),
    "episode.end": Entry(_always(), before=episode_begun),
    "episode.discard": Entry(_always(), before=episode_begun),
    "end_load.set": Entry(_always(EndLoad.FULL)),
    "end_load.report": Entry(lambda _way: {"on": True}),
    "linkage.set": Entry(_always(LinkageRole.MOTION_OUTPUT)),
    "settings.read": Entry(_always([Batch(Group.END_LIMITS)])),
    "settings.save": Entry(_always({Parameter("max_angle_deg", 2): 100.0})),
    "settings.reset_end_limits": Entry(_always()),
    "settings.reset_joint_limits": Entry(_always()),
    "reference.allow": Entry(_always(), before=in_doubt),
    "reference.begin": Entry(_always()),
    "reference.finish": Entry(_always(), before=checked),
    "reference.teach": Entry(_always()),
    "cell.take": Entry(_always(Cell("bench"))),
    "cell.choose": Entry(_always("bench"), before=in_a_cell),
    "cell.change": Entry(_always(Cell("bench", (Tool("pen"),), "pen")), before=in_a_cell),
    "cell.confirm": Entry(_always(), before=cell_unconfirmed),
    "cell.delete": Entry(_always(), before=in_a_cell),
    "cell.rename": Entry(_always("stand"), before=in_a_cell),
    "cell.hold": Entry(_always("cube"), before=in_a_cell),
}
"""Every operation that the registry has."""

DRIVE: Final = tuple(name for name, entry in ENTRIES.items() if entry.frames)
"""Those that send a motion frame."""
STAND: Final = tuple(name for name, entry in ENTRIES.items() if not entry.frames)
"""Those that send none."""
LEAD: Final = tuple(name for name, entry in ENTRIES.items() if entry.tip_mm is not None)
"""Those that lead the arm somewhere."""
