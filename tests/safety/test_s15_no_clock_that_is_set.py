"""S15, S19: nothing is decided by the time of day, which a user, NTP or a resume may set."""

import re
from pathlib import Path

import armui

ROOMS = ("arm", "bus", "cell", "control", "gamepad", "kinematics", "protocol", "telemetry")
TIME_OF_DAY = re.compile(r"\btime\.time\b|datetime\.now|utcnow|currentDateTime|st_mtime")

ONLY_SHOWN = {
    "control/authority_watch.py": "since when another host is there",
    "control/devices/joint_monitor.py": "since when a joint's state holds",
    "control/event_log/keeper.py": "the name of the log's file",
    "control/link/instance_registry.py": "since when another program is there",
    "control/run/sample_store.py": "when a recording was made",
    "control/sessions/session_recorder.py": "the name of a session, and where its time begins",
}
"""What each of these files needs the time of day for."""
CORRECTED = {
    "bus/multicast.py": "the age of a stamp of the system, never less than 0",
    "bus/line_bus.py": "stamps what comes over the line; nothing is decided by it",
    "bus/receive_clock.py": "the age of a stamp of the system; one of the future is ignored",
}


def test_only_these_know_the_time_of_day():
    root = Path(armui.__file__).parent
    found = {
        path.relative_to(root).as_posix()
        for room in ROOMS
        for path in (root / room).rglob("*.py")
        if TIME_OF_DAY.search(path.read_text("utf-8"))
    }
    assert found == {*ONLY_SHOWN, *CORRECTED}
