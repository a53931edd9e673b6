"""The text of a layout, and what fits a screen."""

import pytest

from armui.ui.shell.workspace_layout import (
    ColumnLayout,
    Place,
    WorkspaceLayout,
    fitted,
    from_text,
    to_text,
)

WHOLE = WorkspaceLayout(
    window=Place(10, 20, 1440, 900),
    maximized=True,
    panel_px=440,
    page_share=0.6,
    drawer_px=260,
    taken_out={"library": Place(-100, 0, 800, 600)},
    columns={"points": ColumnLayout((80, 66), 1, ascending=False)},
)


def test_a_layout_comes_back_as_it_was():
    assert from_text(to_text(WHOLE)) == WHOLE
    assert from_text(to_text(WorkspaceLayout())) == WorkspaceLayout()


@pytest.mark.parametrize(
    "text",
    [
        "",
        "null",
        "[" * 100_000,
        '{"window": [0, 0, 1e9, 3]}',
        '{"window": [0, 0, true, 900]}',
        '{"window": [0, 0, 10, 10]}',
        '{"panel_px": -3, "page_share": 1.5, "drawer_px": "x"}',
        '{"page_share": NaN}',
        '{"taken_out": {"library": [1, 2, 3]}, "columns": {"points": {"widths_px": []}}}',
        '{"columns": {"points": {"widths_px": ["a"]}}, "taken_out": []}',
    ],
)
def test_what_is_not_possible_is_as_at_first(text):
    assert from_text(text) == WorkspaceLayout()


def test_columns_are_held_within_reason():
    found = from_text('{"columns": {"t": {"widths_px": [1, 99999], "sorted_by": 7}}}')
    assert found.columns == {"t": ColumnLayout((20, 4000), -1)}


SCREENS = [Place(0, 0, 1280, 760), Place(1280, 0, 1920, 1040)]


@pytest.mark.parametrize(
    ("place", "expected"),
    [
        (Place(100, 50, 640, 480), Place(100, 50, 640, 480)),  # it fits as it is
        (Place(1300, 10, 800, 600), Place(1300, 10, 800, 600)),  # on the second screen, too
        (Place(0, 0, 1440, 900), Place(0, 0, 1280, 760)),  # larger than the screen
        (Place(-900, -50, 1000, 600), Place(0, 0, 1000, 600)),  # most of it off the edge
        (Place(9000, 9000, 500, 400), Place(780, 360, 500, 400)),  # on a screen that is gone
        (Place(1200, 700, 400, 400), Place(1280, 640, 400, 400)),  # 80 px here, 320 px there
    ],
)
def test_a_window_is_brought_onto_the_screen_that_shows_most_of_it(place, expected):
    assert fitted(place, SCREENS) == expected
