"""The parameters of one arm as a file that people can read: JSON, one parameter a line.

A file names its format and version, when and by which program it was saved, and from which arm.
What is broken, truncated or foreign is refused with the place where it is wrong.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Final

from armui.arm.limits import JOINTS
from armui.arm.parameters import KINDS, Group, Parameter
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode

FORMAT: Final = "armui-parameters"
VERSION: Final = 1
SUFFIX: Final = ".json"

_DECIMALS: Final = 6
"""More than any frame can carry, in the operator's units."""
_GENERATIONS: Final = (1, 2)
_OF_EACH_JOINT: Final = frozenset({Group.JOINT_LIMITS, Group.JOINT_ACCELERATION, Group.COLLISION})


@dataclass(frozen=True, slots=True)
class Backup:
    """What an arm held at one time.

    Attributes:
        saved_at: With its time zone.
        program: Which program wrote it, with its version.
        generation: Of the protocol the arm spoke, 1 or 2.
        firmware: Its version text; ``None``: it told none (generation 1).
        device: How the arm was connected, as the operator read it.
        values: In the operator's units.
    """

    saved_at: datetime
    program: str
    generation: int
    firmware: str | None
    device: str
    values: Mapping[Parameter, float]


class _WrongError(Exception):
    """What is wrong with a file; never leaves this module."""

    def __init__(self, code: RefusalCode, **params: float | str) -> None:
        super().__init__(code)
        self.refusal = Refusal(code, params)


def to_text(backup: Backup) -> str:
    """A backup as the text of its file."""
    head = {
        "format": FORMAT,
        "version": VERSION,
        "saved_at": backup.saved_at.isoformat(timespec="seconds"),
        "program": backup.program,
        "arm": {
            "generation": backup.generation,
            "firmware": backup.firmware,
            "device": backup.device,
        },
    }
    rows = [
        "    " + json.dumps(_row(parameter, value), ensure_ascii=False)
        for parameter, value in backup.values.items()
    ]
    opening = json.dumps(head, indent=2, ensure_ascii=False).removesuffix("\n}")
    return opening + ',\n  "parameters": [\n' + ",\n".join(rows) + "\n  ]\n}\n"


def _row(parameter: Parameter, value: float) -> dict[str, float | int | str]:
    joint: dict[str, float | int | str] = {"joint": parameter.joint} if parameter.joint else {}
    return {
        "name": parameter.name,
        **joint,
        "value": round(value, _DECIMALS),
        "unit": parameter.kind.unit,
    }


def from_text(text: str) -> Backup | Refusal:
    """The backup in the text of a file, or what is wrong with it and where."""
    try:
        return _backup(_object(_parsed(text), ""))
    except _WrongError as wrong:
        return wrong.refusal


def _parsed(text: str) -> object:
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise _WrongError(
            RefusalCode.BACKUP_NO_JSON, line=error.lineno, column=error.colno
        ) from error
    except (RecursionError, ValueError) as error:  # thousands of brackets, or of digits
        raise _WrongError(RefusalCode.BACKUP_FOREIGN) from error


def _backup(entries: Mapping[str, Any]) -> Backup:
    if entries.get("format") != FORMAT:
        raise _WrongError(RefusalCode.BACKUP_FOREIGN)
    version = entries.get("version")
    if version != VERSION or isinstance(version, bool):
        raise _WrongError(RefusalCode.BACKUP_VERSION, version=str(version), known=VERSION)
    arm = _object(_field(entries, "arm"), "arm")
    generation = _field(arm, "generation", "arm.")
    if isinstance(generation, bool) or generation not in _GENERATIONS:
        raise _bad("arm.generation", generation)
    firmware = arm.get("firmware")
    return Backup(
        saved_at=_time(_field(entries, "saved_at")),
        program=_text(_field(entries, "program"), "program"),
        generation=int(generation),
        firmware=None if firmware is None else _text(firmware, "arm.firmware"),
        device=_text(_field(arm, "device", "arm."), "arm.device"),
        values=_values(_field(entries, "parameters")),
    )


def _values(rows: object) -> Mapping[Parameter, float]:
    if not isinstance(rows, list):
        raise _bad("parameters", rows)
    if not rows:
        raise _WrongError(RefusalCode.BACKUP_EMPTY)
    values: dict[Parameter, float] = {}
    for place, entries in enumerate(rows, start=1):
        where = f"parameters[{place}]"
        row = _object(entries, where)
        parameter = _parameter(row, f"{where}.")
        if parameter in values:
            raise _WrongError(RefusalCode.BACKUP_TWICE, field=where, parameter=parameter.name)
        values[parameter] = _value(row, parameter, f"{where}.")
    return values


def _parameter(row: Mapping[str, Any], where: str) -> Parameter:
    name = _field(row, "name", where)
    if not isinstance(name, str) or name not in KINDS:
        raise _bad(f"{where}name", name)
    joint = row.get("joint", 0)
    joints = JOINTS if KINDS[name].group in _OF_EACH_JOINT else (0,)
    if isinstance(joint, bool) or not isinstance(joint, int) or joint not in joints:
        raise _bad(f"{where}joint", joint)
    return Parameter(name, joint)


def _value(row: Mapping[str, Any], parameter: Parameter, where: str) -> float:
    unit = _field(row, "unit", where)
    if unit != parameter.kind.unit:
        raise _bad(f"{where}unit", unit)
    value = _field(row, "value", where)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise _bad(f"{where}value", value)
    try:
        figure = float(value)
    except OverflowError as error:
        raise _bad(f"{where}value", "10^308…") from error
    if not math.isfinite(figure):
        raise _bad(f"{where}value", value)
    return figure


def _time(text: object) -> datetime:
    try:
        time = datetime.fromisoformat(_text(text, "saved_at"))
    except ValueError as error:
        raise _bad("saved_at", text) from error
    if time.tzinfo is None:
        raise _bad("saved_at", text)
    return time


def _field(entries: Mapping[str, Any], name: str, where: str = "") -> Any:
    if name not in entries:
        raise _WrongError(RefusalCode.BACKUP_FIELD_MISSING, field=f"{where}{name}")
    return entries[name]


def _object(value: object, where: str) -> Mapping[str, Any]:
    if isinstance(value, dict):
        return value
    raise _WrongError(RefusalCode.BACKUP_FOREIGN) if not where else _bad(where, value)


def _text(value: object, where: str) -> str:
    if isinstance(value, str):
        return value
    raise _bad(where, value)


def _bad(where: str, value: object) -> _WrongError:
    return _WrongError(RefusalCode.BACKUP_FIELD_BAD, field=where, value=_shortened(str(value)))


def _shortened(text: str) -> str:
    return text if len(text) <= _LONGEST_QUOTE else f"{text[:_LONGEST_QUOTE]}…"


_LONGEST_QUOTE: Final = 40
