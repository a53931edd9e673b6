"""Storage for an arm's settings that outlives a power cut, like the controller's flash memory."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Final, Protocol

from armui.arm.json_fields import FieldError, Fields
from armui.arm.limits import JOINTS, JointLimits
from armui.arm.parameters import KINDS, Group, ParameterKind
from armui.protocol.addressing import OFFSETS
from armui.protocol.codes import EndLoad, LinkageRole
from armui.protocol.generation import PiperModel
from armui.protocol.message_fields import signal_names
from armui.sim.parameters.settings import (
    ArmSettingsRecord,
    HandleSettings,
    LinkageSettings,
    factory_settings,
)
from armui.system.atomic import write_whole
from armui.system.files import error_text, read_file

_FORMAT: Final = 1
_END_LIMITS: Final = 4
_HIGHEST_LEVEL: Final = 8
_MOST_ASSISTANCE: Final = 10
_LOADS: Final = (EndLoad.EMPTY, EndLoad.HALF, EndLoad.FULL)

_MOST_BYTES: Final = 1 << 20
"""The settings have about a thousand bytes; a file this large is another one."""


class SettingsTextError(ValueError):
    """A text that does not hold settings; the message names the part and the reason."""


def to_text(settings: ArmSettingsRecord) -> str:
    """Return the settings that outlive a power cut, as JSON."""
    record = {
        "format": _FORMAT,
        "limits": [each._asdict() for each in settings.limits],
        "accelerations_deg_s2": settings.accelerations_deg_s2,
        "end_limits": settings.end_limits,
        "collision_levels": settings.collision_levels,
        "load": settings.load,
        "teaching": settings.teaching._asdict(),
        "drag_assistance": settings.drag_assistance,
        "linkage": settings.linkage._asdict(),
        "zeros_deg": settings.zeros_deg,
    }
    return json.dumps(record, indent=1) + "\n"


def from_text(text: str) -> ArmSettingsRecord:
    """Return the settings in a text of `to_text`.

    Values a real flash can hold but no motor can follow (0xFFFF read back) are accepted.

    Raises:
        SettingsTextError: The text is no JSON, or a part is missing, of a wrong type, or not
            finite.
    """
    try:
        record = json.loads(text)
    except (json.JSONDecodeError, RecursionError) as error:
        raise SettingsTextError(f"not JSON: {error}") from error
    if not isinstance(record, dict) or record.get("format") != _FORMAT:
        raise SettingsTextError(f"not a settings file of format {_FORMAT}")
    try:
        return _settings(Fields(record))
    except FieldError as error:
        raise SettingsTextError(str(error)) from error


def _settings(record: Fields) -> ArmSettingsRecord:
    joints = (len(JOINTS),)
    teaching = _teaching(record.object("teaching"))
    linkage = record.object("linkage")
    return ArmSettingsRecord(
        limits=[
            JointLimits(*(each.number(name) for name in ("min_deg", "max_deg", "max_speed_deg_s")))
            for each in record.objects("limits", len(JOINTS))
        ],
        accelerations_deg_s2=list(record.numbers("accelerations_deg_s2", joints)),
        end_limits=record.numbers("end_limits", (_END_LIMITS,)),
        collision_levels=record.wholes("collision_levels", len(JOINTS), range(_HIGHEST_LEVEL + 1)),
        load=EndLoad(record.whole("load", allowed=_LOADS)),
        teaching=teaching,
        drag_assistance=_drag_assistance(record),
        linkage=LinkageSettings(
            LinkageRole(linkage.whole("role", allowed=list(LinkageRole))),
            *(
                linkage.whole(name, allowed=OFFSETS)
                for name in ("feedback_offset", "control_offset", "target_offset")
            ),
        ),
        zeros_deg=list(record.numbers("zeros_deg", joints)),
    )


def _drag_assistance(record: Fields) -> tuple[int, ...]:
    """Return the drag assistance in a text; an older text has none: then the factory's."""
    if "drag_assistance" not in record:
        return ArmSettingsRecord().drag_assistance
    return record.wholes("drag_assistance", len(JOINTS), range(_MOST_ASSISTANCE + 1))


def _teaching(fields: Fields) -> HandleSettings:
    """Return the teaching settings in a text; a missing field, newer than it, is the factory's."""
    signals, factory = signal_names(HandleSettings), HandleSettings()._asdict()
    kinds = {kind.signal: kind for kind in KINDS.values() if kind.group is Group.TEACHING}
    return HandleSettings(
        **{
            name: fields.whole(name, first, _allowed(kinds[signals[name]]))
            for name, first in factory.items()
        }
    )


def _allowed(kind: ParameterKind) -> Sequence[int]:
    choices = [int(choice) for choice in kind.choices]
    return choices or range(int(kind.minimum), int(kind.maximum) + 1)


class Flash(Protocol):
    """Stores the settings of one arm.

    Attributes:
        problem: The last error as text; empty if there was none.
    """

    problem: str

    def load(self, model: PiperModel = PiperModel.PIPER) -> ArmSettingsRecord:
        """Return the settings saved last, or the model's factory values if none can be read."""
        ...

    def save(self, settings: ArmSettingsRecord) -> None:
        """Saves the settings; a failure is reported in `problem`, never raised."""
        ...


class MemoryFlash:
    """Storage in memory: it outlives the arm's power cycles, but not the program.

    Attributes:
        text: The stored text; empty at first.
        writes: The number of writes.
    """

    def __init__(self) -> None:
        self.problem = ""
        self.text = ""
        self.writes = 0

    def load(self, model: PiperModel = PiperModel.PIPER) -> ArmSettingsRecord:
        """Return the settings saved last, or factory values."""
        if not self.text:
            return factory_settings(model)
        try:
            return from_text(self.text)
        except SettingsTextError as error:
            self.problem = f"flash unreadable, factory values in use: {error}"
            return factory_settings(model)

    def save(self, settings: ArmSettingsRecord) -> None:
        """Saves the settings; unchanged ones are not written again."""
        text = to_text(settings)
        if text != self.text:
            self.text = text
            self.writes += 1


class FileFlash:
    """Storage in a file that is written completely or not at all.

    An unreadable file is renamed so that it ends in `.broken`, and the arm starts with factory
    values.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.problem = ""
        self._kept = ""

    def load(self, model: PiperModel = PiperModel.PIPER) -> ArmSettingsRecord:
        """Return the settings in the file, or factory values."""
        try:
            text = read_file(self.path, _MOST_BYTES).decode()
            settings = from_text(text)
        except FileNotFoundError:
            return factory_settings(model)
        except OSError as error:
            self.problem = f"cannot read {self.path}, factory values in use: {error_text(error)}"
            return factory_settings(model)
        except (UnicodeDecodeError, SettingsTextError) as error:
            self._put_aside(str(error))
            return factory_settings(model)
        self._kept = text
        return settings

    def save(self, settings: ArmSettingsRecord) -> None:
        """Replaces the file safely, even through a power cut of the computer."""
        text = to_text(settings)
        if text == self._kept:
            return
        try:
            write_whole(self.path, text.encode())
        except OSError as error:
            self.problem = f"cannot write {self.path}: {error_text(error)}"
            return
        self._kept = text
        self.problem = ""

    def _put_aside(self, reason: str) -> None:
        aside = self.path.with_name(f"{self.path.name}.broken")
        try:
            self.path.replace(aside)
        except OSError as error:
            reason = f"{reason}; it could not be kept as {aside.name}: {error_text(error)}"
        else:
            reason = f"{reason}; kept as {aside.name}"
        self.problem = f"{self.path} is broken, factory values in use: {reason}"
