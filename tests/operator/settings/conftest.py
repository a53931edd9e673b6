"""Each panel of the settings, open and read."""

import pytest

from tests.operator.settings.panels import at


@pytest.fixture
def joints(any_driver):
    """Connected, the panel 关节设置 open and read."""
    return at(any_driver, "joint_settings")


@pytest.fixture
def end(any_driver):
    return at(any_driver, "end_limits")


@pytest.fixture
def collision(any_driver):
    return at(any_driver, "collision")
