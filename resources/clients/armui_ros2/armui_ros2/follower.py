"""Follows trajectories as streams of targets, under the lease: one at a time, the newest."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import armui_client
from armui_ros2.trajectory import Code, Path, Point, Tolerances, Unfit, limits_of

if TYPE_CHECKING:
    from armui_ros2.link import Link

SILENT_S: Final = 0.5
"""Angles older than this are not known: a trajectory ends."""
SETTLES_S: Final = 0.3
"""The goal is held for this time at least."""
_ENTERS_S: Final = 10.0
_CLOSES_S: Final = 5.0


@dataclass(frozen=True)
class Wishes:
    """How trajectories are followed.

    Attributes:
        name: What the operator reads.
        asks: True if a trajectory asks for the lease where none is held.
        max_speed_percent: The highest speed that is asked for.
        stream_hz: How many targets a second.
        start_within_deg: How far from the arm a trajectory may begin.
        tolerances: Where it names none itself.
    """

    name: str
    asks: bool
    max_speed_percent: int
    stream_hz: float
    start_within_deg: float
    tolerances: Tolerances


@dataclass(frozen=True)
class Ended:
    """How a trajectory has ended.

    Attributes:
        code: As ``FollowJointTrajectory`` counts it.
        text: In words.
        reason: The id of armui's reason, "" if it has none.
    """

    code: Code
    text: str
    reason: str = ""


CANCELLED: Final = Ended(Code.SUCCESSFUL, "Cancelled by its sender.")
"""As its sender wishes: the arm comes to rest where it is."""


class Job:
    """A trajectory to be followed.

    Attributes:
        points: Its points.
        tolerances: Its tolerances.
        came_s: When it came, monotonic.
        ended: How it has ended, or ``None``.
        over: Is set when it has.
        desired_deg: Where it was at the newest measured angles, while it is followed.
        measured_deg: These.
    """

    def __init__(
        self,
        points: Sequence[Point],
        tolerances: Tolerances,
        on_end: Callable[[Job, Ended], None],
    ) -> None:
        self.points = points
        self.tolerances = tolerances
        self.came_s = time.monotonic()
        self.ended: Ended | None = None
        self.over = threading.Event()
        self.desired_deg: tuple[float, ...] = ()
        self.measured_deg: tuple[float, ...] = ()
        self._on_end = on_end
        self._ending = threading.Lock()

    def end(self, ended: Ended) -> None:
        """End it, if it has not ended."""
        with self._ending:
            if self.ended is not None:
                return
            self.ended = ended
        self._on_end(self, ended)
        self.over.set()


class Follower:
    """Follows the newest trajectory, in a thread of its own.

    Args:
        link: The arm.
        wishes: How.
        on_change: Is called with what it does now, in words, from any thread.
    """

    def __init__(self, link: Link, wishes: Wishes, on_change: Callable[[str], None]) -> None:
        self._link = link
        self._wishes = wishes
        self._on_change = on_change
        self._lease: armui_client.Lease | None = None
        self._asking = threading.Lock()
        self._given_back = False
        self._news = threading.Condition()
        self._newest: Job | None = None
        self._target_deg: tuple[float, ...] | None = None
        self._over = False
        self._thread = threading.Thread(target=self._run, name="armui-follower", daemon=True)

    def start(self) -> None:
        """Begin to wait for trajectories."""
        self._thread.start()

    def close(self) -> None:
        """End what is followed, and give the arm back."""
        with self._news:
            self._over = True
            self._news.notify_all()
        self._cancel("The node ends.")
        if self._thread.is_alive():
            self._thread.join(_CLOSES_S)
        self.release()

    # The lease: may wait for the operator -------------------------------------------------------

    @property
    def held(self) -> bool:
        """True while the lease is held."""
        return self._lease is not None and self._lease.held

    @property
    def asking(self) -> bool:
        """True while the operator is asked for it."""
        return self._asking.locked()

    def take(self, *, asks: bool = True) -> int:
        """Ask the operator for the arm, unless it is held; return the speed he grants, in percent.

        Args:
            asks: False to ask nobody.

        Raises:
            ArmuiError: It was not granted.
        """
        with self._asking:
            arm, lease = self._link.arm(), self._lease
            if lease is not None and lease.held:
                return lease.max_speed_percent
            if not asks:
                raise _not_asked()
            self._given_back = False
            self._on_change("Asks the operator for the arm")
            wanted = self._wishes.max_speed_percent
            lease = arm.lease("trajectories of ROS", max_speed_percent=wanted)
            try:
                lease.take()
                if self._given_back:
                    raise armui_client.Refused("The arm was given back while it was asked for.")
                # as fast as was granted: the check of a trajectory counts on it
                arm.set_speed(lease.max_speed_percent)
            except armui_client.ArmuiError as error:
                lease.release()
                self._on_change(f"Has no lease of the arm: {error}")
                raise
            self._lease = lease
            self._on_change(
                f"Has the lease of the arm, at {lease.max_speed_percent} % of its speed"
            )
            return lease.max_speed_percent

    def release(self) -> None:
        """Give the arm back; what is followed ends."""
        self._given_back = True
        self._cancel("The lease was given back.")
        lease = self._lease
        if lease is not None:
            lease.release()
            self._on_change("Has given the arm back")

    # Trajectories -------------------------------------------------------------------------------

    def follow(self, job: Job) -> None:
        """Follow a trajectory from now on, instead of the one before; it ends at once if it can't.

        One that can't be followed leaves the one before as it is.
        """
        try:
            self._path(job, 100)
        except (Unfit, armui_client.ArmuiError) as error:
            job.end(_refused(error))
            return
        if not self._wishes.asks and not self.held:
            job.end(_refused(_not_asked()))
            return
        if not self._thread.is_alive():
            text = "The node has failed, and follows nothing: see its log."
            job.end(Ended(Code.INVALID_GOAL, text))
            return
        with self._news:
            before, self._newest = self._newest, job
            self._news.notify_all()
        if before is not None:
            before.end(Ended(Code.INVALID_GOAL, "Replaced by a newer trajectory."))

    def _cancel(self, text: str) -> None:
        with self._news:
            job = self._newest
        if job is not None:
            job.end(Ended(Code.INVALID_GOAL, text))

    def _path(self, job: Job, percent: float) -> Path:
        """Return the path from where the arm is, or is sent to.

        Raises:
            Unfit: There is none.
            ArmuiError: armui is not there, or its arm is silent.
        """
        arm, within_deg = self._link.arm(), self._wishes.start_within_deg
        # anew: another arm may have come
        hello = arm.call("hello", client=self._wishes.name, protocol=armui_client.PROTOCOL)
        from_deg = self._target_deg or self._link.angles_deg(SILENT_S)[0]
        return Path(job.points, from_deg, limits_of(hello, percent), within_deg)

    # The thread ---------------------------------------------------------------------------------

    def _run(self) -> None:
        while job := self._next():
            self._follow_all(job)
            self._target_deg = None

    def _follow_all(self, job: Job) -> None:
        """Follow a trajectory, and those that replace it, in one stream."""
        newest: Job | None = job
        try:
            with self._link.arm().stream(self._wishes.stream_hz) as stream:
                while newest is not None:
                    job = newest
                    self._follow(job, stream)
                    newest = self._another(job)
        except armui_client.ArmuiError as error:
            job.end(_refused(error))

    def _next(self) -> Job | None:
        """Wait for a trajectory; ``None``: there will be no more."""
        with self._news:
            self._news.wait_for(lambda: self._over or self._waits() is not None)
            return None if self._over else self._waits()

    def _another(self, job: Job) -> Job | None:
        """Return the trajectory that has replaced one, or ``None``."""
        with self._news:
            return None if self._newest is job else self._waits()

    def _waits(self) -> Job | None:
        job = self._newest
        return None if job is None or job.ended is not None else job

    def _follow(self, job: Job, stream: armui_client.Stream) -> None:
        """Follow a trajectory to its end."""
        try:
            percent = self.take(asks=self._wishes.asks)
            path = self._path(job, percent)
            self._enter(job, path)
            self._along(job, path, stream)
        except Unfit as error:
            job.end(Ended(error.code, str(error)))
        except armui_client.ArmuiError as error:
            job.end(_refused(error))

    def _enter(self, job: Job, path: Path) -> None:
        """Move an arm that rests a little beyond its limits within them, to the path's beginning.

        No target of a stream is followed from there.
        """
        now_deg = self._link.angles_deg(SILENT_S)[0]
        if job.ended is None and path.beyond(now_deg):
            self._on_change("Moves the arm within its limits, to where the trajectory begins")
            self._link.arm().move_joints(path.at(0.0), timeout_s=_ENTERS_S)

    def _along(self, job: Job, path: Path, stream: armui_client.Stream) -> None:
        """Send targets until the arm is there, or the trajectory has ended otherwise.

        armui's path follows an even motion twice its smoothing time behind, so each target is
        taken so much later on the trajectory; one period for the wait until it is sent.
        """
        smoothing_s = self._link.arm().hello["rates"]["stream_smoothing_s"]
        ahead_s = 2.0 * smoothing_s + 1.0 / self._wishes.stream_hz
        tolerances, began_s = job.tolerances, time.monotonic()
        while job.ended is None:
            now_s = time.monotonic() - began_s
            self._target_deg = path.at(now_s + ahead_s)
            stream.target(self._target_deg)
            if not job.desired_deg:
                waited_ms = 1000.0 * (time.monotonic() - job.came_s)
                text = f"Follows a trajectory of {path.duration_s:.2f} s"
                self._on_change(f"{text}; the first target went {waited_ms:.0f} ms after it came")
            measured_deg, at_s = self._link.angles_deg(SILENT_S)
            job.desired_deg = path.at(at_s - began_s)
            job.measured_deg = measured_deg
            if now_s <= path.duration_s:
                astray = tolerances.astray(measured_deg, job.desired_deg)
                if astray is not None:
                    text = f"The arm does not follow: {astray}. Is it slowed?"
                    job.end(Ended(Code.PATH_TOLERANCE_VIOLATED, text))
            elif now_s >= path.duration_s + SETTLES_S:
                off = tolerances.off_goal(measured_deg, path.goal_deg)
                if off is None:
                    job.end(Ended(Code.SUCCESSFUL, "The arm is there."))
                elif now_s > path.duration_s + max(SETTLES_S, tolerances.goal_time_s):
                    text = f"The arm has not come to the goal: {off}."
                    job.end(Ended(Code.GOAL_TOLERANCE_VIOLATED, text))


def _not_asked() -> armui_client.Refused:
    text = "The arm was not asked for: call the service lease first."
    return armui_client.Refused(text, reason="lease_not_held")


def _refused(error: Unfit | armui_client.ArmuiError) -> Ended:
    if isinstance(error, Unfit):
        return Ended(error.code, str(error))
    return Ended(Code.INVALID_GOAL, str(error), error.reason)


def usual_tolerances(path_deg: float, goal_deg: float, goal_time_s: float) -> Tolerances:
    """Return the same tolerances for all joints; 0 of a path: it is not looked at."""
    return Tolerances((path_deg or math.inf,) * 6, (goal_deg,) * 6, goal_time_s)
