"""A library of three trajectories: one, three, two."""

import pytest

from tests.operator_library.hands import Shelf


@pytest.fixture
def shelf(desk):
    return Shelf(desk, "one", "three", "two")
