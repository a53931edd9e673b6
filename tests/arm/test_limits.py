import math

import pytest

from armui.arm.limits import JOINT_NOT_A_NUMBER, JOINT_OUT_OF_LIMITS, check_joint, check_joints
from tests.family import FACTORY_LIMITS


def test_the_factory_limits_are_those_of_the_facts():
    ranges = [(limit.min_deg, limit.max_deg) for limit in FACTORY_LIMITS]
    assert ranges == [(-150, 150), (0, 180), (-170, 0), (-100, 100), (-70, 70), (-120, 120)]
    assert {round(math.radians(limit.max_speed_deg_s), 9) for limit in FACTORY_LIMITS} == {3.0}


@pytest.mark.parametrize("angle_deg", [-150.0, 150.0, 0.0, 150.0004])
def test_an_angle_within_the_limits_is_not_refused(angle_deg):
    assert check_joint(1, angle_deg, FACTORY_LIMITS[0]) is None


@pytest.mark.parametrize("angle_deg", [150.001, -150.001, 1e9])
def test_an_angle_beyond_the_limits_is_refused_with_its_figures(angle_deg):
    refusal = check_joint(1, angle_deg, FACTORY_LIMITS[0])
    assert refusal is not None
    assert refusal.reason == JOINT_OUT_OF_LIMITS
    assert refusal.params == {"joint": 1, "value": angle_deg, "minimum": -150, "maximum": 150}


@pytest.mark.parametrize("angle_deg", [math.nan, math.inf, -math.inf])
def test_what_is_no_angle_is_refused(angle_deg):
    refusal = check_joint(4, angle_deg, FACTORY_LIMITS[3])
    assert refusal is not None
    assert refusal.reason == JOINT_NOT_A_NUMBER


def test_of_six_angles_the_first_bad_one_is_named():
    refusal = check_joints((0, 0, 0, 0, 71, 121), FACTORY_LIMITS)
    assert refusal is not None
    assert refusal.params["joint"] == 5
