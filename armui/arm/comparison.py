"""A backup beside the arm, parameter by parameter: pure."""

from __future__ import annotations

import enum
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass

from armui.arm.parameters import KINDS, Parameter, check_value, heard
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState


class ComparisonVerdict(enum.Enum):
    """How a parameter of the file stands to the arm's."""

    SAME = "same"
    DIFFERS = "differs"
    ONLY_IN_FILE = "only_in_file"
    """This arm's protocol has no such parameter."""
    ONLY_IN_ARM = "only_in_arm"
    NOT_READ = "not_read"
    """The arm has not told what it holds."""


@dataclass(frozen=True, slots=True)
class ComparisonRow:
    """One parameter.

    Attributes:
        parameter: Which one.
        verdict: How file and arm compare.
        filed: What the file says.
        held: What the arm said.
        against: Why the file's value may not be restored, or ``None``.
    """

    parameter: Parameter
    verdict: ComparisonVerdict
    filed: float | None = None
    held: float | None = None
    against: Refusal | None = None

    @property
    def restorable(self) -> bool:
        """Whether restoring it can be asked for, and would change something."""
        return self.verdict in {ComparisonVerdict.DIFFERS, ComparisonVerdict.NOT_READ} and (
            self.filed is not None and self.against is None
        )


def compare(
    filed: Mapping[Parameter, float],
    state: ArmState,
    known: Collection[Parameter],
    same: Callable[[Parameter, float], bool],
) -> list[ComparisonRow]:
    """Every parameter of the file and of the arm, in the order of the catalogue.

    Args:
        filed: What the file says; empty: only the arm is shown.
        state: The arm as last heard.
        known: The parameters this arm has.
        same: Whether what the arm holds is a value, as far as its frames can tell.
    """
    names = list(KINDS)
    every = sorted({*filed, *known}, key=lambda each: (names.index(each.name), each.joint))
    return [_row(parameter, filed.get(parameter), state, known, same) for parameter in every]


def _row(
    parameter: Parameter,
    filed: float | None,
    state: ArmState,
    known: Collection[Parameter],
    same: Callable[[Parameter, float], bool],
) -> ComparisonRow:
    said = heard(state, parameter)
    held = None if said is None else said.value
    if parameter not in known:
        return ComparisonRow(parameter, ComparisonVerdict.ONLY_IN_FILE, filed)
    if held is None:
        against = None if filed is None else check_value(parameter, filed)
        return ComparisonRow(parameter, ComparisonVerdict.NOT_READ, filed, None, against)
    if filed is None:
        return ComparisonRow(parameter, ComparisonVerdict.ONLY_IN_ARM, None, held)
    if same(parameter, filed):
        return ComparisonRow(parameter, ComparisonVerdict.SAME, filed, held)
    return ComparisonRow(
        parameter, ComparisonVerdict.DIFFERS, filed, held, check_value(parameter, filed)
    )
