"""The lease of the arm over the local interface (S29)."""

import pytest

THERE = [10.0, 20.0, -30.0, 0.0, 10.0, 0.0]


def test_hello_tells_the_arm(client):
    arm = client.hello["arm"]
    assert arm["simulated"] is True
    assert arm["model"] == "piper"
    assert client.hello["protocol"] == 1
    assert len(client.hello["limits"]) == 6


def test_without_a_lease_nothing_moves(client, desk):
    wrong = client.refused("motion.send", angles_deg=THERE)
    assert wrong["data"]["reason"] == "lease_not_held"
    desk.rig.run(0.5)
    assert desk.rig.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.01)


def test_with_a_lease_it_moves_and_the_outcome_follows(leased, desk):
    number = leased.ask("motion.send", lease=leased.lease, angles_deg=THERE)["number"]
    leased.wait(
        lambda: any(
            each["number"] == number and each["state"] == "done"
            for each in leased.told("operation")
        )
    )
    assert desk.rig.firmware.joints_deg == pytest.approx(THERE, abs=0.1)


def test_release(leased, desk):
    leased.ask("lease.release", lease=leased.lease)
    assert desk.view.lease is None
    assert leased.refused("motion.home", lease=leased.lease)["data"]["reason"] == "lease_not_held"


def test_a_stream_is_followed(leased, desk):
    rig = desk.rig
    start = list(rig.firmware.joints_deg)
    for step in range(100):
        leased.begin(
            "stream.target", lease=leased.lease, joints_deg=[start[0] + 0.2 * step, *start[1:]]
        )
        leased.wait(lambda n=leased.ids: n in leased.answers)
    rig.run(1.0)
    leased.read()
    assert rig.firmware.joints_deg[0] == pytest.approx(start[0] + 19.8, abs=0.2)


def test_the_holder_is_told_why_the_lease_has_ended(leased, desk):
    desk.take_back()
    leased.wait(lambda: leased.told("lease"))
    (told,) = leased.told("lease")
    assert told["lease"] == leased.lease
    assert told["reason"]["reason"] == "lease_taken_back"


def test_episodes_are_marked_without_a_lease_and_are_nothing_that_a_lease_does(
    leased, desk, connect
):
    lines: list[dict[str, object]] = []
    desk.rig.controller.episodes.begin_log(lines.append, 0.0)
    other = connect("a recorder")
    number = other.ask("episode.begin", task="pour")["number"]
    assert desk.view.doing == ""
    assert other.refused("episode.begin")["data"]["reason"] == "episode_under_way"
    other.ask("episode.end")
    other.wait(lambda: any(each["state"] == "done" for each in other.told("operation")))
    assert {each["number"] for each in other.told("operation")} >= {number}
    other.ask("episode.discard")
    assert [(each["task"], each["discarded"]) for each in lines] == [
        ("pour", False),
        ("pour", False),
        ("pour", True),
    ]
    assert "client_asks" in desk.rig.codes()
    assert desk.view.lease is not None
