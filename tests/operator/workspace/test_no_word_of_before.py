"""After a change of language no word of the other one is left, in any panel, page or message."""

import re
import xml.etree.ElementTree as ET

import pytest
from PySide6.QtCore import QCoreApplication, QModelIndex, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QMenu,
)

from tests.app_driver import PANELS
from tests.gallery_scenes import arm, panels
from tests.gallery_scenes.scene import close_dialogs
from tests.translations import TS

pytestmark = pytest.mark.timeout(300)

_CHINESE = re.compile(r"[\u3400-\u9fff\u3000-\u303f\uff00-\uffef]")
_PLACE = re.compile(r"\{[^}]*\}")
_LEAST_WORDS = 9
"""Letters of a sentence around its figures: «{a} {b}» would be found in everything."""


def english():
    """The texts that Chinese has other words for: those as they are, and those with figures."""
    messages = ET.parse(TS).iter("message")
    pairs = [(each.findtext("source"), each.findtext("translation")) for each in messages]
    texts = {text for text, chinese in pairs if text and text != chinese and len(text) > 3}
    figures = {each for each in texts if "{" in each}
    long = (each for each in figures if len(_PLACE.sub("", each)) > _LEAST_WORDS)
    patterns = [".+?".join(map(re.escape, _PLACE.split(each))) for each in long]
    return texts - figures, re.compile("|".join(patterns), re.DOTALL)


def texts_of(widget):
    """What a widget shows, and tells a screen reader or in its tooltip."""
    yield from (widget.toolTip(), widget.accessibleName(), widget.windowTitle())
    yield from (action.text() for action in widget.actions())
    if isinstance(widget, QLabel | QAbstractButton):
        yield widget.text()
    elif isinstance(widget, QLineEdit):
        yield widget.placeholderText()
    elif isinstance(widget, QComboBox):
        yield from (widget.itemText(place) for place in range(widget.count()))
    elif isinstance(widget, QMenu):
        yield widget.title()
    elif isinstance(widget, QAbstractItemView) and widget.model() is not None:
        model = widget.model()
        for column in range(model.columnCount()):
            yield model.headerData(column, Qt.Orientation.Horizontal)
            for row in range(model.rowCount()):
                yield model.index(row, column, QModelIndex()).data()


_OF_THE_OPERATOR = ("page_name", "points_table", "library_table")
"""Names that somebody gave."""
_ALWAYS_CHINESE = {"中文"}


class Reader:
    def __init__(self, driver):
        self._driver = driver
        self._english, self._with_figures = english()
        self.found = set()

    def read(self, language):
        self._driver.window.layout().activate()
        self._driver.run(0.06)
        for _ in range(3):
            QCoreApplication.processEvents()
        for widget in QApplication.allWidgets():
            shown = widget.isVisible() or isinstance(widget, QMenu)
            if shown and widget.objectName() not in _OF_THE_OPERATOR:
                for text in filter(None, map(str, filter(None, texts_of(widget)))):
                    if self._is_other(text, language):
                        self.found.add((widget.objectName() or type(widget).__name__, text))

    def _is_other(self, text, language):
        if language == "en":
            return _CHINESE.search(text) is not None and text not in _ALWAYS_CHINESE
        lines = text.split("\n")
        return any(each in self._english or self._with_figures.fullmatch(each) for each in lines)


SCENES = {
    "no device": arm.no_device,
    "refused": arm.refused,
    "stopped": arm.stopped,
    "lost": arm.lost,
    "teaching": arm.teaching,
    "collision": arm.collision,
    "tool refused": panels.tool_refused,
    "cell": panels.cell,
}


@pytest.mark.each_value(full="each scene, to both languages")
@pytest.mark.parametrize("languages", [("zh", "en"), ("en", "zh")])
@pytest.mark.parametrize("scene", SCENES)
def test_what_is_seen_is_in_the_language_chosen(app_driver, scene, languages):
    before, after = languages
    app_driver.store.change(language=before)
    SCENES[scene](app_driver)
    for key in ("joint_status", "events", "sessions"):
        app_driver.click(f"{key}_button")
    reader = Reader(app_driver)
    app_driver.store.change(language=after)
    reader.read(after)
    assert not reader.found


@pytest.mark.parametrize("languages", [("zh", "en"), ("en", "zh")])
def test_so_is_what_is_opened_again(pages, languages):
    driver = pages.driver
    before, after = languages
    driver.store.change(language=before)
    arm.moving(driver)  # all panels have been seen
    editor = pages.open_editor()
    editor._actions["jog"].trigger()
    editor._find_bar.open()
    drawer = ("plots", "events", "bus", "sessions")
    for key in drawer:
        driver.click(f"{key}_button")
    dialogs = ("connect", "settings")
    for key in dialogs:
        driver.window.pages.show(key)
        driver.run(0.1)
        close_dialogs()
    reader = Reader(driver)
    driver.store.change(language=after)
    reader.read(after)
    driver.window.pages.trajectories.open_library()
    for key in dialogs:
        driver.window.pages.show(key)
        reader.read(after)
        close_dialogs()
    for key in drawer:
        driver.click(f"{key}_button")
        reader.read(after)
    for key in PANELS:
        driver.click(f"menu_{key}")
        reader.read(after)
    assert not reader.found
