"""The parameters of one arm as a file that people can read: JSON, one parameter a line.

A file names its format and version, when and by which program it was saved, and from which arm. A
broken, truncated or foreign file is refused, and the place of the error is named.
"""

from __future__ import annotations

import enum
import json
import sys
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Final

from armui.arm.json_fields import FieldError, FieldProblem, Fields
from armui.arm.limits import JOINTS
from armui.arm.parameters import KINDS, Group, Parameter, check_value, reading_of
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.protocol.generation import PiperModel

BACKUP_NO_JSON = Reason(
    "backup_no_json",
    "The file is broken or cut short: line {line}, column {column} is not JSON. Nothing was "
    "changed; choose another file, or correct that line.",
)
BACKUP_FOREIGN = Reason(
    "backup_foreign",
    "This is not a parameter backup of this program. Nothing was changed; choose another file.",
)
BACKUP_VERSION = Reason(
    "backup_version",
    "The file has format version {version}; this program reads version {known}. Open it with "
    "the program that wrote it, or update this one.",
)
BACKUP_FIELD_MISSING = Reason(
    "backup_field_missing",
    "The file lacks the field “{field}”. Nothing was changed; choose another file, or add the "
    "field.",
)
BACKUP_FIELD_BAD = Reason(
    "backup_field_bad",
    "The file says “{value}” in the field “{field}”, which is not valid. Nothing was changed; "
    "choose another file, or correct the field.",
)
BACKUP_EMPTY = Reason(
    "backup_empty", "The file holds no parameter. Nothing was changed; choose another file."
)
BACKUP_TWICE = Reason(
    "backup_twice",
    "The file names {parameter} a second time, in “{field}”. Nothing was changed; remove one "
    "of the two.",
)


FORMAT: Final = "armui-parameters"
VERSION: Final = 1
"""The version of the file; others are refused."""
SUFFIX: Final = ".json"

_DECIMALS: Final = 6
"""The decimals of a value in the operator's unit: more than any frame can carry."""
_GENERATIONS: Final = (1, 2)
_OF_EACH_JOINT: Final = frozenset(
    {Group.JOINT_LIMITS, Group.JOINT_ACCELERATION, Group.COLLISION, Group.DRAG_ASSISTANCE}
)

_LONGEST_QUOTE: Final = 40
"""A foreign text is quoted up to this length."""
_LARGEST: Final = sys.float_info.max


@dataclass(frozen=True, slots=True)
class Backup:
    """The parameters of an arm at one time.

    Attributes:
        saved_at: The time of saving, with its time zone.
        program: The program that wrote it, with its version.
        generation: The protocol's generation, 1 or 2.
        firmware: The firmware's version text; ``None`` if the arm named none (generation 1).
        device: How the arm was connected, as the operator read it.
        values: The parameters' values in the operator's units.
        model: The model it was connected as; ``None`` in older files, which lack it.
    """

    saved_at: datetime
    program: str
    generation: int
    firmware: str | None
    device: str
    values: Mapping[Parameter, float]
    model: PiperModel | None = None


def to_text(backup: Backup) -> str:
    """Return the text of a backup's file."""
    head = {
        "format": FORMAT,
        "version": VERSION,
        "saved_at": backup.saved_at.isoformat(timespec="seconds"),
        "program": backup.program,
        "arm": {
            "generation": backup.generation,
            "firmware": backup.firmware,
            "device": backup.device,
            **({} if backup.model is None else {"model": backup.model.value}),
        },
    }
    rows = [
        "    " + json.dumps(parameter_row(parameter, value), ensure_ascii=False)
        for parameter, value in backup.values.items()
    ]
    opening = json.dumps(head, indent=2, ensure_ascii=False).removesuffix("\n}")
    return opening + ',\n  "parameters": [\n' + ",\n".join(rows) + "\n  ]\n}\n"


def parameter_row(parameter: Parameter, value: float) -> dict[str, float | int | str]:
    """Return a parameter as the JSON object in a backup and in a recording's sidecar."""
    joint: dict[str, float | int | str] = {"joint": parameter.joint} if parameter.joint else {}
    return {
        "name": parameter.name,
        **joint,
        "value": round(value, _DECIMALS),
        "unit": parameter.kind.unit,
    }


def from_text(text: str) -> Backup | Refusal:
    """Return the backup in the text of a file, or the reason why there is none, with the place."""
    try:
        entries = json.loads(text)
    except json.JSONDecodeError as error:
        return BACKUP_NO_JSON(line=error.lineno, column=error.colno)
    except (RecursionError, ValueError):  # thousands of brackets, or of digits
        return BACKUP_FOREIGN()
    if not isinstance(entries, dict) or entries.get("format") != FORMAT:
        return BACKUP_FOREIGN()
    version = entries.get("version")
    if version != VERSION or isinstance(version, bool):
        return BACKUP_VERSION(version=str(version), known=VERSION)
    try:
        return _backup(Fields(entries))
    except FieldError as error:
        if error.problem is FieldProblem.MISSING:
            return BACKUP_FIELD_MISSING(field=error.place)
        return error.refusal or BACKUP_FIELD_BAD(field=error.place, value=_shortened(error.value))


def _backup(entries: Fields) -> Backup:
    arm = entries.object("arm")
    rows = list(entries.objects("parameters"))
    return Backup(
        saved_at=_time(entries),
        program=entries.text("program"),
        generation=arm.whole("generation", allowed=_GENERATIONS),
        firmware=arm.maybe_text("firmware"),
        device=arm.text("device"),
        model=_model(arm),
        values=_values(entries, rows),
    )


def _model(arm: Fields) -> PiperModel | None:
    model = arm.maybe_text("model")
    if model is not None and model not in list(PiperModel):
        raise arm.bad("model", PiperModel.PIPER)
    return None if model is None else PiperModel(model)


def _values(entries: Fields, rows: Sequence[Fields]) -> Mapping[Parameter, float]:
    if not rows:
        raise entries.wrong("parameters", BACKUP_EMPTY())
    values: dict[Parameter, float] = {}
    for place, row in enumerate(rows, start=1):
        parameter = _parameter(row)
        if parameter in values:
            field = f"parameters[{place}]"
            raise row.wrong("name", BACKUP_TWICE(field=field, parameter=parameter.name))
        values[parameter] = _value(row, parameter)
    return values


def _parameter(row: Fields) -> Parameter:
    name = row.text("name")
    if name not in KINDS:
        raise row.bad("name", "max_angle_deg")
    joints = JOINTS if KINDS[name].group in _OF_EACH_JOINT else (0,)
    return Parameter(name, row.whole("joint", 0, joints))


def _value(row: Fields, parameter: Parameter) -> float:
    if row.text("unit") != parameter.kind.unit:
        raise row.bad("unit", parameter.kind.unit)
    return row.number("value")


def _time(entries: Fields) -> datetime:
    try:
        time = datetime.fromisoformat(entries.text("saved_at"))
    except ValueError as error:
        raise entries.bad("saved_at", "2026-01-02T03:04:05+00:00") from error
    if time.tzinfo is None:
        raise entries.bad("saved_at", "2026-01-02T03:04:05+00:00")
    return time


def _shortened(value: object) -> str:
    if isinstance(value, int) and abs(value) > _LARGEST:
        return "10^308…"
    text = str(value)
    return text if len(text) <= _LONGEST_QUOTE else f"{text[:_LONGEST_QUOTE]}…"


class ComparisonVerdict(enum.Enum):
    """The result of comparing a parameter in the file with the arm's."""

    SAME = "same"
    DIFFERS = "differs"
    ONLY_IN_FILE = "only_in_file"
    """This arm's protocol has no such parameter."""
    ONLY_IN_ARM = "only_in_arm"
    NOT_READ = "not_read"
    """The arm's value has not been read."""


@dataclass(frozen=True, slots=True)
class ComparisonRow:
    """One parameter compared between file and arm.

    Attributes:
        parameter: The parameter.
        verdict: The result of the comparison.
        filed: The value in the file.
        held: The value read from the arm.
        against: The reason why the file's value may not be restored, or ``None``.
    """

    parameter: Parameter
    verdict: ComparisonVerdict
    filed: float | None = None
    held: float | None = None
    against: Refusal | None = None

    @property
    def restorable(self) -> bool:
        """True if restoring it is allowed, and would or might change the arm's value."""
        return self.verdict in {ComparisonVerdict.DIFFERS, ComparisonVerdict.NOT_READ} and (
            self.filed is not None and self.against is None
        )


def compare(
    filed: Mapping[Parameter, float],
    state: ArmState,
    known: Collection[Parameter],
    same: Callable[[Parameter, float], bool],
) -> list[ComparisonRow]:
    """Return every parameter of the file and of the arm, in the order of the catalogue.

    Args:
        filed: The values in the file; if empty, only the arm's are listed.
        state: The arm as last heard.
        known: The parameters this arm has.
        same: Returns whether the arm holds this value, within the resolution of its frames.
    """
    names = list(KINDS)
    every = sorted({*filed, *known}, key=lambda each: (names.index(each.name), each.joint))
    return [_row(parameter, filed.get(parameter), state, known, same) for parameter in every]


def _row(
    parameter: Parameter,
    filed: float | None,
    state: ArmState,
    known: Collection[Parameter],
    same: Callable[[Parameter, float], bool],
) -> ComparisonRow:
    said = reading_of(state, parameter)
    held = None if said is None else said.value
    if parameter not in known:
        return ComparisonRow(parameter, ComparisonVerdict.ONLY_IN_FILE, filed)
    if held is None:
        against = None if filed is None else check_value(parameter, filed)
        return ComparisonRow(parameter, ComparisonVerdict.NOT_READ, filed, None, against)
    if filed is None:
        return ComparisonRow(parameter, ComparisonVerdict.ONLY_IN_ARM, None, held)
    if same(parameter, filed):
        return ComparisonRow(parameter, ComparisonVerdict.SAME, filed, held)
    return ComparisonRow(
        parameter, ComparisonVerdict.DIFFERS, filed, held, check_value(parameter, filed)
    )
