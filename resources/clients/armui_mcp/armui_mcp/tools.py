"""The methods of armui's local interface as tools: what each takes, and what it answers."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

from armui_client import Arm, ArmuiError, Invalid, Lease, Operation, Refused

PURPOSE: Final = (
    "Moves a real robot arm, or a simulated one, through armui, whose operator has it in sight. "
    "Reading, halt and stop are free. What moves or sets something needs the arm: ask for it by "
    "lease_request; the operator grants it by holding a button, or refuses. Give it back by "
    "lease_release when the work is done. Figures are in degrees, mm and percent. A refusal says "
    "what speaks against a call: tell it to the user, and do not try ways around it."
)

_LEASE: Final = "lease"
_REQUEST: Final = "lease.request"
_RELEASE: Final = "lease.release"
_LEFT_OUT: Final = frozenset({"hello", "ping", "stream.target", "stream.end"})
"""The connection does it by itself, or it wants a pace that no language model keeps."""
_NOTIFIES: Final = ("subscribe", "unsubscribe")
_UNIT: Final = "x-unit"
_STOP: Final = "stop"
_ACTS: Final = frozenset({_STOP, "halt", _REQUEST})
"""What needs no lease, and is more than reading."""


@dataclass(frozen=True)
class Tool:
    """A method as a tool.

    Attributes:
        name: As MCP's hosts take it: letters and underscores.
        method: Its name at armui.
        title: What it does, in a line.
        description: The same, with what it needs.
        takes: The JSON schema of its arguments.
        reads_only: True if it neither moves nor sets anything.
        drops: True if the arm may drop after it, or something is lost by it.
    """

    name: str
    method: str
    title: str
    description: str
    takes: Mapping[str, Any]
    reads_only: bool
    drops: bool


def tools_of(document: Mapping[str, Any]) -> dict[str, Tool]:
    """Return the tools by their names, made from what `armui api --schema` prints."""
    found = [
        _tool_of(each)
        for each in document["methods"]
        if each["name"] not in _LEFT_OUT and not each["name"].endswith(_NOTIFIES)
    ]
    return {each.name: each for each in found}


def _tool_of(method: Mapping[str, Any]) -> Tool:
    name, summary = method["name"], method["summary"].removesuffix(".")
    params = [each for each in method["params"] if each["name"] != _LEASE]
    leased = len(params) < len(method["params"])
    asks = method.get("x-asks-the-operator", False)
    sentences = [f"{summary}."]
    if leased and name != _RELEASE:
        sentences.append("Needs the arm (lease_request).")
    if asks:
        sentences.append("The operator is asked each time, and holds a button to allow it.")
    return Tool(
        name=name.replace(".", "_"),
        method=name,
        title=summary,
        description=" ".join(sentences),
        takes={
            "type": "object",
            "properties": {each["name"]: _in_words(each["schema"]) for each in params},
            "required": [each["name"] for each in params if each["required"]],
            "additionalProperties": False,
        },
        reads_only=not leased and name not in _ACTS and "x-moves" not in method,
        drops=asks or name == _STOP,
    )


def _in_words(schema: Mapping[str, Any]) -> dict[str, Any]:
    """Return a schema with its unit in words, as no host knows armui's own keyword for it."""
    found = {
        key: _in_words(each) if isinstance(each, Mapping) else each
        for key, each in schema.items()
        if key != _UNIT
    }
    return {**found, "description": f"in {schema[_UNIT]}"} if _UNIT in schema else found


class ToolCaller:
    """Calls tools at armui, to which it connects when it is first needed, and again after an end.

    Its methods may be called from several threads.

    Args:
        tools: The tools by their names.
        connect: Connects to armui.
    """

    def __init__(self, tools: Mapping[str, Tool], connect: Callable[[], Arm]) -> None:
        self._tools = tools
        self._connect = connect
        self._arm: Arm | None = None
        self._lease: Lease | None = None
        self._connecting = threading.Lock()

    def call(self, name: str, arguments: Mapping[str, Any]) -> dict[str, Any]:
        """Call a tool, and wait for the end of what it begins.

        Returns:
            What armui answers; of an operation its `state`, `reason` and `text`.

        Raises:
            ArmuiError: It is refused, has failed, or armui is not there; the text says why.
        """
        tool = self._tools.get(name)
        if tool is None:
            raise Invalid(f"There is no tool {name!r}.")
        if unknown := arguments.keys() - tool.takes["properties"].keys():
            names = ", ".join(sorted(unknown))
            raise Invalid(f"{name} does not take: {names}.")
        arm = self._connected()
        if tool.method == _REQUEST:
            return self._ask_for_the_arm(arm, arguments)
        if tool.method == _RELEASE:
            if self._lease is None or not self._lease.held:
                raise Refused("The arm is not yours: there is nothing to give back.")
            self._lease.release()
            return {}
        found = arm.call(tool.method, **arguments)
        if isinstance(found, Operation):
            return {"state": found.state, "reason": found.reason, "text": found.text}
        return found if isinstance(found, dict) else {"result": found}

    def close(self) -> None:
        """Close the connection; the lease ends with it, its motion, and what the operator is asked.

        The next call connects again.
        """
        with self._connecting:
            if self._arm is not None:
                self._arm.close()
            self._arm = None

    def _connected(self) -> Arm:
        with self._connecting:
            if self._arm is None or not self._arm.is_connected:
                if self._arm is not None:
                    self._arm.close()
                self._arm, self._lease = self._connect(), None
            return self._arm

    def _ask_for_the_arm(self, arm: Arm, arguments: Mapping[str, Any]) -> dict[str, Any]:
        if self._lease is not None and self._lease.held:
            raise Refused("The arm is yours already: give it back by lease_release first.")
        wanted = {"purpose": "", "max_speed_percent": 100, "moves": True, **arguments}
        self._lease = arm.lease(
            wanted["purpose"], max_speed_percent=wanted["max_speed_percent"], moves=wanted["moves"]
        ).take()
        return {"max_speed_percent": self._lease.max_speed_percent}


def told(error: ArmuiError) -> str:
    """Return what a host is told of an error: its sentence, and the id of its reason."""
    return f"{error} ({error.reason})" if error.reason else str(error)
