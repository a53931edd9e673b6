"""The render process lowers the priority of all its threads, those of a driver included."""

import json
import subprocess
import sys

import pytest

CODE = """
import json, os, threading
from armui.viewport.process.main import lower_priority
done, numbers = threading.Event(), []
def wait():
    numbers.append(threading.get_native_id())
    done.wait()
threads = [threading.Thread(target=wait) for _ in range(3)]
for thread in threads:
    thread.start()
while len(numbers) < len(threads):
    pass
before = os.getpriority(os.PRIO_PROCESS, 0)
lower_priority()
numbers.append(threading.get_native_id())
print(json.dumps([before, [os.getpriority(os.PRIO_PROCESS, number) for number in numbers]]))
done.set()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="each thread has its own there")
def test_every_thread_gets_the_lower_priority():
    told = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    before, after = json.loads(told.stdout)
    assert len(after) == 4
    assert set(after) == {max(before, 5)}
