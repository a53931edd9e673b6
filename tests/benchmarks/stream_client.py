"""A client's part of a benchmark: ``python -m tests.benchmarks.stream_client PATH RELAY TARGETS``.

It takes the lease and prints a line. On a line of its input it sends targets, each a little way
from where the arm rests after the last, and by turns asks armui, and the bare relay, for what costs
them nothing. Then it prints what it has measured, as JSON: times are Unix, in seconds.
"""

import json
import os
import random
import socket
import sys
import time
from typing import Any

START_DEG = (0.0, 40.0, -50.0, 0.0, 20.0, 0.0)
STEP_DEG = 0.1
_TRIES = 40
PAUSE_S = (0.32, 0.4)
"""Until then the setpoint is at the target, and nothing is sent."""


def begin(arm: Any) -> Any:
    """Take the lease and begin a stream where the arm is sent first.

    Again and again: on a computer that is busy beyond measure the arm may not be heard in time.
    """
    import armui_client  # noqa: PLC0415 - found there

    for left in reversed(range(_TRIES)):
        try:
            arm.lease("a benchmark").take()
            arm.move_joints(START_DEG)
            stream = arm.stream(rate_hz=50)
            stream.hold(START_DEG, 0.5)
        except armui_client.ArmuiError:
            if not left:
                raise
            time.sleep(0.5)
        else:
            return stream
    raise AssertionError


def main() -> None:
    """Measure."""
    os.environ["ARMUI_SOCKET"] = sys.argv[1]
    sys.path.append("resources/clients/armui_client")
    import armui_client  # noqa: PLC0415 - found there

    chance = random.Random(3)
    said_s: list[float] = []
    losses: list[str] = []
    ping_s, echo_s, relayed_s = [], [], []
    with (
        socket.socket(socket.AF_UNIX) as bare,
        armui_client.connect("stream_client.py") as arm,
    ):
        bare.connect(sys.argv[2])
        lines = bare.makefile("rwb")

        def relay(word: bytes) -> tuple[float, float, float]:
            began_s = time.time()
            lines.write(word + b"\n")
            lines.flush()
            there_s = float(lines.readline())
            return began_s, there_s, time.time()

        stream = begin(arm)
        print("ready", flush=True)
        sys.stdin.readline()
        away_deg = 0.0
        while len(said_s) < int(sys.argv[3]):
            time.sleep(chance.uniform(*PAUSE_S))
            away_deg = STEP_DEG - away_deg  # the target that is reached already sends nothing
            began_s = time.time()
            try:
                stream.target((START_DEG[0] + away_deg, *START_DEG[1:]))
            except armui_client.ArmuiError as error:
                losses.append(str(error))
                stream, away_deg = begin(arm), 0.0
                continue
            said_s.append(began_s)
            began_s = time.time()
            arm._connection.ask("ping", {}, 5.0)
            ping_s.append(time.time() - began_s)
            began_s, _, over_s = relay(b"")
            echo_s.append(over_s - began_s)
            began_s, there_s, _ = relay(b"frame")
            relayed_s.append(there_s - began_s)
        time.sleep(max(PAUSE_S))  # the last target is on its way, too
    found = {"said_s": said_s, "ping_s": ping_s, "echo_s": echo_s, "relayed_s": relayed_s}
    print(json.dumps(found | {"losses": losses}), flush=True)


if __name__ == "__main__":
    main()
