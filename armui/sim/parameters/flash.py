"""Storage for an arm's settings that outlives a power cut, like the controller's flash memory."""

from __future__ import annotations

from pathlib import Path
from typing import Final, Protocol

from armui.protocol.generation import PiperModel
from armui.sim.parameters.settings import ArmSettingsRecord, factory_settings
from armui.sim.parameters.settings_text import SettingsTextError, from_text, to_text
from armui.system.atomic import write_whole
from armui.system.files import error_text, read_file

_MOST_BYTES: Final = 1 << 20
"""The settings have some thousand; a file this large is another."""


class Flash(Protocol):
    """Keeps the settings of one arm.

    Attributes:
        problem: What went wrong last, in words; empty when all is well.
    """

    problem: str

    def load(self, model: PiperModel = PiperModel.PIPER) -> ArmSettingsRecord:
        """What was saved last; a model's factory values when nothing was, or none can be read."""
        ...

    def save(self, settings: ArmSettingsRecord) -> None:
        """Keeps the settings; what cannot be kept is told in `problem`, never raised."""
        ...


class MemoryFlash:
    """Kept in memory: outlives the arm's power cycles, but not the program.

    Attributes:
        text: What is kept; empty in a new one.
        writes: How often the settings were written.
    """

    def __init__(self) -> None:
        self.problem = ""
        self.text = ""
        self.writes = 0

    def load(self, model: PiperModel = PiperModel.PIPER) -> ArmSettingsRecord:
        """What was saved last, or factory values."""
        if not self.text:
            return factory_settings(model)
        try:
            return from_text(self.text)
        except SettingsTextError as error:
            self.problem = f"flash unreadable, factory values in use: {error}"
            return factory_settings(model)

    def save(self, settings: ArmSettingsRecord) -> None:
        """Keeps the settings; the same ones again cost no write."""
        text = to_text(settings)
        if text != self.text:
            self.text = text
            self.writes += 1


class FileFlash:
    """A file, written as a whole or not at all.

    A file that cannot be understood is kept beside, under a name that ends in `.broken`, and the
    arm starts with factory values.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.problem = ""
        self._kept = ""

    def load(self, model: PiperModel = PiperModel.PIPER) -> ArmSettingsRecord:
        """What the file says, or factory values."""
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
        """Replaces the file, also through a power cut of the computer."""
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
