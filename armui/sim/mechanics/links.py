"""The links of a simulated arm as rigid bodies, made of its model's data."""

from __future__ import annotations

from functools import cache

from armui.arm.models import ModelData, model_data
from armui.kinematics.geometry import Geometry
from armui.protocol.generation import PiperModel
from armui.sim.mechanics.rigid_body import ROTOR_INERTIAS_KG_M2, RigidLink


def rigid_links(model: ModelData, geometry: Geometry) -> tuple[RigidLink, ...]:
    """The six links that move; the base stands still.

    Args:
        model: Has the masses and their centres.
        geometry: Of that model, with the zeros that the arm's firmware counts from.
    """
    return tuple(
        RigidLink(*row, link.mass_kg, link.centre_mm, rotor_kg_m2)
        for row, link, rotor_kg_m2 in zip(
            geometry.rows, model.links[1:], ROTOR_INERTIAS_KG_M2, strict=True
        )
    )


@cache
def piper_links() -> tuple[RigidLink, ...]:
    """Those of the PiPER with the zeros of today's firmware."""
    model = model_data(PiperModel.PIPER)
    return rigid_links(model, model.geometry)
