"""What is promised is shown with an arm that says everything as often as a real one."""

import pytest

from tests.gamepad.pads import Pads
from tests.gamepad.piloting import held_ready


@pytest.fixture
def arm_repeats():
    return True


@pytest.fixture
def pads():
    """Gamepads where the program reads them from; none is plugged in yet."""
    return Pads()


@pytest.fixture
def ready(app_driver, pads):
    """The program with an enabled arm, and a pad whose dead-man button is held."""
    return held_ready(app_driver, pads)
