"""`armui doctor` as it is called: beside a simulated arm, without one, and without any package."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import uuid
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import can
import pytest

from armui.cli import main
from armui.doctor import add_arguments, run
from armui.doctor.doctor_command import Probes
from armui.doctor.facts import CanFacts, DeviceFacts, LinkFacts, ProgramFacts, ScreenFacts
from armui.protocol.codes import LinkageRole
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.sim.parameters.flash import MemoryFlash

ROOT = Path(__file__).parents[2]


NOTHING = CanFacts()


def look(capsys, *words: str, can_facts: CanFacts = NOTHING) -> tuple[int, dict[str, Any]]:
    """The exit code and the JSON report, with probes that find this computer in order."""
    probes = Probes(
        program=lambda: ProgramFacts("0.1.0", "3.11.9", True, "python3", "Linux"),
        screen=lambda: ScreenFacts(True, "6.11", "xcb", opengl="NVIDIA"),
        can=lambda: can_facts,
    )
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    code = run(parser.parse_args(["--json", "--lang", "en", "--seconds", "1", *words]), probes)
    return code, json.loads(capsys.readouterr().out)


def codes(report: dict[str, Any]) -> list[str]:
    return [each["code"] for each in report["findings"]]


@pytest.fixture
def channel() -> str:
    return uuid.uuid4().hex


@contextmanager
def on_the_bus(firmware: Firmware, channel: str):
    """A simulated arm on a bus of its own."""
    with can.Bus(interface="virtual", channel=channel) as bus:
        node = Node(firmware, bus)
        node.start()
        try:
            yield node
        finally:
            node.stop()


@pytest.fixture
def arm(channel):
    with on_the_bus(Firmware(Generation.TWO, version="S-V1.8-9"), channel) as node:
        yield node


def test_an_arm_is_heard_and_nothing_is_sent(capsys, arm, channel):
    code, report = look(capsys, "--interface", "virtual", "--channel", channel)
    assert code == 0
    assert report["arm_answers"] is True
    assert "arm" in codes(report)
    assert "firmware_unknown" in codes(report)
    assert arm.received == 0


def test_asking_is_said_and_answered(capsys, arm, channel):
    code, report = look(
        capsys, "--ask", "--seconds", "2", "--interface", "virtual", "--channel", channel
    )
    assert code == 0
    assert report["asked"] is True
    assert "firmware" in codes(report)
    assert arm.received > 10
    # questions alone: nothing has moved, and nothing was set
    assert not any(arm.firmware.enabled)


def flash_with(**linkage) -> MemoryFlash:
    flash = MemoryFlash()
    settings = flash.load()
    settings.linkage = settings.linkage._replace(**linkage)
    flash.save(settings)
    return flash


# Failures seen in the field, in the simulated arm.


def test_an_arm_that_has_become_a_teaching_input(capsys, channel):
    flash = flash_with(role=LinkageRole.TEACHING_INPUT)
    with on_the_bus(Firmware(Generation.TWO, flash=flash), channel):
        code, report = look(capsys, "--interface", "virtual", "--channel", channel)
    assert code == 1
    (finding,) = [each for each in report["findings"] if each["code"] == "teaching_input"]
    assert "bytes.fromhex('FC00000000000000')" in finding["commands"][0]
    assert "other_host" not in codes(report)


def test_limits_that_are_damaged_in_the_flash(capsys, channel):
    firmware = Firmware(Generation.TWO, version="S-V1.8-9")
    firmware.corrupt_limits(2)
    with on_the_bus(firmware, channel):
        code, report = look(
            capsys, "--ask", "--seconds", "2", "--interface", "virtual", "--channel", channel
        )
    assert code == 0
    (finding,) = [each for each in report["findings"] if each["code"] == "limits_damaged"]
    assert finding["params"]["joints"] == "2"


def test_a_shifted_arm(capsys, channel):
    flash = flash_with(feedback_offset=0x10, control_offset=0x10)
    with on_the_bus(Firmware(Generation.TWO, flash=flash), channel):
        code, report = look(capsys, "--interface", "virtual", "--channel", channel)
    assert code == 0
    (finding,) = [each for each in report["findings"] if each["code"] == "offset"]
    assert finding["params"]["offset"] == "0x10"


def test_generation_1(capsys, channel):
    with on_the_bus(Firmware(Generation.ONE), channel):
        code, report = look(
            capsys, "--ask", "--seconds", "2", "--interface", "virtual", "--channel", channel
        )
    assert code == 0
    (finding,) = [each for each in report["findings"] if each["code"] == "arm"]
    assert finding["params"]["generation"] == "1"


def test_nobody_there(capsys, channel):
    code, report = look(capsys, "--interface", "virtual", "--channel", channel)
    assert code == 1
    assert "nothing_heard" in codes(report)
    assert report["arm_answers"] is False


def test_a_question_of_ours_is_no_answer(capsys, channel):
    code, report = look(capsys, "--ask", "--interface", "virtual", "--channel", channel)
    assert code == 1
    assert "nothing_heard" in codes(report)


def test_a_device_that_is_not_there(capsys):
    code, report = look(capsys, "--interface", "socketcan", "--channel", "can99")
    assert code == 1
    assert set(codes(report)) & {"bus_gone", "bus_driver_missing", "bus_failed", "bus_down"}


def test_every_device_found_is_listened_to_but_those_switched_off(capsys, arm, channel):
    found = CanFacts(
        links=(LinkFacts("can7", "can", False),),
        devices=(DeviceFacts("socketcan", "can7"), DeviceFacts("virtual", channel)),
    )
    code, report = look(capsys, can_facts=found)
    assert code == 0
    assert codes(report).count("link_down") == 1
    assert not {"bus_down", "bus_gone", "bus_failed"} & set(codes(report))


def test_the_bus_is_left_alone_on_request(capsys, arm, channel):
    found = CanFacts(devices=(DeviceFacts("virtual", channel),))
    code, report = look(capsys, "--no-listen", can_facts=found)
    assert code == 1
    assert "arm" not in codes(report)


@pytest.mark.parametrize("words", [["--seconds", "0"], ["--seconds", "x"], ["--lang", "fr"]])
def test_bad_options_are_refused(capsys, words):
    with pytest.raises(SystemExit):
        look(capsys, *words)


@pytest.mark.timeout(120)
@pytest.mark.parametrize(
    ("language", "words"), [("en", "The package numpy is missing."), ("zh", "缺少软件包 numpy")]
)
def test_without_a_single_package_it_says_which_are_missing(language, words):
    """As on a computer where nothing but Python is installed: no Qt that translates, either."""
    done = subprocess.run(
        [sys.executable, "-S", "-m", "armui", "doctor", "--json", "--lang", language],
        cwd=ROOT, capture_output=True, encoding="utf-8", timeout=100, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT), "PYTHONIOENCODING": "utf-8"},
    )  # fmt: skip
    assert done.stderr == ""
    assert done.returncode == 1
    report = json.loads(done.stdout)
    missing = {each["params"]["package"] for each in report["findings"]
               if each["code"] == "package_missing"}  # fmt: skip
    assert {"numpy", "python-can", "PySide6-Essentials", "cantools"} <= missing
    assert "search_failed" in codes(report)
    assert any(each["text"].startswith(words) for each in report["findings"])


def test_a_window_that_cannot_be_loaded_names_the_doctor(monkeypatch, capsys):
    """As without a system library that Qt wants: the import fails."""
    monkeypatch.setitem(sys.modules, "armui.start", None)
    assert main(["--sim"]) == 2
    assert "`armui doctor` says what is missing" in capsys.readouterr().err
