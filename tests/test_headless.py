"""`armui sim --api-on`: a simulated arm behind the local interface, without a window."""

import json
import signal
import socket
import subprocess
import sys
import time

import pytest

from armui import cli

ARMUI = (sys.executable, "-m", "armui")


@pytest.fixture
def served(tmp_path):
    path = tmp_path / "private" / "api.sock"
    command = [*ARMUI, "sim", "--api-on", "--grant", "--socket", str(path)]
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
        lines = one.makefile("rw", encoding="utf-8")

        def ask(method, **params):
            call = {"jsonrpc": "2.0", "id": 1, "method": method, "params": params}
            lines.write(json.dumps(call) + "\n")
            lines.flush()
            return next(each for each in map(json.loads, lines) if "id" in each)

        def measured():
            return ask("state.get")["result"]["measured"]

        def until(condition):
            until_s = time.monotonic() + 30.0
            while not condition():
                assert time.monotonic() < until_s
                time.sleep(0.1)

        ask("hello", client="a script", protocol=1)
        lease = ask("lease.request", purpose="a test")["result"]["lease"]
        assert "result" in ask("motors.enable", lease=lease)
        until(lambda: all(measured()["enabled"]["value"]))
        there = [5.0, 10.0, -10.0, 0.0, 0.0, 0.0]
        assert "result" in ask("motion.send", lease=lease, angles_deg=there)
        until(lambda: measured()["joints_deg"]["value"] == pytest.approx(there, abs=0.1))


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
    assert percent["schema"] == {"type": "number", "minimum": 0, "maximum": 100, "x-unit": "%"}
    assert methods["motors.enable"]["x-asks-the-operator"] is True
    assert methods["motion.send"]["x-asks-the-operator"] is False
