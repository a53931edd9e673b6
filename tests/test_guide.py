"""The user guide: complete, the same in both languages, and opened at the right place."""

import ast
import re
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.ui.actions.keys import SHORTCUTS
from armui.ui.background import Background
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.guide.guide_page import GuidePage
from armui.ui.guide.place import _REGIONS, _WINDOWS
from armui.ui.guide.text import FOLDER, parse, read_guide, search
from armui.ui.widgets.message_line import MessageLine
from tests.app_driver import PANELS, AtOnce
from tests.each import check_each

pytestmark = pytest.mark.styled

LANGUAGES = ("zh", "en")
MANUAL = [f"M{number}" for number in range(1, 27)]
PROTOCOL = [f"P{number}" for number in range(1, 10)]
BEYOND = [f"B{number}" for number in (*range(1, 23), 26, 28, 32, 33, 37, 38)]
"""What the program has of the functions that go beyond the manual and the protocol."""
MOST_BYTES = 100_000
ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(params=LANGUAGES)
def sections(request):
    return read_guide(request.param)


def test_every_function_stands_in_it(sections):
    def check_number(number):
        assert any(number in section.functions for section in sections)

    check_each([*MANUAL, *PROTOCOL, *BEYOND], check_number)


def test_both_languages_have_the_same_sections_and_functions():
    zh, en = (read_guide(language) for language in LANGUAGES)
    assert [(each.anchor, each.level) for each in zh] == [(each.anchor, each.level) for each in en]
    for one, other in zip(zh, en, strict=True):
        assert one.functions == other.functions, one.anchor
        assert not re.search(r"\b[MPB]\d+\b", one.text + other.text), "numbers are not for readers"


def test_every_place_leads_to_a_section(sections):
    assert {*_WINDOWS.values(), *_REGIONS.values(), *PANELS} <= {
        section.anchor for section in sections
    }


def test_every_window_and_page_has_a_section():
    """Questions and their like belong to the place that asks."""
    asking = {"ConfirmDialog", "SaveQuestion", "CloseQuestion", "UnsavedQuestion", "FileDialog"}
    holding = {"ArmDialog", "Page", "PageWindow", "GuidePage", "MainWindow"}
    classes = set()
    for path in (ROOT / "armui" / "ui").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                bases = {each.id for each in node.bases if isinstance(each, ast.Name)}
                if bases & {"ArmDialog", "Page"}:
                    classes.add(node.name)
    assert classes - asking - holding == set(_WINDOWS)


def test_the_help_of_the_picture_names_mouse_keys_and_figures():
    words = {
        "zh": ("左键拖动", "中键拖动", "滚轮", "双击连杆", "Home", "RX RY RZ", "| — |"),
        "en": ("Left drag", "Middle drag", "Wheel", "Double click", "Home", "RX RY RZ", "| — |"),
    }
    for language, each in words.items():
        text = next(one.text for one in read_guide(language) if one.anchor == "view")
        assert [word for word in each if word not in text] == []


def test_links_lead_somewhere(sections):
    anchors = {section.anchor for section in sections}
    for section in sections:
        for link in re.findall(r"\]\(#([^)]+)\)", section.text):
            assert link in anchors, section.anchor


def test_every_picture_is_there_small_and_used():
    named = set()
    for language in LANGUAGES:
        for section in read_guide(language):
            for picture in section.pictures:
                assert picture.endswith(f"-{language}.png")
                assert (FOLDER / picture).stat().st_size <= MOST_BYTES, picture
                named.add(FOLDER / picture)
    assert named == set((FOLDER / "pictures").iterdir())


def test_the_keys_of_every_window_stand_in_it(sections):
    text = next(section.text for section in sections if section.anchor == "keys")
    for shortcut in SHORTCUTS.values():
        if shortcut.place in ("window", "motion") or shortcut.name == "everywhere.palette":
            keys = shortcut.keys.replace("Return", "回车") if "回车" in text else shortcut.keys
            assert keys in text, shortcut.name


# Reading it ---------------------------------------------------------------------------------------


def test_a_section_ends_where_the_next_begins():
    first, second = parse('x\n<a id="one"></a>\n\n## One\n\na\n\n<a id="two"></a>\n### Two\nb')
    assert (first.anchor, first.title, first.level, first.text) == (
        "one",
        "One",
        2,
        "## One\n\na\n",
    )
    assert (second.title, second.level) == ("Two", 3)


def test_a_section_without_a_heading_is_a_mistake():
    with pytest.raises(ValueError, match="one"):
        parse('<a id="one"></a>\ntext\n')


def test_the_search_wants_every_word_and_puts_titles_first():
    guide = read_guide("en")
    assert search(guide, "bus monitor")[0].anchor == "bus"
    assert search(guide, "gripper zebra") == []
    assert search(guide, "  ") == guide


# The page -----------------------------------------------------------------------------------------


def open_guide(app_driver, window=None):
    window = window or app_driver.window
    window.activateWindow()
    app_driver.wait(window.isActiveWindow)
    QTest.keyClick(window, Qt.Key.Key_F1)
    guide = app_driver.page(GuidePage)
    app_driver.wait(lambda: guide.shown != "")
    return guide


def test_f1_opens_it_at_the_panel(app_driver):
    for panel in PANELS:
        app_driver.click(f"menu_{panel}")
        guide = open_guide(app_driver)
        assert guide.shown == panel
        assert guide.window() is app_driver.window
        assert app_driver.find("operation_area").isVisible()


def test_who_reads_on_elsewhere_is_left_there_until_another_panel_is_seen(app_driver):
    guide = open_guide(app_driver)
    guide.show_section("bus")
    guide.search.setFocus()
    open_guide(app_driver)
    assert guide.shown == "bus"
    app_driver.click("menu_gripper")
    open_guide(app_driver)
    assert guide.shown == "gripper"


def test_f1_opens_it_at_the_dialog(app_driver):
    app_driver.window.pages.show("settings")
    guide = open_guide(app_driver, app_driver.dialog(SettingsDialog))
    assert guide.shown == "settings"


@pytest.mark.parametrize("page", ["plots", "events", "bus", "sessions", "joint_status"])
def test_f1_in_the_drawer_opens_it_at_the_drawer_or_its_page(app_driver, page):
    app_driver.click(f"{page}_button")
    app_driver.find(f"drawer_{page}").setFocus()
    guide = open_guide(app_driver)
    assert guide.shown == "drawer"
    guide.close()
    app_driver.window.activateWindow()
    app_driver.find("drawer").current.take_focus()
    app_driver.find("drawer").current.setFocus()
    assert open_guide(app_driver).shown == page


def test_the_pages_of_the_drawer_stand_in_its_chapter(sections):
    names = [(each.anchor, each.level) for each in sections]
    place = names.index(("drawer", 2))
    assert names[place + 1 : place + 4] == [("plots", 3), ("events", 3), ("bus", 3)]
    assert names[place + 4][1] == 2


def test_contents_search_and_links(app_driver):
    guide = open_guide(app_driver)
    QTest.keyClicks(guide.search, "jitter")
    assert guide.shown == "bus"
    assert guide.browser.extraSelections()
    said = guide.findChild(MessageLine, "guide_message")
    QTest.keyClicks(guide.search, "qx")
    assert said.text() == "No section has “jitterqx”."
    guide.browser.section_wanted.emit("keys")
    assert guide.shown == "keys"
    assert (guide.search.text(), said.text()) == ("", "")
    QTest.keyClick(guide.contents, Qt.Key.Key_Up)
    assert guide.shown == "interface"


def test_it_speaks_the_language_of_the_window(app_driver):
    guide = open_guide(app_driver)
    guide.show_section("motor")
    app_driver.store.change(language="zh")
    app_driver.wait(lambda: "电机设置" in guide.browser.toPlainText())


def test_pictures_are_shown_as_wide_as_there_is_room(app_driver):
    guide = open_guide(app_driver)
    guide.show_section("motion")
    app_driver.wait(lambda: guide.browser.picture_width("pictures/motion-en.png") > 0)
    width = guide.browser.picture_width("pictures/motion-en.png")
    assert 0 < width <= guide.browser.viewport().width()


def test_in_the_drawer_pictures_are_as_high_as_the_page_and_no_higher(app_driver):
    guide = open_guide(app_driver)
    guide.show_section("motion")
    name = "pictures/motion-en.png"
    app_driver.wait(lambda: guide.browser.picture_width(name) > 0)
    low = guide.browser.viewport().height()
    assert guide.browser.picture_width(name) == pytest.approx(low * 16 / 10, abs=3)
    app_driver.click("drawer_take_out")
    app_driver.wait(lambda: guide.browser.picture_width(name) > low)


def test_a_guide_that_cannot_be_read_says_so(app_driver):
    def fails(_language):
        raise OSError("gone")

    guide = GuidePage(Background(AtOnce()), read=fails)
    guide.show()
    QApplication.processEvents()
    assert "gone" in guide.findChild(MessageLine, "guide_message").text()
