"""A joint's figures from its swing, where friction, lag and gravity are known beforehand."""

import numpy as np
import pytest

from armui.telemetry.swing_figures import figures_of

SPEED = 10.0
TURN_S = 4.0


def curves(behind_deg=0.4, friction_a=0.3, bears_a=lambda angle: 0.0 * angle, noise=0.0):
    """A joint that swings by ±10° to and fro at an even speed."""
    times = np.arange(0.0, 2 * TURN_S, 0.005)
    target = 20.0 * np.abs((times / TURN_S + 0.5) % 2.0 - 1.0) - 10.0
    sign = np.sign(np.gradient(target))
    chance = np.random.default_rng(1)
    angle = target - behind_deg * sign + chance.normal(0.0, noise / 10, len(times))
    current = friction_a * sign + bears_a(angle) + chance.normal(0.0, noise, len(times))
    warm = np.arange(0.0, 8.0, 0.1), np.linspace(30.0, 34.0, 80)
    return {
        "target": (times[::4], target[::4]),
        "angle": (times, angle),
        "current": (times, current),
        "motor": warm,
        "driver": warm,
    }


def measured(**joint):
    return figures_of(curves(**joint), 5.0, signed=True)


def test_friction_and_lag_are_parted_from_gravity():
    figures = measured(bears_a=lambda angle: 2.0 + 0.1 * angle)
    assert figures.behind_deg == pytest.approx(0.4, abs=0.05)
    assert figures.current_a == pytest.approx(0.3, abs=0.03)
    assert figures.bears_a == pytest.approx(2.0, abs=0.1)
    assert (figures.motor_c, figures.driver_c) == (34.0, 34.0)


def test_noise_averages_out():
    figures = measured(noise=0.2)
    assert figures.current_a == pytest.approx(0.3, abs=0.04)
    assert figures.behind_deg == pytest.approx(0.4, abs=0.05)


def test_currents_without_a_sign_tell_no_friction():
    assert figures_of(curves(), 5.0, signed=False).current_a is None


@pytest.mark.parametrize("lost", ["target", "angle", "current"])
def test_without_feedback_there_is_no_measurement(lost):
    found = curves()
    found[lost] = tuple(each[:5] for each in found[lost])
    assert figures_of(found, 5.0, signed=True) is None


def test_nor_without_either_of_the_two_ways():
    found = {name: (at[at < 2.0], value[at < 2.0]) for name, (at, value) in curves().items()}
    assert figures_of(found, 5.0, signed=True) is None


def test_nor_of_a_joint_that_stands_still():
    found = curves()
    found["angle"] = (found["angle"][0], 0.0 * found["angle"][1])
    assert figures_of(found, 5.0, signed=True) is None


def test_nor_at_half_the_speed():
    assert figures_of(curves(), 10.0, signed=True) is None


def test_temperatures_that_were_not_heard_are_none():
    found = curves()
    found["motor"] = found["driver"] = (np.empty(0), np.empty(0))
    figures = figures_of(found, 5.0, signed=True)
    assert (figures.motor_c, figures.driver_c) == (None, None)
