"""A few seconds of the random walk: ``python -m tests.window_walk`` takes thousands of steps."""

import pytest

from tests.window_walk import Walk

pytestmark = pytest.mark.styled


@pytest.mark.timeout(120)
def test_some_steps_at_random_leave_everything_in_its_place(qapp, tmp_path):
    walk = Walk(qapp, tmp_path, seed=2)
    try:
        for kind in [""] * 10 + ["dialog", "lists", "stop"] * 2:
            assert walk.step(kind) == [], walk.names
    finally:
        walk.close()
