"""The window «Report a problem»: seen before it is saved, and never in the way of the window."""

import zipfile

import pytest

from armui.arm.device import Device
from armui.control.sessions.progress import RingContent
from armui.doctor.judge import PACKAGES
from armui.doctor.problem_report import BUS_FILE
from armui.ui.background import Background
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.problem_report import ProblemReportDialog
from tests.app_driver import AtOnce, Slow
from tests.ui.arm_states import operating_state
from tests.ui.dialog_reading import message
from tests.ui.fake_controller import FakeController
from tests.ui.test_doctor_dialog import Examinations

FINE = PACKAGES(count="12")


@pytest.fixture
def controller(qapp):
    return FakeController()


@pytest.fixture
def examinations():
    return Examinations()


@pytest.fixture
def make(qtbot, controller, examinations, tmp_path):
    def made(files):
        dialog = ProblemReportDialog(
            controller.as_real, Background(files), tmp_path / "settings.json", None, examinations
        )
        qtbot.addWidget(dialog)
        dialog.open()
        examinations.on_answer([FINE])
        return dialog

    return made


def names(dialog):
    return [dialog.list.item(row).text().split("  (")[0] for row in range(dialog.list.count())]


def save(dialog, path):
    dialog.save_button.click()
    (chooser,) = dialog.findChildren(FileDialog)
    assert chooser.testOption(FileDialog.Option.DontConfirmOverwrite)
    chooser.fileSelected.emit(str(path))
    chooser.close()
    chooser.setParent(None)


def test_each_file_is_seen_before_any_is_written(qtbot, make, tmp_path):
    dialog = make(AtOnce())
    assert not dialog.save_button.isEnabled()
    qtbot.waitUntil(dialog.save_button.isEnabled)
    assert {"doctor.txt", "doctor.json", "versions.txt", "settings.json"} <= set(names(dialog))
    dialog.list.setCurrentRow(names(dialog).index("doctor.txt"))
    assert "All 12 packages" in dialog.text.toPlainText()
    assert list(tmp_path.iterdir()) == []
    save(dialog, tmp_path / "r.zip")
    assert message(dialog) == f"Saved: {tmp_path / 'r.zip'}"
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        assert archive.namelist() == names(dialog)
    before = (tmp_path / "r.zip").read_bytes()
    save(dialog, tmp_path / "r.zip")
    assert "exists already" in message(dialog)
    assert (tmp_path / "r.zip").read_bytes() == before


def test_the_bus_is_in_it_only_where_it_is_ticked(qtbot, make, controller):
    dialog = make(AtOnce())
    qtbot.waitUntil(dialog.save_button.isEnabled)
    assert not dialog.bus_box.isEnabled()
    dialog.close()
    controller.sessions.content = RingContent(frames=3, span_s=1.0)
    controller.sessions.text = b"(1.0) can0 2A1#00\n" * 20_000
    dialog = make(AtOnce())
    qtbot.waitUntil(dialog.save_button.isEnabled)
    assert BUS_FILE not in names(dialog)
    dialog.bus_box.click()
    assert names(dialog)[-1] == BUS_FILE
    dialog.list.setCurrentRow(len(names(dialog)) - 1)
    shown = dialog.text.toPlainText()
    assert "160 kB are not shown here" in shown
    assert len(shown) < 210_000
    dialog.bus_box.click()
    assert BUS_FILE not in names(dialog)


def test_an_open_device_is_left_alone(make, controller, examinations):
    make(AtOnce()).close()
    controller.be(operating_state(device=Device("socketcan", "can0", None)))
    make(AtOnce())
    assert examinations.arguments == [[], ["--no-listen"]]


def test_a_share_that_hangs_is_told_and_another_place_can_be_chosen(qtbot, make, tmp_path):
    files = Slow()
    dialog = make(files)
    qtbot.waitUntil(lambda: bool(files.waiting))
    files.work()
    qtbot.waitUntil(dialog.save_button.isEnabled)
    save(dialog, tmp_path / "share.zip")
    assert not dialog.save_button.isEnabled()
    hung, files.waiting = files.waiting, []
    dialog._late.timeout.emit()  # ten seconds later
    assert "does not answer" in message(dialog)
    save(dialog, tmp_path / "here.zip")
    files.work()
    assert message(dialog) == f"Saved: {tmp_path / 'here.zip'}"
    # the share is back: what is said now is of the other file
    files.waiting = hung
    files.work()
    assert message(dialog) == f"Saved: {tmp_path / 'here.zip'}"


def test_a_doctor_that_fails_is_part_of_the_report(qtbot, controller, tmp_path, examinations):
    dialog = ProblemReportDialog(
        controller.as_real, Background(AtOnce()), tmp_path / "s.json", None, examinations
    )
    qtbot.addWidget(dialog)
    dialog.open()
    examinations.on_answer("no answer within 180 s")
    qtbot.waitUntil(dialog.save_button.isEnabled)
    dialog.list.setCurrentRow(names(dialog).index("doctor.txt"))
    assert dialog.text.toPlainText() == "no answer within 180 s\n"


def test_a_closed_window_waits_for_nobody(qtbot, make, examinations):
    dialog = make(Slow())
    dialog.close()
    assert examinations.ended == 1
