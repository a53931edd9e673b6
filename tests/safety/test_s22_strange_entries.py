"""S22, S15: one entry that cannot be understood costs itself, and stays in the file as it was."""

import errno
import json
from pathlib import Path

import pytest

from armui.arm.reference_record import ReferenceRecord
from armui.control.cell.cell_reasons import CELL_NOT_READ
from armui.control.safety.kept_references import KeptReferences
from armui.setting_checks import MOST_KEPT
from armui.setting_fields import Settings
from armui.settings import SettingsStore
from tests.safety.test_s21_entries_of_arms import ENTRIES, as_json, enabled, in_file

STRANGE: tuple[object, ...] = (
    7,
    None,
    True,
    [],
    [["bench"]],
    {"name": "crate", "slot": 2},
    "x" * 5000,
    1e300,
    -0.5,
)
"""What no entry is; those an entry of a map may be are left out of it."""


@pytest.fixture
def path(tmp_path):
    return tmp_path / "settings.json"


def strange_ones(name):
    empty = ReferenceRecord().as_entry()
    unknown = {"references": ({"doubtful": [9]}, empty | {"off_deg": {"x": 1}})}
    known = {"references": ({"name": "crate", "slot": 2},)}
    return [each for each in (*STRANGE, *unknown.get(name, ())) if each not in known.get(name, ())]


@pytest.mark.parametrize("name", ENTRIES)
def test_it_costs_no_other_entry_and_stays_until_it_is_chosen_anew(path, name):
    one, other = ENTRIES[name]
    for strange in strange_ones(name):
        kept = {"a": one, "strange": strange, "b": other}
        path.write_text(json.dumps({name: kept, "theme": "dark"}), encoding="utf-8")
        store = SettingsStore(path)
        assert as_json(getattr(store.settings, name)) == as_json({"a": one, "b": other}), strange
        assert store.settings.theme == "dark"
        (problem,) = store.problems
        assert problem.code == "setting_entries_bad"
        assert (problem.params["field"], problem.params["key"]) == (name, "strange")
        # another choice leaves it, whichever
        assert store.change(language="en") is None
        assert store.keep(name, {"c": one}) is None
        assert store.keep(name, {"a": None}) is None
        assert in_file(path, name) == as_json({"strange": strange, "b": other, "c": one})
        # a choice for it takes its place
        assert store.keep(name, {"strange": other}) is None
        assert in_file(path, name) == as_json({"b": other, "c": one, "strange": other})
        assert as_json(getattr(store.settings, name)["strange"]) == as_json(other)
        assert store.strange(name, "strange") is None
        assert SettingsStore(path).problems == ()


def test_many_of_them_are_told_in_one_line(path):
    cells = {f"adapter {number}": number for number in range(300)} | {"good": "bench"}
    path.write_text(json.dumps({"cells": cells}), encoding="utf-8")
    store = SettingsStore(path)
    assert [each.params["count"] for each in store.problems] == [300]
    # they are not what is dropped where there are too many
    store.keep("cells", {f"arm {number}": "crate" for number in range(MOST_KEPT + 5)})
    kept = in_file(path, "cells")
    assert len(kept) == 300 + MOST_KEPT
    assert "good" not in kept
    assert kept["adapter 0"] == 0


def test_a_key_as_long_as_no_adapter_has_costs_no_other(path):
    path.write_text(json.dumps({"cells": {"k" * 5000: "x", "a": "bench"}}), encoding="utf-8")
    assert SettingsStore(path).settings.cells == {"a": "bench"}


@pytest.mark.parametrize("name", ENTRIES)
@pytest.mark.parametrize("whole", [5, ["bench"], "bench", True])
def test_what_is_no_map_at_all_is_put_aside_before_one_takes_its_place(path, name, whole):
    path.write_text(json.dumps({name: whole, "jog_step_deg": 2.5}), encoding="utf-8")
    before = path.read_bytes()
    store = SettingsStore(path)
    assert [each.params["field"] for each in store.problems] == [name]
    assert getattr(store.settings, name) == {}
    store.change(theme="dark")
    assert in_file(path, name) == whole
    store.keep(name, {"a": ENTRIES[name][0]})
    assert in_file(path, name) == as_json({"a": ENTRIES[name][0]})
    aside = json.loads(path.with_name("settings.json.broken").read_bytes())
    assert aside == json.loads(before) | {"theme": "dark"}


# What it means for the arm ------------------------------------------------------------------------


@pytest.mark.parametrize("strange", [7, None, {"name": "crate"}, ["bench"]])
def test_a_cell_that_is_not_understood_is_not_taken_for_none(app_driver, strange):
    key, path = app_driver.device.arm_key(), app_driver.store.path
    path.write_text(json.dumps({"cells": {key: strange, "b": "crate"}}), encoding="utf-8")
    app_driver.store.follow()
    enabled(app_driver)
    assert app_driver.controller.operating_state.cannot_move.reason == CELL_NOT_READ
    assert in_file(path, "cells")[key] == strange
    app_driver.controller.cell.choose("")
    app_driver.run(0.1)
    assert app_driver.controller.operating_state.cannot_move is None
    assert in_file(path, "cells") == {"b": "crate"}


@pytest.mark.parametrize("strange", [7, [2], {"doubtful": ["5"]}, {"pose_deg": [1]}])
def test_a_reference_that_is_not_understood_is_one_in_doubt(path, strange):
    path.write_text(json.dumps({"references": {"a": strange}}), encoding="utf-8")
    store = SettingsStore(path)
    kept = KeptReferences(store)
    assert kept.get("a").doubtful == (1, 2, 3, 4, 5, 6)
    assert kept.get("b") is None
    kept.keep("a", ReferenceRecord((5,), "then", "now", {5: 60.0}))  # the check is finished
    assert KeptReferences(SettingsStore(path)).get("a").doubtful == (5,)


# The file as a whole ------------------------------------------------------------------------------


@pytest.mark.parametrize("text", ["{", "[1]", "", '"light"', '{"cells": {"a": "bench"'])
def test_a_file_that_becomes_no_json_while_it_is_used_is_not_overwritten(path, text):
    store = SettingsStore(path)
    store.change(theme="dark")
    path.write_text(text, encoding="utf-8")
    told = store.keep("cells", {"a": "bench"})
    aside = path.with_name("settings.json.broken")
    assert told.code == "settings_put_aside"
    assert told.params == {"kept": str(aside)}
    assert aside.read_text(encoding="utf-8") == text
    assert store.settings.cells == {"a": "bench"}
    store.follow()  # what is not saved is tried once more
    again = SettingsStore(path)
    assert (again.settings.theme, again.settings.cells, again.problems) == (
        "dark",
        {"a": "bench"},
        (),
    )


def test_the_first_that_is_put_aside_is_not_lost_by_the_next(path):
    for number in range(12):
        path.write_text(f"{{ {number}", encoding="utf-8")
        assert [each.code for each in SettingsStore(path).problems] == ["settings_broken"]
    texts = {each.read_text(encoding="utf-8") for each in path.parent.iterdir()}
    assert {"{ 0", "{ 1", "{ 11"} <= texts


def test_a_file_that_cannot_be_read_is_not_overwritten(path, monkeypatch):
    whole = json.dumps({"cells": {"a": "bench"}})
    path.write_text(whole, encoding="utf-8")
    with monkeypatch.context() as sick:

        def refuse(*_arguments):
            raise OSError(errno.EIO, "Input/output error")

        sick.setattr("armui.settings.open_file", refuse)
        store = SettingsStore(path)
        assert [each.code for each in store.problems] == ["settings_unreadable"]
        assert store.keep("cells", {"b": "crate"}).params["text"] == "Input/output error"
        assert path.read_text(encoding="utf-8") == whole
    store.follow()
    assert in_file(path, "cells") == {"a": "bench", "b": "crate"}
    assert store.settings.cells == {"a": "bench", "b": "crate"}


def test_a_file_that_is_gone_is_written_whole(path):
    store = SettingsStore(path)
    store.change(theme="dark", cells={"a": "bench"})
    path.unlink()
    store.follow()
    assert store.settings.cells == {"a": "bench"}
    store.change(language="en")
    again = SettingsStore(path).settings
    assert (again.theme, again.language, again.cells) == ("dark", "en", {"a": "bench"})


def test_no_file_is_written_that_the_next_start_would_not_read(path):
    store = SettingsStore(path)
    long = {f"{number:04}" + "k" * 4000: "x" * 200 for number in range(MOST_KEPT)}
    assert store.keep("cells", long) is None
    before = path.read_bytes()
    told = store.keep("models", dict.fromkeys(long, "piper"))
    assert told.code == "settings_not_saved"
    assert path.read_bytes() == before
    assert SettingsStore(path).problems == ()


def test_a_link_that_leads_nowhere_is_no_broken_file(path):
    path.symlink_to(Path("elsewhere.json"))
    store = SettingsStore(path)
    assert (store.settings, store.problems) == (Settings(), ())
    assert store.change(theme="dark") is None
    assert not path.with_name("settings.json.broken").exists()
