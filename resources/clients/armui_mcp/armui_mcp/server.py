"""The server: MCP on standard input and output, armui's tools behind it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, Final

import anyio
import armui_client
from mcp import types
from mcp.server.lowlevel import Server
from mcp.server.stdio import stdio_server

from armui_mcp import __version__
from armui_mcp.tools import PURPOSE, Tool, ToolCaller, told, tools_of

_NAME: Final = "armui mcp"


def serve(document: Mapping[str, Any], path: Path | None = None) -> None:
    """Serve until the host closes standard input; the lease ends then.

    Args:
        document: armui's OpenRPC document.
        path: The socket; by default that of `armui_client`.
    """
    tools = tools_of(document)
    caller = ToolCaller(tools, lambda: armui_client.connect(_NAME, path=path))
    try:
        anyio.run(_serve, tools, caller)
    finally:
        caller.close()


async def _serve(tools: Mapping[str, Tool], caller: ToolCaller) -> None:
    async def listed(_context: Any, _params: Any) -> types.ListToolsResult:
        return types.ListToolsResult(tools=[*map(_published, tools.values())])

    async def called(_context: Any, params: types.CallToolRequestParams) -> types.CallToolResult:
        arguments = params.arguments or {}
        call = partial(caller.call, params.name, arguments)
        try:
            # the thread ends by the end of what it waits for; the host has its answer before
            found = await anyio.to_thread.run_sync(call, abandon_on_cancel=True)
        except armui_client.ArmuiError as error:
            return _answer(told(error), is_error=True)
        except anyio.get_cancelled_exc_class():
            tool = tools.get(params.name)
            if tool is not None and not tool.reads_only:
                # what it asked for and what it moves end with the connection, and nothing else
                with anyio.CancelScope(shield=True):
                    await anyio.to_thread.run_sync(caller.close)
            raise
        return _answer(json.dumps(found, ensure_ascii=False), found)

    server = Server(
        "armui",
        version=__version__,
        instructions=PURPOSE,
        on_list_tools=listed,
        on_call_tool=called,
    )
    async with stdio_server() as (reads, writes):
        await server.run(reads, writes, server.create_initialization_options())


def _answer(
    text: str, found: Mapping[str, Any] | None = None, *, is_error: bool = False
) -> types.CallToolResult:
    content = types.TextContent(type="text", text=text)
    return types.CallToolResult(content=[content], structured_content=found, is_error=is_error)


def _published(tool: Tool) -> types.Tool:
    return types.Tool(
        name=tool.name,
        title=tool.title,
        description=tool.description,
        input_schema=dict(tool.takes),
        annotations=types.ToolAnnotations(
            read_only_hint=tool.reads_only, destructive_hint=tool.drops, open_world_hint=False
        ),
    )
