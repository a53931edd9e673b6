"""S21: two programs on one settings file or one channel lose nothing, and each says so."""

import json
import subprocess
import sys
import threading
import time

import pytest
from filelock import FileLock

from armui.arm.device import Device
from armui.control.events import Event
from armui.control.link.instance_registry import InstanceRegistry
from armui.control.operating_state import OperatingState
from armui.settings import SETTINGS_IN_USE, SettingsStore
from armui.system.alone import lock_path
from armui.system.presence import Presence
from tests.posix import kill
from tests.ui.fake_controller import FakeController

LOOK_S = 0.01


def test_each_change_of_two_programs_is_kept(tmp_path):
    path = tmp_path / "settings.json"
    first, second = SettingsStore(path), SettingsStore(path)
    assert first.change(theme="dark") is None
    assert second.change(jog_step_deg=2.5) is None
    assert first.change(language="en") is None
    kept = SettingsStore(path).settings
    assert (kept.theme, kept.jog_step_deg, kept.language) == ("dark", 2.5, "en")


def test_what_a_newer_program_keeps_there_stays(tmp_path):
    path = tmp_path / "settings.json"
    path.write_text('{"theme": "dark", "of_tomorrow": [1, 2]}', encoding="utf-8")
    assert SettingsStore(path).change(jog_step_deg=2.5) is None
    kept = json.loads(path.read_text(encoding="utf-8"))
    assert (kept["of_tomorrow"], kept["theme"], kept["jog_step_deg"]) == ([1, 2], "dark", 2.5)


def test_changes_at_the_same_time_lose_none(tmp_path):
    path = tmp_path / "settings.json"
    stores = [SettingsStore(path) for _ in range(2)]
    choices = [{"jog_step_deg": 2.5}, {"theme": "dark"}]
    lost = []

    def change(store, choice):
        for _ in range(20):
            if store.change(**choice) is not None:
                lost.append(choice)
            store.change(language="en")
            store.change(language="zh")

    threads = [
        threading.Thread(target=change, args=pair) for pair in zip(stores, choices, strict=True)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    kept = SettingsStore(path).settings
    assert lost or (kept.jog_step_deg, kept.theme) == (2.5, "dark")


def test_a_file_another_program_holds_is_not_waited_for(tmp_path):
    path = tmp_path / "settings.json"
    store = SettingsStore(path)
    with FileLock(lock_path(path)):
        began_s = time.perf_counter()
        assert store.change(theme="dark").reason == SETTINGS_IN_USE
        assert time.perf_counter() - began_s < 2.0
    assert store.settings.theme == "dark"
    assert not path.exists()


def test_those_who_are_there_count_each_other(tmp_path):
    first, second = Presence(tmp_path / "a"), Presence(tmp_path / "a")
    first.enter()
    assert first.others() == 0
    second.enter()
    assert (first.others(), second.others()) == (1, 1)
    second.leave()
    assert first.others() == 0
    first.leave()
    assert list((tmp_path / "a").iterdir()) == []


def test_a_program_that_was_killed_is_not_there(tmp_path):
    code = (
        "import sys, time; from pathlib import Path; from armui.system.presence import Presence\n"
        "here = Presence(Path(sys.argv[1])); here.enter()\n"
        "print('there', flush=True); time.sleep(60)"
    )
    other = subprocess.Popen([sys.executable, "-c", code, str(tmp_path)], stdout=subprocess.PIPE)
    assert other.stdout.readline() == b"there\n"
    mine = Presence(tmp_path)
    mine.enter()
    assert mine.others() == 1
    kill(other.pid)
    other.wait()
    other.stdout.close()
    assert mine.others() == 0
    mine.leave()


@pytest.fixture
def two(qapp, tmp_path):
    controllers = [FakeController(), FakeController()]
    told: list[list[Event]] = [[], []]
    for controller, events in zip(controllers, told, strict=True):
        controller.noticed.connect(events.append)
    files = [tmp_path / "one.json", tmp_path / "other.json"]
    programs = [
        InstanceRegistry(controller.as_real, file, tmp_path / "run", LOOK_S)
        for controller, file in zip(controllers, files, strict=True)
    ]
    yield controllers, told
    for program in programs:
        program.close()


def test_each_says_that_the_other_is_on_the_channel(two, qtbot):
    controllers, told = two
    can0 = Device("socketcan", "can0", None)
    controllers[0].operating_state_changed.emit(OperatingState(device=can0))
    controllers[1].operating_state_changed.emit(
        OperatingState(device=Device("socketcan", "can1", None))
    )
    qtbot.wait(100)
    assert told == [[], []]
    controllers[1].operating_state_changed.emit(OperatingState(device=can0))
    qtbot.waitUntil(lambda: all(told))
    assert [[(n.code, n.params["device"]) for n in each] for each in told] == [
        [("channel_shared", can0)]
    ] * 2


def test_each_says_that_the_other_has_the_settings_file(qapp, qtbot, tmp_path):
    controllers = [FakeController(), FakeController()]
    told: list[list[Event]] = [[], []]
    programs = []
    for controller, events in zip(controllers, told, strict=True):
        controller.noticed.connect(events.append)
        programs.append(
            InstanceRegistry(controller.as_real, tmp_path / "s.json", tmp_path / "run", LOOK_S)
        )
    qtbot.waitUntil(lambda: all(told))
    assert [[n.code for n in each] for each in told] == [["settings_shared"]] * 2
    for program in programs:
        program.close()
