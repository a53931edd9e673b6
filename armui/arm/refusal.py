"""Why something was not done, as data: the user interface puts it into the operator's language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from armui.arm.refusal_codes import RefusalCode


@dataclass(frozen=True, slots=True)
class Refusal:
    """A reason against an action.

    Attributes:
        code: What it is; the user interface has a sentence for each.
        params: The figures the sentence names, in the units the sentence shows.
    """

    code: RefusalCode
    params: Mapping[str, float | int | str] = field(default_factory=dict)

    def __str__(self) -> str:
        figures = ", ".join(f"{key}={value}" for key, value in self.params.items())
        return f"{self.code}({figures})"
