"""Where a moving arm is taken to come to rest, before it does."""

import pytest

from armui.control.safety.momentum import Momentum
from tests.family import FACTORY_LIMITS

STANDS = (0.0,) * 5
BRAKES = (100.0,) * 6


def stops_at(speed, angle, acceleration=100.0):
    """Joint 1 alone moves."""
    motion = Momentum((speed, *STANDS), (acceleration, *BRAKES[1:]), late_s=0.1)
    return motion.stops_at((angle, 10.0, -10.0, 0.0, 0.0, 0.0), FACTORY_LIMITS)[0]


@pytest.mark.parametrize("speed", [-50.0, -1.0, 0.0, 20.0, 50.0])
def test_a_joint_brakes_from_its_speed(speed):
    braking = speed * abs(speed) / 200.0
    assert stops_at(speed, 5.0) == pytest.approx(5.0 + 0.1 * speed + braking)


@pytest.mark.parametrize(("speed", "limit"), [(150.0, 150.0), (-150.0, -150.0)])
def test_it_stops_within_its_limits_whatever_the_arm_says_of_its_brakes(speed, limit):
    """An arm that reports an acceleration of 0 would go on for ever."""
    assert stops_at(speed, 0.0, acceleration=1e-3) == limit


def test_one_that_is_outside_goes_no_further():
    assert stops_at(30.0, 152.0) == 152.0
    assert stops_at(-30.0, -151.0) == -151.0
    assert stops_at(-30.0, 152.0) == pytest.approx(144.5)
