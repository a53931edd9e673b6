"""Which model an arm is, by its own word: where its angles lead, compared with the pose it tells.

No frame names the model. But the arm computes its end pose (0x2A2–0x2A4) with its own dimensions,
and the models lie apart by more than 8 mm, or by 60° of the hand (PiPER X), in every pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.models import all_models, model_data
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.protocol.piper_model import PiperModel

FITS_MM: Final = 1.0
FITS_DEG: Final = 1.0
"""A model fits whose flange is as near as this to where a standing arm says it is."""

Models = frozenset[PiperModel]


@dataclass(frozen=True, slots=True)
class ModelFit:
    """What the comparison says of the model that was chosen.

    Attributes:
        chosen: By the operator.
        fitting: The models that fit; empty: none does; ``None``: not compared yet.
    """

    chosen: PiperModel = PiperModel.PIPER
    fitting: Models | None = None

    @property
    def confirmed(self) -> bool:
        """Whether the chosen model fits, and no other."""
        return self.fitting == frozenset({self.chosen})

    @property
    def other(self) -> PiperModel | None:
        """The model that fits instead of the chosen one, where there is just one."""
        if self.fitting is None or self.chosen in self.fitting or len(self.fitting) != 1:
            return None
        return next(iter(self.fitting))

    @property
    def wrong(self) -> Refusal | None:
        """Why nothing can be computed of this arm as the chosen model, or ``None``."""
        if self.fitting is None or self.chosen in self.fitting:
            return None
        if not self.fitting:
            return Refusal(RefusalCode.MODEL_DIFFERS)
        fits = ", ".join(model_data(model).name for model in PiperModel if model in self.fitting)
        return Refusal(
            RefusalCode.MODEL_OTHER, {"chosen": model_data(self.chosen).name, "fits": fits}
        )


def fitting_models(
    joints_deg: Sequence[float], pose: Sequence[float], firmware: str | None
) -> Models:
    """The models whose flange is where a standing arm says that it is.

    Args:
        joints_deg: Its six angles.
        pose: X, Y, Z in mm and RX, RY, RZ in degrees.
        firmware: Its version; ``None``: it tells none, and may count from the older zeros.
    """
    from armui.kinematics.arm_kinematics import Kinematics  # noqa: PLC0415 - numpy: faster start
    from armui.kinematics.poses import Pose, apart  # noqa: PLC0415 - see above

    told = Pose(*pose)
    found = set()
    for model, data in all_models().items():
        geometries = data.geometries if firmware is None else (data.geometry_of(firmware),)
        for geometry in geometries:
            off_mm, off_deg = apart(Kinematics(geometry).forward(joints_deg), told)
            if off_mm <= FITS_MM and off_deg <= FITS_DEG:
                found.add(model)
    return frozenset(found)
