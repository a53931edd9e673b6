"""What leaves the window: files, the clipboard, and the layout for the next time."""

import csv
import xml.etree.ElementTree as ET
from datetime import datetime

import pytest
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QApplication

from armui.protocol.generation import Generation
from armui.settings import SettingsStore
from armui.system.atomic import UNFINISHED
from armui.ui.dialogs.files import FileDialog
from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.round_figures import ticks
from tests.app_driver import AppDriver
from tests.operator.plots.actions import Plots

pytestmark = pytest.mark.styled


def save(plots, kind, path):
    plots.window.bar.save.saves[kind].trigger()
    dialog = plots.driver.dialog(FileDialog)
    assert dialog.selectedFiles()[0].endswith(f".{kind}")
    dialog.close()
    plots.window.export.write(kind, path)
    plots.driver.wait(path.exists)
    QApplication.processEvents()


def test_values_as_csv(plots, tmp_path):
    plots.click("plot_pause")
    path = tmp_path / "values.csv"
    save(plots, "csv", path)
    assert path.name in plots.window.area.message.text()
    with path.open(encoding="utf-8-sig", newline="") as file:
        titles, *rows = list(csv.reader(file))
    assert titles[:4] == ["time", "t_s", "J1 angle [°]", "J1 angle, our command [°]"]
    assert len(titles) == 2 + 18
    times = [float(row[1]) for row in rows]
    assert times == sorted(times)
    assert times[0] >= -30.0
    assert times[-1] <= 0.0
    # the rig's time goes in steps of 20 ms: five seconds of them
    told = [(float(row[1]), float(row[2])) for row in rows if row[2]]
    assert len(told) >= 250
    assert told[0][1] == 0.0
    assert told[-1][1] == pytest.approx(20.0, abs=0.01)
    commanded = [(float(row[1]), row[3]) for row in rows if row[3]]
    assert commanded[0][0] == pytest.approx(-4.0, abs=0.1)
    assert commanded[0][1] == "20"
    stamps = [datetime.fromisoformat(row[0]) for row in rows]
    assert (stamps[-1] - stamps[0]).total_seconds() == pytest.approx(times[-1] - times[0])


def test_a_picture_as_png(plots, tmp_path):
    path = tmp_path / "plots.png"
    save(plots, "png", path)
    image = QImage(str(path))
    assert image.width() == 2400
    colors = {image.pixelColor(x, y).name() for x in range(300, 2300, 3) for y in range(200, 500)}
    assert set(plots.board.panes[0].curve_colors.values()) & colors


def test_a_picture_as_svg(plots, tmp_path):
    plots.click("plot_cursors")
    path = tmp_path / "plots.svg"
    save(plots, "svg", path)
    root = ET.parse(path).getroot()
    assert root.tag.endswith("svg")
    texts = {each.text for each in root.iter() if each.tag.endswith("text")}
    assert {"J1 angle", "measured", "our command", "A", "B"} <= texts
    assert len([each for each in root.iter() if each.tag.endswith("polyline")]) >= 12


def test_a_folder_that_is_not_there_is_told(plots, tmp_path):
    for kind in ("csv", "png", "svg"):
        plots.window.export.write(kind, tmp_path / "missing" / f"plots.{kind}")
        QApplication.processEvents()
        assert "Not saved" in plots.window.area.message.text()
        assert "missing" in plots.window.area.message.text()
        plots.window.area.message.show_message("")


def test_a_file_that_is_being_replaced_stays_whole(plots, tmp_path, monkeypatch):
    path = tmp_path / "values.csv"
    path.write_text("old")
    monkeypatch.setattr(
        "armui.ui.watch.value_table._chunk",
        lambda *_args: (_ for _ in ()).throw(OSError(28, "No space left on device")),
    )
    plots.window.export.write("csv", path)
    QApplication.processEvents()
    assert "No space left" in plots.window.area.message.text()
    assert path.read_text() == "old"
    assert list(tmp_path.glob(f"*{UNFINISHED}")) == []


def test_copies(plots):
    plots.window.bar.save.saves["copy_picture"].trigger()
    QApplication.processEvents()
    assert QGuiApplication.clipboard().image().width() == 2400
    plots.window.bar.save.saves["copy_values"].trigger()
    text = QGuiApplication.clipboard().text()
    assert plots.board.has_cursors
    assert "J1 angle\t" in text
    assert text.splitlines()[1].split("\t") == ["Quantity", "A", "B", "B − A"]


def test_the_layout_is_there_the_next_time(plots, qapp, request, tmp_path):
    plots.choose("plot_sets", "Temperatures and currents")
    plots.board.remove(0, "arm.motor_temperature.3")
    plots.choose("plot_span", "1 min")
    plots.wait_built()
    wanted = plots.keys()
    plots.window.close()  # what is not kept yet is kept now
    other = AppDriver(qapp, f"{request.node.nodeid} 2", tmp_path / "settings.json", Generation.TWO)
    try:
        again = Plots(other, None)
        assert again.keys() == wanted
        assert again.board.frame.shown.span_s == 60.0
        assert again.board.frame.live
        assert not again.board.frame.can_undo
    finally:
        other.close()


@pytest.mark.parametrize("text", ["", "[", '{"plots": [["nonsense"]], "span_s": 5}', "\0\0"])
def test_whatever_the_file_holds_the_window_opens(app_driver, tmp_path, text):
    (tmp_path / "plots.json").write_text(text)
    assert SettingsStore(tmp_path / "settings.json").path.parent == tmp_path
    plots = Plots(app_driver, None)
    assert plots.keys() == [list(plot) for plot in SETS["follow"]]


def test_round_figures():
    assert ticks(0.0, 10.0, 4) == [0.0, 5.0, 10.0]
    assert ticks(-0.3, 0.2, 4) == pytest.approx([-0.2, 0.0, 0.2])
    assert ticks(3.0, 3.0, 4) == []


def test_a_picture_has_every_plot_with_its_curves_and_units(plots):
    """What is scrolled out of sight is in it, and 0.005 A does not lie flat under 40°."""
    temperatures = ["arm.motor_temperature.1", "arm.joint_angle.1"]
    angles = [[f"arm.joint_angle.{joint}"] for joint in range(1, 7)]
    plots.board.show_plots([*angles, temperatures, *angles[:5]])
    plots.driver.wait(lambda: plots.board.built)
    plots.driver.run(1.0)
    shown = plots.window.export.figure().plots
    assert len(shown) == 13
    units = [each.unit for each in shown]
    assert units[:6] == ["°"] * 6
    assert units[8:] == ["°"] * 5
    assert set(units[6:8]) == {"°", "°C"}
    for plot in shown:
        low, high = plot.heights
        for lines in plot.lines:
            assert lines
            figures = [figure for _times, line in lines for figure in line.tolist()]
            assert low < min(figures) <= max(figures) < high
            assert (low, high) != (0.0, 1.0)
