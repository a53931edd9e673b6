"""The real MCP client and server before a simulated arm: ``python -m tests.tools.mcp_host``.

In an environment with armui, armui_client and armui_mcp (which brings `mcp`). It starts
``armui sim --api-on --grant`` and a host that starts ``armui mcp``, and prints what that has seen.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import anyio
from mcp.client.client import Client
from mcp.client.stdio import StdioServerParameters

import armui_client

ARMUI = (sys.executable, "-m", "armui")
WITHIN_S = 30.0
AWAY = {"angles_deg": [-90, 40, -50, 0, 20, 0]}


def until_it_answers(path: Path) -> None:
    """Wait until the arm is heard."""
    until_s = time.monotonic() + WITHIN_S
    while True:
        try:
            with armui_client.connect("waits", path=path) as arm:
                arm.state().joints_deg.get()
        except armui_client.ArmuiError:
            if time.monotonic() > until_s:
                raise
            time.sleep(0.2)
        else:
            return


async def call(client: Client, name: str, *, fails: bool = False, **arguments: Any) -> Any:
    """Call a tool, print it, and return its answer."""
    began_s = time.monotonic()
    answer = await client.call_tool(name, arguments)
    text = answer.content[0].text
    print(f"{name} {arguments}: {text[:200]} ({1e3 * (time.monotonic() - began_s):.0f} ms)")
    assert answer.is_error == fails, text
    return text if fails else answer.structured_content


async def host(path: Path) -> None:
    """Do what a language model's host does."""
    server = StdioServerParameters(
        command=ARMUI[0], args=[*ARMUI[1:], "mcp"], env={**os.environ, "ARMUI_SOCKET": str(path)}
    )
    async with Client(server) as client:
        tools = (await client.list_tools()).tools
        print(f"{client.server_info.name} {client.server_info.version}: {len(tools)} tools")
        await call(client, "motion_step", fails=True, joint=1, delta_deg=5)
        await call(client, "lease_request", purpose="shows what MCP can do", max_speed_percent=30)
        enabled = await call(client, "state_get", fields=["enabled"])
        if not all(enabled["measured"]["enabled"]["value"]):
            await call(client, "motors_enable")
        moved = await call(client, "motion_send", angles_deg=[0, 40, -50, 0, 20, 0])
        assert moved["state"] == "done", moved
        await call(client, "motion_step", fails=True, joint=1, delta_deg=400)
        state = await call(client, "state_get", fields=["joints_deg"])
        off_deg = max(
            abs(found - asked)
            for found, asked in zip(
                state["measured"]["joints_deg"]["value"], (0, 40, -50, 0, 20, 0), strict=True
            )
        )
        print(f"off by {off_deg:.3f}°")
        assert off_deg < 0.5
        # a call that its host gives up ends what it has begun
        with anyio.move_on_after(0.6):
            await call(client, "motion_send", angles_deg=[120, 40, -50, 0, 20, 0])
        await anyio.sleep(1.0)
        first = await call(client, "state_get", fields=["joints_deg"])
        await anyio.sleep(1.0)
        second = await call(client, "state_get", fields=["joints_deg"])
        at_deg = [each["measured"]["joints_deg"]["value"][0] for each in (first, second)]
        print(f"given up: J1 rests at {at_deg[0]:.2f}°, a second later {at_deg[1]:.2f}°")
        assert at_deg[0] < 100.0
        assert abs(at_deg[1] - at_deg[0]) < 0.1
        # the host ends in motion; that it was given up has ended the lease
        await call(client, "lease_request", purpose="ends in motion", max_speed_percent=30)
        async with anyio.create_task_group() as group:
            group.start_soon(client.call_tool, "motion_send", AWAY)
            await anyio.sleep(0.6)
            group.cancel_scope.cancel()
    with armui_client.connect("looks", path=path) as arm:
        time.sleep(1.0)
        first_deg = arm.state().joints_deg.get()[0]
        time.sleep(1.0)
        second_deg = arm.state().joints_deg.get()[0]
        print(f"host gone: J1 rests at {first_deg:.2f}°, a second later {second_deg:.2f}°")
        assert abs(second_deg - first_deg) < 0.1
        with arm.lease("another one has it"):
            print("the lease is free again")


def main() -> None:
    """Run it all."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "api.sock"
        process = subprocess.Popen([*ARMUI, "sim", "--api-on", "--grant", "--socket", str(path)])
        try:
            until_it_answers(path)
            anyio.run(host, path)
        finally:
            process.terminate()
            process.wait(10.0)
    print("all held")


if __name__ == "__main__":
    main()
