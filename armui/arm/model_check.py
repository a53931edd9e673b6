"""Finds the model of an arm: the pose of its angles is compared with the pose it reports.

No frame names the model. But the arm computes its end pose (0x2A2–0x2A4) with its own dimensions,
and the models lie apart by more than 8 mm, or by 60° of the hand (PiPER X), in every pose.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Final, NamedTuple

from armui.arm.models import ModelData, all_models, model_data
from armui.arm.refusal import Reason, Refusal
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import Pose, apart
from armui.protocol.generation import PiperModel

if TYPE_CHECKING:
    from armui.kinematics.geometry import Geometry

MODEL_DIFFERS = Reason(
    "model_differs",
    "The pose the arm reports does not fit its joint angles: the program cannot compute its "
    "way. Check the joints' zeros; the joints can still be moved one by one.",
)
MODEL_OTHER = Reason(
    "model_other",
    "Connected as a {chosen}, but the pose it reports is that of a {fits}: paths would be wrong. "
    "Connect it as a {fits}; until then the joints can be moved one by one.",
)


FITS_MM: Final = 1.0
FITS_DEG: Final = 1.0
"""A model fits if its flange is this near to the pose that a standing arm reports."""

Models = frozenset[PiperModel]

OLDER_ZEROS: Final = " (zeros before S-V1.6-3)"
"""The text behind the model's name in `ModelFit.kind`."""


class FittingArm(NamedTuple):
    """A model, with its zeros, whose computed flange is where a standing arm reports it.

    Attributes:
        model: The model of the family.
        older_zeros: True if it counts joints 2 and 3 from the zeros before S-V1.6-3.
    """

    model: PiperModel
    older_zeros: bool


class ModelFit(NamedTuple):
    """The result of comparing the arm with the model that was chosen.

    Attributes:
        chosen: The model the operator chose.
        fitting: The models that fit; empty if none does, ``None`` if not compared yet.
        older_zeros: True if the arm counts joints 2 and 3 from the zeros before S-V1.6-3.
        before: The model of this arm the last time, if that was another and nothing has been
            compared yet.
    """

    chosen: PiperModel = PiperModel.PIPER
    fitting: Models | None = None
    older_zeros: bool = False
    before: PiperModel | None = None

    @property
    def geometry(self) -> Geometry:
        """The geometry of the chosen model with its zeros; every computation takes it from here."""
        return model_data(self.chosen).geometry_with(older_zeros=self.older_zeros)

    @property
    def kind(self) -> str:
        """The model and its zeros, as trajectories name the arm they were taught on."""
        name = model_data(self.chosen).name
        return f"{name}{OLDER_ZEROS}" if self.older_zeros else name

    @property
    def taught_on(self) -> str:
        """The kind for new trajectories; "" until the arm's feedback has confirmed it."""
        return self.kind if self.fitting is not None and self.chosen in self.fitting else ""

    def zeros_from_deg(self, taught_on: str) -> tuple[float, ...] | None:
        """Return the difference between another arm's joint zeros and this one's.

        Args:
            taught_on: The `kind` of the other arm.

        Returns:
            The degrees to add to its six angles; ``None`` unless both arms are known to be of one
            model with different zeros.
        """
        data = model_data(self.chosen)
        if not self.taught_on or taught_on != self._replace(older_zeros=not self.older_zeros).kind:
            return None
        theirs = data.geometry_with(older_zeros=not self.older_zeros)
        return tuple(
            round(one.theta_deg - other.theta_deg, 6)
            for one, other in zip(theirs.rows, self.geometry.rows, strict=True)
        )

    @property
    def confirmed(self) -> bool:
        """True if the chosen model fits, and no other."""
        return self.fitting == frozenset({self.chosen})

    @property
    def other(self) -> PiperModel | None:
        """The model that fits instead of the chosen one, if there is exactly one."""
        if self.fitting is None or self.chosen in self.fitting or len(self.fitting) != 1:
            return None
        return next(iter(self.fitting))

    @property
    def wrong(self) -> Refusal | None:
        """The reason why nothing can be computed with the chosen model, or ``None``."""
        if self.fitting is None or self.chosen in self.fitting:
            return None
        if not self.fitting:
            return MODEL_DIFFERS()
        fits = ", ".join(model_data(model).name for model in PiperModel if model in self.fitting)
        return MODEL_OTHER(chosen=model_data(self.chosen).name, fits=fits)


def fitting_arms(
    joints_deg: Sequence[float], pose: Sequence[float], firmware: str | None
) -> frozenset[FittingArm]:
    """Return the models, with their zeros, whose flange is where a standing arm reports it.

    The version determines the zeros an arm counts from. The others are tried only if no model fits
    with those: whether PiPER H, L and X ever had the older ones is not known.

    Args:
        joints_deg: Its six angles.
        pose: X, Y, Z in mm and RX, RY, RZ in degrees.
        firmware: Its version; ``None`` if it names none, and may count from either.
    """
    if firmware is None:
        return _fitting(joints_deg, pose, lambda _data: (False, True))
    return _fitting(joints_deg, pose, lambda data: (data.older_zeros(firmware),)) or _fitting(
        joints_deg, pose, lambda data: (not data.older_zeros(firmware),)
    )


def fitting_models(
    joints_deg: Sequence[float], pose: Sequence[float], firmware: str | None
) -> Models:
    """Return the models of the family that `fitting_arms` finds."""
    return frozenset(arm.model for arm in fitting_arms(joints_deg, pose, firmware))


def _fitting(
    joints_deg: Sequence[float], pose: Sequence[float], zeros: Callable[[ModelData], Iterable[bool]]
) -> frozenset[FittingArm]:

    told = Pose(*pose)
    found = set()
    for model, data in all_models().items():
        for older_zeros in zeros(data):
            geometry = data.geometry_with(older_zeros=older_zeros)
            off_mm, off_deg = apart(Kinematics(geometry).forward(joints_deg), told)
            if off_mm <= FITS_MM and off_deg <= FITS_DEG:
                found.add(FittingArm(model, older_zeros))
    return frozenset(found)
