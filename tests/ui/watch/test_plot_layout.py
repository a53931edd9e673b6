"""Which curves stand in which plot; and the file that keeps it."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.telemetry.quantities import QUANTITIES
from armui.ui.watch.layout_file import path_beside, read_text, write_text
from armui.ui.watch.plot_layout import (
    MOST_CURVES,
    MOST_PLOTS,
    SETS,
    PlotLayout,
    Plots,
    from_text,
    tidy,
    to_text,
)

A, B, C = "arm.joint_angle.1", "own.joint_angle.1", "bus.bus_load"


@pytest.mark.parametrize("name", SETS)
def test_every_set_draws_what_exists(name):
    assert tidy(SETS[name]) == SETS[name]
    layout = PlotLayout(SETS[name])
    assert layout.name == name


def test_adding_moving_and_removing():
    first: Plots = ((A,), (B,))
    layout = PlotLayout(first)
    layout.add([C, A], 0)
    assert list(layout.plots) == [(A, C), (B,)]
    layout.add([C])
    assert list(layout.plots) == [(A, C), (B,), (C,)]
    assert layout.name is None
    layout.move(C, 0, 1)
    assert list(layout.plots) == [(A,), (B, C), (C,)]
    layout.move(B, 1, None)
    assert list(layout.plots) == [(A,), (C,), (C,), (B,)]
    layout.remove(1, C)
    assert list(layout.plots) == [(A,), (C,), (B,)]
    layout.remove_plot(0)
    assert list(layout.plots) == [(C,), (B,)]
    assert layout.find(B) == 1
    assert layout.find(A) is None


def test_what_there_is_no_room_for():
    keys = list(QUANTITIES)
    layout = PlotLayout(tuple((key,) for key in keys[:MOST_PLOTS]))
    assert layout.why_not([keys[20]], None) == "plots"
    layout.add(keys[:MOST_CURVES], 0)
    assert layout.why_not([keys[20]], 0) == "curves"
    assert layout.why_not([keys[0]], 0) is None
    assert layout.why_not([keys[20]], 1) is None


@given(st.lists(st.lists(st.sampled_from(list(QUANTITIES)), max_size=20), max_size=20))
def test_a_file_keeps_it(plots):
    kept = tidy(plots)
    assert all(plot and len(plot) == len(set(plot)) <= MOST_CURVES for plot in kept)
    assert len(kept) <= MOST_PLOTS
    assert from_text(to_text(kept, 60.0)) == ((kept, 60.0) if kept else None)


@given(st.recursive(
    st.none() | st.booleans() | st.floats() | st.text() | st.sampled_from([A, "plots", 1e300]),
    lambda inner: st.lists(inner) | st.dictionaries(st.sampled_from(["plots", "span_s"]), inner),
))  # fmt: skip
def test_any_json_is_survived(value):
    found = from_text(json.dumps(value))
    assert found is None or tidy(found[0]) == found[0]


@given(st.text())
def test_any_text_is_survived(text):
    from_text(text)


@pytest.mark.parametrize(
    "text", ["[" * 100_000, "", '{"plots": [["arm.joint_angle.1"]], "span_s": 1e999}', "null"]
)
def test_nonsense_is_no_layout(text):
    assert from_text(text) is None


def test_a_file_beside_the_settings(tmp_path):
    path = path_beside(tmp_path / "settings.json")
    assert read_text(path) == ""
    write_text(path, "{}")
    assert read_text(path) == "{}"
    path.write_bytes(b"\xff\xfe")
    assert read_text(path) == ""
    path.write_bytes(b"x" * 100_000)
    assert read_text(path) == ""
    path.unlink()
    path.mkdir()
    assert read_text(path) == ""
