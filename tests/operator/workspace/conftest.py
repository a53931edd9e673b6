"""A library of two trajectories, opened by its button."""

import pytest

from tests.operator.workspace.actions import Pages


@pytest.fixture
def pages(app_driver):
    return Pages(app_driver)
