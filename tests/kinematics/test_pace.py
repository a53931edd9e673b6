"""How fast a path may be followed, as an arm's limits allow."""

import numpy as np
import pytest

from armui.kinematics.pace import Demand, pace


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("rounding", [0.0, 1e-310, 1e-200, 1e-12])
def test_what_moves_by_rounding_alone_limits_nothing(rounding):
    """The first path moves joint 1 only, the second none at all."""
    rates = np.array([[[2.0, rounding], [rounding, rounding]]])
    bends = np.full_like(rates, rounding * 1e-60)
    demand = Demand(rates, bends, np.array([100.0, 100.0]), np.array([300.0, 300.0]))
    speed, acceleration = pace([demand])
    assert speed.tolist() == [50.0, np.inf]
    assert acceleration.tolist() == [150.0, np.inf]
