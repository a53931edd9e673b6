"""The plain form of the operations: their arguments in JSON, and their schema.

Everything comes from the annotations of the operations' methods. Those that take objects of the
program are left out, or have a method of their own (:data:`WITHOUT`).
"""

from __future__ import annotations

import enum
import inspect
import math
from collections.abc import Iterator, Mapping, Sequence
from types import UnionType
from typing import TYPE_CHECKING, Annotated, Any, Final, Union, get_args, get_origin, get_type_hints

from armui.arm.figures import figures_of
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
    "replay.go_on": _HELD,
    "replay.start": "a replay is begun by the operator",
    "run.go_on": _HELD,
    "run.start": "trajectory.run runs a trajectory of the library by its name",
    "settings.read": "the settings are read in the window",
    "settings.reset_end_limits": "the settings are the operator's, who reads what changes",
    "settings.reset_joint_limits": "the settings are the operator's, who reads what changes",
    "settings.save": "the settings are the operator's, who reads what changes",
    "teaching.command": "the arm would go limp: somebody must stand at it",
}
"""The operations that no client can ask for, each with the reason, or what there is instead."""

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
"""What a client with the lease may do without asking; the operator holds a button for the rest."""

_SIX: Final = 6
_ONLY: Final[Mapping[type[enum.Enum], tuple[str, ...]]] = {MoveMode: ("MOVE_P", "MOVE_L")}
"""Of these enumerations some values are no choices of a command."""


def asks(operation: Operation) -> bool:
    """Return whether the operator is asked each time, whatever the lease allows."""
    return operation.consent is not Consent.NONE or operation.id not in FREE


def offered(operations: Mapping[str, BoundOperation]) -> Iterator[BoundOperation]:
    """Yield the operations that a client can ask for."""
    return (bound for name, bound in operations.items() if name not in WITHOUT)


def _parameters(method: Any) -> Iterator[tuple[inspect.Parameter, object]]:
    hints = get_type_hints(method, include_extras=True)
    for each in inspect.signature(method).parameters.values():
        if each.name not in {"self", "started"}:
            yield each, hints[each.name]


def arguments(bound: BoundOperation, params: Json) -> tuple[list[object], dict[str, object]]:
    """Return a call's arguments as the operation's method takes them.

    Raises:
        CallError: One is missing, unknown, or of another form; the ranges are the operation's own.
    """
    left = dict(params)
    positional: list[object] = []
    named: dict[str, object] = {}
    for each, hint in _parameters(bound.carry_out):
        if each.name not in left:
            if each.default is each.empty and each.kind is not each.VAR_POSITIONAL:
                raise CallError(Code.PARAMS, f"“{each.name}” is missing.")
            continue
        value = left.pop(each.name)
        if each.kind is each.VAR_POSITIONAL:
            if not isinstance(value, list):
                raise CallError(Code.PARAMS, f"“{each.name}” must be a list.")
            positional += [_taken(each.name, hint, one) for one in value]
        else:
            named[each.name] = _taken(each.name, hint, value)
    if left:
        raise CallError(Code.PARAMS, f"Unknown: {', '.join(sorted(map(str, left)))}.")
    return positional, named


def _taken(name: str, hint: object, value: object) -> object:
    """Return one argument as its annotation has it."""
    kind = _kind(hint)
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
        if isinstance(value, str):
            return value
        wrong = "a text"
    elif kind in {int, float}:
        whole = kind is int
        if isinstance(value, int if whole else int | float) and not isinstance(value, bool):
            return value
        wrong = "a whole number" if whole else "a number"
    else:
        return six(name, value)
    raise CallError(Code.PARAMS, f"“{name}” must be {wrong}.")


def six(name: str, value: object) -> tuple[float, ...]:
    """Return six finite numbers.

    Raises:
        CallError: It is something else.
    """
    if isinstance(value, list) and len(value) == _SIX:
        numbers = [each for each in value if isinstance(each, int | float)]
        if len(numbers) == _SIX and not any(isinstance(each, bool) for each in numbers):
            try:
                found = tuple(map(float, numbers))
            except OverflowError:
                found = (math.inf,)
            if all(map(math.isfinite, found)):
                return found
    raise CallError(Code.PARAMS, f"“{name}” must be six numbers.")


def _kind(hint: object) -> object:
    """Return what an annotation allows: an enum, a plain type, or a sequence of numbers."""
    if get_origin(hint) is Annotated:
        hint = get_args(hint)[0]
    if hint == MotionFrame:
        return JogFrame
    if get_origin(hint) in {Union, UnionType}:
        hint = next(each for each in get_args(hint) if each is not type(None))
    if get_origin(hint) is Sequence or hint in {bool, int, float, str}:
        return hint
    if isinstance(hint, type) and issubclass(hint, enum.Enum):
        return hint
    raise TypeError(f"{hint!r} has no plain form")


def _names(kind: type[enum.Enum]) -> dict[str, enum.Enum]:
    only = _ONLY.get(kind)
    return {each.name.lower(): each for each in kind if only is None or each.name in only}


def schema(operations: Mapping[str, BoundOperation]) -> list[Json]:
    """Return each offered operation as a method of OpenRPC."""
    return [_method(bound) for bound in offered(operations)]


def _method(bound: BoundOperation) -> Json:
    operation = bound.operation
    of_lease = {"name": "lease", "required": True, "schema": {"type": "integer"}}
    return {
        "name": operation.id,
        "summary": operation.title,
        "paramStructure": "by-name",
        "params": [of_lease, *(_param(bound, *each) for each in _parameters(bound.carry_out))],
        "result": {"name": "number", "schema": {"type": "integer"}},
        "x-moves": operation.moves,
        "x-asks-the-operator": asks(operation),
    }


def _param(bound: BoundOperation, each: inspect.Parameter, hint: object) -> Json:
    several = each.kind is each.VAR_POSITIONAL
    of_one = _schema(bound, each.name, _kind(hint))
    return {
        "name": each.name,
        "required": each.default is each.empty and not several,
        "schema": {"type": "array", "items": of_one} if several else of_one,
    }


def _schema(bound: BoundOperation, name: str, kind: object) -> Json:
    if isinstance(kind, type) and issubclass(kind, enum.Enum):
        return {"enum": list(_names(kind))}
    if kind is bool:
        return {"type": "boolean"}
    if kind is str:
        return {"type": "string"}
    if kind not in {int, float}:
        return {
            "type": "array",
            "items": {"type": "number"},
            "minItems": _SIX,
            "maxItems": _SIX,
        }
    found: Json = {"type": "integer" if kind is int else "number"}
    figure = figures_of(bound.carry_out).get(name)
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
