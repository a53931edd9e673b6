"""`armui --sim --firmware`, `--joints`: the window's simulated arm is what was asked for."""

from __future__ import annotations

import time

import can
import pytest

from armui import app
from armui.app import open_device
from armui.cli import main
from armui.protocol.firmware_version import VERSION_ID, find_version
from armui.simulated_arms import SIMULATED, SimulatedArms

WITHIN_S = 20.0


@pytest.mark.parametrize(("asked", "told"), [("S-V1.7-3", "S-V1.7-3"), (None, "S-V1.8-9")])
def test_the_arm_tells_the_version(asked: str | None, told: str) -> None:
    text, deadline_s = b"", time.monotonic() + WITHIN_S
    with open_device(SIMULATED[0], SimulatedArms(firmware=asked)) as bus:
        bus.send(can.Message(arbitration_id=VERSION_ID, data=b"\1", is_extended_id=False))
        while find_version(text) is None:
            assert time.monotonic() < deadline_s
            message = bus.recv(timeout=1.0)
            if message is not None and message.arbitration_id == VERSION_ID:
                text += bytes(message.data)
    assert find_version(text) == told


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--firmware", "S-V1.7-3"], "--firmware belongs to --sim"),
        (
            ["--sim", "--generation", "1", "--firmware", "S-V1.7-3"],
            "belongs to --sim in generation",
        ),
        (["--joints", *"123456"], "--joints belongs to --sim"),
        (["--sim", "--joints", *"12345x"], "'x' is no angle; give degrees from -360 to 360"),
        (["--sim", "--joints", *"12345", "nan"], "'nan' is no angle"),
        (["--sim", "--firmware", "1.7"], "'1.7' is no firmware version; write it as S-V1.8-9"),
    ],
)
def test_what_belongs_to_no_simulated_arm_is_refused(words, reason, capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(words)
    assert ended.value.code == 2
    assert reason in capsys.readouterr().err


class StartedError(Exception):
    """The window would open now."""


@pytest.mark.parametrize(
    ("words", "joints"),
    [
        (["--sim"], None),
        (["--sim", "--joints", "0", "-1.5", "2", "0", "0", "-120"], (0, -1.5, 2, 0, 0, -120)),
    ],
)
def test_the_window_is_told_how_the_arm_lies(words, joints, monkeypatch) -> None:
    """Without a word it lies as a real one does."""

    def run(options):
        assert options.sim_joints_deg == joints
        raise StartedError

    monkeypatch.setattr(app, "run", run)
    with pytest.raises(StartedError):
        main(words)
