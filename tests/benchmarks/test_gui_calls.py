"""Names the ten longest calls of the GUI thread while the arm moves; see `gui_calls`."""

import subprocess
import sys

import pytest

SECONDS = 10


@pytest.mark.skipif(sys.platform != "linux", reason="loopback of udp_multicast")
@pytest.mark.timeout(600)
def test_gui_calls(capsys, benchmark):
    table = subprocess.run(
        [sys.executable, "-m", "tests.benchmarks.gui_calls", str(SECONDS)],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\nthe GUI thread's longest calls in {SECONDS} s, by processor time:\n{table}")
    assert len(table.splitlines()) > 5
