"""Every drop-down box of the program: its widest entry is not cut, its list shows all its rows."""

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication, QComboBox, QStyle, QStyleOptionComboBox, QToolButton
from shiboken6 import isValid

from armui.trajectory.points.cells import PointColumn
from tests.app_driver import PANELS
from tests.gallery_scenes import gamepads
from tests.gallery_scenes.scene import close_dialogs
from tests.operator import tip_actions
from tests.operator.library import tables
from tests.operator.replay_actions import Replay
from tests.session.recordings import frames, write

pytestmark = [pytest.mark.styled, pytest.mark.timeout(240)]

_LEAST_BOXES = 31


def in_sight():
    """The boxes that are seen, in any window."""
    boxes = (each for each in QApplication.allWidgets() if isinstance(each, QComboBox))
    return [each for each in boxes if each.isVisible()]


def missing_px(box):
    """How much the field of a box is too narrow for its widest entry."""
    option = QStyleOptionComboBox()
    box.initStyleOption(option)
    part = (QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField)
    room = box.style().subControlRect(*part, box).width()
    texts = [box.itemText(place) for place in range(box.count())]
    return max(map(box.fontMetrics().horizontalAdvance, texts), default=0) - room


def missing_in_list_px(box):
    """How much the list of a box is too low for its rows, and too narrow for its widest one."""
    box.showPopup()
    QCoreApplication.processEvents()
    view = box.view()
    rows = min(box.count(), box.maxVisibleItems())
    last = view.visualRect(box.model().index(rows - 1, 0))
    low = last.bottom() - view.viewport().rect().bottom() if rows else 0
    narrow = view.sizeHintForColumn(0) - view.viewport().width()
    box.hidePopup()
    return max(low, narrow)


class Looker:
    """Looks at all boxes that are seen, and remembers what is wrong.

    Attributes:
        seen: The names of the boxes.
        faults: What is wrong.
    """

    def __init__(self, driver):
        self._driver = driver
        self.seen = set()
        self.faults = set()

    def look(self, *parts):
        self._driver.window.layout().activate()
        self._driver.run(0.1)
        for box in filter(isValid, in_sight()):
            owner = box.parentWidget()
            name = box.objectName() or f"{type(owner).__name__} of {type(owner.parent()).__name__}"
            self.seen.add(name)
            field_px = missing_px(box)
            list_px = missing_in_list_px(box) if box.isEnabled() else 0
            if max(field_px, list_px) > 0:
                self.faults.add(f"{name}: {field_px} px in the field, {list_px} in the list")


def walk(pages, looker):
    """Open whatever has a drop-down box, and look at it."""
    driver = pages.driver
    driver.click("menu_cell")
    looker.look()
    driver.click("cell_tool_typed")
    looker.look()
    for tab in driver.window.findChildren(QToolButton):
        if tab.objectName().startswith("cell_tab_"):
            driver.click(tab)
            looker.look()
    for key in PANELS:
        looker.look()
        driver.click(f"menu_{key}")
    for page in ("plots", "events", "bus", "sessions"):
        driver.click(f"{page}_button")
        looker.look()
    driver.click("drawer_fold")
    window = driver.window
    window.pages.trajectories.open_library()
    looker.look()
    window.pages.trajectories.open_editor("one")
    looker.look()
    for key in ("connect", "settings", "export"):
        window.pages.show(key)
        looker.look()
        close_dialogs()


@pytest.mark.parametrize("languages", [("en", "zh"), ("zh", "en")])
def test_no_drop_down_box_cuts_its_entries_also_after_a_change_of_language(
    pages, languages, monkeypatch, tmp_path
):
    driver = pages.driver
    tip_actions.search(driver)  # a search for a tip is open in the panel of the cell
    replay = Replay(driver, monkeypatch)
    log = tmp_path / "log.blf"
    write(log, frames(2.0))
    replay.open(log)
    editor = pages.open_editor()
    editor._actions["jog"].trigger()
    editor._find_bar.open()
    gamepads.settings(driver)
    looker = Looker(driver)
    for language in languages:
        driver.store.change(language=language)
        looker.look()
        if language == languages[0]:
            close_dialogs()
        walk(pages, looker)
    replay.window.close()
    driver.wait(lambda: replay.window.view is None)
    assert not looker.faults
    assert len(looker.seen) >= _LEAST_BOXES


@pytest.mark.each_value(full="each column in both languages")
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("column", [PointColumn.MOVE, PointColumn.GRIPPER, PointColumn.LIGHT])
def test_no_drop_down_box_in_a_cell_cuts_its_entries(pages, language, column):
    pages.driver.store.change(language=language)
    editor = pages.open_editor()
    editor.table.edit(editor.model.index(0, column))
    pages.driver.run(0.1)
    boxes = editor.table.findChildren(QComboBox)
    assert len(boxes) == (2 if column is PointColumn.GRIPPER else 1)
    for box in boxes:
        assert box.isVisible()
        assert missing_px(box) <= 0
        assert missing_in_list_px(box) <= 0


@pytest.mark.parametrize("language", ["en", "zh"])
def test_none_does_where_a_table_is_imported(app_driver, language, tmp_path):
    app_driver.store.change(language=language)
    tables.Operator(app_driver, tmp_path).open(angles=tables.ANGLES)
    looker = Looker(app_driver)
    looker.look()
    assert not looker.faults
    assert len(looker.seen) > 3
