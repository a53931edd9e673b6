"""The number of a joint, checked, and one value for each joint."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, Generic, Self, TypeVar, cast

from armui.arm.limits import JOINTS
from armui.arm.state import Six

T = TypeVar("T")


class JointNumber(int):
    """The number of a joint, 1 to 6.

    A frame can hold any number; only what was checked opens a :class:`PerJoint`.

    Raises:
        ValueError: No joint has this number.
    """

    def __new__(cls, number: float) -> Self:
        """Check a number."""
        if number not in JOINTS:
            raise ValueError(f"no joint has the number {number:g}; they are 1 to 6")
        return super().__new__(cls, number)


EACH_JOINT: Final = tuple(map(JointNumber, JOINTS))


class PerJoint(Generic[T]):
    """One value for each joint, opened by a checked number: no number is ever counted from the end.

    Args:
        value: What each joint has to begin with.
    """

    def __init__(self, value: T) -> None:
        self._values = [value] * len(JOINTS)

    def __setitem__(self, joint: JointNumber, value: T) -> None:
        self._values[joint - 1] = value

    def __iter__(self) -> Iterator[T]:
        return iter(self._values)

    def six(self) -> Six[T]:
        """Return the values as they are now, joint 1 first."""
        return cast("Six[T]", tuple(self._values))
