"""What clients do with the operator's library: list, read, check, plan, and run (S29, S35)."""

import itertools

import numpy as np
import pytest

from armui.arm.refusal import Refusal
from armui.control.operations.started import Ending
from armui.control.run.player import NOT_PAUSED
from armui.control.run.progress import Run, RunPhase
from armui.control.safety import gate
from armui.interface import interface
from armui.interface.methods import MOST_POINTS
from armui.protocol.codes import MoveMode
from armui.trajectory.library.run_options import FIRST_RUN_PERCENT, RunOptions
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import COLUMN_COUNT, Recording
from tests.app_driver import Slow
from tests.interface.conftest import with_lease

NEAR, FAR = (10.0, 5.0, -5.0, 0.0, 0.0, 0.0), (60.0, 60.0, -60.0, 0.0, 0.0, 0.0)
BEYOND = (179.0, 5.0, -5.0, 0.0, 0.0, 0.0)


def joint(angles_deg, percent=100, dwell_s=0.0):
    return Waypoint(MoveMode.MOVE_J, angles_deg, speed_percent=percent, dwell_s=dwell_s)


def plain(angles_deg):
    return {"move": "MOVE J", "joints_deg": list(angles_deg)}


@pytest.fixture
def library(desk):
    """The operator's library, with a way that is fine, one with a warning, one with an error."""
    library = desk.shelf.library()
    library.save(Trajectory("fine", points=(joint(NEAR), joint((0.0,) * 6))))
    library.save(Trajectory("far", points=(joint(FAR), joint(NEAR))))
    library.save(Trajectory("beyond", points=(joint(NEAR), joint(BEYOND))))
    library.save(Trajectory("long", points=(joint(NEAR),) * (MOST_POINTS + 1)))
    for name in ("fine", "far"):
        library.note_run(name, RunOptions())
    return library


def run(client, name, **more):
    return client.begin("trajectory.run", lease=client.lease, name=name, **more)


def wait(client, condition):
    """Wait for something; the client says that it is there."""

    def seen():
        client.begin("ping")
        return condition()

    client.wait(seen)


def progress(desk):
    return desk.rig.controller.player.progress


def test_the_list_and_the_points(client, library):
    listed = {each["name"]: each for each in client.ask("trajectory.list")}
    assert listed.keys() == {"fine", "far", "beyond", "long"}
    assert (listed["fine"]["kind"], listed["fine"]["count"]) == ("points", 2)
    assert listed["fine"]["has_run"]
    assert not listed["beyond"]["has_run"]
    told = client.ask("trajectory.get", name="long", first_row=MOST_POINTS, rows=5)
    assert (told["count"], len(told["points"])) == (MOST_POINTS + 1, 2)
    assert told["points"][0] == {**plain(NEAR), "speed_percent": 100, "dwell_s": 0.0}
    assert client.ask("trajectory.get", name="fine", first_row=9)["points"] == []
    assert client.refused("trajectory.get", name="no")["data"]["reason"] == "file_gone"
    assert client.refused("trajectory.get", name="fine", rows=MOST_POINTS + 1)["code"] == -32602


def test_a_check_without_the_lease_says_what_the_operators_says(client, desk, library):
    told = client.ask("trajectory.check", name="beyond")
    assert (told["errors"], told["warnings"]) == (1, 0)
    (found,) = told["findings"]
    assert (found["id"], found["row"], found["severity"]) == ("target_beyond_limit", 2, "error")
    assert found["figures"]["joint"] == 1
    assert "beyond its limits" in found["text"]
    assert client.ask("trajectory.check", points=[plain(BEYOND)])["errors"] == 1
    plan = client.ask("trajectory.plan", points=[plain(NEAR), plain(FAR)])
    assert len(plan["expected_s"]) == 2
    assert plan["joints_deg"][-1] == pytest.approx(FAR, abs=0.01)
    assert plan["times_s"][-1] == pytest.approx(plan["length_s"], abs=0.01)
    assert len(plan["rows"]) == len(plan["times_s"]) == len(plan["joints_deg"])
    assert client.refused("trajectory.check", name="long")["data"]["figures"] == {
        "name": "long",
        "count": MOST_POINTS + 1,
        "maximum": MOST_POINTS,
    }
    wrong = client.refused("trajectory.check", points=[plain(NEAR), {"move": "MOVE X"}])
    assert wrong["code"] == -32602
    assert "row 2" in wrong["message"]
    assert client.refused("trajectory.check", points=[])["code"] == -32602
    for odd in ({"name": "fine", "points": [plain(NEAR)]}, {"points": [1]}):
        assert client.refused("trajectory.check", **odd)["code"] == -32602
    assert not desk.rig.controller.operating_state.moving


def test_checks_are_one_at_a_time_for_a_client(connect, desk, library):
    desk.shelf.works._workers = Slow()
    one, other = connect(), connect()
    first = one.begin("trajectory.check", name="fine")
    assert one.refused("trajectory.check", name="fine")["data"]["reason"] == "check_busy"
    second = other.begin("trajectory.check", name="fine")
    other.wait(lambda: len(desk.shelf.works._workers.waiting) == 3)  # one loads the modules
    desk.shelf.works._workers.work()
    assert one.answer(first)["result"]["errors"] == 0
    assert other.answer(second)["result"]["errors"] == 0


def test_a_run_by_name_to_its_end(leased, desk, library):
    begun = leased.answer(run(leased, "fine", cycles=2))["result"]
    leased.wait(lambda: desk.view.doing == "run.start")
    wait(leased, lambda: any(each["state"] == "done" for each in leased.told("operation")))
    assert {each["number"] for each in leased.told("operation")} == {begun["number"]}
    assert leased.told("operation")[-1]["result"]["id"] == "run_done"
    assert progress(desk).cycles == 2
    assert desk.rig.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)
    assert desk.view.lease is not None


def test_a_run_ends_the_stream_of_its_client_as_any_motion_does(leased, desk, library):
    for step in range(30):
        leased.ask("stream.target", lease=leased.lease, joints_deg=[0.2 * step, *NEAR[1:]])
    assert desk.rig.controller.jogging.streamed is not None
    assert "result" in leased.answer(run(leased, "fine"))
    wait(
        leased,
        lambda: any(
            each.get("result", {}).get("id") == "run_done" for each in leased.told("operation")
        ),
    )


def test_what_has_not_run_begins_slowly_and_is_noted(leased, desk, library):
    library.save(Trajectory("new", points=(joint(NEAR),)))
    assert "result" in leased.answer(run(leased, "new"))
    assert desk.rig.controller.motion.speed_percent == FIRST_RUN_PERCENT
    (entry,) = (each for each in Library(library.folder).entries() if each.name == "new")
    assert entry.ran_with == RunOptions()


def reason(client, number):
    return client.answer(number)["error"]["data"]["reason"]


def test_a_run_is_refused_with_the_operators_reasons(leased, desk, library):
    assert reason(leased, run(leased, "beyond")) == "findings_against"
    assert reason(leased, run(leased, "no")) == "file_gone"
    assert reason(leased, run(leased, "long")) == "check_too_long"
    assert reason(leased, run(leased, "fine", first_row=3)) == "run_no_such_row"
    desk.rig.controller.motors.disable()
    leased.wait(lambda: desk.view.lease is None)
    assert reason(leased, run(leased, "fine")) == "lease_not_held"
    assert progress(desk).phase is RunPhase.IDLE


@pytest.mark.parametrize("given", [True, False])
def test_a_warning_needs_the_operators_held_press(leased, desk, library, given):
    number = run(leased, "far")
    leased.wait(lambda: desk.view.consent is not None)
    consent = desk.view.consent
    assert (consent.operation, consent.arguments) == ("run.start", {"name": "far"})
    assert [each.code for each in consent.findings] == ["far_from_start"]
    desk.rig.run(0.5)
    assert not desk.rig.controller.player.running
    desk.consent(given=given)
    if given:
        assert "result" in leased.answer(number)
    else:
        assert reason(leased, number) == "lease_declined"
    assert desk.rig.controller.player.running is given
    assert desk.view.consent is None


def test_one_whose_arm_has_moved_meanwhile_is_refused(leased, desk, library):
    number = run(leased, "far")
    leased.wait(lambda: desk.view.consent is not None)
    leased.ask("motion.step", lease=leased.lease, joint=1, delta_deg=5)
    wait(leased, lambda: any(each["state"] == "done" for each in leased.told("operation")))
    desk.consent(given=True)
    assert reason(leased, number) == "moved_since_check"


def stops(desk):
    desk.rig.controller.emergency_stop()


def halts(desk):
    desk.rig.controller.halt_and_hold()


def moves(desk):
    desk.rig.controller.begin("gripper.move", 20.0, 1.0)


def takes_back(desk):
    desk.take_back()


@pytest.mark.parametrize(
    ("when", "act"),
    [
        *itertools.product(("checked", "asked"), (halts, moves, takes_back)),
        *itertools.product(("moving", "dwelling", "paused"), (stops, halts, takes_back)),
    ],
)
def test_the_end_of_the_lease_ends_the_run_wherever_it_is(leased, desk, library, act, when):
    library.save(Trajectory("dwells", points=(joint(NEAR, dwell_s=30.0), joint((0.0,) * 6))))
    library.note_run("dwells", RunOptions())
    works, name = desk.shelf.works, {"asked": "far", "dwelling": "dwells"}.get(when, "fine")
    if when == "checked":
        works._workers = Slow()
    number = run(leased, name)
    if when == "checked":
        leased.wait(lambda: works._workers.waiting)
    elif when == "asked":
        leased.wait(lambda: desk.view.consent is not None)
    else:
        assert "result" in leased.answer(number)
    if when == "dwelling":
        wait(leased, lambda: progress(desk).phase is RunPhase.DWELLING)
    if when == "paused":
        leased.ask("run.pause", lease=leased.lease)
        assert progress(desk).phase is RunPhase.PAUSED
    act(desk)
    assert desk.view.lease is None
    if when in {"checked", "asked"}:
        ended = reason(leased, number)
        assert ended == leased.told("lease")[-1]["reason"]["reason"]
    if when == "checked":
        works._workers.work()
    desk.rig.run(3.0)
    assert not desk.rig.controller.player.running
    assert act is stops or all(desk.rig.controller.operating_state.enabled)
    before = tuple(desk.rig.firmware.joints_deg)
    desk.rig.run(1.0)
    assert desk.rig.firmware.joints_deg == pytest.approx(before, abs=0.05)


@pytest.mark.parametrize("paused_while", ["moving", "checked"])
def test_one_that_the_operator_goes_on_with_ends_with_the_lease_and_is_not_said_to_go_on(
    leased, desk, library, monkeypatch, paused_while
):
    controller, slow = desk.rig.controller, Slow()
    if paused_while == "checked":
        monkeypatch.setattr(gate, "_AT_ONCE", -1.0)
        controller.gate._background = slow.submit
    assert "result" in leased.answer(run(leased, "fine"))
    assert bool(slow.waiting) is (paused_while == "checked")
    assert not isinstance(controller.player.pause(), Refusal)
    desk.rig.run(0.5)
    before = tuple(desk.rig.firmware.joints_deg)
    assert controller.player.go_on() == NOT_PAUSED()
    assert desk.view.lease is None
    slow.work()
    desk.rig.run(1.0)
    assert progress(desk).phase is RunPhase.STOPPED
    assert desk.rig.firmware.joints_deg == pytest.approx(before, abs=0.1)
    assert "run_continued" not in desk.rig.codes()


def test_a_recording_is_replayed_and_ended_with_the_lease(leased, desk, library):
    samples = np.full((1500, COLUMN_COUNT), np.nan)
    samples[:, 0] = np.arange(1500) / 100.0
    samples[:, 1:7] = 0.0
    samples[:, 1] = np.linspace(0.0, 30.0, 1500)
    library.save(Recording("slow", samples=samples))
    library.note_run("slow", RunOptions())
    assert leased.ask("trajectory.get", name="slow")["samples"][0] == [0.0] * 7
    assert leased.ask("trajectory.check", name="slow")["findings"] == []
    assert "result" in leased.answer(run(leased, "slow"))
    replayer = desk.rig.controller.replayer
    wait(leased, lambda: replayer.phase is RunPhase.MOVING and desk.rig.firmware.joints_deg[0] > 2)
    desk.take_back()
    desk.rig.run(1.5)
    before = desk.rig.firmware.joints_deg[0]
    desk.rig.run(1.0)
    assert not replayer.running
    assert desk.rig.firmware.joints_deg[0] == pytest.approx(before, abs=0.05)
    assert before < 25.0


def test_it_ends_its_run_and_keeps_the_lease(leased, desk, library, monkeypatch):
    monkeypatch.setattr(interface, "_MOST_MOVING", 2)
    assert "result" in leased.answer(run(leased, "fine"))
    for joint_number in range(1, 5):  # what it does meanwhile makes nobody forget the run
        color = {"lamp": 255, "red": 1, "green": 2, "blue": 3}
        leased.ask("lamps.set", lease=leased.lease, joint=joint_number, **color)
    leased.ask("trajectory.stop", lease=leased.lease)
    leased.wait(lambda: progress(desk).phase is RunPhase.STOPPED)
    leased.wait(lambda: "result" in leased.told("operation")[-1])  # told a little later
    assert desk.view.lease is not None
    assert leased.told("operation")[-1]["result"]["id"] == "run_ended"
    assert all(desk.rig.controller.operating_state.enabled)


def test_the_operators_own_run_is_not_the_clients_to_end(connect, desk, library):
    leased = with_lease(connect(), desk)
    desk.take_back()
    started = desk.rig.controller.player.start(Run("his", (joint(FAR),), (3.0,)))
    assert not isinstance(started, Refusal)
    again = leased.begin("lease.request", purpose="x", moves=True)
    leased.wait(lambda: desk.view.asked is not None)
    desk.grant(100)
    leased.ask("trajectory.stop", lease=leased.answer(again)["result"]["lease"])
    desk.take_back()
    desk.rig.run(0.5)
    assert desk.rig.controller.player.running
    assert started.ending is not Ending.CUT_OFF


def test_a_paused_run_goes_on_by_the_operators_held_press(leased, desk, library):
    assert "result" in leased.answer(run(leased, "fine"))
    leased.ask("run.pause", lease=leased.lease)
    number = leased.begin("run.go_on", lease=leased.lease)
    leased.wait(lambda: desk.view.consent is not None)
    assert progress(desk).phase is RunPhase.PAUSED
    desk.consent(given=True)
    assert "result" in leased.answer(number)
    wait(leased, lambda: progress(desk).phase is RunPhase.DONE)
    assert desk.view.lease is not None
