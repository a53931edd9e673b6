"""The declaration of an action: its name, why it may not be done, what it does to the arm."""

from __future__ import annotations

import enum
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final, TypeVar

from armui.arm.refusal import Refusal
from armui.control.operating_state import OperatingState
from armui.control.operations.started import Started

_Method = TypeVar("_Method", bound=Callable[..., object])
_ATTRIBUTE: Final = "_operation"

WhyNot = Callable[..., Refusal | None]
"""Takes the operating state and, by name, the arguments that matter; answers with a reason."""


class Consent(enum.Enum):
    """The way the operator agrees to an operation before it is carried out."""

    NONE = enum.auto()
    PRESS = enum.auto()
    """A question is answered first."""
    HELD = enum.auto()
    """A button is held for as long as the operation goes on, or for a second before it begins."""


@dataclass(frozen=True, slots=True)
class Operation:
    """An action of the operator on the arm.

    Attributes:
        id: Its stable name: the part of the arm, a dot, the act.
        title: The English title; the translation context is ``Operation``.
        why_not: Tells why it may not be done now, from the operating state alone.
        moves: It sets a joint or the gripper in motion.
        consent: What the operator has to do beside choosing it.
        shown_first: It does what stands on its page, and is only done where that is seen.
    """

    id: str
    title: str
    why_not: WhyNot
    moves: bool
    consent: Consent
    shown_first: bool


def operation(
    name: str,
    title: str,
    why_not: WhyNot,
    *,
    moves: bool = False,
    consent: Consent = Consent.NONE,
    shown_first: bool = False,
) -> Callable[[_Method], _Method]:
    """Declare a method of a part of the controller as an operation; see :class:`Operation`.

    The method itself stays as it is, and so do the types its callers are checked against.
    """

    def declare(method: _Method) -> _Method:
        declared = Operation(name, title, why_not, moves, consent, shown_first)
        setattr(method, _ATTRIBUTE, declared)
        return method

    return declare


def operation_of(method: Callable[..., object]) -> Operation:
    """Return the operation that a method was declared as.

    Raises:
        AttributeError: The method was not declared.
    """
    declared: Operation = getattr(method, _ATTRIBUTE)
    return declared


def record_start(method: Callable[..., object]) -> Started:
    """Return a record for a declared method that begins now; the part that follows it closes it."""
    return Started(operation_of(method).id)


@dataclass(frozen=True, slots=True)
class BoundOperation:
    """An operation on one arm.

    Attributes:
        operation: Its declaration.
        carry_out: Does it; the method's own arguments.
    """

    operation: Operation
    carry_out: Callable[..., Any]


class Operations(Mapping[str, BoundOperation]):
    """The registry: the operations of the parts of a controller, by their ids.

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
        """Return the operation of an id."""
        return self._bound[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._bound)

    def __len__(self) -> int:
        return len(self._bound)

    def why_not(self, name: str, now: OperatingState, **arguments: object) -> Refusal | None:
        """Tell why an operation may not be done now, or ``None``.

        Args:
            name: Its id.
            now: What the operator can do.
            **arguments: Those of its method that the reason depends on.
        """
        return self._bound[name].operation.why_not(now, **arguments)
