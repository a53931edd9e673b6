"""What can be wrong with a file of 参数备份."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

BACKUP_REFUSALS: Final[Mapping[str, object]] = {
    "backup_no_json": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file is broken or cut short: line {line}, column {column} is no JSON. Nothing was "
        "changed; choose another file, or mend that line.",
    ),
    "backup_foreign": QT_TRANSLATE_NOOP(
        "Refusal",
        "This is not a parameter backup of this program. Nothing was changed; choose another file.",
    ),
    "backup_version": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file has format version {version}; this program reads version {known}. Open it with "
        "the program that wrote it, or update this one.",
    ),
    "backup_field_missing": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file lacks the field “{field}”. Nothing was changed; choose another file, or add the "
        "field.",
    ),
    "backup_field_bad": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file says “{value}” in the field “{field}”, which is not possible. Nothing was "
        "changed; choose another file, or mend the field.",
    ),
    "backup_twice": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file names {parameter} a second time, in “{field}”. Nothing was changed; take one of "
        "the two away.",
    ),
    "backup_empty": QT_TRANSLATE_NOOP(
        "Refusal", "The file holds no parameter. Nothing was changed; choose another file."
    ),
    "backup_unreadable": QT_TRANSLATE_NOOP(
        "Refusal", "The file {path} cannot be read: {text}. Choose another one."
    ),
    "backup_not_written": QT_TRANSLATE_NOOP(
        "Refusal",
        "The backup could not be written to {path}: {text}. Choose another folder.",
    ),
    "backup_nothing_read": QT_TRANSLATE_NOOP(
        "Refusal", "Nothing has been read from the arm. Press Read first."
    ),
}
