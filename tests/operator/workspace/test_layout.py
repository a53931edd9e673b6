"""Every page in every window is laid out by the rules: ``python -m tests.layout`` has them all."""

import importlib
import pkgutil

import pytest
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QFrame,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QTableWidget,
    QVBoxLayout,
    QWidget,
)

import armui.ui
from armui.ui.dialogs.base import ArmDialog
from armui.ui.shell.workspace import PageWindow
from armui.ui.widgets.page import Page
from armui.ui.widgets.text_label import ElidedLabel
from tests.layout import LANGUAGES, PLACES, SIZES, Look, Shown, kind_at
from tests.layout_rules import findings

pytestmark = [pytest.mark.styled, pytest.mark.timeout(240)]


@pytest.fixture(scope="module")
def shown(qapp, tmp_path_factory):
    """The program, in which one place after another is shown."""
    shown = Shown(qapp, tmp_path_factory.mktemp("layout"))
    yield shown
    shown.close()


@pytest.mark.each_pair("every page in all sizes, both languages, with and without the drawer")
@pytest.mark.parametrize("drawer", [False, True], ids=["alone", "drawer"])
@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_is_cut_stretched_scrolled_covered_or_hidden(shown, place, size, language, drawer):
    found = shown.faults(place, Look(size, language, drawer))
    assert not [str(each) for each in found if each.exception is None]


def test_every_page_and_dialog_is_looked_at():
    for module in pkgutil.walk_packages(armui.ui.__path__, "armui.ui."):
        importlib.import_module(module.name)
    there = {
        each
        for kind in (Page, ArmDialog)
        for each in kind.__subclasses__()
        if each.__module__.startswith("armui.")
    }
    assert there - {PageWindow} == {kind_at(place) for place in PLACES} & there
    assert len(there) > 25


# What the rules find --------------------------------------------------------------------------


@pytest.fixture
def window(qtbot):
    """A window of 300×300 px with a column."""
    window = QDialog()
    QVBoxLayout(window)
    window.resize(300, 300)
    qtbot.addWidget(window)
    return window


def found_in(window, rule):
    window.show()
    QApplication.processEvents()
    window.layout().activate()
    return [each.words for each in findings(window) if each.rule == rule]


def narrow(widget):
    widget.setFixedWidth(40)
    return widget


def elided():
    label = ElidedLabel()
    label.show_text("A text that is too long for it")
    return label


def table():
    """A column cuts its title beside one that takes the rest."""
    table = QTableWidget(1, 2)
    table.setHorizontalHeaderLabels(["A title", "B"])
    table.setColumnWidth(0, 20)
    table.horizontalHeader().setStretchLastSection(True)
    return table


@pytest.mark.parametrize(
    "make",
    [
        lambda: narrow(QLabel("A text that is too long for it")),
        lambda: narrow(QPushButton("A text that is too long for it")),
        lambda: narrow(QLineEdit("A text that is too long for it")),
        lambda: narrow(elided()),
        table,
    ],
    ids=["label", "button", "field", "elided", "column"],
)
def test_a_cut_text_is_found(window, make):
    window.layout().addWidget(make())
    assert found_in(window, "cut")


def test_a_text_that_fits_is_not(window):
    for widget in (QLabel("A text"), QPushButton("A text"), QLineEdit("A text")):
        window.layout().addWidget(widget)
    assert found_in(window, "cut") == []


def test_what_lies_outside_its_parent_is_found(window):
    inner = QWidget()
    window.layout().addWidget(inner)
    button = QPushButton("A text", inner)
    button.move(-20, 0)
    assert found_in(window, "cut") == ["20 px outside across"]


@pytest.mark.parametrize(("share", "found"), [(0, 0), (1, 1)], ids=["as high", "higher"])
def test_a_card_higher_than_its_content_is_found(window, share, found):
    card = QFrame()
    card.setProperty("card", True)
    QVBoxLayout(card).addWidget(QLabel("A text"))
    window.layout().addWidget(card, share)
    window.layout().addStretch(1 - share)
    assert len(found_in(window, "stretched")) == found


def test_a_button_higher_than_its_text_is_found(window):
    button = QPushButton("A text")
    button.resize(100, 90)
    button.setParent(window)
    assert len(found_in(window, "stretched")) == 1


def test_a_scroll_bar_beside_free_room_is_found(window):
    area = QScrollArea()
    content = QWidget()
    content.setFixedHeight(200)
    area.setWidget(content)
    area.setFixedHeight(100)
    window.layout().addWidget(area)
    window.layout().addStretch(1)
    assert found_in(window, "scrolled")
    area.setFixedHeight(220)
    assert found_in(window, "scrolled") == []


def test_what_lies_over_another_is_found(window):
    _one, other = QPushButton("One", window), QPushButton("Other", window)
    other.move(10, 5)
    assert found_in(window, "covered")
    other.move(10, 200)
    assert found_in(window, "covered") == []


def test_a_stop_under_something_and_a_dialog_over_the_stops_are_found(shown):
    window = shown.driver.window
    cover = QWidget(window)
    stop = shown.driver.find("stop_button")
    cover.setGeometry(stop.parentWidget().geometry())
    cover.show()
    cover.raise_()
    try:
        words = [each.words for each in findings(window) if "stop_button" in each.where]
    finally:
        cover.deleteLater()
    assert words == [f"by {type(cover).__name__} < MainWindow"]


def test_a_window_without_a_stop_is_found(window):
    assert found_in(window, "hidden") == ["no whole StopButton", "no whole HaltButton"]
