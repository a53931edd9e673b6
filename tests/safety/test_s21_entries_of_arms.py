"""S21: what one program keeps of its arms and devices in the settings file no other one drops."""

import json
import threading
from dataclasses import replace

import pytest

from armui.arm.device import Device
from armui.arm.reference_record import ReferenceRecord
from armui.control.cell.cell_reasons import CELL_NOT_READ
from armui.control.link.arm_key import arm_key
from armui.control.safety.kept_references import KeptReferences
from armui.protocol.generation import PiperModel
from armui.setting_checks import MOST_KEPT
from armui.setting_fields import OF_EACH, Settings
from armui.settings import SettingsStore
from armui.ui.dialogs.kept_models import KeptModels

RECORD = ReferenceRecord((2,), "2026-01-01T08:00:00").as_entry()
ENTRIES = {
    "mountings": ("level", "upside_down"),
    "home_poses": ((1.0, 2.0, 3.0, 4.0, 5.0, 6.0), (6.0, 5.0, 4.0, 3.0, 2.0, 1.0)),
    "gamepad_buttons": ({"stop": "x"}, {"stop": "y"}),
    "models": ("piper", "piper_h"),
    "references": (RECORD, ReferenceRecord((5,)).as_entry()),
    "cells": ("bench", "crate"),
}
"""Two entries that each of them may have."""


@pytest.fixture
def path(tmp_path):
    return tmp_path / "settings.json"


def in_file(path, name):
    return json.loads(path.read_text(encoding="utf-8"))[name]


def as_json(entry):
    return json.loads(json.dumps(entry))


def two(path):
    """Two programs that were started before either kept anything."""
    return SettingsStore(path), SettingsStore(path)


def test_every_setting_that_is_a_map_is_kept_by_entry():
    maps = {name for name, value in vars_of(Settings()).items() if isinstance(value, dict)}
    assert maps == set(OF_EACH) == set(ENTRIES)


def vars_of(settings):
    return {name: getattr(settings, name) for name in Settings.__slots__}


@pytest.mark.parametrize("name", ENTRIES)
def test_neither_drops_what_the_other_kept_of_another_arm(path, name):
    first, second = two(path)
    one, other = ENTRIES[name]
    assert first.keep(name, {"a": one}) is None
    assert second.keep(name, {"b": other}) is None
    assert first.change(theme="dark") is None
    assert first.keep(name, {"c": one}) is None
    assert second.keep(name, {"d": one}) is None
    expected = {"a": one, "b": other, "c": one, "d": one}
    assert in_file(path, name) == as_json(expected)
    assert SettingsStore(path).settings.theme == "dark"


@pytest.mark.parametrize("name", ENTRIES)
def test_of_the_same_arm_the_last_choice_counts(path, name):
    first, second = two(path)
    one, other = ENTRIES[name]
    first.keep(name, {"a": one})
    second.keep(name, {"a": other})
    first.keep(name, {"b": one})  # what it remembers of the arm is not written again
    assert in_file(path, name)["a"] == as_json(other)
    first.keep(name, {"a": one})  # as it remembers, but chosen after the other
    assert in_file(path, name)["a"] == as_json(one)
    assert SettingsStore(path).problems == ()


@pytest.mark.parametrize("name", ENTRIES)
def test_what_is_dropped_is_that_arm_alone(path, name):
    first, second = two(path)
    one, other = ENTRIES[name]
    first.keep(name, {"a": one, "b": one})
    second.keep(name, {"c": other})
    assert first.keep(name, {"a": None}) is None
    assert in_file(path, name) == as_json({"b": one, "c": other})
    assert second.change(**{name: {}}) is None  # all that it knows of
    assert list(in_file(path, name)) in (["b"], [])


def test_a_choice_that_stood_already_counts_for_the_others_too(path):
    first, second = two(path)
    assert first.change(theme="dark") is None
    assert second.change(theme="system") is None
    assert first.change(theme="dark") is None
    assert in_file(path, "theme") == "dark"


def test_what_a_newer_program_keeps_of_an_arm_stays(path):
    newer = {
        "of_tomorrow": {"a": 1},
        "cells": {"a": "bench", "b": {"name": "crate", "slot": 2}},
        "gamepad_buttons": {"Pad": {"stop": "x", "wave": "back"}},
        "references": {"a": {"doubtful": [2], "warmth": [20.5]}},
        "mountings": {"a": "level", "b": "on_a_rail"},
    }
    path.write_text(json.dumps(newer), encoding="utf-8")
    store = SettingsStore(path)
    store.keep("cells", {"a": "shelf"})
    store.keep("gamepad_buttons", {"Pad": {"stop": "y"}})
    store.keep("mountings", {"a": "upside_down"})
    KeptReferences(store).keep("a", ReferenceRecord((2, 3)))
    kept = json.loads(path.read_text(encoding="utf-8"))
    assert kept["of_tomorrow"] == {"a": 1}
    assert kept["cells"] == {"b": {"name": "crate", "slot": 2}, "a": "shelf"}
    assert kept["gamepad_buttons"] == {"Pad": {"stop": "y", "wave": "back"}}
    assert kept["mountings"] == {"b": "on_a_rail", "a": "upside_down"}
    assert (kept["references"]["a"]["doubtful"], kept["references"]["a"]["warmth"]) == (
        [2, 3],
        [20.5],
    )


def test_at_the_same_time_none_is_lost(path):
    stores = two(path)
    told = []

    def keep(store, letter):
        keys = [f"{letter}{number}" for number in range(15)]
        told.extend([store.keep("cells", {key: f"of {letter}"}) for key in keys])

    threads = [threading.Thread(target=keep, args=pair) for pair in zip(stores, "ab", strict=True)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for store in stores:  # who found the other at the file tries again a second later
        store.follow()
    expected = {f"{letter}{number}": f"of {letter}" for letter in "ab" for number in range(15)}
    assert in_file(path, "cells") == expected, told


def test_what_another_program_keeps_is_known_a_look_later(path):
    first, second = two(path)
    second.keep("cells", {"a": "bench"})
    second.change(theme="dark")
    assert first.settings.cells == {}
    first.follow()
    assert first.settings.cells == {"a": "bench"}
    assert first.settings.theme == "light"  # that holds until this one ends
    second.keep("cells", {"a": None, "b": "crate"})
    first.follow()
    assert first.settings.cells == {"b": "crate"}


def test_a_choice_that_is_not_saved_yet_outlives_a_look(path, monkeypatch):
    first, second = two(path)
    second.keep("cells", {"a": "bench", "b": "bench"})
    with monkeypatch.context() as broken:
        broken.setattr("armui.settings.write_whole", full_disk)
        assert first.keep("cells", {"a": "crate"}).code == "settings_not_saved"
        first.follow()
        assert first.settings.cells == {"a": "crate", "b": "bench"}
    first.follow()  # there is room again
    assert in_file(path, "cells") == {"a": "crate", "b": "bench"}


def full_disk(*_arguments):
    raise OSError(28, "No space left on device")


def test_what_waits_to_be_saved_is_not_undone_by_an_older_look(path):
    """A look at the file that hangs, and answers after this program has written."""
    jobs = []

    class Later:
        def submit(self, work):
            jobs.append(work)
            raise RuntimeError

    first, second = two(path)
    second.keep("cells", {"a": "bench"})
    first.write_by(Later(), lambda _problem: None)
    first.follow()
    first.keep("cells", {"a": "crate"})
    for job in reversed(jobs):
        job()
    assert first.settings.cells == in_file(path, "cells") == {"a": "crate"}


def test_so_many_are_remembered_whoever_kept_them(path):
    first, second = two(path)
    first.keep("models", {f"first {number}": "piper" for number in range(MOST_KEPT - 1)})
    second.keep("models", {"second": "piper_h"})
    assert len(in_file(path, "models")) == MOST_KEPT
    first.keep("models", {"newest": "piper_l"})
    kept = list(in_file(path, "models"))
    assert (len(kept), kept[0], kept[-2:]) == (MOST_KEPT, "first 1", ["second", "newest"])


def test_models_of_two_programs(path):
    first, second = (KeptModels(store) for store in two(path))
    candle = Device("gs_usb", "0", 1_000_000, serial="31", model=PiperModel.PIPER_H)
    other = Device("gs_usb", "1", 1_000_000, serial="42", model=PiperModel.PIPER_L)
    first.keep(candle, "15")
    second.keep(other)
    again = KeptModels(SettingsStore(path))
    assert (again.of(candle, "15"), again.of(other)) == (PiperModel.PIPER_H, PiperModel.PIPER_L)


# Doubt (S34) --------------------------------------------------------------------------------------


def test_a_doubt_goes_only_with_the_check_that_clears_it(path):
    first, second = (KeptReferences(store) for store in two(path))
    doubt = ReferenceRecord((2,), "2026-01-01T08:00:00")
    first.keep("a", doubt)
    # the other, which has not looked since, keeps a photo, then a doubt of its own
    second.keep("a", ReferenceRecord(photo="a.jpg"))
    record = KeptReferences(SettingsStore(path)).get("a")
    assert (record.doubtful, record.photo, record.doubted_at) == ((2,), "a.jpg", doubt.doubted_at)
    second.keep("a", ReferenceRecord((5,), "2026-01-02T08:00:00", photo="a.jpg"))
    assert KeptReferences(SettingsStore(path)).get("a").doubtful == (2, 5)
    # the first has checked what it knew of
    first.keep("a", ReferenceRecord((), doubt.doubted_at, "2026-01-03T08:00:00", {}))
    record = KeptReferences(SettingsStore(path)).get("a")
    assert (record.doubtful, record.photo) == ((5,), "a.jpg")


def test_a_doubt_another_program_has_noted_is_asked_for_at_the_next_connection(app_driver):
    app_driver.device = replace(app_driver.device, simulated=False)  # a simulated arm's ends
    app_driver.ready()
    app_driver.run(1.5)
    now = app_driver.controller.operating_state
    key = arm_key(now.device, now.generation, app_driver.controller.state.identity)
    assert key is not None
    app_driver.controller.disconnect_device()
    KeptReferences(SettingsStore(app_driver.store.path)).keep(key, ReferenceRecord((5,), "then"))
    app_driver.store.follow()
    app_driver.connect()
    app_driver.run(0.5)
    assert app_driver.controller.operating_state.reference.doubtful == (5,)


def enabled(arm):
    """Connect, and switch the motors on."""
    arm.connect()
    arm.controller.motors.enable()
    arm.run_until(lambda: all(arm.controller.operating_state.enabled))
    arm.run(0.5)


# The cell of an adapter (S32) ---------------------------------------------------------------------


def test_a_cell_another_program_has_chosen_for_the_adapter_is_asked_for(app_driver):
    theirs = SettingsStore(app_driver.store.path)
    theirs.keep("cells", {app_driver.device.arm_key(): "bench", "another": "crate"})
    app_driver.store.follow()
    enabled(app_driver)
    assert app_driver.controller.operating_state.cannot_move.reason == CELL_NOT_READ
    assert app_driver.controller.cell.choose("").ending is not None
    app_driver.run(0.1)
    assert app_driver.controller.operating_state.cannot_move is None
    assert in_file(app_driver.store.path, "cells") == {"another": "crate"}


def test_it_is_asked_for_even_while_the_adapter_is_open_here(app_driver):
    app_driver.ready()
    app_driver.run(0.5)
    assert app_driver.controller.operating_state.cannot_move is None
    theirs = SettingsStore(app_driver.store.path)
    theirs.keep("cells", {app_driver.device.arm_key(): "bench"})
    app_driver.store.follow()
    app_driver.run(0.1)
    now = app_driver.controller.operating_state
    assert now.cannot_move is not None
    assert now.cannot_move.params == {"name": "bench"}


def test_what_was_chosen_here_stays_as_long_as_the_adapter_is_open(app_driver):
    app_driver.ready()
    app_driver.run(0.5)
    app_driver.controller.cell.choose("")
    theirs = SettingsStore(app_driver.store.path)
    theirs.keep("cells", {app_driver.device.arm_key(): "bench"})
    app_driver.store.follow()
    app_driver.run(0.1)
    assert app_driver.controller.operating_state.cannot_move is None


def test_a_cell_that_is_renamed_takes_the_arms_of_both_along_and_no_other(app_driver):
    app_driver.ready()
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench")
    theirs = SettingsStore(app_driver.store.path)
    theirs.keep("cells", {"b": "bench", "c": "crate", "d": "bench"})
    theirs.keep("cells", {"d": "shelf"})
    app_driver.controller.cell.rename("stand")
    mine = app_driver.device.arm_key()
    expected = {mine: "stand", "b": "stand", "c": "crate", "d": "shelf"}
    assert in_file(app_driver.store.path, "cells") == expected
