"""S22: killed at any moment of a save, the program finds the old or the new file, and goes on."""

import json
import os
import subprocess
import sys
from itertools import groupby
from pathlib import Path

import pytest

pytestmark = [
    pytest.mark.skipif(not hasattr(os, "fork"), reason="kills in the manner of POSIX"),
    pytest.mark.timeout(300),
]

FOUND = {
    "settings": ["old", "new"],
    "broken settings": ["old", "new"],
    "cell": ["old", "new"],
    "cell's name": ["old", "old and stand", "stand"],
    "cell's end": ["old", ""],
    "cell's backup": ["old", "put aside", "new"],
}
"""What is found, in this order, the later the kill."""
FEWEST = 12
"""A save calls the system more often than this."""


@pytest.mark.parametrize("what", FOUND)
def test_what_is_found_after_a_kill_is_old_or_new(tmp_path, what):
    command = [sys.executable, "-m", "tests.safety.killed_saves", what, str(tmp_path)]
    done = subprocess.run(command, cwd=Path.cwd(), check=True, capture_output=True, timeout=280)
    found = json.loads(done.stdout)
    assert len(found) > FEWEST
    assert [each for each, _ in groupby(found)] == FOUND[what]
