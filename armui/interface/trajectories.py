"""The calls of clients about the library: trajectories by name, their checks, plans and runs.

The library's files are read in the thread for files, and checks run one after another in a process
for clients: the operator waits for neither. A run asks the same questions as a press
(:class:`armui.control.run.run_request.RunRequest`).
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.run.preflight import Checks, Preflight, Then, Works
from armui.control.run.run_request import RequestState, RunRequest
from armui.control.run.runner import Runner
from armui.interface.messages import CallError, Code, Json, english, figures, plain
from armui.interface.methods import MOST_POINTS, MOST_SAMPLES
from armui.trajectory.files import Content, TrajectoryFileError, json_file
from armui.trajectory.files.model import VERSIONS
from armui.trajectory.library.run_options import RunOptions, begin_percent
from armui.trajectory.library.store import LibraryError
from armui.trajectory.library.turns import take_turn
from armui.trajectory.planning.findings import Severity
from armui.trajectory.samples.recording import Recording

if TYPE_CHECKING:
    from PySide6.QtCore import QObject

    from armui.control.arm_controller import ArmController
    from armui.control.operations.started import Started
    from armui.trajectory.library.store import Library
    from armui.trajectory.planning.findings import Finding

CHECK_TOO_LONG = Reason(
    "check_too_long",
    "“{name}” has {count} points or samples; a program may have {maximum} checked and run. Have "
    "the operator run it.",
)
CHECK_BUSY = Reason("check_busy", "Something else is being checked for you. Wait for its answer.")

_LISTED: Final = ("name", "kind", "count", "note", "folder", "check")
_GIVEN: Final = "points"
"""The name under which points sent by a client are checked."""


class ClientRunner(Runner):
    """Starts the runs of clients.

    Args:
        controller: The controller that runs it.
        by_client: Calls what begins a motion as the client's.

    Attributes:
        begun: The record of the last run that has begun.
    """

    def __init__(
        self,
        controller: ArmController,
        by_client: Callable[[Callable[[], Any]], Any],
        parent: QObject,
    ) -> None:
        super().__init__(controller, parent)
        self._by_client = by_client
        self.begun: Started | None = None

    def begin(self, checked: Preflight, speed_percent: int) -> Started | Refusal:
        """Run a checked content; return the record of the run, or why it has not begun."""
        begun: Started | Refusal = self._by_client(
            # not above the speed in force, which `_by_client` has lowered to that of the lease
            lambda: super(ClientRunner, self).begin(
                checked, min(speed_percent, self._controller.motion.speed_percent)
            )
        )
        self.begun = None if isinstance(begun, Refusal) else begun
        return begun


@dataclass(eq=False, repr=False)
class Trajectories:
    """Answers the calls of clients about the library.

    Args:
        controller: Gives the arm's state.
        works: Runs the clients' checks, and reads the library's files.
        library: The library; only work on files touches it.
        runner: Starts the runs.
        clock: Monotonic time in seconds.
    """

    _controller: ArmController
    _works: Works
    _library: Library
    runner: ClientRunner
    _clock: Callable[[], float]
    _checked_for: set[int] = field(default_factory=set, init=False)

    def __post_init__(self) -> None:
        self._checks = Checks(self._controller, self._works)
        self._checks.get_ready()

    def ask(self, method: str, client: int, then: Then, **params: Any) -> None:
        """Answer a call; see the declarations of :mod:`armui.interface.methods`.

        Args:
            method: It needs no lease.
            client: The number of the client's connection.
            then: Takes the answer.
            **params: The arguments of the call.
        """
        if method == "trajectory.list":
            self._read(_listed, then)
        elif method == "trajectory.get":
            self._read(partial(_part, **params), then)
        elif (params["name"] is None) == (params["points"] is None):
            then(CallError(Code.PARAMS, "Wanted: “name” or “points”."))
        else:
            report = partial(_check_report, plans=method == "trajectory.plan")
            self._check(client, then, partial(_loaded, **params), report)

    def _check(
        self,
        client: int,
        then: Then,
        load: Callable[[Library], Any],
        report: Callable[[Preflight], Json],
    ) -> None:
        """Check something from the arm's present place; one check at a time for each client."""
        if client in self._checked_for:
            then(CHECK_BUSY())
            return
        self._checked_for.add(client)

        def answer(value: object) -> None:
            self._checked_for.discard(client)
            then(value)

        def on_checked(checked: Preflight | Refusal) -> None:
            answer(checked if isinstance(checked, Refusal) else report(checked))

        def on_read(found: tuple[Content, bool] | Refusal | CallError) -> None:
            if isinstance(found, Refusal | CallError):
                answer(found)
            else:
                self._checks.begin(found[0], RunOptions(), on_checked)

        self._read(load, on_read)

    def run(
        self,
        name: str,
        cycles: int,
        first_row: int,
        on_state: Callable[[RunRequest], object],
        unread: Callable[[Refusal], object],
    ) -> RunRequest:
        """Return the request to run a trajectory of the library; the caller begins it.

        Args:
            name: The trajectory.
            cycles: How often; 0: until it is ended.
            first_row: The row to begin with, from 1.
            on_state: Called with the request in each new state.
            unread: Takes why there is nothing to run; the request is given up then.
        """
        seen, options = False, RunOptions(cycles, first_row - 1)

        def read(then: Callable[[Content | None], object]) -> None:
            def on_read(found: tuple[Content, bool] | Refusal) -> None:
                nonlocal seen
                if isinstance(found, Refusal):
                    unread(found)
                    then(None)
                else:
                    content, seen = found
                    then(content)

            self._read(partial(_loaded, name=name), on_read)

        def note(request: RunRequest) -> None:
            if request.state is RequestState.UNDER_WAY:
                self._read(lambda library: library.note_run(name, options), lambda _done: None)
            on_state(request)

        return RunRequest(
            *(self._controller, self._checks, self.runner),
            read=read,
            options=lambda: options,
            speed_percent=lambda: begin_percent(
                self._controller.operating_state.speed_percent, seen=seen
            ),
            on_state=note,
            clock=self._clock,
        )

    def _read(self, work: Callable[[Library], Any], then: Then) -> None:
        self._works.begin_here(then, _alone, self._library, work)


def _alone(library: Library, work: Callable[[Library], Any]) -> object:
    """Return the result of work on the library, or the refusal or error that prevented it."""
    try:
        return take_turn(library, lambda: work(library))
    except (LibraryError, TrajectoryFileError) as error:
        return error.refusal
    except CallError as wrong:
        return wrong


def _listed(library: Library) -> list[Json]:
    return [
        {
            **{name: getattr(each, name) for name in _LISTED},
            "length_s": each.estimated_s if each.length_s is None else each.length_s,
            "modified": each.modified.isoformat(),
            "has_run": each.ran_with is not None,
            "damage": None if each.damage is None else plain(each.damage.refusal),
        }
        for each in library.entries()
        if each.kind != "draft"
    ]


def _part(library: Library, name: str, first_row: int, rows: int) -> Json:
    content, first, last = library.load(name), first_row - 1, first_row - 1 + rows
    if isinstance(content, Recording):
        kind, count = "recording", len(content.samples)
        content = replace(content, samples=content.samples[first:last])
    else:
        kind, count = "points", len(content.points)
        content = replace(content, points=content.points[first:last])
    whole = json.loads(json_file.write(content))
    return {"kind": kind, "count": count, **{k: whole[k] for k in whole if k != "format"}}


def _loaded(library: Library, name: str | None, points: Any = None) -> tuple[Content, bool]:
    """Return the content to be checked, and whether it has been run before.

    Raises:
        CallError: The points are invalid.
        LibraryError: There is nothing of that name, or too much of it.
        TrajectoryFileError: It is damaged.
    """
    if name is None:
        return _given(points), False
    content = library.load(name)
    count, most = (
        (len(content.samples), MOST_SAMPLES)
        if isinstance(content, Recording)
        else (len(content.points), MOST_POINTS)
    )
    if count > most:
        raise LibraryError(CHECK_TOO_LONG(name=name, count=count, maximum=most))
    seen = any(each.name == name and each.ran_with is not None for each in library.entries())
    return content, seen


def _given(points: Any) -> Content:
    lines = ",\n".join(map(json.dumps, points))
    head = f'"format": "armui trajectory", "version": {VERSIONS[-1]}, "name": "{_GIVEN}"'
    try:
        return json_file.read(f'{{{head}, "points": [{lines}]}}', _GIVEN)
    except TrajectoryFileError as error:
        why = english(error.refusal.reason.source, error.refusal.params)
        raise CallError(Code.PARAMS, f"“points”, row {error.line}: {why}") from None


def _check_report(checked: Preflight, *, plans: bool) -> Json:
    """Return the findings of a check in JSON and, if wanted, the planned path."""
    path, errors = checked.path, checked.errors
    report: Json = {
        "name": checked.content.name,
        "errors": errors,
        "warnings": len(checked.findings) - errors,
        "findings": [_finding(each) for each in checked.findings[:MOST_POINTS]],
        "length_s": checked.length_s,
    }
    if plans:
        kept = path.outline(MOST_POINTS // 2)
        report |= {
            "expected_s": [round(each, 3) for each in path.expected_s],
            "times_s": path.times_s[kept].round(3).tolist(),
            "joints_deg": path.joints_deg[kept].round(3).tolist(),
            "rows": (path.rows[kept] + 1).tolist(),
        }
    return report


def _finding(found: Finding) -> Mapping[str, object]:
    remedy = found.kind.remedy if found.at_s is None else ""
    return {
        "id": found.code,
        "severity": "error" if found.severity is Severity.ERROR else "warning",
        "text": english(f"{found.kind.source} {remedy}".rstrip(), found.params),
        "figures": figures(found.params),
        "row": None if found.row is None else found.row + 1,
        "of_approach": found.is_of_approach,
    }
