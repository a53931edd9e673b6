"""`armui sim`."""

from __future__ import annotations

import argparse
import threading
from pathlib import Path

import can
import pytest

from armui.protocol.addressing import Addressing
from armui.protocol.firmware_version import FirmwareBug
from armui.protocol.generation import Generation, PiperModel
from armui.sim import sim_command
from armui.sim.faults.schedule import FAULTS, Fault
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.sim.talk import ENABLE, frame, mode, tell


@pytest.mark.parametrize(
    ("interface", "channel"),
    [("nosuch", "x"), ("socketcan", "armui-none"), ("serial", "/dev/none")],
)
def test_a_bus_that_cannot_be_opened_gives_a_line_and_exit_code_2(
    interface: str, channel: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert sim_command.run_arm(Firmware(Generation.TWO), interface, channel) == 2
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
                sim_command.run_arm(
                    Firmware(Generation.ONE), "virtual", "test_it_runs", ending=ending
                )
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

    monkeypatch.setattr(sim_command, "_report", interrupt)
    assert sim_command.run_arm(Firmware(Generation.TWO), "virtual", "test_ctrl_c") == 0
    assert not any(thread.name == "simulated-arm" for thread in threading.enumerate())
    assert capsys.readouterr().out.endswith("\n")


def read(*words: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="armui sim")
    sim_command.add_arguments(parser)
    return parser.parse_args(words)


def test_options_left_out() -> None:
    assert vars(read()) == {
        "interface": "udp_multicast",
        "channel": "",
        "bitrate": None,
        "port": None,
        "generation": 2,
        "firmware": None,
        "flash": None,
        "joints": None,
        "fault": [],
        "offset": None,
        "seed": 0,
        "bugs": frozenset(),
        "api_on": False,
        "grant": False,
        "socket": None,
        "trajectories": None,
        "model": PiperModel.PIPER,
    }


@pytest.mark.parametrize(
    ("words", "joints"),
    [([], (0.0,) * 6), (["--joints", "1", "-2", "3", "-4.5", "5", "-6"], (1, -2, 3, -4.5, 5, -6))],
)
def test_it_lies_at_zero_or_as_told(words, joints, monkeypatch) -> None:
    made = []

    def run_arm(arm, *_rest, **_more):
        made.append(arm)
        return 0

    monkeypatch.setattr(sim_command, "run_arm", run_arm)
    assert sim_command.run(read(*words)) == 0
    assert made[0].joints_deg == joints


def test_a_port_of_its_own(monkeypatch, capsys) -> None:
    opened = []

    def refuse(**options):
        opened.append(options)
        raise OSError("no such bus here")

    monkeypatch.setattr(can, "Bus", refuse)
    assert sim_command.run(read("--channel", "239.1.2.3", "--port", "45000")) == 2
    assert opened == [{"interface": "udp_multicast", "channel": "239.1.2.3", "port": 45000}]
    assert sim_command.run(read()) == 2
    assert opened[1:] == [{"interface": "udp_multicast"}]  # others find it there
    assert sim_command.run(read("--interface", "socketcan", "--port", "45000")) == 2
    assert "--port belongs to --interface udp_multicast" in capsys.readouterr().err
    for text in ("0", "65536", "-1", "x"):
        with pytest.raises(SystemExit):
            read("--port", text)


@pytest.mark.parametrize(
    ("error", "advice"),
    [
        (can.CanInterfaceNotImplementedError("msgpack not installed"), "Install what it names"),
        (ImportError("No module named 'msgpack'"), "Install what it names"),
        (OSError("No such device"), "Check that the interface exists"),
    ],
)
def test_the_advice_fits_the_failure(error, advice, monkeypatch, capsys) -> None:
    def refuse(**_options):
        raise error

    monkeypatch.setattr(can, "Bus", refuse)
    assert sim_command.run(read()) == 2
    assert advice in capsys.readouterr().err


def test_bugs() -> None:
    assert read("--bugs", "all").bugs == frozenset(FirmwareBug)
    assert read("--bugs", "zero-feedback,feedback-parts").bugs == {
        FirmwareBug.ZERO_FEEDBACK,
        FirmwareBug.FEEDBACK_PARTS,
    }


@pytest.mark.parametrize(
    ("version", "names", "said"),
    [
        ("S-V1.8-6", {FirmwareBug.FEEDBACK_PARTS}, ""),
        ("S-V1.8-9", set(), "no bug of S-V1.8-9 is known"),
    ],
)
def test_bugs_without_names_are_those_of_the_version(
    version, names, said, capsys, monkeypatch
) -> None:
    made = []

    def run_arm(arm, *_rest, **_more):
        made.append(arm)
        return 0

    monkeypatch.setattr(sim_command, "run_arm", run_arm)
    assert sim_command.run(read("--firmware", version, "--bugs")) == 0
    assert made[0].bugs.present == names
    assert said in capsys.readouterr().err


def test_options(tmp_path: Path) -> None:
    options = read(
        *("--interface", "socketcan", "--channel", "vcan0", "--generation", "2"),
        *("--firmware", "S-V1.5-2", "--flash", str(tmp_path / "arm.json"), "--offset", "0x10"),
        *("--fault", "stall:2@5-10", "--fault", "lost-frames:0.5@1", "--seed", "7"),
    )
    assert (options.firmware, options.offset, options.seed) == ("S-V1.5-2", 0x10, 7)
    assert options.flash.path == tmp_path / "arm.json"
    assert options.fault == [
        Fault("stall", 2, 5.0, 10.0),
        Fault("lost-frames", 0.5, 1.0, None),
    ]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--generation", "3"], "invalid choice"),
        (["--bitrate", "-5"], "'-5' is no bit rate; give bit/s, as 1000000"),
        (["--bitrate", "0"], "'0' is no bit rate"),
        (["--firmware", "1.8"], "'1.8' is no firmware version; write it as S-V1.8-9"),
        (["--bugs", "fleas"], "no bug is called 'fleas'; there are zero-feedback, "),
        (["--flash", "/nowhere/arm.json"], "must be a file in a folder that exists"),
        (["--flash", "/"], "must be a file in a folder that exists"),
        (["--fault", "fire@1"], "no fault is called 'fire'"),
        (["--fault", "stall:9@1"], "the joint is 9; give 1 to 6"),
        (["--offset", "0x30"], "'0x30' is none of 0x00, 0x10, 0x20"),
        (["--offset", "ten"], "'ten' is none of 0x00, 0x10, 0x20"),
        (["--seed", "x"], "invalid int value"),
    ],
)
def test_bad_options_give_a_reason_and_exit_code_2(
    words: list[str], reason: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        read(*words)
    assert ended.value.code == 2
    assert reason in capsys.readouterr().err


def test_a_version_for_generation_1_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert sim_command.run(read("--generation", "1", "--firmware", "S-V1.8-5")) == 2
    assert "--firmware and --bugs belong to generation 2" in capsys.readouterr().err


def test_help_names_every_fault(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        read("--help")
    assert ended.value.code == 0
    help_text = "".join(capsys.readouterr().out.split())
    assert all(name in help_text for name in FAULTS)


def run_with(monkeypatch: pytest.MonkeyPatch, *words: str) -> list[Firmware]:
    """Runs the command on a virtual bus until its first status line; returns the arm."""
    arms: list[Firmware] = []

    def report(node: Node, *_: object) -> None:
        arms.append(node.firmware)
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(sim_command, "_report", report)
        channel = f"test_command {words}"
        assert sim_command.run(read("--interface", "virtual", "--channel", channel, *words)) == 0
    return arms


def test_the_options_reach_the_arm(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    file = str(tmp_path / "arm.json")
    words = ("--flash", file, "--offset", "0x20", "--firmware", "S-V1.5-2")
    (arm,) = run_with(monkeypatch, *words)
    assert arm.addressing == Addressing(feedback_offset=0x20, control_offset=0x20)
    assert b"S-V1.5-2" in b"".join(f.data for f in arm.on_frame(frame("4AF#0100000000000000")))
    tell(arm, "47A#0001020304080000")
    # a restart without --offset: the flash knows
    (again,) = run_with(monkeypatch, "--flash", file)
    assert again.addressing == arm.addressing
    assert again.settings.collision_levels == (0, 1, 2, 3, 4, 8)


def test_planned_faults_reach_the_arm(monkeypatch: pytest.MonkeyPatch) -> None:
    broken: list[str] = []

    def report(node: Node, *_: object) -> None:
        node.stop()
        node.faults.at(4.9)
        broken.append(f"before {node.faults.active}")
        node.faults.at(5.0)
        broken.extend(each.name for each in node.faults.active)
        raise KeyboardInterrupt

    monkeypatch.setattr(sim_command, "_report", report)
    place = ("--interface", "virtual", "--channel", "test_planned_faults")
    assert sim_command.run(read(*place, "--fault", "stall:2@5", "--fault", "latency@5-6")) == 0
    assert broken == ["before []", "stall", "latency"]


def test_a_broken_flash_is_told_and_the_arm_runs(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "arm.json"
    path.write_text("{", encoding="utf-8")
    run_with(monkeypatch, "--flash", str(path))
    assert "is broken, factory values in use" in capsys.readouterr().err


def test_two_arms_on_one_bus_by_offsets() -> None:
    channel = "test_two_arms_on_one_bus"
    with can.Bus(interface="virtual", channel=channel) as host:
        buses = [can.Bus(interface="virtual", channel=channel) for _ in range(2)]
        nodes = []
        for bus, offset in zip(buses, (0x00, 0x10), strict=True):
            arm = Firmware(Generation.TWO)
            tell(arm, f"470#FC{offset:02X}{offset:02X}0000000000")
            nodes.append(Node(arm, bus))
        identifier, data = frame("160#0100000000000000")
        host.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=False))
        for node in nodes:
            node.poll(0.005)
        assert [node.firmware.condition.stopped for node in nodes] == [False, True]
        identifiers = set()
        while (message := host.recv(timeout=0.0)) is not None:
            identifiers.add(message.arbitration_id)
        assert {*range(0x2A1, 0x2A9), *range(0x2B1, 0x2B9)} <= identifiers
        for bus in buses:
            bus.shutdown()


def test_the_status_line_says_what_is_broken() -> None:
    with can.Bus(interface="virtual", channel="test_the_status_line_says") as bus:
        node = Node(Firmware(Generation.TWO), bus, faults=[Fault("stall", 2), Fault("bus-off", 0)])
        node.poll(1.0)
        line = sim_command.status_line(node, sent=0, received=0, load_percent=0.0)
    assert line.endswith("enabled 000000  broken: stall:2, bus-off:0\n")


def test_the_status_line() -> None:
    with can.Bus(interface="virtual", channel="test_the_status_line") as bus:
        node = Node(Firmware(Generation.TWO), bus)
        tell(node.firmware, ENABLE, mode(50))
        node.poll(2.0)
        line = sim_command.status_line(node, sent=3040, received=200, load_percent=39.9)
    assert line == (
        "     2.0 s  sent 3040/s  received 200/s  load 40 %  lost 0  late 0.0 ms  "
        "CAN_CONTROL NORMAL  enabled 111111\n"
    )
