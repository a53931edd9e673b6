"""The arm behind armui: what it tells, and what it can be asked."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, cast

from armui_client.connection import ANSWER_S, PROTOCOL, Connection, socket_path
from armui_client.errors import ArmuiError, Invalid, Stale, Timeout
from armui_client.lease import OPERATOR_S, Lease
from armui_client.operation import MOTION_S, Operation
from armui_client.stream import Stream
from armui_client.values import (
    Checked,
    Event,
    Listed,
    Offered,
    Plan,
    Six,
    State,
    as_six,
    checked_of,
    fields_of,
    plan_of,
    six,
    state_of,
)

_AGAIN_S: Final = 0.05
_WITHOUT_LEASE: Final = frozenset(
    {
        "episode.begin",
        "episode.discard",
        "episode.end",
        "events.subscribe",
        "events.unsubscribe",
        "halt",
        "hello",
        "kinematics.fk",
        "kinematics.ik",
        "lease.request",
        "operations.list",
        "ping",
        "state.get",
        "state.subscribe",
        "state.unsubscribe",
        "stop",
        "trajectory.check",
        "trajectory.get",
        "trajectory.list",
        "trajectory.plan",
    }
)


def connect(
    name: str = "", *, path: str | os.PathLike[str] | None = None, timeout_s: float = ANSWER_S
) -> Arm:
    """Connect to armui on this computer; use the result in a ``with``.

    Args:
        name: What the operator reads, at most 80 characters; by default the script's name.
        path: The socket; by default :func:`socket_path`.
        timeout_s: For answers that need no operator.

    Raises:
        Disconnected: armui does not run, or its interface is off.
        Invalid: It speaks another version of the protocol, or does not take the name.
    """
    return Arm(name or Path(sys.argv[0]).name or "python", Path(path or socket_path()), timeout_s)


class Arm:
    """An arm behind armui; :func:`connect` makes one.

    Attributes:
        hello: What armui said first: ``program``, ``version``, ``arm``, ``limits``, ``rates``.
    """

    def __init__(self, name: str, path: Path, timeout_s: float) -> None:
        self._timeout_s = timeout_s
        self._connection = Connection(path)
        try:
            hello = self._ask("hello", {"client": name, "protocol": PROTOCOL})
        except BaseException:
            self._connection.close()
            raise
        self.hello: Mapping[str, Any] = MappingProxyType(hello)

    def __enter__(self) -> Arm:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the connection; a lease ends with it, and its motion is halted with power on."""
        self._connection.close()

    @property
    def is_connected(self) -> bool:
        """True while armui answers."""
        return self._connection.heard.gone is None

    # What is measured -------------------------------------------------------------------------

    def state(self, fields: Sequence[str] | None = None) -> State:
        """Return the measured state, each value with its age.

        Args:
            fields: Names of fields of :class:`State`; all by default.
        """
        return state_of(self._ask("state.get", fields_of(fields)))

    def is_enabled(self, timeout_s: float = ANSWER_S) -> bool:
        """Return whether all six motors are on, once the arm has told so within the last second.

        Raises:
            Timeout: It has not.
        """
        until_s = time.monotonic() + timeout_s
        while time.monotonic() <= until_s:
            with contextlib.suppress(Stale):
                return all(self.state(["enabled"]).enabled.get(max_age_s=1.0))
            time.sleep(_AGAIN_S)
        raise Timeout(f"The arm has not told whether its motors are on within {timeout_s:g} s.")

    def subscribe(
        self,
        rate_hz: float = 10.0,
        fields: Sequence[str] | None = None,
        *,
        timeout_s: float = ANSWER_S,
    ) -> Iterator[State]:
        """Yield the newest state at a rate, until the loop is left; one such loop at a time.

        Args:
            rate_hz: Up to 200. Who takes longer for one gets the newest next, not the missed ones.
            fields: Names of fields of :class:`State`; all by default.
            timeout_s: :class:`Timeout` is raised if none comes for this time.
        """
        connection, heard = self._connection, self._connection.heard
        with connection.news:
            heard.state = None
        self._ask("state.subscribe", {"rate_hz": rate_hz, **fields_of(fields)})

        def states() -> Iterator[State]:
            try:
                while True:
                    with connection.news:
                        text = "No state has come"
                        connection.wait_for(lambda: heard.state is not None, timeout_s, text)
                        told, heard.state = heard.state, None
                    if told is not None:
                        yield state_of(told)
            finally:
                with contextlib.suppress(ArmuiError):
                    self._ask("state.unsubscribe", {})

        return states()

    def events(self, *, timeout_s: float | None = None) -> Iterator[Event]:
        """Yield armui's events from now on, until the loop is left; one such loop at a time.

        Args:
            timeout_s: :class:`Timeout` is raised if none comes for this time; never by default.
        """
        connection, heard = self._connection, self._connection.heard
        with connection.news:
            heard.events.clear()
        self._ask("events.subscribe", {})

        def events() -> Iterator[Event]:
            try:
                while True:
                    with connection.news:
                        connection.wait_for(lambda: bool(heard.events), timeout_s, "No event came")
                        told = heard.events.popleft()
                    yield Event(**told)
            finally:
                with contextlib.suppress(ArmuiError):
                    self._ask("events.unsubscribe", {})

        return events()

    def operations(self) -> list[Offered]:
        """Return the operations, each with what speaks against it now."""
        return [
            Offered(**{**each, "why_not": each["why_not"] and each["why_not"]["text"]})
            for each in self._ask("operations.list", {})
        ]

    def fk(self, joints_deg: Sequence[float]) -> Six:
        """Return the pose of the flange, without tool, at six angles: mm and degrees."""
        params = {"joints_deg": six(joints_deg)}
        found = self._ask("kinematics.fk", params)
        return as_six(found["flange_pose_mm_deg"])

    def ik(
        self, flange_pose_mm_deg: Sequence[float], near_deg: Sequence[float] | None = None
    ) -> list[Six]:
        """Return the angles with which the flange has a pose, the nearest first.

        Args:
            flange_pose_mm_deg: The pose.
            near_deg: Six angles that the first shall be near to; by default the measured ones.

        Returns:
            Only solutions within the joints' limits; none: the pose is out of reach.
        """
        params: dict[str, Any] = {"flange_pose_mm_deg": six(flange_pose_mm_deg)}
        if near_deg is not None:
            params["near_deg"] = six(near_deg)
        found = self._ask("kinematics.ik", params)
        return [as_six(each) for each in found["joints_deg"]]

    # The operator's library -------------------------------------------------------------------

    def trajectories(self) -> list[Listed]:
        """Return what is in the operator's library: trajectories and recordings."""
        return [
            Listed(**{**each, "damage": each["damage"] and each["damage"]["text"]})
            for each in self._ask("trajectory.list", {})
        ]

    def trajectory(self, name: str, *, first_row: int = 1, rows: int = 1000) -> dict[str, Any]:
        """Return a trajectory or recording, in the form of its file.

        Args:
            name: Its name.
            first_row: The first of the points or samples that are wanted, from 1.
            rows: How many, at most 1,000; ``count`` says how many there are.

        Raises:
            Refused: There is none of this name, or it is damaged.
        """
        params = {"name": name, "first_row": first_row, "rows": rows}
        return cast("dict[str, Any]", self._ask("trajectory.get", params))

    def check(self, trajectory: str | Sequence[Mapping[str, Any]]) -> Checked:
        """Return what speaks against a run from where the arm stands, as the operator sees it.

        Args:
            trajectory: A name of the library, or points as :meth:`trajectory` returns them; at most
                1,000, or 30,000 samples of a recording; points of your own at most 64 KiB of JSON.

        Raises:
            Refused: There is none of this name, it has more points, or another is being checked.
            Invalid: A point is none.
        """
        return checked_of(self._connection.ask("trajectory.check", _named(trajectory), OPERATOR_S))

    def plan(self, trajectory: str | Sequence[Mapping[str, Any]]) -> Plan:
        """Return the same as :meth:`check`, with the path and the times of each point."""
        return plan_of(self._connection.ask("trajectory.plan", _named(trajectory), OPERATOR_S))

    # Stopping: needs no lease -----------------------------------------------------------------

    def stop(self) -> None:
        """Stop the arm at once (emergency stop). When that is released, the arm drops."""
        self._ask("stop", {})

    def halt(self) -> None:
        """End any motion, with power on. It ends the lease, too."""
        self._ask("halt", {})

    # Moving: needs the lease ------------------------------------------------------------------

    def lease(
        self,
        purpose: str,
        *,
        max_speed_percent: int = 100,
        moves: bool = True,
        timeout_s: float = OPERATOR_S,
    ) -> Lease:
        """Return the lease, to be taken by ``with``: the operator is asked, by a held press.

        Args:
            purpose: What the operator reads.
            max_speed_percent: The highest speed that is wanted; he may grant less.
            moves: False if nothing shall move, and only settings are wanted.
            timeout_s: For his answer; armui refuses after 30 s.
        """
        return Lease(self._connection, purpose, max_speed_percent, moves=moves, timeout_s=timeout_s)

    def move_joints(
        self, angles_deg: Sequence[float], *, wait: bool = True, timeout_s: float | None = MOTION_S
    ) -> Operation:
        """Move the joints to six angles (MOVE J).

        This and all motions below:

        Args:
            angles_deg: The target.
            wait: True to wait for the end; False to return at once: :meth:`Operation.wait`.
            timeout_s: For the end.

        Raises:
            Refused: Something speaks against it; ``reason`` and ``figures`` say what.
            Failed: It did not come to its end.
            LeaseLost: The lease has ended.
            Timeout: It still goes on.
        """
        params = {"angles_deg": six(angles_deg)}
        return self._operation("motion.send", params, wait=wait, timeout_s=timeout_s)

    def move_pose(
        self,
        tool_pose_mm_deg: Sequence[float],
        *,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Move the tool centre point to a pose, by the nearest angles (MOVE P)."""
        params = {"target": six(tool_pose_mm_deg), "move_mode": "move_p"}
        return self._operation("tool.move", params, wait=wait, timeout_s=timeout_s)

    def move_line(
        self,
        tool_pose_mm_deg: Sequence[float],
        *,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Move the tool centre point to a pose on a straight line (MOVE L)."""
        params = {"target": six(tool_pose_mm_deg), "move_mode": "move_l"}
        return self._operation("tool.move", params, wait=wait, timeout_s=timeout_s)

    def arc(
        self,
        start_mm_deg: Sequence[float],
        middle_mm_deg: Sequence[float],
        end_mm_deg: Sequence[float],
        *,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Move the tool centre point on the arc through three poses (MOVE C).

        The arm must stand at the first of them.
        """
        params = {"points": [six(each) for each in (start_mm_deg, middle_mm_deg, end_mm_deg)]}
        return self._operation("tool.arc", params, wait=wait, timeout_s=timeout_s)

    def run(
        self,
        name: str,
        *,
        cycles: int = 1,
        first_row: int = 1,
        wait: bool = True,
        timeout_s: float | None = None,
    ) -> Operation:
        """Run a trajectory of the operator's library, checked as by his own press.

        What the check warns of he has to accept by a held press; one that has never run begins
        slowly.

        Args:
            name: Its name.
            cycles: How often; 0: until it is ended.
            first_row: The row to begin with, from 1.
            wait: See :meth:`move_joints`.
            timeout_s: For the end.
        """
        params = {"name": name, "cycles": cycles, "first_row": first_row}
        return self._operation("trajectory.run", params, wait=wait, timeout_s=timeout_s)

    def pause(self) -> Operation:
        """Have the run under way hold where it is."""
        return self._operation("run.pause", {})

    def go_on(self) -> Operation:
        """Go on with the run that is paused. The operator holds a button for it."""
        return self._operation("run.go_on", {})

    def end_motion(self) -> None:
        """End the run, or any motion of this client, with power on; the lease stays."""
        self.call("trajectory.stop")

    def home(self, *, wait: bool = True, timeout_s: float | None = MOTION_S) -> Operation:
        """Move all joints to 0°, the factory zeros."""
        return self._operation("motion.home", {}, wait=wait, timeout_s=timeout_s)

    def step_joint(
        self,
        joint: int,
        delta_deg: float,
        *,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Move one joint, 1 to 6, by some degrees."""
        params = {"joint": joint, "delta_deg": float(delta_deg)}
        return self._operation("motion.step", params, wait=wait, timeout_s=timeout_s)

    def step_tool(
        self,
        axis: int,
        amount: float,
        *,
        frame: str = "base",
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Move the tool along or about one axis.

        Args:
            axis: 0 to 2: x, y, z; 3 to 5: about x, y, z.
            amount: In mm or degrees.
            frame: "base" or "tool".
            wait: See :meth:`move_joints`.
            timeout_s: For the end.
        """
        params = {"axis": axis, "amount": float(amount), "frame": frame}
        return self._operation("tool.step", params, wait=wait, timeout_s=timeout_s)

    def gripper(
        self,
        opening_mm: float,
        *,
        torque_nm: float = 1.0,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Open or close the gripper, of an arm that tells its opening; held objects count as done.

        Raises:
            Invalid: This arm's gripper is moved by its angle: see :meth:`gripper_angle`.
        """
        told = self.state(["gripper_mm", "gripper_deg"])
        if told.gripper_mm.value is None and told.gripper_deg.value is not None:
            raise Invalid("This gripper tells its angle, not its opening: use gripper_angle().")
        params = {"travel": float(opening_mm), "effort": float(torque_nm)}
        return self._operation("gripper.move", params, wait=wait, timeout_s=timeout_s)

    def gripper_angle(
        self,
        angle_deg: float,
        *,
        effort: float = 1.0,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        """Turn a gripper that tells its angle.

        Args:
            angle_deg: The target.
            effort: Speed in rad/s (arms of generation 1), or torque in N·m.
            wait: See :meth:`move_joints`.
            timeout_s: For the end.

        Raises:
            Invalid: This arm's gripper is moved by its opening: see :meth:`gripper`.
        """
        told = self.state(["gripper_mm", "gripper_deg"])
        if told.gripper_deg.value is None and told.gripper_mm.value is not None:
            raise Invalid("This gripper tells its opening, not its angle: use gripper().")
        params = {"travel": float(angle_deg), "effort": float(effort)}
        return self._operation("gripper.move", params, wait=wait, timeout_s=timeout_s)

    def lamp(self, joint: int, red: int, green: int, blue: int, *, lamp: int = 255) -> Operation:
        """Set the colour of a joint's lamps, in parts of 0 to 255.

        Args:
            joint: 1 to 6.
            red: The colour's red part.
            green: Its green part.
            blue: Its blue part.
            lamp: One of them; 255: all.
        """
        color = {"red": red, "green": green, "blue": blue}
        return self._operation("lamps.set", {"joint": joint, "lamp": lamp, **color})

    def begin_episode(self, task: str | None = None) -> Operation:
        """Mark the beginning of an episode in armui's log; no lease is needed.

        Args:
            task: What is done in it, one line; by default that of the episode before.

        Returns:
            The episode, which is done when it is ended.
        """
        params = {} if task is None else {"task": task}
        return self._operation("episode.begin", params, wait=False)

    def end_episode(self) -> Operation:
        """Mark the end of the episode; no lease is needed."""
        return self._operation("episode.end", {})

    def discard_episode(self) -> Operation:
        """Leave the last episode out of datasets; no lease is needed."""
        return self._operation("episode.discard", {})

    def set_speed(self, percent: int) -> Operation:
        """Set the speed of all motions, at most what the operator has granted."""
        return self._operation("motion.set_speed", {"percent": percent})

    def enable(self, joint: int | None = None) -> Operation:
        """Switch the motors on, of one joint or all. The operator holds a button for it."""
        return self._operation("motors.enable", {} if joint is None else {"joint": joint})

    def disable(self, joint: int | None = None) -> Operation:
        """Switch the motors off: **the arm drops**. The operator holds a button for it."""
        return self._operation("motors.disable", {} if joint is None else {"joint": joint})

    def stream(self, rate_hz: float = 50.0, *, raises: bool = True) -> Stream:
        """Return a stream of targets, to be used in a ``with``.

        Args:
            rate_hz: 10 to 100; :meth:`Stream.target` keeps the pace.
            raises: False to have refusals returned instead of raised.
        """
        least, most = self.hello["rates"]["stream_hz"]
        if not least <= rate_hz <= most:
            raise Invalid(f"A stream has {least:g} to {most:g} targets a second, not {rate_hz:g}.")
        return Stream(self._connection, rate_hz, raises=raises)

    def call(
        self, method: str, *, wait: bool = True, timeout_s: float | None = MOTION_S, **args: Any
    ) -> Any:
        """Call any method or operation by its id; the lease that is held is named by itself.

        Args:
            method: As in ``armui api --schema`` and :meth:`operations`.
            wait: Of an operation, whether to wait for its end.
            timeout_s: For that end.
            **args: Its arguments.

        Returns:
            The result; of an operation its :class:`Operation`.
        """
        lease = None if method in _WITHOUT_LEASE else self._connection.lease()
        # a run is checked before the operator is asked
        most_s = 3 * OPERATOR_S if method == "trajectory.run" else OPERATOR_S
        result = self._connection.ask(method, args, most_s, lease=lease)
        if not isinstance(result, dict) or set(result) != {"number"}:
            return result
        begun = Operation(self._connection, method, result["number"], lease)
        return begun.wait(timeout_s) if wait else begun

    def _operation(
        self,
        id_: str,
        params: dict[str, Any],
        *,
        wait: bool = True,
        timeout_s: float | None = MOTION_S,
    ) -> Operation:
        found = self.call(id_, wait=wait, timeout_s=timeout_s, **params)
        return cast("Operation", found)

    def _ask(self, method: str, params: Mapping[str, Any]) -> Any:
        return self._connection.ask(method, params, self._timeout_s)


def _named(trajectory: str | Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return the argument that names a trajectory of the library, or gives points."""
    if isinstance(trajectory, str):
        return {"name": trajectory}
    return {"points": [dict(each) for each in trajectory]}
