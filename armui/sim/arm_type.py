"""The type of a simulated arm: its model and firmware version, and what follows from both."""

from __future__ import annotations

from dataclasses import dataclass

from armui.arm.models import ModelData, model_data
from armui.kinematics.geometry import Geometry
from armui.protocol.firmware_version import RECOMMENDED, FirmwareQuirks, FirmwareVersion, quirks_of
from armui.protocol.generation import PiperModel
from armui.sim.mechanics.rigid_body import RigidLink, rigid_links

SixFactors = tuple[float, ...]


@dataclass(frozen=True, slots=True)
class ArmType:
    """A model with a firmware version.

    Attributes:
        model: The model's data.
        version: The version in the answer to 0x4AF.
        quirks: The firmware's behaviour.
    """

    model: ModelData
    version: str
    quirks: FirmwareQuirks

    @classmethod
    def of(cls, model: PiperModel, version: str) -> ArmType:
        """Return a model with a version like ``S-V1.8-9``; an unreadable one counts as today's."""
        parsed = FirmwareVersion.parse(version) or RECOMMENDED
        return cls(model_data(model), version, quirks_of(parsed, model))

    @property
    def geometry(self) -> Geometry:
        """The dimensions, with the zeros of this firmware."""
        return self.model.geometry_of(self.version)

    @property
    def links(self) -> tuple[RigidLink, ...]:
        """The links with their masses."""
        return rigid_links(self.model, self.geometry)

    @property
    def nm_per_ampere(self) -> SixFactors:
        """The torque at the output for each ampere of motor current, joint 1 first: k·b·c.

        A calibration c that is not known counts as 1.
        """
        torque = self.model.torque
        calibration = torque.c or (1.0,) * 6
        return tuple(
            k * b * c for k, b, c in zip(torque.k_nm_per_a, torque.b, calibration, strict=True)
        )

    @property
    def mit_torque_scale(self) -> SixFactors:
        """The torque at the output for 1 N·m in a MIT frame, joint 1 first.

        It holds the firmware's factor and the calibration c. Whatever the model, the firmware
        converts torque to current with the PiPER's k·b.
        """
        torque, piper = self.model.torque, model_data().torque
        calibration = torque.c or (1.0,) * 6
        ratios = (
            k * b / (piper_k * piper_b)
            for k, b, piper_k, piper_b in zip(
                torque.k_nm_per_a, torque.b, piper.k_nm_per_a, piper.b, strict=True
            )
        )
        return tuple(
            factor * c * ratio
            for factor, c, ratio in zip(
                self.quirks.mit_torque_factors, calibration, ratios, strict=True
            )
        )
