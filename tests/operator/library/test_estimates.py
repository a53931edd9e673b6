"""How long a trajectory will take is told before it is checked, and marked as an estimate."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory.library import store
from armui.trajectory.library.index import IndexEntry
from armui.trajectory.library.store import Library
from armui.trajectory.planning.estimate import estimate_s
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from armui.ui.trajectory.editor.editor_page import EditorPage
from tests.operator.library.actions import POINT, LibraryDriver

LENGTH = 2
OTHER = replace(POINT, target=(60.0, *POINT.target[1:]))
FAR = Waypoint(MoveMode.MOVE_P, (900.0, 0.0, 200.0, 0.0, 85.0, 0.0))


@pytest.fixture
def driver(app_driver):
    app_driver.ready()
    app_driver.run(1.0)
    library = Library(app_driver.library_folder)
    library.save(Trajectory("away", points=(POINT, FAR)))
    library.save(Trajectory("both", points=(POINT, OTHER)))
    library.save(Trajectory("empty"))
    return LibraryDriver(app_driver)


def length(driver, name):
    return next(row[LENGTH] for row in driver.rows() if row[0] == name)


def tip(driver, name):
    index = driver.table.model().index(driver.names().index(name), LENGTH)
    return index.data(Qt.ItemDataRole.ToolTipRole)


def effective(page):
    return page.findChild(QWidget, "run_effective")


def told(page):
    """How long it takes, beside Send: `≈ 3.0 s`; "" while nothing is told."""
    text = effective(page).text().rpartition(" · ")[2].removeprefix("from here ")
    return text if text.endswith((" s", " s a run")) else ""


def seconds(text):
    return float(text.removeprefix("from here ").removeprefix("≈ ").removesuffix(" s"))


def at_full_speed(driver):
    """Of a trajectory that has run: a first run would begin at 20 %."""
    driver.window._run_bar._shared.note_run("both")
    driver.app_driver.controller.motion.set_speed_percent(100)
    driver.app_driver.step()


def test_the_list_tells_estimates_and_why_there_is_none(driver):
    driver.app_driver.wait(lambda: length(driver, "both") != "—")
    assert length(driver, "both").startswith("≈ ")
    assert "estimate" in tip(driver, "both")
    assert length(driver, "away") == "—"
    assert "not known" in tip(driver, "away")
    assert length(driver, "empty") == "—"
    assert "no points" in tip(driver, "empty")


def test_the_checked_figure_takes_its_place_beside_run_alone(driver):
    driver.app_driver.wait(lambda: length(driver, "both") != "—")
    of_file = length(driver, "both")
    driver.choose("both")
    at_full_speed(driver)
    driver.app_driver.wait(lambda: told(driver.window).startswith("≈"))
    estimated = seconds(told(driver.window))
    driver.window._run_bar.check()
    assert not told(driver.window).startswith("≈")
    checked = seconds(told(driver.window))
    assert checked == pytest.approx(estimated, abs=0.2), "the way to the first point counts in both"
    assert length(driver, "both") == of_file, "a check is from where the arm stands"


def test_of_a_loop_both_tell_a_further_run_from_any_row_and_at_a_lower_speed_the_estimate_stays(
    driver,
):
    driver.choose("both")
    at_full_speed(driver)
    driver.window.findChild(QWidget, "run_cycles").setCurrentIndex(2)
    driver.window.findChild(QWidget, "run_first").setValue(2)
    driver.app_driver.wait(lambda: told(driver.window).startswith("≈"))
    estimated = seconds(told(driver.window).removesuffix(" a run"))
    driver.window._run_bar.check()
    driver.app_driver.wait(lambda: not told(driver.window).startswith("≈"))
    checked = seconds(told(driver.window).removesuffix(" a run"))
    assert checked == pytest.approx(estimated, abs=0.2), "every row, and the way back, in both"
    driver.app_driver.controller.motion.set_speed_percent(50)
    driver.app_driver.run(0.5)
    driver.app_driver.wait(lambda: told(driver.window).startswith("at 50 % ≈"))
    driver.window._run_bar.check()
    full, slowed = effective(driver.window).text().split(" · ")
    assert seconds(full.removesuffix(" a run")) == checked
    assert slowed.startswith("at 50 % ≈")


def test_of_a_recording_a_check_counts_no_way_to_it_so_that_slower_is_longer(driver):
    samples = np.array([(t_s, *POINT.target, 0.0) for t_s in (0.0, 0.1, 0.2)])
    driver.library.save(Recording("taught", samples=samples))
    driver.window.refresh(["taught"])
    driver.app_driver.controller.motion.set_speed_percent(20)
    driver.app_driver.step()
    driver.app_driver.wait(lambda: "at 20 % ≈ 1.0 s" in effective(driver.window).text())
    driver.window._run_bar.check()
    driver.app_driver.wait(lambda: not driver.window._run_bar.is_checking)
    assert effective(driver.window).text().startswith("≈ 0.2 s · at 20 % ≈ 1.0 s")


def test_beside_send_it_is_that_of_what_is_chosen(driver):
    driver.choose("both")
    at_full_speed(driver)
    driver.app_driver.wait(lambda: told(driver.window).startswith("≈"))
    assert effective(driver.window).text().startswith("from here ≈")
    assert "from where the arm stands" in effective(driver.window).toolTip()
    driver.window.findChild(QWidget, "run_cycles").setCurrentIndex(2)
    driver.app_driver.wait(lambda: told(driver.window).endswith("a run"))
    assert "without the way to the first point" in effective(driver.window).toolTip()
    driver.window.findChild(QCheckBox, "run_steps").setChecked(True)
    assert told(driver.window) == ""
    assert "as long as the operator" in effective(driver.window).toolTip()


def test_in_the_editor_it_follows_the_points(driver):
    driver.window.open_trajectory("both")
    editor = driver.app_driver.page(EditorPage)
    at_full_speed(driver)
    driver.app_driver.wait(lambda: told(editor).startswith("≈"))
    before = seconds(told(editor))
    editor.document.edit((*editor.document.points, POINT), "once more")
    assert told(editor) == ""
    driver.app_driver.wait(lambda: told(editor).startswith("≈"))
    assert seconds(told(editor)) > before
    editor.document.edit((FAR,), "away")
    driver.app_driver.run(0.1)
    driver.app_driver.wait(lambda: "not known" in effective(editor).toolTip())
    assert told(editor) == ""


def test_a_file_is_planned_once_until_it_changes(driver, monkeypatch):
    planned = []
    known: Any = estimate_s

    def count(content, arm):
        planned.append(content.name)
        return known(content, arm)

    monkeypatch.setattr(store, "estimate_s", count)
    driver.app_driver.wait(lambda: length(driver, "both") != "—")
    assert sorted(planned) == ["away", "both", "empty"]
    planned.clear()
    driver.window.refresh()
    QTest.qWait(500)
    arm = driver.window._checks.arm
    another = Library(driver.library.folder)
    kept = {entry.name: entry for entry in another.entries()}
    assert kept["both"].estimated_for == arm.fingerprint, "it outlives the program"
    assert planned == []
    before = length(driver, "both")
    another.save(Trajectory("both", points=(POINT, OTHER, POINT)), replacing="both")
    driver.window.refresh()
    driver.app_driver.wait(lambda: length(driver, "both") not in {before, "—"})
    assert planned == ["both"]


def test_an_old_cache_and_a_damaged_file_are_no_obstacle(driver):
    (driver.library.folder / "broken.log").write_text("no trajectory\n")
    driver.window.refresh()
    driver.app_driver.wait(lambda: length(driver, "both") != "—")
    assert length(driver, "broken") == "—"
    entry = IndexEntry("x", "points", 1, None, Library(driver.library.folder)._now())
    assert (entry.estimated_s, entry.estimated_for) == (None, "")


def test_a_lower_speed_is_told_beside_the_whole(driver):
    driver.choose("both")
    at_full_speed(driver)
    driver.app_driver.wait(lambda: told(driver.window).startswith("≈"))
    whole = effective(driver.window).text()
    driver.app_driver.controller.motion.set_speed_percent(10)
    driver.app_driver.step()
    driver.app_driver.wait(lambda: " · at 10 % ≈ " in effective(driver.window).text())
    full, slowed = effective(driver.window).text().split(" · ")
    assert full == whole
    assert seconds(slowed.removeprefix("at 10 % ")) > 1.5 * seconds(whole)
    driver.window._run_bar.check()
    checked, estimated = effective(driver.window).text().split(" · ")
    assert seconds(checked) == pytest.approx(seconds(full), abs=0.2)
    assert not checked.startswith("≈")
    assert estimated == slowed, "a check counts no slower speed"
