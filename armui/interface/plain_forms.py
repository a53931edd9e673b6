"""The arguments of operations in JSON, and their schema.

Everything comes from the annotations of the operations' methods. Those that take objects of the
program are left out, or have a method of their own (:data:`WITHOUT`).
"""

from __future__ import annotations

import enum
import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from types import UnionType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Final,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

from armui.arm.figures import CommandFigure, Count, Range, figures_of
from armui.control.motion.jog_path import MotionFrame
from armui.control.operations.operation import Consent, Operation
from armui.interface.messages import CallError, Code, Json
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode

if TYPE_CHECKING:
    from armui.control.operations.operation import BoundOperation

_OWN: Final = "the cell is the operator's"
_REFERENCE: Final = "the reference is checked by the operator, who watches the marks"
_HELD: Final = "the operator holds a button throughout"
WITHOUT: Final[Mapping[str, str]] = {
    "cell.change": _OWN,
    "cell.choose": _OWN,
    "cell.confirm": _OWN,
    "cell.delete": _OWN,
    "cell.hold": _OWN,
    "cell.rename": _OWN,
    "cell.take": _OWN,
    "jog.begin": "stream.target moves the arm by targets, and nobody holds a button",
    "linkage.set": "the arm would obey nobody any more",
    "motion.come_inside": _HELD,
    "planned.command": "halt ends a motion; the operator holds a button to continue one",
    "reference.allow": _REFERENCE,
    "reference.begin": _REFERENCE,
    "reference.drive": _REFERENCE,
    "reference.finish": _REFERENCE,
    "reference.teach": _REFERENCE,
    "replay.start": "trajectory.run replays a recording of the library by its name",
    "run.start": "trajectory.run runs a trajectory of the library by its name",
    "settings.read": "the settings are read in the window",
    "settings.reset_end_limits": "the settings are the operator's, who reads what changes",
    "settings.reset_joint_limits": "the settings are the operator's, who reads what changes",
    "settings.save": "the settings are the operator's, who reads what changes",
    "teaching.command": "the arm would go limp: somebody must stand at it",
}
"""The operations that clients cannot call, each with the reason or the alternative."""

FREE: Final = frozenset(
    {
        "motion.home",
        "motion.step",
        "motion.send",
        "motion.set_speed",
        "tool.move",
        "tool.arc",
        "tool.step",
        "gripper.move",
        "lamps.set",
        "run.pause",
        "replay.pause",
        "end_load.report",
    }
)
"""What a client with the lease may do without asking; for the rest the operator holds a button."""


@dataclass(frozen=True, slots=True)
class Longest:
    """The most characters of a text, or objects of a list; at least one."""

    length: int


@dataclass(frozen=True, slots=True)
class Choices:
    """The names that a list may have."""

    names: tuple[str, ...]


UNLEASED: Final = frozenset({"episode.begin", "episode.end", "episode.discard"})
"""What a client may do without the lease: it marks the log, and neither moves nor sets the arm."""

_SIX: Final = 6
_MOST: Final = 1e6
"""The largest figure accepted from a client, mm or degrees: larger ones overflow calculations."""
_NOT_NAMED: Final = frozenset({"self", "started"})
_ONLY: Final[Mapping[type[enum.Enum], tuple[str, ...]]] = {MoveMode: ("MOVE_P", "MOVE_L")}
"""The values of an enumeration that a client may choose, if not all of them."""


def asks(operation: Operation) -> bool:
    """Return whether the operator is asked at each call, even with a lease."""
    return operation.consent is not Consent.NONE or operation.id not in FREE | UNLEASED


def offered(operations: Mapping[str, BoundOperation]) -> Iterator[BoundOperation]:
    """Yield the operations that a client can ask for."""
    return (bound for name, bound in operations.items() if name not in WITHOUT)


def parameters_of(method: Callable[..., object]) -> Sequence[tuple[inspect.Parameter, object]]:
    """Return the parameters of a method that a client names, each with its annotation."""
    return _parameters(getattr(method, "__func__", method))


@cache  # by the functions: a bound method would keep its program
def _parameters(function: Callable[..., object]) -> Sequence[tuple[inspect.Parameter, object]]:
    hints = get_type_hints(function, include_extras=True)
    parameters = inspect.signature(function).parameters.values()
    return [(each, hints[each.name]) for each in parameters if each.name not in _NOT_NAMED]


def taken(method: Callable[..., object], params: Json) -> tuple[list[object], dict[str, object]]:
    """Return a call's arguments as the method takes them, without the number of the lease.

    Raises:
        CallError: One is missing, unknown, or of another form; ranges are checked elsewhere.
    """
    left = {name: value for name, value in params.items() if name != "lease"}
    positional: list[object] = []
    named: dict[str, object] = {}
    for each, hint in parameters_of(method):
        count = _kind(hint)[1].get(Count)
        if each.name not in left:
            if each.default is each.empty and (each.kind is not each.VAR_POSITIONAL or count):
                raise CallError(Code.PARAMS, f"“{each.name}” is missing.")
            continue
        value = left.pop(each.name)
        if value is None and each.default is None:
            continue
        if each.kind is each.VAR_POSITIONAL:
            if not isinstance(value, list) or (count and len(value) != count.number):
                many = f" of {count.number}" if count else ""
                raise CallError(Code.PARAMS, f"“{each.name}” must be a list{many}.")
            positional += [_taken(each.name, hint, one) for one in value]
        else:
            named[each.name] = _taken(each.name, hint, value)
    if left:
        raise CallError(Code.PARAMS, f"Unknown: {', '.join(sorted(map(str, left)))}.")
    return positional, named


def _taken(name: str, hint: object, value: object) -> object:
    """Return one argument converted to the type of its annotation."""
    kind, marks = _kind(hint)
    wrong: str
    if isinstance(kind, type) and issubclass(kind, enum.Enum):
        names = _names(kind)
        if isinstance(value, str) and value in names:
            return names[value]
        wrong = f"one of {', '.join(names)}"
    elif kind is bool:
        if isinstance(value, bool):
            return value
        wrong = "true or false"
    elif kind is str:
        longest = marks.get(Longest)
        if isinstance(value, str) and (longest is None or 0 < len(value) <= longest.length):
            return value
        wrong = "a text" if longest is None else f"a text of 1 to {longest.length} characters"
    elif kind in {int, float}:
        whole = kind is int
        numeric = isinstance(value, int if whole else int | float) and not isinstance(value, bool)
        if numeric and (whole or _is_plausible(value)):
            return value
        wrong = _whole(marks.get(Range)) if whole else f"a number within ±{_MOST:,.0f}"
    elif get_origin(kind) is list:
        return _listed(name, get_args(kind)[0], marks, value)
    else:
        return six(name, value)
    raise CallError(Code.PARAMS, f"“{name}” must be {wrong}.")


def _whole(within: Range | None) -> str:
    return f"a whole number{f' from {within[0]} to {within[1]}' if within else ''}"


def _listed(name: str, of: object, marks: Mapping[type, Any], value: object) -> list[object]:
    each_is: Any = get_origin(of) or of
    if not isinstance(value, list) or not all(isinstance(each, each_is) for each in value):
        wanted = "names" if each_is is str else "objects"
        raise CallError(Code.PARAMS, f"“{name}” must be a list of {wanted}.")
    choices, longest = marks.get(Choices), marks.get(Longest)
    if choices is not None and (unknown := [each for each in value if each not in choices.names]):
        text = f"Of “{name}” none is called “{unknown[0]}”; there are {', '.join(choices.names)}."
        raise CallError(Code.PARAMS, text)
    if longest is not None and not 0 < len(value) <= longest.length:
        raise CallError(Code.PARAMS, f"“{name}” must be 1 to {longest.length} of them.")
    return value


def six(name: str, value: object) -> tuple[float, ...]:
    """Return six plausible numbers.

    Raises:
        CallError: It is something else.
    """
    if isinstance(value, list) and len(value) == _SIX:
        numbers = [each for each in value if isinstance(each, int | float)]
        are_numbers = len(numbers) == _SIX and not any(isinstance(each, bool) for each in numbers)
        if are_numbers and all(map(_is_plausible, numbers)):
            return tuple(map(float, numbers))
    raise CallError(Code.PARAMS, f"“{name}” must be six numbers within ±{_MOST:,.0f}.")


def _is_plausible(value: Any) -> bool:
    return bool(-_MOST <= value <= _MOST)  # false for infinite values and NaN, too


def _kind(hint: object) -> tuple[object, Mapping[type, Any]]:
    """Return the type that an annotation allows, and its further marks by their types.

    The type is an enum, a plain type, a list, or a sequence of numbers.
    """
    marks: dict[type, Any] = {}
    if get_origin(hint) in {Union, UnionType} and hint != MotionFrame:
        hint = next(each for each in get_args(hint) if each is not type(None))
    if get_origin(hint) is Annotated:
        hint, *found = get_args(hint)
        marks = {type(each): each for each in found}
    if hint == MotionFrame:
        return JogFrame, marks
    if get_origin(hint) in {Sequence, list} or hint in {bool, int, float, str}:
        return hint, marks
    if isinstance(hint, type) and issubclass(hint, enum.Enum):
        return hint, marks
    raise TypeError(f"{hint!r} has no plain form")


def _names(kind: type[enum.Enum]) -> dict[str, enum.Enum]:
    only = _ONLY.get(kind)
    return {each.name.lower(): each for each in kind if only is None or each.name in only}


def schema(operations: Mapping[str, BoundOperation]) -> list[Json]:
    """Return each offered operation as a method of OpenRPC."""
    return [_method(bound) for bound in offered(operations)]


def _method(bound: BoundOperation) -> Json:
    operation = bound.operation
    return {
        "name": operation.id,
        "summary": operation.title,
        **takes(bound.carry_out, leased=operation.id not in UNLEASED),
        "result": {"name": "number", "schema": {"type": "integer"}},
        "x-moves": operation.moves,
        "x-asks-the-operator": asks(operation),
    }


def takes(method: Callable[..., object], *, leased: bool) -> Json:
    """Return the parameters of a method in the form of OpenRPC."""
    of_lease = {"name": "lease", "required": True, "schema": {"type": "integer"}}
    params = [_param(method, *each) for each in parameters_of(method)]
    return {"paramStructure": "by-name", "params": [of_lease, *params] if leased else params}


def _param(method: Callable[..., object], each: inspect.Parameter, hint: object) -> Json:
    several = each.kind is each.VAR_POSITIONAL
    of_one, count = _schema(method, each.name, hint), _kind(hint)[1].get(Count)
    counts = {"minItems": count.number, "maxItems": count.number} if count else {}
    found: Json = {
        "name": each.name,
        "required": each.default is each.empty and (not several or bool(count)),
        "schema": {"type": "array", "items": of_one, **counts} if several else of_one,
    }
    if isinstance(each.default, bool | int | float | str):
        found["schema"] = {**found["schema"], "default": each.default}
    return found


def _schema(method: Callable[..., object], name: str, hint: object) -> Json:
    kind, marks = _kind(hint)
    longest = marks.get(Longest)
    if isinstance(kind, type) and issubclass(kind, enum.Enum):
        return {"enum": list(_names(kind))}
    if kind is bool:
        return {"type": "boolean"}
    if kind is str:
        lengths = {} if longest is None else {"minLength": 1, "maxLength": longest.length}
        return {"type": "string", **lengths}
    if get_origin(kind) is list:
        items = {"enum": list(marks[Choices].names)} if Choices in marks else {"type": "object"}
        counts = {} if longest is None else {"minItems": 1, "maxItems": longest.length}
        return {"type": "array", "items": items, **counts}
    if kind in {int, float}:
        return _number(figures_of(method).get(name), whole=kind is int)
    unit = {"x-unit": marks[str]} if str in marks else {}
    number = {"type": "number", "minimum": -_MOST, "maximum": _MOST}
    numbers = {"type": "array", "items": number}
    return {**numbers, "minItems": _SIX, "maxItems": _SIX, **unit}


def _number(figure: CommandFigure | None, *, whole: bool) -> Json:
    found: Json = {"type": "integer" if whole else "number"}
    if figure is None:
        return found
    if figure.choices is not None:
        found["enum"] = list(figure.choices.values)
    elif not figure.of_arm:
        found |= {"minimum": figure.range.minimum, "maximum": figure.range.maximum}
    if figure.also:
        found = {"anyOf": [found, {"enum": list(figure.also)}]}
    if figure.range.unit:
        found["x-unit"] = figure.range.unit
    return found
