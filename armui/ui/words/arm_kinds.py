"""The arm that a trajectory was taught on, as the operator reads it."""

from __future__ import annotations

from typing import Final

from armui.arm.model_check import OLDER_ZEROS
from armui.ui.words.text import Texts

_KINDS: Final = Texts("ArmKind") | {"older": "{model} (zeros before S-V1.6-3)"}


def arm_kind(kind: str) -> str:
    """Return a `ModelFit.kind` in the operator's language."""
    model = kind.removesuffix(OLDER_ZEROS)
    return kind if model == kind else _KINDS.text("older", {"model": model})
