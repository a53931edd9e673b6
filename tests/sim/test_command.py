"""`armui sim`."""

from __future__ import annotations

import argparse
import threading

import can
import pytest

from armui.protocol.generation import Generation
from armui.sim import command
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.sim.talk import ENABLE, mode, tell


@pytest.mark.parametrize(
    ("interface", "channel"),
    [("nosuch", "x"), ("socketcan", "armui-none"), ("serial", "/dev/none")],
)
def test_a_bus_that_cannot_be_opened_gives_a_line_and_exit_code_2(
    interface: str, channel: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command.run_arm(interface, channel) == 2
    out, error = capsys.readouterr()
    assert out == ""
    assert error.startswith(f"armui sim: cannot open {interface}:{channel}: ")
    assert error.count("\n") == 1


def test_it_runs_until_told_to_end(capsys: pytest.CaptureFixture[str]) -> None:
    ending = threading.Event()
    with can.Bus(interface="virtual", channel="test_it_runs") as host:
        codes: list[int] = []
        thread = threading.Thread(
            target=lambda: codes.append(
                command.run_arm("virtual", "test_it_runs", generation=1, ending=ending)
            )
        )
        thread.start()
        message = host.recv(timeout=5.0)
        ending.set()
        thread.join()
    assert message is not None
    assert codes == [0]
    assert capsys.readouterr().out.startswith("Simulated arm, generation 1, on Virtual bus")


def test_ctrl_c_ends_it_in_order(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "_report", interrupt)
    assert command.run_arm("virtual", "test_ctrl_c") == 0
    assert not any(thread.name == "simulated-arm" for thread in threading.enumerate())
    assert capsys.readouterr().out.endswith("\n")


def test_options() -> None:
    parser = argparse.ArgumentParser()
    command.add_arguments(parser)
    options = parser.parse_args(
        ["--interface", "socketcan", "--channel", "vcan0", "--generation", "1"]
    )
    assert vars(options) == {
        "interface": "socketcan",
        "channel": "vcan0",
        "bitrate": None,
        "generation": 1,
    }


def test_the_status_line() -> None:
    with can.Bus(interface="virtual", channel="test_the_status_line") as bus:
        node = Node(Firmware(Generation.TWO), bus)
        tell(node.firmware, ENABLE, mode(50))
        node.poll(2.0)
        line = command.status_line(node, sent=3040, received=200, load_percent=39.9)
    assert line == (
        "     2.0 s  sent 3040/s  received 200/s  load 40 %  lost 0  late 0.0 ms  "
        "CAN_CONTROL NORMAL  enabled 111111\n"
    )
