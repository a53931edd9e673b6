"""The window 事件 of an arm to which something has happened."""

import pytest
from PySide6.QtWidgets import QApplication

from armui.sim.faults.schedule import fault
from tests.accepted import accepted
from tests.operator.events.actions import Events


@pytest.fixture
def eventful(app_driver):
    """The program after a motion, a fault that began and ended, and a stop."""
    app_driver.ready()
    app_driver.run(0.5)
    accepted(app_driver.controller.motion.send_joints((20.0, 30.0, -30.0, 10.0, 5.0, 15.0)))
    app_driver.run(2.0)
    hot = fault("motor-overtemperature", 3)
    app_driver.node.faults.start(hot)
    app_driver.run(0.6)
    app_driver.node.faults.end(hot)
    drivers = app_driver.firmware.drivers
    drivers.motor_temperatures_c[2] = drivers.driver_temperatures_c[2] = 30.0
    app_driver.run(0.4)
    app_driver.controller.emergency_stop()
    app_driver.run(0.4)
    return app_driver


@pytest.fixture
def events(eventful):
    yield Events(eventful)
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()
