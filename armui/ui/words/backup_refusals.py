"""What can be wrong with a file of 参数备份."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

BACKUP_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.BACKUP_NO_JSON: (
        "The file is broken or cut short: line {line}, column {column} is no JSON. Nothing was "
        "changed; choose another file, or mend that line."
    ),
    RefusalCode.BACKUP_FOREIGN: (
        "This is not a parameter backup of this program. Nothing was changed; choose another file."
    ),
    RefusalCode.BACKUP_VERSION: (
        "The file has format version {version}; this program reads version {known}. Open it with "
        "the program that wrote it, or update this one."
    ),
    RefusalCode.BACKUP_FIELD_MISSING: (
        "The file lacks the field “{field}”. Nothing was changed; choose another file, or add the "
        "field."
    ),
    RefusalCode.BACKUP_FIELD_BAD: (
        "The file says “{value}” in the field “{field}”, which is not possible. Nothing was "
        "changed; choose another file, or mend the field."
    ),
    RefusalCode.BACKUP_TWICE: (
        "The file names {parameter} a second time, in “{field}”. Nothing was changed; take one of "
        "the two away."
    ),
    RefusalCode.BACKUP_EMPTY: (
        "The file holds no parameter. Nothing was changed; choose another file."
    ),
    RefusalCode.BACKUP_UNREADABLE: "The file {path} cannot be read: {text}. Choose another one.",
    RefusalCode.BACKUP_NOT_WRITTEN: (
        "The backup could not be written to {path}: {text}. Choose another folder."
    ),
    RefusalCode.BACKUP_NOTHING_READ: "Nothing has been read from the arm. Press Read first.",
}
