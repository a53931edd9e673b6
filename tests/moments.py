"""Values that change while a test looks at them."""

from typing import TypeVar

_Value = TypeVar("_Value")


def now(value: _Value) -> _Value:
    """A value as it is at this moment.

    What mypy has seen asserted of an attribute it takes to be so for the rest of the test, and
    checks nothing of what comes after an assertion of something else.
    """
    return value
