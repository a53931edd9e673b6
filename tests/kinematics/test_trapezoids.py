"""The closed form against ruckig, which plans the simulated arm's joints."""

import numpy as np
import pytest
from ruckig import InputParameter, Ruckig, Trajectory

from armui.kinematics import trapezoids

COUNT = 60


@pytest.fixture(scope="module")
def moves():
    draw = np.random.default_rng(11)
    ways = draw.uniform(-170, 170, (COUNT, 6)) * draw.choice([0.0, 1e-3, 0.1, 1.0], (COUNT, 6))
    ways[0] = (60.0, 0.0, -1e-6, 0.0, 0.0, 0.0)
    speeds = draw.uniform(1.0, 172.0, (COUNT, 6))
    accelerations = draw.uniform(50.0, 400.0, (COUNT, 6))
    return ways, speeds, accelerations


def planned(way, speeds, accelerations):
    request = InputParameter(6)
    request.target_position = list(way)
    request.max_velocity = list(speeds)
    request.max_acceleration = list(accelerations)
    plan = Trajectory(6)
    Ruckig(6).calculate(request, plan)
    return plan


def test_six_joints_go_as_ruckig_has_them_go(moves):
    lasting_s = trapezoids.durations(*moves).max(axis=1)

    for index, (way, top, acceleration) in enumerate(zip(*moves, strict=True)):
        plan = planned(way, top, acceleration)
        assert lasting_s[index] == pytest.approx(plan.duration, abs=1e-6)
        even = trapezoids.even_speeds(way, lasting_s[index], acceleration)
        assert (np.abs(even) <= top * (1 + 1e-9)).all()
        for time_s in np.linspace(0.0, plan.duration, 17):
            place = trapezoids.places(time_s, lasting_s[index], even, acceleration)
            assert place == pytest.approx(plan.at_time(time_s)[0], abs=1e-3)


def test_the_time_of_a_place_is_when_the_motion_is_there(moves):
    ways, speeds, accelerations = (np.abs(values[:, 0]) + 1.0 for values in moves)
    lasting_s = trapezoids.durations(ways, speeds, accelerations)
    even = trapezoids.even_speeds(ways, lasting_s, accelerations)

    for share in np.linspace(0.0, 1.0, 21):
        when_s = trapezoids.times(share * ways, ways, speeds, accelerations)
        there = trapezoids.places(when_s, lasting_s, even, accelerations)
        assert there == pytest.approx(share * ways, abs=1e-6)


def test_no_way_takes_no_time():
    nothing = np.zeros(6)

    assert trapezoids.durations(nothing, nothing + 1.0, nothing + 1.0).tolist() == [0.0] * 6
    assert trapezoids.even_speeds(nothing, nothing, nothing + 1.0).tolist() == [0.0] * 6
    assert trapezoids.times(nothing, nothing, nothing + 1.0, nothing + 1.0).tolist() == [0.0] * 6
