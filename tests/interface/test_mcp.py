"""armui's tools for language models, before a simulated arm: `armui-mcp`.

The server itself wants 60 MB that nothing else here needs: `python -m tests.tools.mcp_host` runs it
with the protocol's own client.
"""

import argparse
import re
import sys
from pathlib import Path

import pytest

import armui_client
from armui.interface import mcp_command
from armui.interface.methods import METHODS
from armui.interface.openrpc import openrpc
from armui_mcp.tools import ToolCaller, told, tools_of

ROOT = Path(__file__).resolve().parents[2]
LEASE = {"purpose": "tidy up", "max_speed_percent": 40}
FREE = {
    *("kinematics_fk", "kinematics_ik", "operations_list", "state_get"),
    *("trajectory_check", "trajectory_get", "trajectory_list", "trajectory_plan"),
}


@pytest.fixture
def tools(desk):
    return tools_of(openrpc(desk.rig.controller.operations))


@pytest.fixture
def caller(desk, tools):
    caller = ToolCaller(tools, lambda: armui_client.connect("a model", path=desk.view.path))
    yield caller
    caller.close()


def refusal(call, *arguments):
    with pytest.raises(armui_client.ArmuiError) as caught:
        call(*arguments)
    return told(caught.value)


def test_every_method_and_operation_is_a_tool_but_those_of_the_connection(desk, tools):
    by_method = {each.method: each for each in tools.values()}
    document = openrpc(desk.rig.controller.operations)["methods"]
    assert {each["name"] for each in document} - {*by_method} == {
        *("hello", "ping", "stream.target", "stream.end"),
        *(name for name in METHODS if name.endswith("subscribe")),
    }
    for each in document:
        tool = by_method.get(each["name"])
        if tool is None:
            continue
        names = [param["name"] for param in each["params"] if param["name"] != "lease"]
        assert [*tool.takes["properties"]] == names
        assert "x-unit" not in str(tool.takes)
        needs = "lease" in str(each["params"]) and tool.method != "lease.release"
        assert ("Needs the arm" in tool.description) == needs
        assert tool.drops or not each.get("x-asks-the-operator")


def test_their_names_are_what_every_host_takes_and_what_reads_only_says_so(tools):
    assert all(re.fullmatch("[a-z_]{1,64}", name) for name in tools)
    assert {each.name for each in tools.values() if each.reads_only} == FREE
    assert tools["stop"].drops
    assert not tools["halt"].drops
    assert tools["motion_step"].takes["properties"]["delta_deg"]["description"] == "in °"


def test_reading_is_free_and_moving_needs_the_operator(script, caller):
    def run():
        state = caller.call("state_get", {"fields": ["joints_deg"]})
        assert len(state["measured"]["joints_deg"]["value"]) == 6
        assert {"id", "why_not"} <= {*caller.call("operations_list", {})["result"][0]}
        no_lease = refusal(caller.call, "motion_step", {"joint": 1, "delta_deg": 3})
        assert caller.call("lease_request", LEASE) == {"max_speed_percent": 40}
        twice = refusal(caller.call, "lease_request", LEASE)
        moved = caller.call("motion_step", {"joint": 1, "delta_deg": 3})
        assert caller.call("lease_release", {}) == {}
        again = refusal(caller.call, "lease_release", {})
        return no_lease, twice, moved, again

    no_lease, twice, moved, again = script.run(run)
    assert "lease" in no_lease
    assert "yours already" in twice
    assert moved["state"] == "done"
    assert "nothing to give back" in again
    assert script.rig.firmware.joints_deg[0] == pytest.approx(3.0, abs=0.3)
    assert script.desk.view.lease is None


def test_what_is_refused_is_told_with_the_id_of_its_reason(script, caller):
    def run():
        caller.call("lease_request", LEASE)
        far = refusal(caller.call, "motion_step", {"joint": 1, "delta_deg": 400})
        unknown = refusal(caller.call, "motion_step", {"joint": 9, "delta_deg": 1})
        nothing = refusal(caller.call, "motion_dance", {})
        return far, unknown, nothing

    far, unknown, nothing = script.run(run)
    assert far.endswith("(step_beyond_limit)")
    assert "1 to 6" in unknown
    assert "no tool" in nothing


def test_what_a_tool_does_not_take_reaches_nobody(script, caller):
    """`wait` is an argument of the client's own call, by which a motion would not be waited for."""

    def run():
        caller.call("lease_request", LEASE)
        return refusal(caller.call, "motion_step", {"joint": 1, "delta_deg": 3, "wait": False})

    assert script.run(run) == "motion_step does not take: wait."


def test_what_is_given_up_while_the_operator_is_asked_asks_him_no_more(script, caller):
    script.percent = None
    script.meanwhile = lambda: script.desk.view.asked and caller.close()
    script.run(lambda: refusal(caller.call, "lease_request", LEASE))
    script.rig.run(0.1)
    assert script.desk.view.asked is None
    script.percent, script.meanwhile = 100, lambda: None
    assert script.run(lambda: caller.call("lease_request", LEASE)) == {"max_speed_percent": 40}


def test_without_the_package_the_command_says_how_to_install_it(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "armui_mcp.server", None)
    assert mcp_command.run(argparse.Namespace()) == 1
    folders = re.findall(r"\./(\S+)", capsys.readouterr().err)
    assert len(folders) == 2
    assert all((ROOT / each / "pyproject.toml").exists() for each in folders)


def test_the_operator_declines(script, caller):
    script.percent = None
    script.meanwhile = lambda: script.desk.view.asked and script.desk.decline()
    said = script.run(lambda: refusal(caller.call, "lease_request", LEASE))
    assert said.endswith("(lease_declined)")


def test_without_armui_it_says_so_and_connects_once_that_is_there(desk, tools, script):
    path = [desk.view.path + ".none"]
    caller = ToolCaller(tools, lambda: armui_client.connect("a model", path=path[0]))
    assert "No armui answers" in script.run(lambda: refusal(caller.call, "state_get", {}))
    path[0] = desk.view.path
    assert script.run(lambda: caller.call("state_get", {}))["measured"]
    caller.close()
    assert script.run(lambda: caller.call("state_get", {}))["measured"]
    caller.close()


def test_its_end_is_the_end_of_the_lease(script, caller):
    script.run(lambda: caller.call("lease_request", LEASE))
    assert script.desk.view.lease is not None
    caller.close()
    script.rig.run(0.1)
    assert script.desk.view.lease is None
