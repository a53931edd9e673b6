"""`armui mcp`: the local interface for language models, by the Model Context Protocol."""

from __future__ import annotations

import argparse
import sys

from armui.interface.api_command import document
from armui.system.command_line import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the options of the command: it has none."""
    del parser


def run(_options: argparse.Namespace) -> int:
    """Serves on standard input and output until these are closed; returns the exit code."""
    try:
        from armui_mcp.server import serve  # noqa: PLC0415 - its package may be missing
    except ImportError as error:
        text = say(
            "armui mcp: {error}. In a copy of armui's repository: "
            "pip install ./resources/clients/armui_client ./resources/clients/armui_mcp",
            error=error,
        )
        sys.stderr.write(f"{text}\n")
        return 1
    serve(document())
    return 0
