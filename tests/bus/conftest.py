"""An outbox and the driver it gives its frames to."""

import pytest

from armui.bus.outbox import Outbox
from tests.bus.driver import Driver


@pytest.fixture
def driver():
    return Driver()


@pytest.fixture
def time_s():
    return [0.25]


@pytest.fixture
def outbox(driver, time_s):
    box = Outbox(clock=lambda: time_s[0])
    box.attach(driver)
    return box
