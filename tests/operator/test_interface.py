"""What the operator sees of the local interface, and what a client gets by his presses."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui import app, cli
from armui.control.operating_state import StopState
from armui.interface.interface import Interface
from armui.interface.lease import GRANT_WITHIN_S, SILENT_S
from armui.protocol.codes import MoveMode
from armui.start import StartOptions
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.actions.operator_view import set_operator_view
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.interface.client_question import ClientQuestion, ConsentDialog, GrantDialog
from armui.ui.interface.interface_dialog import InterfaceDialog
from armui.ui.interface.lease_bar import LeaseBar
from armui.ui.watch.bus.bus_page import BusPage
from tests.interface.conftest import RawClient, until_settled
from tests.operator.test_operator_view import item

NOTHING = "There is nothing to do here right now."
TO = (0.0, 20.0, -30.0, 0.0, 10.0, 0.0)


class Desk:
    """The program with its interface on, and what the operator does there."""

    def __init__(self, driver):
        self.driver = driver
        driver.ready()
        driver.store.change(interface=True)
        self.interface = driver.program.interface
        until_settled(self.interface)
        self.clients = []

    def client(self, name="my script"):
        self.clients.append(RawClient(self.driver, self.interface.view.path, name))
        return self.clients[-1]

    def asked(self, client, purpose="to sort bottles", moves=True, percent=50):
        asked = client.begin(
            "lease.request", purpose=purpose, moves=moves, max_speed_percent=percent
        )
        client.wait(lambda: self.interface.view.asked is not None)
        return asked

    def leased(self, client, **more):
        asked = self.asked(client, **more)
        self.hold(GrantDialog)
        client.lease = client.answer(asked)["result"]["lease"]

    def hold(self, kind, share=1.0):
        self.driver.hold_button(self.driver.dialog(kind).action_button, share)

    def refuse(self, kind):
        self.driver.click(self.driver.dialog(kind).cancel_button)

    @property
    def open(self):
        shown = QApplication.topLevelWidgets()
        return [each for each in shown if isinstance(each, ClientQuestion) and each.isVisible()]

    @property
    def bar(self):
        return self.driver.find("lease_bar")

    def close(self):
        for each in self.clients:
            each.close()


@pytest.fixture
def desk(app_driver):
    desk = Desk(app_driver)
    yield desk
    desk.close()


@pytest.fixture
def client(desk):
    return desk.client()


def why(answer):
    return answer["error"]["data"]["reason"]


def text_of(dialog):
    return "\n".join((dialog.windowTitle(), dialog.text()))


# Being asked for the arm --------------------------------------------------------------------------


def test_the_question_says_who_asks_and_what_for(desk, client):
    desk.asked(client)
    dialog = desk.driver.dialog(GrantDialog)
    said = text_of(dialog)
    process = desk.interface.view.clients[0].process
    assert "“my script” asks for the arm" in said
    assert "to sort bottles" in said
    assert f"process {process}" in said
    assert desk.interface.view.clients[0].program in said
    assert "moves the arm by itself" in said
    assert dialog.findChild(type(dialog._seconds), "client_seconds_left").text().startswith("Ref")


def test_a_held_press_grants_at_the_operators_speed(desk, client):
    desk.driver.controller.motion.set_speed_percent(30)
    asked = desk.asked(client, percent=60)
    dialog = desk.driver.dialog(GrantDialog)
    assert dialog.limit.value() == 30
    assert (dialog.limit.minimum(), dialog.limit.maximum()) == (1, 60)
    dialog.limit.setValue(20)
    desk.hold(GrantDialog)
    assert client.answer(asked)["result"]["max_speed_percent"] == 20
    assert not desk.open


def test_a_short_press_grants_nothing(desk, client):
    desk.asked(client)
    desk.hold(GrantDialog, 0.9)
    dialog = desk.driver.dialog(GrantDialog)
    desk.driver.click(dialog.action_button)
    QTest.keyClick(dialog, Qt.Key.Key_Space)  # upon Refuse, where the keyboard is
    assert desk.interface.view.lease is None


def test_enter_and_escape_refuse(desk, client):
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Escape):
        asked = desk.asked(client)
        QTest.keyClick(desk.driver.dialog(GrantDialog), key)
        assert why(client.answer(asked)) == "lease_declined"


def test_refuse_refuses(desk, client):
    asked = desk.asked(client)
    desk.refuse(GrantDialog)
    assert why(client.answer(asked)) == "lease_declined"
    assert not desk.open
    assert desk.interface.view.lease is None


def test_unanswered_it_closes_by_itself_and_says_the_seconds_left(desk, client):
    asked = desk.asked(client)
    desk.driver.run(GRANT_WITHIN_S - 10)
    dialog = desk.driver.dialog(GrantDialog)
    dialog._show_time_left()
    assert dialog._seconds.text() == "Refused by itself in 10 s."
    desk.driver.run(10.2)
    assert why(client.answer(asked)) == "lease_not_granted"
    assert not desk.open
    assert "asked_otherwise" not in desk.driver.codes()


def test_a_client_that_goes_takes_its_question_along(desk, client):
    desk.asked(client)
    client.close()
    desk.driver.wait(lambda: not desk.open)


def test_for_this_connection_it_asks_once(desk, client):
    desk.asked(client)
    desk.driver.dialog(GrantDialog).lasting.click()
    desk.hold(GrantDialog)
    client.wait(lambda: desk.interface.view.lease is not None)
    client.ask("lease.release", lease=desk.interface.view.lease.number)
    client.ask("lease.request", purpose="more", moves=True, max_speed_percent=20)
    assert desk.interface.view.lease is not None
    assert not desk.open


def test_what_moves_nothing_is_granted_once_and_without_a_speed(desk, client):
    desk.asked(client, moves=False)
    dialog = desk.driver.dialog(GrantDialog)
    assert "moves nothing" in dialog.text()
    assert not dialog.lasting.isVisible()
    assert not dialog.limit.isVisible()


@pytest.mark.styled
@pytest.mark.parametrize("size", [(1280, 800), (1440, 900)])
def test_a_foreign_text_makes_no_question_wider_than_its_room(desk, size):
    desk.driver.window.resize(*size)
    client = desk.client("N" * 80)
    desk.asked(client, purpose="W" * 200)
    dialog = desk.driver.dialog(GrantDialog)
    room = desk.driver.window.room_for_questions()
    assert dialog.geometry().right() <= room.right() + 16
    stop = desk.driver.find("stop_button")
    place = stop.rect().translated(stop.mapToGlobal(stop.rect().topLeft()))
    assert not dialog.geometry().intersects(place)


def test_it_comes_without_taking_the_keyboard(desk, client):
    desk.asked(client)
    dialog = desk.driver.dialog(GrantDialog)
    assert dialog.testAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
    assert not dialog.isModal()


# The bar ------------------------------------------------------------------------------------------


def test_the_bar_says_who_does_what_since_when(desk, client):
    assert desk.bar.isVisible()
    assert desk.bar.text == "Local interface: my script connected, without the arm"
    desk.leased(client)
    assert "“my script (" in desk.bar.text
    assert "does nothing now" in desk.bar.text
    assert "at most 30 %" in desk.bar.text
    number = client.begin("motion.send", lease=client.lease, angles_deg=TO)
    client.wait(lambda: desk.interface.view.doing == "motion.send")
    client.answer(number)
    assert "Move the joints to angles" in desk.bar.text
    client.ask("stream.target", lease=client.lease, joints_deg=(0.0,) * 6)
    client.wait(lambda: "streams targets" in desk.bar.text)
    for _ in range(int(2 / 0.5)):
        desk.driver.run(0.5)
        client.ask("ping")
    desk.bar._show_text()
    seconds = desk.bar.text.split(" · ")[1].removesuffix(" s")
    assert int(seconds) >= 2


def test_take_back_ends_and_halts(desk, client):
    desk.leased(client)
    client.ask("motion.send", lease=client.lease, angles_deg=TO)
    client.wait(lambda: desk.driver.controller.operating_state.moving)
    desk.driver.click("interface_take_back")
    assert desk.interface.view.lease is None
    desk.driver.run_until(lambda: not desk.driver.controller.operating_state.moving, 3.0)
    measured = desk.driver.controller.state.angles_deg()
    assert max(abs(a - b) for a, b in zip(measured, TO, strict=True)) > 3
    assert not desk.driver.find("interface_take_back").isVisible()
    assert why(client.answer(client.begin("motion.home", lease=client.lease))) == "lease_not_held"


def test_after_take_back_what_was_granted_for_the_connection_is_asked_anew(desk, client):
    desk.asked(client)
    desk.driver.dialog(GrantDialog).lasting.click()
    desk.hold(GrantDialog)
    client.wait(lambda: desk.interface.view.lease is not None)
    desk.driver.click("interface_take_back")
    desk.asked(client)
    assert desk.open


def test_a_jog_of_the_operators_ends_the_lease(desk, client):
    client.ask("events.subscribe")
    desk.leased(client)
    desk.driver.press(desk.driver.find("jog_plus_1"))
    desk.driver.run(0.3)
    assert desk.interface.view.lease is None
    assert "without the arm" in desk.bar.text
    client.wait(lambda: client.told("lease"))
    assert client.told("lease")[-1]["reason"]["reason"] == "lease_operator_moved"


def test_the_emergency_stop_ends_it_and_the_question(desk, client):
    desk.leased(client)
    desk.driver.click("stop_button")
    assert desk.interface.view.lease is None
    desk.driver.run(0.5)
    assert desk.driver.controller.operating_state.stop is not StopState.RUNNING
    assert not desk.open


def test_silence_ends_it_and_the_bar_says_so(desk, client):
    desk.leased(client)
    desk.driver.run(SILENT_S + 0.2)
    assert desk.interface.view.lease is None
    assert "without the arm" in desk.bar.text


@pytest.mark.styled
def test_no_lease_shifts_a_button(desk, client):
    names = ("jog_plus_1", "send_button", "stop_button", "halt_button", "enable_button")

    def places():
        desk.driver.window.layout().activate()
        desk.driver.run(0.1)
        found = [desk.driver.find(name) for name in names]
        return [each.mapTo(desk.driver.window, each.rect().topLeft()) for each in found]

    before = places()
    desk.leased(client)
    assert desk.driver.find("interface_take_back").isVisible()
    assert places() == before
    desk.driver.click("interface_take_back")
    assert places() == before


def test_taking_back_is_a_command_and_stays_in_the_operators_view(desk, client):
    assert item(desk.driver, "interface.take_back").reason == NOTHING
    desk.leased(client)
    item(desk.driver, "window.operator_view").target.trigger()
    try:
        assert desk.driver.find("interface_take_back").isEnabled()
        assert not item(desk.driver, "interface.take_back").reason
    finally:
        set_operator_view(wanted=False)


# Consent ------------------------------------------------------------------------------------------


def test_a_consent_is_held_each_time(desk, client):
    desk.leased(client)
    asked = client.begin("motors.disable", lease=client.lease)
    client.wait(lambda: desk.open)
    said = text_of(desk.driver.dialog(ConsentDialog))
    assert "“my script” wants: Disable motors" in said
    assert "The arm will drop" in said
    assert "1–6" in said
    desk.hold(ConsentDialog, 0.9)
    desk.driver.run(0.1)
    assert None not in desk.driver.controller.operating_state.enabled
    assert all(desk.driver.controller.operating_state.enabled)
    client.ask("ping")
    desk.hold(ConsentDialog)
    assert "number" in client.answer(asked)["result"]
    assert not desk.open
    desk.driver.run_until(lambda: not any(desk.driver.controller.operating_state.enabled))


@pytest.mark.parametrize("accepts", [True, False])
def test_what_the_check_of_a_run_warns_of_is_accepted_by_a_held_press(desk, client, accepts):
    Library(desk.driver.library_folder).save(
        Trajectory("far", points=(Waypoint(MoveMode.MOVE_J, (60.0, *TO[1:])),))
    )
    desk.leased(client)
    asked = client.begin("trajectory.run", lease=client.lease, name="far")
    client.wait(lambda: desk.open)
    said = text_of(desk.driver.dialog(ConsentDialog))
    assert "“my script” wants: Run a trajectory" in said
    assert "Name: far" in said
    assert "Row 1: The first point is far from where the arm is: joint 1 turns 60" in said
    if accepts:
        desk.hold(ConsentDialog)
        assert "number" in client.answer(asked)["result"]
        assert desk.bar.isVisible()
    else:
        desk.refuse(ConsentDialog)
        assert why(client.answer(asked)) == "lease_declined"
    assert desk.driver.controller.player.running is accepts


def test_a_consent_refused_does_nothing(desk, client):
    desk.leased(client)
    asked = client.begin("joints.set_zero", lease=client.lease, joint=3)
    client.wait(lambda: desk.open)
    said = desk.driver.dialog(ConsentDialog).text()
    assert "Joint number: 3" in said
    assert "The limits move with the zero" in said
    desk.refuse(ConsentDialog)
    assert why(client.answer(asked)) == "lease_declined"


def test_releasing_the_stop_is_never_a_clients_alone(desk, client):
    """The lease ends by the stop; release is the operator's own held press."""
    desk.leased(client)
    desk.driver.click("stop_button")
    error = client.refused("motors.resume", lease=client.lease)
    assert error["data"]["reason"] == "lease_not_held"


def test_a_question_about_a_zero_is_withdrawn_when_the_arm_moves(desk, client):
    desk.leased(client)
    asked = client.begin("joints.set_zero", lease=client.lease)
    client.wait(lambda: desk.open)
    client.begin("motion.send", lease=client.lease, angles_deg=TO)
    client.wait(lambda: asked in client.answers)
    assert why(client.answers[asked]) == "lease_declined"
    assert not desk.open


@pytest.mark.parametrize("joint", [99, -1, 7])
def test_no_figure_of_a_client_breaks_its_question(desk, client, joint):
    desk.leased(client)
    client.begin("joints.set_zero", lease=client.lease, joint=joint)
    client.wait(lambda: desk.open)
    desk.driver.run(0.1)
    assert desk.open


def test_a_page_in_its_own_window_says_who_has_the_arm_and_takes_it_back(desk, client):
    driver = desk.driver
    driver.click("bus_button")
    page = driver.taken_out(BusPage)
    (bar,) = page.window().findChildren(LeaseBar)
    assert not bar.take_back.isVisible()
    desk.leased(client)
    assert "has the arm" in bar.text
    driver.click(bar.take_back)
    assert desk.interface.view.lease is None


# The settings -------------------------------------------------------------------------------------


def test_the_setting_opens_and_closes_the_socket(app_driver):
    app_driver.ready()
    path = app_driver.program.interface._path
    mark, bar = app_driver.find("interface_mark"), app_driver.find("lease_bar")
    assert not path.exists()
    assert not mark.isVisible()
    assert not bar.isVisible()
    app_driver.click("settings_button")
    app_driver.click(app_driver.dialog(SettingsDialog).interface_button)
    dialog = app_driver.dialog(InterfaceDialog)
    app_driver.click(dialog.box)
    assert app_driver.store.settings.interface
    until_settled(app_driver.program.interface)
    assert path.exists()
    assert mark.isVisible()
    assert isinstance(bar, LeaseBar)
    assert bar.isVisible()
    assert dialog.path.text() == str(path)
    app_driver.click(dialog.copy_path)
    assert QGuiApplication.clipboard().text() == str(path)
    app_driver.click(dialog.box)
    assert not path.exists()
    assert not mark.isVisible()
    assert not bar.isVisible()


def test_the_mark_counts_and_leads_to_the_window(desk, client):
    mark = desk.driver.find("interface_mark")
    assert mark.text() == "Interface: 1"
    desk.client("another")
    assert mark.text() == "Interface: 2"
    desk.driver.click(mark)
    dialog = desk.driver.dialog(InterfaceDialog)
    assert [dialog.clients.item(row).text().split(" (")[0] for row in range(2)] == [
        "my script",
        "another",
    ]


def test_the_window_says_what_was_granted(desk, client):
    desk.driver.window.pages.show("interface")
    dialog = desk.driver.dialog(InterfaceDialog)
    assert dialog.grants.count() == 0
    desk.leased(client)
    assert dialog.grants.count() == 1
    assert "my script" in dialog.grants.item(0).text()
    assert "30 %" in dialog.grants.item(0).text()
    desk.interface.take_back()
    assert "taken the arm back" in dialog.grants.item(0).text()


def test_a_socket_that_another_program_serves_is_said(app_driver):
    first = app_driver.program.interface
    app_driver.store.change(interface=True)
    until_settled(first)
    second = Interface(app_driver.controller, first._path, lambda: app_driver.time_s)
    second.switch(on=True)
    until_settled(second)
    assert second.view.problem.code == "interface_taken"
    second.switch(on=False)
    assert second.view.problem is None
    second.end()


def test_every_text_follows_the_language(desk, client):
    desk.asked(client)
    desk.driver.window.pages.show("interface")
    desk.driver.store.change(language="zh")
    desk.driver.run(0.1)
    dialog = desk.driver.dialog(GrantDialog)
    assert dialog.windowTitle() == "“my script”申请操作机械臂"
    assert dialog.action_button.text() == "授予"
    assert dialog.cancel_button.text() == "拒绝"
    assert desk.driver.dialog(InterfaceDialog).windowTitle() == "本地接口"
    desk.hold(GrantDialog)
    client.wait(lambda: desk.interface.view.lease is not None)
    assert desk.driver.find("interface_take_back").text() == "收回"
    assert "“my script (" in desk.bar.text
    number = desk.interface.view.lease.number
    client.begin("motors.disable", lease=number)
    client.wait(lambda: desk.open)
    assert "下落" in desk.driver.dialog(ConsentDialog).text()
    assert "失能电机" in desk.driver.read("notice_label")
    desk.refuse(ConsentDialog)
    desk.driver.press(desk.driver.find("jog_plus_1"))
    desk.driver.run(0.2)
    desk.driver.window.pages.show("interface")
    told = desk.driver.dialog(InterfaceDialog).grants
    assert "关节步进" in told.item(0).text()


@pytest.mark.parametrize("words", [[], ["--api-on"]])
def test_the_command_line_switches_it_on_for_one_run(words, monkeypatch):
    begun: list[StartOptions] = []
    monkeypatch.setattr(app, "run", begun.append)
    monkeypatch.setattr(cli, "has_display", lambda: True)
    cli.main(words)
    assert [each.api_on for each in begun] == [bool(words)]
