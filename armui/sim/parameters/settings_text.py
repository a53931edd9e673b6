"""Settings as JSON text and back."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, Final

from armui.arm.limits import JOINTS, JointLimits
from armui.protocol.addressing import OFFSETS
from armui.protocol.codes import EndLoad, LinkageRole
from armui.sim.parameters.settings import ArmSettingsRecord, HandleSettings, LinkageSettings

_FORMAT: Final = 1
_END_LIMITS: Final = 4
_HIGHEST_LEVEL: Final = 8
_LOADS: Final = (EndLoad.EMPTY, EndLoad.HALF, EndLoad.FULL)


class SettingsTextError(ValueError):
    """Text that does not hold settings; says which part and why."""


def to_text(settings: ArmSettingsRecord) -> str:
    """The settings that outlive a power cut, as JSON."""
    record = {
        "format": _FORMAT,
        "limits": [asdict(each) for each in settings.limits],
        "accelerations_deg_s2": settings.accelerations_deg_s2,
        "end_limits": settings.end_limits,
        "collision_levels": settings.collision_levels,
        "load": settings.load,
        "teaching": settings.teaching._asdict(),
        "linkage": settings.linkage._asdict(),
        "zeros_deg": settings.zeros_deg,
    }
    return json.dumps(record, indent=1) + "\n"


def from_text(text: str) -> ArmSettingsRecord:
    """The inverse of `to_text`.

    Values a real flash can hold but no motor can follow (0xFFFF read back) are accepted.

    Raises:
        SettingsTextError: It is no JSON, or a part is missing, of another kind, or not finite.
    """
    try:
        record = json.loads(text)
    except (json.JSONDecodeError, RecursionError) as error:
        raise SettingsTextError(f"not JSON: {error}") from error
    if not isinstance(record, dict) or record.get("format") != _FORMAT:
        raise SettingsTextError(f"not a settings file of format {_FORMAT}")
    return ArmSettingsRecord(
        limits=[_limits(each) for each in _items(record, "limits", len(JOINTS))],
        accelerations_deg_s2=_numbers(record, "accelerations_deg_s2", len(JOINTS)),
        end_limits=tuple(_numbers(record, "end_limits", _END_LIMITS)),
        collision_levels=tuple(
            _whole("collision_levels", level, range(_HIGHEST_LEVEL + 1))
            for level in _items(record, "collision_levels", len(JOINTS))
        ),
        load=EndLoad(_whole("load", record.get("load"), _LOADS)),
        teaching=_teaching(record.get("teaching")),
        linkage=_linkage(record.get("linkage")),
        zeros_deg=_numbers(record, "zeros_deg", len(JOINTS)),
    )


def _items(record: dict[str, Any], name: str, count: int) -> list[Any]:
    items = record.get(name)
    if not isinstance(items, list) or len(items) != count:
        raise SettingsTextError(f"{name} is not a list of {count}")
    return items


def _numbers(record: dict[str, Any], name: str, count: int) -> list[float]:
    return [_number(name, item) for item in _items(record, name, count)]


def _number(name: str, item: object) -> float:
    if isinstance(item, bool) or not isinstance(item, int | float) or not math.isfinite(item):
        raise SettingsTextError(f"{name} holds {item!r}, which is no number")
    return float(item)


def _whole(name: str, item: object, allowed: Sequence[int]) -> int:
    if isinstance(item, bool) or not isinstance(item, int) or item not in allowed:
        raise SettingsTextError(f"{name} holds {item!r}, which is none of its values")
    return item


def _fields(name: str, item: object) -> dict[str, object]:
    if not isinstance(item, dict):
        raise SettingsTextError(f"{name} is missing or no object")
    return item


def _limits(item: object) -> JointLimits:
    fields = _fields("limits", item)
    return JointLimits(
        *(_number(name, fields.get(name)) for name in ("min_deg", "max_deg", "max_speed_deg_s"))
    )


def _teaching(item: object) -> HandleSettings:
    fields = _fields("teaching", item)
    return HandleSettings(
        _whole("range_percent", fields.get("range_percent"), range(100, 201)),
        _whole("stroke_limit_mm", fields.get("stroke_limit_mm"), (0, 70, 100)),
        _whole("friction", fields.get("friction"), range(1, 11)),
    )


def _linkage(item: object) -> LinkageSettings:
    fields = _fields("linkage", item)
    role = LinkageRole(_whole("role", fields.get("role"), list(LinkageRole)))
    return LinkageSettings(
        role,
        *(
            _whole(name, fields.get(name), OFFSETS)
            for name in ("feedback_offset", "control_offset", "target_offset")
        ),
    )
