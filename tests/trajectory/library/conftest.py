"""A library whose folder is not there yet."""

import pytest

from tests.trajectory.library.contents import opened


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "trajectories"


@pytest.fixture
def library(folder):
    return opened(folder)
