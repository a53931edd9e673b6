"""The messages of the local interface, JSON-RPC 2.0, one a line: pure."""

from __future__ import annotations

import enum
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Final

from armui.arm.refusal import Refusal
from armui.system import paths
from armui.system.files import read_file
from armui.telemetry.events import EventOutcome

PROTOCOL: Final = 1
"""Counts up with each change that a client could notice."""
MAX_BYTES: Final = 64 * 1024
"""The longest line, its end included."""
_DIGITS: Final = 6

Id = int | str | None
Json = dict[str, Any]


class Code(enum.IntEnum):
    """The error codes: those of JSON-RPC 2.0, and one of ours."""

    PARSE = -32700
    INVALID = -32600
    METHOD = -32601
    PARAMS = -32602
    INTERNAL = -32603
    REFUSED = -32000
    """The program refuses the call; ``data`` has the reason that the operator reads."""


@dataclass(frozen=True, slots=True)
class Call:
    """A call from a client.

    Attributes:
        id: The id of its answer; ``None`` for a notification, which has no answer.
        method: The name of the method.
        params: The arguments by name.
        answered: False for a notification.
    """

    id: Id
    method: str
    params: Json = field(default_factory=dict)
    answered: bool = True


class CallError(Exception):
    """A call that cannot be carried out.

    Attributes:
        code: The number of the error.
        id: The id of the call, if it could be read.
        data: Further data about the error.
    """

    def __init__(self, code: Code, text: str, *, id_: Id = None, data: Json | None = None) -> None:
        super().__init__(text)
        self.code = code
        self.id = id_
        self.data = data


def refused(refusal: Refusal) -> CallError:
    """Return a refusal by the program as the error of a call."""
    data = {"reason": refusal.code, "figures": figures(refusal.params)}
    return CallError(Code.REFUSED, english(refusal.reason.source, refusal.params), data=data)


def ended(outcome: EventOutcome) -> CallError:
    """Return how something has ended as the error of a call."""
    told = plain_outcome(outcome)
    data = {"reason": told["id"], "figures": told["figures"]}
    return CallError(Code.REFUSED, told["text"], data=data)


def plain_outcome(outcome: EventOutcome) -> Json:
    """Return how something has ended, as the operator reads it."""
    text = english(sentences().get(outcome.code, ""), outcome.params)
    return {"id": outcome.code, "text": text, "figures": figures(outcome.params)}


def read_call(line: bytes) -> Call:
    """Read one line.

    Raises:
        CallError: It is no call of JSON-RPC 2.0.
    """
    try:
        message = json.loads(line, parse_constant=_no_constant)
    except (ValueError, RecursionError):
        raise CallError(Code.PARSE, "This line is no JSON. Send one call a line.") from None
    if not isinstance(message, dict):
        raise CallError(Code.INVALID, "A call is a JSON object; batches are not taken.")
    id_ = message.get("id")
    if isinstance(id_, bool) or not isinstance(id_, int | str | None):
        raise CallError(Code.INVALID, "“id” must be a whole number or a text.")
    method, params = message.get("method"), message.get("params", {})
    if message.get("jsonrpc") != "2.0" or not isinstance(method, str):
        raise CallError(Code.INVALID, "Wanted: “jsonrpc” 2.0 and “method”, a text.", id_=id_)
    if not isinstance(params, dict):
        raise CallError(Code.PARAMS, "“params” must be an object: arguments by name.", id_=id_)
    return Call(id_, method, params, "id" in message)


def _no_constant(name: str) -> float:
    raise ValueError(name)


def result(id_: Id, value: object) -> bytes:
    """Return the line that answers a call."""
    return _line({"jsonrpc": "2.0", "id": id_, "result": value})


def error(wrong: CallError, id_: Id = None) -> bytes:
    """Return the line that says why a call was not carried out."""
    told: Json = {"code": int(wrong.code), "message": str(wrong)}
    if wrong.data is not None:
        told["data"] = wrong.data
    return _line({"jsonrpc": "2.0", "id": wrong.id if id_ is None else id_, "error": told})


def notification(method: str, params: Mapping[str, object]) -> bytes:
    """Return the line of a notification, which answers no call."""
    return _line({"jsonrpc": "2.0", "method": method, "params": params})


def _line(message: Json) -> bytes:
    return json.dumps(message, ensure_ascii=False, allow_nan=False).encode() + b"\n"


def english(source: str, params: Mapping[str, object]) -> str:
    """Return a sentence of the program in English with its figures."""
    try:
        return source.format_map({name: _shown(value) for name, value in params.items()})
    except (KeyError, IndexError, ValueError):
        return source  # a figure is missing, or has a format that only the window can fill in


@cache
def sentences() -> Mapping[str, str]:
    """Return the program's sentences in English by their ids, read from a file the first time."""
    found: Mapping[str, Mapping[str, str]] = json.loads(
        read_file(paths.RESOURCES / "i18n" / "sentences.json")
    )
    return {**found["Refusal"], **found["Observed"], **found["Notice"]}


def _shown(value: object) -> object:
    if isinstance(value, Refusal):
        return english(value.reason.source, value.params)
    return f"{value:g}" if isinstance(value, float) else value


def figures(params: Mapping[str, object]) -> Json:
    """Return the figures of a sentence in plain JSON."""
    return {name: plain(value) for name, value in params.items()}


def plain(value: object) -> object:
    """Return a value of the program in plain JSON: numbers finite, everything else by its text."""
    if isinstance(value, bool | int | str) or value is None:
        return value
    if isinstance(value, float):
        finite = value == value and abs(value) != float("inf")  # noqa: PLR0124 - NaN is not itself
        return round(value, _DIGITS) if finite else None
    if isinstance(value, Refusal):
        return {"reason": value.code, "text": _shown(value), "figures": figures(value.params)}
    if isinstance(value, enum.Enum):
        return value.name.lower()
    if isinstance(value, tuple | list):
        return [plain(each) for each in value]
    return str(value)
