"""Leaving, closing and disconnecting with changes that are not saved."""

from armui.control.situation import LinkState
from armui.ui.dialogs.confirm import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from tests.operator_settings.panels import note, questions, sent, settled


def test_leaving_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    end.click("menu_motion")
    question = end.dialog(ConfirmDialog)
    assert "has not been saved" in question.text()
    assert end.find("max_linear_speed_m_s").isVisible()
    assert end.find("menu_end_limits").isChecked()
    question.reject()
    assert end.read("max_linear_speed_m_s") == "0.500"
    end.click("menu_motion")
    end.confirm()
    assert end.find("send_button").isVisible()
    assert end.find("menu_motion").isChecked()
    end.click("menu_end_limits")
    settled(end)
    assert end.read("max_linear_speed_m_s") == "1.000"
    assert sent(end)[0].arbitration_id == 0x477


def test_leaving_without_changes_does_not_ask(end):
    end.click("end_limits_edit_button")
    end.click("menu_motion")
    assert questions() == []
    assert end.find("send_button").isVisible()


def test_closing_the_window_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    assert not end.window.close()
    assert end.window.isVisible()
    end.confirm()
    assert not end.window.isVisible()


def test_disconnecting_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    end.click("communication_button")
    dialog = end.dialog(ConnectDialog)
    end.click(dialog.disconnect_button)
    end.dialog(ConfirmDialog).reject()
    assert end.controller.situation.link is LinkState.ONLINE
    end.click(dialog.disconnect_button)
    end.confirm()
    assert end.controller.situation.link is LinkState.NO_DEVICE
    assert end.read("max_linear_speed_m_s") == ""
    assert note(end, "max_linear_speed_m_s") == "not read"
