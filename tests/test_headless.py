"""`armui sim --api-on`: a simulated arm behind the local interface, without a window."""

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from armui import cli
from armui.doctor.probes.program import try_priority
from armui.interface.state_report import FIELDS
from armui.protocol.codes import MoveMode
from armui.system.thread_priority import NICE, RaisedBy
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint

ARMUI = (sys.executable, "-m", "armui")


@pytest.fixture
def served(tmp_path):
    path = tmp_path / "private" / "api.sock"
    library = Library(tmp_path / "library")
    library.save(Trajectory("way", points=(Waypoint(MoveMode.MOVE_J, (9.0, 10.0, *(0.0,) * 4)),)))
    command = [*ARMUI, "sim", "--api-on", "--grant", "--socket", str(path)]
    command += ["--trajectories", str(library.folder)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as program:
        assert str(path) in program.stdout.readline()
        yield program, path
        program.send_signal(signal.SIGINT)
        assert program.wait(20) == 0
    assert not path.exists()


def test_a_script_enables_the_arm_and_moves_it(served):
    _program, path = served
    with socket.socket(socket.AF_UNIX) as one:
        one.settimeout(20.0)
        one.connect(str(path))
        lines = one.makefile("r", encoding="utf-8")
        writing, ended = threading.Lock(), threading.Event()

        def say(**call):
            with writing:
                one.sendall(json.dumps({"jsonrpc": "2.0", **call}).encode() + b"\n")

        def ask(method, **params):
            say(id=1, method=method, params=params)
            return next(each for each in map(json.loads, lines) if "id" in each)

        def stay():  # a check may take longer than a silent client keeps the lease
            while not ended.wait(0.2):
                say(method="ping")

        def measured():
            return ask("state.get")["result"]["measured"]

        def until(condition):
            until_s = time.monotonic() + 30.0
            while not condition():
                assert time.monotonic() < until_s
                time.sleep(0.1)

        ask("hello", client="a script", protocol=1)
        stays = threading.Thread(target=stay)
        stays.start()
        granted = ask("lease.request", purpose="a test")
        assert "result" in granted, granted
        lease = granted["result"]["lease"]
        assert "result" in ask("motors.enable", lease=lease)
        until(lambda: all(measured()["enabled"]["value"]))
        there = [5.0, 10.0, -10.0, 0.0, 0.0, 0.0]
        assert "result" in ask("motion.send", lease=lease, angles_deg=there)
        until(lambda: measured()["joints_deg"]["value"] == pytest.approx(there, abs=0.1))
        assert [each["name"] for each in ask("trajectory.list")["result"]] == ["way"]
        assert ask("trajectory.check", name="way")["result"]["errors"] == 0
        run = ask("trajectory.run", lease=lease, name="way")
        assert "number" in run.get("result", {}), run
        until(lambda: measured()["joints_deg"]["value"][0] == pytest.approx(9.0, abs=0.1))
        ended.set()
        stays.join()


def test_it_goes_before_other_programs_where_the_system_permits_it(served):
    program, _path = served
    if try_priority().by is not RaisedBy.SYSTEM:
        pytest.skip("this user may not")
    threads = Path(f"/proc/{program.pid}/task")
    until_s = time.monotonic() + 30.0
    while {os.getpriority(os.PRIO_PROCESS, int(each.name)) for each in threads.iterdir()} != {NICE}:
        assert time.monotonic() < until_s
        time.sleep(0.05)


@pytest.mark.parametrize(
    "more",
    [("--interface", "socketcan"), ("--channel", "can0"), ("--port", "1"), ("--offset", "0x10")],
)
def test_on_a_bus_of_others_it_is_refused(capsys, more):
    assert cli.main(["sim", "--api-on", *more]) == 2
    assert more[0] in capsys.readouterr().err


def test_the_flags_belong_to_it(capsys):
    assert cli.main(["sim", "--grant"]) == 2
    assert "--api-on" in capsys.readouterr().err


def test_the_schema_has_every_operation_that_is_offered(capsys):
    assert cli.main(["api", "--schema"]) == 0
    document = json.loads(capsys.readouterr().out)
    methods = {each["name"]: each for each in document["methods"]}
    assert {"hello", "stream.target", "motion.send", "lamps.set"} <= set(methods)
    assert "run.start" not in methods
    (percent,) = (
        each for each in methods["motion.set_speed"]["params"] if each["name"] == "percent"
    )
    assert percent["schema"] == {"type": "integer", "minimum": 0, "maximum": 100, "x-unit": "%"}
    of = {
        (name, each["name"]): (each["required"], each["schema"])
        for name, method in methods.items()
        for each in method["params"]
    }
    assert of["state.subscribe", "rate_hz"][1] == {
        "type": "number",
        "minimum": 0.1,
        "maximum": 200.0,
        "x-unit": "Hz",
        "default": 10.0,
    }
    assert of["state.get", "fields"][1]["items"]["enum"] == list(FIELDS)
    assert of["hello", "client"] == (True, {"type": "string", "minLength": 1, "maxLength": 80})
    figure = {"type": "number", "minimum": -1e6, "maximum": 1e6}
    pose = {"type": "array", "items": figure, "minItems": 6, "maxItems": 6}
    assert of["stream.target", "flange_pose_mm_deg"] == (False, {**pose, "x-unit": "mm, °"})
    assert of["trajectory.run", "lease"][0]
    assert ("trajectory.check", "lease") not in of
    assert all("schema" in each["result"] for each in methods.values())
    assert methods["motors.enable"]["x-asks-the-operator"] is True
    assert methods["motion.send"]["x-asks-the-operator"] is False
