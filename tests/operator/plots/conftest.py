"""The window 曲线 of an arm that has moved."""

import pytest
from PySide6.QtWidgets import QApplication

from tests.accepted import accepted
from tests.operator.plots.actions import Plots


@pytest.fixture
def moved(app_driver):
    """The program after a motion of some seconds."""
    app_driver.ready()
    app_driver.run(1.0)
    target = (20.0, 30.0, -30.0, 10.0, 5.0, 15.0)
    accepted(app_driver.controller.motion.send_joints(target))
    app_driver.run(4.0)
    return app_driver


@pytest.fixture
def plots(moved, monkeypatch):
    plots = Plots(moved, monkeypatch)
    plots.draw()
    yield plots
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()
