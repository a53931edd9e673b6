"""`armui api`: prints the methods of the local interface, for authors of clients."""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.interface.messages import Json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declares the options of the command."""
    parser.add_argument(
        "--schema",
        action="store_true",
        required=True,
        help="print the methods with their arguments, units and ranges as an OpenRPC document",
    )


def run(options: argparse.Namespace) -> int:
    """Runs the command with options read by `add_arguments`; returns the exit code."""
    if options.schema:
        json.dump(document(), sys.stdout, ensure_ascii=False, indent=2)
        sys.stdout.write("\n")
    return 0


def document() -> Json:
    """Returns the interface as an OpenRPC document."""
    from armui.control.arm_controller import ArmController  # noqa: PLC0415 - Qt, for this only
    from armui.interface.openrpc import openrpc  # noqa: PLC0415 - as above

    return openrpc(ArmController(lambda _device: iter(())).operations)  # type: ignore[arg-type,return-value]
