"""The OpenRPC document of the local interface, made from the registry of operations."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import TYPE_CHECKING

from armui import __version__
from armui.interface.messages import PROTOCOL, Json
from armui.interface.methods import METHODS, schema_of
from armui.interface.plain_forms import schema

if TYPE_CHECKING:
    from armui.control.operations.operation import BoundOperation


def openrpc(operations: Mapping[str, BoundOperation]) -> Json:
    """Return the interface as an OpenRPC document, made from the registry of operations."""
    return {
        "openrpc": "1.3.2",
        "info": {"title": "armui", "version": f"{__version__} (protocol {PROTOCOL})"},
        "methods": [
            *itertools.starmap(schema_of, METHODS.items()),
            *schema(operations),
        ],
    }
