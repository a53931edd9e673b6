"""The file in which the plots are kept."""

from armui.ui.watch.layout_file import path_beside, read_text, write_text


def test_it_is_kept_though_no_setting_was_ever_changed(tmp_path):
    path = path_beside(tmp_path / "armui" / "settings.json")
    write_text(path, "{}")
    assert read_text(path) == "{}"
