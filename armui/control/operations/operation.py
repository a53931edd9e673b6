"""The declaration of an operation: its name, the reason against it, its effect on the arm."""

from __future__ import annotations

import enum
import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial, wraps
from typing import TYPE_CHECKING, Any, Concatenate, Final, ParamSpec, Protocol, TypeVar

from armui.arm.figures import check_arguments
from armui.arm.refusal import Refusal
from armui.control.operations.started import Ending, Started

if TYPE_CHECKING:
    from armui.control.context import Context

_ATTRIBUTE: Final = "_operation"

WhyNot = Callable[..., Refusal | None]
"""Returns a reason or ``None`` from the operating state and the arguments of the method that it
depends on, by their names; what it takes by keyword only is not asked of the method."""

_Method = TypeVar("_Method", bound=Callable[..., object])
_P = ParamSpec("_P")


class Part(Protocol):
    """A part of the controller that has operations."""

    @property
    def _context(self) -> Context: ...


_AnyPart = TypeVar("_AnyPart", bound=Part)


class Consent(enum.Enum):
    """The way the operator agrees to an operation before it is carried out."""

    NONE = enum.auto()
    PRESS = enum.auto()
    """The operator answers a question first."""
    HELD = enum.auto()
    """The operator holds a button throughout the operation, or for a second before it."""


@dataclass(frozen=True, slots=True)
class Operation:
    """An action of the operator on the arm.

    Attributes:
        id: Its stable name: the part of the arm, a dot, the act.
        title: The English title; the translation context is ``Operation``.
        why_not: Returns why it may not be done now, from the operating state alone.
        moves: True if a frame of it may set a joint or the gripper in motion: then it is refused
            while the arm is not heard, and beside another host. A speed is a choice that is kept,
            and told only where it sets nothing going: it is none of these.
        consent: The operator's consent that it needs beside the choice.
        shown_first: True if it applies the contents of its page, and so needs that page to be
            shown.
    """

    id: str
    title: str
    why_not: WhyNot
    moves: bool
    consent: Consent
    shown_first: bool

    def why_not_now(self, now: object) -> Refusal | None:
        """Return why it may not be done now, where that depends on no argument; else ``None``."""
        return None if _arguments_of(self.why_not) else self.why_not(now)


def operation(
    name: str,
    title: str,
    why_not: WhyNot,
    *,
    moves: bool = False,
    consent: Consent = Consent.NONE,
    shown_first: bool = False,
    sends: bool = True,
    first: Callable[[Any], object] = lambda _part: None,
) -> Callable[
    [Callable[Concatenate[_AnyPart, Started, _P], Refusal | None]],
    Callable[Concatenate[_AnyPart, _P], Started | Refusal],
]:
    """Make a method of a part of the controller an operation; see :class:`Operation`.

    The reason against it is asked with what is heard now, and the figures it is called with are
    checked against their annotations (:mod:`armui.arm.figures`). Without a reason the method gets
    the record of the command beside its arguments, and does its work; it returns ``None``, or why
    that could not be done after all. A refusal is told the operator, here and nowhere else.

    Args:
        name: Its id.
        title: Its English title.
        why_not: As in :class:`Operation`.
        moves: As in :class:`Operation`.
        consent: As in :class:`Operation`.
        shown_first: As in :class:`Operation`.
        sends: False if nothing of it is for the arm.
        first: Does with the part what every press does, even one that is refused.

    Returns:
        What makes of the method one that returns the record of the command, or the refusal.

    Raises:
        TypeError: The reason depends on an argument that the method has not.
    """

    def wrap(
        method: Callable[Concatenate[_AnyPart, Started, _P], Refusal | None],
    ) -> Callable[Concatenate[_AnyPart, _P], Started | Refusal]:
        signature = inspect.signature(method)
        asked = _arguments_of(why_not)
        if lost := sorted(asked - signature.parameters.keys()):
            raise TypeError(f"{name}: the reason asks for {lost}")

        @declare(name, title, why_not, moves=moves, consent=consent, shown_first=shown_first)
        @wraps(method)
        def carry_out(part: _AnyPart, /, *args: _P.args, **kwargs: _P.kwargs) -> Started | Refusal:
            first(part)
            context = part._context  # noqa: SLF001 - each part has kept what it was given
            started = Started(name)
            given = signature.bind(part, started, *args, **kwargs)
            given.apply_defaults()
            why_not_now = partial(why_not, **{each: given.arguments[each] for each in asked})
            refusal = why_not_now(context.refresh()) or check_arguments(method, given.arguments)
            if refusal is None:
                before = context.authority.revision
                context.begun(name)  # before it sends: what this ends must not drop its frames
                if context.authority.revision != before:  # the motion it acts on may have ended
                    refusal = why_not_now(context.refresh())
            if refusal is None:
                refusal = method(part, started, *args, **kwargs)
            if refusal is None:
                return started
            started.close(Ending.REFUSED)
            return context.refuse(refusal, sends=sends)

        return carry_out

    return wrap


def _arguments_of(why_not: WhyNot) -> set[str]:
    """Return the names of what a reason depends on beside the operating state."""
    parameters = inspect.signature(why_not).parameters.values()
    _now, *others = (each.name for each in parameters if each.kind is not each.KEYWORD_ONLY)
    return set(others)


def declare(
    name: str,
    title: str,
    why_not: WhyNot,
    *,
    moves: bool = False,
    consent: Consent = Consent.NONE,
    shown_first: bool = False,
) -> Callable[[_Method], _Method]:
    """Declare a method as an :class:`Operation` that asks, records and refuses in a way of its own.

    It is for what does not begin one command, told at each press; all others are made by
    :func:`operation`.
    """

    def mark(method: _Method) -> _Method:
        declared = Operation(name, title, why_not, moves, consent, shown_first)
        setattr(method, _ATTRIBUTE, declared)
        return method

    return mark


def operation_of(method: Callable[..., object]) -> Operation:
    """Return the operation that a method was declared as.

    Raises:
        AttributeError: The method was not declared.
    """
    declared: Operation = getattr(method, _ATTRIBUTE)
    return declared


def record_start(method: Callable[..., object]) -> Started:
    """Return the record of what a declared method has led to: a motion of its run, its next part.

    The record of the command itself is made by :func:`operation`.
    """
    return Started(operation_of(method).id)


@dataclass(frozen=True, slots=True)
class BoundOperation:
    """An operation on one arm.

    Attributes:
        operation: Its declaration.
        carry_out: The method that does it.
    """

    operation: Operation
    carry_out: Callable[..., Any]


class Operations(Mapping[str, BoundOperation]):
    """The registry of the operations of a controller's parts, by id.

    Args:
        parts: The parts.

    Raises:
        ValueError: Two methods have the same id.
    """

    def __init__(self, parts: Iterable[object]) -> None:
        self._bound: dict[str, BoundOperation] = {}
        for part in parts:
            for name in dir(type(part)):
                declared = getattr(getattr(type(part), name), _ATTRIBUTE, None)
                if declared is None:
                    continue
                if declared.id in self._bound:
                    raise ValueError(f"operation {declared.id} is declared twice")
                self._bound[declared.id] = BoundOperation(declared, getattr(part, name))

    def __getitem__(self, name: str) -> BoundOperation:
        """Return the operation with an id, bound to its part; an unknown id is a `KeyError`."""
        return self._bound[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._bound)

    def __len__(self) -> int:
        return len(self._bound)
