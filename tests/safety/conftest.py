"""What is promised is shown with an arm that says everything as often as a real one."""

import pytest


@pytest.fixture
def arm_repeats():
    return True
