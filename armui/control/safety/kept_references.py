"""Keeps what is known of each arm's reference in the settings."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.reference_record import ReferenceRecord, read_record

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

    def get(self, arm: str) -> ReferenceRecord | None:
        """Return the record of an arm, by its key, or ``None``."""
        return read_record(self._store.settings.references.get(arm))

    def keep(self, arm: str, record: ReferenceRecord) -> Refusal | None:
        """Keep the record of an arm; return why it could not be saved, or ``None``."""
        kept = dict(self._store.settings.references)
        kept[arm] = record.as_entry()
        return self._store.change(references=kept)
