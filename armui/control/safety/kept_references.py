"""Keeps what is known of each arm's reference in the settings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from armui.arm.reference_record import ReferenceRecord, merged_entry, record_in

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.settings import SettingsStore


class KeptReferences:
    """The records in the settings, by the key of each arm.

    Args:
        store: The operator's settings.
    """

    def __init__(self, store: SettingsStore) -> None:
        self._store = store
        self._given: dict[str, ReferenceRecord] = {}

    def get(self, arm: str) -> ReferenceRecord | None:
        """Return the record of an arm, by its key, or ``None``.

        Of an arm whose entry cannot be read every joint is in doubt.
        """
        entry = self._store.settings.references.get(arm) or self._store.strange("references", arm)
        record = record_in(entry)
        self._given[arm] = record or ReferenceRecord()
        return record

    def keep(self, arm: str, record: ReferenceRecord) -> Refusal | None:
        """Keep the record of an arm; return why it could not be saved, or ``None``.

        What differs from the record that was given, or kept, last is changed; the rest is left to
        other programs.
        """
        before, self._given[arm] = self._given.get(arm, ReferenceRecord()), record

        def put(entries: dict[str, Any]) -> None:
            entries[arm] = merged_entry(before, record, entries.pop(arm, None))

        return self._store.revise("references", put)
