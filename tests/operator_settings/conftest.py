"""Each panel of the settings, open and read."""

import pytest

from tests.operator_settings.panels import at


@pytest.fixture
def joints(any_desk):
    """Connected, the panel 关节设置 open and read."""
    return at(any_desk, "joint_settings")


@pytest.fixture
def end(any_desk):
    return at(any_desk, "end_limits")


@pytest.fixture
def collision(any_desk):
    return at(any_desk, "collision")
