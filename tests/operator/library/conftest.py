"""A library of three trajectories: one, three, two."""

import pytest

from tests.operator.library.actions import LibraryDriver
from tests.operator.library.tables import Operator


@pytest.fixture
def driver(app_driver):
    return LibraryDriver(app_driver, "one", "three", "two")


@pytest.fixture
def operator(app_driver, tmp_path):
    folder = tmp_path / "files"
    folder.mkdir()
    return Operator(app_driver, folder)
