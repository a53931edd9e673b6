"""The methods of the interface beside the operations, each declared once.

A declaration is a function without a body: its docstring says what the method does, its annotations
what it takes. The arguments of a call are read by them, and the schema is made from them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, Final

from armui.arm.figures import Range, check_arguments
from armui.interface.messages import CallError, Code, Json, english
from armui.interface.plain_forms import Choices, Longest, parameters_of, taken
from armui.interface.plain_forms import takes as taken_by
from armui.interface.state_report import FIELDS
from armui.trajectory.library.run_options import MOST_CYCLES

MOST_RATE_HZ: Final = 200.0
LEAST_RATE_HZ: Final = 0.1
NAME_LENGTH: Final = 80
MOST_POINTS: Final = 1000
"""A check of a client's has at most so many points or samples, and so has an answer with them."""

Angles = Annotated[Sequence[float], "°"]
FlangePose = Annotated[Sequence[float], "mm, °"]
"""The flange without tool, in the base: X, Y, Z in mm, RX, RY, RZ in degrees."""
Fields = Annotated[list[str], Choices(tuple(FIELDS))]
Percent = Annotated[int, Range(1, 100, "%")]
Name = Annotated[str, Longest(NAME_LENGTH)]
Row = Annotated[int, Range(1, 1_000_000_000)]
Rows = Annotated[int, Range(1, MOST_POINTS)]
Points = Annotated[list[dict[str, Any]], Longest(MOST_POINTS)]
Cycles = Annotated[int, Range(0, MOST_CYCLES)]


def _hello(client: Name, protocol: int) -> None:
    """Say who you are; the first call. Tells the arm, its limits and the rates."""


def _ping() -> None:
    """Nothing; any call keeps the lease, which ends after a second of silence."""


def _state(fields: Fields | None = None) -> None:
    """The measured state, each value with its age."""


def _subscribe(
    rate_hz: Annotated[float, Range(LEAST_RATE_HZ, MOST_RATE_HZ, "Hz")] = 10.0,
    fields: Fields | None = None,
) -> None:
    """The same as notifications, at a rate up to 200 Hz."""


def _unsubscribe() -> None:
    """No more of them."""


def _events() -> None:
    """The events of the program, as they come."""


def _operations() -> None:
    """The operations, each with what speaks against it now."""


def _request(purpose: str = "", *, moves: bool = True, max_speed_percent: Percent = 100) -> None:
    """Ask the operator for the arm; answers once he has decided."""


def _release() -> None:
    """Give the arm back; its motion ends."""


def _forward(joints_deg: Angles) -> None:
    """The pose of the flange at six angles."""


def _inverse(flange_pose_mm_deg: FlangePose, near_deg: Angles | None = None) -> None:
    """The angles of a pose, nearest to others first."""


def _stop() -> None:
    """The emergency stop. Needs no lease."""


def _halt() -> None:
    """End any motion with power on. Needs no lease."""


def _target(joints_deg: Angles | None = None, flange_pose_mm_deg: FlangePose | None = None) -> None:
    """The newest target of a stream, at 10 to 100 Hz: six angles, or a pose of the flange."""


def _stream_end() -> None:
    """End the stream."""


def _trajectories() -> None:
    """The trajectories and recordings of the library."""


def _trajectory(name: str, first_row: Row = 1, rows: Rows = MOST_POINTS) -> None:
    """A trajectory or recording with some of its points or samples, in the form of its file."""


def _check(name: str | None = None, points: Points | None = None) -> None:
    """What speaks against a trajectory of the library, or points, from where the arm stands."""


def _plan(name: str | None = None, points: Points | None = None) -> None:
    """The same, with the path and the times at the points' own speeds."""


def _run(name: str, cycles: Cycles = 1, first_row: Row = 1) -> None:
    """Run a trajectory of the library, checked as by the operator; answers once it has begun."""


def _end_motion() -> None:
    """End your run, or any motion of yours, with power on; the lease stays."""


_NUMBERS: Final = {"type": "array", "items": {"type": "number"}}
_ROWS: Final = {"type": "array", "items": _NUMBERS}
_OBJECT: Final = {"type": "object"}
_OBJECTS: Final = {"type": "array", "items": _OBJECT}
_TEXT: Final = {"type": "string"}
_WHOLE: Final = {"type": "integer"}
_CHECKED: Final = {"name": _TEXT, "errors": _WHOLE, "warnings": _WHOLE, "findings": _OBJECTS}
_STATE: Final = {"sequence": _WHOLE, "measured": _OBJECT}


@dataclass(frozen=True, slots=True)
class Method:
    """A method of the interface.

    Attributes:
        takes: Declares it.
        answers: The schemas of what its answer has, by name; or of the whole of another answer.
        leased: True if it needs the lease.
    """

    takes: Callable[..., None]
    answers: Mapping[str, Any] = field(default_factory=dict)
    leased: bool = False

    @property
    def summary(self) -> str:
        """What it does."""
        return self.takes.__doc__ or ""


METHODS: Final[Mapping[str, Method]] = {
    "hello": Method(
        _hello,
        {
            **dict.fromkeys(("program", "version"), _TEXT),
            **dict.fromkeys(("protocol", "client"), _WHOLE),
            **dict.fromkeys(("arm", "rates"), _OBJECT),
            "limits": _OBJECTS,
        },
    ),
    "ping": Method(_ping),
    "state.get": Method(_state, _STATE),
    "state.subscribe": Method(_subscribe),
    "state.unsubscribe": Method(_unsubscribe),
    "events.subscribe": Method(_events),
    "events.unsubscribe": Method(_unsubscribe),
    "operations.list": Method(_operations, _OBJECTS),
    "lease.request": Method(_request, {"lease": _WHOLE, "max_speed_percent": _WHOLE}),
    "lease.release": Method(_release, leased=True),
    "kinematics.fk": Method(_forward, {"flange_pose_mm_deg": _NUMBERS}),
    "kinematics.ik": Method(_inverse, {"joints_deg": _ROWS}),
    "stop": Method(_stop),
    "halt": Method(_halt),
    "stream.target": Method(_target, {"superseded": {"type": "boolean"}}, leased=True),
    "stream.end": Method(_stream_end, leased=True),
    "trajectory.list": Method(_trajectories, _OBJECTS),
    "trajectory.get": Method(_trajectory, {"kind": _TEXT, "count": _WHOLE, "name": _TEXT}),
    "trajectory.check": Method(_check, _CHECKED),
    "trajectory.plan": Method(
        _plan,
        {
            **_CHECKED,
            "expected_s": _NUMBERS,
            "times_s": _NUMBERS,
            "joints_deg": _ROWS,
            "rows": {"type": "array", "items": _WHOLE},
        },
    ),
    "trajectory.run": Method(_run, {"number": _WHOLE}, leased=True),
    "trajectory.stop": Method(_end_motion, leased=True),
}
"""The methods beside the operations."""


def read(method: str, params: Json) -> dict[str, Any]:
    """Return the arguments of a call, with the defaults of those it leaves out.

    Raises:
        CallError: One is missing, unknown, of another form, or out of its range.
    """
    takes = METHODS[method].takes
    _none, named = taken(takes, params)
    defaults = {each.name: each.default for each, _hint in parameters_of(takes)}
    found = {**defaults, **named}
    refusal = check_arguments(takes, found)
    if refusal is not None:
        raise CallError(Code.PARAMS, english(refusal.reason.source, refusal.params))
    return found


def schema_of(name: str, method: Method) -> Json:
    """Return a method as OpenRPC has it."""
    answers = method.answers
    whole = answers if "type" in answers else {"type": "object", "properties": answers}
    return {
        "name": name,
        "summary": method.summary,
        **taken_by(method.takes, leased=method.leased),
        "result": {"name": "result", "schema": whole},
    }
