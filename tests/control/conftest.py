"""The queue of commands and questions without an arm."""

import pytest

from tests.control.transaction_line import Program


@pytest.fixture
def program():
    return Program()
