"""The links of the simulated arm as rigid bodies."""

from __future__ import annotations

from typing import Final

from armui.sim.mechanics.rigid_body import ROTOR_INERTIAS_KG_M2, RigidLink

_ROWS: Final = (
    (0.0, 0.0, 123.0, 0.0),
    (0.0, -90.0, 0.0, -172.22),
    (285.03, 0.0, 0.0, -102.78),
    (-21.98, 90.0, 250.75, 0.0),
    (0.0, -90.0, 0.0, 0.0),
    (0.0, 90.0, 91.0, 0.0),
)
_MASSES_KG: Final = (0.71, 1.16, 0.5, 0.38, 0.383, 0.007)
_CENTRES_MM: Final = (
    (0.32, -0.41, -3.48),
    (218.52, -8.61, 1.26),
    (-19.99, -148.08, -0.53),
    (0.13, -0.76, -3.94),
    (0.18, -61.04, -2.27),
    (-0.03, 0.06, -2.0),
)
PIPER_LINKS: Final = tuple(
    RigidLink(*row, mass_kg, centre_mm, rotor)
    for row, mass_kg, centre_mm, rotor in zip(
        _ROWS, _MASSES_KG, _CENTRES_MM, ROTOR_INERTIAS_KG_M2, strict=True
    )
)
