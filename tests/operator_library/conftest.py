"""A library of three trajectories: one, three, two."""

import pytest

from tests.operator_library.actions import FileStore
from tests.operator_library.tables import Operator


@pytest.fixture
def shelf(app_driver):
    return FileStore(app_driver, "one", "three", "two")


@pytest.fixture
def operator(app_driver, tmp_path):
    folder = tmp_path / "files"
    folder.mkdir()
    return Operator(app_driver, folder)
