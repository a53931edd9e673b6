"""An operation that begins, or fails the test with the reason why not."""

from armui.arm.refusal import Refusal
from armui.control.operations.started import Started


def accepted(answer: Started | Refusal | None) -> Started:
    """The record of an operation that was to begin; the controller has taken it on."""
    assert isinstance(answer, Started), f"it did not begin: {answer}"
    return answer
