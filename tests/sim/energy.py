"""The energy of the rigid links, by which their equation is measured."""

import numpy as np

from armui.sim.mechanics.rigid_body import DOWN, G_M_S2


def kinetic_energy_j(body, joints_rad, speeds_rad_s):
    mass_matrix, _ = body.equation(joints_rad, speeds_rad_s)
    return float(speeds_rad_s @ mass_matrix @ speeds_rad_s) / 2.0


def potential_energy_j(body, joints_rad, down=DOWN):
    """Counted from the base."""
    *_, centres = body._place(joints_rad)
    return -G_M_S2 * float(body._masses @ (centres @ np.asarray(down)))
