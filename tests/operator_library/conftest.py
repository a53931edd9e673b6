"""A library of three trajectories: one, three, two."""

import pytest

from tests.operator_library.hands import Shelf
from tests.operator_library.tables import Operator


@pytest.fixture
def shelf(desk):
    return Shelf(desk, "one", "three", "two")


@pytest.fixture
def operator(desk, tmp_path):
    folder = tmp_path / "files"
    folder.mkdir()
    return Operator(desk, folder)
