"""What the window shows at once, which is not to grow unnoticed; see `tests.window_count`."""

import pytest

from tests.window_count import motion_panel


@pytest.mark.styled
def test_the_window_shows_no_more_than_it_did(qapp, tmp_path):
    counts = motion_panel(qapp, tmp_path / "settings.json")
    found = {
        name: (len(each.controls), len(each.figures), len(each.words))
        for name, each in counts.items()
    }
    most = {"open": (67, 21, 63), "folded": (59, 21, 55)}
    for name, limits in most.items():
        assert all(map(int.__le__, found[name], limits)), (name, found[name], limits)
