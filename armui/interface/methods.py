"""The methods of the interface besides the operations, each declared once.

A declaration is a function without a body: its docstring says what the method does, and its
annotations give the parameters. Calls are read by these, and the schema is made from them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
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
"""The most points of a trajectory that is checked, and the most points or samples of an answer."""
MOST_SAMPLES: Final = 30_000
"""The most samples of a recording that is checked: five minutes at 100 Hz, checked in 0.2 s."""

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


_TEXT: Final = {"type": "string"}
_WHOLE: Final = {"type": "integer"}
_FLAG: Final = {"type": "boolean"}
_OBJECT: Final = {"type": "object"}
_OBJECTS: Final[Json] = {"type": "array", "items": _OBJECT}
_NUMBERS: Final = {"type": "array", "items": {"type": "number"}}
_ROWS: Final = {"type": "array", "items": _NUMBERS}
_HELLO: Final[Json] = {
    **dict.fromkeys(("program", "version"), _TEXT),
    **dict.fromkeys(("protocol", "client"), _WHOLE),
    **dict.fromkeys(("arm", "rates"), _OBJECT),
    "limits": _OBJECTS,
}
_CHECKED: Final = {"name": _TEXT, "errors": _WHOLE, "warnings": _WHOLE, "findings": _OBJECTS}
_PLANNED: Final = {"rows": _NUMBERS, **dict.fromkeys(("expected_s", "times_s"), _NUMBERS)}


@dataclass(frozen=True, slots=True)
class Method:
    """A method of the interface.

    Attributes:
        takes: The function that declares the method.
        answers: The schemas of the answer's parts by name; or of an answer without parts.
        leased: True if it needs the lease.
    """

    takes: Callable[..., None]
    answers: Mapping[str, Any]
    leased: bool

    @property
    def summary(self) -> str:
        """The docstring of the declaration."""
        return self.takes.__doc__ or ""


_METHODS: Final[dict[str, Method]] = {}
METHODS: Final[Mapping[str, Method]] = _METHODS
"""The methods beside the operations."""


def _method(
    name: str, answers: Mapping[str, Any] = MappingProxyType({}), *, leased: bool = False
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Declare a method with the schemas of its answer's parts by name, or of the whole."""

    def declare(takes: Callable[..., None]) -> Callable[..., None]:
        _METHODS[name] = Method(takes, answers, leased)
        return takes

    return declare


@_method("hello", _HELLO)
def _hello(client: Name, protocol: int) -> None:
    """Say who you are; the first call. Tells the arm, its limits and the rates."""


@_method("ping")
def _ping() -> None:
    """Nothing; any call keeps the lease, which ends after a second of silence."""


@_method("state.get", {"sequence": _WHOLE, "measured": _OBJECT})
def _state(fields: Fields | None = None) -> None:
    """The measured state, each value with its age."""


@_method("state.subscribe")
def _subscribe(
    rate_hz: Annotated[float, Range(LEAST_RATE_HZ, MOST_RATE_HZ, "Hz")] = 10.0,
    fields: Fields | None = None,
) -> None:
    """The same as notifications, at a rate up to 200 Hz."""


@_method("state.unsubscribe")
def _unsubscribe() -> None:
    """No more of them."""


@_method("events.subscribe")
def _events() -> None:
    """The events of the program, as they come."""


@_method("events.unsubscribe")
def _no_events() -> None:
    """No more of them."""


@_method("operations.list", _OBJECTS)
def _operations() -> None:
    """The operations, each with what speaks against it now."""


@_method("lease.request", {"lease": _WHOLE, "max_speed_percent": _WHOLE})
def _request(purpose: str = "", *, moves: bool = True, max_speed_percent: Percent = 100) -> None:
    """Ask the operator for the arm; answers once he has decided."""


@_method("lease.release", leased=True)
def _release() -> None:
    """Give the arm back; its motion ends."""


@_method("kinematics.fk", {"flange_pose_mm_deg": _NUMBERS})
def _forward(joints_deg: Angles) -> None:
    """The pose of the flange at six angles."""


@_method("kinematics.ik", {"joints_deg": _ROWS})
def _inverse(flange_pose_mm_deg: FlangePose, near_deg: Angles | None = None) -> None:
    """The angles of a pose, nearest to others first."""


@_method("stop")
def _stop() -> None:
    """The emergency stop. Needs no lease."""


@_method("halt")
def _halt() -> None:
    """End any motion with power on. Needs no lease."""


@_method("stream.target", {"superseded": _FLAG}, leased=True)
def _target(joints_deg: Angles | None = None, flange_pose_mm_deg: FlangePose | None = None) -> None:
    """The newest target of a stream, at 10 to 100 Hz: six angles, or a pose of the flange."""


@_method("stream.end", leased=True)
def _stream_end() -> None:
    """End the stream."""


@_method("trajectory.list", _OBJECTS)
def _trajectories() -> None:
    """The trajectories and recordings of the library."""


@_method("trajectory.get", {"name": _TEXT, "kind": _TEXT, "count": _WHOLE})
def _trajectory(name: str, first_row: Row = 1, rows: Rows = MOST_POINTS) -> None:
    """A trajectory or recording with some of its points or samples, in the form of its file."""


@_method("trajectory.check", _CHECKED)
def _check(name: str | None = None, points: Points | None = None) -> None:
    """What speaks against a trajectory of the library, or points, from where the arm stands."""


@_method("trajectory.plan", {**_CHECKED, **_PLANNED, "joints_deg": _ROWS})
def _plan(name: str | None = None, points: Points | None = None) -> None:
    """The same, with the path and the times at the points' own speeds."""


@_method("trajectory.run", {"number": _WHOLE}, leased=True)
def _run(name: str, cycles: Cycles = 1, first_row: Row = 1) -> None:
    """Run a trajectory of the library, checked as by the operator; answers once it has begun."""


@_method("trajectory.stop", leased=True)
def _end_motion() -> None:
    """End your run, or any motion of yours, with power on; the lease stays."""


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
    answers = dict(method.answers)
    whole = answers if "type" in answers else {"type": "object", "properties": answers}
    return {
        "name": name,
        "summary": method.summary,
        **taken_by(method.takes, leased=method.leased),
        "result": {"name": "result", "schema": whole},
    }
