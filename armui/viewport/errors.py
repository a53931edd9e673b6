"""What can go wrong on the way to a picture."""

from __future__ import annotations

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode


class SceneError(Exception):
    """The 3D picture can't be made.

    Args:
        code: what it is.
        params: what the sentence names.

    Attributes:
        refusal: the reason, to be put into words by the user interface.
    """

    def __init__(self, code: RefusalCode, **params: float | int | str) -> None:
        self.refusal = Refusal(code, params)
        super().__init__(str(self.refusal))
