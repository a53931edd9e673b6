"""What the client does with poses and the operator's library."""

import pytest

import armui_client
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Trajectory, Waypoint
from tests.company import OtherHost

THERE = (10.0, 20.0, -30.0, 0.0, 10.0, 0.0)
READY = (0.0, 60.0, -60.0, 0.0, 30.0, 0.0)


def test_a_stream_of_poses_is_followed_and_leaps_are_refused(with_lease, script):
    def ask(arm):
        arm.move_joints(READY)
        x, y, z, *turned = arm.fk(READY)
        with arm.stream(rate_hz=50, raises=False) as targets:
            for step in range(100):
                targets.pose((x, y + 0.4 * step, z, *turned))
            for _ in range(25):
                targets.pose((x, y + 40.0, z, *turned))
            assert targets.refused == 0
            there = arm.fk(arm.state().joints_deg.get())
            wrong = ((5000.0, *there[1:]), arm.fk((90.0, *READY[1:])))
            seen = {
                refusal.reason
                for pose in (*wrong, (x, y + 40.0, z, *turned))
                for refusal in [targets.pose(pose) for _ in range(10)]
                if refusal is not None
            }
        return there, (x, y + 40.0, z), seen

    there, wanted, seen = with_lease(ask)
    assert there[:3] == pytest.approx(wanted, abs=1.0)
    assert seen == {"pose_out_of_reach", "stream_leaps"}


def test_the_library_is_typed_and_a_trajectory_is_run(with_lease, script):
    points = tuple(Waypoint(MoveMode.MOVE_J, each, speed_percent=100) for each in (THERE, READY))
    script.desk.shelf.library().save(Trajectory("way", points=points))

    def ask(arm):
        (listed,) = arm.trajectories()
        assert (listed.name, listed.kind, listed.count, listed.has_run) == (
            "way",
            "points",
            2,
            False,
        )
        rows = arm.trajectory("way")["points"]
        checked, plan = arm.check("way"), arm.plan(rows)
        assert checked.findings == plan.findings
        with pytest.raises(armui_client.Invalid, match="at most 65536"):
            arm.check(rows * 500)
        assert (checked.errors, len(plan.expected_s)) == (0, 2)
        assert plan.joints_deg[-1] == pytest.approx(READY, abs=0.01)
        with pytest.raises(armui_client.Refused, match="not in the library") as found:
            arm.run("no")
        assert found.value.reason == "file_gone"
        begun = arm.run("way", wait=False)
        arm.pause()
        assert arm.go_on().state == "sent"
        arm.end_motion()
        with pytest.raises(armui_client.Failed):
            begun.wait()
        return arm.run("way", first_row=2)

    done = with_lease(ask)
    assert (done.state, done.reason) == ("done", "run_done")
    assert script.rig.firmware.joints_deg == pytest.approx(READY, abs=0.1)


def test_a_consent_that_another_host_ends_is_a_lost_lease(with_lease, script):
    """It is no refusal: nothing of this client's can be asked for any more."""
    hosts: list[OtherHost] = []
    script.consents = None

    def meanwhile():
        if script.desk.view.consent is not None and not hosts:
            hosts.append(OtherHost(script.rig))
            hosts[0].move_to((1, 0, 0, 0, 0, 0))

    script.meanwhile = meanwhile
    with pytest.raises(armui_client.LeaseLost, match="Another program") as found:
        with_lease(lambda arm: arm.disable(3))
    assert found.value.reason == "other_host"
    hosts[0].close()
