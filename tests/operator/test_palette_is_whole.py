"""Whatever can be pressed in the window is found by Ctrl+K, whether its page is seen or not."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QDialog,
    QMenu,
    QToolButton,
    QWidget,
)

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.actions.names import read_names
from armui.ui.actions.palette import CommandPalette
from armui.ui.actions.search import rank
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.shell.pages import PAGES, PLACES
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.recording.recording_page import RecordingPage
from armui.ui.translation import Translator
from armui.ui.watch.bus.bus_page import BusPage
from armui.ui.watch.plots_area import PlotPage
from armui.ui.watch.recordings.sessions_page import SessionsPage
from armui.ui.widgets.page import Page
from armui.ui.widgets.press_button import PressButton
from tests.app_driver import PANELS
from tests.operator.library.actions import POINT
from tests.operator.test_palette import command, open_palette, palette_items, rows, targets


@pytest.fixture
def driver(app_driver):
    """A library of one trajectory, the arm ready."""
    Library(app_driver.library_folder).save(Trajectory("one", points=(POINT, POINT)))
    app_driver.ready()
    return app_driver


def open_editor(driver):
    driver.click("library_button")
    driver.page(LibraryPage).open_trajectory("one")


def open_recorder(driver):
    driver.click("library_button")
    driver.page(LibraryPage).open_recorder()


PLACES_OPENED = {
    "library": lambda driver: driver.click("library_button"),
    "editor": open_editor,
    "recording": open_recorder,
    "plots": lambda driver: driver.click("plots_button"),
    "events": lambda driver: driver.click("events_button"),
    "bus": lambda driver: driver.click("bus_button"),
    "sessions": lambda driver: driver.click("sessions_button"),
}

TOLD_ELSEWHERE = {
    **dict.fromkeys(("page_back", "page_crumb"), "ways back: the pages they lead to are offered"),
    **dict.fromkeys(("page_take_out", "drawer_take_out"), "offered of each page by its key"),
    **dict.fromkeys(("drawer_plots", "drawer_events", "drawer_bus"), "the pages' own commands"),
    "drawer_fold": "offered by the name of the drawer",
    **dict.fromkeys(("halt_button", "stop_button"), "everywhere.stop and everywhere.halt"),
    "view_more_button": "its menu, whose entries are offered",
    "commands_button": "the palette itself",
    "recovery_button": "window.next_step",
    "model_mark": "connect.model",
    "view_handles_button": "view.handles",
    "library_clear_search": "empties the search that it stands in",
    "box_insert": "editor.insert_measured",
    "set_own_home_button": "its menu, whose entries are offered",
    "box_gripper_close": "gripper.close_fully",
    "box_gripper_open": "gripper.open_fully",
}
"""Of buttons that no command presses: why none has to."""


def is_shown(thing):
    owner = thing if isinstance(thing, QWidget) else thing.parent()
    while isinstance(owner, QMenu):
        owner = owner.parent()
    return isinstance(owner, QWidget) and owner.isVisible()


def to_be_told(window):
    """All buttons and actions with words that are seen in a window, by their names."""
    found = {}
    for thing in (*window.findChildren(QAbstractButton), *window.findChildren(QAction)):
        name = thing.objectName()
        words = thing.text() or getattr(thing, "accessibleName", str)()
        mute = not any(letter.isalpha() for letter in words)
        closes = isinstance(thing, QAbstractButton) and thing.text() == "Close"
        if mute or not name or name.startswith("qt_") or not is_shown(thing):
            continue
        if not (isinstance(thing, PressButton) or closes or name in TOLD_ELSEWHERE):
            found[name] = thing
    return found


def untold(driver, things):
    """Those that carry out no command of the palette."""
    told = set(targets(driver).values())
    told |= {each.defaultAction() for each in told if isinstance(each, QToolButton)}
    return {
        name
        for name, thing in things.items()
        if thing not in told
        and not (isinstance(thing, QToolButton) and thing.defaultAction() in told)
    }


def go_away(driver):
    """Every page is put away, every window closed."""
    driver.click("menu_motion")
    fold = driver.find("drawer_fold")
    if fold.isVisible():
        driver.click(fold)
    for widget in QApplication.topLevelWidgets():
        if isinstance(widget, QDialog) and widget.isVisible():
            widget.close()


@pytest.mark.parametrize("place", PLACES_OPENED)
def test_what_a_page_offers_is_found_while_it_is_not_seen(driver, place):
    before = to_be_told(driver.window)
    PLACES_OPENED[place](driver)
    seen = {name: each for name, each in to_be_told(driver.window).items() if name not in before}
    assert len(seen) >= 4
    assert untold(driver, seen) == set()
    for source in driver.window.window_actions._sources():
        if source.owner() is not None:
            known = {command.name for command in source.commands}
            assert source.owner().command_targets().keys() <= known
    of_page = {name for name in targets(driver) if name.startswith(f"{place}.")}
    go_away(driver)
    offered = {item.command.name for item in rows(open_palette(driver))}
    assert of_page
    assert of_page <= offered


@pytest.mark.parametrize("panel", PANELS)
def test_the_main_window_itself_is_told_whole(driver, panel):
    driver.click(f"menu_{panel}")
    assert untold(driver, to_be_told(driver.window)) == set()


def test_every_one_is_found_by_all_its_names(qapp, app_driver):
    """Chinese, English, pinyin, initials."""
    names = read_names()
    translator = Translator(qapp)
    translator.set_language("zh")
    try:
        shown = [(item.command, item.title, item.place) for item in palette_items(app_driver)]
    finally:
        translator.set_language("en")
    lost = []
    for action, chinese, place in shown:
        text = names.search_text([chinese], place)
        pinyin = [each for each in (text.pinyin or ((),))[0] if each.isalnum()]
        initials = "".join(syllable[0] for syllable in pinyin)
        asked = (chinese.lower(), action.title.source.lower(), "".join(pinyin), initials)
        lost += [(action.name, each) for each in asked if not each or rank(each, text) is None]
    assert lost == []


# Choosing one whose page is not seen --------------------------------------------------------------


def test_a_trajectory_is_made_from_a_panel(driver):
    command(driver, "create trajectory library")
    field = driver.window.focusWidget()  # it asks for a name, which stands there already
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert driver.page(EditorPage).document.points == ()


def test_what_cannot_be_done_shows_the_page_and_says_why(driver):
    palette = command(driver, "rename trajectory library")
    assert driver.page(LibraryPage).isVisible()
    assert palette.isVisible()
    assert "Choose a trajectory" in palette.findChild(object, "palette_message").text()


def test_the_reason_stays_while_the_arm_goes_on_telling_of_itself(driver):
    palette = command(driver, "rename trajectory library")
    driver.controller.motors.disable()
    driver.run_until(lambda: not any(driver.controller.operating_state.enabled))
    driver.run(0.5)
    message = palette.findChild(QWidget, "palette_message")
    assert message.isVisible()
    QTest.keyClicks(palette.search, " x")
    assert "Choose a trajectory" not in message.text()


def test_what_is_not_there_just_now_says_so(driver):
    palette = command(driver, "results trajectory library")
    assert palette.isVisible()
    assert "nothing" in palette.findChild(object, "palette_message").text()


def test_the_editor_that_was_used_last(driver):
    palette = command(driver, "check trajectory editor")
    assert "Open a trajectory" in palette.findChild(object, "palette_message").text()
    palette.close()
    open_editor(driver)
    driver.click("menu_light")
    command(driver, "insert current pose")
    assert len(driver.page(EditorPage).document.points) == 3


def test_a_button_of_the_same_name_on_another_page_is_not_pressed(driver):
    open_editor(driver)
    command(driver, "send trajectory library")
    driver.page(LibraryPage)


def test_the_drawer(driver):
    command(driver, "bus pause")
    page = driver.page(BusPage)
    assert page.findChild(QAbstractButton, "bus_pause").isChecked()
    command(driver, "fold away")
    assert not page.isVisible()
    palette = command(driver, "fold away")
    assert "folded" in palette.findChild(object, "palette_message").text()


@pytest.mark.parametrize("key", [key for key, page in PAGES.items() if page.movable])
def test_a_page_is_taken_out_and_put_back(driver, key):
    if key == "editor":
        open_editor(driver)
        driver.click("menu_motion")
    name = PLACES[key].text()
    command(driver, f"own window {name}")
    page = next(each for each in QApplication.allWidgets() if is_page(each, key))
    assert page.window() is not driver.window
    palette = command(driver, f"own window {name}")
    assert "in its own window" in palette.findChild(object, "palette_message").text()
    palette.close()
    command(driver, f"put back {name}")
    assert page.window() is driver.window
    assert page.isVisible()


def is_page(widget, key):
    return isinstance(widget, Page) and widget.key == key and widget.isVisible()


def test_the_model_is_gone_to(driver):
    command(driver, "model of the arm")
    box = driver.dialog(ConnectDialog).findChild(QComboBox, "model_box")
    driver.wait(box.hasFocus)


def test_windows_and_curves(driver):
    command(driver, "save what just happened")
    assert driver.page(SessionsPage)
    go_away(driver)
    command(driver, "cursors")
    page = driver.page(PlotPage)
    assert page.findChild(QAbstractButton, "plot_cursors").isChecked()
    go_away(driver)
    command(driver, "save as points")
    driver.page(RecordingPage)
    assert driver.dialog(CommandPalette).isVisible()
