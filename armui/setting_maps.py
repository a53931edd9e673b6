"""The settings with an entry for each arm or device: each is read, checked and changed alone.

Two programs keep entries in one file, of different arms and of the same: neither writes what it
merely remembers (safety S21), and an entry that cannot be understood costs no other one (S22).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from armui.arm.refusal import Reason, Refusal
from armui.setting_checks import SETTING_BAD, shown
from armui.setting_fields import OF_EACH, check

SETTING_ENTRIES_BAD = Reason(
    "setting_entries_bad",
    "Setting “{field}”: {count} of its entries cannot be read, the first is “{key}”: “{value}”. "
    "The others hold; these stay in the file until you choose anew.",
)

Entries = dict[str, Any]
Revision = Callable[[Entries], object]
"""Changes entries in place: those in memory, and later those that are in the file by then."""


@dataclass(frozen=True, slots=True)
class KeptMap:
    """A map as it stands in the file.

    Attributes:
        entries: The entries that are understood.
        strange: The others.
        instead: What stands there if it is no map at all, else ``None``.
    """

    entries: Mapping[str, Any]
    strange: Mapping[str, object]
    instead: object = None

    @property
    def whole(self) -> object:
        """The map as the file has it."""
        return {**self.strange, **self.entries} if self.instead is None else self.instead

    def strange_at(self, key: str) -> str | None:
        """Return what stands for an arm that is not understood, as a text; ``None`` if nothing."""
        if self.instead is not None:
            return shown(self.instead)
        return shown(self.strange[key]) if key in self.strange else None


def read_map(name: str, value: object) -> KeptMap:
    """Return a map with its entries told apart.

    Args:
        name: The setting.
        value: Its value in the file; ``None`` if there is none.
    """
    if value is None:
        return KeptMap({}, {})
    if not isinstance(value, Mapping):
        return KeptMap({}, {}, value)
    entries: Entries = {}
    strange: dict[str, object] = {}
    for key, entry in value.items():
        (entries if check(name, {key: entry}) is None else strange)[key] = entry
    return KeptMap(entries, strange)


def problem_of(name: str, kept: KeptMap) -> Refusal | None:
    """Return what is to be told of a map that is not understood as a whole, or ``None``."""
    if kept.instead is not None:
        return SETTING_BAD(field=name, value=shown(kept.instead))
    if not kept.strange:
        return None
    key, entry = next(iter(kept.strange.items()))
    figures = {"key": shown(key), "value": shown(entry)}
    return SETTING_ENTRIES_BAD(field=name, count=len(kept.strange), **figures)


def revise(name: str, revision: Revision, settings: Entries) -> None:
    """Change the entries of one map among all settings, in place.

    The entries of the arms used longest ago are dropped where there are too many; none that is not
    understood: a newer program may know it.
    """
    before = settings.get(name)
    entries = dict(before) if isinstance(before, Mapping) else {}
    revision(entries)
    most = OF_EACH[name].kept
    if len(entries) > most:
        understood = list(read_map(name, entries).entries)
        for key in understood[: max(0, len(understood) - most)]:
            del entries[key]
    settings[name] = entries


def loses_map(before: Mapping[str, Any], after: Mapping[str, Any]) -> bool:
    """Return whether settings have a map where something else stood, whatever that was."""
    names = [each for each in OF_EACH if before.get(each) is not None]
    return any(
        isinstance(after[each], Mapping) and not isinstance(before[each], Mapping) for each in names
    )


def put(name: str, new: Mapping[str, Any], entries: Entries) -> None:
    """Put entries in the place of those there were; ``None`` drops one.

    The fields of an entry that only a newer program knows stay.
    """
    for key, value in new.items():
        before = entries.pop(key, None)
        if value is None:
            continue
        entries[key] = value
        if isinstance(value, Mapping) and isinstance(before, Mapping):
            merged = {**before, **value}
            entries[key] = merged if check(name, {key: merged}) is None else value


def changes(before: Mapping[str, Any], after: Mapping[str, Any]) -> dict[str, Any]:
    """Return the entries to :func:`put` so that one map becomes another one."""
    gone = dict.fromkeys(key for key in before if key not in after)
    return gone | {key: each for key, each in after.items() if before.get(key) != each}
