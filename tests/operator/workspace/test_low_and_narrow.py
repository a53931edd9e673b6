"""In the smallest window no page scrolls sideways: its controls go on in another line."""

import pytest
from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtWidgets import QScrollArea, QWidget

from armui.ui.translation import Translator
from tests.app_driver import PANELS
from tests.operator.workspace.actions import rect_in_window

pytestmark = pytest.mark.styled


def sideways(pages):
    """How far each area scrolls to the side."""
    for _ in range(5):
        QCoreApplication.processEvents()
    areas = pages.driver.window.findChildren(QScrollArea)
    return [each.horizontalScrollBar().maximum() for each in areas if each.isVisible()]


@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_page_scrolls_sideways(qapp, pages, language):
    translator = Translator(qapp)
    translator.set_language(language)
    try:
        pages.driver.window.resize(1024, 720)
        pages.open_library()
        assert not any(sideways(pages))
        editor = pages.open_editor()
        assert not any(sideways(pages))
        editor._actions["jog"].trigger()
        editor._find_bar.open()
        assert pages.driver.window.size().toTuple() == (1024, 720)
        assert not any(sideways(pages))
    finally:
        translator.set_language("en")


@pytest.mark.each_value(full="each page in both languages")
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("page", ["events", "sessions", "joint_status", "guide"])
def test_no_page_of_the_drawer_scrolls_sideways(pages, page, language):
    pages.driver.store.change(language=language)
    pages.driver.window.resize(1024, 720)
    pages.driver.click("events_button")
    pages.driver.click(f"drawer_{page}")
    assert not any(sideways(pages))
    assert pages.driver.window.size().toTuple() == (1024, 720)


@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_menu_of_the_picture_opens_below_the_stop(app_driver, language):
    app_driver.store.change(language=language)
    app_driver.window.resize(1264, 756)
    QCoreApplication.processEvents()
    button, stop = app_driver.find("view_more_button"), app_driver.find("stop_button")
    menu_px = button.menu().sizeHint().height()
    lowest_px = rect_in_window(stop).bottom()
    below_px = app_driver.window.height() - rect_in_window(button).bottom()
    # it opens below the button, or above it where that is higher
    assert menu_px <= below_px or menu_px <= rect_in_window(button).top() - lowest_px


def free_below(panel):
    """How much room is left under the lowest part of a panel, in pixels."""
    parts = panel.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
    seen = [each for each in parts if each.isVisible()]
    lowest = max(each.mapTo(panel, QPoint(0, each.height())).y() for each in seen)
    return panel.height() - lowest


@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_card_scrolls_beside_free_room(app_driver, language):
    app_driver.connect()
    app_driver.store.change(language=language)
    scrolling = []
    for key in PANELS:
        app_driver.click(f"menu_{key}")
        app_driver.run(0.1)
        panel = app_driver.find("operation_area").currentWidget()
        for area in panel.findChildren(QScrollArea):
            if area.isVisible() and area.verticalScrollBar().maximum():
                scrolling.append(key)
                assert free_below(panel) <= 20, key
    assert len(scrolling) < len(PANELS) / 2


@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_menu_is_whole_at_1280_800(app_driver, language):
    app_driver.store.change(language=language)
    app_driver.window.resize(1280, 800)
    app_driver.run(0.1)
    entries = app_driver.window.findChild(QScrollArea, "side_menu_entries")
    assert entries.verticalScrollBar().maximum() == 0


@pytest.mark.parametrize("language", ["en", "zh"])
def test_every_joint_is_in_sight_in_a_low_window_and_above_the_legend_of_the_keys(pages, language):
    pages.driver.ready()
    pages.driver.store.change(language=language)
    (card,) = pages.driver.find("operation_area").currentWidget().findChildren(QScrollArea)
    for height in (724, 800):
        pages.driver.window.resize(1280, height)
        pages.driver.run(0.1)
        assert card.verticalScrollBar().maximum() == 0, height
    pages.driver.click("jog_keys_button")
    pages.driver.run(0.1)
    assert pages.driver.find("jog_key_pad").isVisible()
    assert card.verticalScrollBar().maximum() == 0


@pytest.mark.parametrize("language", ["en", "zh"])
def test_help_view_and_settings_stay_in_their_place_whatever_opens(pages, language):
    pages.driver.store.change(language=language)
    names = ("help_button", "reset_view_button", "settings_button")
    picture = pages.driver.find("view_region")

    def places():
        for _ in range(5):
            QCoreApplication.processEvents()
        buttons = [pages.driver.find(name) for name in names]
        assert all(button.isVisible() for button in buttons)
        rects = [rect_in_window(button) for button in buttons]
        assert not any(rect.intersects(rect_in_window(picture)) for rect in rects)
        assert all(each.width() >= each.sizeHint().width() for each in buttons)
        return rects

    first, width, height = places(), picture.width(), picture.height()
    pages.driver.click("events_button")
    assert places() == first
    low = picture.height()
    assert low < height
    pages.driver.find("work_column").setSizes([200, 400])
    assert places() == first
    assert picture.height() != low
    pages.open_library()
    assert places() == first
    assert picture.width() != width
    pages.driver.click("drawer_fold")
    assert places() == first


@pytest.mark.parametrize("language", ["en", "zh"])
def test_what_the_speed_means_has_room_and_the_language_keeps_its_place(app_driver, language):
    app_driver.store.change(language=language)
    app_driver.window.resize(1280, 800)
    for _ in range(5):
        QCoreApplication.processEvents()
    before = rect_in_window(app_driver.find("language_button"))
    app_driver.ready()
    app_driver.run(0.1)
    means = app_driver.find("speed_means")
    assert means.isVisible()
    assert means.text() == "≤ 51.6°/s"
    assert means.width() >= means.sizeHint().width()
    assert app_driver.find("speed_slider").width() >= 100
    assert rect_in_window(app_driver.find("language_button")) == before
