"""An operator reads, filters, searches, copies and saves what has happened."""

from __future__ import annotations

import csv
import json

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.control.events import Notice
from armui.settings import SETTINGS_IN_USE
from armui.telemetry.event_json import from_record, to_json
from armui.telemetry.events import Asker, EventKind, Level
from armui.ui.dialogs.files import FileDialog
from armui.ui.watch.events.event_page import EventPage
from armui.ui.watch.events.event_table import EventColumn
from armui.ui.watch.plots_area import PlotPage

HOT = "J3 Motor temperature: Too hot"


def clock(entry, at_s):
    return f"{entry.wall_at(at_s):%H:%M:%S.%f}"[:-3]


def test_a_fault_stands_in_its_row_with_beginning_and_end(events):
    row = events.row(HOT)
    entry = events.model.entry(row)
    assert entry.ended_s - entry.at_s == pytest.approx(0.6, abs=0.1)
    assert events.cell(row, EventColumn.BEGIN) == clock(entry, entry.at_s)
    assert events.cell(row, EventColumn.END) == clock(entry, entry.ended_s)
    assert events.cell(row, EventColumn.KIND) == "Fault"
    assert events.cell(row, EventColumn.WHO) == "Arm"
    hint = events.model.index(row, EventColumn.TEXT).data(Qt.ItemDataRole.ToolTipRole)
    assert hint == events.cell(row, EventColumn.TEXT)  # in a narrow table the text is cut


def test_a_fault_that_begins_while_one_looks_and_ends(events):
    from armui.sim.faults.schedule import fault  # noqa: PLC0415 - here alone

    driver = events.driver
    hot = fault("driver-overtemperature", 5)
    driver.node.faults.start(hot)
    driver.run(0.2)
    events.look()
    row = events.row("J5 Driver temperature: Too hot")
    assert events.cell(row, EventColumn.END) == "ongoing"
    driver.node.faults.end(hot)
    drivers = driver.firmware.drivers
    drivers.motor_temperatures_c[4] = drivers.driver_temperatures_c[4] = 30.0
    driver.run(0.3)
    events.look()
    assert events.cell(row, EventColumn.END) == clock(
        events.model.entry(row), events.model.entry(row).ended_s
    )


def test_a_command_says_who_asked_and_what_became_of_it(events):
    row = events.row("Enable sent to all six motors")
    assert events.cell(row, EventColumn.WHO) == "Operator"
    assert events.cell(row, EventColumn.ANSWER).startswith("✓")
    assert events.cell(row, EventColumn.RESULT).startswith("✓")
    events.click(row)
    detail = events.window.detail.text()
    assert "Answered with 0x476 (setting 0x71)" in detail
    assert "All six motors are enabled." in detail


def test_the_newest_stays_in_sight_until_the_operator_looks_elsewhere(events):
    bar = events.table.verticalScrollBar()
    events.window.window().resize(1000, 500)
    events.look()
    assert bar.maximum() > 0
    events.driver.controller.end_motion()
    events.driver.controller.motion.go_home()
    events.look()
    assert bar.value() == bar.maximum()
    bar.triggerAction(bar.SliderAction.SliderToMinimum)
    events.driver.wait(lambda: not events.bar.follow.isChecked())
    events.driver.controller.motion.go_home()
    events.driver.controller.disconnect_device()
    events.look()
    assert bar.value() == 0
    bar.triggerAction(bar.SliderAction.SliderToMaximum)
    events.driver.wait(events.bar.follow.isChecked)


# Filters -------------------------------------------------------------------------------------


def test_faults_alone(events):
    QTest.keyClick(events.bar.levels, Qt.Key.Key_End)
    events.bar.levels.setCurrentIndex(2)
    events.bar.levels.activated.emit(2)
    assert HOT in events.read()
    assert {events.model.entry(row).level for row in range(events.model.rowCount())} == {
        Level.FAULT
    }


def test_one_sort_less_and_one_asker_alone(events):
    unfold_kinds(events)
    events.driver.click(events.bar.kinds[EventKind.FAULT])
    assert HOT not in events.read()
    place = events.bar.askers.findData(Asker.OPERATOR)
    events.bar.askers.setCurrentIndex(place)
    events.bar.askers.activated.emit(place)
    assert set(events.read(EventColumn.WHO)) == {"Operator"}


def test_one_kind_alone_and_all_again_and_the_button_says_which(events):
    bar = events.bar
    unfold_kinds(events)
    assert bar.chosen_kinds.text() == "All kinds"
    events.driver.click(bar.all_kinds)
    assert events.read() == []
    events.driver.click(bar.kinds[EventKind.FAULT])
    assert HOT in events.read()
    assert set(events.read(EventColumn.KIND)) == {"Fault"}
    assert bar.chosen_kinds.text() == "Fault"
    events.driver.click(bar.kinds[EventKind.COMMAND])
    assert bar.chosen_kinds.text() == "2 kinds"
    events.driver.click(bar.all_kinds)
    assert bar.wanted.everything
    assert bar.chosen_kinds.text() == "All kinds"
    bar.chosen_kinds.menu().close()


def unfold_kinds(events):
    button = events.bar.chosen_kinds
    button.menu().popup(button.mapToGlobal(button.rect().bottomLeft()))


def test_the_detail_stands_beside_the_rows_and_goes_when_the_newest_are_followed(events):
    index = events.model.index(events.row(HOT), 0)
    events.table.scrollTo(index, events.table.ScrollHint.PositionAtCenter)
    top_px = events.table.visualRect(index).top()
    events.click(index.row())
    QApplication.processEvents()
    assert events.window.detail.isVisible()
    assert events.table.visualRect(index).top() == top_px
    events.driver.click(events.bar.follow)
    assert events.window.detail.text() == ""


def test_the_curves_of_an_event_are_in_front_of_the_events(events):
    """A window of a page always lies over the main window, and so over the drawer in it."""
    events.driver.window.resize(1280, 800)
    below = events.driver.window.rect().bottomLeft()
    events.window.window().move(events.driver.window.mapToGlobal(below) - QPoint(0, 300))
    events.double_click(events.row(HOT))
    plots = events.driver.page(PlotPage)
    assert plots.window() is not events.driver.window
    assert plots.isVisible()
    events.driver.wait(plots.window().isActiveWindow)


def test_the_curves_stay_in_the_drawer_where_nothing_lies_over_it(events):
    events.window.window().setGeometry(0, 0, 400, 100)
    events.driver.window.move(0, 200)
    events.double_click(events.row(HOT))
    assert events.driver.page(PlotPage).window() is events.driver.window


def test_words_are_searched_in_everything_that_is_written(events):
    everything = events.model.rowCount()
    events.search("j3 hot")
    assert events.read() == [HOT]
    events.search("confirmed the emergency stop")
    # the command itself is found by its end, which its detail tells
    assert len(events.read()) == 2
    events.search("no such thing")
    assert events.read() == []
    assert events.bar.count.text() == f"0 of {everything}"
    events.search("")
    assert events.model.rowCount() == everything


def test_what_passes_comes_in_and_what_does_not_stays_out(events):
    events.search("stop")
    before = events.model.rowCount()
    events.driver.controller.emergency_stop()
    events.driver.controller.lights.set_light(1, 2, 3, 4, 5)
    events.look()
    assert events.model.rowCount() == before + 1


def test_a_menu_narrows_and_widens(events):
    everything = events.model.rowCount()
    events.choose(events.menu(events.row(HOT)), "Only this kind")
    assert set(events.read(EventColumn.KIND)) == {"Fault"}
    events.choose(events.menu(0), "Show all")
    assert events.model.rowCount() == everything


def test_the_chosen_row_stays_chosen_when_others_go(events):
    events.click(events.row(HOT))
    events.choose(events.menu(events.row(HOT)), "Only this kind")
    assert [each.code for each in events.window.table.chosen()] == ["joint_fault"]
    assert HOT in events.window.detail.text()


# Out -----------------------------------------------------------------------------------------


def test_rows_are_copied(events):
    events.click(events.row(HOT))
    QTest.keyClick(events.table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    heading, line, rest = QApplication.clipboard().text().split("\n")
    assert heading.split("\t")[0] == "Time"
    assert HOT in line.split("\t")
    assert rest == ""


def test_all_that_is_shown_is_copied(events):
    events.search("stop")
    events.bar.save.saves["copy"].trigger()
    assert len(QApplication.clipboard().text().splitlines()) == 1 + events.model.rowCount()


def save(events, kind, path):
    events.bar.save.saves[kind].trigger()
    dialog = events.driver.dialog(FileDialog)
    assert dialog.selectedFiles()[0].endswith(f".{kind}")
    dialog.fileSelected.emit(str(path))
    dialog.close()
    return path


def test_csv(events, tmp_path):
    path = save(events, "csv", tmp_path / "events.csv")
    with path.open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["Event"] for row in rows] == events.read()
    (hot,) = [row for row in rows if row["Event"] == HOT]
    assert (hot["Level"], hot["Kind"], hot["Who"]) == ("Fault", "Fault", "Arm")
    assert hot["Time"].startswith("20")


def test_json_is_read_back(events, tmp_path):
    path = save(events, "json", tmp_path / "events.json")
    read = [from_record(each) for each in json.loads(path.read_text(encoding="utf-8"))]
    assert [to_json(each) for each in read] == [to_json(each) for each in events.model.entries()]


def test_text(events, tmp_path):
    path = save(events, "txt", tmp_path / "events.txt")
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1 + events.model.rowCount()


def test_a_file_that_cannot_be_written_is_said(events, tmp_path):
    save(events, "csv", tmp_path / "no such folder" / "events.csv")
    message = events.window._message
    assert message.isVisible()
    assert "Not saved" in message.text()


def test_a_cell_is_no_formula(events, tmp_path):
    events.driver.controller.event_collector._add(
        *(Notice("=HYPERLINK(1)"), EventKind.PROGRAM, Asker.PROGRAM, Level.INFO)
    )
    events.look()
    path = save(events, "csv", tmp_path / "events.csv")
    lines = path.read_text(encoding="utf-8-sig").splitlines()
    cells = [cell for row in csv.reader(lines) for cell in row]
    assert not [cell for cell in cells if cell[:1] in {"=", "+", "@"}]


# Together with the rest of the program -------------------------------------------------------


def test_a_click_moves_the_cursor_of_curves_that_are_seen(events):
    driver = events.driver
    driver.click("plots_button")
    plots = driver.page(PlotPage)
    driver.wait(lambda: plots.board.built and plots._known)
    row = events.row(HOT)
    events.click(row)
    assert plots.board.cursors_s[0] == events.model.entry(row).at_s
    plots.close()
    events.click(row + 1)
    assert plots.board.cursors_s[0] == events.model.entry(row).at_s
    assert not plots.isVisible()


def test_a_double_click_opens_the_curves_there(events):
    row = events.row(HOT)
    events.double_click(row)
    plots = events.driver.page(PlotPage)
    entry = events.model.entry(row)
    events.driver.wait(lambda: plots.board.cursors_s[0] == entry.at_s)
    shown, now_s = plots.board.frame.shown, plots.board.now_s()
    edge_s = plots.board.frame.edge_s(now_s)
    assert edge_s + shown.begin_s <= entry.at_s <= edge_s + shown.end_s


def test_the_end_of_a_fault_is_shown_too(events):
    row = events.row(HOT)
    events.choose(events.menu(row), "Show its end in the curves")
    plots = events.driver.page(PlotPage)
    ended_s = events.model.entry(row).ended_s
    events.driver.wait(lambda: plots.board.cursors_s[0] == ended_s)


def test_the_notice_in_the_status_bar_leads_to_its_entry(eventful):
    eventful.controller.motion.go_home()  # refused: the arm is stopped
    notice = eventful.read("notice_label")
    eventful.click("notice_label")
    window = eventful.page(EventPage)
    (entry,) = window.table.chosen()
    assert entry.code == "refused"
    assert notice.endswith(window.detail.text().splitlines()[0])


def test_a_problem_of_the_program_is_an_event(eventful):

    eventful.window.show_problem(SETTINGS_IN_USE(path="x"))
    eventful.click("notice_label")
    (entry,) = eventful.page(EventPage).table.chosen()
    assert (entry.code, entry.kind) == ("problem", EventKind.PROGRAM)


def test_an_entry_that_a_filter_hides_is_shown_all_the_same(events):
    events.search("no such thing")
    events.driver.controller.motion.go_home()
    events.driver.click("notice_label")
    (entry,) = events.window.table.chosen()
    assert entry.code == "refused"
    assert events.bar.search.text() == ""


def test_another_language_changes_every_word(events):
    events.driver.store.change(language="zh")
    events.driver.wait(lambda: events.window.title == "事件")
    row = events.row("J3 电机温度")
    assert "故障" in events.window.model.index(row, EventColumn.KIND).data()
    assert events.model.headerData(0, Qt.Orientation.Horizontal) == "时间"


# Cost ----------------------------------------------------------------------------------------


def test_a_window_that_is_not_seen_does_nothing(events):
    events.window.close()
    revision = events.model._revision
    assert not events.window._timer.isActive()
    events.driver.controller.lights.set_light(1, 2, 3, 4, 5)
    events.driver.run(1.0)
    assert events.model._revision == revision
    events.driver.click("events_button")
    assert events.window._timer.isActive()
    assert "Sent to lamp 2" in events.read()[-1]


def test_ten_thousand_events_are_searched_in_pieces(events):
    log = events.driver.controller.events
    first = log.entries()[0]
    for number in range(12_000):
        log.add(
            at_s=first.at_s + number,
            wall=first.wall,
            level=Level.INFO,
            kind=EventKind.STATUS,
            who=Asker.ARM,
            code="beyond_limit",
            params={"joint": number % 6 + 1},
        )
    events.look()
    assert events.model.rowCount() == 10_000
    events.bar.search.setText("J4")
    assert events.model.searching
    assert events.model.rowCount() == 10_000  # those of before, until all are looked through
    events.driver.wait(lambda: not events.model.searching)
    assert set(events.read()) == {"J4 beyond its angle limit"}
    assert events.model.rowCount() == sum(each.params["joint"] == 4 for each in log.entries())


def test_in_a_narrow_window_what_happened_is_read_and_the_rest_is_told_below(events):
    across = events.table.horizontalHeader()
    window = events.window.window()
    window.resize(1400, 700)
    assert not events.table.isColumnHidden(EventColumn.END)
    window.resize(800, 700)
    assert events.table.isColumnHidden(EventColumn.END)
    assert across.sectionSize(EventColumn.TEXT) >= 200
    row = events.row(HOT)
    events.click(row)
    entry = events.model.entry(row)
    assert clock(entry, entry.ended_s) in events.window.detail.text()
    window.resize(1400, 700)
    assert not events.table.isColumnHidden(EventColumn.END)
