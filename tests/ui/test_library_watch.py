"""Whether the library's folders have changed: what counts as a change, and what does not."""

import os

import pytest
from PySide6.QtWidgets import QWidget

from armui.ui.background import Background
from armui.ui.trajectory.library.library_presence import LibraryWatch, folder_times
from tests.app_driver import AtOnce

OLD_NS = 1_000_000_000 * 10**9
"""2001: the time of a change so long ago that a second one has another time."""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "cell").mkdir()
    settle(tmp_path)
    return tmp_path


def settle(folder, at_ns=OLD_NS):
    for each in (folder / "cell", folder):
        os.utime(each, ns=(at_ns, at_ns))


@pytest.fixture
def page(qtbot):
    page = QWidget()
    qtbot.addWidget(page)
    return page


@pytest.fixture
def watch(page, folder):
    return LibraryWatch(folder, page, Background(AtOnce()))


def changes(watch):
    """How often it is said, looked at once."""
    told = []
    watch.changed.connect(lambda: told.append(True))
    watch._ask()
    watch.changed.disconnect()
    return len(told)


def test_a_folder_that_stays_as_it_was_listed_is_no_change(watch):
    watch.on_listed(watch.times(), ("cell",))
    assert [changes(watch) for _ in range(3)] == [0, 0, 0]


@pytest.mark.parametrize("where", ["", "cell"])
def test_a_file_that_comes_is_told_until_it_is_listed(watch, folder, where):
    watch.on_listed(watch.times(), ("cell",))
    watch.on_listed(watch.times(), ("cell",))
    (folder / where / "new.log").touch()
    os.utime(folder / where, ns=(OLD_NS + 1, OLD_NS + 1))
    assert [changes(watch), changes(watch)] == [1, 1]
    watch.on_listed(watch.times(), ("cell",))
    assert changes(watch) == 0


def test_what_changed_a_moment_ago_is_looked_at_again(watch, folder):
    """A second change in the same tick of the disk's clock would bear the same time."""
    (folder / "new.log").touch()
    watch.on_listed(watch.times(), ("cell",))
    assert folder_times(folder, ())[""] is None
    assert changes(watch) == 1
    settle(folder)
    watch.on_listed(watch.times(), ("cell",))
    assert changes(watch) == 0


def test_a_folder_that_comes_or_goes_is_a_change(watch, folder):
    watch.on_listed(watch.times(), ("cell",))
    watch.on_listed(watch.times(), ("cell",))
    (folder / "cell").rmdir()
    os.utime(folder, ns=(OLD_NS, OLD_NS))
    assert changes(watch) == 1
    folder.rmdir()
    watch.on_listed(watch.times(), ())
    assert changes(watch) == 0
    folder.mkdir()
    assert changes(watch) == 1
