"""The operator chooses the model when connecting; what the arm tells confirms it, or warns."""

import json
from dataclasses import replace

import pytest

from armui.arm.device import Device
from armui.arm.models import model_data, robot_description
from armui.control.link.link_state import LinkState
from armui.protocol.generation import PiperModel
from armui.setting_checks import MOST_KEPT
from armui.settings import SettingsStore
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.kept_models import KeptModels, last_model
from tests.accepted import accepted
from tests.family import MODELS
from tests.moments import now

LEANING_DEG = (10.0, 60.0, -60.0, 5.0, 30.0, 0.0)
CANDLE = Device("gs_usb", "0", 1_000_000, serial="0031002F")
OTHER = Device("gs_usb", "1", 1_000_000, serial="0042")
PLACE = Device("socketcan", "can0", None)


def dialog_of(app_driver) -> ConnectDialog:
    app_driver.window.pages.show("connect")
    (dialog,) = app_driver.window.findChildren(ConnectDialog)
    app_driver.controller.devices_found.emit([app_driver.device])
    return dialog


def choose(dialog, model):
    dialog.model_choice.box.setCurrentIndex(dialog.model_choice.box.findData(model))


@pytest.mark.parametrize("model", MODELS)
def test_what_is_chosen_is_shown_and_computed_with(app_driver, model):
    app_driver.lie(LEANING_DEG, model)
    dialog = dialog_of(app_driver)
    assert dialog.model_choice.model is PiperModel.PIPER
    choose(dialog, model)
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: "limits_read" in app_driver.codes())
    app_driver.run(2.0)

    assert now(app_driver.controller.operating_state.model_fit).confirmed
    assert app_driver.window._robot.path == robot_description(model)
    mark = app_driver.find("model_mark")
    assert (
        mark.text()
        == {
            PiperModel.PIPER: "PiPER",
            PiperModel.PIPER_H: "PiPER H",
            PiperModel.PIPER_L: "PiPER L",
            PiperModel.PIPER_X: "PiPER X",
        }[model]
    )
    assert dialog.model_choice.hint.text() == "Confirmed by the pose the arm reports."
    assert not dialog.connect_button.isEnabled()


def test_a_wrong_choice_is_said_where_the_operator_looks_and_mended_by_connecting(app_driver):
    app_driver.lie(LEANING_DEG, PiperModel.PIPER_L)
    app_driver.connect()
    app_driver.run(3.0)
    mark = app_driver.find("model_mark")
    assert mark.text() == "PiPER? The pose is that of a PiPER L"
    app_driver.click(mark)
    (dialog,) = app_driver.window.findChildren(ConnectDialog)
    app_driver.controller.devices_found.emit([app_driver.device])
    assert "that of a PiPER L: choose it and press Connect" in dialog.model_choice.hint.text()
    assert dialog.model_choice.model is PiperModel.PIPER  # nothing is changed by itself
    assert not dialog.connect_button.isEnabled()

    choose(dialog, PiperModel.PIPER_L)
    assert dialog.connect_button.isEnabled()
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: app_driver.controller.operating_state.link is LinkState.ONLINE)
    app_driver.run(3.0)

    assert now(app_driver.controller.operating_state.model_fit).confirmed
    assert mark.text() == "PiPER L"
    assert app_driver.window._robot.path == robot_description(PiperModel.PIPER_L)


def test_the_choice_is_kept_for_the_adapter_and_offered_the_next_time(app_driver, tmp_path):
    app_driver.lie(LEANING_DEG, PiperModel.PIPER_X)
    dialog = dialog_of(app_driver)
    choose(dialog, PiperModel.PIPER_X)
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: "limits_read" in app_driver.codes())
    app_driver.controller.disconnect_device()

    kept = json.loads((tmp_path / "settings.json").read_text("utf-8"))["models"]
    assert set(kept.values()) == {"piper_x"}
    choose(dialog, PiperModel.PIPER)
    dialog._table.clearSelection()
    app_driver.controller.devices_found.emit([app_driver.device])
    assert dialog.model_choice.model is PiperModel.PIPER_X
    # and plans go on being made for it while nothing is connected
    assert now(app_driver.controller.operating_state.model) is PiperModel.PIPER_X


def test_models_are_kept_by_serial_number_and_node(tmp_path):
    store = SettingsStore(tmp_path / "settings.json")
    kept = KeptModels(store)
    assert kept.of(CANDLE) is None

    kept.keep(replace(CANDLE, model=PiperModel.PIPER_H), "15")
    kept.keep(replace(OTHER, model=PiperModel.PIPER_L))
    kept.keep(replace(CANDLE, model=PiperModel.PIPER_X), "16")

    again = KeptModels(SettingsStore(tmp_path / "settings.json"))
    assert again.of(CANDLE, "15") is PiperModel.PIPER_H
    assert again.of(CANDLE, "16") is PiperModel.PIPER_X
    assert again.of(CANDLE) is PiperModel.PIPER_X  # the last one
    assert again.of(replace(CANDLE, channel="7")) is PiperModel.PIPER_X  # wherever it is plugged in
    assert again.of(OTHER) is PiperModel.PIPER_L
    assert again.of(PLACE) is None
    assert last_model(store.settings.models) is PiperModel.PIPER_X
    assert last_model({}) is PiperModel.PIPER


def test_only_so_many_are_remembered(tmp_path):
    store = SettingsStore(tmp_path / "settings.json")
    many = {f"adapter {number}": "piper_h" for number in range(MOST_KEPT)}
    assert store.change(models=many) is None

    KeptModels(store).keep(replace(OTHER, model=PiperModel.PIPER_L))

    assert len(store.settings.models) == MOST_KEPT
    assert "adapter 0" not in store.settings.models
    assert KeptModels(store).of(OTHER) is PiperModel.PIPER_L


@pytest.mark.parametrize("bad", [5, ["piper"], {"a": "nero"}, {"a": 3}, {"a": None}])
def test_models_in_a_file_that_cannot_be_are_left_out(tmp_path, bad):
    path = tmp_path / "settings.json"
    path.write_text(json.dumps({"models": bad}))
    store = SettingsStore(path)
    assert store.settings.models == {}
    assert [each.params["field"] for each in store.problems] == ["models"]


def test_the_operator_s_own_description_goes_before_the_model_s(app_driver, tmp_path):
    own = str(tmp_path / "own.urdf")
    app_driver.store.change(urdf_path=own)
    app_driver.lie(LEANING_DEG, PiperModel.PIPER_H)
    app_driver.connect(PiperModel.PIPER_H)
    assert str(app_driver.window._robot.path) == own
    app_driver.store.change(urdf_path=None)
    assert app_driver.window._robot.path == robot_description(PiperModel.PIPER_H)


def test_what_the_arm_has_confirmed_is_kept_by_its_node_number_when_it_is_left(
    app_driver, tmp_path
):
    path = tmp_path / "settings.json"
    app_driver.lie(LEANING_DEG, PiperModel.PIPER_H)
    dialog = dialog_of(app_driver)
    choose(dialog, PiperModel.PIPER_H)
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: app_driver.controller.state.identity is not None)
    node = app_driver.controller.state.identity.node_number
    app_driver.run_until(lambda: now(app_driver.controller.operating_state.model_fit).confirmed)
    app_driver.run(0.1)
    assert len(json.loads(path.read_text("utf-8"))["models"]) == 1

    app_driver.controller.disconnect_device()

    kept = json.loads(path.read_text("utf-8"))["models"]
    name = f"{app_driver.device.interface} {app_driver.device.channel}"
    assert node
    assert kept == {name: "piper_h", f"{name} / {node}": "piper_h"}


def test_a_wrong_choice_is_not_kept_by_the_node_number(app_driver, tmp_path):
    app_driver.lie(LEANING_DEG, PiperModel.PIPER_L)
    dialog = dialog_of(app_driver)
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: app_driver.controller.state.identity is not None)
    app_driver.run(2.0)
    app_driver.controller.disconnect_device()

    kept = json.loads((tmp_path / "settings.json").read_text("utf-8"))["models"]
    assert [" / " in each for each in kept] == [False]


def connect_again(app_driver, model, *, by_hand=None):
    """The arm of another connection at the same adapter, a real one for all that is known."""
    app_driver.controller.disconnect_device()
    app_driver.lie(LEANING_DEG, model)
    app_driver.window.pages.show("connect")
    (dialog,) = app_driver.window.findChildren(ConnectDialog)
    device = replace(app_driver.device, simulated=False, serial="0031002F")
    app_driver.controller.devices_found.emit([device])
    dialog._table.selectRow(0)
    if by_hand is not None:
        choose(dialog, by_hand)
        dialog.model_choice.box.activated.emit(dialog.model_choice.box.currentIndex())
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: app_driver.controller.state.identity is not None)
    app_driver.run(0.1)


def keep(app_driver, **models):
    """What was chosen for the arms with these node numbers; for the adapter it was the last."""
    adapter = replace(CANDLE, serial="0031002F")
    kept = {adapter.arm_key(number.lstrip("_")): model for number, model in models.items()}
    app_driver.store.change(models={**kept, adapter.arm_key(): list(models.values())[-1]})


def node_of(app_driver):
    return app_driver.controller.state.identity.node_number


def test_what_was_kept_for_this_very_arm_is_taken_when_it_names_itself(app_driver):
    keep(app_driver, _15="piper_l", _16="piper_x")
    connect_again(app_driver, PiperModel.PIPER_L)
    assert node_of(app_driver) == "15"

    operating = app_driver.controller.operating_state
    assert operating.model is PiperModel.PIPER_L  # not the X of the adapter's last connection
    assert "model_recalled" in app_driver.codes()
    assert app_driver.window._robot.path == robot_description(PiperModel.PIPER_L)
    geometry = app_driver.controller.cartesian.kinematics().geometry
    assert geometry == model_data(PiperModel.PIPER_L).geometry
    app_driver.run(2.0)
    assert now(app_driver.controller.operating_state.model_fit).confirmed
    app_driver.controller.disconnect_device()
    assert app_driver.store.settings.models["0031002F / 15"] == "piper_l"


def test_what_the_operator_has_chosen_this_time_stays_and_is_asked_about(app_driver):
    keep(app_driver, _15="piper_l")
    connect_again(app_driver, PiperModel.PIPER_L, by_hand=PiperModel.PIPER_H)

    assert app_driver.controller.operating_state.model is PiperModel.PIPER_H
    assert "model_recalled" not in app_driver.codes()
    assert "model_was_other" in app_driver.codes()
    assert app_driver.find("model_mark").text() == "PiPER H? It was a PiPER L"
    app_driver.run(2.0)
    assert now(app_driver.controller.operating_state.model_fit).other is PiperModel.PIPER_L


def test_nothing_is_taken_or_said_where_it_was_the_same_or_never_seen(app_driver):
    keep(app_driver, _15="piper_l")
    connect_again(app_driver, PiperModel.PIPER_L)
    keep(app_driver, _16="piper_h")
    connect_again(app_driver, PiperModel.PIPER_H)
    assert not {"model_recalled", "model_was_other"} & set(app_driver.codes())
    assert app_driver.controller.operating_state.model is PiperModel.PIPER_H


def test_a_model_is_not_changed_under_an_arm_that_moves(app_driver):
    keep(app_driver, _16="piper_x")
    connect_again(app_driver, PiperModel.PIPER_L)
    controller = app_driver.controller
    accepted(controller.motors.enable())
    app_driver.run_until(lambda: controller.operating_state.cannot_move is None)
    accepted(controller.motion.jog(1, 20.0))
    app_driver.run(0.2)
    assert controller.operating_state.moving

    controller.model_watch.recall(PiperModel.PIPER_L, "15")

    assert now(controller.operating_state.model) is PiperModel.PIPER_X
    assert "model_was_other" in app_driver.codes()
