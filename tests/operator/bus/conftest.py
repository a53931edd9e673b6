"""The window 总线 of an arm that is ready."""

import pytest

from tests.company import OtherHost
from tests.operator.bus.actions import BusMonitor


@pytest.fixture
def arm_repeats():
    return True  # rates and counts are read


@pytest.fixture
def monitor(app_driver):
    app_driver.ready()
    monitor = BusMonitor(app_driver)
    monitor.run()
    return monitor


@pytest.fixture
def company(app_driver):
    """A second host on the bus of the window's arm."""
    host = OtherHost(app_driver)
    yield host
    host.close()
