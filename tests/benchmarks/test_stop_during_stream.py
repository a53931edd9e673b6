"""The operator's stop while a client streams: as fast as while he jogs the arm himself.

By turns in the same run, a mouse press on the stop to its frame on the bus: during a jog of the
operator's, and during a stream of a client whose next target waits already. Each press ends the
client's lease; the arm does not listen to the stop, so that the next turn needs no resume.

    python -m pytest tests/benchmarks/test_stop_during_stream.py -s
    STOP_PRESSES=300 python -m pytest tests/benchmarks/test_stop_during_stream.py -s
"""

import os
import sys
import time

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.motion.jog_path import JointJog
from armui.ui.widgets.stop_button import StopButton
from tests.accepted import accepted
from tests.benchmarks.rig import spread
from tests.interface.conftest import Desk, RawClient, until_settled, with_lease

PRESSES = int(os.environ.get("STOP_PRESSES", "60"))
MID = (0.0, 60.0, -60.0, 0.0, 0.0, 0.0)
STOP_ID = 0x150
STOP = bytes([1, 0, 0, 0, 0, 0, 0, 0])
STEP_S = 0.01


def deaf_to_stops(firmware):
    on_frame = firmware.on_frame

    def deaf(frame):
        return [] if frame.arbitration_id == STOP_ID else on_frame(frame)

    firmware.on_frame = deaf


@pytest.mark.skipif(sys.platform != "linux", reason="the interface is not offered there")
def test_stop_during_a_stream(rig, qtbot, tmp_path, capsys, benchmark):
    rig.ready()
    accepted(rig.controller.motion.send_joints(MID))
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(MID, abs=0.05))
    deaf_to_stops(rig.firmware)
    sent_s: list[float] = []
    send = rig._host_bus.send

    def timed(message, timeout=None):
        send(message, timeout)
        if message.arbitration_id == STOP_ID and bytes(message.data) == STOP:
            sent_s.append(time.perf_counter())

    rig._host_bus.send = timed
    stop = StopButton(rig.controller)
    qtbot.addWidget(stop)
    desk = Desk(rig, tmp_path / "r" / "api.sock")
    desk.switch(on=True)
    until_settled(desk)
    client = RawClient(rig, desk.view.path)
    side = 1

    def stream():
        with_lease(client, desk)
        target = [MID[0] + 40.0 * side, *MID[1:]]
        for _ in range(10):
            client.ask("stream.target", lease=client.lease, joints_deg=target)
            rig.step(STEP_S)
        assert rig.controller.jogging.streamed is not None
        client.begin("stream.target", lease=client.lease, joints_deg=target)

    def jog():
        accepted(rig.controller.jogging.start(JointJog(1, side)))
        for _ in range(20):
            rig.step(STEP_S)
        assert rig.controller.jogging.active

    took_ms: dict[str, list[float]] = {"stream": [], "jog": []}
    for number in range(2 * PRESSES):
        (stream, jog)[number % 2]()
        sent_s.clear()
        began_s = time.perf_counter()
        QTest.mousePress(stop, Qt.MouseButton.LeftButton)
        rig.run(0.1)
        took_ms[("stream", "jog")[number % 2]].append(1e3 * (sent_s[0] - began_s))
        assert desk.view.lease is None
        assert not rig.controller.jogging.active
        QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)
        rig.controller._stop.emergency_stop.reset()
        rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
        rig.run(0.5)
        side = -side if number % 2 else side
    client.close()
    desk.end()
    benchmark.extra_info.update({f"{name}_ms": max(each) for name, each in took_ms.items()})
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n{PRESSES} presses each, to the stop's frame on the bus")
        print(spread("while a client streams", took_ms["stream"]))
        print(spread("while the operator jogs", took_ms["jog"]))
